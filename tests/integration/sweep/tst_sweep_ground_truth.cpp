// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep test against the simulator's truth: what a servo was given as a defect is found again,
// through the wire, with noise, and good servos are told from bad ones. What no defect says as a
// figure is taken from a twin of the servo that a probe moves without a bus.
#include "jobs/sweep/sweep.h"
#include "support/servo_plant.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using results::Grade;
using results::SweepEnd;
using results::SweepShape;
using support::SimFixture;
using namespace std::chrono_literals;

namespace {
/// Fewer readings than at the fastest rate: what holds for them holds for more.
constexpr int rate = 115'200;

/// One servo, and what it is asked to do.
struct Case {
    sim::ServoSpec servoSpec{};
    std::uint64_t seed = 1;
    results::SweepSpec spec{};
};

QString text(int number)
{
    return QString::number(number);
}

Case sts(SweepShape shape = SweepShape::BothSides)
{
    Case test;
    test.servoSpec.model = QStringLiteral("STS3215");
    test.servoSpec.initialDegrees = 100;
    test.spec.shape = shape;
    test.spec.range = {text(1000), text(2600)};
    test.spec.step = text(400);
    test.spec.speed = text(2000);
    test.spec.acceleration = text(50);
    test.spec.pace = results::SweepPace::Dwell;
    test.spec.pause = 300ms;
    test.spec.cycles = 3;
    return test;
}

Case scs(SweepShape shape = SweepShape::BothSides)
{
    Case test = sts(shape);
    test.servoSpec.model = QStringLiteral("SCS15");
    test.spec.range = {text(300), text(700)};
    test.spec.step = text(100);
    test.spec.speed = text(500);
    test.spec.acceleration.clear();
    return test;
}

std::unique_ptr<SimFixture> fixtureFor(const Case& test)
{
    sim::ServoSpec servoSpec = test.servoSpec;
    servoSpec.baud = rate;
    support::SimFixtureOptions options;
    options.baud = rate;
    options.wire.seed = test.seed;
    return std::make_unique<SimFixture>(std::vector{servoSpec}, options);
}

sim::VirtualServo& servoOf(SimFixture& fixture)
{
    return *fixture.withBus([](sim::VirtualBus& wire) { return wire.servo(1); });
}

base::Result<results::SweepRun> run(SimFixture& fixture, const Case& test,
                                    const jobs::SweepCallbacks& watch = {})
{
    std::vector<device::Servo> servos{fixture.servo(1)};
    jobs::SweepRequest order;
    order.spec = test.spec;
    order.limits = {
        results::builtInSweepLimits(servos[0].profile->modelName, servos[0].profile->series)};
    return jobs::sweep(fixture.context(), servos, order, watch);
}

base::Result<results::SweepRun> run(const Case& test)
{
    return run(*fixtureFor(test), test);
}

QByteArray failure(const base::Result<results::SweepRun>& done)
{
    return done ? results::sweepEndName(done->end).toUtf8()
                : (base::errorName(done.error().code) + u' ' + done.error().detail).toUtf8();
}

const results::SweepMetric& metric(const results::SweepRun& run, const char* key)
{
    for (const results::SweepMetric& one : run.servos.at(0).metrics) {
        if (one.key == QLatin1String(key))
            return one;
    }
    qFatal("no metric %s", key);
}

/// Not measured is no number, which is near nothing.
double found(const results::SweepRun& run, const char* key)
{
    return metric(run, key).value.value_or(std::nan(""));
}

QByteArray mismatchText(double value, double truth)
{
    return QByteArray::number(value) + " instead of " + QByteArray::number(truth);
}

#define FINISH(done)                                                                               \
    QVERIFY2(done, failure(done));                                                                 \
    QVERIFY2(done->end == SweepEnd::Finished, failure(done))
#define VERIFY_NEAR(value, truth, by)                                                              \
    do {                                                                                           \
        const double one = value;                                                                  \
        const double other = truth;                                                                \
        QVERIFY2(std::abs(one - other) <= (by), mismatchText(one, other).constData());             \
    } while (false)

/// Steps of a register as an angle of the shaft.
double radians(double steps, double stepsPerTurn)
{
    return steps / stepsPerTurn * 2 * std::numbers::pi;
}

/// The same servo, moved between the ends of its test without a bus.
struct ReferenceServo {
    explicit ReferenceServo(const Case& test)
        : fixture(fixtureFor(test))
        , servo(servoOf(*fixture))
        , from(test.spec.range.from.toInt())
        , to(test.spec.range.to.toInt())
    {
        if (!test.spec.speed.isEmpty())
            servo.poke(QStringLiteral("goal_speed"), test.spec.speed.toInt());
        if (!test.spec.acceleration.isEmpty())
            servo.poke(QStringLiteral("acceleration"), test.spec.acceleration.toInt());
        probe::ServoPlant(servo).move(from, 4s);
    }

    double topSpeed()
    {
        probe::ServoPlant plant(servo);
        const double there = plant.move(to, 4s).topSpeed();
        return (there + plant.move(from, 4s).topSpeed()) / 2;
    }
    /// Of every millisecond there and back.
    double lowestVoltage()
    {
        std::int64_t least = 1000;
        for (const int goal : {to, from}) {
            servo.poke(QStringLiteral("goal_position"), goal);
            for (int ms = 0; ms < 4000; ++ms) {
                servo.step(1ms);
                least = std::min(least, servo.raw(QStringLiteral("present_voltage")));
            }
        }
        return double(least) / 10;
    }

    std::unique_ptr<SimFixture> fixture;
    sim::VirtualServo& servo;
    int from;
    int to;
};

void addCase(const char* name, Case test, double noise = 0)
{
    test.servoSpec.defects.positionNoise = noise;
    QTest::newRow(name) << test;
}
} // namespace

class TestSweepGroundTruth : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void hysteresis_data();
    void hysteresis();
    void overshoot_data();
    void overshoot();
    void staticError_data();
    void staticError();
    void topSpeed_data();
    void topSpeed();
    void saggingSupply_data();
    void saggingSupply();
    void temperatureRise();
    void overtemperature_data();
    void overtemperature();
    void againstAHardStop_data();
    void againstAHardStop();
    void goodFromBad();
};

void TestSweepGroundTruth::hysteresis_data()
{
    QTest::addColumn<Case>("test");
    addCase("STS, both sides", sts());
    addCase("STS, both sides, noise", sts(), 1.5);
    addCase("STS, stairs", sts(SweepShape::Stairs));
    addCase("STS, stairs, noise", sts(SweepShape::Stairs), 1.5);
    addCase("SCS, both sides", scs());
    addCase("SCS, both sides, noise", scs(), 1);
    addCase("SCS, stairs", scs(SweepShape::Stairs));
}

void TestSweepGroundTruth::hysteresis()
{
    QFETCH(Case, test);
    // Half of 12 steps is beside the target of an SCS, which has a tolerance of 3.
    for (const double truth : {12.0, 7.0}) {
        test.servoSpec.defects.restHysteresis = truth;
        const auto done = run(test);
        FINISH(done);
        VERIFY_NEAR(found(*done, "hysteresis"), truth, 2);
    }
}

void TestSweepGroundTruth::overshoot_data()
{
    QTest::addColumn<Case>("test");
    for (const SweepShape shape : {SweepShape::Sweep, SweepShape::BothSides}) {
        const bool sides = shape == SweepShape::BothSides;
        addCase(sides ? "STS, both sides" : "STS, sweep", sts(shape));
        addCase(sides ? "STS, both sides, noise" : "STS, sweep, noise", sts(shape), 1.5);
        addCase(sides ? "SCS, both sides" : "SCS, sweep", scs(shape));
        addCase(sides ? "SCS, both sides, noise" : "SCS, sweep, noise", scs(shape), 1);
    }
    // It swings beyond 0 and beyond the last step of its encoder.
    Case wrapCase = sts(SweepShape::Sweep);
    wrapCase.spec.range = {QStringLiteral("60"), QStringLiteral("4030")};
    addCase("STS, over the seam", wrapCase);
    addCase("STS, over the seam, noise", wrapCase, 1.5);
}

void TestSweepGroundTruth::overshoot()
{
    QFETCH(Case, test);
    for (const double truth : {5.0, 8.0}) {
        test.servoSpec.defects.overshootPercent = truth;
        const auto done = run(test);
        FINISH(done);
        VERIFY_NEAR(found(*done, "overshoot"), truth, 1);
        VERIFY_NEAR(metric(*done, "overshoot").mean.value(), truth, 1);
    }
}

void TestSweepGroundTruth::staticError_data()
{
    QTest::addColumn<Case>("test");
    addCase("STS", sts());
    addCase("STS, noise", sts(), 1.5);
    addCase("STS, by delay", [] {
        Case test = sts(SweepShape::Sweep);
        test.spec.pace = results::SweepPace::Delay;
        test.spec.pause = 2s;
        return test;
    }());
    addCase("SCS", scs());
    addCase("SCS, noise", scs(), 1);
}

/// 20 steps are outside of the tolerance of either family.
void TestSweepGroundTruth::staticError()
{
    QFETCH(Case, test);
    for (const double truth : {20.0, -20.0, 6.0}) {
        test.servoSpec.defects.staticError = truth;
        const auto done = run(test);
        FINISH(done);
        VERIFY_NEAR(found(*done, "steady_error"), std::abs(truth), 2);
        for (const results::SweepLeg& leg : done->servos[0].legs)
            QVERIFY(leg.steadyError && std::abs(*leg.steadyError - truth) <= 2);
    }
}

void TestSweepGroundTruth::topSpeed_data()
{
    QTest::addColumn<Case>("test");
    Case worn = sts(SweepShape::Sweep);
    worn.spec.range = {text(600), text(3400)};
    worn.spec.speed.clear();
    worn.spec.acceleration = text(0);
    worn.servoSpec.defects.speedFactor = 0.7;
    addCase("STS, worn", worn);
    addCase("STS, worn, noise", worn, 1.5);
    Case loaded = worn;
    loaded.servoSpec.defects.speedFactor = 1;
    loaded.servoSpec.defects.speedPerLoad = 1.5;
    loaded.servoSpec.load.coulombFriction = 0.3;
    addCase("STS, under load", loaded);
    addCase("STS, under load, noise", loaded, 1.5);
    Case capped = worn;
    capped.spec.speed = text(800);
    addCase("STS, slower than it could", capped);
    Case scsWorn = scs(SweepShape::Sweep);
    scsWorn.spec.range = {text(150), text(850)};
    scsWorn.spec.speed.clear();
    scsWorn.servoSpec.defects.speedFactor = 0.7;
    addCase("SCS, worn", scsWorn);
    addCase("SCS, worn, noise", scsWorn, 1);
}

void TestSweepGroundTruth::topSpeed()
{
    QFETCH(Case, test);
    const auto done = run(test);
    FINISH(done);
    const double truth = ReferenceServo(test).topSpeed();
    VERIFY_NEAR(found(*done, "top_speed"), truth, 0.02 * truth);
    const bool capped = !test.spec.speed.isEmpty();
    if (capped) {
        VERIFY_NEAR(found(*done, "top_speed"), 800, 0.02 * 800);
    } else {
        test.servoSpec.defects.speedFactor = 1;
        test.servoSpec.defects.speedPerLoad = 0;
        QVERIFY(truth < 0.9 * ReferenceServo(test).topSpeed());
    }
}

void TestSweepGroundTruth::saggingSupply_data()
{
    QTest::addColumn<Case>("test");
    QTest::addColumn<double>("ohms");
    for (Case test : {sts(SweepShape::Sweep), scs(SweepShape::Sweep)}) {
        test.servoSpec.load.coulombFriction =
            test.servoSpec.model == QLatin1String("SCS15") ? 0.1 : 0.3;
        const QByteArray name = test.servoSpec.model.toLatin1();
        QTest::newRow(name + ", good supply") << test << 0.05;
        QTest::newRow(name + ", long cable") << test << 1.0;
        QTest::newRow(name + ", weak supply") << test << 2.0;
    }
}

void TestSweepGroundTruth::saggingSupply()
{
    QFETCH(Case, test);
    QFETCH(double, ohms);
    test.servoSpec.supplyOhms = ohms;
    const auto done = run(test);
    FINISH(done);
    const double truth = ReferenceServo(test).lowestVoltage();
    VERIFY_NEAR(found(*done, "voltage_min"), truth, 0.1 + 0.02 * truth);
}

/// Five minutes of work against much friction.
void TestSweepGroundTruth::temperatureRise()
{
    Case test = sts(SweepShape::Sweep);
    test.servoSpec.load.coulombFriction = 0.6;
    test.spec.cycles = 0;
    test.spec.length = 5min;
    const auto fixture = fixtureFor(test);
    const sim::VirtualServo& servo = servoOf(*fixture);
    std::int64_t before = 0;
    std::int64_t maximum = 0;
    jobs::SweepCallbacks watch;
    watch.onSample = [&](std::size_t, const jobs::SweepSample&, double, int leg) {
        const std::int64_t now = servo.raw(QStringLiteral("present_temperature"));
        (leg == 0 ? before : maximum) = leg == 0 ? now : std::max(maximum, now);
    };
    const auto done = run(*fixture, test, watch);
    FINISH(done);
    QVERIFY2(maximum - before >= 5, mismatchText(double(maximum), double(before)));
    VERIFY_NEAR(found(*done, "temperature_rise"), double(maximum - before), 1);
    VERIFY_NEAR(found(*done, "temperature_max"), double(maximum), 1);
}

void TestSweepGroundTruth::overtemperature_data()
{
    QTest::addColumn<Case>("test");
    addCase("STS", sts());
    addCase("SCS", scs());
}

void TestSweepGroundTruth::overtemperature()
{
    QFETCH(Case, test);
    const auto fixture = fixtureFor(test);
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 3)
            servoOf(*fixture).setTemperature(95);
    };
    const auto done = run(*fixture, test, watch);
    QVERIFY2(done, failure(done));
    QVERIFY2(done->end == SweepEnd::Alarm, failure(done));
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(done->verdict(), Grade::Fail);
    QCOMPARE(done->servos[0].legs.size(), std::size_t(4));
    VERIFY_NEAR(found(*done, "temperature_max"), 95, 1);
    QCOMPARE(found(*done, "alarms"), 1.0);
    QCOMPARE(fixture->raw(1, QStringLiteral("torque_switch")), 0);
}

void TestSweepGroundTruth::againstAHardStop_data()
{
    QTest::addColumn<Case>("test");
    QTest::addColumn<double>("stop");
    QTest::addColumn<bool>("looksForStall");
    const double stsStop = radians(2200, 4096);
    QTest::newRow("STS, the test sees it") << sts() << stsStop << true;
    QTest::newRow("STS, the servo says so") << sts() << stsStop << false;
    const double scsStop = radians(450, 1024 * 360.0 / 220);
    QTest::newRow("SCS, the test sees it") << scs() << scsStop << true;
    QTest::newRow("SCS, the servo says so") << scs() << scsStop << false;
}

void TestSweepGroundTruth::againstAHardStop()
{
    QFETCH(Case, test);
    QFETCH(double, stop);
    QFETCH(bool, looksForStall);
    test.servoSpec.load.stopHigh = stop;
    test.spec.stopOnStall = looksForStall;
    const auto fixture = fixtureFor(test);
    const auto done = run(*fixture, test);
    QVERIFY2(done, failure(done));
    const bool alarm = done->end == SweepEnd::Alarm;
    QVERIFY2(alarm || (looksForStall && done->end == SweepEnd::Stall), failure(done));
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(done->verdict(), Grade::Fail);
    QCOMPARE(fixture->raw(1, QStringLiteral("torque_switch")), 0);
}

namespace {
/// A servo as the seed has it: every second one bad, in one way.
class RandomServo {
public:
    explicit RandomServo(unsigned seed)
        : m_seed(seed)
        , m_random(seed)
    {}

    bool bad() const { return m_seed % 2 == 1; }

    Case test()
    {
        Case test = sts();
        test.seed = m_seed;
        const int from = int(between(500, 1200));
        const int to = from + int(between(900, 2400));
        test.spec.range = {text(from), text(to)};
        test.spec.speed = text(int(between(900, 2600)));
        test.spec.acceleration = text(int(between(20, 120)));
        test.servoSpec.initialDegrees = between(60, 250);
        test.servoSpec.supplyVolts = between(6.8, 7.8);
        test.servoSpec.load.inertia = between(1e-4, 4e-4);
        test.servoSpec.load.gravityTorque = between(0, 0.05);
        test.servoSpec.load.coulombFriction = between(0, 0.01);
        test.servoSpec.defects.positionNoise = between(0.5, 1.5);
        if (bad())
            spoil(test, to);
        else
            makeGood(test.servoSpec.defects);
        return test;
    }
    const QString& defectName() const { return m_defectName; }

private:
    double between(double low, double high)
    {
        return low + (high - low) * double(m_random()) / 4294967296.0;
    }
    double randomSign(double low, double high)
    {
        const double size = between(low, high);
        return m_random() % 2 == 0 ? size : -size;
    }

    /// The limits are 11 steps, 5 %, 16 steps, and no target missed.
    void spoil(Case& test, int to)
    {
        sim::Defects& defects = test.servoSpec.defects;
        switch (m_seed / 2 % 4) {
        case 0:
            defects.restHysteresis = std::round(between(15, 40));
            m_defectName = QStringLiteral("hysteresis %1").arg(defects.restHysteresis);
            break;
        case 1:
            defects.overshootPercent = between(7, 15);
            m_defectName = QStringLiteral("overshoot %1").arg(defects.overshootPercent);
            break;
        case 2:
            defects.staticError = std::round(randomSign(20, 50));
            m_defectName = QStringLiteral("static error %1").arg(defects.staticError);
            break;
        default:
            const double away = between(25, 400);
            test.servoSpec.load.stopHigh = radians(to - away, 4096);
            m_defectName = QStringLiteral("stop %1 before the end").arg(away);
        }
    }

    void makeGood(sim::Defects& defects)
    {
        switch (m_seed / 2 % 5) {
        case 0:
            defects.restHysteresis = std::round(between(1, 7));
            break;
        case 1:
            defects.overshootPercent = between(0.5, 3.5);
            break;
        case 2:
            defects.staticError = std::round(randomSign(1, 10));
            break;
        case 3:
            defects.speedFactor = between(0.8, 1);
            break;
        default:
            break; // as it came from the factory
        }
        m_defectName = QStringLiteral("nothing (hysteresis %1, overshoot %2, error %3, speed %4)")
                           .arg(defects.restHysteresis)
                           .arg(defects.overshootPercent)
                           .arg(defects.staticError)
                           .arg(defects.speedFactor);
    }

    unsigned m_seed;
    std::mt19937 m_random;
    QString m_defectName;
};

/// What was measured, for whoever has to find out why it was graded so.
QString figures(const base::Result<results::SweepRun>& done)
{
    QString all = QString::fromUtf8(failure(done));
    if (!done)
        return all;
    for (const char* key : {"hysteresis", "overshoot", "steady_error", "repeatability_range",
                            "missed_targets", "moving_flag_errors"})
        all += QStringLiteral(", %1 %2").arg(QLatin1String(key)).arg(found(*done, key));
    return all + u' ' + results::gradeName(done->verdict());
}
} // namespace

/// These seeds were not looked at while anything was tuned; for others set SWEEP_TRUTH_SEED.
void TestSweepGroundTruth::goodFromBad()
{
    bool given = false;
    const int asked = qEnvironmentVariableIntValue("SWEEP_TRUTH_SEED", &given);
    const unsigned first = given ? unsigned(asked) : 1000;
    int right = 0;
    QStringList wrong;
    QStringList passed; // although bad
    for (unsigned seed = first; seed < first + 100; ++seed) {
        RandomServo draw(seed);
        const Case test = draw.test();
        const auto done = run(test);
        // A bad one is failed, a warning does not do; a good one may be warned of.
        const bool failed = done && done->verdict() == Grade::Fail;
        const bool accepted =
            done && (done->verdict() == Grade::Pass || done->verdict() == Grade::Warn);
        const bool good = draw.bad() ? failed : accepted;
        right += good ? 1 : 0;
        const QString line =
            QStringLiteral("%1: %2: %3").arg(seed).arg(draw.defectName(), figures(done));
        if (given)
            qInfo("%s", qPrintable(line));
        if (!good)
            wrong += line;
        if (draw.bad() && accepted)
            passed += line;
    }
    QVERIFY2(passed.isEmpty(), qPrintable(passed.join(u'\n')));
    qInfo("%d of 100 graded rightly", right);
    QVERIFY2(right >= 99, qPrintable(wrong.join(u'\n')));
}

SERVODESK_GUILESS_TEST(TestSweepGroundTruth)
#include "tst_sweep_ground_truth.moc"
