// SPDX-License-Identifier: GPL-3.0-or-later
// A restart is proven or not claimed: devices that ignore the command, acknowledge it and do
// nothing, restart before anybody can notice, or refuse it with an exception.
#include "jobs/change.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

using base::Bytes;
using base::ErrorCode;
using support::SimBench;
using namespace std::chrono_literals;

Q_DECLARE_METATYPE(base::Duration)

namespace {
const Bytes restartOf1{0xFF, 0xFF, 0x01, 0x02, 0x08, 0xF4};
const Bytes statusOf1{0xFF, 0xFF, 0x01, 0x02, 0x00, 0xFC};
const Bytes modbusRestartOf1{0x01, 0x41, 0xC0, 0x10};
const Bytes modbusIllegalFunction{0x01, 0xC1, 0x01, 0xB0, 0x50};

QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

/// How often the command was sent to a device that makes `reply` of it, and nothing else.
void replace(SimBench& bench, const Bytes& command, const Bytes& reply, int& heard)
{
    bench.tap().answerInstead = [command, reply, &heard](const Bytes& frame) {
        if (frame != command)
            return std::optional<Bytes>();
        ++heard;
        return std::optional(reply);
    };
}

bool noted(SimBench& bench, device::NoticeCode code)
{
    return std::any_of(bench.notices().begin(), bench.notices().end(),
                       [code](const device::Notice& notice) { return notice.code == code; });
}
} // namespace

class TestReboot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void restartIsProven_data();
    void restartIsProven();
    void ignoredCommandIsNoRestart_data();
    void ignoredCommandIsNoRestart();
    void lostCommandIsSentAgain();
    void acknowledgementIsNoRestart();
    void quickRestartIsProvenByRam_data();
    void quickRestartIsProvenByRam();
    void quickRestartWithoutMarkIsNotClaimed();
    void lostPingIsNoRestart();
    void exceptionFails();
    void limitThatWasLoweredIsTheMark();
    void aFullDiskIsNamedAndNothingRestarts();
    void aRestartThatCannotBeRecordedIsSaid();
};

void TestReboot::restartIsProven_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<base::Duration>("latency");
    QTest::addColumn<base::Duration>("timeout"); ///< the user's
    for (const char* servo : {"sts3215@1", "scs15@1:1000000", "sm40blhv@1:1000000"})
        QTest::addRow("%s", servo) << text(servo) << base::Duration(1ms) << base::Duration(25ms);
    for (const base::Duration latency : {1ms, 20ms, 40ms, 60ms, 100ms, 150ms}) {
        for (const base::Duration timeout : {25ms, 200ms}) {
            for (const char* servo : {"sts3215@1", "scs15@1:1000000"}) {
                QTest::addRow("%s, %d ms, time-out %d ms", servo, int(latency / 1ms),
                              int(timeout / 1ms))
                    << text(servo) << latency << timeout;
            }
        }
    }
}

void TestReboot::restartIsProven()
{
    QFETCH(QString, servo);
    QFETCH(base::Duration, latency);
    QFETCH(base::Duration, timeout);
    support::BenchOptions options;
    options.wire.adapterLatency = latency;
    SimBench bench(servo, options);
    bench.bus().setPatience(timeout);
    device::Servo one = bench.servo(1);
    const auto took = jobs::reboot(bench.context(), one);
    QVERIFY2(took, took ? "" : qPrintable(took.error().detail));
    QVERIFY(*took >= 700);
    QCOMPARE(bench.raw(1, text("lock")), 1);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    QCOMPARE(bench.journal().open()->size(), std::size_t(0));
}

void TestReboot::ignoredCommandIsNoRestart_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("mark");
    QTest::addColumn<int>("before");
    QTest::newRow("STS") << text("sts3215@1") << text("torque_limit") << 1000;
    QTest::newRow("SCS") << text("scs15@1:1000000") << text("goal_time") << 0;
}

void TestReboot::ignoredCommandIsNoRestart()
{
    QFETCH(QString, model);
    QFETCH(QString, mark);
    QFETCH(int, before);
    SimBench bench(model);
    device::Servo one = bench.servo(1);
    int heard = 0;
    replace(bench, restartOf1, {}, heard);
    const auto took = jobs::reboot(bench.context(), one);
    QVERIFY2(!took, "it has not restarted");
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, text("not-restarted"));
    QCOMPARE(heard, 2); // the first one may have been lost: reading proved that nothing happened
    QVERIFY(!noted(bench, device::NoticeCode::RebootedAfter));
    QCOMPARE(bench.raw(1, mark), before); // the mark is taken back
    QCOMPARE(bench.journal().open()->size(), std::size_t(0));
}

void TestReboot::lostCommandIsSentAgain()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    int heard = 0;
    bench.tap().answerInstead = [&heard](const Bytes& frame) {
        return frame == restartOf1 && ++heard == 1 ? std::optional(Bytes()) : std::nullopt;
    };
    QVERIFY(jobs::reboot(bench.context(), one));
    QCOMPARE(heard, 2);
    QVERIFY(noted(bench, device::NoticeCode::SentAgain));
}

void TestReboot::acknowledgementIsNoRestart()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    int heard = 0;
    replace(bench, restartOf1, statusOf1, heard);
    const auto took = jobs::reboot(bench.context(), one);
    QVERIFY(!took);
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, text("restart-acknowledged"));
    QCOMPARE(heard, 1);
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
    QCOMPARE(bench.journal().open()->size(), std::size_t(0));
}

void TestReboot::quickRestartIsProvenByRam_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("mark");
    QTest::addColumn<int>("atStart");
    QTest::newRow("torque limit") << text("sts3215@1") << text("torque_limit") << 1000;
    QTest::newRow("running time") << text("scs15@1:1000000") << text("goal_time") << 0;
}

void TestReboot::quickRestartIsProvenByRam()
{
    QFETCH(QString, model);
    QFETCH(QString, mark);
    QFETCH(int, atStart);
    SimBench bench(model);
    device::Servo one = bench.servo(1);
    bench.tap().answerInstead = [&bench](const Bytes& frame) {
        if (frame != restartOf1)
            return std::optional<Bytes>();
        bench.powerCycle();
        return std::optional(Bytes());
    };
    QVERIFY(jobs::reboot(bench.context(), one));
    QVERIFY(noted(bench, device::NoticeCode::RebootedAfter));
    QCOMPARE(bench.raw(1, mark), atStart);
    QCOMPARE(bench.journal().open()->size(), std::size_t(0));
}

void TestReboot::quickRestartWithoutMarkIsNotClaimed()
{
    SimBench bench(text("scs15@1:1000000")); // in motor mode it has no mark
    for (const char* limit : {"min_angle_limit", "max_angle_limit"})
        bench.poke(1, text(limit), 0);
    device::Servo one = bench.servo(1);
    bench.tap().answerInstead = [&bench](const Bytes& frame) {
        if (frame != restartOf1)
            return std::optional<Bytes>();
        bench.powerCycle();
        return std::optional(Bytes());
    };
    const auto took = jobs::reboot(bench.context(), one);
    QVERIFY(!took);
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, text("restart-unproven"));
}

/// The command is ignored, and the first PING after it gets lost: that is not a servo that was
/// away.
void TestReboot::lostPingIsNoRestart()
{
    for (const char* servo : {"sts3215@1", "scs15@1:1000000"}) {
        SimBench bench{text(servo)};
        device::Servo one = bench.servo(1);
        bool lost = false;
        bool sent = false;
        bench.tap().answerInstead = [&](const Bytes& frame) {
            const bool drop = frame == restartOf1 || (sent && !lost && frame[4] == support::Ping);
            lost = lost || (drop && sent && frame != restartOf1);
            sent = sent || frame == restartOf1;
            return drop ? std::optional(Bytes()) : std::nullopt;
        };
        const auto took = jobs::reboot(bench.context(), one);
        QVERIFY2(!took, servo);
        QCOMPARE(took.error().code, ErrorCode::Refused);
        QVERIFY(lost);
    }
}

void TestReboot::exceptionFails()
{
    support::BenchOptions options;
    options.baud = 115'200;
    SimBench bench(text("smsmb@1:115200"), options);
    device::Servo one = bench.servo(1, base::Protocol::Modbus);
    int heard = 0;
    replace(bench, modbusRestartOf1, modbusIllegalFunction, heard);
    const std::int64_t limit = bench.raw(1, text("torque_limit"));
    const auto took = jobs::reboot(bench.context(), one);
    QVERIFY2(!took, "refused in so many words");
    QCOMPARE(took.error().code, ErrorCode::Refused);
    QCOMPARE(took.error().detail, text("illegal-function"));
    QCOMPARE(heard, 1);
    QCOMPARE(bench.raw(1, text("torque_limit")), limit);
    QCOMPARE(bench.journal().open()->size(), std::size_t(0));
}

/// What differs from the power-on value by itself needs no write.
void TestReboot::limitThatWasLoweredIsTheMark()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("torque_limit"), 300);
    device::Servo one = bench.servo(1);
    bench.forgetFrames();
    QVERIFY(jobs::reboot(bench.context(), one));
    for (const Bytes& frame : bench.tap().written)
        QVERIFY(frame[4] != support::Write || frame[5] != 48);
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
}

/// Its mark could not be noted: a restart would prove nothing, and the servo is not to blame.
void TestReboot::aFullDiskIsNamedAndNothingRestarts()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    bench.journal().failWith(ErrorCode::DiskFull);
    bench.forgetFrames();
    const auto took = jobs::reboot(bench.context(), one);
    QVERIFY(!took);
    QCOMPARE(took.error().code, ErrorCode::DiskFull);
    QCOMPARE(bench.frames(support::Reboot), 0);
    QVERIFY(noted(bench, device::NoticeCode::TorqueStaysOff));
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
}

void TestReboot::aRestartThatCannotBeRecordedIsSaid()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    bench.tap().onWrite = [&bench](const Bytes& frame) {
        if (frame == restartOf1)
            bench.journal().failWith(ErrorCode::DiskFull);
    };
    QVERIFY(jobs::reboot(bench.context(), one));
    QVERIFY(noted(bench, device::NoticeCode::RebootedAfter));
    QVERIFY(noted(bench, device::NoticeCode::NotRecorded));
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
}

QTEST_GUILESS_MAIN(TestReboot)
#include "tst_reboot.moc"
