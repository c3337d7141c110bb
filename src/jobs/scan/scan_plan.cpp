// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan_plan.h"

#include "jobs/scan/rate_scan.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using base::Protocol;

std::vector<int> ratesToScan(const ScanSpec& spec, int currentBaud)
{
    std::vector<int> rates;
    for (const int baud : spec.bauds) {
        if (std::find(rates.begin(), rates.end(), baud) == rates.end())
            rates.push_back(baud);
    }
    if (rates.empty())
        rates.push_back(currentBaud);
    return rates;
}

std::vector<Protocol> protocolsToScan(const device::Context& context, const ScanSpec& spec,
                                      int baud)
{
    if (!spec.protocols.empty())
        return spec.protocols;
    // A bridge has no rate of its own to judge by.
    if (!context.bus.canSetBaud())
        return {base::allProtocols.begin(), base::allProtocols.end()};
    return context.catalog.protocolsAt(baud);
}

base::Duration estimateRate(const device::Context& context, const ScanSpec& spec, int baud)
{
    base::Duration total{};
    for (const Protocol protocol : protocolsToScan(context, spec, baud)) {
        if (idsToScan(spec, protocol).count() == 0)
            continue;
        total += broadcastEstimate(baud, protocol);
        if (!spec.untilFound || !scanProfileOf(protocol).supportsBroadcast)
            total += idScanEstimate(spec, baud, protocol);
    }
    return total;
}

base::Result<void> checkSpec(const device::Context& context, const ScanSpec& spec)
{
    const auto refuse = [](const QString& why) -> base::Result<void> {
        return base::fail(ErrorCode::BadArgument, QStringLiteral("scan"), why);
    };
    const bool idsGood =
        spec.firstId >= 0 && spec.firstId <= spec.lastId && spec.lastId <= protocol::maxId;
    const bool ratesGood =
        std::all_of(spec.bauds.begin(), spec.bauds.end(), [](int baud) { return baud > 0; });
    if (!idsGood || !ratesGood)
        return refuse(QStringLiteral("IDs 0 to 253, rates above 0"));
    for (const int baud : ratesToScan(spec, context.bus.baud())) {
        for (const Protocol protocol : protocolsToScan(context, spec, baud)) {
            if (idsToScan(spec, protocol).count() > 0)
                return {};
        }
    }
    return refuse(QStringLiteral("Modbus stations are 1 to 247"));
}

base::Duration estimateScanTime(const device::Context& context, const ScanSpec& spec)
{
    base::Duration total{};
    for (const int baud : ratesToScan(spec, context.bus.baud()))
        total += estimateRate(context, spec, baud);
    for (const int baud : ratesForLxAtTheEnd(context, spec))
        total += broadcastEstimate(baud, Protocol::Lx);
    return total;
}

std::vector<int> ratesForLxAtTheEnd(const device::Context& context, const ScanSpec& spec)
{
    std::vector<int> rates;
    if (!spec.untilFound || !spec.protocols.empty())
        return rates;
    for (const int baud : ratesToScan(spec, context.bus.baud())) {
        const auto searched = protocolsToScan(context, spec, baud);
        if (std::find(searched.begin(), searched.end(), Protocol::Lx) == searched.end())
            rates.push_back(baud);
    }
    return rates;
}
} // namespace jobs
