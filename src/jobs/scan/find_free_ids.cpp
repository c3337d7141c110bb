// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/find_free_ids.h"

#include "jobs/change/change_steps.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;

namespace {
std::vector<base::Protocol> protocolsOnBus(const device::Context& context, base::Protocol own)
{
    std::vector<base::Protocol> all{own};
    if (!context.bus.canSetBaud())
        return all;
    for (const base::Protocol other : context.catalog.protocolsAt(context.bus.baud())) {
        if (other != own)
            all.push_back(other);
    }
    return all;
}
} // namespace

base::Result<std::vector<int>> findFreeIds(const device::Context& context, base::Protocol protocol,
                                           const std::vector<int>& ids, std::size_t maxCount)
{
    const std::vector<base::Protocol> askedProtocols = protocolsOnBus(context, protocol);
    std::vector<int> free;
    for (const int id : ids) {
        if (free.size() >= maxCount)
            break;
        bool silent = true;
        for (const base::Protocol language : askedProtocols) {
            if (context.stop.isRequested())
                return base::fail(ErrorCode::Stopped, QStringLiteral("free-ids"));
            const auto unused = isIdFree(context, language, id, 1);
            if (!unused && base::endsJob(unused.error().code))
                return tl::unexpected(unused.error());
            silent = silent && unused.value_or(false);
        }
        if (silent)
            free.push_back(id);
    }
    return free;
}
} // namespace jobs
