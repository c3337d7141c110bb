// SPDX-License-Identifier: GPL-3.0-or-later
// Time for tests of whole programs on simulated servos: it passes as on the system's clock while a
// counted thread works, and jumps to the next instant that is waited for as soon as all of them
// wait. So a test costs what its work costs. Counted are the thread that made the clock and each
// ClockThread; a wait for anything else (a lock, a file, the keyboard) counts as work. Thread-safe.
#pragma once

#include "base/clock.h"

#include <condition_variable>
#include <mutex>
#include <vector>

namespace base {
class SkippingClock final : public Clock {
public:
    SkippingClock() { addThread(); }

    Duration now() const override;
    std::unique_ptr<Event> makeEvent() override;
    bool sleepUntil(Duration instant, const StopToken* stop = nullptr) override;
    bool isRealTime() const override { return false; }
    void addThread() override;
    void removeThread() override;

private:
    class SkippingEvent;
    struct Wait;

    void await(Wait& wait, const StopToken* stop, std::unique_lock<std::mutex>& lock);
    void end(Wait& wait);
    void skip();

    std::atomic<Duration::rep> m_skipped{0};
    std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_changed;
    std::vector<Wait*> m_waits;
    int m_working = 0;
};
} // namespace base
