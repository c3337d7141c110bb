// SPDX-License-Identifier: GPL-3.0-or-later
// A restart is proven or not claimed: devices that ignore the command, acknowledge it and do
// nothing, restart unnoticed, or refuse it with an exception.
#include "jobs/change/change.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

using base::Bytes;
using base::ErrorCode;
using support::SimFixture;
using support::utf8;
using namespace std::chrono_literals;

namespace {
const Bytes restartOf1{0xFF, 0xFF, 0x01, 0x02, 0x08, 0xF4};
const Bytes statusOf1{0xFF, 0xFF, 0x01, 0x02, 0x00, 0xFC};
const Bytes modbusRestartOf1{0x01, 0x41, 0xC0, 0x10};
const Bytes modbusIllegalFunction{0x01, 0xC1, 0x01, 0xB0, 0x50};

/// How often the command was sent to a device that makes `reply` of it, and nothing else.
void replace(SimFixture& fixture, const Bytes& command, const Bytes& reply, int& matchCount)
{
    fixture.tap().replyOverride = [command, reply, &matchCount](const Bytes& frame) {
        if (frame != command)
            return std::optional<Bytes>();
        ++matchCount;
        return std::optional(reply);
    };
}
} // namespace

class TestReboot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void restartIsVerified_data();
    void restartIsVerified();
    void ignoredCommandIsNoRestart_data();
    void ignoredCommandIsNoRestart();
    void lostCommandIsResent();
    void acknowledgmentIsNoRestart();
    void quickRestartIsDetectedByRam_data();
    void quickRestartIsDetectedByRam();
    void quickRestartWithoutMarkerIsNotReported();
    void lostPingIsNoRestart();
    void lateRepliesAreNoSilence_data();
    void lateRepliesAreNoSilence();
    void exceptionFails();
    void loweredLimitIsTheMarker();
    void aFullDiskIsReportedAndNothingRestarts();
    void anUnrecordedRestartIsReported();
};

void TestReboot::restartIsVerified_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<base::Duration>("latency");
    QTest::addColumn<base::Duration>("timeout"); ///< the user's
    for (const char* servo : {"sts3215@1", "scs15@1:1000000", "sm40blhv@1:1000000"})
        QTest::addRow("%s", servo) << utf8(servo) << base::Duration(1ms) << base::Duration(25ms);
    for (const base::Duration latency : {1ms, 20ms, 40ms, 60ms, 100ms, 150ms}) {
        for (const base::Duration timeout : {25ms, 200ms}) {
            for (const char* servo : {"sts3215@1", "scs15@1:1000000"}) {
                QTest::addRow("%s, %d ms, time-out %d ms", servo, int(latency / 1ms),
                              int(timeout / 1ms))
                    << utf8(servo) << latency << timeout;
            }
        }
    }
}

void TestReboot::restartIsVerified()
{
    QFETCH(QString, servo);
    QFETCH(base::Duration, latency);
    QFETCH(base::Duration, timeout);
    support::SimFixtureOptions options;
    options.wire.adapterLatency = latency;
    SimFixture fixture(servo, options);
    fixture.bus().setTimeout(timeout);
    device::Servo one = fixture.servo(1);
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY2(took, took ? "" : qPrintable(took.error().detail));
    QVERIFY(*took >= 700);
    QCOMPARE(fixture.raw(1, utf8("lock")), 1);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(0));
}

void TestReboot::ignoredCommandIsNoRestart_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("mark");
    QTest::addColumn<int>("before");
    QTest::newRow("STS") << utf8("sts3215@1") << utf8("torque_limit") << 1000;
    QTest::newRow("SCS") << utf8("scs15@1:1000000") << utf8("goal_time") << 0;
}

void TestReboot::ignoredCommandIsNoRestart()
{
    QFETCH(QString, model);
    QFETCH(QString, mark);
    QFETCH(int, before);
    SimFixture fixture(model);
    device::Servo one = fixture.servo(1);
    int matchCount = 0;
    replace(fixture, restartOf1, {}, matchCount);
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY2(!took, "it has not restarted");
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, utf8("not-restarted"));
    QCOMPARE(matchCount,
             2); // the first one may have been lost: reading proved that nothing happened
    QVERIFY(!fixture.hasNotice(device::NoticeCode::RebootedAfter));
    QCOMPARE(fixture.raw(1, mark), before); // the mark is taken back
    QCOMPARE(fixture.journal().open()->size(), std::size_t(0));
}

void TestReboot::lostCommandIsResent()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    int matchCount = 0;
    fixture.tap().replyOverride = [&matchCount](const Bytes& frame) {
        return frame == restartOf1 && ++matchCount == 1 ? std::optional(Bytes()) : std::nullopt;
    };
    QVERIFY(jobs::reboot(fixture.context(), one));
    QCOMPARE(matchCount, 2);
    QVERIFY(fixture.hasNotice(device::NoticeCode::Resent));
}

void TestReboot::acknowledgmentIsNoRestart()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    int matchCount = 0;
    replace(fixture, restartOf1, statusOf1, matchCount);
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY(!took);
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, utf8("restart-acknowledged"));
    QCOMPARE(matchCount, 1);
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(0));
}

void TestReboot::quickRestartIsDetectedByRam_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("mark");
    QTest::addColumn<int>("atStart");
    QTest::newRow("torque limit") << utf8("sts3215@1") << utf8("torque_limit") << 1000;
    QTest::newRow("running time") << utf8("scs15@1:1000000") << utf8("goal_time") << 0;
}

void TestReboot::quickRestartIsDetectedByRam()
{
    QFETCH(QString, model);
    QFETCH(QString, mark);
    QFETCH(int, atStart);
    SimFixture fixture(model);
    device::Servo one = fixture.servo(1);
    fixture.tap().replyOverride = [&fixture](const Bytes& frame) {
        if (frame != restartOf1)
            return std::optional<Bytes>();
        fixture.powerCycle();
        return std::optional(Bytes());
    };
    QVERIFY(jobs::reboot(fixture.context(), one));
    QVERIFY(fixture.hasNotice(device::NoticeCode::RebootedAfter));
    QCOMPARE(fixture.raw(1, mark), atStart);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(0));
}

void TestReboot::quickRestartWithoutMarkerIsNotReported()
{
    SimFixture fixture(utf8("scs15@1:1000000")); // in motor mode it has no mark
    for (const char* limit : {"min_angle_limit", "max_angle_limit"})
        fixture.poke(1, utf8(limit), 0);
    device::Servo one = fixture.servo(1);
    fixture.tap().replyOverride = [&fixture](const Bytes& frame) {
        if (frame != restartOf1)
            return std::optional<Bytes>();
        fixture.powerCycle();
        return std::optional(Bytes());
    };
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY(!took);
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, utf8("restart-unproven"));
}

/// The command is ignored, and the first PING after it gets lost: that is not a servo that was
/// away.
void TestReboot::lostPingIsNoRestart()
{
    for (const char* servo : {"sts3215@1", "scs15@1:1000000"}) {
        SimFixture fixture{utf8(servo)};
        device::Servo one = fixture.servo(1);
        bool lost = false;
        bool sent = false;
        fixture.tap().replyOverride = [&](const Bytes& frame) {
            const bool drop = frame == restartOf1 || (sent && !lost && frame[4] == support::Ping);
            lost = lost || (drop && sent && frame != restartOf1);
            sent = sent || frame == restartOf1;
            return drop ? std::optional(Bytes()) : std::nullopt;
        };
        const auto took = jobs::reboot(fixture.context(), one);
        QVERIFY2(!took, servo);
        QCOMPARE(took.error().code, ErrorCode::Refused);
        QVERIFY(lost);
    }
}

void TestReboot::lateRepliesAreNoSilence_data()
{
    QTest::addColumn<base::Duration>("lateness");
    QTest::addColumn<int>("latePings");
    for (const int ms : {60, 90, 110, 130, 160, 200}) {
        QTest::addRow("two by %d ms", ms) << base::Duration(ms * 1ms) << 2;
        QTest::addRow("all by %d ms", ms) << base::Duration(ms * 1ms) << 100;
    }
}

/// The command is ignored, and a busy computer holds back the replies to PINGs: the servo was not
/// away.
void TestReboot::lateRepliesAreNoSilence()
{
    QFETCH(const base::Duration, lateness);
    QFETCH(const int, latePings);
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    bool sent = false;
    int pings = 0;
    fixture.tap().replyOverride = [&](const Bytes& frame) {
        const bool isRestart = frame == restartOf1;
        sent = sent || isRestart;
        if (sent && frame[4] == support::Ping)
            ++pings;
        const bool late = sent && pings <= latePings;
        fixture.wireConfig().adapterLatency = late ? lateness : base::Duration();
        return isRestart ? std::optional(Bytes()) : std::nullopt;
    };
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY(!took);
    QVERIFY(pings > 1);
    QCOMPARE(took.error().detail, utf8("not-restarted"));
}

void TestReboot::exceptionFails()
{
    support::SimFixtureOptions options;
    options.baud = 115'200;
    SimFixture fixture(utf8("smsmb@1:115200"), options);
    device::Servo one = fixture.servo(1, base::Protocol::Modbus);
    int matchCount = 0;
    replace(fixture, modbusRestartOf1, modbusIllegalFunction, matchCount);
    const std::int64_t limit = fixture.raw(1, utf8("torque_limit"));
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY2(!took, "refused in so many words");
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, utf8("illegal-function"));
    QCOMPARE(matchCount, 1);
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), limit);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(0));
}

/// What differs from the power-on value by itself needs no write.
void TestReboot::loweredLimitIsTheMarker()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("torque_limit"), 300);
    device::Servo one = fixture.servo(1);
    fixture.clearFrames();
    QVERIFY(jobs::reboot(fixture.context(), one));
    for (const Bytes& frame : fixture.tap().written)
        QVERIFY(frame[4] != support::Write || frame[5] != 48);
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
}

/// Its mark could not be noted: a restart would prove nothing, and the servo is not to blame.
void TestReboot::aFullDiskIsReportedAndNothingRestarts()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    fixture.journal().setError(ErrorCode::DiskFull);
    fixture.clearFrames();
    const auto took = jobs::reboot(fixture.context(), one);
    QVERIFY(!took);
    QCOMPARE(took.error().code, ErrorCode::DiskFull);
    QCOMPARE(fixture.frames(support::Reboot), 0);
    QVERIFY(fixture.hasNotice(device::NoticeCode::TorqueStaysOff));
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
}

void TestReboot::anUnrecordedRestartIsReported()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    fixture.tap().onWrite = [&fixture](const Bytes& frame) {
        if (frame == restartOf1)
            fixture.journal().setError(ErrorCode::DiskFull);
    };
    QVERIFY(jobs::reboot(fixture.context(), one));
    QVERIFY(fixture.hasNotice(device::NoticeCode::RebootedAfter));
    QVERIFY(fixture.hasNotice(device::NoticeCode::NotRecorded));
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

SERVODESK_GUILESS_TEST(TestReboot)
#include "tst_reboot.moc"
