// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a VirtualBus in real time behind a pseudo-terminal. A reply becomes readable in one piece
// when its last byte has passed the wire, as an adapter hands it over. With wire time that instant
// is met within some ten microseconds (sleep until shortly before, then spin); without, replies may
// come up to two milliseconds early, which is at once for ordinary frames; the bus never runs
// further ahead of the clock than that. The client sends at the rate it has set. One thread, except
// stop().
#pragma once

#include "sim/bus/virtual_bus.h"
#include "sim/host/pty_device.h"

#include <functional>
#include <optional>

namespace sim {
class PtyHost {
public:
    PtyHost(VirtualBus& bus, PtyDevice& device, bool wireTime);

    /// Serves until stop() or `until` (system clock). `housekeeping` is called some 50 times a
    /// second.
    void serve(std::optional<base::Duration> until, const std::function<void()>& housekeeping);
    void stop() { m_device.wake(); } ///< any thread, also from a signal handler

private:
    void listen();
    void deliver(base::Duration upTo);
    void waitFor(std::optional<base::Duration> due, base::Duration latest);

    VirtualBus& m_bus;
    PtyDevice& m_device;
    bool m_wireTime;
    base::Duration m_lead;
    base::SystemClock m_clock;
};
} // namespace sim
