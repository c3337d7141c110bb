// SPDX-License-Identifier: GPL-3.0-or-later
// Ready-made frames that take torque off, for the bus' emergency lane: once to everybody in each
// language, then once to each known servo, because a broadcast is never acknowledged. Pure.
#pragma once

#include "bus/stop_frame.h"
#include "device/servo.h"

namespace device {
/// `protocols`: the languages somebody on this line may speak. A known servo is spoken to in its
/// own, whether that is among them or not.
std::vector<bus::StopFrame> stopFrames(const std::vector<base::Protocol>& protocols,
                                       const std::vector<Servo>& known = {});
} // namespace device
