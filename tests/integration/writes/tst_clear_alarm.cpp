// SPDX-License-Identifier: GPL-3.0-or-later
// One test a release rule: what lets an alarm go is done, after consent where it moves or
// energizes; what only time or a power-cycle helps against is shown and left alone.
#include "device/motion/motion.h"
#include "jobs/change/clear_alarm.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace std::chrono_literals;
using base::ErrorCode;
using base::Protocol;
using jobs::AlarmPlan;
using jobs::ClearMethod;
using support::SimFixture;
using support::utf8;

namespace {
/// A servo that hits a stop a little way off when it is sent upwards.
sim::ServoSpec blocked(const char* model, double stopDegrees)
{
    constexpr double room = 20;
    sim::Load load;
    load.stopHigh = stopDegrees * std::numbers::pi / 180.0;
    return {utf8(model), 1, {}, 7.4, stopDegrees - room, load, nullptr};
}

sim::VirtualServo& first(sim::VirtualBus& wire)
{
    return *wire.servos().front();
}

int statusOf(SimFixture& fixture, const char* key = "servo_status")
{
    return int(fixture.raw(1, utf8(key)));
}

/// Pressed against its stop until the overload protection has tripped.
void stall(SimFixture& fixture, std::int64_t goal)
{
    fixture.poke(1, utf8("goal_position"), goal);
    fixture.runFor(6s);
}

double shaft(SimFixture& fixture)
{
    return fixture.withBus([](sim::VirtualBus& wire) { return first(wire).shaftDegrees(); });
}

QStringList keys(const AlarmPlan& plan)
{
    QStringList all;
    for (const jobs::Alarm& alarm : plan.alarms)
        all << alarm.key;
    return all;
}
} // namespace

class TestClearAlarm : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void noAlarmWritesNothing();
    void overloadMovesBackAfterConsent_data();
    void overloadMovesBackAfterConsent();
    void overloadNeedsConsent();
    void overloadInTheOtherDirectionNeedsConsent();
    void overloadWithoutASmallMoveBack_data();
    void overloadWithoutASmallMoveBack();
    void overcurrentUsesThePresentPositionAsGoal();
    void overcurrentNeedsConsent();
    void voltageIsShownUntilItReturns();
    void temperatureIsShownUntilItReturns();
    void temperatureComesBeforeOverload();
    void lxRecoversByItself();
    void lxVoltageIsShown();
    void modbusIsResetByRegister();
    void modbusHoldsItsPosition();
    void modbusPersistentCauseReturns();
    void sensorNeedsAPowerCycle();
    void worksWithResponseLevelZero();
};

void TestClearAlarm::noAlarmWritesNothing()
{
    SimFixture fixture(utf8("sts3215@1"));
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(report);
    QVERIFY(report->isCleared() && !report->isExecuted);
    QVERIFY(fixture.onlyReadsSent());
}

void TestClearAlarm::overloadMovesBackAfterConsent_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::addColumn<double>("stop");
    QTest::addColumn<int>("goal");
    QTest::newRow("STS3215") << utf8("STS3215") << 1'000'000 << 200.0 << 3000;
    QTest::newRow("SM40BLHV") << utf8("SM40BLHV") << 115'200 << 200.0 << 3000;
    QTest::newRow("SCS15") << utf8("SCS15") << 1'000'000 << 120.0 << 900;
}

void TestClearAlarm::overloadMovesBackAfterConsent()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(double, stop);
    QFETCH(int, goal);
    SimFixture fixture({blocked(model.toLatin1().constData(), stop)}, {baud});
    stall(fixture, goal);
    QVERIFY(statusOf(fixture) & 32);
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const double before = shaft(fixture);
    const auto plan = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(plan);
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(plan->next, ClearMethod::BackOff);
    QVERIFY(plan->needsConsent());
    QVERIFY(*plan->to < *plan->from);
    const auto report = jobs::clearAlarm(fixture.context(), servo, *plan);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->isExecuted);
    QVERIFY(report->isCleared());
    fixture.runFor(1s);
    QCOMPARE(statusOf(fixture), 0);
    // A little way, and away from the stall.
    const double turned = before - shaft(fixture);
    QVERIFY2(turned > 1.5 && turned < 8.0, qPrintable(QString::number(turned)));
}

void TestClearAlarm::overloadNeedsConsent()
{
    SimFixture fixture({blocked("STS3215", 200.0)});
    stall(fixture, 3000);
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NeedsConsent);
    QCOMPARE(report.error().detail, utf8("release-moves"));
    QVERIFY(fixture.onlyReadsSent());
}

/// Between question and answer it was turned against the other stop.
void TestClearAlarm::overloadInTheOtherDirectionNeedsConsent()
{
    SimFixture fixture({blocked("STS3215", 200.0)});
    stall(fixture, 3000);
    auto servo = fixture.servo(1);
    auto agreed = *jobs::planClearAlarm(fixture.context(), servo);
    std::swap(agreed.from, agreed.to);
    fixture.clearFrames();
    const auto report = jobs::clearAlarm(fixture.context(), servo, agreed);
    QVERIFY(!report);
    QCOMPARE(report.error().detail, utf8("alarm-changed"));
    QVERIFY(fixture.onlyReadsSent());
}

void TestClearAlarm::overloadWithoutASmallMoveBack_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("why");
    QTest::newRow("speed mode") << utf8("operating_mode") << 1 << utf8("release-mode");
    QTest::newRow("minimum angle") << utf8("min_angle_limit") << 2290 << utf8("release-limit");
}

void TestClearAlarm::overloadWithoutASmallMoveBack()
{
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(QString, why);
    SimFixture fixture({blocked("STS3215", 200.0)});
    stall(fixture, 3000);
    fixture.poke(1, key, value);
    fixture.runFor(50ms);
    QVERIFY(statusOf(fixture) & 32);
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto plan = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(plan && plan->refused && !plan->needsConsent());
    QCOMPARE(plan->refused->detail, why);
    const auto report = jobs::clearAlarm(fixture.context(), servo, *plan);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NotSupported);
    QVERIFY(fixture.onlyReadsSent());
}

namespace {
void triggerOvercurrent(SimFixture& fixture)
{
    fixture.poke(1, utf8("protection_current"), 150);
    fixture.poke(1, utf8("overcurrent_time"), 50);
    fixture.poke(1, utf8("unload_condition"), 8);
    fixture.poke(1, utf8("goal_position"), 3500);
    fixture.runFor(3s);
}
} // namespace

void TestClearAlarm::overcurrentUsesThePresentPositionAsGoal()
{
    SimFixture fixture({blocked("STS3215", 200.0)});
    triggerOvercurrent(fixture);
    QCOMPARE(statusOf(fixture), 8);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    auto servo = fixture.servo(1);
    const auto plan = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(plan);
    QCOMPARE(plan->next, ClearMethod::NewGoal);
    QVERIFY(plan->torqueOff && plan->needsConsent());
    QCOMPARE(plan->alarms.front().max, std::optional<std::int64_t>(150));
    const double before = shaft(fixture);
    const auto report = jobs::clearAlarm(fixture.context(), servo, *plan);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->isExecuted && report->isCleared());
    fixture.runFor(1s);
    QCOMPARE(statusOf(fixture), 0);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 1);
    QVERIFY(std::abs(shaft(fixture) - before) < 1.0);
}

void TestClearAlarm::overcurrentNeedsConsent()
{
    SimFixture fixture({blocked("STS3215", 200.0)});
    triggerOvercurrent(fixture);
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(!report);
    QCOMPARE(report.error().detail, utf8("release-energises"));
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

void TestClearAlarm::voltageIsShownUntilItReturns()
{
    SimFixture fixture(utf8("sts3215@1"));
    const auto supply = [&](double volts) {
        fixture.withBus(
            [&](sim::VirtualBus& wire) { first(wire).environment().supplyVolts = volts; });
        fixture.runFor(500ms);
    };
    supply(9.0);
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto high = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(high && !high->isExecuted && !high->isCleared());
    const jobs::Alarm& alarm = high->after.alarms.front();
    QCOMPARE(alarm.key, utf8("voltage"));
    QCOMPARE(alarm.release, ClearMethod::Wait);
    QCOMPARE(alarm.measured, utf8("present_voltage"));
    QVERIFY(*alarm.value > *alarm.max);
    QVERIFY(*alarm.min < *alarm.max);
    supply(7.4);
    const auto good = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(good);
    QCOMPARE(good->next, ClearMethod::None);
    QVERIFY(fixture.onlyReadsSent());
}

void TestClearAlarm::temperatureIsShownUntilItReturns()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.withBus([](sim::VirtualBus& wire) { first(wire).setTemperature(80); });
    fixture.runFor(50ms);
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto hot = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(hot && !hot->isExecuted && !hot->isCleared());
    QCOMPARE(keys(hot->after), QStringList{utf8("temperature")});
    QVERIFY(*hot->after.alarms.front().value > *hot->after.alarms.front().max);
    fixture.runFor(600s);
    const auto cool = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(cool);
    QCOMPARE(cool->next, ClearMethod::None);
    QVERIFY(fixture.onlyReadsSent());
}

/// While heat unloads the motor, no goal could turn it back.
void TestClearAlarm::temperatureComesBeforeOverload()
{
    SimFixture fixture({blocked("STS3215", 200.0)});
    stall(fixture, 3000);
    fixture.withBus([](sim::VirtualBus& wire) { first(wire).setTemperature(80); });
    fixture.runFor(50ms);
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(report && !report->isExecuted);
    QCOMPARE(report->before.next, ClearMethod::Wait);
    QCOMPARE(report->before.alarms.size(), std::size_t(2));
    QVERIFY(fixture.onlyReadsSent());
}

void TestClearAlarm::lxRecoversByItself()
{
    SimFixture fixture(utf8("lx16a@1"), {115'200});
    fixture.poke(1, utf8("temp_limit"), 60);
    fixture.withBus([](sim::VirtualBus& wire) { first(wire).setTemperature(70); });
    fixture.runFor(50ms);
    auto servo = fixture.servo(1, Protocol::Lx);
    const std::size_t journaled = fixture.journal().entries()->size();
    const auto hot = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(hot && !hot->isExecuted && !hot->isCleared());
    const jobs::Alarm& alarm = hot->after.alarms.front();
    QCOMPARE(alarm.key, utf8("temperature"));
    QVERIFY(alarm.derived);
    QCOMPARE(alarm.max, std::optional<std::int64_t>(60));
    QVERIFY(*alarm.value > 60);
    fixture.runFor(600s);
    const auto cool = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(cool);
    QCOMPARE(cool->next, ClearMethod::None);
    QCOMPARE(fixture.journal().entries()->size(), journaled);
}

void TestClearAlarm::lxVoltageIsShown()
{
    SimFixture fixture(utf8("lx16a@1"), {115'200});
    fixture.withBus([](sim::VirtualBus& wire) { first(wire).environment().supplyVolts = 13; });
    fixture.runFor(500ms);
    auto servo = fixture.servo(1, Protocol::Lx);
    const auto plan = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(plan);
    QCOMPARE(keys(*plan), QStringList{utf8("voltage")});
    QCOMPARE(plan->next, ClearMethod::Wait);
    QVERIFY(*plan->alarms.front().value > *plan->alarms.front().max);
}

namespace {
constexpr int modbusFaults = 0x2F;

void stallModbus(SimFixture& fixture)
{
    fixture.poke(1, utf8("torque_switch"), 1);
    stall(fixture, 3000);
}
} // namespace

void TestClearAlarm::modbusIsResetByRegister()
{
    SimFixture fixture({blocked("SMSMB", 200.0)}, {115'200});
    stallModbus(fixture);
    QVERIFY(statusOf(fixture) & 32);
    auto servo = fixture.servo(1, Protocol::Modbus);
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->before.next, ClearMethod::FaultReset);
    QCOMPARE(report->before.faultResetBits, 1);
    QVERIFY(report->isExecuted && report->isCleared());
    fixture.runFor(5s);
    QCOMPARE(statusOf(fixture) & modbusFaults, 0);
}

/// A reset gives the full force back: it must not set out for its old goal.
void TestClearAlarm::modbusHoldsItsPosition()
{
    SimFixture fixture({blocked("SMSMB", 200.0)}, {115'200});
    stallModbus(fixture);
    // The jam is gone, and the goal still far away.
    fixture.withBus([](sim::VirtualBus& wire) { first(wire).load().stopHigh.reset(); });
    auto servo = fixture.servo(1, Protocol::Modbus);
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(report && report->isCleared());
    const double atReset = shaft(fixture);
    fixture.runFor(3s);
    QVERIFY(std::abs(shaft(fixture) - atReset) < 3.0);
}

void TestClearAlarm::modbusPersistentCauseReturns()
{
    SimFixture fixture(utf8("smsmb@1"), {115'200});
    fixture.withBus([](sim::VirtualBus& wire) { first(wire).setTemperature(95); });
    fixture.runFor(50ms);
    auto servo = fixture.servo(1, Protocol::Modbus);
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->isExecuted && !report->isCleared());
    const jobs::Alarm& alarm = report->after.alarms.front();
    QCOMPARE(alarm.key, utf8("temperature"));
    QVERIFY(*alarm.value > *alarm.max);
}

void TestClearAlarm::sensorNeedsAPowerCycle()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.withBus([](sim::VirtualBus& wire) { first(wire).injectStatus(2); });
    auto servo = fixture.servo(1);
    fixture.clearFrames();
    const auto report = jobs::clearAlarm(fixture.context(), servo, {});
    QVERIFY(report && !report->isExecuted && !report->isCleared());
    QCOMPARE(report->after.next, ClearMethod::PowerCycle);
    QVERIFY(fixture.onlyReadsSent());
}

/// Response level 0: writes are not acknowledged, so reading proves them.
void TestClearAlarm::worksWithResponseLevelZero()
{
    SimFixture fixture({blocked("STS3215", 200.0)});
    fixture.poke(1, utf8("response_level"), 0);
    stall(fixture, 3000);
    auto servo = fixture.servo(1);
    const auto plan = jobs::planClearAlarm(fixture.context(), servo);
    QVERIFY(plan);
    const auto report = jobs::clearAlarm(fixture.context(), servo, *plan);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->isCleared());
}

SERVODESK_GUILESS_TEST(TestClearAlarm)
#include "tst_clear_alarm.moc"
