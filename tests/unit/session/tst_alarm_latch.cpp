// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms that came stay until they are acknowledged and over; silence is told from a lost reading.
#include "session_bench.h"

using session::AlarmLatch;
using session::AlarmNow;
using session::LinkWatch;
using namespace std::chrono_literals;

namespace {
const AlarmNow overload{QStringLiteral("overload"), 5, false};
const AlarmNow voltage{QStringLiteral("voltage"), 0, false};
const QString temperatureKey = QStringLiteral("present_temperature");
} // namespace

class TestAlarmLatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void whatCameStaysUntilAcknowledged()
    {
        AlarmLatch latch;
        QCOMPARE(latch.update({overload}, 1s).size(), std::size_t(1));
        QVERIFY(latch.update({overload}, 2s).empty()); // nothing new
        const auto gone = latch.update({}, 3s);
        QCOMPARE(gone.size(), std::size_t(1));
        QVERIFY(!gone.front().came);
        QCOMPARE(latch.alarms().size(), std::size_t(1));
        QVERIFY(!latch.alarms().front().active);
        latch.acknowledge();
        QVERIFY(latch.alarms().empty());
    }

    void firstSeenAndHowOften()
    {
        AlarmLatch latch;
        const QDateTime before = QDateTime::currentDateTime();
        latch.update({overload}, 1s);
        latch.update({voltage}, 2s);
        latch.update({voltage, overload}, 3s);
        const session::Alarm& alarm = latch.alarms().front();
        QCOMPARE(alarm.what, overload);
        QCOMPARE(alarm.times, 2);
        QVERIFY(alarm.firstAt == 1s);
        QVERIFY(alarm.latestAt == 3s);
        QVERIFY(alarm.firstSeen >= before);
        QVERIFY(alarm.active);
        QCOMPARE(latch.alarms().back().times, 1);
    }

    /// Acknowledging an alarm that goes on does not hide it; it goes when it is over.
    void anActiveOneIsAcknowledgedWhenItIsOver()
    {
        AlarmLatch latch;
        latch.update({overload, voltage}, 1s);
        latch.update({overload}, 2s);
        latch.acknowledge();
        QCOMPARE(latch.alarms().size(), std::size_t(1));
        QVERIFY(latch.anyActive());
        latch.update({}, 3s);
        QVERIFY(latch.alarms().empty());
        latch.update({overload}, 4s); // a new one
        QVERIFY(!latch.alarms().front().acknowledged);
        QVERIFY(latch.alarms().front().firstAt == 4s);
    }

    void oneLostReadingIsNoSilence()
    {
        LinkWatch link;
        QCOMPARE(link.reading(false, 1000ms), LinkWatch::News::None);
        QCOMPARE(link.reading(true, 1002ms), LinkWatch::News::None);
        for (int i = 0; i < 3; ++i)
            QCOMPARE(link.reading(false, 1010ms + i * 2ms), LinkWatch::News::None);
        QCOMPARE(link.reading(false, 1020ms), LinkWatch::News::Lost); // the fourth in a row
        QCOMPARE(link.reading(false, 1030ms), LinkWatch::News::None); // said once
        QVERIFY(link.silentSince() == base::Duration(1010ms));
        QCOMPARE(link.reading(true, 1040ms), LinkWatch::News::Back);
        QVERIFY(!link.lost());
    }

    /// Rarely asked: two lost ones over more than a quarter of a second.
    void aSlowWatchNeedsNoFour()
    {
        LinkWatch link;
        QCOMPARE(link.reading(false, 1000ms), LinkWatch::News::None);
        QCOMPARE(link.reading(false, 1300ms), LinkWatch::News::Lost);
        LinkWatch quick;
        QCOMPARE(quick.reading(false, 1000ms), LinkWatch::News::None);
        QCOMPARE(quick.reading(false, 1200ms), LinkWatch::News::None);
    }

    /// Through the feed: seen, marked, kept after it is over, and gone when acknowledged.
    void aHotServoIsLatchedAndMarked()
    {
        Bench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        std::vector<record::Mark> marks;
        connect(&bench.desk, &Desk::marked, &bench.desk,
                [&](const record::Mark& mark) { marks.push_back(mark); });
        bench.desk.wish(user, {{{ref, {temperatureKey}}}, {}});
        QTRY_VERIFY(bench.raw(ref, temperatureKey));
        QVERIFY(bench.entry(ref).alarms.alarms().empty());
        bench.withWire([](sim::VirtualBus& bus) { bus.servo(1)->setTemperature(95); });
        QTRY_VERIFY(bench.entry(ref).alarms.anyActive());
        const session::Alarm alarm = bench.entry(ref).alarms.alarms().front();
        QCOMPARE(alarm.what.key, QStringLiteral("temperature"));
        QVERIFY(!alarm.what.derived);
        QCOMPARE(marks.back().kind, record::MarkKind::Fault);
        QCOMPARE(marks.back().servoId, 1);
        QCOMPARE(marks.back().text, QStringLiteral("temperature"));
        bench.desk.acknowledgeAlarms(ref);
        QCOMPARE(bench.entry(ref).alarms.alarms().size(), std::size_t(1)); // it is still hot
        bench.withWire([](sim::VirtualBus& bus) { bus.servo(1)->setTemperature(30); });
        bench.desk.powerCycle();
        QTRY_VERIFY(bench.entry(ref).alarms.alarms().empty());
        QTRY_VERIFY(std::any_of(marks.begin(), marks.end(), [](const record::Mark& mark) {
            return mark.kind == record::MarkKind::FaultOver;
        }));
    }

    /// An LX servo reports nothing: what its measurements say is latched alike, and said so.
    void aServoWithoutFaultReportIsJudgedByItsLimits()
    {
        Bench bench(QStringLiteral("sim:lx"));
        QVERIFY(bench.search(
            {.firstId = 1, .lastId = 5, .bauds = {}, .protocols = {base::Protocol::Lx}}));
        const ServoRef ref = bench.at(3, base::Protocol::Lx); // over its temperature limit
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        QVERIFY(bench.entry(ref).alarms.anyActive());
        const session::Alarm& alarm = bench.entry(ref).alarms.alarms().front();
        QVERIFY(alarm.what.derived);
        QCOMPARE(alarm.what.key, QStringLiteral("temperature"));
    }
};

QTEST_GUILESS_MAIN(TestAlarmLatch)
#include "tst_alarm_latch.moc"
