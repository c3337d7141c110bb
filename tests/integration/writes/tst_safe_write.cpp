// SPDX-License-Identifier: GPL-3.0-or-later
// The safe write against the simulated bus: what is called kept survives power-off, what is called
// temporary does not, nothing else changes, the lock ends closed.
#include "device/writer.h"
#include "support/lost_acknowledgments.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using device::LockState;
using device::WriteItem;
using device::WriteOptions;
using device::WriteOutcome;
using support::SimFixture;

namespace {
const QString twoServos = QStringLiteral("sts3215@1,scs15@2");

std::size_t openIntents(SimFixture& fixture)
{
    return fixture.journal().open()->size();
}

base::Bytes wholeTable(SimFixture& fixture, int id)
{
    base::Bytes bytes;
    fixture.withBus([&](sim::VirtualBus& wire) {
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

    void savedSurvivesPowerOff_data();
    void savedSurvivesPowerOff();
    void temporaryIsLostAtPowerOff_data() { savedSurvivesPowerOff_data(); }
    void temporaryIsLostAtPowerOff();
    void temporaryClosesALockLeftOpen();
    void safeWriteClosesALockLeftOpen();
    void onlyTheNamedRegisterChanges();
    void bothLimitsGoInOneFrame();
    void refusedBeforeTheFirstByte_data();
    void refusedBeforeTheFirstByte();
    void readValueCanBeWrittenBack();
    void sramIsTemporary();
    void lockOfAnotherFamilyIsNeverWritten_data();
    void lockOfAnotherFamilyIsNeverWritten();
    void lostAcknowledgmentsAreHarmless();
    void responseLevelZero();
    void switchingTheResponseLevel_data();
    void switchingTheResponseLevel();
    void fullJournalWritesNothing();
    void torqueIsSwitchedOffOnRequest();
    void stopBetweenRegistersClosesTheLock();
    void silentServoIsNoAnswer();
    void aLooseContactLeavesNoLockOpen();
    void journalKeepsTheOldValue();
    void brownOutIsNotReportedSaved();
    void aReplacedServoIsNotVerified();
    void aPossiblyClosedLockIsNotReportedOpen_data();
    void aPossiblyClosedLockIsNotReportedOpen();
};

void TestSafeWrite::savedSurvivesPowerOff_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::newRow("STS, one byte") << 1 << "max_temperature" << 61;
    QTest::newRow("STS, two bytes") << 1 << "protection_current" << 311;
    QTest::newRow("SCS, one byte") << 2 << "max_temperature" << 62;
    QTest::newRow("SCS, two bytes") << 2 << "min_startup_force" << 300;
}

void TestSafeWrite::savedSurvivesPowerOff()
{
    QFETCH(int, id);
    QFETCH(QString, key);
    QFETCH(int, value);
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(id);
    const auto report = device::write(fixture.context(), servo, {{key, value}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes.size(), std::size_t(1));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(*report->writes[0].readBack, std::int64_t(value));
    QCOMPARE(report->lock, LockState::Closed);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.raw(id, QStringLiteral("lock")), 1);
    fixture.powerCycle();
    QCOMPARE(fixture.raw(id, key), std::int64_t(value));
    QCOMPARE(openIntents(fixture), std::size_t(0));
}

void TestSafeWrite::temporaryIsLostAtPowerOff()
{
    QFETCH(int, id);
    QFETCH(QString, key);
    QFETCH(int, value);
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(id);
    const std::int64_t before = fixture.raw(id, key);
    WriteOptions options;
    options.temporary = true;
    const auto report = device::write(fixture.context(), servo, {{key, value}}, options);
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(fixture.raw(id, key), std::int64_t(value));
    fixture.powerCycle();
    QCOMPARE(fixture.raw(id, key), before);
}

void TestSafeWrite::temporaryClosesALockLeftOpen()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    fixture.poke(1, QStringLiteral("lock"), 0);
    WriteOptions options;
    options.temporary = true;
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, options);
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QVERIFY(fixture.hasNotice(device::NoticeCode::LockFoundOpen));
    fixture.powerCycle();
    QCOMPARE(fixture.raw(1, QStringLiteral("max_temperature")), 70);
}

void TestSafeWrite::safeWriteClosesALockLeftOpen()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    fixture.poke(1, QStringLiteral("lock"), 0);
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report && report->isSuccessful());
    QVERIFY(fixture.hasNotice(device::NoticeCode::LockFoundOpen));
    QCOMPARE(fixture.raw(1, QStringLiteral("lock")), 1);
}

void TestSafeWrite::onlyTheNamedRegisterChanges()
{
    SimFixture fixture(twoServos);
    for (const int id : {1, 2}) {
        device::Servo servo = fixture.servo(id);
        const base::Bytes before = wholeTable(fixture, id);
        const auto report =
            device::write(fixture.context(), servo, {{QStringLiteral("position_p"), 17}}, {});
        QVERIFY(report && report->isSuccessful());
        const base::Bytes after = wholeTable(fixture, id);
        int changed = 0;
        for (std::size_t i = 0; i < before.size(); ++i)
            changed += before[i] != after[i] ? 1 : 0;
        QCOMPARE(changed, 1);
    }
}

void TestSafeWrite::bothLimitsGoInOneFrame()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    fixture.clearFrames();
    const auto report = device::write(
        fixture.context(), servo,
        {{QStringLiteral("max_angle_limit"), 3000}, {QStringLiteral("min_angle_limit"), 1000}}, {});
    QVERIFY(report && report->isSuccessful());
    // 1000 = E8 03, 3000 = B8 0B, at address 9.
    const base::Bytes frame = *base::fromHex(QStringLiteral("FF FF 01 07 03 09 E8 03 B8 0B 3D"));
    QVERIFY(std::find(fixture.tap().written.begin(), fixture.tap().written.end(), frame) !=
            fixture.tap().written.end());
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
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(id);
    WriteOptions options;
    options.consent = device::Consent::byTask(dangerous);
    const auto report = device::write(fixture.context(), servo, {{key, value}}, options);
    QVERIFY(!report);
    QCOMPARE(report.error().code, code);
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(openIntents(fixture), std::size_t(0));
}

void TestSafeWrite::readValueCanBeWrittenBack()
{
    SimFixture fixture(twoServos);
    fixture.poke(1, QStringLiteral("lock"), 0);
    fixture.poke(1, QStringLiteral("max_temperature"), 120); // beyond what the sheet allows
    fixture.poke(1, QStringLiteral("lock"), 1);
    fixture.runFor(std::chrono::milliseconds(50));
    device::Servo servo = fixture.servo(1);
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 120}}, {});
    QVERIFY(report && report->isSuccessful());
}

void TestSafeWrite::sramIsTemporary()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("torque_limit"), 500}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QCOMPARE(report->lock, LockState::None);
    QCOMPARE(fixture.raw(1, QStringLiteral("torque_limit")), 500);
}

void TestSafeWrite::lockOfAnotherFamilyIsNeverWritten_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("foreignLock");
    QTest::newRow("STS: 48 is its torque limit") << 1 << 48;
    QTest::newRow("SCS: 55 is undefined") << 2 << 55;
}

void TestSafeWrite::lockOfAnotherFamilyIsNeverWritten()
{
    QFETCH(int, id);
    QFETCH(int, foreignLock);
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(id);
    fixture.clearFrames();
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report && report->isSuccessful());
    for (const base::Bytes& frame : fixture.tap().written) {
        if (support::isWriteFrame(frame))
            QVERIFY(frame[5] != foreignLock);
    }
}

void TestSafeWrite::lostAcknowledgmentsAreHarmless()
{
    SimFixture fixture(twoServos);
    for (const int id : {1, 2}) {
        device::Servo servo = fixture.servo(id);
        support::dropAcknowledgments(fixture);
        const auto report =
            device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
        support::restoreReplies(fixture);
        QVERIFY(report);
        QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
        QCOMPARE(report->lock, LockState::Closed);
        QCOMPARE(fixture.raw(id, QStringLiteral("lock")), 1);
    }
}

void TestSafeWrite::responseLevelZero()
{
    SimFixture fixture(twoServos);
    for (const int id : {1, 2}) {
        fixture.poke(id, QStringLiteral("response_level"), 0);
        device::Servo servo = fixture.servo(id);
        const auto report =
            device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
        QVERIFY(report && report->isSuccessful());
        QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
        QCOMPARE(fixture.bus().statistics().total.timeouts, std::uint64_t(0));
    }
}

void TestSafeWrite::switchingTheResponseLevel_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::newRow("answers no more") << 1 << 0;
    QTest::newRow("replies again") << 0 << 1;
}

void TestSafeWrite::switchingTheResponseLevel()
{
    QFETCH(int, from);
    QFETCH(int, to);
    SimFixture fixture(twoServos);
    fixture.poke(1, QStringLiteral("response_level"), from);
    device::Servo servo = fixture.servo(1);
    WriteOptions options;
    options.consent = device::Consent::confirmed();
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("response_level"), to}}, options);
    QVERIFY(report && report->isSuccessful());
    QCOMPARE(fixture.raw(1, QStringLiteral("response_level")), to);
}

void TestSafeWrite::fullJournalWritesNothing()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    fixture.journal().setError(ErrorCode::DiskFull);
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::DiskFull);
    QVERIFY(fixture.onlyReadsSent());
}

void TestSafeWrite::torqueIsSwitchedOffOnRequest()
{
    SimFixture fixture(twoServos);
    fixture.poke(1, QStringLiteral("torque_switch"), 1);
    device::Servo servo = fixture.servo(1);
    WriteOptions options;
    options.consent = device::Consent::confirmed();
    const auto quiet =
        device::write(fixture.context(), servo, {{QStringLiteral("position_p"), 30}}, options);
    QVERIFY(quiet && quiet->isSuccessful());
    QCOMPARE(fixture.raw(1, QStringLiteral("torque_switch")), 1);
    const auto offset =
        device::write(fixture.context(), servo, {{QStringLiteral("position_offset"), 30}}, options);
    QVERIFY(offset && offset->isSuccessful());
    QCOMPARE(fixture.raw(1, QStringLiteral("torque_switch")), 0);
    QVERIFY(fixture.hasNotice(device::NoticeCode::TorqueSwitchedOff));
}

void TestSafeWrite::stopBetweenRegistersClosesTheLock()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    // The user stops while the first register is being written (address 13).
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 13)
            fixture.stop().request();
    };
    const auto report = device::write(
        fixture.context(), servo,
        {{QStringLiteral("max_temperature"), 61}, {QStringLiteral("position_p"), 30}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->writes[1].outcome, WriteOutcome::NotSent);
    QCOMPARE(report->writes[1].error->code, ErrorCode::Stopped);
    QCOMPARE(fixture.raw(1, QStringLiteral("position_p")), *report->writes[1].oldRaw);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(fixture.raw(1, QStringLiteral("lock")), 1);
}

void TestSafeWrite::silentServoIsNoAnswer()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 13)
            fixture.wireConfig().faults.muteIds = {1};
    };
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::NoReply);
    QVERIFY(!report->isSuccessful());
    QVERIFY(fixture.hasNotice(device::NoticeCode::LockLeftOpen));
    QCOMPARE(openIntents(fixture), std::size_t(1));
}

void TestSafeWrite::aLooseContactLeavesNoLockOpen()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    std::optional<base::Duration> lostAt;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        const base::Duration now = fixture.clock().now();
        if (frame[4] == support::Write && frame[5] == 13 && !lostAt)
            lostAt = now;
        const bool loose = lostAt && now - *lostAt < std::chrono::seconds(2);
        fixture.wireConfig().faults.dropRequest = loose ? 1 : 0;
    };
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report && lostAt);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::NoReply);
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(fixture.raw(1, QStringLiteral("lock")), 1);
}

void TestSafeWrite::journalKeepsTheOldValue()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    QVERIFY(device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {}));
    const auto entries = *fixture.journal().entries();
    QCOMPARE(entries.size(), std::size_t(1));
    QCOMPARE(entries[0].intent.items[0].oldRaw, 70);
    QCOMPARE(entries[0].intent.items[0].newRaw, 61);
    QCOMPARE(entries[0].end->outcome, QStringLiteral("done"));
}

void TestSafeWrite::brownOutIsNotReportedSaved()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    bool once = false;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        // The supply dips after the unlock: the lock closes by itself.
        if (frame[4] == support::Write && frame[5] == 13 && !std::exchange(once, true))
            fixture.powerCycle();
    };
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Unknown);
    QVERIFY(!report->isSuccessful());
    QCOMPARE(openIntents(fixture), std::size_t(1));
    fixture.powerCycle();
    QCOMPARE(fixture.raw(1, QStringLiteral("max_temperature")), 70);
}

/// After the value has arrived another servo of the kind is plugged in: what it shows is its own.
void TestSafeWrite::aReplacedServoIsNotVerified()
{
    SimFixture fixture(twoServos);
    device::Servo servo = fixture.servo(1);
    bool written = false;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        const bool readBack = frame[4] == support::Read && frame[5] <= 13 && written;
        written = written || (frame[4] == support::Write && frame[5] == 13);
        if (!readBack)
            return;
        written = false;
        fixture.powerCycle();
        fixture.poke(1, QStringLiteral("max_temperature"), 70);
    };
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].readBack, std::optional<std::int64_t>(70));
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Unknown);
    QVERIFY(!report->openIntent.isEmpty());
    QCOMPARE(openIntents(fixture), std::size_t(1));
}

void TestSafeWrite::aPossiblyClosedLockIsNotReportedOpen_data()
{
    QTest::addColumn<bool>("acknowledged");
    QTest::newRow("the reading is lost") << true;
    QTest::newRow("the acknowledgement as well") << false;
}

/// The servo has closed its lock; only what would show it gets lost.
void TestSafeWrite::aPossiblyClosedLockIsNotReportedOpen()
{
    QFETCH(bool, acknowledged);
    SimFixture fixture(QStringLiteral("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    const base::Bytes closes{0xFF, 0xFF, 0x01, 0x04, 0x03, 0x37, 0x01, 0xBF};
    bool sent = false;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        const bool now = frame == closes;
        if (sent || (now && !acknowledged))
            fixture.wireConfig().faults.drop = 1;
        sent = sent || now;
    };
    const auto report =
        device::write(fixture.context(), servo, {{QStringLiteral("max_temperature"), 61}}, {});
    QVERIFY(report && sent);
    QCOMPARE(fixture.raw(1, QStringLiteral("lock")), 1);
    QCOMPARE(report->lock, LockState::Unknown);
    QVERIFY(!report->isSuccessful());
    QVERIFY(fixture.hasNotice(device::NoticeCode::LockLeftOpen));
    QCOMPARE(openIntents(fixture), std::size_t(1));
}

SERVODESK_GUILESS_TEST(TestSafeWrite)
#include "tst_safe_write.moc"
