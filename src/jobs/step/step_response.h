// SPDX-License-Identifier: GPL-3.0-or-later
// The step-response lab: the same step there and back, every reading kept, each response measured
// (jobs/step/step_meter.h). Gains that are tried out, and the mode where the servo's own has no
// positions, are set for the length of the run (jobs/temporary_settings.h); speed and acceleration,
// which the run may raise, get their values back. Drives, ends and leaves the servo as a sweep test
// does (jobs/sweep/sweep.h): it holds, unless it is at fault. A plug that is pulled is awaited for
// 5 s, as there, from the first setting to the last one put back. Writes no EPROM. The job's
// thread. Errors, all before anything has moved, operation "step": BadArgument no-size, no-hold,
// no-gain, no-repeats; OutOfRange (no room for the step between the limits); TurnsUnknown
// (multi-turn without a start); those of the sweep test and of temporary settings. Afterwards:
// Refused trial-lost: the gains were not in force any more, it had restarted before it moved.
#pragma once

#include "jobs/sweep/sweep.h"
#include "results/step_run.h"

namespace jobs {
struct StepRequest {
    results::StepSpec spec{};
    QString program{}; ///< name and version, for the report
    bool simulated = false;
    bool switchMode = false; ///< as SweepRequest's
};

/// Called on the job's thread while it runs; each may be empty.
struct StepCallbacks {
    /// The registers that a trial has changed, now in effect.
    std::function<void(const std::vector<base::JournalItem>&)> onTrial{};
    std::function<void(const results::StepResponse&)> onResponse{}; ///< complete
    std::function<void(const SweepProgress&)> onProgress{};
    std::function<void(const UnreleasedTorque&)> onUnreleasedTorque{}; ///< as SweepCallbacks's
};

/// The step in the servo's terms, as it will be.
struct StepPlan {
    double from = 0; ///< steps of its feedback
    double to = 0;
    base::Duration hold{};
    std::optional<base::Duration> travel{}; ///< as planned; none: no speed is known
    bool isHoldTooShort = false;            ///< it will turn round before it has arrived
    results::SweepSpec sweep{};
    results::SweepLimits limits{};
};

/// Reads, writes nothing. The servo is in a mode with positions.
base::Result<StepPlan> planStep(const device::Context& context, device::Servo& servo,
                                const results::StepSpec& spec);

/// The registers of the control loop of this family, in the order of its table: gains first.
std::vector<const catalog::Register*> loopRegisters(const catalog::Profile& profile);

base::Result<results::StepRun> stepResponse(const device::Context& context, device::Servo& servo,
                                            const StepRequest& request,
                                            const StepCallbacks& callbacks);
} // namespace jobs
