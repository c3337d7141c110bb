// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of tests that start whole programs: waiting is skipped, but no thread's work.
#include "base/skipping_clock.h"
#include "support/test_main.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <thread>
#include <vector>

using namespace std::chrono_literals;
using base::Duration;
using base::SkippingClock;

namespace {
/// A second counted thread. Its end is waited for without the clock, by a thread that no longer
/// counts.
class CountedThread {
public:
    CountedThread(SkippingClock& clock, const std::function<void()>& work)
        : m_clock(clock)
        , m_begun(clock.makeEvent())
        , m_thread([this, work] {
            const base::ClockThread counted(m_clock);
            m_begun->set();
            work();
        })
    {
        m_begun->waitUntil(Duration::max());
    }
    ~CountedThread() { join(); }

    void join()
    {
        if (!m_thread.joinable())
            return;
        m_clock.removeThread();
        m_thread.join();
        m_clock.addThread();
    }

private:
    SkippingClock& m_clock;
    std::unique_ptr<base::Event> m_begun;
    std::thread m_thread;
};
} // namespace

class TestSkippingClock : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void waitingIsSkipped();
    void threadsKeepTheirOrder();
    void nothingIsSkippedWhileAThreadWorks();
    void aWokenThreadCountsAtOnce();
    void aStopEndsASleep();
};

void TestSkippingClock::waitingIsSkipped()
{
    SkippingClock clock;
    const auto start = clock.now();
    const auto event = clock.makeEvent();
    QVERIFY(clock.sleepUntil(start + 10h));
    QVERIFY(!event->waitUntil(start + 20h));
    QVERIFY(clock.now() >= start + 20h);
    QVERIFY(clock.now() < start + 21h);
    event->set();
    QVERIFY(event->waitUntil(start + 40h));
    QVERIFY(clock.now() < start + 21h);
}

void TestSkippingClock::threadsKeepTheirOrder()
{
    SkippingClock clock;
    const auto start = clock.now() + 1h; // by then the other thread has begun
    std::atomic<int> ticks{0};
    CountedThread ticking(clock, [&] {
        for (int tick = 1; tick <= 100; ++tick) {
            clock.sleepUntil(start + tick * 10min);
            ++ticks;
        }
    });
    for (int hour = 1; hour <= 10; ++hour) {
        clock.sleepUntil(start + hour * 1h + 5min);
        QCOMPARE(ticks.load(), hour * 6);
    }
    ticking.join();
    QCOMPARE(ticks.load(), 100);
}

void TestSkippingClock::nothingIsSkippedWhileAThreadWorks()
{
    SkippingClock clock;
    const auto start = clock.now();
    const auto done = clock.makeEvent();
    const CountedThread waiting(clock, [&] {
        clock.sleepUntil(start + 10h);
        done->set();
    });
    std::this_thread::sleep_for(20ms); // work: the clock knows nothing of it
    QVERIFY(clock.now() < start + 1h);
    QVERIFY(done->waitUntil(Duration::max()));
    QVERIFY(clock.now() >= start + 10h);
}

/// Who sets an event and waits must not skip time before the woken thread has been scheduled.
void TestSkippingClock::aWokenThreadCountsAtOnce()
{
    constexpr int rounds = 200;
    SkippingClock clock;
    const auto asked = clock.makeEvent();
    const auto answered = clock.makeEvent();
    std::vector<Duration> late;
    Duration askedAt{};
    CountedThread other(clock, [&] {
        for (int round = 0; round < rounds; ++round) {
            asked->waitUntil(Duration::max());
            late.push_back(clock.now() - askedAt);
            answered->set();
        }
    });
    for (int round = 0; round < rounds; ++round) {
        askedAt = clock.now();
        asked->set();
        answered->waitUntil(clock.now() + 100h);
    }
    other.join();
    QVERIFY(*std::max_element(late.begin(), late.end()) < 1h);
}

void TestSkippingClock::aStopEndsASleep()
{
    SkippingClock clock;
    base::StopToken stop;
    const auto start = clock.now();
    std::atomic<bool> slept{true};
    CountedThread sleeping(clock, [&] { slept = clock.sleepUntil(start + 10h, &stop); });
    stop.request();
    while (slept)
        std::this_thread::sleep_for(1ms); // work
    QVERIFY(clock.now() < start + 1h);
    // Nor does one that begins after the request take time.
    QVERIFY(!clock.sleepUntil(start + 10h, &stop));
    QVERIFY(clock.now() < start + 1h);
}

SERVODESK_GUILESS_TEST(TestSkippingClock)
#include "tst_skipping_clock.moc"
