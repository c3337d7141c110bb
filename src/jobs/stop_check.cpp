// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/stop_check.h"

#include "device/reader.h"
#include "device/talk.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using Torque = StopVerdict::Torque;

namespace {
/// How often one that is still on is told.
constexpr int tries = 4;

/// Concerns the whole bus, or the user: nobody else need be asked.
bool endsAll(const base::Error& error)
{
    return error.code == ErrorCode::LinkLost || error.code == ErrorCode::Stopped ||
           error.code == ErrorCode::Preempted;
}

/// Where the torque switch is. Who could not be identified has it where all Feetech tables do.
bus::PollSpan torqueSwitch(const device::Servo& servo)
{
    constexpr bus::PollSpan everyFeetech{40, 1};
    const catalog::Register* reg =
        servo.profile ? servo.profile->byRole(Role::TorqueSwitch) : nullptr;
    if (reg != nullptr)
        return {reg->offset, reg->size};
    return servo.protocol == base::Protocol::Feetech ? everyFeetech : bus::PollSpan{};
}

base::Result<Torque> switchOff(const device::Context& context, device::Servo& servo)
{
    const bus::PollSpan place = torqueSwitch(servo);
    if (place.count == 0)
        return Torque::Unknown;
    const catalog::Register* reg =
        servo.profile ? servo.profile->byRole(Role::TorqueSwitch) : nullptr;
    const base::Bytes off(static_cast<std::size_t>(place.count), 0);
    const device::Patch patch{reg != nullptr ? reg->writeOffset : place.address, place.address,
                              off};
    for (int attempt = 1;; ++attempt) {
        if (const auto read = readBlock(context, servo, place.address, place.count); !read)
            return tl::unexpected(read.error());
        if (servo.image.bytes(place.address, place.count) == off)
            return Torque::Off;
        if (attempt == tries)
            return Torque::On;
        const auto told = writeBlock(context, servo, patch, protocol::Repeat::Safe);
        if (!told && !device::answerLost(told.error()))
            return tl::unexpected(told.error());
    }
}

base::Result<void> say(const device::Context& context, protocol::Request request)
{
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.priority = context.priority;
    transaction.hold = context.hold;
    transaction.epoch = context.epoch;
    return context.bus.transact(transaction).map([](const bus::Outcome&) {});
}

/// A held write of "torque off", which it is, takes the place of a held goal. Only where the servo
/// has acknowledged it may it be carried out, which leaves nothing that waits: an ACTION that met
/// the goal would turn the shaft.
base::Result<bool> mayHold(const device::Context& context, device::Servo& servo,
                           const catalog::Register& flag)
{
    const catalog::Register& torque = *servo.profile->byRole(Role::TorqueSwitch);
    for (int attempt = 0; attempt < tries; ++attempt) {
        const auto held = device::readRegister(context, servo, flag);
        if (!held)
            return tl::unexpected(held.error());
        if (*held == 0)
            return false;
        auto request = protocol::Request::regWrite(servo.id, torque.writeOffset,
                                                   device::wireBytes(servo, torque, 0),
                                                   protocol::Repeat::Safe);
        request.acknowledged = servo.answersWrites();
        const auto replaced = say(context, std::move(request));
        if (!replaced && !device::answerLost(replaced.error()))
            return tl::unexpected(replaced.error());
        if (!replaced || !servo.answersWrites())
            continue;
        const auto acted = say(context, protocol::Request::action(servo.id));
        if (!acted && !device::answerLost(acted.error()))
            return tl::unexpected(acted.error());
    }
    // Told often enough that the harmless one waits now, but nothing has proved it.
    return true;
}

/// A start command shall find the place where the servo is. Some models never tell what they store.
base::Result<bool> mayStore(const device::Context& context, device::Servo& servo,
                            const catalog::Register& goal)
{
    if (const auto here = readRoles(context, servo, {Role::PresentPosition}); !here)
        return tl::unexpected(here.error());
    const auto range = servo.meaning(goal);
    std::int64_t place = servo.raw(Role::PresentPosition).value_or(0);
    place = std::clamp(place, range.min.value_or(place), range.max.value_or(place));
    device::RegisterValues values{{&goal, place}};
    if (const catalog::Register* time = servo.profile->byRole(Role::StoredTime))
        values.push_back({time, 0});
    const device::Patch patch = device::patchOf(servo, values);
    for (int attempt = 0; attempt < tries; ++attempt) {
        const auto sent = writeBlock(context, servo, patch, protocol::Repeat::Safe);
        if (!sent)
            return tl::unexpected(sent.error());
        const auto back = readBlock(context, servo, patch.readOffset, patch.count(), 0);
        if (!back && endsAll(back.error()))
            return tl::unexpected(back.error());
        if (back && servo.image.bytes(patch.readOffset, patch.count()) == patch.data)
            return false;
    }
    return servo.image.bytes(patch.readOffset, patch.count()).has_value();
}
} // namespace

base::Result<bool> disarm(const device::Context& outer, device::Servo& servo)
{
    const device::Owned owned = device::own(outer, {servo.id});
    const device::Context& context = owned.context;
    if (!servo.profile || !servo.profile->writable)
        return false;
    if (const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag))
        return mayHold(context, servo, *flag);
    if (const catalog::Register* goal = servo.profile->byRole(Role::StoredGoal))
        return mayStore(context, servo, *goal);
    return false;
}

base::Result<std::vector<StopVerdict>> checkStopped(const device::Context& outer,
                                                    const std::vector<device::Servo*>& servos)
{
    std::vector<StopVerdict> verdicts(servos.size());
    // Torque of all of them first: what waits in one of them does nothing by itself.
    for (std::size_t i = 0; i < servos.size(); ++i) {
        const device::Owned owned = device::own(outer, {servos[i]->id});
        const auto torque = switchOff(owned.context, *servos[i]);
        if (!torque && endsAll(torque.error()))
            return tl::unexpected(torque.error());
        verdicts[i].torque = torque.value_or(Torque::Unknown);
    }
    for (std::size_t i = 0; i < servos.size(); ++i) {
        if (verdicts[i].torque == Torque::Unknown)
            continue;
        const auto held = disarm(outer, *servos[i]);
        if (!held && endsAll(held.error()))
            return tl::unexpected(held.error());
        verdicts[i].mayHold = held.value_or(true);
    }
    return verdicts;
}
} // namespace jobs
