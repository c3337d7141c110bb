// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep test would be like, before anything moves: a range and a delay that fit the servo,
// and whether the time given is enough. Reads settings, writes nothing; the job's thread.
// Errors: those of jobs/sweep/sweep_axis.h.
#pragma once

#include "jobs/sweep/sweep_axis.h"

namespace jobs {
struct SweepEstimate {
    results::SweepAxis axis;
    /// Of the longest leg of a cycle; nullopt: its speed is not known.
    std::optional<base::Duration> travel{};
    /// The servo would be turned round before it arrives, or cannot follow the sine.
    bool tooShort = false;
    /// Most moves prove nothing (results/sweep_verdict.h): so long, in steps, each must be; 0: they
    /// are long enough.
    double minMove = 0;
    /// Delay, or period of a sine, with room for arriving and settling; 0: not known.
    base::Duration proposedDelay{};
};
base::Result<SweepEstimate> estimateSweep(const device::Context& context, device::Servo& servo,
                                          const results::SweepSpec& spec,
                                          const results::SweepLimits& limits);

/// Inside the servo's own limits, a little away from them; of a servo that turns on and on, half a
/// turn about where it is. Raw values. From what has been read of it: nullopt where its mode or its
/// limits are not known, or it has no positions in this mode.
std::optional<results::SweepRange> proposedRange(const device::Servo& servo);
} // namespace jobs
