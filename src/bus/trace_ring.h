// SPDX-License-Identifier: GPL-3.0-or-later
// The latest frames of a bus. Bounded: where they are not fetched the oldest fall out and are
// counted. Written by the bus, fetched by any thread.
#pragma once

#include "bus/trace.h"

#include <mutex>
#include <vector>

namespace bus {
class TraceRing {
public:
    explicit TraceRing(std::size_t capacity = 4096);

    void setProtocol(base::Protocol protocol); ///< of the frames added from now on
    void add(base::Duration at, TraceKind kind, base::ByteView bytes);
    void note(base::Duration at, const QString& text); ///< ASCII
    std::vector<TraceEntry> take();                    ///< oldest first

private:
    std::mutex m_mutex;
    std::vector<TraceEntry> m_slots; ///< a slot keeps its bytes' memory for the next entry
    base::Protocol m_protocol = base::Protocol::Feetech;
    std::size_t m_capacity;
    std::size_t m_first = 0;
    std::size_t m_count = 0;
    std::uint64_t m_dropped = 0;
};
} // namespace bus
