// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stop_token.h"

namespace base {
void StopToken::request()
{
    {
        const std::lock_guard lock(m_mutex);
        m_requested.store(true, std::memory_order_release);
    }
    m_wake.notify_all();
}

bool StopToken::waitUntil(std::chrono::steady_clock::time_point deadline) const
{
    std::unique_lock lock(m_mutex);
    return !m_wake.wait_until(lock, deadline, [this] { return isRequested(); });
}
} // namespace base
