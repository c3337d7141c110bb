// SPDX-License-Identifier: GPL-3.0-or-later
// Runs sweep tests for the window, one at a time, and looks beforehand whether one can be run.
// Beside Desk, which must outlive it; main thread, never waits. What has been measured is here
// while it is being measured: legs, curves, figures; the readings go to a file in the data folder
// at the same time. Positions in steps; times are the desk's clock.
#pragma once

#include "jobs/sweep/sweep.h"
#include "jobs/sweep/sweep_proposal.h"
#include "jobs/sweep/sweep_recording.h"
#include "session/test_leftovers.h"

#include <QThread>

namespace session {
struct SweepTestRequest {
    record::SweepSpec spec;
    std::vector<ServoRef> servos;
    std::vector<record::SweepLimits> limits; ///< one a servo
    bool switchMode = false;                 ///< as jobs::SweepRequest
};

/// What look() has found out of one servo.
struct SweepPreview {
    ServoRef servo = 0;
    std::optional<jobs::SweepEstimate> estimate{};
    std::optional<base::Error> error{};           ///< why it cannot be run
    std::optional<record::SweepRange> proposed{}; ///< a range that fits it
};

class SweepTest final : public QObject {
    Q_OBJECT

public:
    explicit SweepTest(Desk& desk, QObject* parent = nullptr);
    ~SweepTest() override;

    /// Reads settings, moves nothing; looked() follows, of the latest order only. Nothing while a
    /// test runs.
    void preview(const SweepTestRequest& request);

    /// False: one runs already, or a servo is gone. Else began() or failed() follow, then ended().
    bool start(const SweepTestRequest& request);
    void stop();
    bool isRunning() const { return m_running; }

    /// The running test or the latest one, with the legs there are; null: none yet.
    const record::SweepRun* run() const { return m_run ? &*m_run : nullptr; }
    const std::vector<ServoRef>& servos() const { return m_servos; } ///< of run(), in its order
    const jobs::SweepProgress& progress() const { return m_progress; }
    /// Of the test that has ended: servos that could not be left as they were to be.
    const std::vector<jobs::UnreleasedTorque>& unreleasedTorque() const
    {
        return m_leftovers.torque();
    }
    /// Of that test: what it has set and could not put back (NoticeCode::SettingNotRestored).
    const device::Notices& unrevertedSettings() const { return m_leftovers.settings(); }
    /// Worked out anew from the legs while it runs; the final ones afterwards.
    std::vector<record::SweepMetric> metrics(std::size_t servo) const;

    struct Curves {
        record::ChannelId position = -1;
        record::ChannelId goal = -1;
    };
    const record::SampleStore& store() const { return m_store; }
    Curves curves(std::size_t servo) const { return m_curves.at(servo); }
    base::Duration startedAt() const { return m_startedAt; } ///< of its first reading
    QString readingsPath() const { return m_readingsPath; }  ///< empty: could not be written

    /// Of a test that has ended, as its name says, with the readings beside it; saved() or
    /// saveFailed() follow.
    void save(const QString& path, bool chinese);

Q_SIGNALS:
    void previewReady(
        const std::vector<session::SweepPreview>& previews); ///< in the order of the servos
    void started();
    void progressChanged();
    void samplesAdded(); ///< new readings, about 30 times a second
    void legsAdded();    ///< new legs; at most as often
    void finished();
    void
    leftoversChanged(); ///< of unreleasedTorque() and unrevertedSettings() something is proved over
    void failed(const base::Error& error); ///< nothing has moved, or it could not come to the start
    void saved(const QString& path);
    void saveFailed(const base::Error& error);

private:
    struct Live;
    struct Ending;
    void drain();
    void finish(Ending& ending, const TaskCompletion& end);
    void openCurves();

    Desk& m_desk;
    bool m_running = false;
    std::shared_ptr<Live> m_live; ///< shared with the job
    std::optional<record::SweepRun> m_run;
    std::vector<ServoRef> m_servos;
    jobs::SweepProgress m_progress;
    TestLeftovers m_leftovers;
    record::SampleStore m_store;
    std::vector<Curves> m_curves;
    base::Duration m_startedAt{};
    QString m_readingsPath;
    std::shared_ptr<const jobs::SweepRecording> m_recording; ///< of the latest test, ended
    int m_previewNumber = 0;
    QTimer m_drainTimer;
    MainThreadQueue m_mainQueue;
    QObject m_writer; ///< lives on m_files
    QThread m_files;  ///< a PDF needs a thread of Qt's; its work uses the others
};
} // namespace session
