// SPDX-License-Identifier: GPL-3.0-or-later
// For the end of a job after the adapter was unplugged: the requests that make its end safe can be
// sent only when the link is back, or not at all. The job's thread; ends when the bus gives up.
#pragma once

#include "bus/bus.h"

namespace jobs {
inline void waitForReconnection(bus::Bus& bus)
{
    constexpr base::Duration slice = std::chrono::milliseconds(50);
    while (bus.isReconnecting())
        bus.pauseUntil(bus.clock().now() + slice, nullptr);
}
} // namespace jobs
