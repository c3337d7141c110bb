// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include "base/skipping_clock.h"
#include "bus/bus_thread.h"
#include "protocol/codec.h"
#include "session/paths.h"
#include "session/snapshot/safety_snapshot.h"
#include "sim/host/presets.h"
#include "sim/host/sim_link.h"
#include "sim/servo/eprom_store.h"
#include "transport/port_opener.h"
#include "transport/port_reconnector.h"

#include <algorithm>
#include <map>

namespace session {
namespace {
const QString simPrefix = QStringLiteral("sim:");

/// "demo" is a preset, "sts3215@1,scs15@2" a list.
base::Result<std::unique_ptr<sim::VirtualBus>> makeSimulation(const QString& name,
                                                              const catalog::Catalog& catalog)
{
    if (name.contains(QLatin1Char('@')))
        return sim::makeServos(name, catalog, std::nullopt);
    return sim::makePreset(name, catalog);
}

/// The rate at which most of the servos listen; the first one's among equals.
int commonRate(sim::VirtualBus& bus)
{
    std::map<int, int> votes;
    for (const sim::VirtualServo* servo : bus.servos())
        ++votes[servo->baud()];
    int best = 0;
    for (const sim::VirtualServo* servo : bus.servos()) {
        if (best == 0 || votes[servo->baud()] > votes[best])
            best = servo->baud();
    }
    return best;
}

int defaultRate(std::optional<base::Protocol> protocol)
{
    constexpr int feetech = 1'000'000;
    constexpr int others = 115'200;
    return protocol.value_or(base::Protocol::Feetech) == base::Protocol::Feetech ? feetech : others;
}

/// For tests: how many times as fast as usual the time of a simulated bus passes, or "skip" to
/// skip waiting. Servos outside this program keep their own time, so other ports are refused then.
const char* const clockSpeed = "SERVODESK_CLOCK_SPEED";

/// For tests: the file in which simulated servos keep their EPROMs while no program runs.
const char* const simulatedEproms = "SERVODESK_SIM_STATE";

base::Result<std::unique_ptr<sim::EpromStore>> openEproms(sim::VirtualBus& bus)
{
    const QString path = qEnvironmentVariable(simulatedEproms);
    if (path.isEmpty())
        return nullptr;
    auto store = sim::EpromStore::open(path, bus);
    if (!store)
        return tl::unexpected(store.error());
    return std::make_unique<sim::EpromStore>(std::move(*store));
}

std::unique_ptr<base::Clock> makeClock()
{
    if (qgetenv(clockSpeed) == "skip")
        return std::make_unique<base::SkippingClock>();
    return std::make_unique<base::SystemClock>(
        std::max(1, qEnvironmentVariableIntValue(clockSpeed)));
}
} // namespace

Session::Session()
    : m_loaded(catalog::Catalog::load({modelFolder()}))
    , m_journal(historyFile(), programName())
    , m_clock(makeClock())
{}

base::Result<std::unique_ptr<Connection>> Session::connect(const PortRequest& request)
{
    transport::PortSpec spec{request.name, request.baud.value_or(defaultRate(request.protocol)),
                             request.parity};
    std::shared_ptr<sim::SharedBus> simulation;
    std::unique_ptr<sim::EpromStore> eproms;
    if (request.name.startsWith(simPrefix)) {
        auto made = makeSimulation(request.name.mid(simPrefix.size()), m_loaded.catalog);
        if (!made)
            return tl::unexpected(made.error());
        if (!request.baud)
            spec.baud = commonRate(**made);
        auto kept = openEproms(**made);
        if (!kept)
            return tl::unexpected(kept.error());
        eproms = std::move(*kept);
        simulation = std::make_shared<sim::SharedBus>(std::move(*made));
    } else if (!m_clock->isRealTime()) {
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("connect"),
                          QLatin1String(clockSpeed));
    }
    // Kept by the bus, which opens the port again when a plug is put back.
    base::Clock& clock = *m_clock;
    const auto open =
        [simulation, &clock](
            const transport::PortSpec& port) -> base::Result<std::unique_ptr<transport::Link>> {
        if (simulation)
            return sim::makeSimLink(simulation, port.name, clock, port.baud);
        return transport::openPort(port, clock);
    };
    const auto opener = [keeper = std::make_shared<transport::PortReconnector>(spec, open)] {
        return keeper->open();
    };
    auto bus = bus::BusThread::open(
        opener, protocol::codecFor(request.protocol.value_or(base::Protocol::Feetech)), *m_clock);
    if (!bus)
        return tl::unexpected(bus.error());
    if (request.maxReplyLateness)
        (*bus)->setTimeout(*request.maxReplyLateness);
    if (request.retries)
        (*bus)->setRetries(*request.retries);
    if (request.frameSilence)
        (*bus)->setSilence(*request.frameSilence);
    return std::make_unique<Connection>(std::move(*bus), std::move(simulation), std::move(eproms),
                                        m_loaded.catalog, m_journal, request.protocol);
}

std::vector<transport::PortInfo> adapters()
{
    auto ports = transport::listPorts();
    ports.erase(std::remove_if(ports.begin(), ports.end(),
                               [](const transport::PortInfo& port) { return port.vendorId == 0; }),
                ports.end());
    return ports;
}

QStringList simulatedPorts()
{
    QStringList names;
    for (const QString& preset : sim::presetNames())
        names << simPrefix + preset;
    return names;
}

const std::vector<int>& standardBaudRates()
{
    return transport::standardBaudRates();
}
} // namespace session
