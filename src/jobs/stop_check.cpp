// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/stop_check.h"

#include "device/motion/held_goal.h"
#include "device/transactions.h"
#include "jobs/link_reconnect.h"

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using Torque = StopCheckResult::Torque;

namespace {
/// How often torque off is sent to a servo that is still on.
constexpr int tries = 4;

/// An error of the whole bus, or the user's stop: no other servo needs to be asked.
bool endsCheck(const base::Error& error)
{
    return error.code == ErrorCode::LinkLost || error.code == ErrorCode::Stopped ||
           error.code == ErrorCode::Preempted;
}

/// The register of the torque switch. A servo that was not identified has it at the address of all
/// Feetech tables.
bus::PollSpan torqueSwitch(const device::Servo& servo)
{
    constexpr bus::PollSpan everyFeetech{40, 1};
    const catalog::Register* reg =
        servo.profile ? servo.profile->byRole(Role::TorqueSwitch) : nullptr;
    if (reg != nullptr)
        return {reg->offset, reg->size};
    return servo.protocol == base::Protocol::Feetech ? everyFeetech : bus::PollSpan{};
}

base::Result<Torque> ensureTorqueOff(const device::Context& context, device::Servo& servo)
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
        const auto sent = writeBlock(context, servo, patch, protocol::Repeat::Safe);
        if (!sent && !device::isReplyLost(sent.error()))
            return tl::unexpected(sent.error());
    }
}

} // namespace

base::Result<std::vector<StopCheckResult>>
verifyEmergencyStop(const device::Context& outer, const std::vector<device::Servo*>& servos)
{
    device::Context stopping = outer;
    stopping.emergencyStop = true;
    waitForReconnection(outer.bus); // the stop itself is sent first when the link is back
    std::vector<StopCheckResult> verdicts(servos.size());
    // Torque of all of them first: a waiting goal does nothing by itself.
    for (std::size_t i = 0; i < servos.size(); ++i) {
        const device::Owned owned = device::own(stopping, {servos[i]->id});
        const auto torque = ensureTorqueOff(owned.context, *servos[i]);
        if (!torque && endsCheck(torque.error()))
            return tl::unexpected(torque.error());
        verdicts[i].torque = torque.value_or(Torque::Unknown);
    }
    for (std::size_t i = 0; i < servos.size(); ++i) {
        if (verdicts[i].torque == Torque::Unknown)
            continue;
        const auto held = device::cancelHeldGoal(stopping, *servos[i]);
        if (!held && endsCheck(held.error()))
            return tl::unexpected(held.error());
        verdicts[i].mayHavePendingGoal = held.value_or(true);
    }
    return verdicts;
}
} // namespace jobs
