// SPDX-License-Identifier: GPL-3.0-or-later
// One test a release rule: what lets an alarm go is done, after consent where it moves or
// energises; what only time or a power-cycle helps against is shown and left alone.
#include "device/motion.h"
#include "jobs/clear_alarm.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace std::chrono_literals;
using base::ErrorCode;
using base::Protocol;
using jobs::AlarmPlan;
using jobs::Release;
using support::SimBench;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

/// A servo that hits a stop a little way off when it is sent upwards.
sim::ServoRecipe blocked(const char* model, double stopDegrees)
{
    constexpr double room = 20;
    sim::Load load;
    load.stopHigh = stopDegrees * std::numbers::pi / 180.0;
    return {text(model), 1, {}, 7.4, stopDegrees - room, load, nullptr};
}

sim::VirtualServo& first(sim::VirtualBus& wire)
{
    return *wire.servos().front();
}

int statusOf(SimBench& bench, const char* key = "servo_status")
{
    return int(bench.raw(1, text(key)));
}

/// Pressed against its stop until the overload protection has tripped.
void stall(SimBench& bench, std::int64_t goal)
{
    bench.poke(1, text("goal_position"), goal);
    bench.letTimePass(6s);
}

double shaft(SimBench& bench)
{
    return bench.withWire([](sim::VirtualBus& wire) { return first(wire).shaftDegrees(); });
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
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void noAlarmWritesNothing();
    void overloadTurnsBackAfterConsent_data();
    void overloadTurnsBackAfterConsent();
    void overloadNeedsConsent();
    void overloadTheOtherWayWasNotAgreed();
    void overloadHasNoSmallWayBack_data();
    void overloadHasNoSmallWayBack();
    void overcurrentTakesItsPlaceAsGoal();
    void overcurrentNeedsConsent();
    void voltageIsShownUntilItReturns();
    void temperatureIsShownUntilItReturns();
    void heatComesBeforeOverload();
    void lxRecoversByItself();
    void lxVoltageIsShown();
    void modbusIsResetByRegister();
    void modbusHoldsWhereItIs();
    void modbusCauseThatLastsComesBack();
    void sensorNeedsAPowerCycle();
    void levelZeroWorksToo();
};

void TestClearAlarm::noAlarmWritesNothing()
{
    SimBench bench(text("sts3215@1"));
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(report);
    QVERIFY(report->cleared() && !report->acted);
    QVERIFY(bench.onlyAsked());
}

void TestClearAlarm::overloadTurnsBackAfterConsent_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::addColumn<double>("stop");
    QTest::addColumn<int>("goal");
    QTest::newRow("STS3215") << text("STS3215") << 1'000'000 << 200.0 << 3000;
    QTest::newRow("SM40BLHV") << text("SM40BLHV") << 115'200 << 200.0 << 3000;
    QTest::newRow("SCS15") << text("SCS15") << 1'000'000 << 120.0 << 900;
}

void TestClearAlarm::overloadTurnsBackAfterConsent()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(double, stop);
    QFETCH(int, goal);
    SimBench bench({blocked(model.toLatin1().constData(), stop)}, {baud});
    stall(bench, goal);
    QVERIFY(statusOf(bench) & 32);
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const double before = shaft(bench);
    const auto plan = jobs::planAlarm(bench.context(), servo);
    QVERIFY(plan);
    QVERIFY(bench.onlyAsked());
    QCOMPARE(plan->next, Release::TurnBack);
    QVERIFY(plan->needsConsent());
    QVERIFY(*plan->to < *plan->from);
    const auto report = jobs::clearAlarm(bench.context(), servo, *plan);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->acted);
    QVERIFY(report->cleared());
    bench.letTimePass(1s);
    QCOMPARE(statusOf(bench), 0);
    // A little way, and away from the stall.
    const double turned = before - shaft(bench);
    QVERIFY2(turned > 1.5 && turned < 8.0, qPrintable(QString::number(turned)));
}

void TestClearAlarm::overloadNeedsConsent()
{
    SimBench bench({blocked("STS3215", 200.0)});
    stall(bench, 3000);
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NeedsConsent);
    QCOMPARE(report.error().detail, text("release-moves"));
    QVERIFY(bench.onlyAsked());
}

/// Between question and answer somebody turned it against the other stop.
void TestClearAlarm::overloadTheOtherWayWasNotAgreed()
{
    SimBench bench({blocked("STS3215", 200.0)});
    stall(bench, 3000);
    auto servo = bench.servo(1);
    auto agreed = *jobs::planAlarm(bench.context(), servo);
    std::swap(agreed.from, agreed.to);
    bench.forgetFrames();
    const auto report = jobs::clearAlarm(bench.context(), servo, agreed);
    QVERIFY(!report);
    QCOMPARE(report.error().detail, text("alarm-changed"));
    QVERIFY(bench.onlyAsked());
}

void TestClearAlarm::overloadHasNoSmallWayBack_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("why");
    QTest::newRow("speed mode") << text("operating_mode") << 1 << text("release-mode");
    QTest::newRow("minimum angle") << text("min_angle_limit") << 2290 << text("release-limit");
}

void TestClearAlarm::overloadHasNoSmallWayBack()
{
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(QString, why);
    SimBench bench({blocked("STS3215", 200.0)});
    stall(bench, 3000);
    bench.poke(1, key, value);
    bench.letTimePass(50ms);
    QVERIFY(statusOf(bench) & 32);
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto plan = jobs::planAlarm(bench.context(), servo);
    QVERIFY(plan && plan->refused && !plan->needsConsent());
    QCOMPARE(plan->refused->detail, why);
    const auto report = jobs::clearAlarm(bench.context(), servo, *plan);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::NotSupported);
    QVERIFY(bench.onlyAsked());
}

namespace {
void tripOnCurrent(SimBench& bench)
{
    bench.poke(1, text("protection_current"), 150);
    bench.poke(1, text("overcurrent_time"), 50);
    bench.poke(1, text("unload_condition"), 8);
    bench.poke(1, text("goal_position"), 3500);
    bench.letTimePass(3s);
}
} // namespace

void TestClearAlarm::overcurrentTakesItsPlaceAsGoal()
{
    SimBench bench({blocked("STS3215", 200.0)});
    tripOnCurrent(bench);
    QCOMPARE(statusOf(bench), 8);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    auto servo = bench.servo(1);
    const auto plan = jobs::planAlarm(bench.context(), servo);
    QVERIFY(plan);
    QCOMPARE(plan->next, Release::NewGoal);
    QVERIFY(plan->torqueOff && plan->needsConsent());
    QCOMPARE(plan->alarms.front().max, std::optional<std::int64_t>(150));
    const double before = shaft(bench);
    const auto report = jobs::clearAlarm(bench.context(), servo, *plan);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->acted && report->cleared());
    bench.letTimePass(1s);
    QCOMPARE(statusOf(bench), 0);
    QCOMPARE(bench.raw(1, text("torque_switch")), 1);
    QVERIFY(std::abs(shaft(bench) - before) < 1.0);
}

void TestClearAlarm::overcurrentNeedsConsent()
{
    SimBench bench({blocked("STS3215", 200.0)});
    tripOnCurrent(bench);
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(!report);
    QCOMPARE(report.error().detail, text("release-energises"));
    QVERIFY(bench.onlyAsked());
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
}

void TestClearAlarm::voltageIsShownUntilItReturns()
{
    SimBench bench(text("sts3215@1"));
    const auto supply = [&](double volts) {
        bench.withWire(
            [&](sim::VirtualBus& wire) { first(wire).surroundings().supplyVolts = volts; });
        bench.letTimePass(500ms);
    };
    supply(9.0);
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto high = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(high && !high->acted && !high->cleared());
    const jobs::Alarm& alarm = high->after.alarms.front();
    QCOMPARE(alarm.key, text("voltage"));
    QCOMPARE(alarm.release, Release::Wait);
    QCOMPARE(alarm.measured, text("present_voltage"));
    QVERIFY(*alarm.value > *alarm.max);
    QVERIFY(*alarm.min < *alarm.max);
    supply(7.4);
    const auto good = jobs::planAlarm(bench.context(), servo);
    QVERIFY(good);
    QCOMPARE(good->next, Release::Nothing);
    QVERIFY(bench.onlyAsked());
}

void TestClearAlarm::temperatureIsShownUntilItReturns()
{
    SimBench bench(text("sts3215@1"));
    bench.withWire([](sim::VirtualBus& wire) { first(wire).setTemperature(80); });
    bench.letTimePass(50ms);
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto hot = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(hot && !hot->acted && !hot->cleared());
    QCOMPARE(keys(hot->after), QStringList{text("temperature")});
    QVERIFY(*hot->after.alarms.front().value > *hot->after.alarms.front().max);
    bench.letTimePass(600s);
    const auto cool = jobs::planAlarm(bench.context(), servo);
    QVERIFY(cool);
    QCOMPARE(cool->next, Release::Nothing);
    QVERIFY(bench.onlyAsked());
}

/// While heat unloads the motor, no goal could turn it back.
void TestClearAlarm::heatComesBeforeOverload()
{
    SimBench bench({blocked("STS3215", 200.0)});
    stall(bench, 3000);
    bench.withWire([](sim::VirtualBus& wire) { first(wire).setTemperature(80); });
    bench.letTimePass(50ms);
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(report && !report->acted);
    QCOMPARE(report->before.next, Release::Wait);
    QCOMPARE(report->before.alarms.size(), std::size_t(2));
    QVERIFY(bench.onlyAsked());
}

void TestClearAlarm::lxRecoversByItself()
{
    SimBench bench(text("lx16a@1"), {115'200});
    bench.poke(1, text("temp_limit"), 60);
    bench.withWire([](sim::VirtualBus& wire) { first(wire).setTemperature(70); });
    bench.letTimePass(50ms);
    auto servo = bench.servo(1, Protocol::Lx);
    const std::size_t journalled = bench.journal().entries()->size();
    const auto hot = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(hot && !hot->acted && !hot->cleared());
    const jobs::Alarm& alarm = hot->after.alarms.front();
    QCOMPARE(alarm.key, text("temperature"));
    QVERIFY(alarm.derived);
    QCOMPARE(alarm.max, std::optional<std::int64_t>(60));
    QVERIFY(*alarm.value > 60);
    bench.letTimePass(600s);
    const auto cool = jobs::planAlarm(bench.context(), servo);
    QVERIFY(cool);
    QCOMPARE(cool->next, Release::Nothing);
    QCOMPARE(bench.journal().entries()->size(), journalled);
}

void TestClearAlarm::lxVoltageIsShown()
{
    SimBench bench(text("lx16a@1"), {115'200});
    bench.withWire([](sim::VirtualBus& wire) { first(wire).surroundings().supplyVolts = 13; });
    bench.letTimePass(500ms);
    auto servo = bench.servo(1, Protocol::Lx);
    const auto plan = jobs::planAlarm(bench.context(), servo);
    QVERIFY(plan);
    QCOMPARE(keys(*plan), QStringList{text("voltage")});
    QCOMPARE(plan->next, Release::Wait);
    QVERIFY(*plan->alarms.front().value > *plan->alarms.front().max);
}

namespace {
constexpr int modbusFaults = 0x2F;

void stallModbus(SimBench& bench)
{
    bench.poke(1, text("torque_switch"), 1);
    stall(bench, 3000);
}
} // namespace

void TestClearAlarm::modbusIsResetByRegister()
{
    SimBench bench({blocked("SMSMB", 200.0)}, {115'200});
    stallModbus(bench);
    QVERIFY(statusOf(bench) & 32);
    auto servo = bench.servo(1, Protocol::Modbus);
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QCOMPARE(report->before.next, Release::FaultReset);
    QCOMPARE(report->before.resetBits, 1);
    QVERIFY(report->acted && report->cleared());
    bench.letTimePass(5s);
    QCOMPARE(statusOf(bench) & modbusFaults, 0);
}

/// A reset gives the full force back: it must not set out for its old goal.
void TestClearAlarm::modbusHoldsWhereItIs()
{
    SimBench bench({blocked("SMSMB", 200.0)}, {115'200});
    stallModbus(bench);
    // The jam is gone, and the goal still far away.
    bench.withWire([](sim::VirtualBus& wire) { first(wire).load().stopHigh.reset(); });
    auto servo = bench.servo(1, Protocol::Modbus);
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(report && report->cleared());
    const double atReset = shaft(bench);
    bench.letTimePass(3s);
    QVERIFY(std::abs(shaft(bench) - atReset) < 3.0);
}

void TestClearAlarm::modbusCauseThatLastsComesBack()
{
    SimBench bench(text("smsmb@1"), {115'200});
    bench.withWire([](sim::VirtualBus& wire) { first(wire).setTemperature(95); });
    bench.letTimePass(50ms);
    auto servo = bench.servo(1, Protocol::Modbus);
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->acted && !report->cleared());
    const jobs::Alarm& alarm = report->after.alarms.front();
    QCOMPARE(alarm.key, text("temperature"));
    QVERIFY(*alarm.value > *alarm.max);
}

void TestClearAlarm::sensorNeedsAPowerCycle()
{
    SimBench bench(text("sts3215@1"));
    bench.withWire([](sim::VirtualBus& wire) { first(wire).injectStatus(2); });
    auto servo = bench.servo(1);
    bench.forgetFrames();
    const auto report = jobs::clearAlarm(bench.context(), servo, {});
    QVERIFY(report && !report->acted && !report->cleared());
    QCOMPARE(report->after.next, Release::PowerCycle);
    QVERIFY(bench.onlyAsked());
}

/// Response level 0: writes are not acknowledged, reading tells.
void TestClearAlarm::levelZeroWorksToo()
{
    SimBench bench({blocked("STS3215", 200.0)});
    bench.poke(1, text("response_level"), 0);
    stall(bench, 3000);
    auto servo = bench.servo(1);
    const auto plan = jobs::planAlarm(bench.context(), servo);
    QVERIFY(plan);
    const auto report = jobs::clearAlarm(bench.context(), servo, *plan);
    QVERIFY2(report, report ? "" : qPrintable(base::errorName(report.error().code)));
    QVERIFY(report->cleared());
}

QTEST_GUILESS_MAIN(TestClearAlarm)
#include "tst_clear_alarm.moc"
