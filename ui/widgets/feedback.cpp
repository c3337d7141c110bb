// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/feedback.h"

#include "catalog/units.h"
#include "device/write_check.h"
#include "session/polling/max_reading_age.h"
#include "text/translate.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ui {
using catalog::Role;
using text::translate;

namespace {
struct QuantityInfo {
    Quantity measure;
    Role role;
    const char* title; ///< context "Feedback"
    int decimals;
    double defaultMax; ///< end of the scale where the servo has no limit
};
constexpr std::array quantityTable{
    QuantityInfo{Quantity::Voltage, Role::PresentVoltage, QT_TRANSLATE_NOOP("Feedback", "Voltage"),
                 1, 12},
    QuantityInfo{Quantity::Temperature, Role::PresentTemperature,
                 QT_TRANSLATE_NOOP("Feedback", "Temperature"), 0, 100},
    QuantityInfo{Quantity::Load, Role::PresentLoad, QT_TRANSLATE_NOOP("Feedback", "Load"), 1, 100},
    QuantityInfo{Quantity::Current, Role::PresentCurrent, QT_TRANSLATE_NOOP("Feedback", "Current"),
                 0, 1000},
    QuantityInfo{Quantity::Speed, Role::PresentSpeed, QT_TRANSLATE_NOOP("Feedback", "Speed"), 1,
                 60},
};

const QuantityInfo& infoOf(Quantity measure)
{
    return quantityTable[static_cast<std::size_t>(measure)];
}

std::optional<double> limit(const device::Servo& servo, Role role)
{
    const auto value = servo.physical(role);
    return value && *value > 0 ? value : std::nullopt;
}

QString number(double value, int decimals)
{
    return QLocale().toString(value, 'f', decimals);
}

/// The value the table may show, in its unit.
std::optional<double> shown(const session::ServoEntry& entry, const catalog::Register& reg)
{
    const auto raw = entry.displayedRaw(reg);
    return raw ? std::optional(catalog::toPhysical(*raw, entry.servo.meaning(reg))) : std::nullopt;
}

void setVoltage(const device::Servo& servo, GaugeState& view)
{
    constexpr double below = 0.6;
    constexpr double above = 1.2;
    const auto low = limit(servo, Role::MinVoltage);
    const auto high = limit(servo, Role::MaxVoltage);
    view.scale.low = low;
    view.scale.high = high;
    view.scale.min = low ? *low * below : 0;
    view.scale.max = high ? *high * above : infoOf(Quantity::Voltage).defaultMax;
    if (low && high)
        view.caption = number(*low, 1) + QStringLiteral(" … ") + number(*high, 1);
}

void setTemperature(const device::Servo& servo, GaugeState& view)
{
    constexpr double above = 1.3;
    const auto high = limit(servo, Role::MaxTemperature);
    view.scale.high = high;
    view.scale.max = high ? *high * above : infoOf(Quantity::Temperature).defaultMax;
    if (high)
        view.caption = QStringLiteral("≤ ") + number(*high, 0);
}

/// Above the overload threshold an alarm is near; the torque limit is the maximum of the servo.
void setLoad(const device::Servo& servo, GaugeState& view)
{
    const auto overload = limit(servo, Role::OverloadTorque);
    auto maxValue = servo.physical(Role::TorqueLimit);
    if (!maxValue)
        maxValue = servo.physical(Role::MaxTorque);
    view.scale.max = infoOf(Quantity::Load).defaultMax;
    view.scale.min = -view.scale.max;
    view.scale.high = overload;
    QStringList words;
    if (overload)
        words << QStringLiteral("≤ ") + number(*overload, 0);
    if (maxValue && *maxValue < view.scale.max)
        words << translate("Feedback", "limit %1", "torque limit in %").arg(number(*maxValue, 0));
    view.caption = words.join(QStringLiteral(" · "));
}

void setCurrent(const device::Servo& servo, GaugeState& view)
{
    constexpr double above = 1.2;
    const auto high = limit(servo, Role::ProtectionCurrent);
    view.scale.high = high;
    view.scale.max = high ? *high * above : infoOf(Quantity::Current).defaultMax;
    view.scale.min = -view.scale.max;
    if (high)
        view.caption = QStringLiteral("≤ ") + number(*high, 0);
}

/// The scale grows with the values in whole steps, so that it does not follow each value.
void setSpeed(const session::ServoEntry& entry, GaugeState& view)
{
    constexpr double roundTo = 30;
    double top = infoOf(Quantity::Speed).defaultMax;
    const catalog::Register* fastest = entry.servo.profile->find(QStringLiteral("max_speed_limit"));
    if (const auto maxValue = fastest != nullptr ? shown(entry, *fastest) : std::nullopt)
        top = std::max(top, *maxValue);
    if (view.value)
        top = std::max(top, std::ceil(std::abs(*view.value) / roundTo) * roundTo);
    view.scale.max = top;
    view.scale.min = -top;
    view.caption = view.value && *view.value != 0
                       ? (*view.value > 0 ? QStringLiteral("↻") : QStringLiteral("↺"))
                       : QString();
}

QString plainUnit(const QString& unit)
{
    return catalog::unitSuffix(unit).trimmed();
}

void addKeys(const device::Servo& servo, std::initializer_list<Role> roles, QStringList& keys)
{
    for (const Role role : roles) {
        const catalog::Register* reg = servo.profile->byRole(role);
        if (reg != nullptr && servo.measures(*reg))
            keys << reg->key;
    }
}
} // namespace

bool isFresh(const session::ServoEntry& entry, const session::LinkController& link,
             base::Duration now)
{
    return !entry.silent && !entry.linkMonitor.isLost() &&
           link.state() == session::LinkState::Open &&
           now - entry.lastSeen <= session::maxReadingAge;
}

GaugeState gaugeState(const session::ServoEntry& entry, Quantity measure)
{
    const QuantityInfo& what = infoOf(measure);
    GaugeState view;
    view.title = translate("Feedback", what.title);
    if (!entry.servo.profile)
        return view;
    const device::Servo& servo = entry.servo;
    const catalog::Register* reg = servo.profile->byRole(what.role);
    if (reg == nullptr || !servo.measures(*reg)) {
        view.isMeasured = false;
        return view;
    }
    view.value = shown(entry, *reg);
    view.scale.decimals = what.decimals;
    view.scale.unit = plainUnit(servo.meaning(*reg).unit);
    switch (measure) {
    case Quantity::Voltage:
        setVoltage(servo, view);
        break;
    case Quantity::Temperature:
        setTemperature(servo, view);
        break;
    case Quantity::Load:
        setLoad(servo, view);
        break;
    case Quantity::Current:
        setCurrent(servo, view);
        break;
    case Quantity::Speed:
        setSpeed(entry, view);
        break;
    }
    return view;
}

QStringList feedbackKeys(const device::Servo& servo)
{
    QStringList keys;
    if (!servo.profile)
        return keys;
    addKeys(servo,
            {Role::PresentPosition, Role::PresentSpeed, Role::PresentLoad, Role::PresentVoltage,
             Role::PresentTemperature, Role::Status, Role::Moving, Role::PresentCurrent},
            keys);
    const bool reportsGoal = servo.profile->byRole(Role::ActiveGoal) != nullptr;
    addKeys(servo, {reportsGoal ? Role::ActiveGoal : Role::GoalPosition}, keys);
    return keys;
}

QStringList settingKeys(const device::Servo& servo)
{
    QStringList keys;
    if (!servo.profile)
        return keys;
    addKeys(servo,
            {Role::TorqueSwitch, Role::OperatingMode, Role::MinAngle, Role::MaxAngle,
             Role::GoalPosition, Role::GoalSpeed, Role::Acceleration, Role::GoalPwm, Role::GoalTime,
             Role::GoalCurrent, Role::TorqueLimit, Role::Lock, Role::AsyncFlag},
            keys);
    keys.removeDuplicates();
    return keys;
}

namespace {
void addGoal(DialState& view, const session::ServoEntry& entry, const catalog::Mode& mode)
{
    const catalog::Profile& profile = *entry.servo.profile;
    const catalog::Register* goal = profile.byRole(
        profile.byRole(Role::ActiveGoal) != nullptr ? Role::ActiveGoal : Role::GoalPosition);
    const auto raw = goal != nullptr ? entry.displayedRaw(*goal) : std::nullopt;
    if (!raw)
        return;
    view.goal = double(*raw);
    if (!isTorqueOff(entry))
        view.subtitle += QStringLiteral(" → ") + QLocale::c().toString(qlonglong(*raw));
    if (const auto range = device::goalRange(entry.servo); range && !mode.limitsZero) {
        view.minGoal = range->min;
        view.maxGoal = range->max;
    }
}
} // namespace

bool isTorqueOff(const session::ServoEntry& entry)
{
    const catalog::Profile* profile = entry.servo.profile.get();
    const catalog::Register* torque =
        profile != nullptr ? profile->byRole(Role::TorqueSwitch) : nullptr;
    return torque != nullptr && entry.displayedRaw(*torque) == 0;
}

DialState dialState(const session::ServoEntry& entry, bool fresh)
{
    DialState view;
    const device::Servo& servo = entry.servo;
    if (!servo.profile)
        return view;
    const catalog::Profile& profile = *servo.profile;
    const auto factor =
        double(std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1)));
    view.stepsPerTurn = profile.stepsPerTurn / factor; // of a goal
    view.rangeDegrees = profile.angleRangeDeg.value_or(360);
    view.isStale = !fresh;
    const catalog::Mode* mode = servo.mode();
    const bool drivesPosition = mode != nullptr && mode->command == Role::GoalPosition;
    const bool steps = mode != nullptr && mode->key == QLatin1StringView("step");
    const catalog::Register* present = profile.byRole(Role::PresentPosition);
    const auto raw = present != nullptr ? entry.displayedRaw(*present) : std::nullopt;
    if (raw) {
        // Feedback comes in single steps, goals in steps of the resolution factor.
        view.position = double(*raw) / factor;
        const catalog::ValueFormat meaning = servo.meaning(*present);
        view.value = withUnit(catalog::toPhysical(*raw, meaning), meaning.unit, 1);
        view.subtitle = QLocale::c().toString(qlonglong(*raw));
    } else {
        view.value = QStringLiteral("—");
        view.subtitle = translate("Feedback", "not read");
    }
    if (steps) { // register 56 is what is left of the step, not a position on the dial
        view.position.reset();
        view.turnsText = translate("Feedback", "remaining distance");
    }
    if (drivesPosition && !steps)
        addGoal(view, entry, *mode);
    return view;
}

QString faultText(const QString& key)
{
    struct Word {
        const char* key;
        const char* word;
    };
    static constexpr std::array words{
        Word{"voltage", QT_TRANSLATE_NOOP("Feedback", "Voltage out of range")},
        Word{"sensor", QT_TRANSLATE_NOOP("Feedback", "Sensor fault")},
        Word{"temperature", QT_TRANSLATE_NOOP("Feedback", "Over-temperature")},
        Word{"current", QT_TRANSLATE_NOOP("Feedback", "Overcurrent")},
        Word{"angle", QT_TRANSLATE_NOOP("Feedback", "Angle fault")},
        Word{"overload", QT_TRANSLATE_NOOP("Feedback", "Overload")},
    };
    for (const Word& word : words) {
        if (key == QLatin1StringView(word.key))
            return translate("Feedback", word.word);
    }
    return key;
}

QString withUnit(double value, const QString& unit, int decimals)
{
    return number(value, decimals) + catalog::unitSuffix(unit);
}
} // namespace ui
