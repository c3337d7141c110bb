// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots for the window: taken from a servo or a whole bus, opened and saved as files, kept in
// the history. Beside Workbench and HistoryService, which must outlive it; main thread, never
// waits. Restoring is RestoreService's.
#pragma once

#include "session/history/history_service.h"
#include "session/workbench.h"
#include "snapshot/bundle.h"
#include "snapshot/restore_result.h"

namespace session {
using SharedBundle = std::shared_ptr<const snapshot::Bundle>;

struct SnapshotRequest {
    QString label{};
    QString note{};
    QString path{}; ///< empty: it is kept in the history only
};

/// What a file turned out to be: one of them is set.
struct OpenedFile {
    QString path{};
    SharedSnapshot snapshot{};
    SharedBundle bundle{};
};

class Snapshots final : public QObject {
    Q_OBJECT

public:
    Snapshots(Workbench& workbench, HistoryService& historyService, QObject* parent = nullptr);

    /// Reads the table anew, keeps it in the history and in the file. taken() or failed().
    void take(ServoRef servo, const SnapshotRequest& request);
    /// All servos of the list that are known and answer at the port's rate. bundled() or failed();
    /// one that cannot be read fails the whole.
    void takeAll(const SnapshotRequest& request);
    bool isTaking() const { return m_taking; }

    /// What has been read of a servo so far; null: gone, or not known what it is.
    SharedSnapshot currentSnapshot(ServoRef servo) const;
    /// What such a servo leaves the factory with.
    SharedSnapshot factorySnapshot(const snapshot::Snapshot& like) const;
    /// Chosen rows only; errors as snapshot::makeTemplate.
    base::Result<SharedSnapshot> toTemplate(const snapshot::Snapshot& from, const QStringList& keys,
                                            const SnapshotRequest& request) const;

    /// A snapshot, a template or a bundle. opened() or failed().
    void open(const QString& path);
    /// By the end of the name CSV, a report (HTML, PDF) that opens in Chinese or not, or else the
    /// snapshot itself. saved() or failed().
    void save(SharedSnapshot snapshot, const QString& path, bool chinese);
    void save(std::vector<snapshot::RestoreResult> results, const QString& path);

Q_SIGNALS:
    void snapshotTaken(const session::SharedSnapshot& snapshot, const QString& path);
    void bundleTaken(const session::SharedBundle& bundle, const QString& path);
    void fileOpened(const session::OpenedFile& file);
    void saved(const QString& path);
    void failed(const base::Error& error);
    void takingChanged();

private:
    void setTaking(bool taking);
    /// `keep`: what goes into the history whether or not the file could be written, so that it
    /// names none that is not there.
    void saveInBackground(std::function<base::Result<void>()> write, std::function<void()> then,
                          std::function<void(bool written)> keep = {});

    Workbench& m_workbench;
    HistoryService& m_historyService;
    bool m_taking = false;
};
} // namespace session
