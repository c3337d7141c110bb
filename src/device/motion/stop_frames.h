// SPDX-License-Identifier: GPL-3.0-or-later
// Ready-made frames that take torque off, for the bus' emergency lane: in each language one frame
// for all servos, then one for each, because what is said to several is never acknowledged.
#pragma once

#include "bus/bus.h"
#include "device/servo.h"

namespace device {
/// `protocols`: the languages somebody on this line may speak. A known servo is spoken to in its
/// own, whether that is among them or not.
std::vector<bus::StopFrame> stopFrames(const std::vector<base::Protocol>& protocols,
                                       const std::vector<Servo>& known = {});

/// For these servos only, whatever they are. A protocol without a packet for several servos has the
/// frames for each alone.
std::vector<bus::StopFrame> stopFramesFor(const std::vector<int>& ids,
                                          const std::vector<base::Protocol>& protocols);

/// Sends those frames by the emergency lane, without reading anything before or between them, and
/// returns when they are out. They stay the stop frames of this bus. Proves nothing.
void torqueOffImmediately(bus::Bus& bus, const std::vector<int>& ids,
                          const std::vector<base::Protocol>& protocols);
} // namespace device
