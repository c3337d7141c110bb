// SPDX-License-Identifier: GPL-3.0-or-later
// Which servo answers, in which protocol; its table; its alarms; its emergency stop.
#include "device/alarms.h"
#include "device/motion/stop_frames.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QTest>

#include "fake_bus.h"

using base::ErrorCode;
using base::Protocol;
using catalog::Role;
using device::NoticeCode;
using fake::DeviceFixture;
using support::utf8;

namespace {
const std::vector<Protocol> all(base::allProtocols.begin(), base::allProtocols.end());
} // namespace

class TestIdentify : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyFamilyIsIdentified_data();
    void everyFamilyIsIdentified();
    void noServoAnswers();
    void twoProtocolsUnderOneId();
    void otherErrorsDoNotHideAServo();
    void garbledIsNotSilent();
    void aLostLinkEndsTheRequest();
    void idsUnsupportedByAProtocol();
    void wholeTable_data();
    void wholeTable();
    void aSilentStoredMoveIsNoError();
    void requestedSilentReadIsReported();
    void statusComesFromItsRegister();
    void derivedAlarms_data();
    void derivedAlarms();
    void stopFramesInEachProtocol();
};

void TestIdentify::everyFamilyIsIdentified_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("map");
    QTest::newRow("STS") << "STS"
                         << "sts-sms";
    QTest::newRow("SMS") << "SMS"
                         << "sts-sms";
    QTest::newRow("SCS") << "SCS"
                         << "scs";
    QTest::newRow("HLS") << "HLS"
                         << "hls";
    QTest::newRow("SMCL") << "SMCL"
                          << "smcl";
    QTest::newRow("SCS-2") << "SCS2"
                           << "scs2";
    QTest::newRow("Modbus") << "SMSMB"
                            << "sms-modbus";
    QTest::newRow("LX") << "LX"
                        << "lx";
}

void TestIdentify::everyFamilyIsIdentified()
{
    QFETCH(QString, family);
    QFETCH(QString, map);
    DeviceFixture fixture(family, 7);
    const auto servo = device::identifyAmong(fixture.context(), 7, all);
    QVERIFY(servo);
    QCOMPARE(servo->profile->mapKey, map);
    QCOMPARE(servo->protocol, fixture.fake().profile->protocol);
    QCOMPARE(servo->identity().protocol, servo->protocol);
    QVERIFY(servo->profile->writable);
    QCOMPARE(fixture.bus.writes(), 0);
}

void TestIdentify::noServoAnswers()
{
    DeviceFixture fixture(utf8("LX"), 7);
    const auto servo = device::identifyAmong(fixture.context(), 8, all);
    QVERIFY(!servo);
    QCOMPARE(servo.error().code, ErrorCode::NoReply);
    QCOMPARE(servo.error().id, 8);
}

void TestIdentify::twoProtocolsUnderOneId()
{
    DeviceFixture fixture{{"SMSMB", 3}, {"LX", 3}};
    const auto servo = device::identifyAmong(fixture.context(), 3, all);
    QVERIFY(!servo);
    QCOMPARE(servo.error().code, ErrorCode::AmbiguousProtocol);
    QCOMPARE(servo.error().detail, utf8("modbus, lx"));
    // Said which, each is its own.
    QCOMPARE(device::identifyAmong(fixture.context(), 3, {Protocol::Lx})->profile->series,
             utf8("LX"));
    QCOMPARE(device::identifyAmong(fixture.context(), 3, {Protocol::Modbus})->profile->series,
             utf8("SMSMB"));
}

void TestIdentify::otherErrorsDoNotHideAServo()
{
    // Two stations disagree about themselves; the LX servo of that number is sound.
    DeviceFixture fixture{{"SMSMB", 3}, {"SMSMB", 3}, {"LX", 3}};
    fixture.fake(1).poke(utf8("servo_version"), 99);
    const auto servo = device::identifyAmong(fixture.context(), 3, all);
    QVERIFY(servo);
    QCOMPARE(servo->protocol, Protocol::Lx);
}

void TestIdentify::garbledIsNotSilent()
{
    DeviceFixture fixture{{"SMSMB", 3}, {"SMSMB", 3}};
    fixture.fake(1).poke(utf8("servo_version"), 99);
    const auto servo = device::identifyAmong(fixture.context(), 3, all);
    QVERIFY(!servo);
    QCOMPARE(servo.error().code, ErrorCode::Garbled);
}

void TestIdentify::aLostLinkEndsTheRequest()
{
    DeviceFixture fixture{{"LX", 3}};
    fixture.bus.cutAfter = 1;
    const auto servo = device::identifyAmong(fixture.context(), 3, all);
    QVERIFY(!servo);
    QCOMPARE(servo.error().code, ErrorCode::LinkLost);
}

/// Modbus stations end at 247 and begin at 1; that others have no such ID is no failure.
void TestIdentify::idsUnsupportedByAProtocol()
{
    for (const int id : {0, 250}) {
        DeviceFixture fixture(utf8("LX"), id);
        const auto servo = device::identifyAmong(fixture.context(), id, all);
        QVERIFY(servo);
        QCOMPARE(servo->protocol, Protocol::Lx);
        for (const protocol::Request& request : fixture.bus.requests)
            QVERIFY(request.protocol != Protocol::Modbus);
    }
}

void TestIdentify::wholeTable_data()
{
    everyFamilyIsIdentified_data();
}

void TestIdentify::wholeTable()
{
    QFETCH(QString, family);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    servo.image.clear();
    QVERIFY(device::readAll(fixture.context(), servo));
    for (const catalog::Register& reg : servo.profile->registers)
        QCOMPARE(servo.raw(reg), std::optional(fixture.fake().raw(reg.key)));
    for (const protocol::Request& request : fixture.bus.requests)
        QVERIFY(request.count <= servo.profile->maxRead);
}

void TestIdentify::aSilentStoredMoveIsNoError()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().repliesStoredMove = false;
    device::Servo servo = fixture.servo();
    QVERIFY(device::readAll(fixture.context(), servo));
    QVERIFY(!servo.raw(utf8("wait_angle")));
    QVERIFY(!servo.raw(utf8("wait_time")));
    QCOMPARE(servo.raw(utf8("angle_limit_max")), std::optional<std::int64_t>(1000));
    int asked = 0;
    for (const protocol::Request& request : fixture.bus.requests)
        asked += request.address == 8 * 8 ? 1 : 0;
    QCOMPARE(asked, 1);
    // Settings are read often, and never wait for it.
    fixture.bus.requests.clear();
    QVERIFY(device::readSettings(fixture.context(), servo));
    for (const protocol::Request& request : fixture.bus.requests)
        QVERIFY(request.address != 8 * 8);
}

void TestIdentify::requestedSilentReadIsReported()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().repliesStoredMove = false;
    device::Servo servo = fixture.servo();
    const auto read = device::readKeys(fixture.context(), servo, {utf8("wait_time")});
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::NotSupported);
    QCOMPARE(read.error().detail, utf8("not-readable"));
}

/// Bit 4 means that torque is on, which is no fault.
void TestIdentify::statusComesFromItsRegister()
{
    DeviceFixture fixture(utf8("SMSMB"));
    device::Servo servo = fixture.servo();
    fixture.fake().poke(utf8("servo_status"), 0x10);
    device::addAlarmNotices(fixture.context(), servo);
    QCOMPARE(int(servo.status), 0);
    QVERIFY(fixture.notices.empty());
    fixture.fake().poke(utf8("servo_status"), 0x10 | 0x20 | 0x04);
    device::addAlarmNotices(fixture.context(), servo);
    QCOMPARE(int(servo.status), 0x24);
    QCOMPARE(fixture.noticeCount(NoticeCode::OverloadActive), 1);
    QCOMPARE(fixture.noticeCount(NoticeCode::TemperatureAlarmActive), 1);
    QCOMPARE(fixture.notices.size(), std::size_t(2));
    // Other reads do not wipe it.
    QVERIFY(device::readKeys(fixture.context(), servo, {utf8("present_position")}));
    QCOMPARE(int(servo.status), 0x24);
    QVERIFY(device::derivedAlarms(servo).empty());
}

void TestIdentify::derivedAlarms_data()
{
    QTest::addColumn<int>("celsius");
    QTest::addColumn<int>("millivolts");
    QTest::addColumn<int>("hot");
    QTest::addColumn<int>("voltage");
    QTest::newRow("nothing") << 85 << 7400 << 0 << 0;
    QTest::newRow("too hot") << 86 << 7400 << 1 << 0;
    QTest::newRow("at the lower limit") << 25 << 6500 << 0 << 0;
    QTest::newRow("too low") << 25 << 6499 << 0 << 1;
    QTest::newRow("too high") << 25 << 12001 << 0 << 1;
    QTest::newRow("both") << 99 << 3000 << 1 << 1;
}

void TestIdentify::derivedAlarms()
{
    QFETCH(int, celsius);
    QFETCH(int, millivolts);
    QFETCH(int, hot);
    QFETCH(int, voltage);
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("temperature"), celsius);
    fixture.fake().poke(utf8("vin"), millivolts);
    auto servo = device::identify(fixture.context(), 1, Protocol::Lx);
    QVERIFY(servo);
    QVERIFY(device::derivedAlarms(*servo).empty()); // nothing read, nothing derived
    device::addAlarmNotices(fixture.context(), *servo);
    QCOMPARE(fixture.noticeCount(NoticeCode::DerivedTemperature), hot);
    QCOMPARE(fixture.noticeCount(NoticeCode::DerivedVoltage), voltage);
    QCOMPARE(int(device::derivedAlarms(*servo).size()), hot + voltage);
    QCOMPARE(int(servo->status), 0);
}

void TestIdentify::stopFramesInEachProtocol()
{
    DeviceFixture fixture{{"LX", 1}, {"SMSMB", 1}, {"SCS2", 4}};
    const auto frames = device::stopFrames({Protocol::Feetech, Protocol::Modbus, Protocol::Lx},
                                           {fixture.servo(0), fixture.servo(1), fixture.servo(2)});
    QStringList shown;
    std::vector<Protocol> languages;
    for (const bus::StopFrame& frame : frames) {
        shown << base::toHex(frame.bytes);
        languages.push_back(frame.protocol);
    }
    QCOMPARE(shown.size(), 6);
    QCOMPARE(languages, (std::vector<Protocol>{Protocol::Feetech, Protocol::Modbus, Protocol::Lx,
                                               Protocol::Lx, Protocol::Modbus, Protocol::Feetech}));
    QCOMPARE(shown[0], utf8("FF FF FE 04 03 28 00 D2"));
    QVERIFY(shown[1].startsWith(utf8("00 06 00 81 00 00")));
    // NOT(FE + 4 + 1F + 0) = DE
    QCOMPARE(shown[2], utf8("55 55 FE 04 1F 00 DE"));
    QCOMPARE(shown[3], utf8("55 55 01 04 1F 00 DB")); // the sheet's worked frame
    QVERIFY(shown[4].startsWith(utf8("01 06 00 81 00 00")));
    QVERIFY(shown[5].startsWith(utf8("FF FF 04 04 03 28 00")));
}

SERVODESK_GUILESS_TEST(TestIdentify)
#include "tst_identify.moc"
