// SPDX-License-Identifier: GPL-3.0-or-later
// At the end of a job that awaits a pulled plug: what makes its end safe can be said only when the
// line is back, or not at all. The job's thread; ends with the bus' patience.
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
