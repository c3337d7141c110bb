// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/notice_text.h"

#include "text/alarm_text.h"
#include "text/front_end.h"
#include "text/language.h"
#include "text/text_table.h"

#include <array>

namespace text {
using base::NoticeCode;

namespace {
/// %1 and %2 are the notice's numbers, %3 its register; %recover as in text/front_end.h.
struct NoticeEntry {
    NoticeCode key;
    const char* name;
    const char* text;
};

constexpr std::array noticeEntries{
    NoticeEntry{NoticeCode::TorqueSwitchedOff, "torque-switched-off",
                QT_TRANSLATE_NOOP("text", "Torque was turned off.")},
    NoticeEntry{NoticeCode::TorqueSwitchedOn, "torque-switched-on",
                QT_TRANSLATE_NOOP("text", "Sending the goal turned torque on.")},
    NoticeEntry{NoticeCode::TorqueStaysOff, "torque-stays-off",
                QT_TRANSLATE_NOOP("text", "Torque stays off until you turn it on.")},
    NoticeEntry{NoticeCode::HoldingAt, "holding-at",
                QT_TRANSLATE_NOOP("text", "The servo holds its position (%3 = %1).")},
    NoticeEntry{NoticeCode::LockFoundOpen, "lock-found-open",
                QT_TRANSLATE_NOOP("text", "The EPROM was found unlocked.")},
    NoticeEntry{NoticeCode::LockClosed, "lock-closed",
                QT_TRANSLATE_NOOP("text", "The EPROM has been locked.")},
    NoticeEntry{NoticeCode::LockLeftOpen, "lock-left-open",
                QT_TRANSLATE_NOOP("text",
                                  "The EPROM lock could not be confirmed; this is recorded in the "
                                  "journal. Use %recover when the servo replies again.")},
    NoticeEntry{NoticeCode::CommandZeroed, "command-zeroed",
                QT_TRANSLATE_NOOP(
                    "text", "%3 was set to 0 to prevent unexpected movement in the new mode.")},
    NoticeEntry{NoticeCode::LimitsSaved, "limits-kept",
                QT_TRANSLATE_NOOP("text", "The angle limits (%1 to %2) are saved and will be "
                                          "restored when you switch back to position mode.")},
    NoticeEntry{NoticeCode::LimitsRestored, "limits-restored",
                QT_TRANSLATE_NOOP("text", "The angle limits (%1 to %2) were restored.")},
    NoticeEntry{
        NoticeCode::LimitsSetToDefault, "limits-defaulted",
        QT_TRANSLATE_NOOP("text",
                          "The previous angle limits are unknown, so they were set to %1 and %2.")},
    NoticeEntry{NoticeCode::SpeedRestored, "speed-restored",
                QT_TRANSLATE_NOOP("text", "The speed for position mode, %1 (%3), was restored.")},
    NoticeEntry{NoticeCode::SpeedZeroedForTime, "speed-zero-for-time",
                QT_TRANSLATE_NOOP(
                    "text", "%3 was set to 0; otherwise the travel time would have no effect.")},
    NoticeEntry{NoticeCode::ReplyLostButWritten, "answer-lost-but-done",
                QT_TRANSLATE_NOOP("text", "The acknowledgment was lost; reading back confirmed the "
                                          "change.")},
    NoticeEntry{NoticeCode::ReplyLostResent, "answer-lost-sent-again",
                QT_TRANSLATE_NOOP("text",
                                  "The acknowledgment was lost; reading back showed no change, "
                                  "so the request was sent again.")},
    NoticeEntry{NoticeCode::AckFromNewId, "ack-from-new-id",
                QT_TRANSLATE_NOOP("text", "The reply came from ID %1.")},
    NoticeEntry{NoticeCode::AlreadySet, "already-so",
                QT_TRANSLATE_NOOP("text", "The value was already set; nothing was written.")},
    NoticeEntry{NoticeCode::EffectiveAfterRestart, "acts-after-restart",
                QT_TRANSLATE_NOOP("text", "The change takes effect at the next power-on.")},
    NoticeEntry{NoticeCode::AboveRecommended, "above-usual",
                QT_TRANSLATE_NOOP("text", "%3 is above %1, the highest useful value.")},
    NoticeEntry{NoticeCode::StoppedByUser, "stopped-before",
                QT_TRANSLATE_NOOP("text", "Stopped before %3 was written.")},
    NoticeEntry{NoticeCode::OverloadActive, "overload-holds",
                QT_TRANSLATE_NOOP("text",
                                  "Overload: only the protection torque remains. Remove the load "
                                  "and set a goal away from the stalled position.")},
    NoticeEntry{NoticeCode::OvercurrentActive, "overcurrent-holds",
                QT_TRANSLATE_NOOP("text",
                                  "Overcurrent: torque is off until a new goal is sent. Remove the "
                                  "cause first.")},
    NoticeEntry{NoticeCode::VoltageAlarmActive, "voltage-holds",
                QT_TRANSLATE_NOOP("text", "Voltage: the alarm clears when the supply voltage is "
                                          "back within the servo's limits.")},
    NoticeEntry{
        NoticeCode::TemperatureAlarmActive, "temperature-holds",
        QT_TRANSLATE_NOOP("text", "Temperature: the alarm clears only when the servo cools down.")},
    NoticeEntry{
        NoticeCode::SensorAlarmActive, "sensor-holds",
        QT_TRANSLATE_NOOP(
            "text",
            "Sensor: turn the servo off and on; if the alarm returns, the servo needs repair.")},
    NoticeEntry{NoticeCode::RebootedAfter, "rebooted-after",
                QT_TRANSLATE_NOOP("text", "The servo replied %1 ms after the reboot.")},
    NoticeEntry{NoticeCode::RateChanged, "rate-changed",
                QT_TRANSLATE_NOOP("text", "The servo now replies at %1 baud.")},
    NoticeEntry{NoticeCode::StillMoving, "still-moving",
                QT_TRANSLATE_NOOP("text", "The servo will keep moving to the goal unless it is "
                                          "stopped or torque is turned off.")},
    NoticeEntry{NoticeCode::IdChanged, "id-changed",
                QT_TRANSLATE_NOOP("text", "The servo now replies as ID %1.")},
    NoticeEntry{
        NoticeCode::Resent, "sent-again",
        QT_TRANSLATE_NOOP("text", "Reading back showed no change, so the request was sent again.")},
    NoticeEntry{NoticeCode::PersistenceUndocumented, "persistence-not-stated",
                QT_TRANSLATE_NOOP("text", "Whether %3 is kept after power-off is not documented.")},
    NoticeEntry{NoticeCode::SaveUnverified, "saved-per-sheet",
                QT_TRANSLATE_NOOP("text", "%3 was saved with the command from the data sheet; this "
                                          "can be verified only by turning the servo off and on.")},
    NoticeEntry{NoticeCode::CurrentLimitZero, "no-current-allowed",
                QT_TRANSLATE_NOOP(
                    "text", "%3 is 0, so no current is allowed and the servo has no torque.")},
    NoticeEntry{NoticeCode::CurrentRestored, "current-restored",
                QT_TRANSLATE_NOOP("text", "The current limit %1 (%3) was restored.")},
    NoticeEntry{NoticeCode::DerivedTemperature, "derived-temperature",
                QT_TRANSLATE_NOOP("text", "ServoDesk detected that the temperature is above its "
                                          "limit; the servo did not report this.")},
    NoticeEntry{NoticeCode::DerivedVoltage, "derived-voltage",
                QT_TRANSLATE_NOOP("text", "ServoDesk detected that the voltage is outside its "
                                          "limits; the servo did not report this.")},
    NoticeEntry{NoticeCode::MixedFamilies, "families-mixed",
                QT_TRANSLATE_NOOP("text", "SCS servos share this bus with STS, SMS or HLS servos; "
                                          "the vendor advises against this combination.")},
    NoticeEntry{NoticeCode::LedNotRestored, "led-not-put-back",
                QT_TRANSLATE_NOOP("text",
                                  "The LED setting (%3) could not be restored; this is recorded "
                                  "in the journal. Use %recover when the servo replies again.")},
    NoticeEntry{
        NoticeCode::NotRecorded, "not-recorded",
        QT_TRANSLATE_NOOP(
            "text",
            "Not recorded: the result of this change could not be saved to the history (%3). The "
            "change stays listed as unfinished; use %recover when the history is writable again.")},
    NoticeEntry{
        NoticeCode::SettingNotRestored, "setting-not-put-back",
        QT_TRANSLATE_NOOP(
            "text",
            "%3 could not be restored to %1; this is recorded in the journal. Use %recover when "
            "the servo replies again. At power-off, the servo discards the temporary value.")},
};

constexpr std::array outcomes{
    NamedText{"kept", QT_TRANSLATE_NOOP("text", "kept")},
    NamedText{"temporary", QT_TRANSLATE_NOOP("text", "temporary")},
    NamedText{"mismatch", QT_TRANSLATE_NOOP("text", "mismatch")},
    NamedText{"refused", QT_TRANSLATE_NOOP("text", "refused")},
    NamedText{"not-sent", QT_TRANSLATE_NOOP("text", "not sent")},
    NamedText{"no-answer", QT_TRANSLATE_NOOP("text", "no reply")},
    NamedText{"unknown", QT_TRANSLATE_NOOP("text", "unknown")},
};

constexpr std::array locks{
    NamedText{"closed", QT_TRANSLATE_NOOP("text", "locked")},
    NamedText{"open", QT_TRANSLATE_NOOP("text", "unlocked")},
    NamedText{"unknown", QT_TRANSLATE_NOOP("text", "not confirmed")},
    NamedText{"none", QT_TRANSLATE_NOOP("text", "not affected")},
};

/// The set bits with their names in the status register; null: the bit has no name.
template <typename Name>
QStringList setBits(std::uint8_t status, const catalog::Profile* profile, Name&& name)
{
    QStringList words;
    const catalog::Register* reg =
        profile != nullptr ? profile->byRole(catalog::Role::Status) : nullptr;
    for (int bit = 0; bit < 8; ++bit) {
        if ((status >> bit & 1) == 0)
            continue;
        const catalog::NamedValue* known = nullptr;
        if (reg != nullptr) {
            for (const catalog::NamedValue& value : reg->values)
                known = value.value == bit ? &value : known;
        }
        words << name(bit, known);
    }
    return words;
}
} // namespace

QString describe(const base::Notice& notice)
{
    if (notice.code == NoticeCode::StillMoving && notice.a == 1)
        return translate("text", "The servo may keep moving to the goal with torque on unless it "
                                 "is stopped or torque is turned off.");
    const NoticeEntry* entry = entryFor(noticeEntries, notice.code);
    return withRecoveryName(translate("text", entry->text))
        .replace(QLatin1String("%1"), QString::number(notice.a))
        .replace(QLatin1String("%2"), QString::number(notice.b))
        .replace(QLatin1String("%3"), notice.key);
}

QString noticeName(NoticeCode code)
{
    return QLatin1String(entryFor(noticeEntries, code)->name);
}

QString outcomeLabel(const QString& outcome)
{
    return textFor(outcomes, outcome);
}

QString lockLabel(const QString& lock)
{
    return textFor(locks, lock);
}

QString lineLabel(catalog::Line line)
{
    switch (line) {
    case catalog::Line::Ttl:
        return translate("text", "TTL, half duplex");
    case catalog::Line::Rs485:
        return translate("text", "RS485");
    case catalog::Line::Unknown:
        break;
    }
    return translate("text", "unknown");
}

QString areaLabel(catalog::Area area)
{
    switch (area) {
    case catalog::Area::Eprom:
        return QStringLiteral("EPROM");
    case catalog::Area::Sram:
        return QStringLiteral("SRAM");
    case catalog::Area::Feedback:
        return translate("text", "feedback");
    case catalog::Area::Factory:
        return translate("text", "factory");
    }
    return {};
}

QString accessLabel(catalog::Access access)
{
    return access == catalog::Access::ReadOnly ? translate("text", "read-only")
                                               : translate("text", "read/write");
}

bool reportsAlarms(const catalog::Profile* profile)
{
    return profile == nullptr || profile->protocol == base::Protocol::Feetech ||
           profile->byRole(catalog::Role::Status) != nullptr;
}

QStringList statusKeys(std::uint8_t status, const catalog::Profile* profile)
{
    return setBits(status, profile, [](int bit, const catalog::NamedValue* known) {
        return known != nullptr ? known->key : QStringLiteral("bit%1").arg(bit);
    });
}

QString statusText(std::uint8_t status, const catalog::Profile* profile)
{
    if (!reportsAlarms(profile))
        return translate("text", "not reported", "alarms");
    const QStringList words =
        setBits(status, profile, [](int bit, const catalog::NamedValue* known) {
            if (known == nullptr)
                return translate("text", "bit %1").arg(bit);
            const QString label = alarmLabel(known->key);
            return label != known->key ? label : known->name.in(isUiChinese());
        });
    return words.isEmpty() ? translate("text", "none", "alarms")
                           : words.join(QStringLiteral(" + "));
}
} // namespace text
