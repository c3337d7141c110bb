// SPDX-License-Identifier: GPL-3.0-or-later
// One open port: the bus on its thread, and the simulated servos behind it if it is "sim:…". What a
// simulated servo keeps in its EPROM lives as long as the connection; servodesk-sim --state and,
// for tests, SERVODESK_SIM_STATE keep it longer. Made by Session; main thread. Closing waits for
// the running transaction only.
#pragma once

#include "bus/bus.h"
#include "device/context.h"
#include "device/servo.h"
#include "transport/link.h"

#include <map>
#include <memory>
#include <optional>

namespace sim {
class EpromStore;
class SharedBus;
} // namespace sim

namespace session {
using Parity = transport::Parity;

struct PortRequest {
    QString name; ///< device path, tcp://host:port, sim:PRESET, sim:sts3215@1,scs15@2
    /// None: the rate that most servos of a simulated bus have; 115200 where only LX or Modbus is
    /// spoken; else 1 Mbaud.
    std::optional<int> baud{};
    Parity parity = Parity::None;
    std::optional<base::Protocol> protocol{};         ///< none: all that can exist at the rate
    std::optional<base::Duration> maxReplyLateness{}; ///< beyond wire time and reply delay
    std::optional<base::Duration>
        frameSilence{}; ///< between Modbus frames, instead of the standard's
    std::optional<int> retries{};
};

class Connection {
public:
    Connection(std::unique_ptr<bus::Bus> bus, std::shared_ptr<sim::SharedBus> simulation,
               std::unique_ptr<sim::EpromStore> eproms, const catalog::Catalog& catalog,
               base::Journal& journal, std::optional<base::Protocol> protocol);
    ~Connection();

    bus::Bus& bus() { return *m_bus; }
    device::Context context(const base::StopToken& stop, device::Notices& notices);

    /// The languages to try: the one asked for, or all that can exist at the present rate.
    std::vector<base::Protocol> protocols() const;

    /// From now on the emergency stop also names this servo.
    void addStopTarget(const device::Servo& servo);

    bool isSimulated() const { return m_simulation != nullptr; }
    /// Switches all simulated servos off and on again; false on a real port.
    bool powerCycle();
    /// The simulated servos are in a bag and plugged in one after the other.
    bool hasHotplugQueue() const;
    std::size_t pendingServoCount() const; ///< simulated servos that have not been plugged in yet
    bool connectNext(); ///< unplugs the one before; false: the bag is empty, or there is none
    void unplugAll();
    /// A simulated hand moves every shaft without torque from stop to stop, or no longer. Nothing
    /// on a real port.
    void moveSimulatedServosByHand(bool on);
    /// What is behind a simulated port, for trouble made on purpose; null on a real one.
    sim::SharedBus* simulation() const { return m_simulation.get(); }

private:
    std::shared_ptr<sim::SharedBus> m_simulation;
    std::unique_ptr<sim::EpromStore> m_eproms; ///< saved at the end; null: they are forgotten
    std::unique_ptr<bus::Bus> m_bus;           ///< goes before the simulation its thread talks to
    const catalog::Catalog& m_catalog;
    base::Journal& m_journal;
    void updateStopFrames();

    std::optional<base::Protocol> m_protocol;
    std::map<std::pair<base::Protocol, int>, device::Servo> m_known;
};
} // namespace session
