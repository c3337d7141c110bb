// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_text.h"

#include "device/write_access.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/translate.h"
#include "ui/editors/register_text.h"
#include "ui/widgets/servo_obstacle.h"

#include <QStringList>

#include <cstdlib>

namespace ui {
using device::PositiveDirection;
using device::ZeroSpeed;
using text::translate;

namespace {
constexpr double degreesPerSecondPerRpm = 6;

QString valueOf(const catalog::Profile& profile, const QString& key,
                const std::optional<std::int64_t>& raw)
{
    const catalog::Register* reg = profile.find(key);
    if (reg == nullptr || !raw)
        return QStringLiteral("–");
    return rawWord(*raw, *reg, catalog::valueFormat(*reg, profile, catalog::noLookup));
}

} // namespace

QString physicalValueText(std::int64_t raw, const catalog::Register& reg,
                          const catalog::ValueFormat& meaning)
{
    if (meaning.unit.isEmpty())
        return {};
    if (reg.role == catalog::Role::Acceleration && raw == 0)
        return translate("ControlText", "0 = maximum");
    const double value = catalog::toPhysical(raw, meaning);
    const QString words = physicalText(raw, reg, meaning);
    if (meaning.unit != QLatin1StringView("rpm"))
        return words;
    return QStringLiteral("%1 · %2 °/s")
        .arg(words)
        .arg(value * degreesPerSecondPerRpm, 0, 'f', std::abs(value) < 1 ? 1 : 0);
}

QString turnSymbol(PositiveDirection positive, bool plus)
{
    if (positive == PositiveDirection::Forward)
        return plus ? QStringLiteral("+") : QStringLiteral("−");
    const bool clockwise = (positive == PositiveDirection::Clockwise) == plus;
    return clockwise ? QStringLiteral("↻") : QStringLiteral("↺");
}

QString turnText(PositiveDirection positive, bool plus)
{
    if (positive == PositiveDirection::Forward)
        return plus ? translate("ControlText", "forward") : translate("ControlText", "reverse");
    const bool clockwise = (positive == PositiveDirection::Clockwise) == plus;
    return clockwise ? translate("ControlText", "clockwise")
                     : translate("ControlText", "counterclockwise");
}

bool isAboveMaxSpeed(const device::Servo& servo, std::optional<std::int64_t> speed)
{
    const auto top = device::maxGoalSpeed(servo);
    return top && speed && std::abs(*speed) > *top;
}

QString speedHint(const device::Servo& servo, std::optional<std::int64_t> speed)
{
    QStringList words;
    switch (device::zeroSpeed(servo)) {
    case ZeroSpeed::Stops:
        words << (servo.profile->byRole(catalog::Role::GoalCurrent) != nullptr
                      ? translate("ControlText", "Speed 0 = stop")
                      : translate("ControlText", "Speed 0 = stop (phase bit 3)"));
        break;
    case ZeroSpeed::Fastest:
        words << translate("ControlText", "Speed 0 = maximum (phase bit 3)");
        break;
    case ZeroSpeed::ByTime:
        words << translate("ControlText", "Speed 0 = travel time applies");
        break;
    case ZeroSpeed::Unknown:
        break;
    }
    const catalog::Register* reg = servo.profile->byRole(catalog::Role::GoalSpeed);
    const auto top = device::maxGoalSpeed(servo);
    if (reg != nullptr && top) {
        const QString maxText = physicalText(*top, *reg, servo.meaning(*reg));
        words << (isAboveMaxSpeed(servo, speed)
                      ? translate("ControlText", "limited to %1 (%2), the maximum for this model")
                            .arg(*top)
                            .arg(maxText)
                      : translate("ControlText", "maximum for this model: %1 (%2)")
                            .arg(*top)
                            .arg(maxText));
    }
    return words.join(QStringLiteral(" · "));
}

QString modeTitle(const catalog::Mode& mode)
{
    QString name = text::localized(mode.name);
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

QString modeHelp(const QString& key)
{
    static const std::pair<const char*, const char*> words[] = {
        {"position", QT_TRANSLATE_NOOP("ControlText", "Moves to an angle within the angle limits")},
        {"multiturn",
         QT_TRANSLATE_NOOP("ControlText", "Moves to an angle up to 7.5 turns in either "
                                          "direction; turns are counted from power-on")},
        {"speed", QT_TRANSLATE_NOOP("ControlText", "Turns continuously and holds its speed "
                                                   "under load")},
        {"pwm", QT_TRANSLATE_NOOP("ControlText", "Turns continuously; the speed drops under load")},
        {"step", QT_TRANSLATE_NOOP(
                     "ControlText",
                     "Each goal is relative to the present position, up to 7.5 turns in total")},
        {"motor", QT_TRANSLATE_NOOP("ControlText", "Turns continuously like a motor")},
        {"current", QT_TRANSLATE_NOOP("ControlText", "Controls the current and thus the torque")},
        {"position-pd",
         QT_TRANSLATE_NOOP(
             "ControlText",
             "Position control without an integral term (newer firmware); one turn only")},
        {"release", QT_TRANSLATE_NOOP("ControlText", "Moves to an angle, then turns torque off")},
    };
    for (const auto& [mode, word] : words) {
        if (key == QLatin1StringView(mode))
            return translate("ControlText", word);
    }
    return {};
}

namespace {
void addLimits(QStringList& lines, const device::ModePlan& plan)
{
    if (plan.writes.size() < 2 || !plan.writes[0].oldRaw || !plan.writes[1].oldRaw)
        return;
    const QString limits = QStringLiteral("%1 … %2");
    if (plan.limitsSaved) {
        lines << translate(
                     "ControlText",
                     "The angle limits %1 will be saved and then restored when you switch back.")
                     .arg(limits.arg(*plan.writes[0].oldRaw).arg(*plan.writes[1].oldRaw));
    }
    const QString now = limits.arg(plan.writes[0].newRaw).arg(plan.writes[1].newRaw);
    if (plan.limitsRestored)
        lines << translate("ControlText", "The previous angle limits %1 are restored.").arg(now);
    if (plan.limitsSetToDefault) {
        lines << translate(
                     "ControlText",
                     "No angle limits are saved for this servo, so the factory limits %1 are used.")
                     .arg(now);
    }
}
} // namespace

QString modePlanText(const device::ModePlan& plan, const catalog::Profile& profile, int others)
{
    QStringList lines;
    lines << (plan.torqueGoesOff
                  ? translate("ControlText", "Torque is turned off first and stays off until "
                                             "you turn it on.")
                  : translate("ControlText", "Torque is off and stays off."));
    for (const device::ModePlan::Write& write : plan.writes) {
        const catalog::Register* reg = profile.find(write.key);
        lines << QStringLiteral("• %1 (%2): %3 → %4")
                     .arg(text::registerName(&profile, write.key))
                     .arg(reg != nullptr ? reg->address : 0)
                     .arg(valueOf(profile, write.key, write.oldRaw),
                          valueOf(profile, write.key, write.newRaw));
    }
    addLimits(lines, plan);
    if (!plan.zeroed.isEmpty()) {
        lines << translate("ControlText", "\"%1\" is set to 0 to prevent unexpected movement.")
                     .arg(text::registerName(&profile, plan.zeroed));
    }
    lines << translate("ControlText",
                       "All written values are read back. The mode is kept after power-off.");
    if (others > 0) {
        lines << translate("ControlText",
                           "%n other selected servo(s) will be switched in the same way.", nullptr,
                           others);
    }
    return lines.join(QLatin1Char('\n'));
}

QString controlObstacle(const session::ServoEntry* entry)
{
    if (entry == nullptr)
        return translate("ControlText",
                         "Select a servo on the left. Selecting a servo does not move it.");
    if (!entry->servo.profile)
        return unidentifiedText(*entry);
    if (entry->servo.profile->conflict) {
        const auto obstacle = device::writeObstacle(entry->servo);
        const text::Description words = text::describe(*obstacle);
        return QStringList{words.message, words.cause, words.remedy}.join(QLatin1Char('\n'));
    }
    if (!entry->servo.profile->writable)
        return translate(
            "ControlText",
            "The firmware of this servo is unknown. Measurements are shown, but moving the servo "
            "could cause damage. To allow movement, add a model file.");
    if (entry->servo.mode() != nullptr)
        return {};
    return entry->readError
               ? translate("ControlText", "The settings of this servo could not be read.")
               : translate("ControlText", "Reading the settings of this servo…");
}

namespace {
NoticeKind kindOf(device::NoticeCode code)
{
    using device::NoticeCode;
    switch (code) {
    case NoticeCode::OverloadActive:
    case NoticeCode::OvercurrentActive:
    case NoticeCode::VoltageAlarmActive:
    case NoticeCode::TemperatureAlarmActive:
    case NoticeCode::SensorAlarmActive:
    case NoticeCode::DerivedTemperature:
    case NoticeCode::DerivedVoltage:
    case NoticeCode::CurrentLimitZero:
    case NoticeCode::LockLeftOpen:
        return NoticeKind::Warning;
    default:
        return NoticeKind::Result;
    }
}
} // namespace

QString noticeLines(const device::Notices& notices, const catalog::ProfilePtr& profile,
                    NoticeKind kind)
{
    QStringList lines;
    for (device::Notice notice : notices) {
        if (kindOf(notice.code) != kind)
            continue;
        const catalog::Register* reg = profile ? profile->find(notice.key) : nullptr;
        if (reg != nullptr)
            notice.key = text::localized(reg->name);
        lines << text::describe(notice);
    }
    lines.removeDuplicates();
    return lines.join(QLatin1Char('\n'));
}
} // namespace ui
