// SPDX-License-Identifier: GPL-3.0-or-later
// From registers wanted to reads on the wire: nearby spans become block reads, servos that want the
// same blocks share sync reads. Pure functions; any thread.
#pragma once

#include "bus/poll.h"

#include <vector>

namespace bus {
/// Servos that are asked for the same blocks. `sync`: by one packet, if more than one is there.
struct PollGroup {
    std::vector<int> ids;
    std::vector<PollSpan> blocks;
    bool sync = false;
};

/// Sorted by address, without overlap. A gap is read along where that is cheaper than another
/// transaction. Empty spans are dropped.
std::vector<PollSpan> mergeSpans(std::vector<PollSpan> spans);

/// Groups in the order of their first servo. A servo named twice is read once with all its spans.
std::vector<PollGroup> planGroups(const PollPlan& plan);
} // namespace bus
