// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of a sweep test: a poll plan of its servos, and the polled blocks as samples in the
// units of results/sweep_run.h. Owned by the job; its thread.
#pragma once

#include "device/servo.h"
#include "jobs/sweep/leg_meter.h"
#include "jobs/watch/poll_reader.h"

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
    /// The reading that is complete with this block. One that lacks a block is dropped.
    std::optional<Reading> add(const bus::Sample& sample);

    /// Where a servo turns without limits and its feedback shows one turn only, turns are counted
    /// from the first reading (inside its angle limits: as far as it swings over the seam). From
    /// now on they are counted in a way that this servo, which rests there, is at `position`.
    void anchor(std::size_t servo, double position);

private:
    struct Source {
        device::Servo servo;
        PollReader reader;
        int group = 0;
        double stepsPerTurn = 4096;
        bool wraps = false;   ///< the feedback shows one turn only
        bool limited = false; ///< it stays inside that turn, but for a swing over the seam
        base::Duration lastAt{};
        double turns = 0; ///< steps of the whole ones beside it
        std::optional<double> last{};
    };
    static SweepSample toSample(Source& source, const PollReading& reading);
    static double unwrap(Source& source, double position, base::Duration at);
    static double unwrapNearSeam(Source& source, double position, base::Duration at);

    std::vector<Source> m_sources;
};
} // namespace jobs
