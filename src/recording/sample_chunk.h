// SPDX-License-Identifier: GPL-3.0-or-later
// Up to 4096 samples of one channel in time order, with min/max of each 8 and each 64 of them, so
// that the extremes of any stretch cost some dozens of steps. Times are 32-bit microseconds from
// the first one. Owned by SampleStore, its thread. Values are finite.
#pragma once

#include "recording/sample_store.h"

namespace recording {
struct Extremes {
    double min = 0;
    double max = 0;
    void include(const Extremes& other)
    {
        min = other.min < min ? other.min : min;
        max = other.max > max ? other.max : max;
    }
};

/// Count, means and central sums; those of stretches side by side can be merged without loss.
/// Time is in seconds from some origin.
struct Moments {
    std::uint64_t count = 0;
    double meanTime = 0;
    double mean = 0;
    double timeSquares = 0; ///< sum of (t - mean)²
    double squares = 0;
    double products = 0;
    void merge(const Moments& other);
};

class SampleChunk {
public:
    static constexpr std::size_t maxSamples = 4096;

    explicit SampleChunk(base::Duration first)
        : m_base(first)
    {}

    /// Room left, and not too long after the first one.
    bool accepts(base::Duration at) const;
    bool mustGrow() const { return m_values.size() == m_values.capacity(); }
    void grow();
    void append(base::Duration at, double value);
    void markGap() { m_gaps.push_back(std::uint16_t(m_values.size())); } ///< before the next one
    void close();                                                        ///< nothing comes any more

    /// Its extremes with their times, and what borders on gaps. Only of a closed one.
    SampleChunk decimated() const;
    bool isDecimated() const { return m_decimated; }

    std::size_t size() const { return m_values.size(); }
    base::Duration base() const { return m_base; }
    base::Duration timeAt(std::size_t i) const { return m_base + base::Duration(m_offsets[i]); }
    double valueAt(std::size_t i) const { return m_values[i]; }
    bool gapAt(std::size_t i) const; ///< nothing is known just before sample i
    base::Duration lastTime() const { return timeAt(size() - 1); }

    /// First sample from `start` on that is not before `at`.
    std::size_t lowerBound(base::Duration at, std::size_t start) const;
    Extremes extremes(std::size_t begin, std::size_t end) const; ///< begin < end
    /// Time counts from base(). All of a thinned chunk: what it was before.
    Moments moments(std::size_t begin, std::size_t end) const;
    std::size_t bytes() const;

private:
    Moments moments(std::size_t begin, std::size_t end, double meanTime, double mean) const;
    void copyExtremes(std::size_t begin, std::size_t end, SampleChunk& into) const;

    base::Duration m_base;
    std::vector<std::uint32_t> m_offsets;
    std::vector<double> m_values;
    std::vector<Extremes> m_small; ///< of 8 samples each
    std::vector<Extremes> m_large; ///< of 64
    std::vector<std::uint16_t> m_gaps;
    Moments m_moments; ///< of all, once closed
    Extremes m_extremes;
    bool m_closed = false;
    bool m_decimated = false;
};
} // namespace recording
