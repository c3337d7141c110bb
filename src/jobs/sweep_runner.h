// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep test while it runs: sends goals, reads until the next one is due, measures, looks for
// reasons to end. Internal to the sweep job; its thread.
#pragma once

#include "jobs/sweep_drive.h"
#include "jobs/sweep_reader.h"

#include <functional>

namespace jobs {
class SweepRunner {
public:
    /// A line that says nothing for so long is a gap: nobody saw the servo, and it may have
    /// restarted. For longer, it is the end.
    static constexpr base::Duration gapFrom = std::chrono::milliseconds(300);
    static constexpr base::Duration mostSilence = std::chrono::seconds(5);

    /// `run`: what was asked for, with an axis and limits for each servo.
    SweepRunner(const device::Context& context, std::vector<device::Servo>& servos,
                record::SweepRun run, const SweepWatch& watch);

    /// Once.
    base::Result<record::SweepRun> run();

private:
    /// What is known of a servo beside its legs.
    struct Track {
        SweepPath path;
        std::optional<LegMeter> meter{};
        double goal = 0;
        std::optional<double> position{};
        std::optional<double> startCelsius{};
        base::Duration heardAt{};
        bool gapInLeg = false;
        int lostInARow = 0;
        bool lostTorque = false;
        bool exchanged = false; ///< another servo answers in its place
        bool held() const { return !lostTorque && !exchanged; }
        std::uint64_t answered = 0;
    };

    base::Result<void> goThrough();
    base::Result<void> approach();
    base::Result<void> notAtStart(std::size_t i);
    void warmUp();
    void measure();
    void confirmEnd();
    void forgetLegsInDoubt();
    void step(int number);
    void wave(int number);
    void begin(int number, base::Duration at);
    void close();
    base::Result<void> send(std::vector<double> targets);
    base::Result<bool> stillHeld();
    base::Result<void> findExchanged();
    bool confirmHeld();
    bool canRetry(const base::Error& error);
    bool silent() const; ///< somebody is
    bool sendOrEnd(const std::vector<double>& targets);

    /// Reads until `until`, or `done`, or the end.
    void read(base::Duration until, const std::function<bool()>& done);
    void drain();
    void take(std::size_t i, const SweepSample& sample);
    void noteGap(base::Duration from, base::Duration span);
    void watchLine();
    void blameAlarm(std::size_t i);
    void blameStall(std::size_t i);

    void endRun(record::SweepEnd end, int servo = -1);
    void endExchanged(int servo);
    std::vector<Leaving> leaving() const;
    bool ended() const { return m_ended; }
    bool over(int number) const;
    bool arrived(base::Duration rest) const;
    base::Duration patience() const;
    int legCount() const; ///< 0: not known beforehand
    int placeOf(int id) const;

    void tellProgress();
    void judgeCycle(int number);
    void work(std::size_t i, const bus::Statistics& statistics);
    void finish();

    base::Duration now() const { return m_context.bus.clock().now(); }

    const device::Context& m_context;
    std::vector<device::Servo>& m_servos;
    record::SweepRun m_run;
    const SweepWatch& m_watch;
    SweepReader m_reader;
    std::vector<Track> m_tracks;
    bus::PollId m_poll = 0;
    const std::uint64_t m_emergencies; ///< when it began
    bus::Statistics m_before;          ///< the measured part
    base::Duration m_start{};          ///< of the measured part
    base::Duration m_nextAt{};         ///< Delay: the next goal is due; 0: at once
    base::Duration m_waveStart{};
    base::Duration m_toldAt{}; ///< progress; 0: at once
    bool m_drives = false;     ///< a goal of this run has been sent
    bool m_measuring = false;
    int m_leg = 0;
    base::Duration m_legAt{};  ///< its goal had been sent
    bool m_legInDoubt = false; ///< in the latest leg a servo may have ceased to be held
    bool m_askHeld = false;    ///< that may have happened since it was asked last
    int m_fault = -1;          ///< place of the servo that ended it
    bool m_ended = false;
};
} // namespace jobs
