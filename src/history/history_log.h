// SPDX-License-Identifier: GPL-3.0-or-later
// Servos, writes, snapshots, alarms and recordings of the history database: what is added, listed,
// labeled, taken out again. Borrows the connection of a history::History (its thread). Writes are
// added by history/history_journal.h only. Lists are pages of `limit` rows, and filter.after for
// the next. Fails as history/history_file.h; BadArgument for a number that is not there.
#pragma once

#include "history/history_rows.h"

namespace history {
class HistoryFile;

/// The servo of a snapshot, as the journal would name it.
base::ServoIdentity identityOf(const snapshot::Snapshot& snapshot);

class HistoryLog {
public:
    explicit HistoryLog(const HistoryFile& file)
        : m_file(file)
    {}

    // Servos, the latest written to first. of(): the one that is meant when this servo answers
    // now; nullopt: never met.
    base::Result<std::vector<HistoryServo>> servos(const HistoryFilter& filter = {}) const;
    base::Result<HistoryServo> servo(std::int64_t number) const;
    base::Result<std::optional<HistoryServo>> of(const base::ServoIdentity& identity) const;
    /// The same, made if it was never met.
    base::Result<HistoryServo> findOrAdd(const base::ServoIdentity& identity) const;
    /// A name for this servo, with all its past. BadArgument "label-in-use" where one alike has it.
    base::Result<void> setLabel(std::int64_t servo, const QString& label) const;
    /// From now on the one that answers like this is another: the one with this label, met before
    /// or not. What was kept for the way back from multi-turn stays with the former.
    base::Result<HistoryServo> assignToOther(std::int64_t servo, const QString& label) const;

    base::Result<std::vector<HistoryWrite>> writes(const HistoryFilter& filter = {}) const;
    base::Result<std::int64_t> countWrites(const HistoryFilter& filter = {}) const;
    base::Result<HistoryWrite> write(std::int64_t number) const;
    /// The register keys ever written to this servo (any, without), in order, for a filter.
    base::Result<QStringList> writtenKeys(std::optional<std::int64_t> servo = {}) const;

    /// Returns its number. The servo is found by the identity in the snapshot.
    base::Result<std::int64_t> addSnapshot(const snapshot::Snapshot& snapshot,
                                           SnapshotReason reason, const QString& file = {}) const;
    base::Result<std::vector<HistorySnapshot>> snapshots(const HistoryFilter& filter = {}) const;
    base::Result<HistorySnapshot> snapshotRow(std::int64_t number) const;
    /// With label and note as they are now.
    base::Result<snapshot::Snapshot> snapshot(std::int64_t number) const;
    base::Result<void> setSnapshotNote(std::int64_t number, const QString& label,
                                       const QString& note) const;
    base::Result<void> removeSnapshot(std::int64_t number) const;

    /// Of one that came and has not gone, only the first call counts.
    base::Result<void> recordAlarmStart(const base::ServoIdentity& identity, const QString& key,
                                        bool derived, const QDateTime& at) const;
    base::Result<void> recordAlarmEnd(const base::ServoIdentity& identity, const QString& key,
                                      const QDateTime& at) const;
    base::Result<std::vector<HistoryAlarm>> alarms(const HistoryFilter& filter = {}) const;

    /// number, uuid and the servos' own members are made here; the file itself stays where it is.
    base::Result<std::int64_t> addRecording(const HistoryRecording& recording,
                                            const std::vector<base::ServoIdentity>& servos) const;
    base::Result<std::vector<HistoryRecording>> recordings(const HistoryFilter& filter = {}) const;
    base::Result<void> removeRecording(std::int64_t number) const;

private:
    const HistoryFile& m_file;
};
} // namespace history
