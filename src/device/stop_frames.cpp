// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/stop_frames.h"

namespace device {
namespace {
/// The torque switch has this place in every Feetech table (protocol sheet §4).
constexpr int torqueSwitchAddress = 40;

void append(std::vector<base::Bytes>& frames, const protocol::Codec& codec, int id, int address)
{
    auto off = protocol::Request::write(id, address, {0}, protocol::Repeat::Safe);
    if (auto frame = codec.encode(off))
        frames.push_back(std::move(*frame));
}
} // namespace

std::vector<base::Bytes> stopFrames(const protocol::Codec& codec, const std::vector<Servo>& known)
{
    std::vector<base::Bytes> frames;
    append(frames, codec, protocol::broadcastId, torqueSwitchAddress);
    for (const Servo& servo : known) {
        const catalog::Register* torque =
            servo.profile ? servo.profile->byRole(catalog::Role::TorqueSwitch) : nullptr;
        append(frames, codec, servo.id, torque != nullptr ? torque->address : torqueSwitchAddress);
    }
    return frames;
}
} // namespace device
