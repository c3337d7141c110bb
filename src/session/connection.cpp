// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/connection.h"

#include "device/motion/stop_frames.h"
#include "sim/host/sim_link.h"
#include "sim/servo/eprom_store.h"

namespace session {
Connection::Connection(std::unique_ptr<bus::Bus> bus, std::shared_ptr<sim::SharedBus> simulation,
                       std::unique_ptr<sim::EpromStore> eproms, const catalog::Catalog& catalog,
                       base::Journal& journal, std::optional<base::Protocol> protocol)
    : m_simulation(std::move(simulation))
    , m_eproms(std::move(eproms))
    , m_bus(std::move(bus))
    , m_catalog(catalog)
    , m_journal(journal)
    , m_protocol(protocol)
{
    updateStopFrames();
}

Connection::~Connection()
{
    m_bus.reset(); // writes are over
    if (!m_eproms)
        return;
    if (const auto saved = m_eproms->saveChanges(); !saved)
        qWarning("Cannot save the simulated servos: %s", qPrintable(saved.error().detail));
}

device::Context Connection::context(const base::StopToken& stop, device::Notices& notices)
{
    return {*m_bus, m_catalog, m_journal, stop, notices};
}

void Connection::addStopTarget(const device::Servo& servo)
{
    m_known[{servo.protocol, servo.id}] = servo;
    updateStopFrames();
}

std::vector<base::Protocol> Connection::protocols() const
{
    if (m_protocol)
        return {*m_protocol};
    auto possible = m_catalog.protocolsAt(m_bus->baud());
    // A bridge has no rate of its own to judge by.
    if (!m_bus->canSetBaud() || possible.empty())
        possible.assign(base::allProtocols.begin(), base::allProtocols.end());
    return possible;
}

void Connection::updateStopFrames()
{
    std::vector<device::Servo> servos;
    for (const auto& [identity, known] : m_known)
        servos.push_back(known);
    // The rate may change in the middle of a job; a servo that turns then must get it too.
    const std::vector<base::Protocol> everybody(base::allProtocols.begin(),
                                                base::allProtocols.end());
    m_bus->setStopFrames(
        device::stopFrames(m_protocol ? std::vector{*m_protocol} : everybody, servos));
}

bool Connection::powerCycle()
{
    if (!m_simulation)
        return false;
    m_simulation->with([](sim::VirtualBus& bus) { bus.powerCycle(); });
    return true;
}

bool Connection::hasHotplugQueue() const
{
    return m_simulation &&
           m_simulation->with([](sim::VirtualBus& bus) { return bus.hasHotplugQueue(); });
}

std::size_t Connection::pendingServoCount() const
{
    return m_simulation
               ? m_simulation->with([](sim::VirtualBus& bus) { return bus.pendingServoCount(); })
               : 0;
}

bool Connection::connectNext()
{
    return m_simulation &&
           m_simulation->with([](sim::VirtualBus& bus) { return bus.connectNext().has_value(); });
}

void Connection::unplugAll()
{
    if (m_simulation)
        m_simulation->with([](sim::VirtualBus& bus) { bus.unplugAll(); });
}

void Connection::moveSimulatedServosByHand(bool on)
{
    constexpr double handSpeed = 2.5; // rad/s: about 140 degrees
    if (!m_simulation)
        return;
    m_simulation->with([on](sim::VirtualBus& bus) {
        for (sim::VirtualServo* servo : bus.servos())
            servo->load().handSpeed = on ? handSpeed : 0.0;
    });
}
} // namespace session
