// SPDX-License-Identifier: GPL-3.0-or-later
// From registers wanted to reads on the wire: nearby spans become block reads, servos that want the
// same blocks share sync reads. Pure functions; any thread.
#pragma once

#include "bus/poll.h"

#include <vector>

namespace bus {
/// Servos that are asked for the same blocks. `sync`: by one packet, if more than one is there.
struct PollGroup {
    base::Protocol protocol = base::Protocol::Feetech;
    std::vector<int> ids;
    std::vector<PollSpan> blocks;
    bool sync = false;
};

/// Sorted by address; neighbors of equal `every` without overlap. A gap of up to `mergeGap` bytes
/// is read along, which is cheaper than another transaction; -1: nothing is merged but what is
/// wanted twice. Empty spans are dropped.
std::vector<PollSpan> mergeSpans(std::vector<PollSpan> spans, int mergeGap, int maxBlock);

/// Groups in the order of their first servo. A servo named twice is read once with all its spans.
std::vector<PollGroup> planGroups(const PollPlan& plan);
} // namespace bus
