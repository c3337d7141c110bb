// SPDX-License-Identifier: GPL-3.0-or-later
// Time as everything below the window sees it. Instants and spans are both microseconds; instants
// count from an arbitrary start of the clock. No other code in src asks the system for the time of
// a measurement.
#pragma once

#include "base/stop_token.h"

#include <atomic>
#include <chrono>
#include <memory>

namespace base {
using Duration = std::chrono::microseconds;

/// One thread waits for it, any thread sets it; a wait that returns true resets it. Must be
/// destroyed before its clock.
class Event {
public:
    virtual ~Event() = default;
    virtual void set() = 0;

    /// True: set; false: `instant` passed. Duration::max() waits for ever.
    virtual bool waitUntil(Duration instant) = 0;
};

class Clock {
public:
    virtual ~Clock() = default;
    virtual Duration now() const = 0;
    virtual std::unique_ptr<Event> makeEvent();

    /// Waits until `instant`; false as soon as `stop` is requested. Thread-safe.
    virtual bool sleepUntil(Duration instant, const StopToken* stop = nullptr) = 0;

    bool sleepFor(Duration span, const StopToken* stop = nullptr)
    {
        return sleepUntil(now() + span, stop);
    }

    /// How long the system must wait for `span` of this clock.
    virtual Duration realTime(Duration span) const { return span; }

    /// False for a clock that only simulated servos can keep.
    virtual bool isRealTime() const { return true; }

    /// From one to the other, the calling thread counts as working. For ClockThread.
    virtual void addThread() {}
    virtual void removeThread() {}

    /// True when waiting costs no real time; do not wait for another thread with such a clock.
    virtual bool isManual() const { return false; }
};

/// Monotonic system time; `speed` times as fast for tests on simulated servos, which keep its time.
class SystemClock final : public Clock {
public:
    explicit SystemClock(int speed = 1)
        : m_speed(speed)
    {}

    Duration now() const override;
    bool sleepUntil(Duration instant, const StopToken* stop = nullptr) override;
    Duration realTime(Duration span) const override { return span / m_speed; }
    bool isRealTime() const override { return m_speed == 1; }

private:
    int m_speed;
};

/// Counts the calling thread as working, except while it waits with `clock`.
class ClockThread {
public:
    explicit ClockThread(Clock& clock)
        : m_clock(clock)
    {
        m_clock.addThread();
    }
    ~ClockThread() { m_clock.removeThread(); }
    ClockThread(const ClockThread&) = delete;
    ClockThread& operator=(const ClockThread&) = delete;

private:
    Clock& m_clock;
};

/// Time that passes only when a caller waits or advances it. For tests and fast simulation.
class ManualClock final : public Clock {
public:
    Duration now() const override { return Duration(m_now.load(std::memory_order_relaxed)); }
    bool sleepUntil(Duration instant, const StopToken* stop = nullptr) override;
    bool isManual() const override { return true; }
    void advance(Duration span) { m_now.fetch_add(span.count(), std::memory_order_relaxed); }

private:
    std::atomic<Duration::rep> m_now{0};
};
} // namespace base
