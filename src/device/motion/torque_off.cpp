// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/torque_off.h"

#include "device/transactions.h"

namespace device {
using base::ErrorCode;
using base::Protocol;
using catalog::Role;

namespace {
/// The operation of an error after which torque off was sent; the text layer describes it.
const QString sentOperation = QStringLiteral("torque-off-sent");

/// The context for a write that must reach the servo although writing to it is refused.
Context unrestricted(const Context& context)
{
    Context stopping = context;
    stopping.emergencyStop = true;
    return stopping;
}

bool reachedWire(const base::Result<void>& sent)
{
    return sent || isReplyLost(sent.error()) || sent.error().code == ErrorCode::LineBusy ||
           sent.error().code == ErrorCode::Refused;
}

bool isTorqueOff(const Context& context, Servo& servo)
{
    const auto off = torqueOffOf(servo);
    const catalog::Register* reg =
        servo.profile ? servo.profile->byRole(Role::TorqueSwitch) : nullptr;
    if (!off)
        return false;
    const int offset = reg != nullptr ? reg->offset : off->offset;
    const int count = static_cast<int>(off->data.size());
    return readBlock(context, servo, offset, count) &&
           servo.image.bytes(offset, count) == off->data;
}
} // namespace

TorqueOffWrite torqueOffFor(Protocol protocol)
{
    constexpr int lxUnload = 8 * 31;
    constexpr int modbusTorqueSwitch = 2 * 129;
    constexpr int feetechTorqueSwitch = 40; // the same address in every table (protocol sheet §4)
    switch (protocol) {
    case Protocol::Lx:
        return {lxUnload, {0}};
    case Protocol::Modbus:
        return {modbusTorqueSwitch, {0, 0}};
    case Protocol::Feetech:
        break;
    }
    return {feetechTorqueSwitch, {0}};
}

std::optional<TorqueOffWrite> torqueOffOf(const Servo& servo)
{
    const catalog::Register* torque =
        servo.profile ? servo.profile->byRole(Role::TorqueSwitch) : nullptr;
    if (torque != nullptr)
        return TorqueOffWrite{torque->writeOffset,
                              base::Bytes(static_cast<std::size_t>(torque->size), 0)};
    if (servo.profile && servo.profile->writable)
        return std::nullopt;
    return torqueOffFor(servo.protocol);
}

bool sendTorqueOff(const Context& context, Servo& servo)
{
    const auto off = torqueOffOf(servo);
    if (!off || !canEncode(servo, protocol::Request::write(servo.id, off->offset, off->data,
                                                           protocol::Repeat::Safe)))
        return false;
    return reachedWire(writeBlock(unrestricted(context), servo,
                                  {off->offset, off->offset, off->data}, protocol::Repeat::Safe));
}

base::Result<void> forceTorqueOff(const Context& context, Servo& servo, base::Error why)
{
    if (!sendTorqueOff(context, servo))
        return tl::unexpected(std::move(why));
    const bool isOtherServo =
        why.code == ErrorCode::DuplicateId || why.code == ErrorCode::IdentityMismatch;
    if (!isOtherServo && isTorqueOff(context, servo)) {
        context.note(NoticeCode::TorqueSwitchedOff, servo.id);
        return {};
    }
    return tl::unexpected(markUnverified(std::move(why)));
}

base::Error markUnverified(base::Error why)
{
    why.operation = sentOperation;
    return why;
}

bool isMarkedUnverified(const base::Error& error)
{
    return error.operation == sentOperation;
}

base::Error forceTorqueOffUnidentified(const Context& context, int id,
                                       const std::vector<Protocol>& protocols, base::Error why)
{
    bool sent = false;
    for (const Protocol protocol : protocols) {
        Servo unknown;
        unknown.protocol = protocol;
        unknown.id = id;
        sent = sendTorqueOff(context, unknown) || sent;
    }
    return sent ? markUnverified(std::move(why)) : why;
}
} // namespace device
