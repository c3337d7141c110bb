// SPDX-License-Identifier: GPL-3.0-or-later
// Which servos belong to which job. Any thread; never waits (the bus does).
#pragma once

#include "protocol/request.h"

#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace bus {
class HoldTable {
public:
    enum class Access : std::uint8_t {
        Pass,
        Wait,      ///< another thread holds a servo
        Refused,   ///< the caller's own hold, but not its token
        Preempted, ///< an emergency came since the last transaction of this hold; said once
    };

    /// 0 when another thread holds one of them. Empty `ids`: all servos.
    /// `epoch`: see emergencies(); a hold of older work is born preempted.
    std::uint64_t take(const std::vector<int>& ids, std::thread::id owner,
                       std::optional<std::uint64_t> epoch = {});
    void release(std::uint64_t token);

    Access access(const protocol::Request& request, std::uint64_t token, std::thread::id caller,
                  std::optional<std::uint64_t> epoch = {});
    bool isHeld(int id) const;

    void preemptAll(); ///< an emergency
    std::uint64_t emergencyCount() const;
    void clearPreemption(std::uint64_t token); ///< its running transaction has said so already

private:
    struct Entry {
        std::uint64_t token = 0;
        std::vector<int> ids; ///< empty: all
        std::thread::id owner;
        bool preempted = false;
        bool covers(int id) const;
    };
    Access accessTo(int id, std::uint64_t token, std::thread::id caller) const;

    mutable std::mutex m_mutex;
    std::vector<Entry> m_entries;
    std::uint64_t m_lastToken = 0;
    std::uint64_t m_emergencyCount = 0;
};
} // namespace bus
