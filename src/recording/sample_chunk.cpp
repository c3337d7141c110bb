// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/sample_chunk.h"

#include <algorithm>
#include <array>
#include <limits>

namespace recording {
namespace {
constexpr std::size_t smallBlock = 8;
constexpr std::size_t largeBlock = 64;
constexpr std::size_t initialCapacity = 64;
constexpr std::size_t decimationBucket = 64; ///< of this many, two are left
constexpr double secondsPerTick = 1e-6;

void add(std::vector<Extremes>& nodes, bool begins, const Extremes& what)
{
    if (begins)
        nodes.push_back(what);
    else
        nodes.back().include(what);
}

struct IndexRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool empty() const { return begin >= end; }
};

/// The nodes of `size` that lie in [begin, end) entirely.
IndexRange blocksWithin(std::size_t begin, std::size_t end, std::size_t size)
{
    return {(begin + size - 1) / size, end / size};
}

void include(Extremes& found, const std::vector<double>& values, std::size_t begin, std::size_t end)
{
    for (std::size_t i = begin; i < end; ++i)
        found.include({values[i], values[i]});
}

void include(Extremes& found, const std::vector<Extremes>& nodes, std::size_t begin,
             std::size_t end)
{
    for (std::size_t i = begin; i < end; ++i)
        found.include(nodes[i]);
}
} // namespace

void Moments::merge(const Moments& other)
{
    if (other.count == 0)
        return;
    const auto mine = double(count);
    const auto theirs = double(other.count);
    const double all = mine + theirs;
    const double timeStep = other.meanTime - meanTime;
    const double step = other.mean - mean;
    const double weight = mine * theirs / all;
    timeSquares += other.timeSquares + timeStep * timeStep * weight;
    squares += other.squares + step * step * weight;
    products += other.products + timeStep * step * weight;
    meanTime += timeStep * theirs / all;
    mean += step * theirs / all;
    count += other.count;
}

bool SampleChunk::accepts(base::Duration at) const
{
    return !m_closed && size() < maxSamples &&
           (at - m_base).count() <= std::numeric_limits<std::uint32_t>::max();
}

void SampleChunk::grow()
{
    const std::size_t room = std::clamp(m_values.capacity() * 2, initialCapacity, maxSamples);
    m_offsets.reserve(room);
    m_values.reserve(room);
    m_small.reserve(room / smallBlock);
    m_large.reserve((room + largeBlock - 1) / largeBlock);
}

void SampleChunk::append(base::Duration at, double value)
{
    const std::size_t i = size();
    m_offsets.push_back(std::uint32_t((at - m_base).count()));
    m_values.push_back(value);
    add(m_small, i % smallBlock == 0, {value, value});
    if (i % smallBlock == smallBlock - 1)
        add(m_large, i / smallBlock % (largeBlock / smallBlock) == 0, m_small.back());
}

void SampleChunk::close()
{
    m_extremes = extremes(0, size());
    m_moments = moments(0, size());
    m_closed = true;
    m_offsets.shrink_to_fit();
    m_values.shrink_to_fit();
    m_small.shrink_to_fit();
    m_large.shrink_to_fit();
    m_gaps.shrink_to_fit();
}

SampleChunk SampleChunk::decimated() const
{
    SampleChunk decimatedChunk(m_base);
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= size(); ++i) {
        if (i == size() || i - begin == decimationBucket || gapAt(i)) {
            copyExtremes(begin, i, decimatedChunk);
            begin = i;
        }
    }
    decimatedChunk.close();
    decimatedChunk.m_moments = m_moments;
    decimatedChunk.m_decimated = true;
    return decimatedChunk;
}

void SampleChunk::copyExtremes(std::size_t begin, std::size_t end, SampleChunk& into) const
{
    const auto first = m_values.begin();
    const auto [low, high] =
        std::minmax_element(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(end));
    std::array<std::size_t, 4> kept{std::size_t(low - first), std::size_t(high - first)};
    std::size_t count = 2;
    if (begin == 0 || gapAt(begin))
        kept[count++] = begin;
    if (end == size() || gapAt(end))
        kept[count++] = end - 1;
    std::sort(kept.begin(), kept.begin() + std::ptrdiff_t(count));
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && kept[i] == kept[i - 1])
            continue;
        if (gapAt(kept[i]))
            into.markGap();
        into.append(timeAt(kept[i]), m_values[kept[i]]);
    }
}

bool SampleChunk::gapAt(std::size_t i) const
{
    return !m_gaps.empty() && std::binary_search(m_gaps.begin(), m_gaps.end(), std::uint16_t(i));
}

std::size_t SampleChunk::lowerBound(base::Duration at, std::size_t start) const
{
    const auto offset = (at - m_base).count();
    if (start >= size() || offset <= std::int64_t(m_offsets[start]))
        return start;
    if (offset > std::int64_t(m_offsets.back()))
        return size();
    const auto wanted = std::uint32_t(offset);
    // Samples usually come at a steady rate: search around an estimate. From here on low is before
    // the wanted index and high is not.
    std::size_t low = start;
    std::size_t high = size() - 1;
    const double share = double(wanted - m_offsets[low]) / double(m_offsets[high] - m_offsets[low]);
    std::size_t guess = low + std::size_t(share * double(high - low));
    for (std::size_t step = 1; high - low > 1; step *= 2) {
        guess = std::clamp(guess, low + 1, high - 1);
        const bool before = m_offsets[guess] < wanted;
        (before ? low : high) = guess;
        if (before && step < high - guess)
            guess += step;
        else if (!before && step < guess - low)
            guess -= step;
        else
            break;
    }
    const auto first = m_offsets.begin();
    const auto found =
        std::lower_bound(first + std::ptrdiff_t(low + 1), first + std::ptrdiff_t(high), wanted);
    return std::size_t(found - first);
}

Extremes SampleChunk::extremes(std::size_t begin, std::size_t end) const
{
    if (m_closed && begin == 0 && end == size())
        return m_extremes;
    Extremes found{m_values[begin], m_values[begin]};
    const IndexRange small = blocksWithin(begin, end, smallBlock);
    if (small.empty()) {
        include(found, m_values, begin, end);
        return found;
    }
    include(found, m_values, begin, small.begin * smallBlock);
    include(found, m_values, small.end * smallBlock, end);
    const IndexRange large = blocksWithin(small.begin, small.end, largeBlock / smallBlock);
    if (large.empty()) {
        include(found, m_small, small.begin, small.end);
        return found;
    }
    include(found, m_small, small.begin, large.begin * (largeBlock / smallBlock));
    include(found, m_large, large.begin, large.end);
    include(found, m_small, large.end * (largeBlock / smallBlock), small.end);
    return found;
}

Moments SampleChunk::moments(std::size_t begin, std::size_t end) const
{
    if (begin == end)
        return {};
    if (m_closed && begin == 0 && end == size())
        return m_moments;
    double times = 0;
    double values = 0;
    for (std::size_t i = begin; i < end; ++i) {
        times += m_offsets[i];
        // From the first value, so that a small noise on a large number keeps its digits.
        values += m_values[i] - m_values[begin];
    }
    const auto count = double(end - begin);
    return moments(begin, end, times / count * secondsPerTick, m_values[begin] + values / count);
}

Moments SampleChunk::moments(std::size_t begin, std::size_t end, double meanTime, double mean) const
{
    Moments sums{end - begin, meanTime, mean};
    for (std::size_t i = begin; i < end; ++i) {
        const double time = m_offsets[i] * secondsPerTick - meanTime;
        const double value = m_values[i] - mean;
        sums.timeSquares += time * time;
        sums.squares += value * value;
        sums.products += time * value;
    }
    return sums;
}

std::size_t SampleChunk::bytes() const
{
    return sizeof(*this) + m_offsets.capacity() * sizeof(m_offsets[0]) +
           m_values.capacity() * sizeof(m_values[0]) +
           (m_small.capacity() + m_large.capacity()) * sizeof(Extremes) +
           m_gaps.capacity() * sizeof(m_gaps[0]);
}
} // namespace recording
