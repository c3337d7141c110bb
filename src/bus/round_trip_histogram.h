// SPDX-License-Identifier: GPL-3.0-or-later
// Percentiles of round trips in bounded memory: a histogram that is exact below 128 µs and within
// 1/64 above. One thread.
#pragma once

#include "base/clock.h"

#include <cstdint>
#include <vector>

namespace bus {
class RoundTripHistogram {
public:
    void add(base::Duration roundTrip);
    base::Duration percentile(double fraction) const; ///< 0…1; zero while empty

private:
    std::vector<std::uint32_t> m_buckets; ///< grows to the slowest seen
    std::uint64_t m_count = 0;
};
} // namespace bus
