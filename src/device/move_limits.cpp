// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/move_limits.h"

#include "device/mode.h"
#include "device/persistence.h"

#include <algorithm>
#include <cmath>

namespace device {
using catalog::Role;

namespace {
/// ±7.5 turns of 4096 steps: protocol sheet §3.3.
constexpr std::int64_t mostSteps = 30719;
/// About 50 rpm, for a slider of a model whose maximum is not known.
constexpr double usualRpm = 50;

const catalog::Register* own(const Servo& servo, Role role)
{
    return servo.profile ? servo.profile->byRole(role) : nullptr;
}

const catalog::Mode* modeOf(const Servo& servo)
{
    return servo.profile ? servo.mode() : nullptr;
}

/// What the register can hold at all, for a slider.
GoalRange rangeOf(const catalog::Meaning& meaning, std::int64_t otherwise)
{
    return {meaning.min.value_or(-otherwise), meaning.max.value_or(otherwise)};
}

GoalRange speedSpan(const Servo& servo, const catalog::Register& reg)
{
    const catalog::Meaning meaning = servo.meaning(reg);
    const GoalRange range = rangeOf(meaning, mostSteps);
    std::int64_t top = topSpeed(servo).value_or(0);
    if (top == 0 && meaning.unit == QLatin1StringView("rpm"))
        top = catalog::toRaw(usualRpm, meaning);
    if (top == 0)
        top = 1000; // no unit is documented: the order of a turn in a few seconds, and of LX' scale
    return {std::max(range.min, -top), std::min(range.max, top)};
}

GoalRange currentSpan(const Servo& servo, const catalog::Register& reg)
{
    const GoalRange range = rangeOf(servo.meaning(reg), 2047);
    const std::int64_t most = servo.raw(Role::ProtectionCurrent).value_or(range.max);
    return {std::max(range.min, -most), std::min(range.max, most)};
}
} // namespace

const catalog::Register* goalRegister(const Servo& servo)
{
    const catalog::Mode* mode = modeOf(servo);
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
    // Some families drive several modes by one register: its unit there tells.
    if (servo.meaning(*reg).unit == QLatin1StringView("%"))
        return GoalKind::Pwm;
    return mode.command == Role::GoalCurrent ? GoalKind::Current : GoalKind::Speed;
}

MoveFieldSet moveFields(const Servo& servo)
{
    MoveFieldSet fields;
    const catalog::Mode* mode = modeOf(servo);
    if (mode == nullptr)
        return fields;
    const catalog::Profile& profile = *servo.profile;
    const bool position = mode->command == Role::GoalPosition;
    const auto kind = goalKind(servo);
    fields.speed = position && own(servo, Role::GoalSpeed) != nullptr &&
                   !travelsWithMode(profile, Role::GoalSpeed);
    fields.time = position && own(servo, Role::GoalTime) != nullptr;
    fields.acceleration =
        own(servo, Role::Acceleration) != nullptr && (position || kind == GoalKind::Speed);
    fields.current = own(servo, Role::GoalCurrent) != nullptr && mode->command != Role::GoalCurrent;
    return fields;
}

std::optional<GoalRange> goalSpan(const Servo& servo)
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
        return GoalRange{-mostSteps, mostSteps};
    case GoalKind::Speed:
        return speedSpan(servo, reg);
    case GoalKind::Current:
        return currentSpan(servo, reg);
    case GoalKind::Pwm:
        break;
    }
    return rangeOf(servo.meaning(reg), 1000);
}

std::optional<GoalRange> goalScale(const Servo& servo)
{
    const auto span = goalSpan(servo);
    if (!span || goalKind(servo) != GoalKind::Position)
        return span;
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    const std::int64_t turn = (servo.profile->stepsPerTurn - 1) / factor;
    // LX has a scale of its own: 0 to 1000.
    const auto most = servo.meaning(*goalRegister(servo)).max.value_or(turn);
    const bool wider = servo.profile->stepsPerTurn >= 4096;
    return GoalRange{std::min<std::int64_t>(0, span->min),
                     std::max(wider ? turn : most, span->max)};
}

std::int64_t stepsLeft(std::int64_t sum, bool positive)
{
    return std::max<std::int64_t>(0, positive ? mostSteps - sum : mostSteps + sum);
}

std::optional<std::int64_t> topSpeed(const Servo& servo)
{
    const catalog::Register* limit =
        servo.profile ? servo.profile->find(QStringLiteral("max_speed_limit")) : nullptr;
    const catalog::Register* speed = own(servo, Role::GoalSpeed);
    const auto raw = limit != nullptr ? servo.raw(*limit) : std::nullopt;
    if (speed == nullptr || !raw || *raw <= 0)
        return std::nullopt;
    const catalog::Meaning from = servo.meaning(*limit);
    catalog::Meaning into = servo.meaning(*speed);
    if (from.unit.isEmpty() || from.unit != into.unit)
        return std::nullopt;
    // A speed between two raw ones would be none of the servo's own.
    const double exact = catalog::toPhysical(*raw, from) / into.scale;
    return static_cast<std::int64_t>(std::floor(exact + 1e-9));
}

ZeroSpeed zeroSpeed(const Servo& servo)
{
    // The current-controlled family has no such bit: 0 always stops.
    if (own(servo, Role::GoalCurrent) != nullptr)
        return ZeroSpeed::Stops;
    if (own(servo, Role::GoalTime) != nullptr && servo.raw(Role::GoalTime).value_or(0) != 0)
        return ZeroSpeed::ByTime;
    const catalog::Register* phase = own(servo, Role::Phase);
    const auto bits = servo.raw(Role::Phase);
    if (phase == nullptr || !bits)
        return ZeroSpeed::NotKnown;
    for (const catalog::NamedValue& bit : phase->values) {
        if (bit.key == QLatin1StringView("zero_is_maximum"))
            return (*bits >> bit.value & 1) != 0 ? ZeroSpeed::Fastest : ZeroSpeed::Stops;
    }
    return ZeroSpeed::NotKnown;
}

Positive positiveGoal(const Servo& servo)
{
    const auto kind = goalKind(servo);
    if (!kind || servo.protocol == base::Protocol::Lx)
        return Positive::Forward;
    switch (*kind) {
    case GoalKind::Position:
    case GoalKind::Turns:
    case GoalKind::Step:
    case GoalKind::Speed:
        return Positive::Clockwise;
    case GoalKind::Pwm:
        // Told for STS, SMS and SCS only.
        return servo.protocol == base::Protocol::Feetech && own(servo, Role::GoalCurrent) == nullptr
                   ? Positive::CounterClockwise
                   : Positive::Forward;
    case GoalKind::Current:
        break;
    }
    return Positive::Forward;
}

TorqueLimit torqueLimit(const catalog::Profile& profile)
{
    if (const catalog::Register* now = profile.byRole(Role::TorqueLimit))
        return {now, false};
    const catalog::Register* start = profile.byRole(Role::MaxTorque);
    const bool possible = start != nullptr && start->writable() &&
                          keepingOf(*start) == Keeping::Lock && !start->dangerous;
    return possible ? TorqueLimit{start, true} : TorqueLimit{};
}

bool offers(const Servo& servo, MoveHow how)
{
    const auto kind = goalKind(servo);
    if (how == MoveHow::Write || !kind)
        return how == MoveHow::Write;
    const bool stores = (kind == GoalKind::Position || kind == GoalKind::Turns) &&
                        own(servo, Role::StoredGoal) != nullptr;
    const auto request = how == MoveHow::Sync ? protocol::Request::syncWrite(0, {{servo.id, {0}}})
                                              : protocol::Request::regWrite(servo.id, 0, {0},
                                                                            protocol::Repeat::Safe);
    return stores || canSay(servo, request);
}

QString exactText(std::int64_t raw, const catalog::Meaning& meaning)
{
    if (meaning.unit.isEmpty())
        return QString::number(raw);
    constexpr int digits = 12;
    return QString::number(catalog::toPhysical(raw, meaning), 'f', digits) + meaning.unit;
}
} // namespace device
