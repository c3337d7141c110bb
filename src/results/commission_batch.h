// SPDX-License-Identifier: GPL-3.0-or-later
// A batch of servos that are set up one after the other: the CSV file of the user with a line per
// servo, and a JSON file with the same rows and the unfinished servos, so that a batch can be
// resumed after any interruption. The state of FILE.csv is in FILE.commission.json; the CSV is
// rewritten from it. A plain value; any thread. Fails as text files do; BadArgument ("…") where a
// CSV without a state would be overwritten.
#pragma once

#include "base/error.h"
#include "snapshot/snapshot.h"

namespace results {
enum class CommissionVerdict : std::uint8_t {
    Good,
    Remark,  ///< set up; see the issues
    Failed,  ///< something was written, but not everything succeeded
    Skipped, ///< nothing was written: not one for this batch
};
QString verdictName(CommissionVerdict verdict); ///< "good", "remark", "failed", "set-aside"
std::optional<CommissionVerdict> commissionVerdictFromName(const QString& name);

/// Why: a stable word ("alarm-voltage", "other-model", an error's name) and what belongs to it.
struct CommissionIssue {
    QString word;
    QString detail{};
    bool operator==(const CommissionIssue&) const = default;
};

struct CommissionRow {
    QDateTime at;                  ///< UTC, to the second
    snapshot::SnapshotServo servo; ///< as it was found, with its old ID
    bool simulated = false;
    int oldBaud = 0;
    int newId = -1;         ///< −1: was not given one
    int newBaud = 0;        ///< 0: was not given one
    QString templateName{}; ///< empty: none
    int written = 0;        ///< registers the template has changed
    bool centered = false;
    std::optional<double> volts{};
    std::optional<double> celsius{};
    CommissionVerdict verdict = CommissionVerdict::Good;
    std::vector<CommissionIssue> issues{};
    QString label{};
    QString snapshot{}; ///< file with the table as it was; empty: none
    bool operator==(const CommissionRow&) const = default;
};

/// A servo that was begun and has not been finished: where it may be found.
struct PendingCommission {
    QDateTime at; ///< UTC, to the millisecond: its changes in the journal are later
    snapshot::SnapshotServo servo; ///< as it was found
    int oldBaud = 0;
    int newId = -1;
    int newBaud = 0;
    bool isIdSent = false; ///< it may have its new ID, which no other servo gets
    QString snapshot{};    ///< file with its table before the first write
    bool isIdConfirmed =
        false;             ///< its new ID was read back: under the old one another servo answers
    bool lockOpen = false; ///< its lock was opened and not proven closed
    bool simulated = false;
    bool operator==(const PendingCommission&) const = default;
};

/// Address of the last finished servo, until it is unplugged.
struct ServoLocation {
    QString protocol;
    int id = -1;
    int baud = 0;
    bool operator==(const ServoLocation&) const = default;
};

struct CommissionBatch {
    QString program{};
    std::vector<CommissionRow> rows{}; ///< in the order of work
    std::vector<PendingCommission> pending{};
    std::optional<ServoLocation> attachedServo{};
    bool operator==(const CommissionBatch&) const = default;

    /// Given to a servo, or perhaps given.
    bool isIdTaken(int id) const;
    int count(CommissionVerdict verdict) const;
    int done() const; ///< good or with a remark
};

/// The known state of an unfinished servo: the IDs it may have, and its lock.
std::vector<CommissionIssue> unfinishedIssues(const PendingCommission& pending);

QByteArray encodeCommissionBatch(const CommissionBatch& batch);
base::Result<CommissionBatch> decodeCommissionBatch(const QByteArray& text);
/// For spreadsheets, with a byte order mark. Columns: time, verdict, troubles, model, firmware,
/// was_id, was_baud, id, baud, template, written, centered, volts, celsius, label, snapshot,
/// simulated.
QByteArray encodeCommissionCsv(const CommissionBatch& batch);

/// "batch.csv" → "batch.commission.json"
QString commissionStatePath(const QString& csvPath);
/// A new batch where neither file exists.
base::Result<CommissionBatch> openCommissionBatch(const QString& csvPath);
/// Both files; when it returns they are on the disk. The state goes first.
base::Result<void> saveCommissionBatch(const CommissionBatch& batch, const QString& csvPath);

/// "1 M", "500 k", "115.2 k"
QString rateLabel(int baud);
/// {model} {id} {rate} {baud} {firmware} {date} {was_id}; unknown names stay as they are.
QString commissionLabel(const QString& format, const CommissionRow& row);
QString defaultLabelFormat(); ///< "{model} · ID {id} · {rate}"
} // namespace results
