// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep test: drives one servo or several together through a path again and again, measures
// every leg, judges the run. Writes goals, speed, acceleration and torque, never EPROM. However it
// ends, the servos are left safe: the one at fault without torque, the others as the order says,
// and after an emergency stop as that left them. A silence of up to 5 s is waited out and noted as
// a gap. The job's thread; times are the bus clock's.
// Errors, all before anything has moved: those of sweep_axis.h, of reading and of switching the
// mode; Refused no-start (the first place was not reached). Whatever happens later is
// SweepRun::end; a mode that could not be put back is a notice.
#pragma once

#include "device/servo.h"
#include "jobs/job.h"
#include "jobs/sweep/leg_meter.h"

namespace jobs {
struct SweepRequest {
    results::SweepSpec spec{};
    std::vector<results::SweepLimits> limits{}; ///< one a servo
    QString program{};                          ///< name and version, for the report
    bool simulated = false;
    /// A servo in a mode without positions is switched for the test, with its EPROM lock closed,
    /// and back at the end: then it stands without torque. See jobs/temporary_settings.h.
    bool switchMode = false;
};

struct SweepProgress {
    double fraction = 0; ///< 0…1
    base::Duration elapsed{};
    std::optional<base::Duration> remaining{}; ///< estimate; none before the first cycle
    int leg = 0;                               ///< 0: on the way to the start, or warming up
    int cycle = 0;
    bool warmingUp = false;
    bool ended = false;         ///< the servos are being left as they are to be
    std::vector<int> silent{};  ///< IDs that have not answered for a while
    base::Duration silentFor{}; ///< the longest of them
};

/// How a servo was to be left at the end of a test, which could not be proved.
struct UnreleasedTorque {
    int id = -1;
    bool holding = false; ///< stopped, holding where it is; else without torque
    base::Error error{};
};

/// Called on the job's thread while it runs; each may be empty.
struct SweepCallbacks {
    /// In time order for each servo; `goal` in steps, NaN before the first one; `leg` 0 outside of
    /// the measured part and while goals are being sent.
    std::function<void(std::size_t servo, const SweepSample&, double goal, int leg)> onSample{};
    std::function<void(std::size_t servo, const results::SweepLeg&)> onLeg{};
    /// The goal of a measured leg had been sent at this time of the bus clock.
    std::function<void(std::size_t servo, int leg, base::Duration at)> onGoal{};
    std::function<void(const SweepProgress&)> onProgress{};
    /// The run with all but its legs and figures, once everything has been found possible. An error
    /// keeps it from beginning and becomes the job's.
    std::function<std::optional<base::Error>(const results::SweepRun&)> onBegin{};
    /// At the end, for each servo that could not be left as it was to be.
    std::function<void(const UnreleasedTorque&)> onUnreleasedTorque{};
};

/// All servos on one bus; their settings are read. What is in `servos` afterwards is what the job
/// knows of them.
base::Result<results::SweepRun> sweep(const device::Context& outer,
                                      std::vector<device::Servo>& servos,
                                      const SweepRequest& request, const SweepCallbacks& callbacks);
} // namespace jobs
