// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/skipping_clock.h"

#include <algorithm>
#include <utility>

namespace base {
namespace {
using namespace std::chrono_literals;

/// A stop request does not end a wait here; it is looked for this often.
constexpr Duration stopInterval = 5ms;

/// The clock that counts this thread's work.
thread_local const SkippingClock* counting = nullptr;
} // namespace

struct SkippingClock::Wait {
    Duration until;
    const Event* event;
    bool isCounted;
    bool isOver = false;
    bool isSet = false; ///< its event ended it
};

class SkippingClock::SkippingEvent final : public Event {
public:
    explicit SkippingEvent(SkippingClock& clock)
        : m_clock(clock)
    {}

    void set() override
    {
        const std::lock_guard lock(m_clock.m_mutex);
        const auto wait = std::find_if(m_clock.m_waits.begin(), m_clock.m_waits.end(),
                                       [this](const Wait* one) { return one->event == this; });
        if (wait == m_clock.m_waits.end()) {
            m_isSet = true;
            return;
        }
        (*wait)->isSet = true;
        m_clock.end(**wait);
    }

    bool waitUntil(Duration instant) override
    {
        std::unique_lock lock(m_clock.m_mutex);
        if (std::exchange(m_isSet, false))
            return true;
        Wait wait{instant, this, counting == &m_clock};
        m_clock.await(wait, nullptr, lock);
        return wait.isSet;
    }

private:
    SkippingClock& m_clock;
    bool m_isSet = false;
};

Duration SkippingClock::now() const
{
    return SystemClock().now() + Duration(m_skipped.load(std::memory_order_acquire));
}

std::unique_ptr<Event> SkippingClock::makeEvent()
{
    return std::make_unique<SkippingEvent>(*this);
}

bool SkippingClock::sleepUntil(Duration instant, const StopToken* stop)
{
    if (stop != nullptr && stop->isRequested())
        return false;
    std::unique_lock lock(m_mutex);
    Wait wait{instant, nullptr, counting == this};
    await(wait, stop, lock);
    return stop == nullptr || !stop->isRequested();
}

void SkippingClock::addThread()
{
    const std::lock_guard lock(m_mutex);
    counting = this;
    ++m_working;
}

void SkippingClock::removeThread()
{
    const std::lock_guard lock(m_mutex);
    counting = nullptr;
    --m_working;
    skip();
}

void SkippingClock::await(Wait& wait, const StopToken* stop, std::unique_lock<std::mutex>& lock)
{
    m_waits.push_back(&wait);
    if (wait.isCounted)
        --m_working;
    skip();
    while (!wait.isOver) {
        const Duration left = wait.until - now();
        if (left <= 0us || (stop != nullptr && stop->isRequested()))
            end(wait);
        else
            m_changed.wait_for(lock, stop == nullptr ? std::min<Duration>(left, 1s)
                                                     : std::min(left, stopInterval));
    }
}

/// With the mutex held, as skip(). The woken thread counts as working at once, even before it is
/// scheduled.
void SkippingClock::end(Wait& wait)
{
    wait.isOver = true;
    if (wait.isCounted)
        ++m_working;
    m_waits.erase(std::find(m_waits.begin(), m_waits.end(), &wait));
    m_changed.notify_all();
}

void SkippingClock::skip()
{
    const auto earlier = [](const Wait* a, const Wait* b) { return a->until < b->until; };
    while (m_working == 0 && !m_waits.empty()) {
        Wait& next = **std::min_element(m_waits.begin(), m_waits.end(), earlier);
        if (next.until == Duration::max())
            return; // only an event from outside can go on
        m_skipped.fetch_add(std::max(next.until - now(), Duration{}).count(),
                            std::memory_order_release);
        end(next);
    }
}
} // namespace base
