// SPDX-License-Identifier: GPL-3.0-or-later
// The step-response test for the window: runs one after the other on one servo, keeps the last few
// for an overlay, writes accepted gains permanently and reverts them. Beside Workbench, which must
// outlive it; main thread, never waits. Trials last as long as their run; only accept() and
// revert() write permanently, with the workbench's safe write.
#pragma once

#include "jobs/step/step_response.h"
#include "session/workbench.h"

namespace session {
/// A run of the history and its number there.
struct StoredStep {
    std::int64_t number = 0;
    std::shared_ptr<const results::StepRun> run{};
};

struct StepTestRequest {
    results::StepSpec spec{};
    ServoRef servo = 0;
    bool switchMode = false; ///< as jobs::StepRequest
};

class StepTest final : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t maxRuns = 6;   ///< measured ones
    static constexpr std::size_t maxOpened = 2; ///< those of the history

    explicit StepTest(Workbench& workbench, QObject* parent = nullptr);

    /// False: a run is under way, or the servo is gone. Otherwise finished() or failed() follows.
    /// Measured runs of another servo are removed.
    bool start(const StepTestRequest& request);
    void stop();
    bool isRunning() const { return m_running; }
    const jobs::SweepProgress& progress() const { return m_progress; }
    const std::vector<jobs::UnreleasedTorque>& unreleasedTorque() const
    {
        return m_unreleasedTorque;
    } ///< as SweepTest
    /// Of the run that has ended: changes of its trial that could not be restored.
    const std::vector<base::JournalItem>& unrevertedItems() const { return m_unrevertedItems; }

    ServoRef servo() const { return m_servo; } ///< of the measured runs; 0: none yet
    /// Complete ones: first those of the history, then the measured ones, each oldest first.
    const std::vector<results::StepRun>& runs() const { return m_runs; }
    /// Shows at most maxOpened runs of the history instead of those that were opened before.
    void openStored(const std::vector<StoredStep>& stored);
    /// Numbers in the history of the first ones of runs().
    const std::vector<std::int64_t>& openedNumbers() const { return m_openedNumbers; }
    /// Complete responses of the present run.
    const std::vector<results::StepResponse>& liveResponses() const { return m_live; }
    const results::StepSpec& liveSpec() const { return m_liveSpec; }
    /// The run that the latest one is compared with. It made a step of the same size: the latest of
    /// those opened from the history, else the latest measured one with the servo's own values,
    /// else any measured one. Null: there is none.
    const results::StepRun* previousRun() const;
    const std::vector<results::StepAdvice>& advice() const { return m_advice; } ///< on the latest
    void clear();         ///< all runs, but not the accepted values
    void clearMeasured(); ///< keeps those of the history

    /// Writes them permanently and remembers the old values. Does nothing without differences.
    void accept(ServoRef servo, const std::vector<results::StepGain>& gains);
    /// The values that revert() would write to this servo; empty: nothing was accepted.
    std::vector<device::WriteItem> previousValues(ServoRef servo) const;
    void revert(ServoRef servo);

    /// The ending sets the format: .html, .json, .csv; saved() or saveFailed() follows.
    void save(const QString& path, bool chinese);

Q_SIGNALS:
    void progressChanged();
    void responsesAdded(); ///< liveResponses() has grown
    void finished();       ///< runs() has a new one
    void storedOpened();   ///< openStored() has changed runs()
    void failed(const base::Error& error);
    void acceptedChanged(); ///< previousValues() may have changed
    void saved(const QString& path);
    void saveFailed(const base::Error& error);

private:
    struct Live;
    struct AcceptedGains {
        ServoRef servo = 0;
        std::vector<device::WriteItem> before{};
        std::vector<device::WriteItem> after{};
    };
    void drain(Live& live);
    void finish(Live& live, const TaskCompletion& end);
    void happened(const Event& event);

    Workbench& m_workbench;
    bool m_running = false;
    ServoRef m_servo = 0;
    std::shared_ptr<Live> m_job; ///< shared with it
    std::vector<results::StepRun> m_runs;
    std::vector<std::int64_t> m_openedNumbers;
    std::vector<results::StepResponse> m_live;
    results::StepSpec m_liveSpec;
    std::vector<results::StepAdvice> m_advice;
    jobs::SweepProgress m_progress;
    std::vector<jobs::UnreleasedTorque> m_unreleasedTorque;
    std::vector<base::JournalItem> m_unrevertedItems;
    std::vector<AcceptedGains> m_accepted;    ///< accepted, oldest first
    std::optional<AcceptedGains> m_writing{}; ///< on its way to the servo
    bool m_reverting = false;                 ///< revert() has started it
    QTimer m_drainTimer;
    MainThreadQueue m_mainQueue;
    base::JobThread m_files; ///< writes reports; last: its work uses the others
};
} // namespace session
