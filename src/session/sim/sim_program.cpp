// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sim/sim_program.h"

#include "session/paths.h"
#include "session/sim/sim_hotplug_queue.h"
#include "sim/host/presets.h"
#include "sim/host/pty_host.h"
#include "sim/servo/eprom_store.h"

#include <atomic>
#include <csignal>

namespace session {
namespace {
/// EPROMs are looked at this often, so a change is on disk well within half a second.
constexpr int ticksPerSave = 10;

std::atomic<sim::PtyHost*> runningHost{nullptr};

extern "C" void stopRunningHost(int)
{
    if (sim::PtyHost* host = runningHost.load())
        host->stop();
}

/// While it lives, SIGTERM, SIGINT and SIGHUP end the host.
class StopBySignal {
public:
    explicit StopBySignal(sim::PtyHost& host)
    {
        runningHost = &host;
        for (const int number : signals)
            std::signal(number, stopRunningHost);
    }
    ~StopBySignal()
    {
        for (const int number : signals)
            std::signal(number, SIG_DFL);
        runningHost = nullptr;
    }
    StopBySignal(const StopBySignal&) = delete;
    StopBySignal& operator=(const StopBySignal&) = delete;

private:
#ifdef SIGHUP
    static constexpr int signals[] = {SIGTERM, SIGINT, SIGHUP};
#else
    static constexpr int signals[] = {SIGTERM, SIGINT};
#endif
};

base::Result<std::unique_ptr<sim::VirtualBus>> makeBus(const SimOptions& options)
{
    auto faults = sim::parseFaults(options.faults);
    if (!faults)
        return tl::unexpected(faults.error());
    sim::WireConfig wire;
    wire.echo = options.echo;
    wire.adapterLatency = options.latency;
    wire.faults = std::move(*faults);
    wire.seed = options.seed;
    const auto models = catalog::Catalog::load({modelFolder()});
    if (options.servos.isEmpty())
        return sim::makePreset(options.preset, models.catalog, wire, options.baud,
                               options.epromTime);
    return sim::makeServos(options.servos, models.catalog, options.baud, wire, options.epromTime);
}
} // namespace

base::Result<void> runSimulator(const SimOptions& options,
                                const std::function<void(const QString& path)>& announce,
                                const std::function<void(const QString& line)>& log)
{
    auto bus = makeBus(options);
    if (!bus)
        return tl::unexpected(bus.error());
    std::optional<sim::EpromStore> store;
    if (!options.stateFile.isEmpty()) {
        auto opened = sim::EpromStore::open(options.stateFile, **bus);
        if (!opened)
            return tl::unexpected(opened.error());
        store = std::move(*opened);
    }
    auto device = sim::PtyDevice::open(options.symlink, (*bus)->servos().front()->baud());
    if (!device)
        return tl::unexpected(device.error());
    sim::PtyHost host(**bus, **device, options.wireTime);
    const StopBySignal stopBySignal(host);

    base::Result<void> saved;
    int ticks = 0;
    SimHotplugQueue hotplug(**bus, [&log](const QString& line) {
        if (log)
            log(line);
    });
    announce((*device)->path()); // whoever reads it may signal at once
    const auto housekeeping = [&] {
        hotplug.poll();
        if (!store || ++ticks % ticksPerSave != 0)
            return;
        saved = store->saveChanges();
        if (!saved)
            host.stop();
    };
    std::optional<base::Duration> until;
    if (options.runFor)
        until = base::SystemClock().now() + *options.runFor;
    host.serve(until, housekeeping);
    if (store && saved)
        saved = store->saveChanges();
    return saved;
}
} // namespace session
