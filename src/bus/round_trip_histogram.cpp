// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/round_trip_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace bus {
namespace {
constexpr unsigned subBits = 6;
constexpr std::uint64_t exactBelow = std::uint64_t{2} << subBits;
constexpr std::uint64_t maxRoundTrip = std::uint64_t{1} << 30;

/// Values below 128 have a bucket each; above, each power of two is cut in 64.
std::size_t bucketOf(std::uint64_t value)
{
    value = std::min(value, maxRoundTrip);
    if (value < exactBelow)
        return value;
    const auto shift = static_cast<unsigned>(std::bit_width(value)) - subBits - 1;
    return (std::size_t{shift} << subBits) + (value >> shift);
}

std::uint64_t middleOf(std::size_t bucket)
{
    if (bucket < exactBelow)
        return bucket;
    const std::size_t shift = (bucket >> subBits) - 1;
    const std::uint64_t low = (bucket - (shift << subBits)) << shift;
    return low + ((std::uint64_t{1} << shift) >> 1);
}
} // namespace

void RoundTripHistogram::add(base::Duration roundTrip)
{
    const auto count = std::max<base::Duration::rep>(roundTrip.count(), 0);
    const std::size_t bucket = bucketOf(static_cast<std::uint64_t>(count));
    if (bucket >= m_buckets.size())
        m_buckets.resize(bucket + 1);
    ++m_buckets[bucket];
    ++m_count;
}

base::Duration RoundTripHistogram::percentile(double fraction) const
{
    const auto rank =
        static_cast<std::uint64_t>(std::ceil(fraction * static_cast<double>(m_count)));
    std::uint64_t cumulative = 0;
    for (std::size_t bucket = 0; bucket < m_buckets.size(); ++bucket) {
        cumulative += m_buckets[bucket];
        if (cumulative > 0 && cumulative >= rank)
            return base::Duration(static_cast<base::Duration::rep>(middleOf(bucket)));
    }
    return {};
}
} // namespace bus
