// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/motion_check.h"

#include "device/alarms.h"
#include "device/motion/motion.h"
#include "device/motion/move_limits.h"
#include "device/reader.h"
#include "device/write_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace jobs {
using catalog::Role;

namespace {
/// Enough for three steps of the slowest move (LX: 1000 steps in 30 s).
constexpr base::Duration sampleInterval = std::chrono::milliseconds(100);
constexpr std::int64_t torqueIsOn = 1;

bool hasMovingFlag(const device::Servo& servo)
{
    return servo.profile->byRole(Role::Moving) != nullptr;
}

/// Without a flag two positions decide. The last step of the encoder flickers.
base::Result<Motion> comparePositions(const device::Context& context, device::Servo& servo)
{
    const auto before = servo.raw(Role::PresentPosition);
    context.bus.clock().sleepFor(sampleInterval);
    if (const auto read = device::readRoles(context, servo, {Role::PresentPosition}); !read)
        return tl::unexpected(read.error());
    const auto after = servo.raw(Role::PresentPosition);
    const bool moved = before && after && std::abs(*after - *before) > 1;
    return moved ? Motion::ToGoal : Motion::Rest;
}

/// Read together with the position, or later.
bool isLoadCurrent(const device::Servo& servo)
{
    constexpr base::Duration maxSkew = std::chrono::seconds(1);
    const auto readAt = [&](Role role) {
        const catalog::Register* reg = servo.profile->byRole(role);
        return reg != nullptr ? servo.image.readAt(reg->offset) : std::nullopt;
    };
    const auto load = readAt(Role::PresentLoad);
    const auto position = readAt(Role::PresentPosition);
    return load && position && *load >= *position - maxSkew;
}

/// P alone, at half its default value, gives a quarter of the full load 1/64 turn away from the
/// goal. Where torque or current is limited, the limit is the most a servo can give.
bool isPushing(const device::Servo& servo)
{
    constexpr double pushingLoad = 20; // %
    constexpr double limitFraction = 0.5;
    const auto magnitude = [&](Role role) { return std::abs(servo.physical(role).value_or(0)); };
    const double load = magnitude(Role::PresentLoad);
    const double torqueLimit =
        servo.physical(Role::TorqueLimit).value_or(servo.physical(Role::MaxTorque).value_or(100));
    if (load > 0 && load >= std::min(pushingLoad, torqueLimit * limitFraction))
        return true;
    const double currentLimit = magnitude(Role::GoalCurrent);
    return currentLimit > 0 && magnitude(Role::PresentCurrent) >= currentLimit * limitFraction;
}
} // namespace

bool isTurning(const device::Servo& servo)
{
    constexpr std::int64_t movingBit = 1; // HLS: bit 1 only means that the goal was not reached
    if (hasMovingFlag(servo))
        return (servo.raw(Role::Moving).value_or(0) & movingBit) != 0;
    return servo.raw(Role::PresentSpeed).value_or(0) != 0;
}

Motion lastKnownMotion(const device::Servo& servo)
{
    if (!servo.profile || servo.raw(Role::TorqueSwitch) != torqueIsOn)
        return Motion::Rest;
    const catalog::Mode* mode = servo.mode();
    if (mode == nullptr)
        return Motion::Rest;
    if (mode->command != Role::GoalPosition)
        return servo.raw(mode->command).value_or(0) != 0 || isTurning(servo) ? Motion::Endless
                                                                             : Motion::Rest;
    return servo.raw(Role::Moving).value_or(0) != 0 ? Motion::ToGoal : Motion::Rest;
}

bool isInPositionMode(const device::Servo& servo)
{
    const auto kind = device::goalKind(servo);
    return kind == device::GoalKind::Position || kind == device::GoalKind::Turns;
}

base::Error notInPositionMode(const QString& operation, const device::Servo& servo)
{
    const catalog::Mode* mode = servo.mode();
    base::Error error{base::ErrorCode::NotSupported, operation, QStringLiteral("not-position"),
                      servo.id, mode != nullptr ? mode->key : QString()};
    error.reason = base::Reason::NotInPositionMode;
    return error;
}

bool isJammed(const device::Servo& servo, bool ownGoal)
{
    if (!servo.profile || servo.raw(Role::TorqueSwitch) != torqueIsOn)
        return false;
    if (device::hasFault(servo, {QStringLiteral("overload"), QStringLiteral("current")}))
        return true;
    const catalog::Mode* mode = servo.mode();
    const auto goal = servo.raw(Role::GoalPosition);
    if (mode == nullptr || mode->command != Role::GoalPosition || !goal ||
        !device::goalDeviation(servo, *goal, device::isRelative(*mode)))
        return false;
    return isLoadCurrent(servo) ? isPushing(servo) : ownGoal;
}

base::Result<Motion> readMotion(const device::Context& context, device::Servo& servo)
{
    if (!servo.profile)
        return Motion::Rest;
    if (const auto read = device::readSettings(context, servo); !read)
        return tl::unexpected(read.error());
    const catalog::Mode* mode = servo.mode();
    const Role command = mode != nullptr ? mode->command : Role::GoalPosition;
    const auto read = device::readRoles(
        context, servo, {command, Role::PresentPosition, Role::PresentSpeed, Role::Moving});
    if (!read)
        return tl::unexpected(read.error());
    const bool toGoal = mode != nullptr && command == Role::GoalPosition &&
                        servo.raw(Role::TorqueSwitch) == torqueIsOn;
    if (toGoal && !hasMovingFlag(servo))
        return comparePositions(context, servo);
    return lastKnownMotion(servo);
}
} // namespace jobs
