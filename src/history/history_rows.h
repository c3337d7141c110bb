// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the history except the test runs, and their filter. Plain values; any thread. Times
// are UTC. `number` counts within one file and is never reused; `uuid` is the same in every copy.
// Servos have no serial number: a servo is identified by protocol, model, firmware, map, ID and the
// user's label. Two servos that are equal in all of these are one servo to the history.
#pragma once

#include "base/clock.h"
#include "base/journal.h"
#include "snapshot/snapshot.h"

#include <QStringList>

namespace history {
struct HistoryServo {
    std::int64_t number = 0;
    QString uuid{};
    base::ServoIdentity
        identity{};  ///< port and baud as when it was last written to; model for people
    QString label{}; ///< the user's; empty: none yet
    /// Among servos that differ only by label: the one that is assumed when such a servo replies.
    bool current = true;
    QDateTime lastWrite{}; ///< invalid: never written to
};

/// An outcome of a write or of one register: kept, temporary, done or undone.
bool isSuccess(const QString& outcome);

/// One register of one write. Writes that belong together carry the same intent.
struct HistoryWrite {
    std::int64_t number = 0;
    std::int64_t intent = 0;
    QString intentUuid{};
    int place = 0; ///< within the intent
    std::int64_t servo = 0;
    int servoId = -1; ///< ID, model and label of the servo, for lists
    QString model{};
    QString label{};
    QDateTime at{}; ///< of the intent: before the first byte
    base::IntentKind kind = base::IntentKind::Write;
    bool temporary = false;
    QString key{};
    int address = 0;
    std::int64_t oldRaw = 0;
    /// None: the servo itself chose it (centering, factory defaults), and it was not read.
    std::optional<std::int64_t> newRaw{};
    bool ownDefaults = false; ///< the whole intent: the servo took what it had stored itself
    std::optional<std::int64_t> readBack{};
    /// The words of device::outcomeName(); where only the outcome of the whole is known (old
    /// journals, manoeuvres): "done", "undone", "failed", "abandoned"; empty: interrupted, open.
    QString outcome{};
    QString detail{};
    QString port{};
    int baud = 0;
    QString program{};
    bool isGood() const { return isSuccess(outcome); }
};

enum class SnapshotReason : std::uint8_t { Automatic, Manual, Bundle, Commission };
QString snapshotReasonName(SnapshotReason reason); ///< "automatic", "asked" …
std::optional<SnapshotReason> snapshotReasonFromName(const QString& name);

struct HistorySnapshot {
    std::int64_t number = 0;
    QString uuid{};
    std::int64_t servo = 0;
    int servoId = -1;
    QString model{};
    QString firmware{};
    QString label{}; ///< of the snapshot; setSnapshotNote() changes both
    QString note{};
    QDateTime at{};
    SnapshotReason reason = SnapshotReason::Manual;
    QString program{};
    QString port{};
    int baud = 0;
    QString file{};    ///< the file it was also saved to; empty: none
    int registers = 0; ///< with a value
    bool operator==(const HistorySnapshot&) const = default;
};

struct HistoryAlarm {
    std::int64_t number = 0;
    QString uuid{};
    std::int64_t servo = 0;
    int servoId = -1;
    QString model{};
    QString label{};
    QString key{};         ///< "overload", "voltage" …
    bool derived = false;  ///< derived from the limits, not reported by the servo
    QDateTime at{};        ///< when it began
    QDateTime clearedAt{}; ///< invalid: still active when last seen
    QString port{};
};

struct HistoryRecording {
    std::int64_t number = 0;
    QString uuid{};
    QDateTime at{};
    base::Duration length{};
    QString file{};
    qint64 rows = 0;
    QString port{};
    bool simulated = false;
    struct Servo {
        std::int64_t servo = 0;
        int id = -1;
        QString model{};
        QString label{};
    };
    std::vector<Servo> servos{};
};

/// Where the next page begins: after the last row of the previous page.
struct PageCursor {
    QDateTime at{};
    std::int64_t number = 0;
    bool operator==(const PageCursor&) const = default;
};

/// Empty members match all; from is inclusive, until exclusive. Always newest first.
struct HistoryFilter {
    std::optional<std::int64_t> servo{}; ///< number of a HistoryServo
    std::optional<int> id{};
    QString model{}; ///< by name, case-insensitive
    QString label{};
    QDateTime from{};
    QDateTime until{};
    QString key{};             ///< of the register (writes) or of the alarm
    bool onlyProblems = false; ///< failed or open writes, active alarms
    std::optional<SnapshotReason> reason{};
    std::optional<PageCursor> after{};
    int limit = 200;
    bool operator==(const HistoryFilter&) const = default;
};
} // namespace history
