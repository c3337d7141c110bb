// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/stop_frames.h"

#include "protocol/codec.h"

namespace device {
using base::Protocol;
using catalog::Role;

namespace {
/// Where every servo of a language has its torque switch, and what "off" looks like there.
struct TorqueOff {
    int offset = 0;
    base::Bytes data;
};

TorqueOff torqueOffIn(Protocol protocol)
{
    constexpr int lxUnload = 8 * 31;
    constexpr int modbusTorqueSwitch = 2 * 129;
    constexpr int feetechTorqueSwitch = 40; // the same place in every table (protocol sheet §4)
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

void append(std::vector<bus::StopFrame>& frames, Protocol protocol, int id, const TorqueOff& off)
{
    const auto request =
        protocol::Request::write(id, off.offset, off.data, protocol::Repeat::Safe).in(protocol);
    if (auto frame = protocol::codecFor(protocol).encode(request))
        frames.push_back({protocol, std::move(*frame)});
}
} // namespace

std::vector<bus::StopFrame> stopFrames(const std::vector<Protocol>& protocols,
                                       const std::vector<Servo>& known)
{
    std::vector<bus::StopFrame> frames;
    for (const Protocol protocol : protocols)
        append(frames, protocol, protocol::broadcastId, torqueOffIn(protocol));
    for (const Servo& servo : known) {
        TorqueOff off = torqueOffIn(servo.protocol);
        const catalog::Register* torque =
            servo.profile ? servo.profile->byRole(Role::TorqueSwitch) : nullptr;
        if (torque != nullptr)
            off = {torque->writeOffset, base::Bytes(static_cast<std::size_t>(torque->size), 0)};
        append(frames, servo.protocol, servo.id, off);
    }
    return frames;
}
} // namespace device
