// SPDX-License-Identifier: GPL-3.0-or-later
// New ID, new rate, centering, restore, reboot: the servo is followed to wherever it answers, and
// its lock is closed there.
#include "device/motion/motion.h"
#include "jobs/change/change.h"
#include "jobs/change/ordered_write.h"
#include "support/lost_acknowledgments.h"
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
int countOpenLocks(SimFixture& fixture)
{
    return fixture.withBus([](sim::VirtualBus& wire) {
        int open = 0;
        for (sim::VirtualServo* servo : wire.servos())
            open += servo->raw(utf8("lock")) == 0 ? 1 : 0;
        return open;
    });
}
} // namespace

class TestChanges : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void newIdIsSaved_data();
    void newIdIsSaved();
    void takenIdIsRefused();
    void aStopNamesThePresentServo();
    void impossibleIds_data();
    void impossibleIds();
    void lostIdRequestIsResent();
    void waitsOutSilenceAfterAnIdChange();
    void newRateIsSaved_data();
    void newRateIsSaved();
    void rateUnsupportedByTheAdapter();
    void rateUnsupportedByTheSeries();
    void centering_data();
    void centering();
    void centeringOnScs();
    void restoring();
    void restoringChangesTheRate();
    void rebooting_data();
    void rebooting();
    void fullJournalWritesNothing();
    void aMixtureNeedsConsentBeforeItsFirstByte();
    void aMixtureCanLeaveSpecialRegistersOut();
};

void TestChanges::newIdIsSaved_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<bool>("acksLost");
    QTest::addColumn<int>("level");
    for (const char* model : {"sts3215@1", "scs15@1", "sm40blhv@1:1000000"}) {
        QTest::addRow("%s", model) << utf8(model) << false << 1;
        QTest::addRow("%s, every acknowledgement lost", model) << utf8(model) << true << 1;
        QTest::addRow("%s, response level 0", model) << utf8(model) << false << 0;
    }
}

void TestChanges::newIdIsSaved()
{
    QFETCH(QString, servo);
    QFETCH(bool, acksLost);
    QFETCH(int, level);
    SimFixture fixture(servo);
    fixture.poke(1, utf8("response_level"), level);
    device::Servo one = fixture.servo(1);
    if (acksLost)
        support::dropAcknowledgments(fixture);
    fixture.clearFrames();
    const auto report = jobs::changeId(fixture.context(), one, 9);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(one.id, 9);
    QCOMPARE(countOpenLocks(fixture), 0);
    int idWrites = 0;
    for (const base::Bytes& frame : fixture.tap().written)
        idWrites += frame[4] == support::Write && frame[5] == 5 ? 1 : 0;
    QCOMPARE(idWrites, 1);
    fixture.powerCycle();
    QCOMPARE(fixture.raw(9, utf8("id")), 9);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(0));
}

void TestChanges::takenIdIsRefused()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2,sts3215@3,sts3215@3"));
    device::Servo one = fixture.servo(1);
    for (const int taken : {2, 3}) { // 3 is taken twice: a collision is an answer too
        fixture.clearFrames();
        const auto report = jobs::changeId(fixture.context(), one, taken);
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::IdInUse);
        QVERIFY(fixture.onlyReadsSent());
    }
}

/// While the new ID is checked, the servo still has its old one.
void TestChanges::aStopNamesThePresentServo()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[2] == 9)
            fixture.stop().request();
    };
    const auto report = jobs::changeId(fixture.context(), one, 9);
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
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    fixture.clearFrames();
    const auto report = jobs::changeId(fixture.context(), one, id);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::OutOfRange);
    QCOMPARE(fixture.frameCount(), std::size_t(0));
}

void TestChanges::lostIdRequestIsResent()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    int writes = 0;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        const bool idWrite = frame[4] == support::Write && frame[5] == 5;
        writes += idWrite ? 1 : 0;
        fixture.wireConfig().faults.dropRequest = idWrite && writes == 1 ? 1.0 : 0.0;
    };
    const auto report = jobs::changeId(fixture.context(), one, 9);
    QVERIFY(report && report->isSuccessful());
    QCOMPARE(writes, 2);
    QCOMPARE(one.id, 9);
}

/// The ID has changed and the lock is open when the line falls silent for half a second.
void TestChanges::waitsOutSilenceAfterAnIdChange()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    base::Duration silentUntil{};
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 5)
            silentUntil = fixture.clock().now() + 500ms;
        else
            fixture.wireConfig().faults.drop = fixture.clock().now() < silentUntil ? 1.0 : 0.0;
    };
    const auto report = jobs::changeId(fixture.context(), one, 9);
    QVERIFY(report && report->isSuccessful());
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(one.id, 9);
    QCOMPARE(countOpenLocks(fixture), 0);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(0));
}

void TestChanges::newRateIsSaved_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<int>("rate");
    QTest::addColumn<bool>("acksLost");
    QTest::newRow("STS 500000") << utf8("sts3215@1") << 500'000 << false;
    QTest::newRow("STS 38400") << utf8("sts3215@1") << 38'400 << false;
    QTest::newRow("STS 76800, every acknowledgement lost") << utf8("sts3215@1") << 76'800 << true;
    QTest::newRow("SCS 115200") << utf8("scs15@1:1000000") << 115'200 << false;
}

void TestChanges::newRateIsSaved()
{
    QFETCH(QString, servo);
    QFETCH(int, rate);
    QFETCH(bool, acksLost);
    SimFixture fixture(servo);
    device::Servo one = fixture.servo(1);
    if (acksLost)
        support::dropAcknowledgments(fixture);
    const auto report = jobs::changeBaud(fixture.context(), one, rate);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(one.baud, rate);
    QCOMPARE(fixture.bus().baud(), rate);
    fixture.powerCycle();
    QCOMPARE(fixture.withBus([](sim::VirtualBus& wire) { return wire.servo(1)->baud(); }), rate);
    QCOMPARE(countOpenLocks(fixture), 0);
}

void TestChanges::rateUnsupportedByTheAdapter()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    fixture.tap().refusedRates = {250'000};
    fixture.clearFrames();
    const auto report = jobs::changeBaud(fixture.context(), one, 250'000);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::RateUnsupported);
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(fixture.bus().baud(), 1'000'000);
}

void TestChanges::rateUnsupportedByTheSeries()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    const auto report = jobs::changeBaud(fixture.context(), one, 9'600); // code 10: SMS only
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::OutOfRange);
}

void TestChanges::centering_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<bool>("acksLost");
    QTest::addColumn<int>("level");
    for (const char* model : {"sts3215@1", "sm40blhv@1:1000000"}) {
        QTest::addRow("%s", model) << utf8(model) << false << 1;
        QTest::addRow("%s, every acknowledgement lost", model) << utf8(model) << true << 1;
        QTest::addRow("%s, response level 0", model) << utf8(model) << false << 0;
    }
}

void TestChanges::centering()
{
    QFETCH(QString, servo);
    QFETCH(bool, acksLost);
    QFETCH(int, level);
    SimFixture fixture(servo);
    fixture.poke(1, utf8("response_level"), level);
    device::Servo one = fixture.servo(1);
    {
        device::MoveCommand order;
        order.servo = &one;
        order.goal = utf8("1000");
        std::vector<device::MovePlan> plans{*device::planMove(fixture.context(), order)};
        QVERIFY(device::sendMoves(fixture.context(), plans, device::MoveMethod::Write));
        QVERIFY(device::waitForArrival(fixture.context(), plans, 20s, {}));
    }
    if (acksLost)
        support::dropAcknowledgments(fixture);
    fixture.clearFrames();
    const auto report = jobs::center(fixture.context(), one);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->lock, LockState::Closed);
    QVERIFY(std::abs(*report->positionAfter - 2048) <= 12);
    int sent = 0;
    for (const base::Bytes& frame : fixture.tap().written)
        sent += frame[4] == support::Write && frame[5] == 40 && frame[6] == 128 ? 1 : 0;
    QCOMPARE(sent, 1);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    const auto entries = fixture.journal().entries().value();
    QCOMPARE(entries.back().end->items.size(), std::size_t(1));
    QCOMPARE(entries.back().end->items[0].readBack, report->offsetAfter);
    QCOMPARE(entries.back().end->items[0].outcome, utf8("kept"));
    fixture.powerCycle();
    QVERIFY(std::abs(fixture.raw(1, utf8("present_position")) - 2048) <= 12);
    QCOMPARE(countOpenLocks(fixture), 0);
}

void TestChanges::centeringOnScs()
{
    SimFixture fixture(utf8("scs15@1"));
    device::Servo one = fixture.servo(1);
    const auto report = jobs::center(fixture.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NotSupported);
    QVERIFY(fixture.onlyReadsSent());
}

void TestChanges::restoring()
{
    SimFixture fixture(utf8("sts3215@7"));
    device::Servo one = fixture.servo(7);
    QVERIFY(
        device::write(fixture.context(), one, {{utf8("max_temperature"), 55}}, {})->isSuccessful());
    const auto report = jobs::restoreDefaults(fixture.context(), one);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(fixture.raw(7, utf8("max_temperature")), 70);
    QVERIFY(std::find(report->changed.begin(), report->changed.end(), utf8("max_temperature")) !=
            report->changed.end());
    QCOMPARE(report->newId, 7); // everything but the ID
    const auto entries = fixture.journal().entries().value();
    for (const base::ItemResult& end : entries.back().end->items)
        QCOMPARE(end.readBack, std::optional(fixture.raw(7, end.key)));
    QVERIFY(entries.back().end->items.size() == entries.back().intent.items.size());
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(countOpenLocks(fixture), 0);
}

void TestChanges::restoringChangesTheRate()
{
    SimFixture fixture(utf8("sts3215@7"));
    device::Servo one = fixture.servo(7);
    QVERIFY(jobs::changeBaud(fixture.context(), one, 115'200)->isSuccessful());
    const auto report = jobs::restoreDefaults(fixture.context(), one);
    QVERIFY(report);
    QCOMPARE(report->oldBaud, 115'200);
    QCOMPARE(report->newBaud, 1'000'000);
    QCOMPARE(one.baud, 1'000'000);
    QCOMPARE(countOpenLocks(fixture), 0);
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
    support::SimFixtureOptions options;
    options.baud = rate;
    options.servoBaud = rate;
    SimFixture fixture(utf8("sts3215@1"), options);
    fixture.poke(1, utf8("torque_limit"), 300);
    fixture.poke(1, utf8("torque_switch"), 1);
    device::Servo one = fixture.servo(1);
    fixture.clearFrames();
    base::Duration rebootAt{};
    base::Duration nextAt{};
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Reboot)
            rebootAt = fixture.clock().now();
        else if (rebootAt.count() > 0 && nextAt.count() == 0)
            nextAt = fixture.clock().now();
    };
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY(took);
    QVERIFY(*took >= 700 && *took <= 2300);
    QVERIFY(fixture.hasNotice(device::NoticeCode::TorqueSwitchedOff));
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000); // RAM reloaded
    // Nothing may be sent to the loader, which listens at 500 kbaud.
    QVERIFY(nextAt - rebootAt >= (rate == 500'000 ? 2000ms : 700ms));
}

void TestChanges::fullJournalWritesNothing()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    fixture.journal().setError(ErrorCode::DiskFull);
    fixture.clearFrames();
    QCOMPARE(jobs::changeId(fixture.context(), one, 9).error().code, ErrorCode::DiskFull);
    QCOMPARE(jobs::changeBaud(fixture.context(), one, 500'000).error().code, ErrorCode::DiskFull);
    QCOMPARE(jobs::center(fixture.context(), one).error().code, ErrorCode::DiskFull);
    QCOMPARE(jobs::restoreDefaults(fixture.context(), one).error().code, ErrorCode::DiskFull);
    QVERIFY(fixture.onlyReadsSent());
}

/// The new ID, which needs consent, would be written last.
void TestChanges::aMixtureNeedsConsentBeforeItsFirstByte()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    const std::vector<device::WriteItem> items{{utf8("id"), 9}, {utf8("position_p"), 40}};
    fixture.clearFrames();
    std::optional<device::WriteReport> report;
    const auto refused = jobs::writeInOrder(fixture.context(), one, items, {},
                                            jobs::SpecialRegisters::Write, report);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NeedsConsent);
    QCOMPARE(refused.error().registerKey, utf8("id"));
    QVERIFY(!report);
    QVERIFY(fixture.onlyReadsSent());

    device::WriteOptions options;
    options.consent = device::Consent::confirmed();
    const auto written = jobs::writeInOrder(fixture.context(), one, items, options,
                                            jobs::SpecialRegisters::Write, report);
    QVERIFY2(written, written ? "" : qPrintable(base::errorName(written.error().code)));
    QCOMPARE(report->writes.size(), std::size_t(2));
    QCOMPARE(one.id, 9);
    QCOMPARE(fixture.raw(9, utf8("position_p")), 40);
}

void TestChanges::aMixtureCanLeaveSpecialRegistersOut()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    fixture.clearFrames();
    std::optional<device::WriteReport> report;
    const auto refused =
        jobs::writeInOrder(fixture.context(), one, {{utf8("position_p"), 40}, {utf8("id"), 9}}, {},
                           jobs::SpecialRegisters::Refuse, report);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NotSupported);
    QCOMPARE(refused.error().detail, utf8("set-id"));
    QVERIFY(fixture.onlyReadsSent());

    const auto written = jobs::writeInOrder(fixture.context(), one, {{utf8("position_p"), 40}}, {},
                                            jobs::SpecialRegisters::Refuse, report);
    QVERIFY(written);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
}

SERVODESK_GUILESS_TEST(TestChanges)
#include "tst_changes.moc"
