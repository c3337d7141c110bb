// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/answering.h"

#include "device/talk.h"

#include <algorithm>
#include <set>

namespace device {
using base::ErrorCode;
using namespace std::chrono_literals;

namespace {
constexpr base::Duration briefPatience = 4ms;
constexpr base::Duration listenSlice = 10ms;

/// Anything but silence, also the collision of two replies.
bool answers(const Context& context, int id, base::Protocol protocol)
{
    const auto outcome = pingOnce(context, protocol, id, briefPatience);
    return outcome || outcome.error().code == ErrorCode::Garbled ||
           outcome.error().code == ErrorCode::WrongAnswer;
}
} // namespace

std::vector<int> answeringAmong(const Context& context, const std::vector<int>& ids,
                                const std::vector<base::Protocol>& protocols)
{
    std::set<int> heard;
    const auto takeLate = [&] {
        for (const bus::Stray& stray : context.bus.takeStrays())
            heard.insert(stray.id);
    };
    const auto allHeard = [&] {
        return std::all_of(ids.begin(), ids.end(), [&](int id) { return heard.count(id) > 0; });
    };
    context.bus.takeStrays();
    for (const int id : ids) {
        for (const base::Protocol protocol : protocols) {
            if (heard.count(id) == 0 && answers(context, id, protocol))
                heard.insert(id);
        }
        takeLate();
    }
    base::Clock& clock = context.bus.clock();
    const base::Duration end = clock.now() + context.bus.replyTimeout();
    while (!allHeard() && clock.now() < end && !context.stop.requested() && !context.bus.lost()) {
        if (!context.bus.listen(listenSlice))
            break;
        takeLate();
    }
    std::vector<int> answering;
    std::copy_if(ids.begin(), ids.end(), std::back_inserter(answering),
                 [&](int id) { return heard.count(id) > 0; });
    return answering;
}
} // namespace device
