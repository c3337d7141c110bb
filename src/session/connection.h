// SPDX-License-Identifier: GPL-3.0-or-later
// One open port: the bus on its thread, and the simulated servos behind it if it is "sim:…". What a
// simulated servo keeps in its EPROM lives as long as the connection (servodesk-sim --state keeps
// it longer). Made by Session; main thread. Closing waits for the running transaction only.
#pragma once

#include "bus/bus.h"
#include "device/context.h"
#include "device/servo.h"

#include <map>
#include <memory>
#include <optional>

namespace sim {
class SharedBus;
}

namespace session {
struct PortRequest {
    QString name; ///< device path, tcp://host:port, sim:PRESET, sim:sts3215@1,scs15@2
    int baud = 1'000'000;
    std::optional<base::Duration> patience; ///< beyond wire time and reply delay
    std::optional<int> retries;
};

class Connection {
public:
    Connection(std::unique_ptr<bus::Bus> bus, std::shared_ptr<sim::SharedBus> simulation,
               const catalog::Catalog& catalog, base::Journal& journal);
    ~Connection();

    bus::Bus& bus() { return *m_bus; }
    device::Context context(const base::Stop& stop, device::Notices& notices);

    /// From now on the emergency stop also names this servo.
    void know(const device::Servo& servo);

    bool simulated() const { return m_simulation != nullptr; }
    /// Switches all simulated servos off and on again; false on a real port.
    bool powerCycle();

private:
    std::shared_ptr<sim::SharedBus> m_simulation;
    std::unique_ptr<bus::Bus> m_bus; ///< goes before the simulation its thread talks to
    const catalog::Catalog& m_catalog;
    base::Journal& m_journal;
    std::map<int, device::Servo> m_known;
};
} // namespace session
