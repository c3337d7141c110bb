// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of one channel: its chunks, and looking things up in them. Owned by SampleStore, its
// thread.
#pragma once

#include "record/sample_chunk.h"

#include <deque>

namespace record {
class SampleChannel {
public:
    /// A sample, or the end. Never the end of a chunk.
    struct Place {
        std::size_t chunk = 0;
        std::size_t index = 0;
        bool operator==(const Place&) const = default;
    };

    enum class Taken : std::uint8_t { Yes, OutOfOrder };

    /// `bytes` follows the memory that this takes.
    Taken append(base::Duration at, double value, std::size_t& bytes);
    void gap() { m_gap = true; }
    void clear();

    bool empty() const { return m_chunks.empty(); }
    bool endsInGap() const { return m_gap; }
    TimeSpan span() const; ///< not of an empty one

    Place begin() const { return {}; }
    Place end() const { return {m_chunks.size(), 0}; }
    Place next(Place place) const;
    Place previous(Place place) const; ///< not of the first
    /// The first sample from `start` on that is not before `at`.
    Place lowerBound(base::Duration at, Place start) const;
    Place lowerBound(base::Duration at) const { return lowerBound(at, begin()); }
    SamplePoint point(Place place) const;
    bool gapAt(Place place) const { return m_chunks[place.chunk].gapAt(place.index); }

    SampleColumn column(Place from, Place to) const; ///< from != to
    std::optional<Extremes> extremes(Place from, Place to) const;
    /// Time counts from `origin`.
    Moments moments(Place from, Place to, base::Duration origin) const;
    /// Says the truth about the samples in between, each of them.
    bool exact(Place from, Place to) const;

    /// End of the oldest chunk that can be thinned, or dropped; none: there is none.
    std::optional<base::Duration> oldestToThin() const;
    std::optional<base::Duration> oldestToDrop() const;
    void thinOldest(std::size_t& bytes);
    void dropOldest(std::size_t& bytes);
    bool thinned() const { return m_thinned > 0 || m_droppedTo; }
    std::optional<base::Duration> droppedTo() const { return m_droppedTo; }
    std::size_t bytes() const;

private:
    /// Calls with each chunk and the stretch [begin, end) of it.
    template <typename Function>
    void eachPiece(Place from, Place to, const Function& function) const;

    std::deque<SampleChunk> m_chunks; ///< none is empty; all but the last are closed
    std::size_t m_thinned = 0;        ///< so many of the first
    std::optional<base::Duration> m_droppedTo;
    bool m_gap = false; ///< before the next sample
};
} // namespace record
