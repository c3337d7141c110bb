// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/notice_text.h"

#include "text/front_end.h"
#include "text/translate.h"

#include <array>

namespace text {
using base::NoticeCode;

namespace {
/// %1 and %2 are the notice's numbers, %3 its register; %recover as in text/front_end.h.
struct NoticeEntry {
    NoticeCode code;
    const char* name;
    const char* sentence;
};

constexpr std::array noticeEntries{
    NoticeEntry{NoticeCode::TorqueSwitchedOff, "torque-switched-off",
                QT_TRANSLATE_NOOP("text", "Torque was switched off.")},
    NoticeEntry{NoticeCode::TorqueSwitchedOn, "torque-switched-on",
                QT_TRANSLATE_NOOP("text", "The goal switched torque on.")},
    NoticeEntry{NoticeCode::TorqueStaysOff, "torque-stays-off",
                QT_TRANSLATE_NOOP("text", "Torque stays off until you switch it on.")},
    NoticeEntry{NoticeCode::HoldingAt, "holding-at",
                QT_TRANSLATE_NOOP("text", "It holds where it is (%3 = %1).")},
    NoticeEntry{NoticeCode::LockFoundOpen, "lock-found-open",
                QT_TRANSLATE_NOOP("text", "The EPROM lock was found open.")},
    NoticeEntry{NoticeCode::LockClosed, "lock-closed",
                QT_TRANSLATE_NOOP("text", "The EPROM lock has been closed.")},
    NoticeEntry{
        NoticeCode::LockLeftOpen, "lock-left-open",
        QT_TRANSLATE_NOOP("text",
                          "The EPROM lock could not be proven closed; it is noted in the journal. "
                          "Use %recover when the servo answers again.")},
    NoticeEntry{
        NoticeCode::CommandZeroed, "command-zeroed",
        QT_TRANSLATE_NOOP("text", "%3 was set to 0, so that nothing moves in the new mode.")},
    NoticeEntry{NoticeCode::LimitsSaved, "limits-kept",
                QT_TRANSLATE_NOOP("text", "The angle limits %1 … %2 are kept for the way back.")},
    NoticeEntry{NoticeCode::LimitsRestored, "limits-restored",
                QT_TRANSLATE_NOOP("text", "The angle limits %1 … %2 are back.")},
    NoticeEntry{NoticeCode::LimitsSetToDefault, "limits-defaulted",
                QT_TRANSLATE_NOOP("text", "No earlier angle limits are known; %1 … %2 were set.")},
    NoticeEntry{NoticeCode::SpeedRestored, "speed-restored",
                QT_TRANSLATE_NOOP("text", "The position speed %1 (%3) is back.")},
    NoticeEntry{NoticeCode::SpeedZeroedForTime, "speed-zero-for-time",
                QT_TRANSLATE_NOOP("text", "%3 was set to 0, because the time acts only then.")},
    NoticeEntry{
        NoticeCode::ReplyLostButWritten, "answer-lost-but-done",
        QT_TRANSLATE_NOOP("text", "The acknowledgement was lost; reading proved that it is done.")},
    NoticeEntry{NoticeCode::ReplyLostResent, "answer-lost-sent-again",
                QT_TRANSLATE_NOOP("text",
                                  "The acknowledgement was lost; reading proved that nothing had "
                                  "happened, so it was sent again.")},
    NoticeEntry{NoticeCode::AckFromNewId, "ack-from-new-id",
                QT_TRANSLATE_NOOP("text", "The change was acknowledged under ID %1.")},
    NoticeEntry{NoticeCode::AlreadySet, "already-so",
                QT_TRANSLATE_NOOP("text", "It was so already; nothing was written.")},
    NoticeEntry{NoticeCode::EffectiveAfterRestart, "acts-after-restart",
                QT_TRANSLATE_NOOP("text", "This takes effect at the next power-on.")},
    NoticeEntry{NoticeCode::AboveRecommended, "above-usual",
                QT_TRANSLATE_NOOP("text", "%3 is above %1, which is the highest useful value.")},
    NoticeEntry{NoticeCode::StoppedByUser, "stopped-before",
                QT_TRANSLATE_NOOP("text", "Stopped before %3 was written.")},
    NoticeEntry{NoticeCode::OverloadActive, "overload-holds",
                QT_TRANSLATE_NOOP(
                    "text", "Overload: only the holding torque is left. Take the load off and "
                            "give a goal away from the stall.")},
    NoticeEntry{NoticeCode::OvercurrentActive, "overcurrent-holds",
                QT_TRANSLATE_NOOP(
                    "text", "Overcurrent: torque is off until a new goal is given. Remove the "
                            "cause first.")},
    NoticeEntry{NoticeCode::VoltageAlarmActive, "voltage-holds",
                QT_TRANSLATE_NOOP("text",
                                  "Voltage: it passes when the supply is inside the servo's limits "
                                  "again.")},
    NoticeEntry{NoticeCode::TemperatureAlarmActive, "temperature-holds",
                QT_TRANSLATE_NOOP("text", "Temperature: it passes by cooling only.")},
    NoticeEntry{NoticeCode::SensorAlarmActive, "sensor-holds",
                QT_TRANSLATE_NOOP("text",
                                  "Encoder: switch the servo off and on; if it returns, the servo "
                                  "needs repair.")},
    NoticeEntry{NoticeCode::RebootedAfter, "rebooted-after",
                QT_TRANSLATE_NOOP("text", "It answered %1 ms after the restart.")},
    NoticeEntry{NoticeCode::RateChanged, "rate-changed",
                QT_TRANSLATE_NOOP("text", "It answers at %1 baud now.")},
    NoticeEntry{
        NoticeCode::StillMoving, "still-moving",
        QT_TRANSLATE_NOOP(
            "text", "It is still on its way to the goal, until it is stopped or torque is off.")},
    NoticeEntry{NoticeCode::IdChanged, "id-changed",
                QT_TRANSLATE_NOOP("text", "It answers as ID %1 now.")},
    NoticeEntry{NoticeCode::Resent, "sent-again",
                QT_TRANSLATE_NOOP("text",
                                  "Reading proved that nothing had happened, so it was sent "
                                  "again.")},
    NoticeEntry{NoticeCode::PersistenceUndocumented, "persistence-not-stated",
                QT_TRANSLATE_NOOP("text", "Whether %3 survives power-off is not documented.")},
    NoticeEntry{NoticeCode::SaveUnverified, "saved-per-sheet",
                QT_TRANSLATE_NOOP("text",
                                  "%3 was saved, as the data sheet has it; only switching the "
                                  "servo off and on could prove it.")},
    NoticeEntry{
        NoticeCode::CurrentLimitZero, "no-current-allowed",
        QT_TRANSLATE_NOOP("text", "%3 is 0, which allows no current: the servo has no torque.")},
    NoticeEntry{NoticeCode::CurrentRestored, "current-restored",
                QT_TRANSLATE_NOOP("text", "The current limit %1 (%3) is back.")},
    NoticeEntry{NoticeCode::DerivedTemperature, "derived-temperature",
                QT_TRANSLATE_NOOP("text",
                                  "The temperature is above its limit (derived from its limits, "
                                  "not reported by the servo).")},
    NoticeEntry{NoticeCode::DerivedVoltage, "derived-voltage",
                QT_TRANSLATE_NOOP("text",
                                  "The voltage is outside its limits (derived from its limits, "
                                  "not reported by the servo).")},
    NoticeEntry{NoticeCode::MixedFamilies, "families-mixed",
                QT_TRANSLATE_NOOP("text",
                                  "SCS servos share this line with STS, SMS or HLS servos; the "
                                  "vendor advises against it.")},
    NoticeEntry{NoticeCode::LedNotRestored, "led-not-put-back",
                QT_TRANSLATE_NOOP("text",
                                  "The LED setting (%3) could not be put back; it is noted in "
                                  "the journal. Use %recover when the servo answers again.")},
    NoticeEntry{NoticeCode::NotRecorded, "not-recorded",
                QT_TRANSLATE_NOOP(
                    "text", "Not recorded: the outcome of this change could not be saved to "
                            "the history (%3). It stays listed as open; use %recover when the "
                            "history can be written again.")},
    NoticeEntry{NoticeCode::SettingNotRestored, "setting-not-put-back",
                QT_TRANSLATE_NOOP("text",
                                  "%3 could not be put back to %1; it is noted in the journal. "
                                  "Use %recover when the servo answers again. At power-off the "
                                  "servo forgets the temporary value by itself.")},
};

const NoticeEntry* entryFor(NoticeCode code)
{
    for (const NoticeEntry& entry : noticeEntries) {
        if (entry.code == code)
            return &entry;
    }
    return nullptr;
}

struct TextEntry {
    const char* name;
    const char* word;
};

constexpr std::array outcomes{
    TextEntry{"kept", QT_TRANSLATE_NOOP("text", "kept")},
    TextEntry{"temporary", QT_TRANSLATE_NOOP("text", "temporary")},
    TextEntry{"mismatch", QT_TRANSLATE_NOOP("text", "mismatch")},
    TextEntry{"refused", QT_TRANSLATE_NOOP("text", "refused")},
    TextEntry{"not-sent", QT_TRANSLATE_NOOP("text", "not sent")},
    TextEntry{"no-answer", QT_TRANSLATE_NOOP("text", "no answer")},
    TextEntry{"unknown", QT_TRANSLATE_NOOP("text", "unknown")},
};

constexpr std::array locks{
    TextEntry{"closed", QT_TRANSLATE_NOOP("text", "closed")},
    TextEntry{"open", QT_TRANSLATE_NOOP("text", "open")},
    TextEntry{"unknown", QT_TRANSLATE_NOOP("text", "not proven closed")},
    TextEntry{"none", QT_TRANSLATE_NOOP("text", "not concerned")},
};

template <typename Words>
QString textFor(const Words& words, const QString& name)
{
    for (const TextEntry& word : words) {
        if (name == QLatin1String(word.name))
            return translate("text", word.word);
    }
    return name;
}

/// The set bits, as the status register of the family names them.
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
        return translate("text", "It may still be on its way to the goal, with torque on, until it "
                                 "is stopped or torque is off.");
    const NoticeEntry* entry = entryFor(notice.code);
    return withRecoveryName(translate("text", entry->sentence))
        .replace(QLatin1String("%1"), QString::number(notice.a))
        .replace(QLatin1String("%2"), QString::number(notice.b))
        .replace(QLatin1String("%3"), notice.key);
}

QString noticeName(NoticeCode code)
{
    return QLatin1String(entryFor(code)->name);
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
        return translate("text", "TTL, one wire");
    case catalog::Line::Rs485:
        return translate("text", "RS485");
    case catalog::Line::Unknown:
        break;
    }
    return translate("text", "not known");
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
    return access == catalog::Access::ReadOnly ? translate("text", "read only")
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

QString statusText(std::uint8_t status, const catalog::Profile* profile, bool chinese)
{
    if (!reportsAlarms(profile))
        return translate("text", "not reported", "alarms");
    const QStringList words =
        setBits(status, profile, [chinese](int bit, const catalog::NamedValue* known) {
            return known != nullptr ? known->name.in(chinese)
                                    : translate("text", "bit %1").arg(bit);
        });
    return words.isEmpty() ? translate("text", "none", "alarms")
                           : words.join(QStringLiteral(" + "));
}
} // namespace text
