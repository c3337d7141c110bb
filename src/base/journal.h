// SPDX-License-Identifier: GPL-3.0-or-later
// The memory that makes "nothing is lost" true: before the first byte of an EPROM write the intent
// and the old values are recorded; when the write has ended, its outcome. An intent without an end
// is an interrupted write, which the next connection offers to finish or undo. Also keeps small
// facts about a servo that must survive a restart (the limits for the way back from multi-turn).
// Interface only; record owns the file. Any thread; every call returns after the data is on disk.
#pragma once

#include "base/error.h"
#include "base/protocol.h"

#include <QDateTime>
#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace base {
/// The identity of a servo when the intent was written. Servos have no serial number, so an ID
/// alone proves nothing: model, firmware and the old values must match too.
struct ServoIdentity {
    int id = -1;
    int modelMajor = -1;
    int modelMinor = -1;
    int firmwareMajor = -1;
    int firmwareMinor = -1;
    QString map;  ///< register map key, e.g. "sts"
    QString port; ///< canonical port name at that time
    int baud = 0;
    Protocol protocol = Protocol::Feetech;
    QString model{}; ///< its name for people, "STS3215"; may be unknown, proves nothing

    /// By its port: a change of a simulated servo must never count as one of a real servo.
    bool isSimulated() const { return port.startsWith(QLatin1String("sim:")); }

    bool isSameKind(const ServoIdentity& other) const
    {
        return protocol == other.protocol && modelMajor == other.modelMajor &&
               modelMinor == other.modelMinor && firmwareMajor == other.firmwareMajor &&
               firmwareMinor == other.firmwareMinor && map == other.map;
    }
};

struct JournalItem {
    QString key;
    int address = 0;
    std::int64_t oldRaw = 0;
    std::int64_t newRaw = 0;
};

enum class IntentKind {
    Write,
    SetId,
    SetBaud,
    Mode,
    Calibrate,
    Restore,
    Identify, ///< the LED blinks; the old value is always to be restored
    Trial,    ///< set for the duration of a task; the old value is always to be restored
    Undo,     ///< a write that puts back what an earlier one has changed
};

/// "write", "set-id" … as files have it.
QString intentKindName(IntentKind kind);
std::optional<IntentKind> intentKindFromName(const QString& name);

struct Intent {
    QString uuid; ///< set by begin()
    QDateTime at; ///< set by begin(), UTC
    IntentKind kind = IntentKind::Write;
    bool temporary = false;  ///< the lock stays closed: lost at power-off by design
    bool lockOpened = false; ///< the write opens the EPROM lock
    ServoIdentity servo;
    std::vector<JournalItem> items;
    /// Set by open(): another running program is executing this change. Only that program ends it;
    /// when the program has ended for any reason, the intent is free.
    bool isActiveElsewhere = false;
};

/// An item's end: kept, temporary, mismatch, refused, not-sent, no-answer, unknown, or undone (put
/// back).
struct ItemResult {
    QString key;
    std::optional<std::int64_t> readBack{};
    QString outcome{}; ///< one of these words, as device::outcomeName() has all but the last
};

struct IntentResult {
    QString outcome; ///< "done", "undone", "failed", "abandoned"
    QString detail;
    std::vector<ItemResult> items{}; ///< as far as known, in any order
};

struct JournalEntry {
    Intent intent;
    std::optional<IntentResult> end;
};

class Journal {
public:
    virtual ~Journal() = default;

    /// Records the intent durably and returns its uuid. The write must not begin if this fails.
    virtual Result<QString> begin(const Intent& intent) = 0;
    virtual Result<void> end(const QString& uuid, const IntentResult& end) = 0;

    /// Oldest first.
    virtual Result<std::vector<JournalEntry>> entries() const = 0;
    /// Those without an end.
    virtual Result<std::vector<Intent>> open() const;
    /// The latest `maxCount` entries that may concern this servo: of its kind, with its ID, or
    /// changing to its ID. Servos have no serial number, so a closer match is impossible.
    virtual Result<std::vector<JournalEntry>> entriesFor(const ServoIdentity& servo,
                                                         int maxCount) const;

    /// Small facts by servo (kind and ID) and name; the latest value counts.
    virtual Result<void> saveServoValues(const ServoIdentity& servo, const QString& name,
                                         const std::vector<std::int64_t>& values) = 0;
    virtual Result<std::optional<std::vector<std::int64_t>>>
    servoValues(const ServoIdentity& servo, const QString& name) const = 0;
};
} // namespace base
