// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of one channel: its chunks, and looking things up in them. Owned by SampleStore, its
// thread.
#pragma once

#include "recording/sample_chunk.h"

#include <deque>

namespace recording {
class SampleChannel {
public:
    /// A sample, or the end. Never the end of a chunk.
    struct Position {
        std::size_t chunk = 0;
        std::size_t index = 0;
        bool operator==(const Position&) const = default;
    };

    enum class AppendResult : std::uint8_t { Appended, OutOfOrder };

    /// `bytes` follows the memory that this takes.
    AppendResult append(base::Duration at, double value, std::size_t& bytes);
    void gap() { m_gap = true; }
    void clear();

    bool empty() const { return m_chunks.empty(); }
    bool endsInGap() const { return m_gap; }
    TimeSpan span() const; ///< not of an empty one

    Position begin() const { return {}; }
    Position end() const { return {m_chunks.size(), 0}; }
    Position next(Position position) const;
    Position previous(Position position) const; ///< not of the first
    /// The first sample from `start` on that is not before `at`.
    Position lowerBound(base::Duration at, Position start) const;
    Position lowerBound(base::Duration at) const { return lowerBound(at, begin()); }
    SamplePoint point(Position position) const;
    bool gapAt(Position position) const { return m_chunks[position.chunk].gapAt(position.index); }

    SampleColumn column(Position from, Position to) const; ///< from != to
    std::optional<Extremes> extremes(Position from, Position to) const;
    /// Time counts from `origin`.
    Moments moments(Position from, Position to, base::Duration origin) const;
    /// Exact for all samples in between.
    bool exact(Position from, Position to) const;

    /// End of the oldest chunk that can be thinned, or dropped; none: there is none.
    std::optional<base::Duration> oldestToDecimate() const;
    std::optional<base::Duration> oldestDroppable() const;
    void decimateOldest(std::size_t& bytes);
    void dropOldest(std::size_t& bytes);
    bool decimated() const { return m_decimated > 0 || m_droppedUntil; }
    std::optional<base::Duration> droppedUntil() const { return m_droppedUntil; }
    std::size_t bytes() const;

private:
    /// Calls with each chunk and the stretch [begin, end) of it.
    template <typename Function>
    void forEachChunk(Position from, Position to, const Function& function) const;

    std::deque<SampleChunk> m_chunks; ///< none is empty; all but the last are closed
    std::size_t m_decimated = 0;      ///< number of the oldest samples that are decimated
    std::optional<base::Duration> m_droppedUntil;
    bool m_gap = false; ///< before the next sample
};
} // namespace recording
