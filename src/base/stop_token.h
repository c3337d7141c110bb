// SPDX-License-Identifier: GPL-3.0-or-later
// "Please end now": a flag that also wakes threads that wait on it. Owned by the caller that starts
// the work, passed by reference; any thread. Once requested it stays requested.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace base {
class StopToken {
public:
    StopToken() = default;
    StopToken(const StopToken&) = delete;
    StopToken& operator=(const StopToken&) = delete;

    void request();
    bool isRequested() const { return m_requested.load(std::memory_order_acquire); }

    /// Waits until `deadline`; true if it passed, false as soon as stop is requested.
    bool waitUntil(std::chrono::steady_clock::time_point deadline) const;

private:
    std::atomic<bool> m_requested{false};
    mutable std::mutex m_mutex;
    mutable std::condition_variable m_wake;
};
} // namespace base
