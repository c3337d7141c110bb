// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/servo_row.h"

#include "device/alarms.h"
#include "session/polling/max_reading_age.h"
#include "text/bus_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/translate.h"
#include "ui/widgets/rate_text.h"

#include <algorithm>

namespace ui {
namespace {
using catalog::Role;
using text::translate;

QString shortenedLine(catalog::Line line)
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

/// Derived here, because the servo reports no faults itself; OK only if enough was read to judge.
State derivedState(const device::Servo& servo)
{
    const auto alarms = device::derivedAlarms(servo);
    QStringList names;
    for (const device::Notice& alarm : alarms)
        names << (alarm.code == device::NoticeCode::DerivedTemperature
                      ? translate("ServoRow", "temperature")
                      : translate("ServoRow", "voltage"));
    if (!names.isEmpty())
        return {names.join(QStringLiteral(" + ")), Tone::Bad};
    const bool judged = servo.raw(Role::PresentTemperature) && servo.raw(Role::PresentVoltage) &&
                        servo.raw(Role::MaxTemperature);
    return judged ? State{translate("ServoRow", "OK"), Tone::Good}
                  : State{translate("ServoRow", "not read"), Tone::Quiet};
}

State stateOf(const session::ServoEntry& entry)
{
    const device::Servo& servo = entry.servo;
    const catalog::Profile* profile = servo.profile.get();
    if (entry.silent && entry.garbled)
        return {translate("ServoRow", "replies cannot be decoded"), Tone::Bad};
    if (entry.silent)
        return {translate("ServoRow", "no reply"), Tone::Quiet};
    if (servo.status != 0)
        return {text::statusText(servo.status, profile), Tone::Bad};
    if (profile == nullptr)
        return {translate("ServoRow", "not identified"), Tone::Warn};
    if (servo.repliesCarryStatus())
        return {translate("ServoRow", "OK"), Tone::Good};
    if (const catalog::Register* status = profile->byRole(Role::Status))
        return servo.raw(*status) ? State{translate("ServoRow", "OK"), Tone::Good}
                                  : State{translate("ServoRow", "not read"), Tone::Quiet};
    return derivedState(servo);
}

/// A lock flag read during a write to the EPROM does not show its state after the write.
bool isLockReadSinceWrites(const session::ServoEntry& entry)
{
    const catalog::Register* lock = entry.servo.profile->byRole(Role::Lock);
    const auto read = entry.servo.image.readAt(lock->offset);
    return std::all_of(entry.writes.begin(), entry.writes.end(), [&](const auto& row) {
        const catalog::Register* reg = entry.servo.profile->find(row.first);
        return reg == nullptr || reg->area != catalog::Area::Eprom || row.second.pending > 0 ||
               (read && row.second.at <= *read);
    });
}

/// Of one that was open when it was last read.
QString lockRemark(const session::ServoEntry& entry, bool old)
{
    const bool isReadSinceWrites = isLockReadSinceWrites(entry);
    if (!entry.lockOpenedByUs)
        return isReadSinceWrites ? translate("ServoRow", "EPROM unlocked")
                                 : translate("ServoRow", "EPROM lock not confirmed");
    return isReadSinceWrites && !entry.silent && !old
               ? translate("ServoRow", "EPROM unlocked by ServoDesk")
               : translate("ServoRow", "EPROM unlocked by ServoDesk; relocking not confirmed");
}

std::vector<ServoRemark> remarksOf(const session::ServoEntry& entry,
                                   const std::optional<catalog::KnownFirmware>& newer, bool old,
                                   bool firmwareDiffers)
{
    std::vector<ServoRemark> remarks;
    const catalog::Profile* profile = entry.servo.profile.get();
    if (entry.duplicateSuspected)
        remarks.push_back({Tone::Bad, translate("ServoRow", "Two servos with this ID?")});
    if (entry.isLockOpen().value_or(false))
        remarks.push_back({Tone::Warn, lockRemark(entry, old)});
    if (entry.lateReplySeen)
        remarks.push_back({Tone::Warn, translate("ServoRow", "Replies late")});
    if (profile != nullptr && profile->conflict)
        remarks.push_back({Tone::Bad, translate("ServoRow", "Family unclear: read-only")});
    else if (profile != nullptr && !profile->writable)
        remarks.push_back({Tone::Warn, translate("ServoRow", "Unknown firmware: read-only")});
    if (firmwareDiffers)
        remarks.push_back({Tone::Warn, translate("ServoRow", "Firmware differs from the others")});
    if (newer)
        remarks.push_back(
            {Tone::Accent,
             translate("ServoRow", "Newer firmware exists: %1 (%2)")
                 .arg(newer->version(), newer->date.toString(QStringLiteral("yyyy-MM")))});
    return remarks;
}
} // namespace

ServoRow servoRow(const session::ServoEntry& entry,
                  const std::optional<catalog::KnownFirmware>& newer, base::Duration now,
                  bool firmwareDiffers)
{
    const device::Servo& servo = entry.servo;
    const catalog::Profile* profile = servo.profile.get();
    ServoRow row;
    row.ref = entry.ref;
    row.id = servo.id;
    row.model = profile != nullptr ? profile->modelName : translate("ServoRow", "Unknown servo");
    row.protocol = text::protocolText(servo.protocol);
    row.rate = shortRate(servo.baud);
    if (profile != nullptr) {
        row.map = profile->mapKey;
        row.line = shortenedLine(profile->line);
        if (profile->identity.firmwareMajor >= 0)
            row.firmware = profile->identity.firmware();
    }
    const State state = stateOf(entry);
    row.alarm = state.alarm;
    const bool old = now - entry.lastSeen > session::maxReadingAge;
    row.alarmTone = state.tone == Tone::Good && old ? Tone::Quiet : state.tone;
    row.lastSeen = timeAgoText(now - entry.lastSeen);
    row.remarks = remarksOf(entry, newer, old, firmwareDiffers);
    row.isSilent = entry.silent;
    return row;
}

QString ServoRow::details() const
{
    QStringList parts;
    for (const QString& part :
         {firmware.isEmpty() ? QString() : translate("ServoRow", "fw %1").arg(firmware), map, line,
          rate}) {
        if (!part.isEmpty())
            parts << part;
    }
    return parts.join(QStringLiteral(" · "));
}

QString ServoRow::toolTipText() const
{
    const QString unknown = translate("ServoRow", "unknown");
    const auto known = [&](const QString& text) { return text.isEmpty() ? unknown : text; };
    QStringList lines{translate("ServoRow", "ID %1 · %2").arg(id).arg(model),
                      translate("ServoRow", "State: %1").arg(alarm),
                      translate("ServoRow", "Firmware: %1").arg(known(firmware)),
                      translate("ServoRow", "Register map: %1").arg(known(map)),
                      translate("ServoRow", "Bus type: %1").arg(known(line)),
                      translate("ServoRow", "Protocol: %1").arg(protocol),
                      translate("ServoRow", "Baud rate: %1").arg(rate),
                      translate("ServoRow", "Last seen: %1").arg(lastSeen)};
    for (const ServoRemark& remark : remarks)
        lines << remark.text;
    return lines.join(QLatin1Char('\n'));
}
} // namespace ui
