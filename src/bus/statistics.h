// SPDX-License-Identifier: GPL-3.0-or-later
// What happened on the wire, by servo and in sum. A value copied out of the bus; any thread.
#pragma once

#include "base/clock.h"

#include <cstdint>
#include <map>

namespace bus {
/// A sync read counts once for each servo it asks.
struct Counters {
    std::uint64_t sent = 0; ///< attempts
    std::uint64_t ok = 0;   ///< answered attempts
    std::uint64_t timeouts = 0;
    std::uint64_t badChecksums = 0;
    std::uint64_t foreign = 0;
    std::uint64_t late = 0;
    std::uint64_t retried = 0; ///< transactions that needed more than one attempt
    std::uint64_t noiseBytes = 0;
    base::Duration roundTripP50{};
    base::Duration roundTripP99{};
};

struct Statistics {
    Counters total;
    std::map<int, Counters> byId;
    std::uint64_t bytesOut = 0;
    std::uint64_t bytesIn = 0;
    base::Duration wireTime{};     ///< time the bytes needed at their baud rates
    base::Duration since{};        ///< span the figures cover
    base::Duration timeout{};      ///< what ordinary transactions grant now beyond the wire time
    std::uint64_t samplesLost = 0; ///< polled, but not fetched in time
    double busLoad() const
    {
        return since.count() > 0 ? double(wireTime.count()) / double(since.count()) : 0.0;
    }
};
} // namespace bus
