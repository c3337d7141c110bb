// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep test while it runs: sends goals, reads until the next one is due, measures, looks for
// reasons to end. Internal to the sweep job; its thread.
#pragma once

#include "jobs/sweep/sweep_motion.h"
#include "jobs/sweep/sweep_reader.h"

#include <functional>

namespace jobs {
class SweepRunner {
public:
    /// A line that says nothing for so long is a gap: nobody saw the servo, and it may have
    /// restarted. For longer, it is the end.
    static constexpr base::Duration minGap = std::chrono::milliseconds(300);
    static constexpr base::Duration maxSilence = std::chrono::seconds(5);

    /// `run`: what was asked for, with an axis and limits for each servo.
    SweepRunner(const device::Context& context, std::vector<device::Servo>& servos,
                record::SweepRun run, const SweepCallbacks& callbacks);

    /// Once.
    base::Result<record::SweepRun> run();

private:
    /// What is known of a servo beside its legs.
    struct ServoTrack {
        SweepPath path;
        std::optional<LegMeter> meter{};
        double goal = 0;
        std::optional<double> position{};
        std::optional<double> startCelsius{};
        base::Duration lastReplyAt{};
        bool gapInLeg = false;
        int consecutiveLosses = 0;
        bool hasLostTorque = false;
        bool isReplaced = false; ///< another servo answers in its place
        bool isHolding() const { return !hasLostTorque && !isReplaced; }
        std::uint64_t answered = 0;
    };

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
    base::Result<void> send(std::vector<double> targets);
    base::Result<bool> areStillHolding();
    base::Result<void> findReplacedServos();
    bool confirmHolding();
    bool canRetry(const base::Error& error);
    bool isAnySilent() const; ///< somebody is
    bool sendOrEnd(const std::vector<double>& targets);

    /// Reads until `until`, or `done`, or the end.
    void readUntil(base::Duration until, const std::function<bool()>& done);
    void drain();
    void handleSample(std::size_t i, const SweepSample& sample);
    void noteGap(base::Duration from, base::Duration span);
    void checkLink();
    void endOnAlarm(std::size_t i);
    void endOnStall(std::size_t i);

    void endRun(record::SweepEnd end, int servo = -1);
    void endReplaced(int servo);
    std::vector<ServoEndState> endStates() const;
    bool hasEnded() const { return m_ended; }
    bool isOver(int number) const;
    bool arrived(base::Duration rest) const;
    base::Duration timeout() const;
    int legCount() const; ///< 0: not known beforehand
    int indexOfServo(int id) const;

    void reportProgress();
    void evaluateCycle(int number);
    void updateMetrics(std::size_t i, const bus::Statistics& statistics);
    void finish();

    base::Duration now() const { return m_context.bus.clock().now(); }

    const device::Context& m_context;
    std::vector<device::Servo>& m_servos;
    record::SweepRun m_run;
    const SweepCallbacks& m_callbacks;
    SweepReader m_reader;
    std::vector<ServoTrack> m_tracks;
    bus::PollId m_poll = 0;
    const std::uint64_t m_emergencyCount; ///< when it began
    bus::Statistics m_statisticsBefore;   ///< the measured part
    base::Duration m_start{};             ///< of the measured part
    base::Duration m_nextGoalAt{};        ///< Delay: the next goal is due; 0: at once
    base::Duration m_sineStart{};
    base::Duration m_progressAt{}; ///< progress; 0: at once
    bool m_hasSentGoal = false;    ///< a goal of this run has been sent
    bool m_measuring = false;
    int m_leg = 0;
    base::Duration m_legStart{};   ///< its goal had been sent
    bool m_isLegUncertain = false; ///< in the latest leg a servo may have ceased to be held
    bool m_checkHolding = false;   ///< that may have happened since it was asked last
    int m_faultIndex = -1;         ///< place of the servo that ended it
    bool m_ended = false;
};
} // namespace jobs
