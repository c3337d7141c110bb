// SPDX-License-Identifier: GPL-3.0-or-later
// Every manoeuvre through adapters that hand replies over late: it ends right, says so, and leaves
// the lock closed; and an ID that is taken is never given away.
#include "jobs/change/change.h"
#include "jobs/scan/find_free_ids.h"
#include "support/commission_fixture.h"
#include "support/raw_servo_line.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using device::LockState;
using device::WriteOutcome;
using support::SimFixture;
using support::utf8;
using namespace std::chrono_literals;

namespace {
support::SimFixtureOptions late(base::Duration latency)
{
    support::SimFixtureOptions options;
    options.wire.adapterLatency = latency;
    return options;
}

bool closed(SimFixture& fixture, int id)
{
    return fixture.raw(id, utf8("lock")) == 1;
}

void links()
{
    QTest::addColumn<base::Duration>("latency");
    QTest::addColumn<base::Duration>("timeout"); ///< the user's; 0: none given
    for (const base::Duration latency : {1ms, 20ms, 40ms, 60ms, 100ms, 150ms}) {
        const auto ms = int(latency / 1ms);
        QTest::addRow("%d ms", ms) << latency << base::Duration();
        QTest::addRow("%d ms, time-out 200 ms", ms) << latency << base::Duration(200ms);
        QTest::addRow("%d ms, time-out 5 ms", ms) << latency << base::Duration(5ms);
    }
}
} // namespace

class TestSlowAdapter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void freeIdIsAssigned_data() { links(); }
    void freeIdIsAssigned();
    void aStallFreesNoId();
    void takenIdIsRefused_data() { links(); }
    void takenIdIsRefused();
    void takenIdIsNotSuggested_data() { links(); }
    void takenIdIsNotSuggested();
    void rateIsChanged_data() { links(); }
    void rateIsChanged();
    void defaultsAreRestored_data() { links(); }
    void defaultsAreRestored();
    void centerIsSet_data() { links(); }
    void centerIsSet();
    void batchIsCommissioned_data() { links(); }
    void batchIsCommissioned();
    void twoConnectedServosAreDetected_data() { links(); }
    void twoConnectedServosAreDetected();
    void lateEchoIsNoServo_data();
    void lateEchoIsNoServo();
    void fastLinkStaysFast();

private:
    /// As a command does it: the first word on the line is the one to the servo.
    device::Servo connect(SimFixture& fixture, int id)
    {
        QFETCH(base::Duration, timeout);
        if (timeout > 0ms)
            fixture.bus().setTimeout(timeout);
        return fixture.servo(id);
    }
};

void TestSlowAdapter::freeIdIsAssigned()
{
    QFETCH(base::Duration, latency);
    SimFixture fixture(utf8("sts3215@1"), late(latency));
    device::Servo servo = connect(fixture, 1);
    const auto report = jobs::changeId(fixture.context(), servo, 9);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(servo.id, 9);
    QVERIFY(closed(fixture, 9));
}

/// The computer is busy while the other servo replies, and every reply waits.
void TestSlowAdapter::aStallFreesNoId()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    device::Servo one = fixture.servo(1);
    fixture.clearFrames();
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[2] == 2)
            fixture.wireConfig().adapterLatency = 200ms;
    };
    const auto report = jobs::changeId(fixture.context(), one, 2);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::IdInUse);
    QVERIFY(fixture.onlyReadsSent());
}

void TestSlowAdapter::takenIdIsRefused()
{
    QFETCH(base::Duration, latency);
    SimFixture fixture(utf8("sts3215@1,sts3215@9"), late(latency));
    device::Servo servo = connect(fixture, 1);
    fixture.clearFrames();
    const auto report = jobs::changeId(fixture.context(), servo, 9);
    QVERIFY2(!report, "two servos with one ID");
    QCOMPARE(report.error().code, ErrorCode::IdInUse);
    QVERIFY(fixture.onlyReadsSent());
}

void TestSlowAdapter::takenIdIsNotSuggested()
{
    QFETCH(base::Duration, latency);
    SimFixture fixture(utf8("sts3215@1,sts3215@2,sts3215@4"), late(latency));
    const device::Servo servo = connect(fixture, 1);
    const auto proposed = jobs::findFreeIds(fixture.context(), servo.protocol, {2, 3, 4, 5, 6}, 2);
    QVERIFY(proposed);
    QCOMPARE(*proposed, (std::vector{3, 5}));
}

void TestSlowAdapter::rateIsChanged()
{
    QFETCH(base::Duration, latency);
    SimFixture fixture(utf8("sts3215@1"), late(latency));
    device::Servo servo = connect(fixture, 1);
    const auto report = jobs::changeBaud(fixture.context(), servo, 500'000);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(fixture.bus().baud(), 500'000);
    QVERIFY(closed(fixture, 1));
}

void TestSlowAdapter::defaultsAreRestored()
{
    QFETCH(base::Duration, latency);
    SimFixture fixture(utf8("sts3215@7"), late(latency));
    device::Servo servo = connect(fixture, 7);
    QVERIFY(jobs::changeBaud(fixture.context(), servo, 115'200)->isSuccessful());
    const auto report = jobs::restoreDefaults(fixture.context(), servo);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->newId, 7);
    QCOMPARE(report->newBaud, 1'000'000); // the factory's, which it is followed to
    QCOMPARE(report->lock, LockState::Closed);
    QVERIFY(closed(fixture, 7));
}

void TestSlowAdapter::centerIsSet()
{
    QFETCH(base::Duration, latency);
    SimFixture fixture(utf8("sts3215@1"), late(latency));
    device::Servo servo = connect(fixture, 1);
    const auto report = jobs::center(fixture.context(), servo);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->lock, LockState::Closed);
    QVERIFY(std::abs(*report->positionAfter - 2048) <= 12);
    QVERIFY(closed(fixture, 1));
}

/// Factory servos one after the other, all of it: settings, ID, rate, middle.
void TestSlowAdapter::batchIsCommissioned()
{
    QFETCH(base::Duration, latency);
    QFETCH(base::Duration, timeout);
    support::CommissionFixture line(utf8("sts3215@1,sts3215@1"));
    line.fixture.wireConfig().adapterLatency = latency;
    if (timeout > 0ms)
        line.fixture.bus().setTimeout(timeout);
    line.spec.baud = 500'000;
    line.spec.center = true;
    line.spec.settings = support::templateOf("sts3215", {{"position_p", 24}});
    line.spec.count = 2;
    const auto end = line.run();
    QVERIFY(end);
    QCOMPARE(*end, jobs::CommissionEnd::CountReached);
    for (std::size_t place : {0, 1}) {
        QCOMPARE(line.batch.rows[place].verdict, results::CommissionVerdict::Good);
        QCOMPARE(line.batch.rows[place].newId, 11 + int(place));
        const sim::VirtualServo& servo = line.servoAt(place);
        QCOMPARE(servo.id(), 11 + int(place));
        QCOMPARE(servo.baud(), 500'000);
        QCOMPARE(servo.raw(utf8("position_p")), 24);
        QCOMPARE(servo.raw(utf8("lock")), 1);
        QVERIFY2(line.spans[place] < 60s, qPrintable(QString::number(line.spans[place] / 1ms)));
    }
    QVERIFY(!line.hasSeen(jobs::CommissionStep::Blocked)); // it was alone all the time
    QCOMPARE(line.fixture.journal().open()->size(), std::size_t(0));
}

/// The second one is heard although it answers long after the search has asked on.
void TestSlowAdapter::twoConnectedServosAreDetected()
{
    QFETCH(base::Duration, latency);
    QFETCH(base::Duration, timeout);
    support::CommissionFixture line(utf8("sts3215@1,sts3215@253"));
    line.fixture.wireConfig().adapterLatency = latency;
    if (timeout > 0ms)
        line.fixture.bus().setTimeout(timeout);
    line.onView = [&](const jobs::CommissionView& view) {
        if (view.step == jobs::CommissionStep::Waiting && !line.isAnyPlugged()) {
            line.plug(0);
            line.plug(1);
        }
        if (view.step == jobs::CommissionStep::Blocked || view.step == jobs::CommissionStep::Unplug)
            line.fixture.stop().request();
        return true;
    };
    QVERIFY(line.run());
    QVERIFY(line.hasSeen(jobs::CommissionObstacle::DuplicateId));
    QVERIFY(line.fixture.onlyReadsSent());
}

void TestSlowAdapter::lateEchoIsNoServo_data()
{
    QTest::addColumn<base::Duration>("latency");
    QTest::addColumn<bool>("taken");
    for (const base::Duration latency : {1ms, 20ms, 30ms, 40ms, 60ms, 100ms, 150ms, 240ms}) {
        for (const bool taken : {false, true})
            QTest::addRow("%d ms, %s", int(latency / 1ms), taken ? "taken" : "free")
                << latency << taken;
    }
}

/// The echo of PING 9 reads like the reply of a servo 9 with a voltage alarm.
void TestSlowAdapter::lateEchoIsNoServo()
{
    QFETCH(base::Duration, latency);
    QFETCH(bool, taken);
    base::ManualClock clock;
    support::RawServoLine line;
    line.servos = {support::rawSts3215(1)};
    if (taken)
        line.servos.push_back(support::rawSts3215(9));
    line.adapterLatency = latency;
    line.echo = true;
    bus::BusCore bus(support::openRawServoLine(line, clock), protocol::feetechCodec(), clock);
    QVERIFY(bus.hasEcho());
    QVERIFY2(clock.now() < 600ms, qPrintable(QString::number(clock.now() / 1ms)));
    support::MemoryJournal journal;
    base::StopToken stop;
    device::Notices notices;
    const device::Context context{bus, support::builtInCatalog(), journal, stop, notices};
    auto servo = device::identify(context, 1);
    QVERIFY(servo);
    QCOMPARE(int(servo->status), 0);
    line.frames.clear();
    const auto report = jobs::changeId(context, *servo, 9);
    QCOMPARE(report.has_value(), !taken);
    QCOMPARE(line.servos[0].id, taken ? 1 : 9);
    if (taken) {
        QCOMPARE(report.error().code, ErrorCode::IdInUse);
        QCOMPARE(line.writeFrameCount(), 0);
        return;
    }
    QVERIFY(report->isSuccessful());
    QCOMPARE(line.servos[0].table[55], std::uint8_t(1)); // locked again
    QCOMPARE(int(bus.statistics().total.late), 0); // the echo has shown how late the adapter is
}

void TestSlowAdapter::fastLinkStaysFast()
{
    SimFixture fixture(utf8("sts3215@1"), late(1ms));
    device::Servo servo = fixture.servo(1);
    const base::Duration start = fixture.clock().now();
    QVERIFY(jobs::changeId(fixture.context(), servo, 9));
    const base::Duration took = fixture.clock().now() - start;
    // Of simulated time; half a second proves that the ID is free.
    QVERIFY2(took < 1050ms, qPrintable(QString::number(took / 1ms)));
}

SERVODESK_GUILESS_TEST(TestSlowAdapter)
#include "tst_slow_adapter.moc"
