// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/connection.h"

#include "device/stop_frames.h"
#include "sim/sim_link.h"

namespace session {
Connection::Connection(std::unique_ptr<bus::Bus> bus, std::shared_ptr<sim::SharedBus> simulation,
                       const catalog::Catalog& catalog, base::Journal& journal)
    : m_simulation(std::move(simulation))
    , m_bus(std::move(bus))
    , m_catalog(catalog)
    , m_journal(journal)
{
    m_bus->setStopFrames(device::stopFrames(protocol::feetechCodec()));
}

Connection::~Connection() = default;

device::Context Connection::context(const base::Stop& stop, device::Notices& notices)
{
    return {*m_bus, m_catalog, m_journal, stop, notices};
}

void Connection::know(const device::Servo& servo)
{
    m_known[servo.id] = servo;
    std::vector<device::Servo> servos;
    for (const auto& [id, known] : m_known)
        servos.push_back(known);
    m_bus->setStopFrames(device::stopFrames(protocol::feetechCodec(), servos));
}

bool Connection::powerCycle()
{
    if (!m_simulation)
        return false;
    m_simulation->with([](sim::VirtualBus& bus) { bus.powerCycle(); });
    return true;
}
} // namespace session
