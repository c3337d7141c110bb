// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of tests that start whole programs: waiting is skipped, but no thread's work.
#include "base/skipping_clock.h"
#include "support/test_main.h"

#include <QTest>

#include <thread>

using namespace std::chrono_literals;
using base::ClockThread;
using base::SkippingClock;

class TestSkippingClock : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void waitingIsSkipped();
    void threadsKeepTheirOrder();
    void nothingIsSkippedWhileAThreadWorks();
    void whoIsWokenWorksAtOnce();
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
    int ticks = 0;
    const auto begun = clock.makeEvent();
    std::thread ticking([&] {
        const ClockThread member(clock);
        begun->set();
        for (int tick = 1; tick <= 100; ++tick) {
            clock.sleepUntil(start + tick * 10min);
            ++ticks;
        }
    });
    QVERIFY(begun->waitUntil(base::Duration::max()));
    for (int hour = 1; hour <= 10; ++hour) {
        clock.sleepUntil(start + hour * 1h + 5min);
        QCOMPARE(ticks, hour * 6);
    }
    clock.removeThread(); // this one waits for the other now
    ticking.join();
    QCOMPARE(ticks, 100);
}

void TestSkippingClock::nothingIsSkippedWhileAThreadWorks()
{
    SkippingClock clock;
    const auto start = clock.now();
    const auto done = clock.makeEvent();
    std::thread waiting([&] {
        const ClockThread member(clock);
        clock.sleepUntil(start + 10h);
        done->set();
    });
    for (int turn = 0; turn < 1000; ++turn)
        std::this_thread::yield();
    QVERIFY(clock.now() < start + 1h);
    QVERIFY(done->waitUntil(base::Duration::max()));
    QVERIFY(clock.now() >= start + 10h);
    waiting.join();
}

/// Who sets an event and waits must not skip what the woken thread has not had the processor for
/// yet.
void TestSkippingClock::whoIsWokenWorksAtOnce()
{
    constexpr int rounds = 200;
    SkippingClock clock;
    const auto asked = clock.makeEvent();
    const auto answered = clock.makeEvent();
    std::vector<base::Duration> late;
    base::Duration askedAt{};
    std::thread other([&] {
        const ClockThread member(clock);
        answered->set();
        for (int round = 0; round < rounds; ++round) {
            asked->waitUntil(base::Duration::max());
            late.push_back(clock.now() - askedAt);
            answered->set();
        }
    });
    QVERIFY(answered->waitUntil(base::Duration::max()));
    for (int round = 0; round < rounds; ++round) {
        askedAt = clock.now();
        asked->set();
        QVERIFY(answered->waitUntil(clock.now() + 100h));
    }
    clock.removeThread();
    other.join();
    QVERIFY(*std::max_element(late.begin(), late.end()) < 1h);
}

void TestSkippingClock::aStopEndsASleep()
{
    SkippingClock clock;
    base::StopToken stop;
    const auto start = clock.now();
    const auto begun = clock.makeEvent();
    bool slept = true;
    std::thread sleeping([&] {
        const ClockThread member(clock);
        begun->set();
        slept = clock.sleepUntil(start + 10h, &stop);
    });
    QVERIFY(begun->waitUntil(base::Duration::max()));
    stop.request();
    sleeping.join(); // this thread counts as one that works
    QVERIFY(!slept);
    QVERIFY(clock.now() < start + 1h);
}

SERVODESK_GUILESS_TEST(TestSkippingClock)
#include "tst_skipping_clock.moc"
