// SPDX-License-Identifier: GPL-3.0-or-later
// A servo is ill by exactly the figures it was given: every defect is found again by a probe that
// steps the servo itself, on several models, ways, speeds and loads. And one without defects is a
// healthy one.
#include "sim/host/presets.h"
#include "support/servo_plant.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "servo_fixture.h"

using fixture::milliseconds;
using fixture::Servo;

namespace {
using catalog::Role;

struct Case {
    QString model;
    int way = 0;
    int speed = 0;
    int acceleration = 0;
    double severity = 0;
    sim::Defects defects{};
};

int startOf(const QString& model)
{
    return model == QLatin1String("STS3215") ? 2000 : 400;
}

/// At its start, ready to move, having come from below.
struct DefectFixture {
    explicit DefectFixture(const Case& test, sim::ServoConfig config)
        : servo(test.model, with(test, std::move(config)))
        , plant(servo)
        , start(startOf(test.model))
        , way(test.way)
        , span(test.speed == 400 ? 6500 : 3000)
    {
        if (servo.profile().protocol == base::Protocol::Lx) {
            put(Role::TorqueSwitch, 1);
        } else if (test.speed != 0) {
            put(Role::GoalSpeed, test.speed);
        }
        if (servo.profile().byRole(Role::Acceleration) != nullptr) {
            put(Role::Acceleration, test.acceleration);
        }
        plant.move(start, milliseconds(4000));
    }
    explicit DefectFixture(const Case& test)
        : DefectFixture(test, fixture::configOf(test.model))
    {}

    static sim::ServoConfig with(const Case& test, sim::ServoConfig config)
    {
        config.defects = test.defects;
        config.load.gravityTorque = test.severity;
        return config;
    }
    void put(Role role, int value) { servo.poke(servo.profile().byRole(role)->key, value); }
    probe::Move out() { return plant.move(start + way, span); }
    probe::Move back() { return plant.move(start, span); }

    Servo servo;
    probe::ServoPlant plant;
    int start;
    int way;
    milliseconds span;
};

QByteArray text(double value)
{
    return QByteArray::number(value);
}

void addRows(const std::vector<int>& smallMoves)
{
    QTest::addColumn<Case>("test");
    const auto row = [](const char* model, int way, int speed, int acceleration, double severity) {
        const auto name = QStringLiteral("%1, %2 steps, speed %3, acceleration %4, %5 N·m")
                              .arg(QLatin1String(model))
                              .arg(way)
                              .arg(speed)
                              .arg(acceleration)
                              .arg(severity);
        QTest::newRow(qPrintable(name))
            << Case{QString::fromLatin1(model), way, speed, acceleration, severity, {}};
    };
    for (const int way : smallMoves) {
        row("STS3215", way, 0, 0, 0);
        row("STS3215", way, 400, 0, 0.3);
        row("STS3215", way, 1500, 20, 0.1);
    }
    for (const int way : {200, 450}) {
        row("SCS15", way, 0, 0, 0);
        row("SCS15", way, 400, 0, 0.2);
        row("LX-16A", way, 0, 0, 0.1);
    }
}

/// A path through moves of every kind, as the registers show it.
std::vector<std::int64_t> positionTrace(Servo& servo)
{
    std::vector<std::int64_t> seen;
    for (const int goal : {2600, 1500, 1510, 2048}) {
        servo.set("goal_position", goal);
        servo.run(700, [&] {
            for (const char* key : {"present_position", "present_speed", "present_load", "moving",
                                    "present_current", "present_voltage"})
                seen.push_back(servo.at(key));
        });
    }
    return seen;
}
} // namespace

class TestDefects : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void restHysteresis_data() { addRows({60, 450, 1500}); }
    void restHysteresis()
    {
        QFETCH(Case, test);
        for (const double steps : {12.0, 7.0}) {
            test.defects.restHysteresis = steps;
            DefectFixture table(test);
            const probe::Move up = table.out();
            const probe::Move down = table.back();
            const double below = up.restPosition() - double(up.goal);
            const double above = down.restPosition() - double(down.goal);
            QVERIFY2(std::abs(above - below - steps) <= 1, text(above - below));
            QVERIFY2(below < 0 && above > 0, text(below));
            QVERIFY(std::abs(up.shaftRestPosition() - up.restPosition()) <= 1);
        }
    }

    // As dry friction does it: a step back that is smaller than it is not made.
    void aSmallStepBackIsAbsorbedByHysteresis()
    {
        DefectFixture table({QStringLiteral("STS3215"), 500, 0, 0, 0, {}});
        table.servo.defects().restHysteresis = 12;
        const double up = table.out().restPosition();
        const double less = table.plant.move(table.start + 490, milliseconds(1000)).restPosition();
        const double more = table.plant.move(table.start + 480, milliseconds(1000)).restPosition();
        QVERIFY2(std::abs(less - up) <= 1, text(less - up));
        QVERIFY2(std::abs(more - (up - 8)) <= 1, text(more - up));
    }

    void staticError_data() { addRows({60, 450, 1500}); }
    void staticError()
    {
        QFETCH(Case, test);
        for (const double steps : {9.0, -14.0}) {
            test.defects.staticError = steps;
            DefectFixture table(test);
            for (const probe::Move& move : {table.out(), table.back()})
                QVERIFY2(std::abs(move.restPosition() - double(move.goal) - steps) <= 1,
                         text(move.restPosition()));
        }
    }

    void overshoot_data() { addRows({200, 450, 1500}); }
    void overshoot()
    {
        QFETCH(Case, test);
        for (const double percent : {5.0, 8.0}) {
            test.defects.overshootPercent = percent;
            DefectFixture table(test);
            for (const probe::Move& move : {table.out(), table.back()}) {
                const double wanted = std::abs(move.way()) * percent / 100;
                const double allowed = std::max(1.0, std::abs(move.way()) * 0.005);
                QVERIFY2(std::abs(move.peakBeyondGoal() - wanted) <= allowed,
                         text(move.peakBeyondGoal()));
                QVERIFY2(std::abs(move.restPosition() - double(move.goal)) <= 1,
                         text(move.restPosition()));
            }
        }
    }

    void theReturnFromAnOvershootIsFastAndFlagged()
    {
        Case test{QStringLiteral("STS3215"), 1000, 0, 0, 0, {}};
        test.defects.overshootPercent = 8;
        DefectFixture table(test);
        table.servo.set("goal_position", table.start + table.way);
        int peak = 0;
        int settled = 0;
        int flagFell = 0;
        std::int64_t maximum = 0;
        for (int ms = 1; ms <= 2000; ++ms) {
            table.servo.run(1);
            const auto peakBeyondGoal = table.plant.reported() - table.start - table.way;
            peak = peakBeyondGoal > maximum ? ms : peak;
            maximum = std::max(maximum, peakBeyondGoal);
            settled = std::abs(peakBeyondGoal) > 2 ? ms : settled;
            flagFell = table.servo.at("moving") != 0 ? ms : flagFell;
        }
        QVERIFY2(settled - peak >= 50 && settled - peak <= 250, text(settled - peak));
        QVERIFY2(flagFell >= settled, text(flagFell - settled));
    }

    void allDefectsTogether_data() { addRows({450, 1500}); }
    void allDefectsTogether()
    {
        QFETCH(Case, test);
        test.defects.restHysteresis = 12;
        test.defects.staticError = -5;
        test.defects.overshootPercent = 8;
        DefectFixture table(test);
        const probe::Move up = table.out();
        const probe::Move down = table.back();
        QVERIFY2(std::abs(up.restPosition() - double(up.goal) + 11) <= 1, text(up.restPosition()));
        QVERIFY2(std::abs(down.restPosition() - double(down.goal) - 1) <= 1,
                 text(down.restPosition()));
        for (const probe::Move& move : {up, down}) {
            const double wanted = test.way * 0.08;
            QVERIFY2(std::abs(move.peakBeyondGoal() - wanted) <= std::max(2.0, test.way * 0.005),
                     text(move.peakBeyondGoal()));
        }
    }

    void topSpeed_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<int>("way");
        QTest::newRow("STS3215") << QStringLiteral("STS3215") << 2000;
        QTest::newRow("SCS15") << QStringLiteral("SCS15") << 580;
        QTest::newRow("LX-16A") << QStringLiteral("LX-16A") << 580;
    }
    void topSpeed()
    {
        QFETCH(QString, model);
        QFETCH(int, way);
        const Case healthy{model, way, 0, 0, 0, {}};
        const double full = DefectFixture(healthy).out().topSpeed();
        for (const double factor : {0.8, 0.5}) {
            Case test = healthy;
            test.defects.speedFactor = factor;
            DefectFixture table(test);
            for (const probe::Move& move : {table.out(), table.back()})
                QVERIFY2(std::abs(move.topSpeed() / full / factor - 1) <= 0.01,
                         text(move.topSpeed() / full));
        }
    }

    void aSlowerSpeedIsRespected()
    {
        Case test{QStringLiteral("STS3215"), 1500, 1500, 0, 0, {}};
        const double full = DefectFixture(test).out().topSpeed();
        test.defects.speedFactor = 0.7;
        QCOMPARE(DefectFixture(test).out().topSpeed(), full);
        test.speed = 2500;
        const double capped = DefectFixture(test).out().topSpeed();
        QVERIFY2(capped < 2150 && capped > 1950, text(capped));
    }

    void speedFallsWithTheLoad()
    {
        Case test{QStringLiteral("STS3215"), 1500, 0, 0, 0, {}};
        test.defects.speedFactor = 0.8;
        test.defects.speedPerLoad = 1.5;
        const double free = DefectFixture(test).out().topSpeed();
        for (const double share : {0.1, 0.2}) {
            sim::ServoConfig config = fixture::configOf(test.model);
            config.load.coulombFriction = share * 1.91; // of its stall torque
            const double loaded = DefectFixture(test, config).out().topSpeed();
            QVERIFY2(std::abs(loaded / free / (1 - 1.5 * share) - 1) <= 0.01, text(loaded / free));
        }
    }

    void wheelModeHasDefectsToo()
    {
        Servo servo(QStringLiteral("STS3215"));
        servo.defects().speedFactor = 0.6;
        servo.set("operating_mode", 1);
        servo.set("goal_speed", 2900);
        servo.set("torque_switch", 1);
        servo.run(2000);
        const double before = servo.shaftSteps();
        servo.run(1000);
        const double speed = std::abs(servo.shaftSteps() - before);
        QVERIFY2(std::abs(speed - 0.6 * 2900) <= 0.02 * 2900, text(speed));
    }

    void noiseIsInTheRegisterOnly_data()
    {
        QTest::addColumn<QString>("model");
        for (const char* model : {"STS3215", "SCS15", "LX-16A"})
            QTest::newRow(model) << QString::fromLatin1(model);
    }
    void noiseIsInTheRegisterOnly()
    {
        QFETCH(QString, model);
        Case test{model, 300, 0, 0, 0, {}};
        test.defects.positionNoise = 3;
        test.defects.staticError = 9; // rests exactly
        DefectFixture table(test);
        probe::Move move = table.out();
        const double shaft = move.shaftRestPosition();
        QVERIFY(std::abs(shaft - double(move.goal) - 9) <= 1);
        // Many, since a deviation found in few samples is a rough one.
        double sum = 0;
        double squares = 0;
        constexpr int count = 20'000;
        for (int i = 0; i < count; ++i) {
            table.servo.run(1);
            const double off = double(table.plant.reported()) - shaft;
            sum += off;
            squares += off * off;
        }
        const double deviation = std::sqrt(squares / count - sum / count * (sum / count));
        QVERIFY2(std::abs(deviation - 3) <= 0.1, text(deviation));
        QVERIFY2(std::abs(sum / count) <= 0.6, text(sum / count));
    }

    void theMovingFlagCanStick_data()
    {
        QTest::addColumn<QString>("model");
        QTest::newRow("STS3215") << QStringLiteral("STS3215");
        QTest::newRow("SCS15") << QStringLiteral("SCS15");
        QTest::newRow("HLS3606") << QStringLiteral("HLS3606");
    }
    void theMovingFlagCanStick()
    {
        QFETCH(QString, model);
        for (const bool stuck : {true, false}) {
            DefectFixture table({model, 300, 0, 0, 0, {}});
            const auto flag = [&] {
                return table.servo.raw(table.servo.profile().byRole(Role::Moving)->key) != 0;
            };
            QVERIFY(!flag());
            table.servo.defects().movingFlagStuck = stuck;
            QCOMPARE(flag(), stuck);
            table.put(Role::GoalPosition, table.start + table.way);
            for (int ms = 0; ms < 1500; ++ms) {
                table.servo.run(1);
                QCOMPARE(flag(), stuck);
            }
        }
    }

    void withoutDefectsNothingIsDifferent()
    {
        Servo never(QStringLiteral("STS3215"));
        Servo repaired(QStringLiteral("STS3215"));
        repaired.defects().restHysteresis = 30;
        repaired.defects() = {};
        QVERIFY(positionTrace(never) == positionTrace(repaired));
    }

    void defectsCanChangeAtRuntime()
    {
        DefectFixture table({QStringLiteral("STS3215"), 450, 1500, 20, 0, {}});
        const double before = table.out().peakBeyondGoal();
        table.back();
        table.servo.defects().overshootPercent = 10;
        table.servo.defects().staticError = 20;
        const probe::Move defective = table.out();
        QVERIFY2(std::abs(defective.peakBeyondGoal() - 45) <= 3, text(defective.peakBeyondGoal()));
        QVERIFY2(std::abs(defective.restPosition() - double(defective.goal) - 20) <= 1,
                 text(defective.restPosition()));
        table.servo.defects() = {};
        table.back();
        const double after = table.out().peakBeyondGoal();
        QVERIFY2(std::abs(after - before) <= 1, text(after));
    }

    // Blocked half way: no overshoot is made up, and the protection does its work.
    void aStopIsStillAStop()
    {
        Case test{QStringLiteral("STS3215"), 1000, 1500, 0, 0, {}};
        test.defects.overshootPercent = 8;
        test.defects.restHysteresis = 12;
        sim::ServoConfig config = fixture::configOf(test.model);
        config.load.stopHigh = 2500 * 2 * 3.14159265358979 / 4096;
        DefectFixture table(test, config);
        const probe::Move move = table.out();
        QVERIFY2(move.peakBeyondGoal() <= -495, text(move.peakBeyondGoal()));
        constexpr int overload = 32;
        QVERIFY((table.servo.at("servo_status") & overload) != 0);
        const probe::Move back = table.back();
        QVERIFY2(std::abs(back.restPosition() - double(back.goal) - 6) <= 1,
                 text(back.restPosition()));
        QCOMPARE(table.servo.at("servo_status"), 0);
    }

    // A potentiometer's range ends; a servo driven beyond it would not find back.
    void overshootEndsAtTheEndOfThePotentiometer()
    {
        Case test{QStringLiteral("SCS15"), 600, 0, 0, 0, {}};
        test.defects.overshootPercent = 10;
        DefectFixture table(test);
        constexpr int last = 1023;
        const int goal = int(table.servo.raw(table.servo.profile().byRole(Role::MaxAngle)->key));
        const probe::Move move = table.plant.move(goal, milliseconds(4000));
        QVERIFY(goal > last - 40);
        QVERIFY2(std::abs(move.restPosition() - goal) <= 1, text(move.restPosition()));
        QCOMPARE(move.peakBeyondGoal(), double(last - goal));
    }

    void aSoftSupplySagsWhileItMoves()
    {
        Case test{QStringLiteral("STS3215"), 1500, 0, 0, 0, {}};
        sim::ServoConfig config = fixture::configOf(test.model);
        config.load.coulombFriction = 0.3;
        config.environment.supplyOhms = 1.5;
        DefectFixture table(test, config);
        const int before = table.servo.at("present_voltage");
        table.put(Role::GoalPosition, table.start + table.way);
        int lowest = before;
        table.servo.run(1000,
                        [&] { lowest = std::min(lowest, table.servo.at("present_voltage")); });
        table.servo.run(2000);
        QVERIFY2(lowest <= before - 5, text(lowest));
        QVERIFY(std::abs(table.servo.at("present_voltage") - before) <= 1);
    }

    void loadHeatsAndTrips()
    {
        Case test{QStringLiteral("STS3215"), 1500, 0, 0, 0, {}};
        sim::ServoConfig config = fixture::configOf(test.model);
        config.load.coulombFriction = 0.4;
        config.environment.ambientCelsius = 65;
        DefectFixture table(test, config);
        constexpr int overtemperature = 4;
        int moves = 0;
        while ((table.servo.at("servo_status") & overtemperature) == 0 && moves < 400) {
            table.put(Role::GoalPosition, table.start + (moves++ % 2 == 0 ? table.way : 0));
            table.servo.run(1000);
        }
        QVERIFY2(moves > 1 && moves < 400, text(moves));
        QVERIFY(table.servo.at("present_temperature") > 70);
        table.servo.environment().ambientCelsius = 30;
        table.servo.setTemperature(30);
        table.servo.run(50);
        QCOMPARE(table.servo.at("servo_status") & overtemperature, 0);
    }

    void listsContainDefects()
    {
        const auto bus = sim::makeServos(
            QStringLiteral("sts3215@1:500000+overshoot=5+rest-hysteresis=12+static-error=-9,"
                           "scs15@2+speed=0.7+speed-per-load=0.5+noise=2+moving=1,sts3215@3+"
                           "load-friction=0.3+stop=200+supply-ohms=1.5+ambient=60"),
            fixture::models(), {});
        QVERIFY(bus.has_value());
        const auto servos = (*bus)->servos();
        sim::Defects first;
        first.overshootPercent = 5;
        first.restHysteresis = 12;
        first.staticError = -9;
        QVERIFY(servos[0]->defects() == first);
        QCOMPARE(servos[0]->baud(), 500'000);
        sim::Defects second;
        second.speedFactor = 0.7;
        second.speedPerLoad = 0.5;
        second.positionNoise = 2;
        second.movingFlagStuck = true;
        QVERIFY(servos[1]->defects() == second);
        QVERIFY(servos[2]->defects() == sim::Defects());
        QCOMPARE(servos[2]->load().coulombFriction, 0.3);
        QVERIFY(std::abs(servos[2]->load().stopHigh.value_or(0) - 3.4907) < 0.001);
        QCOMPARE(servos[2]->environment().supplyOhms, 1.5);
        QCOMPARE(servos[2]->environment().ambientCelsius, 60.0);
    }

    void listsNameTheInvalidDefect_data()
    {
        QTest::addColumn<QString>("said");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* said, const char* named) {
            QTest::newRow(said) << QString::fromLatin1(said) << QString::fromLatin1(named);
        };
        row("sts3215@1+gout=5", "rest-hysteresis");
        row("sts3215@1+overshoot", "NAME=VALUE");
        row("sts3215@1+", "NAME=VALUE");
        row("sts3215@1+overshoot=", "overshoot=");
        row("sts3215@1+overshoot=x", "overshoot=x");
        row("sts3215@1+overshoot=nan", "overshoot=nan");
        row("sts3215@1+overshoot=51", "0 to 50");
        row("sts3215@1+speed=0", "speed=0");
        row("sts3215@1+moving=0.5", "moving=0.5");
        row("sts3215@1+noise=1+noise=2", "twice");
        row("sts3215+speed=0.5@1", "MODEL@ID");
        row("+speed=0.5", "MODEL@ID");
    }
    void listsNameTheInvalidDefect()
    {
        QFETCH(QString, said);
        QFETCH(QString, named);
        const auto bus = sim::makeServos(said, fixture::models(), {});
        QVERIFY(!bus);
        QCOMPARE(bus.error().code, base::ErrorCode::BadArgument);
        QVERIFY2(bus.error().detail.contains(named), qPrintable(bus.error().detail));
    }

    void thePresetHasAHealthyAWornAndABadlyDampedServo()
    {
        const auto bus = sim::makePreset(QStringLiteral("sweep"), fixture::models());
        QVERIFY(bus.has_value());
        std::vector<double> hysteresis;
        std::vector<double> peakBeyondGoal;
        std::vector<double> speed;
        for (sim::VirtualServo* servo : (*bus)->servos()) {
            probe::ServoPlant plant(*servo);
            plant.move(1500, milliseconds(2000));
            const probe::Move up = plant.move(2500, milliseconds(2000));
            const probe::Move down = plant.move(1500, milliseconds(2000));
            hysteresis.push_back(down.restPosition() - 1500 - (up.restPosition() - 2500));
            peakBeyondGoal.push_back(up.peakBeyondGoal());
            speed.push_back(up.topSpeed());
        }
        QCOMPARE(hysteresis.size(), std::size_t{3});
        QVERIFY(hysteresis[0] < 9 && std::abs(hysteresis[1] - 12) <= 1 && hysteresis[2] <= 1);
        QVERIFY(peakBeyondGoal[0] < 10 && peakBeyondGoal[1] < 10 &&
                std::abs(peakBeyondGoal[2] - 80) <= 5);
        QVERIFY(std::abs(speed[1] / speed[0] - 0.8) <= 0.01);
        QVERIFY(std::abs(speed[2] / speed[0] - 1) <= 0.01);
    }
};

SERVODESK_GUILESS_TEST(TestDefects)
#include "tst_defects.moc"
