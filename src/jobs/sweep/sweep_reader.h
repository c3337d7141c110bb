// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of a sweep test: a poll plan over its servos, and the polled blocks as samples in
// the units of record/sweep_run.h. Owned by the job; its thread.
#pragma once

#include "device/servo.h"
#include "jobs/sweep/leg_meter.h"
#include "jobs/watch/poll_spans.h"

namespace jobs {
class SweepReader {
public:
    /// Settings must have been read, so that units are right.
    explicit SweepReader(const std::vector<device::Servo>& servos);

    bus::PollPlan plan() const;

    struct Reading {
        std::size_t servo = 0; ///< place in the list
        SweepSample sample;
    };
    /// What is finished with this block: none or one.
    std::optional<Reading> add(const bus::Sample& sample);

    /// Where a servo turns on and on and its feedback shows one turn only, turns are counted from
    /// the first reading (inside its angle limits: as far as it swings over the seam); from now
    /// on so that this servo, which has come to rest there, is at `position`.
    void anchor(std::size_t servo, double position);

private:
    struct Source {
        device::Servo servo; ///< takes the status of servos whose replies carry none
        double stepsPerTurn = 4096;
        std::vector<const catalog::Register*> registers;
        std::vector<bus::PollSpan> spans;
        int group = 0;
        PollRoundTracker pollRound;
        bool wraps = false;   ///< the feedback shows one turn only
        bool limited = false; ///< and it stays inside it, but for a swing
        base::Duration lastAt{};
        double turns = 0; ///< steps of the whole ones beside it
        std::optional<double> last{};
        SweepSample pending;
    };
    static void take(Source& source, const bus::Sample& sample);
    static void storeValue(SweepSample& into, Source& source, const catalog::Register& reg,
                           std::int64_t raw);
    static double unwrap(Source& source, double position);
    static double unwrapNearSeam(Source& source, double position);

    std::vector<Source> m_sources;
};
} // namespace jobs
