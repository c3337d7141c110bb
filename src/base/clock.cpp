// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.h"

#include <thread>

namespace base {
namespace {
using Steady = std::chrono::steady_clock;
}

Duration SystemClock::now() const
{
    return std::chrono::duration_cast<Duration>(Steady::now().time_since_epoch() * m_speed);
}

bool SystemClock::sleepUntil(Duration instant, const StopToken* stop)
{
    const auto real = std::chrono::duration_cast<Steady::duration>(instant) / m_speed;
    const Steady::time_point deadline{real};
    if (stop != nullptr)
        return stop->waitUntil(deadline);
    std::this_thread::sleep_until(deadline);
    return true;
}

bool ManualClock::sleepUntil(Duration instant, const StopToken* stop)
{
    if (stop != nullptr && stop->isRequested())
        return false;
    auto current = m_now.load(std::memory_order_relaxed);
    while (current < instant.count() && !m_now.compare_exchange_weak(current, instant.count())) {
    }
    return true;
}
} // namespace base
