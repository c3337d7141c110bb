// SPDX-License-Identifier: GPL-3.0-or-later
// What a slider may reach and which fields a move has, per family and mode; goals that are held and
// started apart; a mode switch that is only planned.
#include "device/motion/move_limits.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QTest>

#include "fake_bus.h"

using catalog::Role;
using device::GoalKind;
using device::MoveFieldSet;
using device::MoveMethod;
using device::ZeroSpeed;
using fake::DeviceFixture;
using protocol::Op;
using support::utf8;

namespace {
bool hasNoWrites(const DeviceFixture& fixture)
{
    return std::all_of(
        fixture.bus.requests.begin(), fixture.bus.requests.end(),
        [](const protocol::Request& one) { return one.op == Op::Read || one.op == Op::Ping; });
}

device::Servo inMode(DeviceFixture& fixture, const QString& mode)
{
    device::Servo servo = fixture.servo();
    if (!device::switchMode(fixture.context(), servo, mode))
        qFatal("no mode %s", qPrintable(mode));
    return servo;
}
} // namespace

class TestMoveLimits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void fieldsOfAMode_data();
    void fieldsOfAMode();
    void zeroSpeedFollowsThePhase();
    void spans();
    void stepModeLimit();
    void exactTextRoundTrips_data();
    void exactTextRoundTrips();
    void planningAModeWritesNothing();
    void knownSettingsAreNotReadAgain();
    void anotherModeIsRefused();
    void currentOfAMove();
    void torqueLimits();
};

void TestMoveLimits::fieldsOfAMode_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("mode");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("fields"); // speed, acceleration, time, current
    const auto row = [](const char* family, const char* mode, GoalKind kind, const char* fields) {
        QTest::addRow("%s %s", family, mode)
            << utf8(family) << utf8(mode) << int(kind) << utf8(fields);
    };
    row("STS", "position", GoalKind::Position, "sa");
    row("STS", "multiturn", GoalKind::Turns, "sa");
    row("STS", "speed", GoalKind::Speed, "a");
    row("STS", "pwm", GoalKind::Pwm, "");
    row("STS", "step", GoalKind::Step, "sa");
    row("SCS", "position", GoalKind::Position, "st");
    row("SCS", "motor", GoalKind::Pwm, "");
    row("HLS", "position", GoalKind::Position, "sac");
    row("HLS", "speed", GoalKind::Speed, "ac");
    row("HLS", "current", GoalKind::Current, "");
    row("HLS", "pwm", GoalKind::Pwm, "");
    row("LX", "position", GoalKind::Position, "t");
    row("LX", "motor", GoalKind::Speed, "");
    row("SMSMB", "position", GoalKind::Position, "sa");
    row("SMSMB", "step", GoalKind::Step, "sa");
}

void TestMoveLimits::fieldsOfAMode()
{
    QFETCH(QString, family);
    QFETCH(QString, mode);
    QFETCH(int, kind);
    QFETCH(QString, fields);
    DeviceFixture fixture(family);
    const device::Servo servo = inMode(fixture, mode);
    QCOMPARE(int(device::goalKind(servo).value()), kind);
    const MoveFieldSet set = device::moveFields(servo);
    QString has;
    has += set.speed ? utf8("s") : QString();
    has += set.acceleration ? utf8("a") : QString();
    has += set.time ? utf8("t") : QString();
    has += set.current ? utf8("c") : QString();
    QCOMPARE(has, fields);
}

void TestMoveLimits::zeroSpeedFollowsThePhase()
{
    constexpr int zeroIsMaximum = 8;
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().poke(utf8("phase"), 4);
    QCOMPARE(device::zeroSpeed(fixture.servo()), ZeroSpeed::Stops);
    fixture.fake().poke(utf8("phase"), 4 | zeroIsMaximum);
    QCOMPARE(device::zeroSpeed(fixture.servo()), ZeroSpeed::Fastest);
    DeviceFixture hls(utf8("HLS"));
    QCOMPARE(device::zeroSpeed(hls.servo()), ZeroSpeed::Stops);
    DeviceFixture scs(utf8("SCS"));
    scs.fake().poke(utf8("goal_time"), 1000);
    QCOMPARE(device::zeroSpeed(scs.servo()), ZeroSpeed::ByTime);
}

void TestMoveLimits::spans()
{
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().poke(utf8("min_angle_limit"), 1001);
    fixture.fake().poke(utf8("max_angle_limit"), 3001);
    fixture.fake().poke(utf8("angle_resolution"), 2);
    device::Servo servo = fixture.servo();
    QCOMPARE(device::goalSliderRange(servo)->min, std::int64_t(501)); // whole counts inside
    QCOMPARE(device::goalSliderRange(servo)->max, std::int64_t(1500));
    QCOMPARE(device::goalScaleRange(servo)->max, std::int64_t(2047));
    servo = inMode(fixture, utf8("multiturn"));
    QCOMPARE(device::goalSliderRange(servo)->min, std::int64_t(-30719));
    QCOMPARE(device::goalSliderRange(servo)->max, std::int64_t(30719));
    servo = inMode(fixture, utf8("pwm"));
    QCOMPARE(device::goalSliderRange(servo)->max, std::int64_t(1000));
    DeviceFixture lx(utf8("LX"));
    QCOMPARE(device::goalScaleRange(lx.servo())->max, std::int64_t(1000));
}

void TestMoveLimits::stepModeLimit()
{
    QCOMPARE(device::remainingSteps(0, true), std::int64_t(30719));
    QCOMPARE(device::remainingSteps(30000, true), std::int64_t(719));
    QCOMPARE(device::remainingSteps(30000, false), std::int64_t(60719));
    QCOMPARE(device::remainingSteps(31000, true), std::int64_t(0));
}

void TestMoveLimits::exactTextRoundTrips_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("role");
    for (const char* family : {"STS", "SMS", "SCS", "HLS", "LX", "SMSMB", "SMCL", "SCS2"}) {
        for (const Role role : {Role::GoalPosition, Role::GoalSpeed})
            QTest::addRow("%s %d", family, int(role)) << utf8(family) << int(role);
    }
}

void TestMoveLimits::exactTextRoundTrips()
{
    QFETCH(QString, family);
    QFETCH(int, role);
    DeviceFixture fixture(family);
    const device::Servo servo = fixture.servo();
    const catalog::Register& reg = *servo.profile->byRole(Role(role));
    const catalog::ValueFormat meaning = servo.meaning(reg);
    for (std::int64_t raw = -1000; raw <= 1000; ++raw) {
        const auto back = catalog::parseValue(device::exactValueText(raw, meaning), reg, meaning);
        QVERIFY(back.has_value());
        QCOMPARE(*back, raw);
    }
}

void TestMoveLimits::planningAModeWritesNothing()
{
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().poke(utf8("min_angle_limit"), 300);
    fixture.fake().poke(utf8("max_angle_limit"), 3333);
    fixture.fake().poke(utf8("torque_switch"), 1);
    device::Servo servo = fixture.servo();
    fixture.bus.requests.clear();
    const auto plan = device::planMode(fixture.context(), servo, utf8("step"));
    QVERIFY(plan.has_value());
    QVERIFY(hasNoWrites(fixture));
    QCOMPARE(plan->from, utf8("position"));
    QCOMPARE(plan->to, utf8("step"));
    QVERIFY(plan->torqueGoesOff && plan->limitsSaved);
    QCOMPARE(plan->writes.size(), std::size_t(3));
    QCOMPARE(plan->writes[0].oldRaw, std::int64_t(300));
    QCOMPARE(plan->writes[1].newRaw, std::int64_t(0));
    QCOMPARE(plan->writes[2].key, utf8("operating_mode"));
    // And it is what is done, and how one gets back.
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("step")));
    const auto back = device::planMode(fixture.context(), servo, utf8("position"));
    QVERIFY(back && back->limitsRestored && !back->torqueGoesOff);
    QCOMPARE(back->writes[1].newRaw, std::int64_t(3333));
    const auto speed = device::planMode(fixture.context(), servo, utf8("speed"));
    QCOMPARE(speed->zeroed, utf8("goal_speed"));
}

void TestMoveLimits::knownSettingsAreNotReadAgain()
{
    DeviceFixture fixture(utf8("STS"));
    device::Servo servo = fixture.servo();
    QVERIFY(device::readSettings(fixture.context(), servo));
    fixture.bus.requests.clear();
    device::MoveCommand order{&servo, utf8("2000")};
    order.maxSettingsAge = std::chrono::seconds(1);
    QVERIFY(device::planMove(fixture.context(), order));
    QVERIFY(fixture.bus.requests.empty());
    order.maxSettingsAge = {};
    QVERIFY(device::planMove(fixture.context(), order));
    QVERIFY(!fixture.bus.requests.empty());
}

void TestMoveLimits::anotherModeIsRefused()
{
    DeviceFixture fixture(utf8("STS"));
    device::Servo servo = inMode(fixture, utf8("step"));
    device::MoveCommand order{&servo, utf8("2000")};
    order.mode = utf8("position");
    const auto plan = device::planMove(fixture.context(), order);
    QVERIFY(!plan);
    QCOMPARE(plan.error().code, base::ErrorCode::Refused);
    QCOMPARE(plan.error().detail, utf8("mode-changed"));
}

void TestMoveLimits::currentOfAMove()
{
    DeviceFixture fixture(utf8("HLS"));
    device::Servo servo = fixture.servo();
    device::MoveCommand order{&servo, utf8("2000")};
    order.current = utf8("80");
    std::vector<device::MovePlan> plans;
    auto plan = device::planMove(fixture.context(), order);
    QVERIFY(plan.has_value());
    plans.push_back(*plan);
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    QCOMPARE(fixture.fake().raw(Role::GoalCurrent), std::int64_t(80));
    order.current = utf8("-80");
    plan = device::planMove(fixture.context(), order);
    QVERIFY(!plan);
    QCOMPARE(plan.error().code, base::ErrorCode::OutOfRange);
    DeviceFixture sts(utf8("STS"));
    device::Servo other = sts.servo();
    order.servo = &other;
    plan = device::planMove(sts.context(), order);
    QVERIFY(!plan);
    QCOMPARE(plan.error().code, base::ErrorCode::NotSupported);
}

void TestMoveLimits::torqueLimits()
{
    const auto of = [](const char* family) {
        return device::torqueLimit(*DeviceFixture(utf8(family)).fake().profile);
    };
    QVERIFY(of("STS").reg != nullptr && !of("STS").temporary);
    QVERIFY(of("SCS").reg != nullptr && of("SCS").temporary);
    QVERIFY(of("SMSMB").reg != nullptr && !of("SMSMB").temporary);
    QVERIFY(of("LX").reg == nullptr);
}

SERVODESK_GUILESS_TEST(TestMoveLimits)
#include "tst_move_limits.moc"
