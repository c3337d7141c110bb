// SPDX-License-Identifier: GPL-3.0-or-later
// Valid frames that answer no request, for searches. Bounded: the oldest fall out. Any thread.
#pragma once

#include "bus/bus.h"

#include <deque>
#include <mutex>

namespace bus {
class UnexpectedFrameList {
public:
    void add(UnexpectedFrame stray)
    {
        const std::lock_guard lock(m_mutex);
        if (m_unexpectedFrames.size() == capacity)
            m_unexpectedFrames.pop_front();
        m_unexpectedFrames.push_back(std::move(stray));
    }

    std::vector<UnexpectedFrame> take()
    {
        const std::lock_guard lock(m_mutex);
        std::vector<UnexpectedFrame> frames(m_unexpectedFrames.begin(), m_unexpectedFrames.end());
        m_unexpectedFrames.clear();
        return frames;
    }

private:
    static constexpr std::size_t capacity = 1024;
    std::mutex m_mutex;
    std::deque<UnexpectedFrame> m_unexpectedFrames;
};
} // namespace bus
