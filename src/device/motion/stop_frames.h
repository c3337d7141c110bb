// SPDX-License-Identifier: GPL-3.0-or-later
// Ready-made frames that turn torque off, for the emergency lane of the bus: in each protocol one
// frame for all servos, then one for each, because a frame for several is never acknowledged.
#pragma once

#include "bus/bus.h"
#include "device/servo.h"

namespace device {
/// `protocols`: those that servos on this line may use. A known servo gets a frame of its own
/// protocol in every case.
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
