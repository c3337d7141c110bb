// SPDX-License-Identifier: GPL-3.0-or-later
// The safe write in every family: what is called kept survives power-off, a neighbor in the same
// block never changes, the lock ends closed, and what cannot be right is refused before the wire.
#include "device/writer.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QTest>

#include "fake_bus.h"

using base::ErrorCode;
using catalog::Role;
using device::LockState;
using device::NoticeCode;
using device::WriteItem;
using device::WriteOutcome;
using fake::DeviceFixture;
using support::utf8;

namespace {
/// Values written to this register, in order; blocks count by their first register.
std::vector<int> hasWriteTo(const DeviceFixture& fixture, const catalog::Register& reg)
{
    std::vector<int> values;
    for (const protocol::Request& request : fixture.bus.requests) {
        if (request.op == protocol::Op::Write && request.address == reg.writeOffset)
            values.push_back(request.data.empty() ? -1 : request.data.back());
    }
    return values;
}
} // namespace

class TestFamilyWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void savedSurvivesPowerOff_data();
    void savedSurvivesPowerOff();
    void lostAcknowledgments_data() { savedSurvivesPowerOff_data(); }
    void lostAcknowledgments();
    void responseLevelZero_data();
    void responseLevelZero();
    void writesThatNeverArrive_data() { savedSurvivesPowerOff_data(); }
    void writesThatNeverArrive();
    void linkCutAnywhere_data() { savedSurvivesPowerOff_data(); }
    void linkCutAnywhere();
    void temporaryIsLost_data();
    void temporaryIsLost();
    void temporaryWhereEveryWriteIsPermanent();
    void undocumentedPersistence();
    void neighborsInABlockAreKept_data();
    void neighborsInABlockAreKept();
    void aBlockGoesInOneFrame();
    void refusedBeforeSending_data();
    void refusedBeforeSending();
    void unusualVoltages();
    void eachAreaHasItsKey();
    void bothAreasInOneWrite();
    void theLockAddressComesFromTheMap_data();
    void theLockAddressComesFromTheMap();
    void exceptionsAreRefusals();
    void offsetNeedsConsentEvenForATrial();
    void anUnreadableMoveIsNotWrittenDirectly();
    void switchingTheModeStopsTheMotor();
    void faultResetClearsItself();
    void aLostFaultResetIsNotRefused();
    void anEmergencyEndsTheWrite();
    void aWrittenModeIsRecovered();
    void duplicateIdsAreNotWritten();
};

void TestFamilyWrites::savedSurvivesPowerOff_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::newRow("STS") << "STS"
                         << "max_temperature" << 61;
    QTest::newRow("HLS") << "HLS"
                         << "protection_current" << 311;
    QTest::newRow("SMCL") << "SMCL"
                          << "position_offset" << -300;
    QTest::newRow("SCS-2") << "SCS2"
                           << "min_startup_force" << 300;
    QTest::newRow("Modbus") << "SMSMB"
                            << "position_p" << 21;
    QTest::newRow("Modbus, signed") << "SMSMB"
                                    << "position_offset" << -5;
    QTest::newRow("Modbus, factory block") << "SMSMB"
                                           << "max_temperature" << 61;
    QTest::newRow("LX, one byte") << "LX"
                                  << "temp_limit" << 71;
    QTest::newRow("LX, half a block") << "LX"
                                      << "angle_limit_max" << 900;
    QTest::newRow("LX, voltage") << "LX"
                                 << "vin_limit_min" << 5000;
    QTest::newRow("LX, inverted LED") << "LX"
                                      << "led" << 1;
    QTest::newRow("LX, saved by command") << "LX"
                                          << "angle_offset" << -125;
}

void TestFamilyWrites::savedSurvivesPowerOff()
{
    QFETCH(QString, family);
    QFETCH(QString, key);
    QFETCH(int, value);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    const auto report = device::write(fixture.context(), servo, {{key, value}},
                                      {false, device::Consent::confirmed()});
    QVERIFY(report);
    QCOMPARE(report->writes.size(), std::size_t(1));
    QCOMPARE(device::outcomeName(report->writes[0].outcome), utf8("kept"));
    QCOMPARE(*report->writes[0].readBack, std::int64_t(value));
    QCOMPARE(report->lock, fixture.fake().has(Role::Lock) ? LockState::Closed : LockState::None);
    QVERIFY(report->isSuccessful());
    QVERIFY(fixture.fake().isLockClosed());
    QCOMPARE(fixture.openIntents(), std::size_t(0));
    QCOMPARE(fixture.noticeCount(NoticeCode::SaveUnverified), key == utf8("angle_offset") ? 1 : 0);
    fixture.fake().powerCycle();
    QCOMPARE(fixture.fake().raw(key), std::int64_t(value));
}

void TestFamilyWrites::lostAcknowledgments()
{
    QFETCH(QString, family);
    QFETCH(QString, key);
    QFETCH(int, value);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    fixture.bus.dropAcknowledgments = true;
    const auto report = device::write(fixture.context(), servo, {{key, value}},
                                      {false, device::Consent::confirmed()});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().persistentRaw(key), std::int64_t(value));
    QVERIFY(fixture.fake().isLockClosed());
    // Where nothing is ever acknowledged, nothing is lost.
    QCOMPARE(fixture.noticeCount(NoticeCode::ReplyLostButWritten), family == utf8("LX") ? 0 : 1);
    QCOMPARE(fixture.noticeCount(NoticeCode::ReplyLostResent), 0);
    QCOMPARE(fixture.noticeCount(NoticeCode::Resent), 0);
}

void TestFamilyWrites::responseLevelZero_data()
{
    QTest::addColumn<QString>("family");
    for (const char* family : {"STS", "SMS", "SCS", "HLS", "SMCL", "SCS2"})
        QTest::newRow(family) << family;
}

void TestFamilyWrites::responseLevelZero()
{
    QFETCH(QString, family);
    DeviceFixture fixture(family);
    fixture.fake().setPersistent(utf8("response_level"), 0);
    device::Servo servo = fixture.servo();
    const auto report =
        device::write(fixture.context(), servo, {{utf8("max_temperature"), 61}}, {});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().persistentRaw(utf8("max_temperature")), std::int64_t(61));
    QVERIFY(fixture.fake().isLockClosed());
    QVERIFY(fixture.notices.empty());
}

void TestFamilyWrites::writesThatNeverArrive()
{
    QFETCH(QString, family);
    QFETCH(QString, key);
    QFETCH(int, value);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    // The very frame that carries the value; the ones around it come through.
    const int place = fixture.fake().reg(key).block ? fixture.fake().reg(key).block->writeOffset
                                                    : fixture.fake().reg(key).writeOffset;
    bool lost = false;
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        if (request.op != protocol::Op::Write || request.address != place || lost)
            return;
        lost = true;
        fixture.bus.lostWrites = 1;
    };
    const auto report = device::write(fixture.context(), servo, {{key, value}},
                                      {false, device::Consent::confirmed()});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().persistentRaw(key), std::int64_t(value));
    const bool lx = family == utf8("LX");
    QCOMPARE(fixture.noticeCount(NoticeCode::Resent), lx ? 1 : 0);
    QCOMPARE(fixture.noticeCount(NoticeCode::ReplyLostResent), lx ? 0 : 1);
}

/// Whenever the link goes, either nothing has happened or the journal knows that something may
/// have.
void TestFamilyWrites::linkCutAnywhere()
{
    QFETCH(QString, family);
    QFETCH(QString, key);
    QFETCH(int, value);
    for (int passed = 0;; ++passed) {
        DeviceFixture fixture(family);
        device::Servo servo = fixture.servo();
        const auto before = fixture.fake().raw(key);
        fixture.bus.cutAfter = passed;
        const auto report = device::write(fixture.context(), servo, {{key, value}},
                                          {false, device::Consent::confirmed()});
        const bool done = report && report->isSuccessful();
        const bool touched = fixture.fake().raw(key) != before || !fixture.fake().isLockClosed();
        if (done) {
            QCOMPARE(fixture.fake().persistentRaw(key), std::int64_t(value));
            QCOMPARE(fixture.openIntents(), std::size_t(0));
            return;
        }
        if (touched)
            QCOMPARE(fixture.openIntents(), std::size_t(1));
        // The assumed lock may be unknown, but never closed where it is open.
        QVERIFY(servo.raw(Role::Lock) != 1 || fixture.fake().isLockClosed());
        QVERIFY2(passed < 200, "never ends");
    }
}

void TestFamilyWrites::temporaryIsLost_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::newRow("HLS") << "HLS"
                         << "max_temperature" << 61;
    QTest::newRow("SMCL") << "SMCL"
                          << "max_temperature" << 61;
    QTest::newRow("SCS-2") << "SCS2"
                           << "max_temperature" << 61;
    QTest::newRow("Modbus") << "SMSMB"
                            << "position_p" << 21;
    QTest::newRow("Modbus, factory block") << "SMSMB"
                                           << "max_temperature" << 61;
    QTest::newRow("LX offset, only tried") << "LX"
                                           << "angle_offset" << 30;
    QTest::newRow("LX speed, never kept") << "LX"
                                          << "motor_speed" << 100;
}

void TestFamilyWrites::temporaryIsLost()
{
    QFETCH(QString, family);
    QFETCH(QString, key);
    QFETCH(int, value);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    const auto before = fixture.fake().raw(key);
    const auto report = device::write(fixture.context(), servo, {{key, value}},
                                      {true, device::Consent::confirmed()});
    QVERIFY(report);
    QCOMPARE(device::outcomeName(report->writes[0].outcome), utf8("temporary"));
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().raw(key), std::int64_t(value));
    QCOMPARE(fixture.noticeCount(NoticeCode::SaveUnverified), 0);
    fixture.fake().powerCycle();
    QCOMPARE(fixture.fake().raw(key), before);
}

void TestFamilyWrites::temporaryWhereEveryWriteIsPermanent()
{
    DeviceFixture fixture(utf8("LX"));
    device::Servo servo = fixture.servo();
    const auto report =
        device::write(fixture.context(), servo, {{utf8("temp_limit"), 71}}, {true, {}});
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NotSupported);
    QCOMPARE(report.error().detail, utf8("always-kept"));
    QCOMPARE(report.error().registerKey, utf8("temp_limit"));
    QVERIFY(fixture.bus.requests.empty());
}

void TestFamilyWrites::undocumentedPersistence()
{
    DeviceFixture fixture(utf8("LX"));
    device::Servo servo = fixture.servo();
    const auto report = device::write(fixture.context(), servo, {{utf8("led_error"), 7}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QCOMPARE(fixture.noticeCount(NoticeCode::PersistenceUndocumented), 1);
}

void TestFamilyWrites::neighborsInABlockAreKept_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("neighbor");
    QTest::addColumn<int>("stays");
    QTest::newRow("minimum angle") << "angle_limit_min" << 100 << "angle_limit_max" << 900;
    QTest::newRow("maximum angle") << "angle_limit_max" << 800 << "angle_limit_min" << 17;
    QTest::newRow("minimum voltage") << "vin_limit_min" << 5000 << "vin_limit_max" << 11000;
    // A value read is never clamped, however odd.
    QTest::newRow("voltage beyond the sheet")
        << "vin_limit_min" << 5000 << "vin_limit_max" << 15000;
    QTest::newRow("motor speed") << "motor_speed" << -500 << "mode" << 0;
}

void TestFamilyWrites::neighborsInABlockAreKept()
{
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(QString, neighbor);
    QFETCH(int, stays);
    DeviceFixture fixture(utf8("LX"));
    device::Servo servo = fixture.servo();
    // Changed behind the program's back: what counts is what is read for the write.
    fixture.fake().setPersistent(neighbor, stays);
    const auto report = device::write(fixture.context(), servo, {{key, value}}, {});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().raw(key), std::int64_t(value));
    QCOMPARE(fixture.fake().raw(neighbor), std::int64_t(stays));
}

void TestFamilyWrites::aBlockGoesInOneFrame()
{
    DeviceFixture fixture(utf8("LX"));
    device::Servo servo = fixture.servo();
    const auto report =
        device::write(fixture.context(), servo,
                      {{utf8("angle_limit_max"), 900}, {utf8("angle_limit_min"), 100}}, {});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.bus.writes(), 1);
    const auto frame = std::find_if(
        fixture.bus.requests.begin(), fixture.bus.requests.end(),
        [](const protocol::Request& request) { return request.op == protocol::Op::Write; });
    // The worked frame of the sheet: angle limits 100–900.
    QCOMPARE(base::toHex(protocol::lxCodec().encode(*frame).value()),
             utf8("55 55 01 07 14 64 00 84 03 F8"));
}

void TestFamilyWrites::refusedBeforeSending_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("items"); ///< key=value, by blanks
    QTest::addColumn<QString>("blamed");
    const auto row = [](const char* name, const char* family, const char* items,
                        const char* blamed) { QTest::newRow(name) << family << items << blamed; };
    row("LX angle", "LX", "move_angle=1001", "move_angle");
    row("LX negative angle", "LX", "move_angle=-1", "move_angle");
    row("LX time", "LX", "move_angle=500 move_time=30001", "move_time");
    row("LX temperature below", "LX", "temp_limit=49", "temp_limit");
    row("LX temperature above", "LX", "temp_limit=101", "temp_limit");
    row("LX speed forward", "LX", "motor_speed=1001", "motor_speed");
    row("LX speed backward", "LX", "motor_speed=-1001", "motor_speed");
    row("LX mask", "LX", "led_error=8", "led_error");
    row("LX offset", "LX", "angle_offset=126", "angle_offset");
    row("LX offset, negative", "LX", "angle_offset=-126", "angle_offset");
    row("LX minimum equal to maximum", "LX", "angle_limit_min=1000", "angle_limit_min");
    row("LX limits both zero", "LX", "angle_limit_min=0 angle_limit_max=0", "angle_limit_min");
    row("LX limit above the scale", "LX", "angle_limit_max=1001", "angle_limit_max");
    row("LX voltage below", "LX", "vin_limit_min=4499", "vin_limit_min");
    row("LX voltage above", "LX", "vin_limit_max=14001", "vin_limit_max");
    row("LX voltages crossed", "LX", "vin_limit_min=9000 vin_limit_max=9000", "vin_limit_min");
    row("LX mode", "LX", "mode=2", "mode");
    row("Modbus limits crossed", "SMSMB", "min_angle_limit=2000 max_angle_limit=1999",
        "min_angle_limit");
    row("Modbus offset", "SMSMB", "position_offset=2048", "position_offset");
    row("Modbus voltages crossed", "SMSMB", "min_voltage=120 max_voltage=60", "min_voltage");
    row("Modbus factory row", "SMSMB", "max_temperature=101", "max_temperature");
    row("HLS current", "HLS", "protection_current=2048", "protection_current");
    row("SMCL offset", "SMCL", "position_offset=2048", "position_offset");
    row("SCS-2 offset", "SCS2", "position_offset=128", "position_offset");
}

void TestFamilyWrites::refusedBeforeSending()
{
    QFETCH(QString, family);
    QFETCH(QString, items);
    QFETCH(QString, blamed);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    std::vector<WriteItem> list;
    for (const QString& item : items.split(QLatin1Char(' ')))
        list.push_back(
            {item.section(QLatin1Char('='), 0, 0), item.section(QLatin1Char('='), 1).toLongLong()});
    const auto report =
        device::write(fixture.context(), servo, list, {false, device::Consent::confirmed()});
    QVERIFY(!report);
    QCOMPARE(base::errorName(report.error().code), base::errorName(ErrorCode::OutOfRange));
    QCOMPARE(report.error().registerKey, blamed);
    QCOMPARE(fixture.bus.writes(), 0);
    QVERIFY(fixture.journal.list.empty());
}

void TestFamilyWrites::unusualVoltages()
{
    DeviceFixture fixture(utf8("LX"));
    device::Servo servo = fixture.servo();
    const auto report =
        device::write(fixture.context(), servo, {{utf8("vin_limit_max"), 13000}}, {});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.noticeCount(NoticeCode::AboveRecommended), 1);
}

/// 0 opens what the EPROM holds, 128 the factory block, 1 closes either.
void TestFamilyWrites::eachAreaHasItsKey()
{
    for (const auto& [key, opens] :
         {std::pair{utf8("position_p"), 0}, std::pair{utf8("max_temperature"), 128}}) {
        DeviceFixture fixture(utf8("SMSMB"));
        device::Servo servo = fixture.servo();
        QVERIFY(device::write(fixture.context(), servo, {{key, 62}},
                              {false, device::Consent::confirmed()}));
        QCOMPARE(hasWriteTo(fixture, fixture.fake().reg(utf8("lock"))),
                 (std::vector<int>{opens, 1}));
    }
}

void TestFamilyWrites::bothAreasInOneWrite()
{
    DeviceFixture fixture(utf8("SMSMB"));
    device::Servo servo = fixture.servo();
    const auto report = device::write(
        fixture.context(), servo,
        {{utf8("max_temperature"), 61}, {utf8("torque_limit"), 500}, {utf8("position_p"), 21}},
        {false, device::Consent::confirmed()});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(hasWriteTo(fixture, fixture.fake().reg(utf8("lock"))),
             (std::vector<int>{0, 1, 128, 1}));
    fixture.fake().powerCycle();
    QCOMPARE(fixture.fake().raw(utf8("max_temperature")), std::int64_t(61));
    QCOMPARE(fixture.fake().raw(utf8("position_p")), std::int64_t(21));
    for (const device::WriteResult& result : report->writes)
        QCOMPARE(device::outcomeName(result.outcome),
                 result.key == utf8("torque_limit") ? utf8("temporary") : utf8("kept"));
}

void TestFamilyWrites::theLockAddressComesFromTheMap_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("address");
    QTest::newRow("HLS") << "HLS" << 55;
    QTest::newRow("SMCL") << "SMCL" << 48;
    QTest::newRow("SCS-2") << "SCS2" << 48;
}

void TestFamilyWrites::theLockAddressComesFromTheMap()
{
    QFETCH(QString, family);
    QFETCH(int, address);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    QVERIFY(device::write(fixture.context(), servo, {{utf8("max_temperature"), 61}}, {}));
    const int other = address == 48 ? 55 : 48;
    int opened = 0;
    for (const protocol::Request& request : fixture.bus.requests) {
        const bool write = request.op == protocol::Op::Write;
        opened += write && request.address == address ? 1 : 0;
        QVERIFY(!write || request.address != other);
    }
    QCOMPARE(opened, 2);
}

void TestFamilyWrites::exceptionsAreRefusals()
{
    DeviceFixture fixture(utf8("SMSMB"));
    device::Servo servo = fixture.servo();
    fixture.fake().exceptions[fixture.fake().reg(utf8("position_p")).writeOffset] = 3;
    const auto report = device::write(fixture.context(), servo, {{utf8("position_p"), 21}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Refused);
    QCOMPARE(report->writes[0].error->detail, utf8("illegal-value"));
    QCOMPARE(report->lock, LockState::Closed);
    QCOMPARE(fixture.openIntents(), std::size_t(0));
    // An explicit refusal: a second write changes nothing.
    QCOMPARE(hasWriteTo(fixture, fixture.fake().reg(utf8("position_p"))).size(), std::size_t(1));
}

void TestFamilyWrites::offsetNeedsConsentEvenForATrial()
{
    for (const bool temporary : {false, true}) {
        DeviceFixture fixture(utf8("LX"));
        device::Servo servo = fixture.servo();
        const auto report =
            device::write(fixture.context(), servo, {{utf8("angle_offset"), 20}}, {temporary, {}});
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::NeedsConsent);
        QVERIFY(fixture.bus.requests.empty());
    }
}

void TestFamilyWrites::anUnreadableMoveIsNotWrittenDirectly()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().repliesStoredMove = false;
    device::Servo servo = fixture.servo();
    const auto stored = device::write(fixture.context(), servo, {{utf8("wait_angle"), 500}}, {});
    QVERIFY(!stored);
    QCOMPARE(stored.error().code, ErrorCode::NotSupported);
    QCOMPARE(stored.error().detail, utf8("not-readable"));
    QCOMPARE(fixture.bus.writes(), 0);
    // A time alone would repeat the latest move.
    const auto timed = device::write(fixture.context(), servo, {{utf8("move_time"), 500}}, {});
    QVERIFY(!timed);
    QCOMPARE(timed.error().detail, utf8("with-goal"));
}

void TestFamilyWrites::switchingTheModeStopsTheMotor()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("motor_speed"), 400);
    fixture.fake().poke(utf8("load"), 1);
    device::Servo servo = fixture.servo();
    const auto both = device::write(fixture.context(), servo,
                                    {{utf8("mode"), 1}, {utf8("motor_speed"), 300}}, {});
    QVERIFY(!both);
    QCOMPARE(both.error().detail, utf8("mode-first"));
    QCOMPARE(fixture.bus.writes(), 0);
    const auto report = device::write(fixture.context(), servo, {{utf8("mode"), 1}}, {});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.fake().raw(utf8("mode")), std::int64_t(1));
    QCOMPARE(fixture.fake().raw(utf8("motor_speed")), std::int64_t(0));
    QCOMPARE(fixture.fake().raw(utf8("load")), std::int64_t(0));
    // Never for a moment in motor mode with a speed.
    for (const protocol::Request& request : fixture.bus.requests) {
        if (request.op == protocol::Op::Write && request.address == 8 * 29)
            QCOMPARE(base::toHex(request.data), utf8("01 00 00 00"));
    }
}

void TestFamilyWrites::faultResetClearsItself()
{
    DeviceFixture fixture(utf8("SMSMB"));
    device::Servo servo = fixture.servo();
    const auto report = device::write(fixture.context(), servo, {{utf8("fault_reset"), 1}}, {});
    QVERIFY(report);
    QCOMPARE(report->writes[0].outcome, WriteOutcome::Temporary);
    QVERIFY(report->isSuccessful());
    const auto center = device::write(fixture.context(), servo, {{utf8("fault_reset"), 5}}, {});
    QVERIFY(!center);
    QCOMPARE(center.error().detail, utf8("center"));
}

void TestFamilyWrites::aLostFaultResetIsNotRefused()
{
    DeviceFixture fixture(utf8("SMSMB"));
    device::Servo servo = fixture.servo();
    fixture.bus.dropAcknowledgments = true;
    const auto report = device::write(fixture.context(), servo, {{utf8("fault_reset"), 1}}, {});
    QVERIFY(report);
    QCOMPARE(device::outcomeName(report->writes[0].outcome), utf8("unknown"));
    QCOMPARE(base::errorName(report->writes[0].error->code), base::errorName(ErrorCode::Uncertain));
    QCOMPARE(fixture.noticeCount(NoticeCode::ReplyLostResent), 0);
}

/// A change of mode, with an emergency stop at every request: the lock is closed again, and
/// nothing but that is written afterwards.
void TestFamilyWrites::anEmergencyEndsTheWrite()
{
    for (int passed = 0;; ++passed) {
        DeviceFixture fixture(utf8("STS"));
        fixture.fake().poke(utf8("goal_speed"), 500);
        fixture.fake().poke(utf8("torque_switch"), 1);
        device::Servo servo = fixture.servo();
        int left = passed;
        bool met = false;
        QStringList after;
        fixture.bus.onRequest = [&](const protocol::Request& request) {
            if (met && request.op == protocol::Op::Write)
                after << QString::number(request.address);
            fixture.bus.emergencyPending = !met && left-- == 0;
            met |= fixture.bus.emergencyPending;
        };
        const auto report = device::write(
            fixture.context(), servo, {{utf8("max_temperature"), 61}, {utf8("operating_mode"), 1}},
            {false, device::Consent::confirmed()});
        if (!met) {
            QVERIFY(report && report->isSuccessful());
            return;
        }
        QVERIFY(fixture.fake().isLockClosed());
        if (report && report->isSuccessful())
            continue;
        after.removeAll(QString::number(fixture.fake().reg(utf8("lock")).writeOffset));
        QCOMPARE(after, QStringList());
        const bool unsettled = fixture.fake().raw(utf8("operating_mode")) == 1 &&
                               fixture.fake().raw(utf8("goal_speed")) != 0;
        QVERIFY(!unsettled || fixture.openIntents() == 1);
    }
}

/// Stopped, or refused, after the mode had been written: the new mode's command is not left
/// standing.
void TestFamilyWrites::aWrittenModeIsRecovered()
{
    for (const bool stopped : {true, false}) {
        DeviceFixture fixture(utf8("SMSMB"));
        fixture.fake().poke(utf8("goal_speed"), 500);
        device::Servo servo = fixture.servo();
        const catalog::Register& mode = fixture.fake().reg(utf8("operating_mode"));
        const int factory = fixture.fake().reg(utf8("lock")).writeOffset;
        fixture.bus.onRequest = [&](const protocol::Request& request) {
            if (request.op != protocol::Op::Write)
                return;
            if (stopped && request.address == mode.writeOffset)
                fixture.stop.request();
            // The key of the second area is not taken.
            if (!stopped && request.address == factory && request.data.back() == 128)
                fixture.fake().exceptions[factory] = 3;
            else
                fixture.fake().exceptions.clear();
        };
        const auto report = device::write(
            fixture.context(), servo, {{utf8("operating_mode"), 1}, {utf8("max_temperature"), 61}},
            {false, device::Consent::confirmed()});
        QVERIFY(report);
        QVERIFY(!report->isSuccessful());
        QCOMPARE(fixture.fake().raw(utf8("operating_mode")), std::int64_t(1));
        QCOMPARE(fixture.fake().raw(utf8("goal_speed")), std::int64_t(0));
        QVERIFY(fixture.fake().isLockClosed());
    }
}

void TestFamilyWrites::duplicateIdsAreNotWritten()
{
    for (const char* family : {"STS", "SMSMB", "LX"}) {
        DeviceFixture fixture{{family, 1}, {family, 1}};
        device::Servo servo = fixture.servo();
        fixture.fake(1).poke(
            utf8(fixture.fake().has(Role::PositionP) ? "position_p" : "temp_limit"), 77);
        const auto key = fixture.fake().has(Role::PositionP) ? utf8("position_d") : utf8("led");
        const auto report = device::write(fixture.context(), servo, {{key, 1}}, {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::Garbled);
        QCOMPARE(fixture.bus.writes(), 0);
    }
}

SERVODESK_GUILESS_TEST(TestFamilyWrites)
#include "tst_family_writes.moc"
