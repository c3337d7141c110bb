// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/stop_frames.h"

#include "device/release.h"
#include "protocol/codec.h"

namespace device {
using base::Protocol;

namespace {
void append(std::vector<bus::StopFrame>& frames, Protocol protocol, int id,
            const TorqueOffWrite& off)
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
        append(frames, servo.protocol, servo.id,
               torqueOffOf(servo).value_or(torqueOffIn(servo.protocol)));
    }
    return frames;
}
} // namespace device
