// SPDX-License-Identifier: GPL-3.0-or-later
// Valid frames nobody waited for, for those who search. Bounded: the oldest fall out. Any thread.
#pragma once

#include "bus/bus.h"

#include <deque>
#include <mutex>

namespace bus {
class StrayList {
public:
    void add(Stray stray)
    {
        const std::lock_guard lock(m_mutex);
        if (m_strays.size() == capacity)
            m_strays.pop_front();
        m_strays.push_back(std::move(stray));
    }

    std::vector<Stray> take()
    {
        const std::lock_guard lock(m_mutex);
        std::vector<Stray> taken(m_strays.begin(), m_strays.end());
        m_strays.clear();
        return taken;
    }

private:
    static constexpr std::size_t capacity = 1024;
    std::mutex m_mutex;
    std::deque<Stray> m_strays;
};
} // namespace bus
