// SPDX-License-Identifier: GPL-3.0-or-later
// Runs sweep tests for the window, one at a time, and checks beforehand whether one can be run.
// Beside Workbench, which must outlive it; main thread, never waits. Legs, curves and figures are
// available while the test runs; the readings go to a file in the data folder at the same time.
// Positions in steps; times are the workbench's clock.
#pragma once

#include "jobs/sweep/sweep.h"
#include "jobs/sweep/sweep_proposal.h"
#include "jobs/sweep/sweep_recording.h"
#include "session/writes/test_leftovers.h"

#include <QThread>

namespace session {
struct SweepTestRequest {
    results::SweepSpec spec;
    std::vector<ServoRef> servos;
    std::vector<results::SweepLimits> limits; ///< one a servo
    bool switchMode = false;                  ///< as jobs::SweepRequest
};

/// What preview() has found out about one servo.
struct SweepPreview {
    ServoRef servo = 0;
    std::optional<jobs::SweepEstimate> estimate{};
    std::optional<base::Error> error{};            ///< why it cannot be run
    std::optional<results::SweepRange> proposed{}; ///< a range that fits it
};

class SweepTest final : public QObject {
    Q_OBJECT

public:
    explicit SweepTest(Workbench& workbench, QObject* parent = nullptr);
    ~SweepTest() override;

    /// Reads settings, moves nothing; previewReady() follows, for the latest request only. Does
    /// nothing while a test runs.
    void preview(const SweepTestRequest& request);

    /// False: a test runs already, or a servo is gone. Otherwise started() or failed() follows,
    /// after started() then finished().
    bool start(const SweepTestRequest& request);
    void stop();
    bool isRunning() const { return m_running; }

    /// The running test or the latest one, with the legs there are; null: none yet.
    const results::SweepRun* run() const { return m_run ? &*m_run : nullptr; }
    const std::vector<ServoRef>& servos() const { return m_servos; } ///< of run(), in its order
    const jobs::SweepProgress& progress() const { return m_progress; }
    /// Of the test that has ended: servos whose torque could not be left as requested.
    const std::vector<jobs::UnreleasedTorque>& unreleasedTorque() const
    {
        return m_leftovers.torque();
    }
    /// Of that test: settings that it changed and could not restore
    /// (NoticeCode::SettingNotRestored).
    const device::Notices& unrevertedSettings() const { return m_leftovers.settings(); }
    /// Computed from the legs so far while it runs; the final ones afterwards.
    std::vector<results::SweepMetric> metrics(std::size_t servo) const;

    const recording::SampleStore& store() const { return m_store; }
    jobs::SweepCurves curves(std::size_t servo) const { return m_curves.at(servo); }
    base::Duration startedAt() const { return m_startedAt; } ///< of its first reading
    QString readingsPath() const { return m_readingsPath; }  ///< empty: could not be written

    /// Of a test that has ended; the ending of the name sets the format, and the readings go beside
    /// it. saved() or saveFailed() follows.
    void save(const QString& path, bool chinese);

Q_SIGNALS:
    void previewReady(
        const std::vector<session::SweepPreview>& previews); ///< in the order of the servos
    void started();
    void progressChanged();
    void samplesAdded(); ///< new readings, about 30 times a second
    void legsAdded();    ///< new legs; at most as often
    void finished();
    /// Something in unreleasedTorque() or unrevertedSettings() is proved to be resolved.
    void leftoversChanged();
    void failed(const base::Error& error); ///< nothing has moved, or it could not come to the start
    void saved(const QString& path);
    void saveFailed(const base::Error& error);

private:
    struct Live;
    struct Ending;
    static jobs::SweepCallbacks callbacksFor(const std::shared_ptr<Live>& live,
                                             const std::shared_ptr<Ending>& ending,
                                             const jobs::ProgressFn& progress);
    static std::optional<base::Error> beginRecording(Live& live, Ending& ending,
                                                     const results::SweepRun& run);
    static base::Result<void> runJob(TaskContext& context, const jobs::SweepRequest& request,
                                     const std::shared_ptr<Live>& live,
                                     const std::shared_ptr<Ending>& ending);
    void drain();
    void finish(Ending& ending, const TaskCompletion& end);
    void openCurves();

    Workbench& m_workbench;
    bool m_running = false;
    std::shared_ptr<Live> m_live; ///< shared with the job
    std::optional<results::SweepRun> m_run;
    std::vector<ServoRef> m_servos;
    jobs::SweepProgress m_progress;
    TestLeftovers m_leftovers;
    recording::SampleStore m_store;
    std::vector<jobs::SweepCurves> m_curves;
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
