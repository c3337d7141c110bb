// SPDX-License-Identifier: GPL-3.0-or-later
// Waiting for a condition while events are processed. It is asked every few milliseconds, where Qt
// Test would sleep 50, and given up after a minute, which only a hung program needs: what a busy
// machine delays breaks no test. Qt Test's macros of the same names give way to these.
#pragma once

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QEvent>
#include <QtTest>

namespace support {
/// Of one wait, on the thread of the test.
class Patience {
public:
    /// Processes events and sleeps briefly; false when it is time to give up.
    bool waits()
    {
        constexpr int betweenMs = 2;
        if (m_end.hasExpired() || (QTest::runningTest() && QTest::currentTestFailed()))
            return false;
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QTest::qSleep(betweenMs);
        return true;
    }

private:
    static constexpr int longestMs = 60'000;
    QDeadlineTimer m_end{longestMs};
};

/// Whether `holds()` became true.
template <typename Condition>
bool waitFor(Condition holds)
{
    bool held = holds();
    for (Patience patience; !held && patience.waits();)
        held = holds();
    return held;
}
} // namespace support

#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE

#define QTRY_VERIFY(condition)                                                                     \
    do {                                                                                           \
        for (support::Patience patience_; !(condition) && patience_.waits();)                      \
            ;                                                                                      \
        QVERIFY(condition);                                                                        \
    } while (false)

#define QTRY_VERIFY2(condition, message)                                                           \
    do {                                                                                           \
        for (support::Patience patience_; !(condition) && patience_.waits();)                      \
            ;                                                                                      \
        QVERIFY2(condition, message);                                                              \
    } while (false)

#define QTRY_COMPARE(actual, expected)                                                             \
    do {                                                                                           \
        for (support::Patience patience_; !((actual) == (expected)) && patience_.waits();)         \
            ;                                                                                      \
        QCOMPARE(actual, expected);                                                                \
    } while (false)
