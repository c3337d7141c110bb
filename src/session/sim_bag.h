// SPDX-License-Identifier: GPL-3.0-or-later
// The hand that plugs servos of a simulated bag in and out while servodesk-sim runs: lines on
// standard input ("next", "unplug", "plug N"), SIGUSR1 for the next one. Does nothing on a bus that
// is no bag. One per program; the serving thread.
#pragma once

#include "sim/virtual_bus.h"
#include "transport/line_input.h"

#include <functional>

namespace session {
class SimBag {
public:
    /// `tell` gets a line for each thing done or not understood: "plugged: STS3215 (1 of 6)".
    SimBag(sim::VirtualBus& bus, std::function<void(const QString&)> tell);
    ~SimBag();
    SimBag(const SimBag&) = delete;
    SimBag& operator=(const SimBag&) = delete;

    void look(); ///< never waits

private:
    void obey(const QByteArray& line);
    void next();
    void sayPlugged(std::size_t place);

    sim::VirtualBus& m_bus;
    std::function<void(const QString&)> m_tell;
    transport::LineInput m_input;
};
} // namespace session
