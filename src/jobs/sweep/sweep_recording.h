// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the readings of a sweep test while it runs: for charts, in memory of bounded size, and in a
// recording (recording/recording.h) that is readable up to the last second whatever happens. In its
// channels the goal and the number of the leg stand beside what was measured; leg 0 is the way to
// the start. Of a run of more than ten minutes the file has 50 readings a second and servo, and
// every extreme of position between them. The job's thread.
// Errors: those of recording::Recorder::start. A disk that fills up later shows in failure().
#pragma once

#include "jobs/sweep/leg_meter.h"
#include "recording/recorder.h"

namespace jobs {
/// The curves of a servo in a store.
struct SweepCurves {
    recording::ChannelId position = -1;
    recording::ChannelId goal = -1;
};

/// Without a position, nothing is known there; `goal` as SweepCallbacks::onSample gives it.
void appendReading(recording::SampleStore& store, const SweepCurves& curves, base::Duration at,
                   std::optional<double> position, double goal);

class SweepRecording {
public:
    /// `path` empty: charts only. `run` as SweepCallbacks::onBegin gives it.
    static base::Result<std::unique_ptr<SweepRecording>> start(const results::SweepRun& run,
                                                               const QString& path);

    void add(std::size_t servo, const SweepSample& sample, double goal, int leg);
    /// As SweepCallbacks::onGoal: a mark "leg 3" of the servo, without which no time of a leg could
    /// be worked out again from the readings.
    void goal(std::size_t servo, int leg, base::Duration at);
    /// Everything is on the disk afterwards.
    void finish();

    std::optional<base::Error> failure() const;
    std::uint64_t lost() const; ///< readings that are not in the file

    const recording::SampleStore& store() const { return m_store; }
    recording::ChannelId positions(std::size_t servo) const { return m_curves.at(servo).position; }
    recording::ChannelId goals(std::size_t servo) const { return m_curves.at(servo).goal; }

private:
    /// Selects the readings that a thinned file keeps.
    struct Decimator {
        base::Duration until{};
        std::optional<recording::RecordingRow> low{};
        std::optional<recording::RecordingRow> high{};
    };
    SweepRecording();
    void write(std::size_t servo, recording::RecordingRow row);
    void flushDecimator(Decimator& decimator);
    void enqueue(recording::RecordingRow row);
    void enqueue(bool all);

    recording::SampleStore m_store;
    std::vector<SweepCurves> m_curves;
    std::vector<Decimator> m_decimators; ///< one per servo
    std::unique_ptr<recording::Recorder> m_recorder;
    std::vector<recording::RecordingRow> m_rows;
    std::vector<recording::Mark> m_marks;
    std::vector<int> m_ids; ///< of the servos
    std::optional<base::Duration> m_start{};
};
} // namespace jobs
