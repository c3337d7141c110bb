// SPDX-License-Identifier: GPL-3.0-or-later
// The safe write against the simulated bus: what is called kept survives power-off, what is called
// temporary does not, nothing else changes, the lock ends closed.
#include "device/writer.h"
#include "support/deaf_acks.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using device::LockState;
using device::WriteItem;
using device::WriteOptions;
using device::WriteOutcome;
using support::SimBench;

namespace {
const QString twoServos = QStringLiteral("sts3215@1,scs15@2");

bool noted(SimBench& bench, device::NoticeCode code)
{
    for (const device::Notice& notice : bench.notices()) {
        if (notice.code == code)
            return true;
    }
    return false;
}

std::size_t openIntents(SimBench& bench)
{
    return bench.journal().open()->size();
}

base::Bytes wholeTable(SimBench& bench, int id)
{
    base::Bytes bytes;
    bench.withWire([&](sim::VirtualBus& wire) {
        for (const catalog::Register& reg : wire.servo(id)->profile().registers) {
            if (reg.area == catalog::Area::Eprom || reg.area == catalog::Area::Sram)
                bytes.push_back(std::uint8_t(wire.servo(id)->raw(reg.key) & 0xFF));
        }
    });
    return bytes;
}
} // namespace

class TestSafeWrite : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void keptSurvivesPowerOff_data();
    void keptSurvivesPowerOff();
    void temporaryIsLostAtPowerOff_data() { keptSurvivesPowerOff_data(); }
    void temporaryIsLostAtPowerOff();
    void temporaryClosesALockLeftOpen();
    void safeWriteClosesALockLeftOpen();
    void onlyTheNamedRegisterChanges();
    void bothLimitsGoInOneFrame();
    void refusedBeforeTheFirstByte_data();
    void refusedBeforeTheFirstByte();
    void valueJustReadMayBeWrittenBack();
    void sramIsTemporary();
    void foreignLockIsNeverWritten_data();
    void foreignLockIsNeverWritten();
    void lostAcknowledgementsAreNoLoss();
    void responseLevelZero();
    void switchingTheResponseLevel_data();
    void switchingTheResponseLevel();
    void fullJournalWritesNothing();
    void torqueGoesOffWhereAsked();
    void stopBetweenRegistersClosesTheLock();
    void silentServoIsNoAnswer();
    void journalKeepsTheOldValue();
    void brownOutIsNotCalledKept();
    void anExchangedServoIsNotJudged();
    void aLockThatMayBeClosedIsNotCalledOpen_data();
    void aLockThatMayBeClosedIsNotCalledOpen();
};

void TestSafeWrite::keptSurvivesPowerOff_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::newRow("STS, one byte") << 1 << "max_temperature" << 61;
    QTest::newRow("STS, two bytes") << 1 << "protection_current" << 311;
    QTest::newRow("SCS, one byte") << 2 << "max_temperature" << 62;
    QTest::newRow("SCS, two bytes") << 2 << "min_startup_force" << 300;
}

void TestSafeWrite::keptSurvivesPowerOff()
{
    QFETCH(int, id);
    QFETCH(QString, key);
    QFETCH(int, value);
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(id);
    const auto report = device::write(bench.context(), servo, {{key, value}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes.size(), std::size_t(1));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(*report->writes[0].readBack, std::int64_t(value));
    QCOMPARE(report->lock, LockState::Closed);
    QVERIFY(report->allGood());
    QCOMPARE(bench.raw(id, QStringLiteral("lock")), 1);
    bench.powerCycle();
    QCOMPARE(bench.raw(id, key), std::int64_t(value));
    QCOMPARE(openIntents(bench), std::size_t(0));
}

void TestSafeWrite::temporaryIsLostAtPowerOff()
{
    QFETCH(int, id);
    QFETCH(QString, key);
    QFETCH(int, value);
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(id);
    const std::int64_t before = bench.raw(id, key);
    WriteOptions options;
    options.temporary = true;
    const auto report = device::write(bench.context(), servo, {{key, value}}, options);
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(bench.raw(id, key), std::int64_t(value));
    bench.powerCycle();
    QCOMPARE(bench.raw(id, key), before);
}

void TestSafeWrite::temporaryClosesALockLeftOpen()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    bench.poke(1, QStringLiteral("lock"), 0);
    WriteOptions options;
    options.temporary = true;
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, options);
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QVERIFY(noted(bench, device::NoticeCode::LockFoundOpen));
    bench.powerCycle();
    QCOMPARE(bench.raw(1, QStringLiteral("max_temperature")), 70);
}

void TestSafeWrite::safeWriteClosesALockLeftOpen()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    bench.poke(1, QStringLiteral("lock"), 0);
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report && report->allGood());
    QVERIFY(noted(bench, device::NoticeCode::LockFoundOpen));
    QCOMPARE(bench.raw(1, QStringLiteral("lock")), 1);
}

void TestSafeWrite::onlyTheNamedRegisterChanges()
{
    SimBench bench(twoServos);
    for (const int id : {1, 2}) {
        device::Servo servo = bench.servo(id);
        const base::Bytes before = wholeTable(bench, id);
        const auto report =
            device::write(bench.context(), servo, {{QStringLiteral("position_p"), 17}}, {});
        QVERIFY(report && report->allGood());
        const base::Bytes after = wholeTable(bench, id);
        int changed = 0;
        for (std::size_t i = 0; i < before.size(); ++i)
            changed += before[i] != after[i] ? 1 : 0;
        QCOMPARE(changed, 1);
    }
}

void TestSafeWrite::bothLimitsGoInOneFrame()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    bench.forgetFrames();
    const auto report = device::write(
        bench.context(), servo,
        {{QStringLiteral("max_angle_limit"), 3000}, {QStringLiteral("min_angle_limit"), 1000}}, {});
    QVERIFY(report && report->allGood());
    // 1000 = E8 03, 3000 = B8 0B, at address 9.
    const base::Bytes frame = *base::fromHex(QStringLiteral("FF FF 01 07 03 09 E8 03 B8 0B 3D"));
    QVERIFY(std::find(bench.tap().written.begin(), bench.tap().written.end(), frame) !=
            bench.tap().written.end());
}

void TestSafeWrite::refusedBeforeTheFirstByte_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::addColumn<bool>("dangerous");
    QTest::addColumn<base::ErrorCode>("code");
    const auto row = [](const char* name, int id, const char* key, int value, bool dangerous,
                        ErrorCode code) {
        QTest::newRow(name) << id << QString::fromLatin1(key) << value << dangerous << code;
    };
    row("unknown", 1, "nonsense", 1, false, ErrorCode::UnknownRegister);
    row("read-only", 1, "present_position", 1, false, ErrorCode::ReadOnly);
    row("factory", 1, "max_speed_limit", 1, true, ErrorCode::ReadOnly);
    row("above range", 1, "max_temperature", 101, false, ErrorCode::OutOfRange);
    row("below range", 1, "max_temperature", -1, false, ErrorCode::OutOfRange);
    row("limits crossed", 1, "min_angle_limit", 4095, false, ErrorCode::OutOfRange);
    row("no such enum value", 1, "response_level", 7, true, ErrorCode::OutOfRange);
    row("dangerous", 1, "phase", 12, false, ErrorCode::NeedsConsent);
    row("dangerous offset", 1, "position_offset", 5, false, ErrorCode::NeedsConsent);
    row("id", 1, "id", 5, true, ErrorCode::NotSupported);
    row("rate", 1, "baud_rate", 1, true, ErrorCode::NotSupported);
    row("torque on", 1, "torque_switch", 1, true, ErrorCode::NotSupported);
    row("centring", 1, "torque_switch", 128, true, ErrorCode::NotSupported);
    row("unlocking", 1, "lock", 0, true, ErrorCode::NotSupported);
    row("goal outside the limits", 2, "goal_position", 5, false, ErrorCode::OutOfRange);
    row("reserved on SCS", 2, "reserved_7", 1, true, ErrorCode::ReadOnly);
    row("8.5 of 11 rates only on SMS", 1, "baud_rate", 9, true, ErrorCode::NotSupported);
}

void TestSafeWrite::refusedBeforeTheFirstByte()
{
    QFETCH(int, id);
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(bool, dangerous);
    QFETCH(base::ErrorCode, code);
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(id);
    WriteOptions options;
    options.dangerous = dangerous;
    const auto report = device::write(bench.context(), servo, {{key, value}}, options);
    QVERIFY(!report);
    QCOMPARE(report.error().code, code);
    QVERIFY(bench.onlyAsked());
    QCOMPARE(openIntents(bench), std::size_t(0));
}

void TestSafeWrite::valueJustReadMayBeWrittenBack()
{
    SimBench bench(twoServos);
    bench.poke(1, QStringLiteral("lock"), 0);
    bench.poke(1, QStringLiteral("max_temperature"), 120); // beyond what the sheet allows
    bench.poke(1, QStringLiteral("lock"), 1);
    bench.letTimePass(std::chrono::milliseconds(50));
    device::Servo servo = bench.servo(1);
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 120}}, {});
    QVERIFY(report && report->allGood());
}

void TestSafeWrite::sramIsTemporary()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("torque_limit"), 500}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QCOMPARE(report->lock, LockState::None);
    QCOMPARE(bench.raw(1, QStringLiteral("torque_limit")), 500);
}

void TestSafeWrite::foreignLockIsNeverWritten_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("foreignLock");
    QTest::newRow("STS: 48 is its torque limit") << 1 << 48;
    QTest::newRow("SCS: 55 is undefined") << 2 << 55;
}

void TestSafeWrite::foreignLockIsNeverWritten()
{
    QFETCH(int, id);
    QFETCH(int, foreignLock);
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(id);
    bench.forgetFrames();
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report && report->allGood());
    for (const base::Bytes& frame : bench.tap().written) {
        if (support::isChange(frame))
            QVERIFY(frame[5] != foreignLock);
    }
}

void TestSafeWrite::lostAcknowledgementsAreNoLoss()
{
    SimBench bench(twoServos);
    for (const int id : {1, 2}) {
        device::Servo servo = bench.servo(id);
        support::loseAcknowledgements(bench);
        const auto report =
            device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
        support::hearEverything(bench);
        QVERIFY(report);
        QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
        QCOMPARE(report->lock, LockState::Closed);
        QCOMPARE(bench.raw(id, QStringLiteral("lock")), 1);
    }
}

void TestSafeWrite::responseLevelZero()
{
    SimBench bench(twoServos);
    for (const int id : {1, 2}) {
        bench.poke(id, QStringLiteral("response_level"), 0);
        device::Servo servo = bench.servo(id);
        const auto report =
            device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
        QVERIFY(report && report->allGood());
        QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
        QCOMPARE(bench.bus().statistics().total.timeOuts, std::uint64_t(0));
    }
}

void TestSafeWrite::switchingTheResponseLevel_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::newRow("answers no more") << 1 << 0;
    QTest::newRow("answers again") << 0 << 1;
}

void TestSafeWrite::switchingTheResponseLevel()
{
    QFETCH(int, from);
    QFETCH(int, to);
    SimBench bench(twoServos);
    bench.poke(1, QStringLiteral("response_level"), from);
    device::Servo servo = bench.servo(1);
    WriteOptions options;
    options.dangerous = true;
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("response_level"), to}}, options);
    QVERIFY(report && report->allGood());
    QCOMPARE(bench.raw(1, QStringLiteral("response_level")), to);
}

void TestSafeWrite::fullJournalWritesNothing()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    bench.journal().failWith(ErrorCode::DiskFull);
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::DiskFull);
    QVERIFY(bench.onlyAsked());
}

void TestSafeWrite::torqueGoesOffWhereAsked()
{
    SimBench bench(twoServos);
    bench.poke(1, QStringLiteral("torque_switch"), 1);
    device::Servo servo = bench.servo(1);
    WriteOptions options;
    options.dangerous = true;
    const auto quiet =
        device::write(bench.context(), servo, {{QStringLiteral("position_p"), 30}}, options);
    QVERIFY(quiet && quiet->allGood());
    QCOMPARE(bench.raw(1, QStringLiteral("torque_switch")), 1);
    const auto offset =
        device::write(bench.context(), servo, {{QStringLiteral("position_offset"), 30}}, options);
    QVERIFY(offset && offset->allGood());
    QCOMPARE(bench.raw(1, QStringLiteral("torque_switch")), 0);
    QVERIFY(noted(bench, device::NoticeCode::TorqueSwitchedOff));
}

void TestSafeWrite::stopBetweenRegistersClosesTheLock()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    // The user stops while the first register is being written (address 13).
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 13)
            bench.stop().request();
    };
    const auto report = device::write(
        bench.context(), servo,
        {{QStringLiteral("max_temperature"), 61}, {QStringLiteral("position_p"), 30}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->writes[1].outcome, WriteOutcome::NotSent);
    QCOMPARE(report->writes[1].error->code, ErrorCode::Stopped);
    QCOMPARE(bench.raw(1, QStringLiteral("position_p")), *report->writes[1].oldRaw);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(bench.raw(1, QStringLiteral("lock")), 1);
}

void TestSafeWrite::silentServoIsNoAnswer()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 13)
            bench.wireConfig().faults.muteIds = {1};
    };
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::NoAnswer);
    QVERIFY(!report->allGood());
    QVERIFY(noted(bench, device::NoticeCode::LockLeftOpen));
    QCOMPARE(openIntents(bench), std::size_t(1));
}

void TestSafeWrite::journalKeepsTheOldValue()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    QVERIFY(device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {}));
    const auto entries = *bench.journal().entries();
    QCOMPARE(entries.size(), std::size_t(1));
    QCOMPARE(entries[0].intent.items[0].oldRaw, 70);
    QCOMPARE(entries[0].intent.items[0].newRaw, 61);
    QCOMPARE(entries[0].end->outcome, QStringLiteral("done"));
}

void TestSafeWrite::brownOutIsNotCalledKept()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    bool once = false;
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        // The supply dips after the unlock: the lock closes by itself.
        if (frame[4] == support::Write && frame[5] == 13 && !std::exchange(once, true))
            bench.powerCycle();
    };
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Unknown);
    QVERIFY(!report->allGood());
    QCOMPARE(openIntents(bench), std::size_t(1));
    bench.powerCycle();
    QCOMPARE(bench.raw(1, QStringLiteral("max_temperature")), 70);
}

/// After the value has arrived another servo of the kind is plugged in: what it shows is its own.
void TestSafeWrite::anExchangedServoIsNotJudged()
{
    SimBench bench(twoServos);
    device::Servo servo = bench.servo(1);
    bool written = false;
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        const bool readBack = frame[4] == support::Read && frame[5] <= 13 && written;
        written = written || (frame[4] == support::Write && frame[5] == 13);
        if (!readBack)
            return;
        written = false;
        bench.powerCycle();
        bench.poke(1, QStringLiteral("max_temperature"), 70);
    };
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].readBack, std::optional<std::int64_t>(70));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Unknown);
    QVERIFY(!report->openIntent.isEmpty());
    QCOMPARE(openIntents(bench), std::size_t(1));
}

void TestSafeWrite::aLockThatMayBeClosedIsNotCalledOpen_data()
{
    QTest::addColumn<bool>("acknowledged");
    QTest::newRow("the reading is lost") << true;
    QTest::newRow("the acknowledgement as well") << false;
}

/// The servo has closed its lock; only what would show it gets lost.
void TestSafeWrite::aLockThatMayBeClosedIsNotCalledOpen()
{
    QFETCH(bool, acknowledged);
    SimBench bench(QStringLiteral("sts3215@1"));
    device::Servo servo = bench.servo(1);
    const base::Bytes closes{0xFF, 0xFF, 0x01, 0x04, 0x03, 0x37, 0x01, 0xBF};
    bool sent = false;
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        const bool now = frame == closes;
        if (sent || (now && !acknowledged))
            bench.wireConfig().faults.drop = 1;
        sent = sent || now;
    };
    const auto report =
        device::write(bench.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report && sent);
    QCOMPARE(bench.raw(1, QStringLiteral("lock")), 1);
    QCOMPARE(report->lock, LockState::Unknown);
    QVERIFY(!report->allGood());
    QVERIFY(noted(bench, device::NoticeCode::LockLeftOpen));
    QCOMPARE(openIntents(bench), std::size_t(1));
}

QTEST_GUILESS_MAIN(TestSafeWrite)
#include "tst_safe_write.moc"
