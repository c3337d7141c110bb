// SPDX-License-Identifier: GPL-3.0-or-later
// What a slider may reach and which fields a move has, per family and mode; goals that are held and
// started apart; a mode switch that is only planned.
#include "device/move_limits.h"

#include <QTest>

#include "paper_bus.h"

using catalog::Role;
using device::GoalKind;
using device::MoveFieldSet;
using device::MoveHow;
using device::ZeroSpeed;
using paper::Bench;
using protocol::Op;

namespace {
QString text(const char* word)
{
    return QString::fromLatin1(word);
}

bool wroteNothing(const Bench& bench)
{
    return std::all_of(
        bench.bus.said.begin(), bench.bus.said.end(),
        [](const protocol::Request& one) { return one.op == Op::Read || one.op == Op::Ping; });
}

device::Servo inMode(Bench& bench, const QString& mode)
{
    device::Servo servo = bench.servo();
    if (!device::switchMode(bench.context(), servo, mode))
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
    void stepsRunOut();
    void exactTextComesBack_data();
    void exactTextComesBack();
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
            << text(family) << text(mode) << int(kind) << text(fields);
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
    Bench bench(family);
    const device::Servo servo = inMode(bench, mode);
    QCOMPARE(int(device::goalKind(servo).value()), kind);
    const MoveFieldSet set = device::moveFields(servo);
    QString has;
    has += set.speed ? text("s") : QString();
    has += set.acceleration ? text("a") : QString();
    has += set.time ? text("t") : QString();
    has += set.current ? text("c") : QString();
    QCOMPARE(has, fields);
}

void TestMoveLimits::zeroSpeedFollowsThePhase()
{
    constexpr int zeroIsMaximum = 8;
    Bench bench(text("STS"));
    bench.paper().poke(text("phase"), 4);
    QCOMPARE(device::zeroSpeed(bench.servo()), ZeroSpeed::Stops);
    bench.paper().poke(text("phase"), 4 | zeroIsMaximum);
    QCOMPARE(device::zeroSpeed(bench.servo()), ZeroSpeed::Fastest);
    Bench hls(text("HLS"));
    QCOMPARE(device::zeroSpeed(hls.servo()), ZeroSpeed::Stops);
    Bench scs(text("SCS"));
    scs.paper().poke(text("goal_time"), 1000);
    QCOMPARE(device::zeroSpeed(scs.servo()), ZeroSpeed::ByTime);
}

void TestMoveLimits::spans()
{
    Bench bench(text("STS"));
    bench.paper().poke(text("min_angle_limit"), 1001);
    bench.paper().poke(text("max_angle_limit"), 3001);
    bench.paper().poke(text("angle_resolution"), 2);
    device::Servo servo = bench.servo();
    QCOMPARE(device::goalSpan(servo)->min, std::int64_t(501)); // whole counts inside
    QCOMPARE(device::goalSpan(servo)->max, std::int64_t(1500));
    QCOMPARE(device::goalScale(servo)->max, std::int64_t(2047));
    servo = inMode(bench, text("multiturn"));
    QCOMPARE(device::goalSpan(servo)->min, std::int64_t(-30719));
    QCOMPARE(device::goalSpan(servo)->max, std::int64_t(30719));
    servo = inMode(bench, text("pwm"));
    QCOMPARE(device::goalSpan(servo)->max, std::int64_t(1000));
    Bench lx(text("LX"));
    QCOMPARE(device::goalScale(lx.servo())->max, std::int64_t(1000));
}

void TestMoveLimits::stepsRunOut()
{
    QCOMPARE(device::stepsLeft(0, true), std::int64_t(30719));
    QCOMPARE(device::stepsLeft(30000, true), std::int64_t(719));
    QCOMPARE(device::stepsLeft(30000, false), std::int64_t(60719));
    QCOMPARE(device::stepsLeft(31000, true), std::int64_t(0));
}

void TestMoveLimits::exactTextComesBack_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("role");
    for (const char* family : {"STS", "SMS", "SCS", "HLS", "LX", "SMSMB", "SMCL", "SCS2"}) {
        for (const Role role : {Role::GoalPosition, Role::GoalSpeed})
            QTest::addRow("%s %d", family, int(role)) << text(family) << int(role);
    }
}

void TestMoveLimits::exactTextComesBack()
{
    QFETCH(QString, family);
    QFETCH(int, role);
    Bench bench(family);
    const device::Servo servo = bench.servo();
    const catalog::Register& reg = *servo.profile->byRole(Role(role));
    const catalog::Meaning meaning = servo.meaning(reg);
    for (std::int64_t raw = -1000; raw <= 1000; ++raw) {
        const auto back = catalog::parseValue(device::exactText(raw, meaning), reg, meaning);
        QVERIFY(back.has_value());
        QCOMPARE(*back, raw);
    }
}

void TestMoveLimits::planningAModeWritesNothing()
{
    Bench bench(text("STS"));
    bench.paper().poke(text("min_angle_limit"), 300);
    bench.paper().poke(text("max_angle_limit"), 3333);
    bench.paper().poke(text("torque_switch"), 1);
    device::Servo servo = bench.servo();
    bench.bus.said.clear();
    const auto plan = device::planMode(bench.context(), servo, text("step"));
    QVERIFY(plan.has_value());
    QVERIFY(wroteNothing(bench));
    QCOMPARE(plan->from, text("position"));
    QCOMPARE(plan->to, text("step"));
    QVERIFY(plan->torqueGoesOff && plan->limitsKept);
    QCOMPARE(plan->writes.size(), std::size_t(3));
    QCOMPARE(plan->writes[0].oldRaw, std::int64_t(300));
    QCOMPARE(plan->writes[1].newRaw, std::int64_t(0));
    QCOMPARE(plan->writes[2].key, text("operating_mode"));
    // And it is what is done, and how one gets back.
    QVERIFY(device::switchMode(bench.context(), servo, text("step")));
    const auto back = device::planMode(bench.context(), servo, text("position"));
    QVERIFY(back && back->limitsRestored && !back->torqueGoesOff);
    QCOMPARE(back->writes[1].newRaw, std::int64_t(3333));
    const auto speed = device::planMode(bench.context(), servo, text("speed"));
    QCOMPARE(speed->zeroed, text("goal_speed"));
}

void TestMoveLimits::knownSettingsAreNotReadAgain()
{
    Bench bench(text("STS"));
    device::Servo servo = bench.servo();
    QVERIFY(device::readSettings(bench.context(), servo));
    bench.bus.said.clear();
    device::MoveOrder order{&servo, text("2000")};
    order.settingsMayBe = std::chrono::seconds(1);
    QVERIFY(device::planMove(bench.context(), order));
    QVERIFY(bench.bus.said.empty());
    order.settingsMayBe = {};
    QVERIFY(device::planMove(bench.context(), order));
    QVERIFY(!bench.bus.said.empty());
}

void TestMoveLimits::anotherModeIsRefused()
{
    Bench bench(text("STS"));
    device::Servo servo = inMode(bench, text("step"));
    device::MoveOrder order{&servo, text("2000")};
    order.mode = text("position");
    const auto plan = device::planMove(bench.context(), order);
    QVERIFY(!plan);
    QCOMPARE(plan.error().code, base::ErrorCode::Refused);
    QCOMPARE(plan.error().detail, text("mode-changed"));
}

void TestMoveLimits::currentOfAMove()
{
    Bench bench(text("HLS"));
    device::Servo servo = bench.servo();
    device::MoveOrder order{&servo, text("2000")};
    order.current = text("80");
    std::vector<device::MovePlan> plans;
    auto plan = device::planMove(bench.context(), order);
    QVERIFY(plan.has_value());
    plans.push_back(*plan);
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    QCOMPARE(bench.paper().raw(Role::GoalCurrent), std::int64_t(80));
    order.current = text("-80");
    plan = device::planMove(bench.context(), order);
    QVERIFY(!plan);
    QCOMPARE(plan.error().code, base::ErrorCode::OutOfRange);
    Bench sts(text("STS"));
    device::Servo other = sts.servo();
    order.servo = &other;
    plan = device::planMove(sts.context(), order);
    QVERIFY(!plan);
    QCOMPARE(plan.error().code, base::ErrorCode::NotSupported);
}

void TestMoveLimits::torqueLimits()
{
    const auto of = [](const char* family) {
        return device::torqueLimit(*Bench(text(family)).paper().profile);
    };
    QVERIFY(of("STS").reg != nullptr && !of("STS").temporary);
    QVERIFY(of("SCS").reg != nullptr && of("SCS").temporary);
    QVERIFY(of("SMSMB").reg != nullptr && !of("SMSMB").temporary);
    QVERIFY(of("LX").reg == nullptr);
}

QTEST_GUILESS_MAIN(TestMoveLimits)
#include "tst_move_limits.moc"
