// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace base {
namespace {
using Steady = std::chrono::steady_clock;

class SystemEvent final : public Event {
public:
    explicit SystemEvent(const Clock& clock)
        : m_clock(clock)
    {}

    void set() override
    {
        const std::lock_guard lock(m_mutex);
        m_isSet = true;
        m_wake.notify_one();
    }

    bool waitUntil(Duration instant) override
    {
        const auto isSet = [this] { return m_isSet; };
        std::unique_lock lock(m_mutex);
        if (instant == Duration::max())
            m_wake.wait(lock, isSet);
        else
            m_wake.wait_for(lock, m_clock.realTime(std::max(instant - m_clock.now(), Duration{})),
                            isSet);
        return std::exchange(m_isSet, false);
    }

private:
    const Clock& m_clock;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_isSet = false;
};
} // namespace

std::unique_ptr<Event> Clock::makeEvent()
{
    return std::make_unique<SystemEvent>(*this);
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
