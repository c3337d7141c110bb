// SPDX-License-Identifier: GPL-3.0-or-later
// Polled samples on their way from the bus to its caller. Bounded: the oldest fall out and are
// counted. Any thread.
#pragma once

#include "bus/poll.h"

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <vector>

namespace bus {
class PollBuffer {
public:
    static constexpr std::size_t capacity = 65536; ///< samples a plan

    PollId open();
    void add(PollId id, Sample sample); ///< dropped silently once the plan is closed and fetched
    void close(PollId id);
    std::vector<Sample> take(PollId id);
    std::uint64_t lost() const;

private:
    struct Queue {
        std::deque<Sample> samples;
        bool closed = false;
    };
    mutable std::mutex m_mutex;
    std::map<PollId, Queue> m_queues;
    PollId m_last = 0;
    std::uint64_t m_lost = 0;
};
} // namespace bus
