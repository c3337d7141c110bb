// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/responding.h"

#include "device/transactions.h"

#include <algorithm>
#include <set>

namespace device {
using base::ErrorCode;
using namespace std::chrono_literals;

namespace {
constexpr base::Duration pingTimeout = 4ms;
constexpr base::Duration listenSlice = 10ms;

/// Anything but silence, also the collision of two replies.
bool responds(const Context& context, int id, base::Protocol protocol)
{
    const auto outcome = pingOnce(context, protocol, id, pingTimeout);
    return outcome || outcome.error().code == ErrorCode::Garbled ||
           outcome.error().code == ErrorCode::UnexpectedReply;
}
} // namespace

std::vector<int> findResponding(const Context& context, const std::vector<int>& ids,
                                const std::vector<base::Protocol>& protocols)
{
    std::set<int> responding;
    const auto collectLate = [&] {
        for (const bus::UnexpectedFrame& stray : context.bus.takeUnexpectedFrames())
            responding.insert(stray.id);
    };
    const auto allResponded = [&] {
        return std::all_of(ids.begin(), ids.end(),
                           [&](int id) { return responding.count(id) > 0; });
    };
    context.bus.takeUnexpectedFrames();
    for (const int id : ids) {
        for (const base::Protocol protocol : protocols) {
            if (responding.count(id) == 0 && responds(context, id, protocol))
                responding.insert(id);
        }
        collectLate();
    }
    base::Clock& clock = context.bus.clock();
    const base::Duration end = clock.now() + context.bus.maxReplyLateness();
    while (!allResponded() && clock.now() < end && !context.stop.isRequested() &&
           !context.bus.lost()) {
        if (!context.bus.listen(listenSlice))
            break;
        collectLate();
    }
    std::vector<int> result;
    std::copy_if(ids.begin(), ids.end(), std::back_inserter(result),
                 [&](int id) { return responding.count(id) > 0; });
    return result;
}
} // namespace device
