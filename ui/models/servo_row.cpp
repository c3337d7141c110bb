// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/servo_row.h"

#include "device/alarms.h"
#include "text/language.h"
#include "text/notice_words.h"
#include "ui/models/rate_words.h"

#include <QCoreApplication>

namespace ui {
namespace {
using catalog::Role;

QString words(const char* source, const char* comment = nullptr)
{
    return QCoreApplication::translate("ServoRow", source, comment);
}

QString protocolWord(base::Protocol protocol)
{
    switch (protocol) {
    case base::Protocol::Modbus:
        return QStringLiteral("Modbus");
    case base::Protocol::Lx:
        return QStringLiteral("LX");
    case base::Protocol::Feetech:
        break;
    }
    return words("Feetech");
}

QString shortLine(catalog::Line line)
{
    switch (line) {
    case catalog::Line::Ttl:
        return QStringLiteral("TTL");
    case catalog::Line::Rs485:
        return QStringLiteral("RS485");
    case catalog::Line::Unknown:
        break;
    }
    return {};
}

struct State {
    QString alarm;
    Tone tone = Tone::Quiet;
};

/// Worked out here, because the servo reports nothing itself; fine only if there was enough to
/// judge by.
State derivedState(const device::Servo& servo)
{
    const auto alarms = device::derivedAlarms(servo);
    QStringList names;
    for (const device::Notice& alarm : alarms)
        names << (alarm.code == device::NoticeCode::DerivedTemperature ? words("temperature")
                                                                       : words("voltage"));
    if (!names.isEmpty())
        return {names.join(QStringLiteral(" + ")), Tone::Bad};
    const bool judged = servo.raw(Role::PresentTemperature) && servo.raw(Role::PresentVoltage) &&
                        servo.raw(Role::MaxTemperature);
    return judged ? State{words("fine"), Tone::Good} : State{words("not read"), Tone::Quiet};
}

State stateOf(const session::ServoEntry& entry)
{
    const device::Servo& servo = entry.servo;
    const catalog::Profile* profile = servo.profile.get();
    if (entry.silent)
        return {words("no answer"), Tone::Quiet};
    if (servo.status != 0)
        return {text::statusWords(servo.status, profile, text::inChinese()), Tone::Bad};
    if (profile == nullptr)
        return {words("not identified"), Tone::Warn};
    if (servo.repliesCarryStatus())
        return {words("fine"), Tone::Good};
    if (const catalog::Register* status = profile->byRole(Role::Status))
        return servo.raw(*status) ? State{words("fine"), Tone::Good}
                                  : State{words("not read"), Tone::Quiet};
    return derivedState(servo);
}

std::vector<ServoRemark> remarksOf(const session::ServoEntry& entry,
                                   const std::optional<catalog::KnownFirmware>& newer)
{
    std::vector<ServoRemark> remarks;
    const catalog::Profile* profile = entry.servo.profile.get();
    if (entry.twinsSuspected)
        remarks.push_back({Tone::Bad, words("Two servos with this ID?")});
    if (entry.lockOpen().value_or(false))
        remarks.push_back({Tone::Warn, entry.lockOpenedByUs
                                           ? words("EPROM lock open, opened by ServoDesk")
                                           : words("EPROM lock open")});
    if (entry.heardLate)
        remarks.push_back({Tone::Warn, words("Answers late")});
    if (profile != nullptr && !profile->writable)
        remarks.push_back({Tone::Warn, words("Unknown firmware: read only")});
    if (newer)
        remarks.push_back(
            {Tone::Accent,
             words("Firmware %1 known (%2)")
                 .arg(newer->version(), newer->date.toString(QStringLiteral("yyyy-MM")))});
    return remarks;
}
} // namespace

QString agoWords(base::Duration age)
{
    constexpr int soon = 2;
    constexpr int minute = 60;
    const auto seconds = int(age.count() / 1'000'000);
    if (seconds < soon)
        return words("now", "last seen");
    if (seconds < minute)
        return words("%1 s ago").arg(seconds);
    return words("%1 min ago").arg(seconds / minute);
}

ServoRow servoRow(const session::ServoEntry& entry,
                  const std::optional<catalog::KnownFirmware>& newer, base::Duration now)
{
    const device::Servo& servo = entry.servo;
    const catalog::Profile* profile = servo.profile.get();
    ServoRow row;
    row.ref = entry.ref;
    row.id = servo.id;
    row.model = profile != nullptr ? profile->modelName : words("Unknown servo");
    row.protocol = protocolWord(servo.protocol);
    row.rate = shortRate(servo.baud);
    if (profile != nullptr) {
        row.map = profile->mapKey;
        row.line = shortLine(profile->line);
        if (profile->identity.firmwareMajor >= 0)
            row.firmware = profile->identity.firmware();
    }
    const State state = stateOf(entry);
    row.alarm = state.alarm;
    row.alarmTone = state.tone;
    row.lastSeen = agoWords(now - entry.lastSeen);
    row.remarks = remarksOf(entry, newer);
    row.silent = entry.silent;
    return row;
}

QString ServoRow::details() const
{
    QStringList parts;
    for (const QString& part :
         {firmware.isEmpty() ? QString() : words("fw %1").arg(firmware), map, line, rate}) {
        if (!part.isEmpty())
            parts << part;
    }
    return parts.join(QStringLiteral(" · "));
}

QString ServoRow::everything() const
{
    const QString unknown = words("not known");
    const auto known = [&](const QString& text) { return text.isEmpty() ? unknown : text; };
    QStringList lines{
        words("ID %1 · %2").arg(id).arg(model),     words("State: %1").arg(alarm),
        words("Firmware: %1").arg(known(firmware)), words("Register map: %1").arg(known(map)),
        words("Line: %1").arg(known(line)),         words("Protocol: %1").arg(protocol),
        words("Baud rate: %1").arg(rate),           words("Last seen: %1").arg(lastSeen)};
    for (const ServoRemark& remark : remarks)
        lines << remark.text;
    return lines.join(QLatin1Char('\n'));
}
} // namespace ui
