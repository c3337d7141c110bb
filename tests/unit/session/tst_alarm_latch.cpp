// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms that came stay until they are acknowledged and over; silence is told from a lost reading.
#include "support/test_main.h"

#include "session_fixture.h"

using session::ActiveAlarm;
using session::AlarmLatch;
using session::LinkMonitor;
using namespace std::chrono_literals;

namespace {
const ActiveAlarm overload{QStringLiteral("overload"), 5, false};
const ActiveAlarm voltage{QStringLiteral("voltage"), 0, false};
const QString temperatureKey = QStringLiteral("present_temperature");
} // namespace

class TestAlarmLatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void alarmsStayUntilAcknowledged()
    {
        AlarmLatch latch;
        QCOMPARE(latch.update({overload}, 1s).size(), std::size_t(1));
        QVERIFY(latch.update({overload}, 2s).empty()); // nothing new
        const auto gone = latch.update({}, 3s);
        QCOMPARE(gone.size(), std::size_t(1));
        QVERIFY(!gone.front().raised);
        QCOMPARE(latch.alarms().size(), std::size_t(1));
        QVERIFY(!latch.alarms().front().active);
        latch.acknowledge();
        QVERIFY(latch.alarms().empty());
    }

    void firstSeenAndCount()
    {
        AlarmLatch latch;
        const QDateTime before = QDateTime::currentDateTime();
        latch.update({overload}, 1s);
        latch.update({voltage}, 2s);
        latch.update({voltage, overload}, 3s);
        const session::Alarm& alarm = latch.alarms().front();
        QCOMPARE(alarm.what, overload);
        QCOMPARE(alarm.count, 2);
        QVERIFY(alarm.firstAt == 1s);
        QVERIFY(alarm.latestAt == 3s);
        QVERIFY(alarm.firstSeen >= before);
        QVERIFY(alarm.active);
        QCOMPARE(latch.alarms().back().count, 1);
    }

    /// Acknowledging an alarm that goes on does not hide it; it goes when it is over.
    void anActiveAlarmClearsAfterItEnds()
    {
        AlarmLatch latch;
        latch.update({overload, voltage}, 1s);
        latch.update({overload}, 2s);
        latch.acknowledge();
        QCOMPARE(latch.alarms().size(), std::size_t(1));
        QVERIFY(latch.hasActive());
        latch.update({}, 3s);
        QVERIFY(latch.alarms().empty());
        latch.update({overload}, 4s); // a new one
        QVERIFY(!latch.alarms().front().acknowledged);
        QVERIFY(latch.alarms().front().firstAt == 4s);
    }

    void oneLostReadingIsNoTimeout()
    {
        LinkMonitor link;
        QCOMPARE(link.addReading(false, 1000ms), LinkMonitor::Transition::None);
        QCOMPARE(link.addReading(true, 1002ms), LinkMonitor::Transition::None);
        for (int i = 0; i < 3; ++i)
            QCOMPARE(link.addReading(false, 1010ms + i * 2ms), LinkMonitor::Transition::None);
        QCOMPARE(link.addReading(false, 1020ms),
                 LinkMonitor::Transition::Lost); // the fourth in a row
        QCOMPARE(link.addReading(false, 1030ms), LinkMonitor::Transition::None); // said once
        QVERIFY(link.silentSince() == base::Duration(1010ms));
        QCOMPARE(link.addReading(true, 1040ms), LinkMonitor::Transition::Back);
        QVERIFY(!link.isLost());
    }

    /// Rarely asked: two lost ones over more than a quarter of a second.
    void slowPollingNeedsFewerMisses()
    {
        LinkMonitor link;
        QCOMPARE(link.addReading(false, 1000ms), LinkMonitor::Transition::None);
        QCOMPARE(link.addReading(false, 1300ms), LinkMonitor::Transition::Lost);
        LinkMonitor quick;
        QCOMPARE(quick.addReading(false, 1000ms), LinkMonitor::Transition::None);
        QCOMPARE(quick.addReading(false, 1200ms), LinkMonitor::Transition::None);
    }

    /// Through the feed: seen, marked, kept after it is over, and gone when acknowledged.
    void aHotServoIsLatchedAndMarked()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        std::vector<recording::Mark> marks;
        connect(&fixture.workbench.polling(), &session::PollController::markAdded,
                &fixture.workbench, [&](const recording::Mark& mark) { marks.push_back(mark); });
        fixture.workbench.polling().subscribe(user, {{{ref, {temperatureKey}}}, {}});
        QTRY_VERIFY(fixture.raw(ref, temperatureKey));
        QVERIFY(fixture.entry(ref).alarms.alarms().empty());
        fixture.withBus([](sim::VirtualBus& bus) { bus.servo(1)->setTemperature(95); });
        QTRY_VERIFY(fixture.entry(ref).alarms.hasActive());
        const session::Alarm alarm = fixture.entry(ref).alarms.alarms().front();
        QCOMPARE(alarm.what.key, QStringLiteral("temperature"));
        QVERIFY(!alarm.what.derived);
        QCOMPARE(marks.back().kind, recording::MarkKind::Fault);
        QCOMPARE(marks.back().servoId, 1);
        QCOMPARE(marks.back().text, QStringLiteral("temperature"));
        fixture.workbench.registry().acknowledgeAlarms(ref);
        QCOMPARE(fixture.entry(ref).alarms.alarms().size(), std::size_t(1)); // it is still hot
        fixture.withBus([](sim::VirtualBus& bus) { bus.servo(1)->setTemperature(30); });
        fixture.workbench.link().powerCycle();
        QTRY_VERIFY(fixture.entry(ref).alarms.alarms().empty());
        QTRY_VERIFY(std::any_of(marks.begin(), marks.end(), [](const recording::Mark& mark) {
            return mark.kind == recording::MarkKind::FaultCleared;
        }));
    }

    /// An LX servo reports nothing: what its measurements say is latched alike, and said so.
    void aServoWithoutFaultBitsIsCheckedByItsLimits()
    {
        SessionFixture fixture(QStringLiteral("sim:lx"));
        QVERIFY(fixture.search(
            {.firstId = 1, .lastId = 5, .bauds = {}, .protocols = {base::Protocol::Lx}}));
        const ServoRef ref = fixture.at(3, base::Protocol::Lx); // over its temperature limit
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.entry(ref).alarms.hasActive());
        const session::Alarm& alarm = fixture.entry(ref).alarms.alarms().front();
        QVERIFY(alarm.what.derived);
        QCOMPARE(alarm.what.key, QStringLiteral("temperature"));
    }
};

SERVODESK_GUILESS_TEST(TestAlarmLatch)
#include "tst_alarm_latch.moc"
