// SPDX-License-Identifier: GPL-3.0-or-later
// New ID, new rate, centring, restore, reboot: the servo is followed to wherever it answers, and
// its lock is closed there.
#include "device/motion.h"
#include "jobs/change.h"
#include "support/deaf_acks.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using device::LockState;
using device::WriteOutcome;
using support::SimBench;
using namespace std::chrono_literals;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

bool noted(SimBench& bench, device::NoticeCode code)
{
    for (const device::Notice& notice : bench.notices()) {
        if (notice.code == code)
            return true;
    }
    return false;
}

int locksOpen(SimBench& bench)
{
    return bench.withWire([](sim::VirtualBus& wire) {
        int open = 0;
        for (sim::VirtualServo* servo : wire.servos())
            open += servo->raw(text("lock")) == 0 ? 1 : 0;
        return open;
    });
}
} // namespace

class TestChanges : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void newIdIsKept_data();
    void newIdIsKept();
    void takenIdIsRefused();
    void aStopNamesTheServoThatIsThere();
    void impossibleIds_data();
    void impossibleIds();
    void lostIdRequestIsSentAgain();
    void silenceAfterTheNewIdIsWaitedFor();
    void newRateIsKept_data();
    void newRateIsKept();
    void rateTheAdapterCannot();
    void rateTheSeriesHasNot();
    void centring_data();
    void centring();
    void centringOnScs();
    void restoring();
    void restoringChangesTheRate();
    void rebooting_data();
    void rebooting();
    void fullJournal();
};

void TestChanges::newIdIsKept_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<bool>("acksLost");
    QTest::addColumn<int>("level");
    for (const char* model : {"sts3215@1", "scs15@1", "sm40blhv@1:1000000"}) {
        QTest::addRow("%s", model) << text(model) << false << 1;
        QTest::addRow("%s, every acknowledgement lost", model) << text(model) << true << 1;
        QTest::addRow("%s, response level 0", model) << text(model) << false << 0;
    }
}

void TestChanges::newIdIsKept()
{
    QFETCH(QString, servo);
    QFETCH(bool, acksLost);
    QFETCH(int, level);
    SimBench bench(servo);
    bench.poke(1, text("response_level"), level);
    device::Servo one = bench.servo(1);
    if (acksLost)
        support::loseAcknowledgements(bench);
    bench.forgetFrames();
    const auto report = jobs::changeId(bench.context(), one, 9);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(one.id, 9);
    QCOMPARE(locksOpen(bench), 0);
    int idWrites = 0;
    for (const base::Bytes& frame : bench.tap().written)
        idWrites += frame[4] == support::Write && frame[5] == 5 ? 1 : 0;
    QCOMPARE(idWrites, 1);
    bench.powerCycle();
    QCOMPARE(bench.raw(9, text("id")), 9);
    QCOMPARE(bench.journal().open()->size(), std::size_t(0));
}

void TestChanges::takenIdIsRefused()
{
    SimBench bench(text("sts3215@1,sts3215@2,sts3215@3,sts3215@3"));
    device::Servo one = bench.servo(1);
    for (const int taken : {2, 3}) { // 3 is taken twice: a collision is an answer too
        bench.forgetFrames();
        const auto report = jobs::changeId(bench.context(), one, taken);
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::IdInUse);
        QVERIFY(bench.onlyAsked());
    }
}

/// While the new ID is asked for, the servo still has its old one.
void TestChanges::aStopNamesTheServoThatIsThere()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[2] == 9)
            bench.stop().request();
    };
    const auto report = jobs::changeId(bench.context(), one, 9);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Stopped);
    QCOMPARE(report.error().id, 1);
}

void TestChanges::impossibleIds_data()
{
    QTest::addColumn<int>("id");
    QTest::newRow("broadcast") << 254;
    QTest::newRow("header") << 255;
    QTest::newRow("negative") << -1;
    QTest::newRow("too large") << 1000;
}

void TestChanges::impossibleIds()
{
    QFETCH(int, id);
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    bench.forgetFrames();
    const auto report = jobs::changeId(bench.context(), one, id);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::OutOfRange);
    QCOMPARE(bench.frameCount(), std::size_t(0));
}

void TestChanges::lostIdRequestIsSentAgain()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    int writes = 0;
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        const bool idWrite = frame[4] == support::Write && frame[5] == 5;
        writes += idWrite ? 1 : 0;
        bench.wireConfig().faults.dropRequest = idWrite && writes == 1 ? 1.0 : 0.0;
    };
    const auto report = jobs::changeId(bench.context(), one, 9);
    QVERIFY(report && report->allGood());
    QCOMPARE(writes, 2);
    QCOMPARE(one.id, 9);
}

/// The ID has changed and the lock is open when the line falls silent for half a second.
void TestChanges::silenceAfterTheNewIdIsWaitedFor()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    base::Duration silentUntil{};
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 5)
            silentUntil = bench.clock().now() + 500ms;
        else
            bench.wireConfig().faults.drop = bench.clock().now() < silentUntil ? 1.0 : 0.0;
    };
    const auto report = jobs::changeId(bench.context(), one, 9);
    QVERIFY(report && report->allGood());
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(one.id, 9);
    QCOMPARE(locksOpen(bench), 0);
    QCOMPARE(bench.journal().open()->size(), std::size_t(0));
}

void TestChanges::newRateIsKept_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<int>("rate");
    QTest::addColumn<bool>("acksLost");
    QTest::newRow("STS 500000") << text("sts3215@1") << 500'000 << false;
    QTest::newRow("STS 38400") << text("sts3215@1") << 38'400 << false;
    QTest::newRow("STS 76800, every acknowledgement lost") << text("sts3215@1") << 76'800 << true;
    QTest::newRow("SCS 115200") << text("scs15@1:1000000") << 115'200 << false;
}

void TestChanges::newRateIsKept()
{
    QFETCH(QString, servo);
    QFETCH(int, rate);
    QFETCH(bool, acksLost);
    SimBench bench(servo);
    device::Servo one = bench.servo(1);
    if (acksLost)
        support::loseAcknowledgements(bench);
    const auto report = jobs::changeBaud(bench.context(), one, rate);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(one.baud, rate);
    QCOMPARE(bench.bus().baud(), rate);
    bench.powerCycle();
    QCOMPARE(bench.withWire([](sim::VirtualBus& wire) { return wire.servo(1)->baud(); }), rate);
    QCOMPARE(locksOpen(bench), 0);
}

void TestChanges::rateTheAdapterCannot()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    bench.tap().refusedRates = {250'000};
    bench.forgetFrames();
    const auto report = jobs::changeBaud(bench.context(), one, 250'000);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::RateUnsupported);
    QVERIFY(bench.onlyAsked());
    QCOMPARE(bench.bus().baud(), 1'000'000);
}

void TestChanges::rateTheSeriesHasNot()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    const auto report = jobs::changeBaud(bench.context(), one, 9'600); // code 10: SMS only
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::OutOfRange);
}

void TestChanges::centring_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<bool>("acksLost");
    QTest::addColumn<int>("level");
    for (const char* model : {"sts3215@1", "sm40blhv@1:1000000"}) {
        QTest::addRow("%s", model) << text(model) << false << 1;
        QTest::addRow("%s, every acknowledgement lost", model) << text(model) << true << 1;
        QTest::addRow("%s, response level 0", model) << text(model) << false << 0;
    }
}

void TestChanges::centring()
{
    QFETCH(QString, servo);
    QFETCH(bool, acksLost);
    QFETCH(int, level);
    SimBench bench(servo);
    bench.poke(1, text("response_level"), level);
    device::Servo one = bench.servo(1);
    {
        device::MoveOrder order;
        order.servo = &one;
        order.goal = text("1000");
        std::vector<device::MovePlan> plans{*device::planMove(bench.context(), order)};
        QVERIFY(device::sendMoves(bench.context(), plans, device::MoveHow::Write));
        QVERIFY(device::waitForArrival(bench.context(), plans, 20s, {}));
    }
    if (acksLost)
        support::loseAcknowledgements(bench);
    bench.forgetFrames();
    const auto report = jobs::center(bench.context(), one);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->lock, LockState::Closed);
    QVERIFY(std::abs(*report->positionAfter - 2048) <= 12);
    int sent = 0;
    for (const base::Bytes& frame : bench.tap().written)
        sent += frame[4] == support::Write && frame[5] == 40 && frame[6] == 128 ? 1 : 0;
    QCOMPARE(sent, 1);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    const auto entries = bench.journal().entries().value();
    QCOMPARE(entries.back().end->items.size(), std::size_t(1));
    QCOMPARE(entries.back().end->items[0].readBack, report->offsetAfter);
    QCOMPARE(entries.back().end->items[0].outcome, text("kept"));
    bench.powerCycle();
    QVERIFY(std::abs(bench.raw(1, text("present_position")) - 2048) <= 12);
    QCOMPARE(locksOpen(bench), 0);
}

void TestChanges::centringOnScs()
{
    SimBench bench(text("scs15@1"));
    device::Servo one = bench.servo(1);
    const auto report = jobs::center(bench.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NotSupported);
    QVERIFY(bench.onlyAsked());
}

void TestChanges::restoring()
{
    SimBench bench(text("sts3215@7"));
    device::Servo one = bench.servo(7);
    QVERIFY(device::write(bench.context(), one, {{text("max_temperature"), 55}}, {})->allGood());
    const auto report = jobs::restoreDefaults(bench.context(), one);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(bench.raw(7, text("max_temperature")), 70);
    QVERIFY(std::find(report->changed.begin(), report->changed.end(), text("max_temperature")) !=
            report->changed.end());
    QCOMPARE(report->newId, 7); // everything but the ID
    const auto entries = bench.journal().entries().value();
    for (const base::ItemEnd& end : entries.back().end->items)
        QCOMPARE(end.readBack, std::optional(bench.raw(7, end.key)));
    QVERIFY(entries.back().end->items.size() == entries.back().intent.items.size());
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(locksOpen(bench), 0);
}

void TestChanges::restoringChangesTheRate()
{
    SimBench bench(text("sts3215@7"));
    device::Servo one = bench.servo(7);
    QVERIFY(jobs::changeBaud(bench.context(), one, 115'200)->allGood());
    const auto report = jobs::restoreDefaults(bench.context(), one);
    QVERIFY(report);
    QCOMPARE(report->oldBaud, 115'200);
    QCOMPARE(report->newBaud, 1'000'000);
    QCOMPARE(one.baud, 1'000'000);
    QCOMPARE(locksOpen(bench), 0);
}

void TestChanges::rebooting_data()
{
    QTest::addColumn<int>("rate");
    QTest::newRow("1 M") << 1'000'000;
    QTest::newRow("the loader's rate") << 500'000;
}

void TestChanges::rebooting()
{
    QFETCH(int, rate);
    support::BenchOptions options;
    options.baud = rate;
    options.servoBaud = rate;
    SimBench bench(text("sts3215@1"), options);
    bench.poke(1, text("torque_limit"), 300);
    bench.poke(1, text("torque_switch"), 1);
    device::Servo one = bench.servo(1);
    bench.forgetFrames();
    base::Duration rebootAt{};
    base::Duration nextAt{};
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Reboot)
            rebootAt = bench.clock().now();
        else if (rebootAt.count() > 0 && nextAt.count() == 0)
            nextAt = bench.clock().now();
    };
    const auto took = jobs::reboot(bench.context(), one);
    QVERIFY(took);
    QVERIFY(*took >= 700 && *took <= 2300);
    QVERIFY(noted(bench, device::NoticeCode::TorqueSwitchedOff));
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000); // RAM reloaded
    // Nothing may be said to the loader, which listens at 500 kbaud.
    QVERIFY(nextAt - rebootAt >= (rate == 500'000 ? 2000ms : 700ms));
}

void TestChanges::fullJournal()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    bench.journal().failWith(ErrorCode::DiskFull);
    bench.forgetFrames();
    QCOMPARE(jobs::changeId(bench.context(), one, 9).error().code, ErrorCode::DiskFull);
    QCOMPARE(jobs::changeBaud(bench.context(), one, 500'000).error().code, ErrorCode::DiskFull);
    QCOMPARE(jobs::center(bench.context(), one).error().code, ErrorCode::DiskFull);
    QCOMPARE(jobs::restoreDefaults(bench.context(), one).error().code, ErrorCode::DiskFull);
    QVERIFY(bench.onlyAsked());
}

QTEST_GUILESS_MAIN(TestChanges)
#include "tst_changes.moc"
