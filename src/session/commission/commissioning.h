// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning line for the window: starts and stops it, carries the click to it, and has the
// batch and what the line is doing. When it ends the list of servos is searched for anew, since
// others stand under those IDs now. Beside Desk, which must outlive it; main thread, never waits.
#pragma once

#include "jobs/commission/commission.h"
#include "session/desk.h"
#include "session/detachable_worker.h"

#include <QDate>

namespace session {
/// A file for a new batch, where documents are kept (in the data folder where that has been
/// chosen): named by the date; one that is another list already is passed over.
QString defaultBatchPath(const QDate& today);

/// Registers of a template that are written only with the user's consent.
QStringList dangerousKeys(const catalog::Catalog& catalog, const record::Snapshot& settings);

/// What is in the files of a line, before it is started.
struct CommissionFileCheck {
    std::optional<base::Error> batchError{};
    std::optional<base::Error> templateError{};
    QStringList dangerous{}; ///< keys of the template that need consent
};

class Commissioning final : public QObject {
    Q_OBJECT

public:
    explicit Commissioning(Desk& desk, QObject* parent = nullptr);
    ~Commissioning() override;

    /// False: it runs already, or no port is open. A template file is loaded by the job: what is
    /// wrong with it arrives as ended(). `templateFile` empty: as in the spec.
    bool start(const jobs::CommissionSpec& spec, const QString& csvPath,
               const QString& templateFile = {});
    /// Reads both files; no port is needed. looked() follows, of the latest call only: batch() and
    /// files(). Not while the line runs.
    void checkFiles(const QString& csvPath, const QString& templateFile);
    const CommissionFileCheck& files() const { return m_files; }
    void stop();
    bool isRunning() const { return m_running; }
    void submitAnswer(jobs::CommissionAnswer answer);

    const jobs::CommissionView& view() const { return m_view; } ///< while it runs
    const record::CommissionBatch& batch() const { return m_batch; }
    const QString& csvPath() const { return m_csvPath; } ///< of that batch; empty: none yet

    // --- a simulated bag of servos ---
    bool hasHotplugQueue() const;
    std::size_t pendingServoCount() const;
    void connectNext();
    void unplug();

Q_SIGNALS:
    void filesChecked();
    void started();
    void changed();      ///< view()
    void batchChanged(); ///< batch()
    /// `error`: why it could not begin or go on.
    void finished(const std::optional<base::Error>& error);

private:
    struct Live;
    void drain();
    void finish(const TaskCompletion& end);
    void restartSearch();

    Desk& m_desk;
    bool m_running = false;
    std::shared_ptr<Live> m_live; ///< shared with the job
    jobs::CommissionView m_view;
    record::CommissionBatch m_batch;
    QString m_csvPath;
    bool m_filesAccepted = false; ///< its files were good: the wire is the line's
    int m_baud = 0;               ///< that servos get; 0: their own
    CommissionFileCheck m_files;
    int m_checkNumber = 0;
    QTimer m_drainTimer;
    MainThreadQueue m_mainQueue;
    std::shared_ptr<GuardedPoster> m_post;
    DetachableWorker m_fileThread; ///< a file may lie where nobody answers
};
} // namespace session
