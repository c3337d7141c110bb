// SPDX-License-Identifier: GPL-3.0-or-later
// IDs at which one servo alone was found to answer on this connection, so that looking for a second
// one costs once. Owned by the bus; any thread.
#pragma once

#include "base/protocol.h"

#include <mutex>
#include <set>
#include <tuple>

namespace bus {
class VerifiedIds {
public:
    void add(base::Protocol protocol, int id, int baud)
    {
        const std::lock_guard lock(m_mutex);
        m_ids.insert({protocol, id, baud});
    }
    bool contains(base::Protocol protocol, int id, int baud) const
    {
        const std::lock_guard lock(m_mutex);
        return m_ids.count({protocol, id, baud}) > 0;
    }
    void remove(base::Protocol protocol, int id, int baud)
    {
        const std::lock_guard lock(m_mutex);
        m_ids.erase({protocol, id, baud});
    }
    /// After a search for servos that may have been plugged in since.
    void clear()
    {
        const std::lock_guard lock(m_mutex);
        m_ids.clear();
    }

private:
    mutable std::mutex m_mutex;
    std::set<std::tuple<base::Protocol, int, int>> m_ids;
};
} // namespace bus
