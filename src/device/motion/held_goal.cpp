// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/held_goal.h"

#include "device/motion/move_groups.h"
#include "device/reader.h"
#include "device/transactions.h"

#include <algorithm>

namespace device {
using catalog::Role;

namespace {
/// How often the replacement is tried.
constexpr int maxHoldAttempts = 4;

/// A held write that changes nothing replaces a held goal. It is started only after the servo has
/// acknowledged it, and then nothing waits any more: an ACTION that met the goal would turn the
/// shaft.
base::Result<bool> replaceHeldGoal(const Context& context, Servo& servo,
                                   const catalog::Register& flag, const RegisterValue& harmless)
{
    for (int attempt = 0; attempt < maxHoldAttempts; ++attempt) {
        const auto held = readRegister(context, servo, flag);
        if (!held)
            return tl::unexpected(held.error());
        if (*held == 0)
            return false;
        auto request = protocol::Request::regWrite(servo.id, harmless.reg->writeOffset,
                                                   wireBytes(servo, *harmless.reg, harmless.raw),
                                                   protocol::Repeat::Safe);
        request.acknowledged = servo.repliesToWrites();
        const auto replaced = sendRequest(context, std::move(request));
        if (!replaced && !isReplyLost(replaced.error()))
            return tl::unexpected(replaced.error());
        if (!replaced || !servo.repliesToWrites())
            continue;
        const auto result = sendRequest(context, protocol::Request::action(servo.id));
        if (!result && !isReplyLost(result.error()))
            return tl::unexpected(result.error());
    }
    // The harmless write was sent often enough, but nothing has proved that it replaced the goal.
    return true;
}

/// A start command must find the present position. Some models never report what they store.
base::Result<bool> replaceStoredGoal(const Context& context, Servo& servo,
                                     const catalog::Register& goal)
{
    if (const auto positionRead = readRoles(context, servo, {Role::PresentPosition}); !positionRead)
        return tl::unexpected(positionRead.error());
    const auto range = servo.meaning(goal);
    std::int64_t place = servo.raw(Role::PresentPosition).value_or(0);
    place = std::clamp(place, range.min.value_or(place), range.max.value_or(place));
    RegisterValues values{{&goal, place}};
    if (const catalog::Register* time = servo.profile->byRole(Role::StoredTime))
        values.push_back({time, 0});
    const Patch patch = patchOf(servo, values);
    for (int attempt = 0; attempt < maxHoldAttempts; ++attempt) {
        const auto sent = writeBlock(context, servo, patch, protocol::Repeat::Safe);
        if (!sent)
            return tl::unexpected(sent.error());
        const auto readBack = readBlock(context, servo, patch.readOffset, patch.count(), 0);
        if (!readBack && !isReplyLost(readBack.error()))
            return tl::unexpected(readBack.error());
        if (readBack && servo.image.bytes(patch.readOffset, patch.count()) == patch.data)
            return false;
    }
    return servo.image.bytes(patch.readOffset, patch.count()).has_value();
}
} // namespace

base::Result<bool> cancelHeldGoal(const Context& outer, Servo& servo)
{
    const Owned owned = own(outer, {servo.id});
    const Context& context = owned.context;
    if (!servo.profile || !servo.profile->writable)
        return false;
    if (const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag))
        return replaceHeldGoal(context, servo, *flag,
                               {servo.profile->byRole(Role::TorqueSwitch), 0});
    if (const catalog::Register* goal = servo.profile->byRole(Role::StoredGoal))
        return replaceStoredGoal(context, servo, *goal);
    return false;
}

base::Result<bool> discardHeldGoal(const Context& outer, Servo& servo)
{
    const Owned owned = own(outer, {servo.id});
    const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag);
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    if (flag == nullptr || lock == nullptr)
        return true;
    return replaceHeldGoal(owned.context, servo, *flag, {lock, 1});
}
} // namespace device
