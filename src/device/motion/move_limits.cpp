// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/move_limits.h"

#include "device/motion/mode.h"
#include "device/persistence.h"
#include "device/write_meaning.h"

#include <algorithm>
#include <cmath>

namespace device {
using catalog::Role;

namespace {
/// ±7.5 turns of 4096 steps: protocol sheet §3.3.
constexpr std::int64_t maxSteps = 30719;
/// About 50 rpm, for a slider of a model whose maximum is not known.
constexpr double defaultMaxRpm = 50;

const catalog::Register* registerFor(const Servo& servo, Role role)
{
    return servo.profile ? servo.profile->byRole(role) : nullptr;
}

const catalog::Mode* modeFor(const Servo& servo)
{
    return servo.profile ? servo.mode() : nullptr;
}

/// The range of the register, for a slider.
GoalRange rangeOf(const catalog::ValueFormat& meaning, std::int64_t otherwise)
{
    return {meaning.min.value_or(-otherwise), meaning.max.value_or(otherwise)};
}

GoalRange speedRange(const Servo& servo, const catalog::Register& reg)
{
    const catalog::ValueFormat meaning = servo.meaning(reg);
    const GoalRange range = rangeOf(meaning, maxSteps);
    std::int64_t maxSpeed = maxGoalSpeed(servo).value_or(0);
    if (maxSpeed == 0 && meaning.unit == QLatin1StringView("rpm"))
        maxSpeed = catalog::toRaw(defaultMaxRpm, meaning);
    if (maxSpeed == 0)
        maxSpeed =
            1000; // no unit is documented: the order of a turn in a few seconds, and of LX' scale
    return {std::max(range.min, -maxSpeed), std::min(range.max, maxSpeed)};
}

GoalRange currentRange(const Servo& servo, const catalog::Register& reg)
{
    const GoalRange range = rangeOf(servo.meaning(reg), 2047);
    const std::int64_t max = servo.raw(Role::ProtectionCurrent).value_or(range.max);
    return {std::max(range.min, -max), std::min(range.max, max)};
}
} // namespace

const catalog::Register* goalRegister(const Servo& servo)
{
    const catalog::Mode* mode = modeFor(servo);
    return mode != nullptr ? servo.profile->byRole(mode->command) : nullptr;
}

std::optional<GoalKind> goalKind(const Servo& servo)
{
    const catalog::Register* reg = goalRegister(servo);
    if (reg == nullptr)
        return std::nullopt;
    const catalog::Mode& mode = *servo.mode();
    if (mode.command == Role::GoalPosition) {
        if (isRelative(mode))
            return GoalKind::Step;
        return mode.limitsZero ? GoalKind::Turns : GoalKind::Position;
    }
    // Some families drive several modes by one register: its unit there decides.
    if (servo.meaning(*reg).unit == QLatin1StringView("%"))
        return GoalKind::Pwm;
    return mode.command == Role::GoalCurrent ? GoalKind::Current : GoalKind::Speed;
}

MoveFieldSet moveFields(const Servo& servo)
{
    MoveFieldSet fields;
    const catalog::Mode* mode = modeFor(servo);
    if (mode == nullptr)
        return fields;
    const catalog::Profile& profile = *servo.profile;
    const bool position = mode->command == Role::GoalPosition;
    const auto kind = goalKind(servo);
    fields.speed = position && registerFor(servo, Role::GoalSpeed) != nullptr &&
                   !sharesFrameWithMode(profile, Role::GoalSpeed);
    fields.time = position && registerFor(servo, Role::GoalTime) != nullptr;
    fields.acceleration =
        registerFor(servo, Role::Acceleration) != nullptr && (position || kind == GoalKind::Speed);
    fields.current =
        registerFor(servo, Role::GoalCurrent) != nullptr && mode->command != Role::GoalCurrent;
    return fields;
}

std::optional<GoalRange> goalSliderRange(const Servo& servo)
{
    const auto kind = goalKind(servo);
    if (!kind)
        return std::nullopt;
    const catalog::Register& reg = *goalRegister(servo);
    switch (*kind) {
    case GoalKind::Position:
        return goalRange(servo);
    case GoalKind::Turns:
    case GoalKind::Step:
        return GoalRange{-maxSteps, maxSteps};
    case GoalKind::Speed:
        return speedRange(servo, reg);
    case GoalKind::Current:
        return currentRange(servo, reg);
    case GoalKind::Pwm:
        break;
    }
    return rangeOf(servo.meaning(reg), 1000);
}

std::optional<GoalRange> goalScaleRange(const Servo& servo)
{
    const auto span = goalSliderRange(servo);
    if (!span || goalKind(servo) != GoalKind::Position)
        return span;
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    const std::int64_t turn = (servo.profile->stepsPerTurn - 1) / factor;
    // LX has a scale of its own: 0 to 1000.
    const auto max = servo.meaning(*goalRegister(servo)).max.value_or(turn);
    const bool wider = servo.profile->stepsPerTurn >= 4096;
    return GoalRange{std::min<std::int64_t>(0, span->min), std::max(wider ? turn : max, span->max)};
}

std::int64_t remainingSteps(std::int64_t sum, bool positive)
{
    return std::max<std::int64_t>(0, positive ? maxSteps - sum : maxSteps + sum);
}

std::optional<std::int64_t> maxGoalSpeed(const Servo& servo)
{
    const catalog::Register* limit =
        servo.profile ? servo.profile->find(QStringLiteral("max_speed_limit")) : nullptr;
    const catalog::Register* speed = registerFor(servo, Role::GoalSpeed);
    const auto raw = limit != nullptr ? servo.raw(*limit) : std::nullopt;
    if (speed == nullptr || !raw || *raw <= 0)
        return std::nullopt;
    const catalog::ValueFormat from = servo.meaning(*limit);
    catalog::ValueFormat into = servo.meaning(*speed);
    if (from.unit.isEmpty() || from.unit != into.unit)
        return std::nullopt;
    // A speed between two raw values does not exist in the servo.
    const double exact = catalog::toPhysical(*raw, from) / into.scale;
    return static_cast<std::int64_t>(std::floor(exact + 1e-9));
}

ZeroSpeed zeroSpeed(const Servo& servo)
{
    // The current-controlled family has no such bit: 0 always stops.
    if (registerFor(servo, Role::GoalCurrent) != nullptr)
        return ZeroSpeed::Stops;
    if (registerFor(servo, Role::GoalTime) != nullptr && servo.raw(Role::GoalTime).value_or(0) != 0)
        return ZeroSpeed::ByTime;
    const catalog::Register* phase = registerFor(servo, Role::Phase);
    const auto bits = servo.raw(Role::Phase);
    if (phase == nullptr || !bits)
        return ZeroSpeed::Unknown;
    for (const catalog::NamedValue& bit : phase->values) {
        if (bit.key == QLatin1StringView("zero_is_maximum"))
            return (*bits >> bit.value & 1) != 0 ? ZeroSpeed::Fastest : ZeroSpeed::Stops;
    }
    return ZeroSpeed::Unknown;
}

PositiveDirection positiveDirection(const Servo& servo)
{
    const auto kind = goalKind(servo);
    if (!kind || servo.protocol == base::Protocol::Lx)
        return PositiveDirection::Forward;
    switch (*kind) {
    case GoalKind::Position:
    case GoalKind::Turns:
    case GoalKind::Step:
    case GoalKind::Speed:
        return PositiveDirection::Clockwise;
    case GoalKind::Pwm:
        // Stated for STS, SMS and SCS only.
        return servo.protocol == base::Protocol::Feetech &&
                       registerFor(servo, Role::GoalCurrent) == nullptr
                   ? PositiveDirection::CounterClockwise
                   : PositiveDirection::Forward;
    case GoalKind::Current:
        break;
    }
    return PositiveDirection::Forward;
}

TorqueLimit torqueLimit(const catalog::Profile& profile)
{
    if (const catalog::Register* now = profile.byRole(Role::TorqueLimit))
        return {now, false};
    const catalog::Register* start = profile.byRole(Role::MaxTorque);
    const bool possible = start != nullptr && start->writable() &&
                          retentionOf(*start) == Retention::Lock && !alwaysNeedsConsent(*start);
    return possible ? TorqueLimit{start, true} : TorqueLimit{};
}

bool supports(const Servo& servo, MoveMethod how)
{
    const auto kind = goalKind(servo);
    if (how == MoveMethod::Write || !kind)
        return how == MoveMethod::Write;
    const bool stores = (kind == GoalKind::Position || kind == GoalKind::Turns) &&
                        registerFor(servo, Role::StoredGoal) != nullptr;
    const auto request =
        how == MoveMethod::Sync
            ? protocol::Request::syncWrite(0, {{servo.id, {0}}})
            : protocol::Request::regWrite(servo.id, 0, {0}, protocol::Repeat::Safe);
    return stores || canEncode(servo, request);
}

QString exactValueText(std::int64_t raw, const catalog::ValueFormat& meaning)
{
    if (meaning.unit.isEmpty())
        return QString::number(raw);
    constexpr int digits = 12;
    return QString::number(catalog::toPhysical(raw, meaning), 'f', digits) + meaning.unit;
}
} // namespace device
