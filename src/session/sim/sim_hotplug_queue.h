// SPDX-License-Identifier: GPL-3.0-or-later
// The hand that plugs servos of a simulated bag in and out while servodesk-sim runs: lines on
// standard input ("next", "unplug", "plug N"), SIGUSR1 for the next one. Does nothing on a bus that
// is no bag. One per program; the serving thread.
#pragma once

#include "sim/bus/virtual_bus.h"
#include "transport/stdin_reader.h"

#include <functional>

namespace session {
class SimHotplugQueue {
public:
    /// `tell` gets a line for each thing done or not understood: "plugged: STS3215 (1 of 6)".
    SimHotplugQueue(sim::VirtualBus& bus, std::function<void(const QString&)> log);
    ~SimHotplugQueue();
    SimHotplugQueue(const SimHotplugQueue&) = delete;
    SimHotplugQueue& operator=(const SimHotplugQueue&) = delete;

    void poll(); ///< never waits

private:
    void execute(const QByteArray& line);
    void next();
    void reportPlugged(std::size_t index);

    sim::VirtualBus& m_bus;
    std::function<void(const QString&)> m_log;
    transport::StdinReader m_input;
};
} // namespace session
