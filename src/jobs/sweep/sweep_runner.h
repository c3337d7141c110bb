// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a sweep test: way to the start, warm-up, legs with their goals, figures and
// progress. Talks to the servos through SweepLink. Internal to the sweep job; its thread.
#pragma once

#include "jobs/sweep/sweep_link.h"

namespace jobs {
class SweepRunner {
public:
    /// `run`: the request, with an axis and limits for each servo.
    SweepRunner(const device::Context& context, std::vector<device::Servo>& servos,
                results::SweepRun run, const SweepCallbacks& callbacks);

    /// Once.
    base::Result<results::SweepRun> run();

private:
    base::Result<void> runPhases();
    base::Result<void> moveToStart();
    base::Result<void> failAtStart(std::size_t i);
    void warmUp();
    void measure();
    void confirmFinalState();
    void dropUncertainLegs();
    void step(int number);
    void runSineLeg(int number);
    void beginLeg(int number, base::Duration at);
    void endLeg();

    bool hasEnded() const { return m_link.hasEnded(); }
    bool isOver(int number) const;
    bool arrived(base::Duration rest) const;
    base::Duration timeout() const;
    int legCount() const; ///< 0: not known beforehand

    void reportProgress();
    void evaluateCycle(int number);
    void updateMetrics(std::size_t i, const bus::Statistics& statistics);
    void finish();

    base::Duration now() const { return m_link.now(); }

    const device::Context& m_context;
    std::vector<device::Servo>& m_servos;
    results::SweepRun m_run;
    const SweepCallbacks& m_callbacks;
    SweepLink m_link;
    std::vector<SweepLink::ServoTrack>& m_tracks; ///< of the link
    bus::Statistics m_statisticsBefore;           ///< the measured part
    base::Duration m_start{};                     ///< of the measured part
    base::Duration m_nextGoalAt{};                ///< Delay: when the next goal is due; 0: now
    base::Duration m_sineStart{};
    base::Duration m_progressAt{}; ///< when the next progress is due; 0: now
    int m_leg = 0;
};
} // namespace jobs
