// SPDX-License-Identifier: GPL-3.0-or-later
// Ready-made frames that take torque off, for the bus' emergency lane: once to everybody, then once
// to each known servo, because a broadcast is never acknowledged. Pure.
#pragma once

#include "device/servo.h"
#include "protocol/codec.h"

namespace device {
std::vector<base::Bytes> stopFrames(const protocol::Codec& codec,
                                    const std::vector<Servo>& known = {});
} // namespace device
