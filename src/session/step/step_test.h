// SPDX-License-Identifier: GPL-3.0-or-later
// The step-response lab for the window: runs one after the other on one servo, keeps the last few
// to be laid over each other, keeps accepted gains for good and takes them back. Beside Desk, which
// must outlive it; main thread, never waits. Trials last as long as their run; only accept() and
// back() write for good, by the desk's safe write.
#pragma once

#include "jobs/step/step_response.h"
#include "session/desk.h"

namespace session {
struct StepTestRequest {
    record::StepSpec spec{};
    ServoRef servo = 0;
    bool switchMode = false; ///< as jobs::StepRequest
};

class StepTest final : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t maxRuns = 6;

    explicit StepTest(Desk& desk, QObject* parent = nullptr);

    /// False: one runs already, or the servo is gone. Else ended() or failed() follow. Runs of
    /// another servo are forgotten.
    bool start(const StepTestRequest& request);
    void stop();
    bool isRunning() const { return m_running; }
    const jobs::SweepProgress& progress() const { return m_progress; }
    const std::vector<jobs::UnreleasedTorque>& unreleasedTorque() const
    {
        return m_unreleasedTorque;
    } ///< as SweepTest
    /// Of the run that has ended: what its trial has changed and could not put back.
    const std::vector<base::JournalItem>& unrevertedItems() const { return m_unrevertedItems; }

    ServoRef servo() const { return m_servo; } ///< that the runs are of; 0: none yet
    /// Complete ones, oldest first.
    const std::vector<record::StepRun>& runs() const { return m_runs; }
    /// Responses of the running one, as far as they are complete.
    const std::vector<record::StepResponse>& liveResponses() const { return m_live; }
    const record::StepSpec& liveSpec() const { return m_liveSpec; }
    /// What the latest run is to be held against: the latest one before it that went the same way
    /// with the servo's own values, else any that did; null: none.
    const record::StepRun* previousRun() const;
    const std::vector<record::StepAdvice>& advice() const { return m_advice; } ///< to the latest
    void clear(); ///< all runs; not what was accepted

    /// Writes them for good and remembers what they replace. Nothing without differences.
    void accept(ServoRef servo, const std::vector<record::StepGain>& gains);
    /// What back() would write to this servo; empty: nothing was accepted.
    std::vector<device::WriteItem> previousValues(ServoRef servo) const;
    void revert(ServoRef servo);

    /// As its name ends: .html, .json, .csv; saved() or saveFailed() follow.
    void save(const QString& path, bool chinese);

Q_SIGNALS:
    void progressChanged();
    void responsesAdded(); ///< live() has grown
    void finished();       ///< runs() has, or its oldest are gone
    void failed(const base::Error& error);
    void acceptedChanged(); ///< earlier() may be another
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

    Desk& m_desk;
    bool m_running = false;
    ServoRef m_servo = 0;
    std::shared_ptr<Live> m_job; ///< shared with it
    std::vector<record::StepRun> m_runs;
    std::vector<record::StepResponse> m_live;
    record::StepSpec m_liveSpec;
    std::vector<record::StepAdvice> m_advice;
    jobs::SweepProgress m_progress;
    std::vector<jobs::UnreleasedTorque> m_unreleasedTorque;
    std::vector<base::JournalItem> m_unrevertedItems;
    std::vector<AcceptedGains> m_accepted;    ///< accepted, oldest first
    std::optional<AcceptedGains> m_writing{}; ///< on its way to the servo
    bool m_reverting = false;                 ///< and it is back() that asked for it
    QTimer m_drainTimer;
    MainThreadQueue m_mainQueue;
    JobThread m_files; ///< writes reports; last: its work uses the others
};
} // namespace session
