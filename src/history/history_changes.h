// SPDX-License-Identifier: GPL-3.0-or-later
// What a copy of the history elsewhere (PostgreSQL) needs: every change since the one it has last
// been given. Borrows the connection of a history::History (its thread). Fails as
// history/history_file.h.
//
// Each row of servos, intents (their writes with them), snapshots, alarms, recordings, facts and
// runs (with run_servos, run_texts, run_files) has a uuid and a revision. Triggers give it the next
// revision of the whole file at every change, its children's included; what is deleted leaves its
// uuid and a revision in `removed`. SQLite lets one write at a time, so revisions become visible in
// order: a copy that has all changes up to N misses none below N. A copy is therefore restartable:
// read changes after the revision the copy has, replace each row by its uuid with its children, and
// write bench() and the new revision down in the same transaction of the *server*. Sending again
// is harmless. bench() names this file; two files never share it, unless one was copied by hand.
// Rows refer to others by number, which is only this file's: a copy refers by uuid (see the
// *_uuid values in ChangedRow).
#pragma once

#include "base/error.h"

#include <QVariantMap>

#include <vector>

namespace history {
class HistoryFile;

struct ChangedRow {
    std::int64_t revision = 0;
    QString table{}; ///< "servos", "intents", "snapshots", "alarms", "recordings", "facts", "runs"
    QString uuid{};
    bool removed = false;
    /// Column name → value as in SQLite, without number and revision; the servo it is about as
    /// servo_uuid. Times in ms since 1970 UTC, lengths in µs, blobs as QByteArray (qCompress).
    QVariantMap values{};
    /// table of the children → their rows, in order; servos as servo_uuid.
    QMap<QString, QVector<QVariantMap>> children{};
};

class HistoryChanges {
public:
    explicit HistoryChanges(const HistoryFile& file)
        : m_file(file)
    {}

    base::Result<QString> bench() const;
    /// The latest; 0: nothing was ever kept.
    base::Result<std::int64_t> revision() const;
    /// In order of revision, a row that changed several times once, with its present values. At
    /// most `limit` rows, and no more than about `bytes` of blobs unless a single row has more.
    base::Result<std::vector<ChangedRow>> after(std::int64_t revision, int limit = 500,
                                                qint64 bytes = qint64(8) << 20) const;
    /// How many rows wait.
    base::Result<std::int64_t> pendingCount(std::int64_t revision) const;

private:
    const HistoryFile& m_file;
};
} // namespace history
