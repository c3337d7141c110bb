// SPDX-License-Identifier: GPL-3.0-or-later
// Motor, play, shaft and load as physics knows them, and the servo's own sense of time.
#include "sim/servo/mechanics.h"
#include "support/test_main.h"
#include "unit/sim/servo_fixture.h"

#include <QRegularExpression>
#include <QTest>

#include <numbers>
#include <vector>

using fixture::Servo;
using sim::Bridge;

class TestMechanics : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void dataSheetFiguresAreMet_data();
    void dataSheetFiguresAreMet();
    void noCreepBelowFriction();
    void shaftIsFreeWithinThePlay();
    void pendulumSwingsOutAndHangs();
    void springPullsToItsCenter();
    void stopsHold();
    void aHandMovesAFreeShaftOnly();
    void brakedMotorResistsAFreeOneDoesNot();
    void currentFollowsTheLoad();
    void supplySagIsOhmsLaw();
    void extremesStayFinite_data();
    void extremesStayFinite();
    void timeStepDoesNotMatter();
    void sameSeedSameBehavior();
    void aSleepingServoWakes();
};

namespace {
constexpr double dt = 0.001;
constexpr double pi = std::numbers::pi;

struct Rig {
    sim::MotorModel motorModel;
    sim::Mechanics mechanics;
    sim::Load load;
    sim::Environment around;

    explicit Rig(const QString& model = QStringLiteral("STS3215"), double play = 0.0,
                 double angle = pi)
        : motorModel(sim::motorModelOf(sim::servoType(*fixture::profileOf(model))))
        , mechanics(motorModel, play, angle, pi)
    {
        around.supplyVolts = sim::servoType(*fixture::profileOf(model)).nominalVolts;
        around.supplyOhms = 0.0;
    }
    void run(double seconds, Bridge bridge = Bridge::Open, double effort = 0.0)
    {
        for (int i = 0; i < int(seconds / dt + 0.5); ++i) {
            mechanics.step(bridge, effort, load, around, dt);
        }
    }
};
} // namespace

void TestMechanics::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestMechanics::dataSheetFiguresAreMet_data()
{
    QTest::addColumn<QString>("model");
    for (const char* model : {"STS3215", "STS3250", "SM40BLHV", "SM45BLHV", "SCS15", "SCS0009"}) {
        QTest::newRow(model) << QString::fromLatin1(model);
    }
}

void TestMechanics::dataSheetFiguresAreMet()
{
    QFETCH(QString, model);
    const sim::ServoType type = sim::servoType(*fixture::profileOf(model));
    Rig free(model);
    free.run(2.0, Bridge::Driven, 1.0);
    QVERIFY(std::abs(free.mechanics.speed() / type.noLoadSpeed() - 1.0) < 0.02);
    QVERIFY(std::abs(free.mechanics.motorAmps() / type.noLoadAmps - 1.0) < 0.25);

    // A spring is wound until the motor stands still: its torque is the stall torque.
    Rig stalled(model);
    stalled.load.springRate = type.stallTorque;
    stalled.load.springCenter = pi;
    stalled.run(3.0, Bridge::Driven, 1.0);
    QVERIFY(std::abs(stalled.mechanics.speed()) < 1e-6);
    const double torque = stalled.load.springRate * (stalled.mechanics.angle() - pi);
    QVERIFY(std::abs(torque / type.stallTorque - 1.0) < 0.1);
    QVERIFY(std::abs(stalled.mechanics.motorAmps() / type.stallAmps - 1.0) < 0.02);
}

void TestMechanics::noCreepBelowFriction()
{
    const sim::MotorModel motorModel = Rig().motorModel;
    const double slides = motorModel.coulomb + motorModel.shaftFriction; // sticking takes more
    const double start = pi + 1.0;
    Rig tilted(QStringLiteral("STS3215"), 0.002, start);
    tilted.load.gravityTorque = 0.9 * slides / std::sin(1.0);
    tilted.run(1.0); // falls through the play first
    const double resting = tilted.mechanics.angle();
    QVERIFY(start - resting <= 0.002);
    tilted.run(60.0);
    QCOMPARE(tilted.mechanics.angle(), resting);
    QVERIFY(tilted.mechanics.isAtRest());
    tilted.load.gravityTorque = 1.5 * slides / std::sin(1.0);
    tilted.run(2.0);
    QVERIFY(resting - tilted.mechanics.angle() > 0.01);
}

void TestMechanics::shaftIsFreeWithinThePlay()
{
    // Driven one way and then back, the motor crosses the whole play before the shaft follows.
    constexpr double play = 0.02;
    Rig rig(QStringLiteral("STS3215"), play);
    rig.load.coulombFriction = 0.05;
    rig.run(0.3, Bridge::Driven, 0.2);
    rig.run(0.5, Bridge::Open);
    const double there = rig.mechanics.angle();
    int waited = 0;
    while (rig.mechanics.angle() == there && waited < 1000) {
        rig.mechanics.step(Bridge::Driven, -0.1, rig.load, rig.around, dt);
        ++waited;
    }
    Rig tight(QStringLiteral("STS3215"), 0.0);
    tight.load.coulombFriction = 0.05;
    tight.run(0.3, Bridge::Driven, 0.2);
    tight.run(0.5, Bridge::Open);
    const double tightThere = tight.mechanics.angle();
    int tightWaited = 0;
    while (tight.mechanics.angle() == tightThere && tightWaited < 1000) {
        tight.mechanics.step(Bridge::Driven, -0.1, tight.load, tight.around, dt);
        ++tightWaited;
    }
    QVERIFY(waited > tightWaited + 10);
    QVERIFY(waited < 1000);
}

void TestMechanics::pendulumSwingsOutAndHangs()
{
    Rig rig(QStringLiteral("STS3215"), 0.0, pi + 1.5);
    rig.load.gravityTorque = 2.0;
    rig.load.inertia = 0.05;
    double peak = 1.5;
    double side = 1.0;
    double maxDeflection = 0.0;
    for (int i = 0; i < 20000; ++i) {
        rig.mechanics.step(Bridge::Open, 0.0, rig.load, rig.around, dt);
        const double swing = rig.mechanics.angle() - pi;
        if (swing * side < 0.0) { // passed the lowest point
            QVERIFY(maxDeflection <= peak + 1e-9);
            peak = std::max(maxDeflection, 0.0001);
            maxDeflection = 0.0;
            side = -side;
        }
        maxDeflection = std::max(maxDeflection, std::abs(swing));
    }
    QVERIFY(rig.mechanics.isAtRest());
    QVERIFY(std::abs(rig.mechanics.angle() - pi) < 0.1);
}

void TestMechanics::springPullsToItsCenter()
{
    Rig rig;
    rig.load.springRate = 5.0;
    rig.load.springCenter = pi + 0.5;
    rig.run(5.0);
    QVERIFY(std::abs(rig.mechanics.angle() - (pi + 0.5)) < 0.05);
}

void TestMechanics::stopsHold()
{
    Rig rig(QStringLiteral("STS3215"), 0.005);
    rig.load.stopHigh = pi + 0.3;
    rig.load.stopLow = pi - 0.2;
    rig.run(1.0, Bridge::Driven, 1.0);
    QCOMPARE(rig.mechanics.angle(), pi + 0.3);
    QCOMPARE(rig.mechanics.speed(), 0.0);
    rig.run(1.0, Bridge::Driven, -1.0);
    QCOMPARE(rig.mechanics.angle(), pi - 0.2);
}

/// To and fro between the stops, at its speed, while the motor turns freely; never against it.
void TestMechanics::aHandMovesAFreeShaftOnly()
{
    Rig rig;
    rig.load.stopLow = pi - 1.0;
    rig.load.stopHigh = pi + 0.5;
    rig.load.handSpeed = 1.0;
    rig.run(0.4);
    QVERIFY(std::abs(rig.mechanics.angle() - (pi + 0.4)) < 0.01);
    rig.run(0.2); // at the stop
    QCOMPARE(rig.mechanics.angle(), pi + 0.5);
    rig.run(2.0);
    QCOMPARE(rig.mechanics.angle(), pi - 1.0);
    const double held = rig.mechanics.angle();
    rig.run(1.0, Bridge::Shorted, 1.0);
    QVERIFY(std::abs(rig.mechanics.angle() - held) < 0.01);
    rig.load.stopLow.reset();
    rig.load.stopHigh.reset();
    rig.run(10.0);
    QVERIFY(std::abs(rig.mechanics.angle() - held) > 2 * pi); // on and on
}

void TestMechanics::brakedMotorResistsAFreeOneDoesNot()
{
    const auto runOut = [](Bridge bridge, double strength) {
        Rig rig;
        rig.run(0.5, Bridge::Driven, 1.0);
        const double start = rig.mechanics.angle();
        rig.run(2.0, bridge, strength);
        return rig.mechanics.angle() - start;
    };
    const double free = runOut(Bridge::Open, 0.0);
    const double half = runOut(Bridge::Shorted, 0.3);
    const double braked = runOut(Bridge::Shorted, 1.0);
    QVERIFY(free > 1.3 * half);
    QVERIFY(half > 1.3 * braked);
    QVERIFY(braked > 0.0);
}

void TestMechanics::currentFollowsTheLoad()
{
    double last = 0.0;
    for (const double friction : {0.0, 0.3, 0.6, 0.9}) {
        Rig rig;
        rig.load.coulombFriction = friction;
        rig.run(1.5, Bridge::Driven, 0.8);
        QVERIFY(rig.mechanics.motorAmps() > last + (friction > 0.0 ? 0.2 : 0.0));
        last = rig.mechanics.motorAmps();
    }
}

void TestMechanics::supplySagIsOhmsLaw()
{
    Rig rig;
    rig.around.supplyOhms = 2.0; // weaker than the motor's own winding, still well-behaved
    rig.load.stopHigh = pi + 0.1;
    rig.run(1.0, Bridge::Driven, 1.0);
    const double amps = rig.mechanics.supplyAmps();
    QVERIFY(amps > 0.5);
    QCOMPARE(rig.mechanics.supplyVolts(rig.around), 7.4 - 2.0 * amps);
    // What is left over the winding drives exactly this current.
    QVERIFY(std::abs(rig.mechanics.motorAmps() * rig.motorModel.resistance -
                     rig.mechanics.supplyVolts(rig.around)) < 1e-9);
}

void TestMechanics::extremesStayFinite_data()
{
    QTest::addColumn<double>("inertia");
    QTest::addColumn<double>("spring");
    QTest::addColumn<double>("viscous");
    QTest::addColumn<double>("friction");
    QTest::newRow("nothing on the shaft") << 0.0 << 0.0 << 0.0 << 0.0;
    QTest::newRow("flywheel") << 50.0 << 0.0 << 0.0 << 0.0;
    QTest::newRow("bar of steel") << 0.0 << 1e7 << 0.0 << 0.0;
    QTest::newRow("in tar") << 0.0 << 0.0 << 1e6 << 0.0;
    QTest::newRow("rusted in") << 1e-9 << 0.0 << 0.0 << 1e6;
}

void TestMechanics::extremesStayFinite()
{
    QFETCH(double, inertia);
    QFETCH(double, spring);
    QFETCH(double, viscous);
    QFETCH(double, friction);
    Rig rig(QStringLiteral("STS3215"), 0.005);
    rig.load = {inertia, viscous, friction, 0.5, spring, pi, {}, {}};
    const double fastest =
        sim::servoType(*fixture::profileOf(QStringLiteral("STS3215"))).noLoadSpeed();
    for (int i = 0; i < 2000; ++i) {
        rig.mechanics.step(Bridge::Driven, i / 200 % 2 == 0 ? 1.0 : -1.0, rig.load, rig.around, dt);
        QVERIFY(std::abs(rig.mechanics.speed()) < 2.0 * fastest);
    }
}

void TestMechanics::timeStepDoesNotMatter()
{
    const auto life = [](base::Duration slice) {
        Servo servo(QStringLiteral("STS3215"));
        servo.set("goal_position", 3000);
        for (base::Duration t{}; t < std::chrono::seconds(1); t += slice) {
            servo.step(slice);
        }
        return servo.shaftDegrees();
    };
    const double whole = life(std::chrono::milliseconds(1));
    QCOMPARE(life(std::chrono::microseconds(100)), whole);
    QCOMPARE(life(std::chrono::milliseconds(4)), whole);
}

void TestMechanics::sameSeedSameBehavior()
{
    const auto life = [](std::uint64_t seed) {
        auto config = fixture::configOf(QStringLiteral("STS3215"));
        config.seed = seed;
        Servo servo(QStringLiteral("STS3215"), config);
        servo.set("goal_position", 3000);
        std::vector<int> loads;
        servo.run(600, [&] { loads.push_back(servo.at("present_load")); });
        return loads;
    };
    QCOMPARE(life(7), life(7));
    QVERIFY(life(7) != life(8));
}

void TestMechanics::aSleepingServoWakes()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.run(5000);
    const double start = servo.shaftDegrees();
    servo.run(5000);
    QCOMPARE(servo.shaftDegrees(), start);
    servo.load().springRate = 5.0; // a pull by hand
    servo.load().springCenter = pi + 0.5;
    servo.run(2000);
    const double pulled = servo.shaftDegrees();
    QVERIFY(pulled > start + 15);
    QVERIFY(std::abs(servo.at("present_position") - pulled / 360 * 4096) <= 1);
    servo.run(5000);
    servo.set("goal_position", 2048);
    servo.load().springRate = 0;
    servo.run(1500);
    QVERIFY(std::abs(servo.at("present_position") - 2048) <= 8);
}

SERVODESK_GUILESS_TEST(TestMechanics)
#include "tst_mechanics.moc"
