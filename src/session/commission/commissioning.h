// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning line for the window: starts and stops it, passes on the answer of the user, and
// has the batch and the state of the line. When it ends, the bus is searched again, because other
// servos have those IDs now. The workbench must outlive it; main thread, never waits.
#pragma once

#include "jobs/commission/commission.h"
#include "session/detachable_worker.h"
#include "session/workbench.h"

#include <QDate>

namespace session {
/// A file for a new batch in the documents folder (in the data folder if one was chosen), named by
/// the date; the name of an existing list is not used.
QString defaultBatchPath(const QDate& today);

/// Registers of a template that are written only with the user's consent.
QStringList dangerousKeys(const catalog::Catalog& catalog, const snapshot::Snapshot& settings);

/// The content of the files, checked before the line is started.
struct CommissionFileCheck {
    std::optional<base::Error> batchError{};
    std::optional<base::Error> templateError{};
    QStringList dangerous{}; ///< keys of the template that need consent
};

class Commissioning final : public QObject {
    Q_OBJECT

public:
    explicit Commissioning(Workbench& workbench, QObject* parent = nullptr);
    ~Commissioning() override;

    /// False: it is running, or no port is open. A template file is loaded by the job: its errors
    /// arrive with finished(). `templateFile` empty: as in the spec.
    bool start(const jobs::CommissionSpec& spec, const QString& csvPath,
               const QString& templateFile = {});
    /// Reads both files; no port is needed. filesChecked() follows for the latest call only, with
    /// batch() and files(). Not while the line runs.
    void checkFiles(const QString& csvPath, const QString& templateFile);
    const CommissionFileCheck& files() const { return m_files; }
    void stop();
    bool isRunning() const { return m_running; }
    void submitAnswer(jobs::CommissionAnswer answer);

    const jobs::CommissionView& view() const { return m_view; } ///< while it runs
    const results::CommissionBatch& batch() const { return m_batch; }
    const QString& csvPath() const { return m_csvPath; } ///< of that batch; empty: none yet
    /// Html or Pdf by the end of the name; `chinese`: the language it opens in. reportSaved() or
    /// saveFailed().
    void saveReport(const QString& path, bool chinese);

    // --- simulated servos that are connected one after the other ---
    bool hasHotplugQueue() const;
    std::size_t pendingServoCount() const;
    void connectNext();
    void unplug();

Q_SIGNALS:
    void filesChecked();
    void started();
    void changed();      ///< view()
    void batchChanged(); ///< batch()
    /// `error`: why it could not start or continue.
    void finished(const std::optional<base::Error>& error);
    void reportSaved(const QString& path);
    void saveFailed(const base::Error& error);

private:
    struct Live;
    void drain();
    void finish(const TaskCompletion& end);
    void restartSearch();

    Workbench& m_workbench;
    bool m_running = false;
    std::shared_ptr<Live> m_live; ///< shared with the job
    jobs::CommissionView m_view;
    results::CommissionBatch m_batch;
    QString m_csvPath;
    bool m_filesAccepted = false; ///< its files were good: it has used the bus
    int m_baud = 0;               ///< that servos get; 0: their own
    CommissionFileCheck m_files;
    int m_checkNumber = 0;
    QTimer m_drainTimer;
    MainThreadQueue m_mainQueue;
    std::shared_ptr<GuardedPoster> m_post;
    DetachableWorker m_fileThread; ///< a file may be on a drive that hangs
};
} // namespace session
