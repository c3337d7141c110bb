// SPDX-License-Identifier: GPL-3.0-or-later
// ID, rate, middle, restart, restore, recovery and snapshots in every family: done and proven, or
// refused in one word before the first byte.
#include "device/motion/motion.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover.h"
#include "jobs/restore/take_snapshot.h"
#include "jobs/scan/scan_plan.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/device/fake_bus.h"

#include <QTest>

using base::ErrorCode;
using catalog::Role;
using device::LockState;
using device::NoticeCode;
using device::WriteOutcome;
using fake::DeviceFixture;
using protocol::Op;
using support::utf8;

class TestFamilyChanges : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void newIdIsSaved_data();
    void newIdIsSaved();
    void newIdSurvivesLostReplies_data() { newIdIsSaved_data(); }
    void newIdSurvivesLostReplies();
    void newIdThatNeverArrives_data() { newIdIsSaved_data(); }
    void newIdThatNeverArrives();
    void newIdThatIsIgnored();
    void factoryResetWithoutVisibleEffect();
    void newIdWithTheLinkCut_data() { newIdIsSaved_data(); }
    void newIdWithTheLinkCut();
    void invalidIds_data();
    void invalidIds();
    void idInUse_data();
    void idInUse();
    void newRate();
    void newRateAfterARestart();
    void onlyOneRate();
    void centering_data();
    void centering();
    void centerUnsupported_data();
    void centerUnsupported();
    void restart();
    void notInThisFamily_data();
    void notInThisFamily();
    void recovery_data();
    void recovery();
    void recoveryClosesEitherLock();
    void recoveryOfATrialOffset();
    void recoveryUsesTheRightProtocol();
    void undoRestoresTheServosValue();
    void anyProtocolBehindABridge();
    void snapshots_data();
    void snapshots();
};

void TestFamilyChanges::newIdIsSaved_data()
{
    QTest::addColumn<QString>("family");
    for (const char* family : {"STS", "SCS", "HLS", "SMCL", "SCS2", "SMSMB", "LX"})
        QTest::newRow(family) << family;
}

void TestFamilyChanges::newIdIsSaved()
{
    QFETCH(QString, family);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    const auto report = jobs::changeId(fixture.context(), servo, 9);
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Kept);
    QCOMPARE(report->lock, fixture.fake().has(Role::Lock) ? LockState::Closed : LockState::None);
    QVERIFY(report->isSuccessful());
    QCOMPARE(servo.id, 9);
    QCOMPARE(fixture.noticeCount(NoticeCode::IdChanged), 1);
    QVERIFY(fixture.fake().isLockClosed());
    QCOMPARE(fixture.openIntents(), std::size_t(0));
    fixture.fake().powerCycle();
    QCOMPARE(fixture.fake().id, 9);
}

void TestFamilyChanges::newIdSurvivesLostReplies()
{
    QFETCH(QString, family);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    fixture.bus.dropAcknowledgments = true;
    const auto report = jobs::changeId(fixture.context(), servo, 9);
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QVERIFY(fixture.fake().isLockClosed());
    fixture.fake().powerCycle();
    QCOMPARE(fixture.fake().id, 9);
}

void TestFamilyChanges::newIdThatNeverArrives()
{
    QFETCH(QString, family);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    const int place = servo.profile->byRole(Role::Id)->writeOffset;
    bool lost = false;
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        if (request.op == Op::Write && request.address == place && !lost) {
            lost = true;
            fixture.bus.lostWrites = 1;
        }
    };
    const auto report = jobs::changeId(fixture.context(), servo, 9);
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().id, 9);
    const bool lx = family == utf8("LX");
    QCOMPARE(fixture.noticeCount(NoticeCode::Resent), lx ? 1 : 0);
    QCOMPARE(fixture.noticeCount(NoticeCode::ReplyLostResent), lx ? 0 : 1);
}

/// Acknowledged, so no acknowledgement was lost.
void TestFamilyChanges::newIdThatIsIgnored()
{
    DeviceFixture fixture(utf8("STS"));
    device::Servo servo = fixture.servo();
    const int place = servo.profile->byRole(Role::Id)->writeOffset;
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        if (request.op == Op::Write && request.address == place)
            fixture.bus.ignoredWrites = 1;
    };
    const auto report = jobs::changeId(fixture.context(), servo, 9);
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Refused);
    QCOMPARE(fixture.noticeCount(NoticeCode::Resent), 1);
    QCOMPARE(fixture.noticeCount(NoticeCode::ReplyLostResent), 0);
}

void TestFamilyChanges::factoryResetWithoutVisibleEffect()
{
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().setPersistent(utf8("position_p"), 60);
    device::Servo servo = fixture.servo();
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        if (request.op == Op::Restore)
            fixture.bus.lostWrites = 1;
    };
    const auto report = jobs::restoreDefaults(fixture.context(), servo);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Uncertain);
    QCOMPARE(report.error().detail, utf8("nothing-changed"));
    QVERIFY(fixture.fake().isLockClosed());
    QCOMPARE(fixture.openIntents(), std::size_t(1));
}

void TestFamilyChanges::newIdWithTheLinkCut()
{
    QFETCH(QString, family);
    for (int passed = 0;; ++passed) {
        DeviceFixture fixture(family);
        device::Servo servo = fixture.servo();
        fixture.bus.cutAfter = passed;
        const auto report = jobs::changeId(fixture.context(), servo, 9);
        if (report && report->isSuccessful())
            return;
        if (fixture.fake().id != 1 || !fixture.fake().isLockClosed())
            QCOMPARE(fixture.openIntents(), std::size_t(1));
        if (fixture.openIntents() == 1) {
            // The cable is back: what was begun can be finished.
            fixture.bus.cutAfter = -1;
            const auto recovered = jobs::recover(fixture.context(), jobs::RecoveryAction::Finish);
            QVERIFY(recovered);
            QVERIFY(recovered->at(0).done);
            QCOMPARE(fixture.openIntents(), std::size_t(0));
            QVERIFY(fixture.fake().isLockClosed());
            fixture.fake().powerCycle();
            QCOMPARE(fixture.fake().id, 9);
        }
        QVERIFY2(passed < 200, "never ends");
    }
}

void TestFamilyChanges::invalidIds_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("range");
    QTest::newRow("everybody, LX") << "LX" << 254 << QStringLiteral("0 … 253");
    QTest::newRow("everybody, HLS") << "HLS" << 254 << QStringLiteral("0 … 253");
    QTest::newRow("everybody, Modbus") << "SMSMB" << 0 << QStringLiteral("1 … 247");
    QTest::newRow("reserved, Modbus") << "SMSMB" << 248 << QStringLiteral("1 … 247");
    QTest::newRow("negative") << "LX" << -1 << QStringLiteral("0 … 253");
}

void TestFamilyChanges::invalidIds()
{
    QFETCH(QString, family);
    QFETCH(int, id);
    QFETCH(QString, range);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    const auto report = jobs::changeId(fixture.context(), servo, id);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::OutOfRange);
    QCOMPARE(report.error().detail, range);
    QCOMPARE(report.error().registerKey, utf8("id"));
    QVERIFY(fixture.bus.requests.empty());
}

void TestFamilyChanges::idInUse_data()
{
    newIdIsSaved_data();
}

void TestFamilyChanges::idInUse()
{
    QFETCH(QString, family);
    const QByteArray name = family.toLatin1();
    DeviceFixture fixture{{name.constData(), 1}, {name.constData(), 9}};
    device::Servo servo = fixture.servo();
    const auto report = jobs::changeId(fixture.context(), servo, 9);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::IdInUse);
    QCOMPARE(fixture.bus.writes(), 0);
}

void TestFamilyChanges::newRate()
{
    DeviceFixture fixture(utf8("SMSMB"));
    device::Servo servo = fixture.servo();
    const auto report = jobs::changeBaud(fixture.context(), servo, 256'000);
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().persistentRaw(utf8("baud_rate")),
             std::int64_t(0)); // its own table of codes
    QCOMPARE(fixture.bus.baud(), 256'000);
    QCOMPARE(fixture.noticeCount(NoticeCode::RateChanged), 1);
    QVERIFY(fixture.fake().isLockClosed());
    const auto never = jobs::changeBaud(fixture.context(), servo, 1'000'000);
    QVERIFY(!never);
    QCOMPARE(never.error().code, ErrorCode::OutOfRange);
}

void TestFamilyChanges::newRateAfterARestart()
{
    DeviceFixture fixture(utf8("SMSMB"));
    fixture.fake().baudNeedsRestart = true;
    device::Servo servo = fixture.servo();
    const auto report = jobs::changeBaud(fixture.context(), servo, 9600);
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.noticeCount(NoticeCode::EffectiveAfterRestart), 1);
    QCOMPARE(fixture.bus.baud(), 115'200);
    fixture.fake().powerCycle();
    QCOMPARE(fixture.fake().baud, 9600);
}

void TestFamilyChanges::onlyOneRate()
{
    DeviceFixture fixture(utf8("LX"));
    device::Servo servo = fixture.servo();
    const auto report = jobs::changeBaud(fixture.context(), servo, 57'600);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NotSupported);
    QCOMPARE(report.error().detail, utf8("fixed-rate"));
    QVERIFY(fixture.bus.requests.empty());
}

void TestFamilyChanges::centering_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<bool>("acksLost");
    for (const bool lost : {false, true}) {
        QTest::addRow("HLS%s", lost ? ", answers lost" : "") << "HLS" << lost;
        QTest::addRow("Modbus%s", lost ? ", answers lost" : "") << "SMSMB" << lost;
    }
}

void TestFamilyChanges::centering()
{
    QFETCH(QString, family);
    QFETCH(bool, acksLost);
    DeviceFixture fixture(family);
    fixture.fake().poke(utf8("present_position"), 1000);
    fixture.fake().poke(utf8("torque_switch"), 1);
    device::Servo servo = fixture.servo();
    fixture.bus.dropAcknowledgments = acksLost;
    const auto report = jobs::center(fixture.context(), servo);
    QVERIFY(report);
    QCOMPARE(*report->positionBefore, std::int64_t(1000));
    QCOMPARE(*report->positionAfter, std::int64_t(2048));
    QCOMPARE(*report->offsetAfter, std::int64_t(1000 - 2048));
    QCOMPARE(report->lock, LockState::Closed);
    QVERIFY(fixture.fake().isLockClosed());
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(0));
    // HLS takes the instruction only, Modbus the fault reset only; neither gets 128 in its switch.
    int ways = 0;
    for (const protocol::Request& request : fixture.bus.requests) {
        const bool reset = request.op == Op::Write && request.address == 2 * 134;
        ways += request.op == Op::Calibrate || reset ? 1 : 0;
        if (request.op == Op::Write &&
            request.address == servo.profile->byRole(Role::TorqueSwitch)->writeOffset)
            QCOMPARE(int(request.data.back()), 0);
    }
    QCOMPARE(ways, 1);
    fixture.fake().powerCycle();
    QCOMPARE(fixture.fake().raw(utf8("position_offset")), std::int64_t(1000 - 2048));
}

void TestFamilyChanges::centerUnsupported_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("detail");
    QTest::newRow("SCS") << "SCS"
                         << "SCS";
    QTest::newRow("SCS-2") << "SCS2"
                           << "write position_offset";
    QTest::newRow("SMCL") << "SMCL"
                          << "write position_offset";
    QTest::newRow("LX") << "LX"
                        << "write angle_offset";
}

void TestFamilyChanges::centerUnsupported()
{
    QFETCH(QString, family);
    QFETCH(QString, detail);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    const auto report = jobs::center(fixture.context(), servo);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NotSupported);
    QCOMPARE(report.error().detail, detail);
    QVERIFY(fixture.bus.requests.empty());
}

void TestFamilyChanges::restart()
{
    for (const char* family : {"HLS", "SMCL", "SMSMB"}) {
        DeviceFixture fixture{{family, 1}};
        fixture.fake().poke(fixture.fake().profile->byRole(Role::GoalPosition)->key, 77);
        device::Servo servo = fixture.servo();
        const auto took = jobs::reboot(fixture.context(), servo);
        QVERIFY2(took, family);
        QVERIFY(*took >= 700);
        QCOMPARE(fixture.noticeCount(NoticeCode::RebootedAfter), 1);
        QCOMPARE(servo.raw(Role::GoalPosition), std::optional<std::int64_t>(0)); // read again
    }
}

void TestFamilyChanges::notInThisFamily_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<bool>("restore");
    QTest::addColumn<QString>("detail");
    QTest::newRow("LX restart") << "LX" << false << "no-reboot";
    QTest::newRow("LX restore") << "LX" << true << "no-restore";
    QTest::newRow("Modbus restore") << "SMSMB" << true << "no-restore";
}

void TestFamilyChanges::notInThisFamily()
{
    QFETCH(QString, family);
    QFETCH(bool, restore);
    QFETCH(QString, detail);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    base::Error error;
    if (restore)
        error = jobs::restoreDefaults(fixture.context(), servo).error();
    else
        error = jobs::reboot(fixture.context(), servo).error();
    QCOMPARE(error.code, ErrorCode::NotSupported);
    QCOMPARE(error.detail, detail);
    QVERIFY(fixture.bus.requests.empty());
}

void TestFamilyChanges::recovery_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::newRow("STS") << "STS"
                         << "max_temperature" << 61;
    QTest::newRow("HLS") << "HLS"
                         << "protection_current" << 311;
    QTest::newRow("SMCL") << "SMCL"
                          << "max_temperature" << 61;
    QTest::newRow("SCS-2") << "SCS2"
                           << "max_temperature" << 61;
    QTest::newRow("Modbus") << "SMSMB"
                            << "position_p" << 21;
    QTest::newRow("Modbus, factory block") << "SMSMB"
                                           << "max_temperature" << 61;
    QTest::newRow("LX") << "LX"
                        << "angle_limit_max" << 900;
    QTest::newRow("LX, saved by command") << "LX"
                                          << "angle_offset" << 20;
}

/// The link is cut after every possible number of requests; whatever was begun can be finished, and
/// can be undone, and then survives power-off.
void TestFamilyChanges::recovery()
{
    QFETCH(QString, family);
    QFETCH(QString, key);
    QFETCH(int, value);
    int interrupted = 0;
    for (const bool finish : {true, false}) {
        for (int passed = 0;; ++passed) {
            DeviceFixture fixture(family);
            device::Servo servo = fixture.servo();
            const auto before = fixture.fake().raw(key);
            fixture.bus.cutAfter = passed;
            const auto report = device::write(fixture.context(), servo, {{key, value}},
                                              {false, device::Consent::confirmed()});
            fixture.bus.cutAfter = -1;
            if (report && report->isSuccessful())
                break;
            if (fixture.openIntents() == 0)
                continue;
            ++interrupted;
            const auto recovered =
                jobs::recover(fixture.context(),
                              finish ? jobs::RecoveryAction::Finish : jobs::RecoveryAction::Undo);
            QVERIFY(recovered);
            QVERIFY(recovered->at(0).done);
            QCOMPARE(fixture.openIntents(), std::size_t(0));
            QVERIFY(fixture.fake().isLockClosed());
            fixture.fake().powerCycle();
            QCOMPARE(fixture.fake().raw(key), finish ? std::int64_t(value) : before);
        }
    }
    QVERIFY(interrupted >= 4);
}

void TestFamilyChanges::recoveryClosesEitherLock()
{
    for (const int open : {0, 128}) {
        DeviceFixture fixture(utf8("SMSMB"));
        device::Servo servo = fixture.servo();
        base::Intent intent;
        intent.servo = servo.identity();
        intent.lockOpened = true;
        intent.items = {{utf8("position_p"), 17, 0, 21}};
        QVERIFY(fixture.journal.begin(intent));
        fixture.fake().poke(utf8("lock"), open);
        const auto preview = jobs::recover(fixture.context(), jobs::RecoveryAction::Preview);
        QVERIFY(preview);
        QCOMPARE(preview->at(0).before.lockOpen, std::optional(true));
        QCOMPARE(fixture.bus.writes(), 0);
        QVERIFY(jobs::recover(fixture.context(), jobs::RecoveryAction::Undo));
        QCOMPARE(fixture.fake().raw(utf8("lock")), std::int64_t(1));
    }
}

/// 17 came through, 18 did not: it reads right, and would be gone at power-off.
void TestFamilyChanges::recoveryOfATrialOffset()
{
    DeviceFixture fixture(utf8("LX"));
    device::Servo servo = fixture.servo();
    base::Intent intent;
    intent.servo = servo.identity();
    intent.items = {{utf8("angle_offset"), 19, 0, 20}};
    QVERIFY(fixture.journal.begin(intent));
    fixture.fake().poke(utf8("angle_offset"), 20);
    const auto recovered = jobs::recover(fixture.context(), jobs::RecoveryAction::Finish);
    QVERIFY(recovered);
    QVERIFY(recovered->at(0).done);
    QCOMPARE(fixture.noticeCount(NoticeCode::SaveUnverified), 1);
    QCOMPARE(fixture.fake().persistentRaw(utf8("angle_offset")), std::int64_t(20));
}

void TestFamilyChanges::recoveryUsesTheRightProtocol()
{
    DeviceFixture fixture{{"STS", 1}, {"SMSMB", 1}, {"LX", 1}};
    device::Servo servo = fixture.servo(2);
    base::Intent intent;
    intent.servo = servo.identity();
    intent.items = {{utf8("temp_limit"), 25, 85, 71}};
    QVERIFY(fixture.journal.begin(intent));
    const auto recovered = jobs::recover(fixture.context(), jobs::RecoveryAction::Finish);
    QVERIFY(recovered);
    QVERIFY(recovered->at(0).done);
    QCOMPARE(fixture.fake(2).persistentRaw(utf8("temp_limit")), std::int64_t(71));
    for (const protocol::Request& request : fixture.bus.requests)
        QCOMPARE(request.protocol, base::Protocol::Lx);
}

void TestFamilyChanges::snapshots_data()
{
    newIdIsSaved_data();
}

void TestFamilyChanges::snapshots()
{
    QFETCH(QString, family);
    DeviceFixture fixture(family, 3);
    fixture.fake().repliesStoredMove = false;
    device::Servo servo = fixture.servo();
    const auto taken = jobs::takeSnapshot(fixture.context(), servo, utf8("test"));
    QVERIFY(taken);
    QCOMPARE(fixture.bus.writes(), 0);
    QCOMPARE(taken->servo.map, servo.profile->mapKey);
    QCOMPARE(taken->servo.protocol, base::protocolName(servo.protocol));
    // Through the file's format and back, with addresses as the sheet prints them.
    const auto read = snapshot::decodeSnapshot(snapshot::encodeSnapshot(*taken));
    QVERIFY(read);
    QCOMPARE(read->registers.size(), servo.profile->registers.size());
    for (const snapshot::SnapshotRegister& row : read->registers) {
        const catalog::Register& reg = fixture.fake().reg(row.key);
        QCOMPARE(row.address, reg.address);
        const bool silent = reg.role == Role::StoredGoal || reg.role == Role::StoredTime;
        QCOMPARE(row.raw, silent ? std::nullopt : std::optional(fixture.fake().raw(row.key)));
    }
}

/// LX: 4 V were set with other software; the program itself refuses that.
void TestFamilyChanges::undoRestoresTheServosValue()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().setPersistent(utf8("vin_limit_min"), 5000);
    device::Servo servo = fixture.servo();
    base::Intent intent;
    intent.servo = servo.identity();
    intent.items = {{utf8("vin_limit_min"), 23, 4000, 5000}};
    QVERIFY(fixture.journal.begin(intent));
    const auto recovered = jobs::recover(fixture.context(), jobs::RecoveryAction::Undo);
    QVERIFY(recovered);
    QVERIFY(recovered->at(0).done);
    QCOMPARE(fixture.fake().persistentRaw(utf8("vin_limit_min")), std::int64_t(4000));
    QCOMPARE(fixture.openIntents(), std::size_t(0));
}

void TestFamilyChanges::anyProtocolBehindABridge()
{
    DeviceFixture fixture(utf8("LX"));
    QCOMPARE(jobs::protocolsToScan(fixture.context(), {}, 1'000'000).size(), std::size_t(1));
    fixture.bus.bridge = true;
    QCOMPARE(jobs::protocolsToScan(fixture.context(), {}, 1'000'000).size(), std::size_t(3));
}

SERVODESK_GUILESS_TEST(TestFamilyChanges)
#include "tst_family_changes.moc"
