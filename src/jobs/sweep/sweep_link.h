// SPDX-License-Identifier: GPL-3.0-or-later
// The servos of a running sweep test: sends their goals, reads them, and ends the run when the
// link, a servo or its torque is lost, on an alarm or a stall. Which goals are sent and what is
// measured is up to SweepRunner. Internal to the sweep job; its thread.
#pragma once

#include "jobs/sweep/sweep_motion.h"
#include "jobs/sweep/sweep_reader.h"

#include <functional>
#include <limits>

namespace jobs {
class SweepLink {
public:
    /// A silence of this length is a gap: the servo may have restarted in it. After maxSilence the
    /// run ends.
    static constexpr base::Duration minGap = std::chrono::milliseconds(300);
    static constexpr base::Duration maxSilence = std::chrono::seconds(5);

    /// What is known of a servo beside its legs.
    struct ServoTrack {
        SweepPath path;
        std::optional<LegMeter> meter{};                        ///< of the present leg
        double goal = std::numeric_limits<double>::quiet_NaN(); ///< before the first one
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

    /// Writes gaps and the end into `run`; `onRead` is called several times a second.
    SweepLink(const device::Context& context, std::vector<device::Servo>& servos,
              results::SweepRun& run, const SweepCallbacks& callbacks,
              std::function<void()> onRead);

    std::vector<ServoTrack>& tracks() { return m_tracks; } ///< in the order of the servos
    void startReading();
    void stopReading();
    /// Positions from now on are counted from this one, without jumps of a turn.
    void anchor(std::size_t i, double position) { m_reader.anchor(i, position); }

    void beginMeasuring(base::Duration start);
    bool isMeasuring() const { return m_measuring; }
    void beginLeg(int leg, base::Duration at); ///< 0: a leg that is not measured
    void endLeg();
    /// A servo may have lost its torque in the latest leg.
    bool isLegUncertain() const { return m_isLegUncertain; }
    void markLegUncertain() { m_isLegUncertain = true; }

    /// Reads until `until`, or `done`, or the end.
    void readUntil(base::Duration until, const std::function<bool()>& done);
    void drain(); ///< the readings that are there

    base::Result<void> send(std::vector<double> targets);
    bool sendOrEnd(const std::vector<double>& targets); ///< false: the run has ended

    void requestHoldingCheck() { m_checkHolding = true; }
    base::Result<bool> areStillHolding();
    bool confirmHolding();
    bool canRetry(const base::Error& error);
    bool isAnySilent() const;

    void endRun(results::SweepEnd end, int servo = -1);
    bool hasEnded() const { return m_ended; }
    std::vector<ServoEndState> endStates() const;
    base::Duration now() const { return m_context.bus.clock().now(); }

private:
    base::Result<void> findReplacedServos();
    void handleSample(std::size_t i, const SweepSample& sample);
    void noteGap(base::Duration from, base::Duration span);
    void checkLink();
    void endStopped();
    void endOnAlarm(std::size_t i);
    void endOnStall(std::size_t i);
    void endReplaced(int servo);
    int indexOfServo(int id) const; ///< -1: none

    const device::Context& m_context;
    std::vector<device::Servo>& m_servos;
    results::SweepRun& m_run;
    const SweepCallbacks& m_callbacks;
    const std::function<void()> m_onRead;
    SweepReader m_reader;
    std::vector<ServoTrack> m_tracks;
    bus::PollId m_poll = 0;
    const std::uint64_t m_emergencyCount; ///< at the start
    bool m_hasSentGoal = false;           ///< in this run
    bool m_measuring = false;
    base::Duration m_start{}; ///< of the measured part
    int m_leg = 0;
    base::Duration m_legStart{};   ///< when its goals had been sent
    bool m_isLegUncertain = false; ///< in the latest leg a servo may have lost its torque
    bool m_checkHolding = false;   ///< that may have happened since the latest check
    int m_faultIndex = -1;         ///< the servo that ended the run
    bool m_ended = false;
};
} // namespace jobs
