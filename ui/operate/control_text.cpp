// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_text.h"

#include "text/language.h"
#include "text/translate.h"
#include "ui/editors/register_text.h"

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

QString nameOf(const catalog::Profile& profile, const QString& key)
{
    const catalog::Register* reg = profile.find(key);
    return reg != nullptr ? reg->name.in(text::isUiChinese()) : key;
}
} // namespace

QString physicalValueText(std::int64_t raw, const catalog::Register& reg,
                          const catalog::ValueFormat& meaning)
{
    if (meaning.unit.isEmpty())
        return {};
    if (reg.role == catalog::Role::Acceleration && raw == 0)
        return translate("ControlWords", "0 = the strongest");
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
        return plus ? translate("ControlWords", "forward") : translate("ControlWords", "reverse");
    const bool clockwise = (positive == PositiveDirection::Clockwise) == plus;
    return clockwise ? translate("ControlWords", "clockwise")
                     : translate("ControlWords", "counter-clockwise");
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
                      ? translate("ControlWords", "Speed 0 = stop")
                      : translate("ControlWords", "Speed 0 = stop (phase bit 3)"));
        break;
    case ZeroSpeed::Fastest:
        words << translate("ControlWords", "Speed 0 = maximum (phase bit 3)");
        break;
    case ZeroSpeed::ByTime:
        words << translate("ControlWords", "Speed 0 = the time counts");
        break;
    case ZeroSpeed::Unknown:
        break;
    }
    const catalog::Register* reg = servo.profile->byRole(catalog::Role::GoalSpeed);
    const auto top = device::maxGoalSpeed(servo);
    if (reg != nullptr && top) {
        const QString maxText = physicalText(*top, *reg, servo.meaning(*reg));
        words
            << (isAboveMaxSpeed(servo, speed)
                    ? translate("ControlWords", "no faster than %1 (%2): the model's maximum")
                          .arg(*top)
                          .arg(maxText)
                    : translate("ControlWords", "model's maximum %1 (%2)").arg(*top).arg(maxText));
    }
    return words.join(QStringLiteral(" · "));
}

QString modeTitle(const catalog::Mode& mode)
{
    QString name = mode.name.in(text::isUiChinese());
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

QString modeHelp(const QString& key)
{
    static const std::pair<const char*, const char*> words[] = {
        {"position", QT_TRANSLATE_NOOP("ControlWords", "Goes to an angle inside its limits")},
        {"multiturn",
         QT_TRANSLATE_NOOP("ControlWords", "Goes to an angle up to 7.5 turns either way; turns are "
                                           "counted from power-on")},
        {"speed", QT_TRANSLATE_NOOP("ControlWords", "Turns on and on at a speed that is held "
                                                    "under load")},
        {"pwm", QT_TRANSLATE_NOOP("ControlWords", "Turns on and on; the speed falls under load")},
        {"step", QT_TRANSLATE_NOOP("ControlWords",
                                   "Each goal is a step from where it is, 7.5 turns in all")},
        {"motor", QT_TRANSLATE_NOOP("ControlWords", "Turns on and on like a motor")},
        {"current", QT_TRANSLATE_NOOP("ControlWords", "Pushes with a current, that is a torque")},
        {"position-pd",
         QT_TRANSLATE_NOOP("ControlWords", "Position without integral part, of newer firmware; one "
                                           "turn only")},
        {"release", QT_TRANSLATE_NOOP("ControlWords", "Goes to an angle and lets go there")},
    };
    for (const auto& [mode, word] : words) {
        if (key == QLatin1StringView(mode))
            return translate("ControlWords", word);
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
        lines << translate("ControlWords", "The angle limits %1 are remembered for the way back.")
                     .arg(limits.arg(*plan.writes[0].oldRaw).arg(*plan.writes[1].oldRaw));
    }
    const QString now = limits.arg(plan.writes[0].newRaw).arg(plan.writes[1].newRaw);
    if (plan.limitsRestored)
        lines << translate("ControlWords", "The angle limits %1 from before come back.").arg(now);
    if (plan.limitsSetToDefault) {
        lines << translate("ControlWords", "No angle limits are remembered for this servo: it gets "
                                           "those of the factory, %1.")
                     .arg(now);
    }
}
} // namespace

QString modePlanText(const device::ModePlan& plan, const catalog::Profile& profile, int others)
{
    QStringList lines;
    lines << (plan.torqueGoesOff
                  ? translate("ControlWords", "Torque goes off first and stays off until you "
                                              "switch it on.")
                  : translate("ControlWords", "Torque is off and stays off."));
    for (const device::ModePlan::Write& write : plan.writes) {
        const catalog::Register* reg = profile.find(write.key);
        lines << QStringLiteral("• %1 (%2): %3 → %4")
                     .arg(nameOf(profile, write.key))
                     .arg(reg != nullptr ? reg->address : 0)
                     .arg(valueOf(profile, write.key, write.oldRaw),
                          valueOf(profile, write.key, write.newRaw));
    }
    addLimits(lines, plan);
    if (!plan.zeroed.isEmpty()) {
        lines << translate("ControlWords", "\"%1\" becomes 0, so that nothing starts by itself.")
                     .arg(nameOf(profile, plan.zeroed));
    }
    lines << translate("ControlWords", "Everything is read back; the mode stays after power-off.");
    if (others > 0) {
        lines << translate("ControlWords", "The other chosen servos are switched the same way: %1")
                     .arg(others);
    }
    return lines.join(QLatin1Char('\n'));
}
} // namespace ui
