// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/stop_frames.h"

#include "device/motion/torque_off.h"
#include "protocol/codec.h"

namespace device {
using base::Protocol;

namespace {
/// Far below the limit of a packet's length byte.
constexpr std::size_t maxTargets = 64;

/// A request for which the protocol has no frame is left out.
void append(std::vector<bus::StopFrame>& frames, Protocol protocol,
            const protocol::Request& request)
{
    if (auto frame = protocol::codecFor(protocol).encode(request.in(protocol)))
        frames.push_back({protocol, std::move(*frame)});
}

void append(std::vector<bus::StopFrame>& frames, Protocol protocol, int id,
            const TorqueOffWrite& off)
{
    append(frames, protocol,
           protocol::Request::write(id, off.offset, off.data, protocol::Repeat::Safe));
}

void appendPackets(std::vector<bus::StopFrame>& frames, Protocol protocol,
                   const std::vector<int>& ids, const TorqueOffWrite& off)
{
    std::vector<protocol::Target> targets;
    for (const int id : ids) {
        targets.push_back({id, off.data});
        if (targets.size() < maxTargets && id != ids.back())
            continue;
        append(frames, protocol, protocol::Request::syncWrite(off.offset, std::move(targets)));
        targets.clear();
    }
}
} // namespace

std::vector<bus::StopFrame> stopFrames(const std::vector<Protocol>& protocols,
                                       const std::vector<Servo>& known)
{
    std::vector<bus::StopFrame> frames;
    for (const Protocol protocol : protocols)
        append(frames, protocol, protocol::broadcastId, torqueOffFor(protocol));
    for (const Servo& servo : known) {
        append(frames, servo.protocol, servo.id,
               torqueOffOf(servo).value_or(torqueOffFor(servo.protocol)));
    }
    return frames;
}

std::vector<bus::StopFrame> stopFramesFor(const std::vector<int>& ids,
                                          const std::vector<Protocol>& protocols)
{
    std::vector<bus::StopFrame> frames;
    for (const Protocol protocol : protocols)
        appendPackets(frames, protocol, ids, torqueOffFor(protocol));
    for (const Protocol protocol : protocols) {
        for (const int id : ids)
            append(frames, protocol, id, torqueOffFor(protocol));
    }
    return frames;
}

void torqueOffImmediately(bus::Bus& bus, const std::vector<int>& ids,
                          const std::vector<Protocol>& protocols)
{
    bus.setStopFrames(stopFramesFor(ids, protocols));
    bus.emergency();
    // They must be sent before any later work, or that would count as work they interrupt.
    static_cast<void>(bus.listen({}));
}
} // namespace device
