// SPDX-License-Identifier: GPL-3.0-or-later
// Random arms of six joints whose ranges lie anywhere, the encoder's seam inside half of them, with
// old offsets, noise and 2 % lost readings, moved by a hand at any speed: after the calibration the
// middle of each joint reads 2048 ± 2, its limits are the stops within 3 steps, and LeRobot's own
// comparison accepts the file. Fifty here, 500 in the deep check.
#include "device/reader.h"
#include "jobs/arm/calibration.h"
#include "jobs/arm/joint_access.h"
#include "jobs/arm/record_ranges.h"
#include "support/deep_check.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>

using support::SimFixture;
using support::SimFixtureOptions;

namespace {
constexpr double armStepsPerDegree = 4096.0 / 360;

struct TrueJoint {
    double low = 0; ///< degrees from the encoder's zero
    double high = 0;
    int oldOffset = 0;
};

class RandomArm {
public:
    explicit RandomArm(std::uint64_t seed)
        : m_random(seed)
    {
        m_options.wire.seed = seed;
        m_options.wire.faults.drop = 0.02;
        for (int id = 1; id <= 6; ++id)
            addJoint(id);
    }
    const std::vector<TrueJoint>& joints() const { return m_joints; }
    std::unique_ptr<SimFixture> make()
    {
        auto fixture = std::make_unique<SimFixture>(m_specs, m_options);
        for (std::size_t i = 0; i < m_joints.size(); ++i) {
            const int id = int(i) + 1;
            fixture->poke(id, QStringLiteral("lock"), 0);
            fixture->poke(id, QStringLiteral("position_offset"), m_joints[i].oldOffset);
            fixture->poke(id, QStringLiteral("lock"), 1);
        }
        return fixture;
    }

private:
    double between(double low, double high)
    {
        return std::uniform_real_distribution(low, high)(m_random);
    }
    void addJoint(int id)
    {
        const double range = between(30, 340);
        // The seam in the middle half of the range, or outside of it.
        const bool hasSeam = id % 2 == 0;
        const double middle =
            hasSeam ? between(-range / 4, range / 4) : between(range / 2, 360 - range / 2);
        TrueJoint joint{middle - range / 2, middle + range / 2,
                        int(std::lround(between(-2047, 2047)))};
        sim::ServoSpec spec{QStringLiteral("STS3215"), id, 1'000'000, {}, {}, {}, nullptr};
        spec.initialDegrees = between(joint.low, joint.high);
        spec.load.stopLow = joint.low * std::numbers::pi / 180;
        spec.load.stopHigh = joint.high * std::numbers::pi / 180;
        spec.load.handSpeed = between(60, 200) * std::numbers::pi / 180;
        spec.defects.positionNoise = 0.5;
        m_specs.push_back(spec);
        m_joints.push_back(joint);
    }

    std::mt19937_64 m_random;
    SimFixtureOptions m_options;
    std::vector<sim::ServoSpec> m_specs;
    std::vector<TrueJoint> m_joints;
};

/// What LeRobot reads: two bytes, the sign in bit 11 of the offset.
int registerOf(SimFixture& fixture, int id, int address, bool isOffset)
{
    bus::Transaction transaction;
    transaction.request = protocol::Request::read(id, address, 2);
    transaction.retries = 20;
    const auto outcome = fixture.bus().transact(transaction);
    if (!outcome)
        return -100'000;
    const int raw = outcome->data()[0] | outcome->data()[1] << 8;
    return isOffset && (raw & 0x800) != 0 ? -(raw & 0x7FF) : raw;
}
} // namespace

class TestRandomArms : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyArmIsCalibrated()
    {
        const int arms = support::isDeepCheck() ? 500 : 50;
        for (int seed = 1; seed <= arms; ++seed) {
            RandomArm arm{std::uint64_t(seed)};
            const auto fixture = arm.make();
            const QByteArray where = "arm " + QByteArray::number(seed);
            const auto file = calibrate(*fixture, where);
            if (QTest::currentTestFailed())
                return;
            for (std::size_t i = 0; i < arm.joints().size(); ++i) {
                verifyJoint(*fixture, arm.joints()[i], file.joints[i], where);
                if (QTest::currentTestFailed())
                    return;
            }
        }
    }

    /// One that turns further than a turn keeps its offset, and its limits are the turn's ends.
    void aJointBeyondATurnIsContinuous()
    {
        sim::ServoSpec spec{QStringLiteral("STS3215"), 1, 1'000'000, {}, {}, {}, nullptr};
        spec.initialDegrees = 200;
        spec.load.stopLow = -0.5 * std::numbers::pi;
        spec.load.stopHigh = 2 * std::numbers::pi;
        spec.load.handSpeed = 2;
        SimFixture fixture(std::vector{spec});
        std::vector<device::Servo> servos{fixture.servo(1)};
        const auto ranges = record(fixture, servos, std::chrono::seconds(10));
        QVERIFY(ranges);
        QCOMPARE(ranges->front().state, base::JointState::FullTurn);
        const auto values =
            jobs::calibrationOf(servos.front(), base::JointKind::Continuous, ranges->front());
        QVERIFY(values);
        QCOMPARE(*values, (jobs::JointCalibration{0, 0, 4095}));
    }

    /// A servo whose positions have no degrees, and LX servos: ranges in steps, the offset stays.
    void otherFamiliesGetTheirLimits_data()
    {
        QTest::addColumn<QString>("model");
        QTest::newRow("SCS15") << QStringLiteral("SCS15");
        QTest::newRow("SCS115") << QStringLiteral("SCS115");
    }
    void otherFamiliesGetTheirLimits()
    {
        QFETCH(QString, model);
        sim::ServoSpec spec{model, 1, 1'000'000, {}, {}, {}, nullptr};
        spec.initialDegrees = 100;
        spec.load.stopLow = 60 * std::numbers::pi / 180;
        spec.load.stopHigh = 140 * std::numbers::pi / 180;
        spec.load.handSpeed = 1;
        SimFixture fixture(std::vector{spec});
        std::vector<device::Servo> servos{fixture.servo(1)};
        const auto ranges = record(fixture, servos, std::chrono::seconds(6));
        QVERIFY(ranges);
        QCOMPARE(ranges->front().state, base::JointState::Recorded);
        const auto values =
            jobs::calibrationOf(servos.front(), base::JointKind::Limited, ranges->front());
        QVERIFY(values);
        QVERIFY(values->rangeMax - values->rangeMin > 200); // 80 degrees of 1024 steps
        const auto written =
            jobs::writeJoints(fixture.context(),
                              {jobs::calibrationTemplate(servos.front(), base::JointKind::Limited,
                                                         *values, QStringLiteral("test"))},
                              {});
        QCOMPARE(jobs::verdictName(written.front().verdict), QStringLiteral("done"));
        QCOMPARE(fixture.raw(1, QStringLiteral("max_angle_limit")), values->rangeMax);
    }

    /// Nothing is turned off where a joint cannot be recorded.
    void aJointWithoutPositionKeepsItsTorque()
    {
        SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2"));
        fixture.poke(2, QStringLiteral("lock"), 0);
        fixture.poke(2, QStringLiteral("operating_mode"), 3);
        fixture.poke(1, QStringLiteral("torque_switch"), 1);
        std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
        const auto ranges = record(fixture, servos, std::chrono::seconds(1));
        QVERIFY(!ranges);
        QCOMPARE(ranges.error().id, 2);
        QCOMPARE(fixture.raw(1, QStringLiteral("torque_switch")), 1);
    }

    void torqueIsOffWhileTheJointsAreMoved()
    {
        SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2"));
        for (const int id : {1, 2})
            fixture.poke(id, QStringLiteral("torque_switch"), 1);
        std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
        fixture.clearFrames();
        const auto ranges = record(fixture, servos, std::chrono::seconds(1));
        QVERIFY(ranges);
        for (const int id : {1, 2})
            QCOMPARE(fixture.raw(id, QStringLiteral("torque_switch")), 0);
        QCOMPARE(ranges->front().state, base::JointState::NotMoved);
    }

private:
    static base::Result<std::vector<jobs::JointRange>>
    record(SimFixture& fixture, std::vector<device::Servo>& servos, base::Duration span)
    {
        const base::Duration start = fixture.clock().now();
        return jobs::recordRanges(fixture.context(), servos, [&](const auto&) {
            return fixture.clock().now() - start < span;
        });
    }

    /// As the user does: move, write, export what was read back.
    static jobs::LerobotFile calibrate(SimFixture& fixture, const QByteArray& where)
    {
        jobs::LerobotFile file;
        std::vector<device::Servo> servos;
        for (int id = 1; id <= 6; ++id)
            servos.push_back(fixture.servo(id));
        const auto ranges = record(fixture, servos, std::chrono::seconds(15));
        if (!ranges) {
            QTest::qFail(where + qPrintable(base::errorName(ranges.error().code)), __FILE__,
                         __LINE__);
            return file;
        }
        for (sim::VirtualServo* servo :
             fixture.withBus([](sim::VirtualBus& wire) { return wire.servos(); }))
            servo->load().handSpeed = 0;
        std::vector<snapshot::Snapshot> templates;
        for (std::size_t i = 0; i < servos.size(); ++i) {
            const auto values =
                jobs::calibrationOf(servos[i], base::JointKind::Limited, (*ranges)[i]);
            if (!values) {
                QTest::qFail(where + qPrintable(values.error().detail), __FILE__, __LINE__);
                return file;
            }
            templates.push_back(jobs::calibrationTemplate(servos[i], base::JointKind::Limited,
                                                          *values, QStringLiteral("test")));
        }
        for (const auto& one : jobs::writeJoints(fixture.context(), templates, {})) {
            if (one.verdict != jobs::ApplyVerdict::Done &&
                one.verdict != jobs::ApplyVerdict::AlreadySet)
                QTest::qFail(where + ": " + qPrintable(jobs::verdictName(one.verdict)), __FILE__,
                             __LINE__);
        }
        for (device::Servo& servo : servos) {
            if (!device::readAll(fixture.context(), servo))
                QTest::qFail(where + ": not readable", __FILE__, __LINE__);
            file.joints.push_back({QString::number(servo.id), servo.id, 0,
                                   jobs::calibrationIn(servo).value_or(jobs::JointCalibration{})});
        }
        return file;
    }

    static void verifyJoint(SimFixture& fixture, const TrueJoint& joint,
                            const jobs::LerobotJoint& saved, const QByteArray& where)
    {
        const QByteArray what = where + ", joint " + QByteArray::number(saved.id);
        const int offset = registerOf(fixture, saved.id, 31, true);
        QVERIFY2(offset == saved.calibration.homingOffset, what);
        QVERIFY2(registerOf(fixture, saved.id, 9, false) == saved.calibration.rangeMin, what);
        QVERIFY2(registerOf(fixture, saved.id, 11, false) == saved.calibration.rangeMax, what);
        QVERIFY2(std::abs(offset) <= 2047, what);
        const auto reading = [offset](double degrees) {
            const double steps = degrees * armStepsPerDegree - offset;
            return steps - 4096 * std::floor(steps / 4096);
        };
        QVERIFY2(std::abs(reading((joint.low + joint.high) / 2) - 2048) <= 2, what);
        QVERIFY2(std::abs(reading(joint.low) - saved.calibration.rangeMin) <= 3, what);
        QVERIFY2(std::abs(reading(joint.high) - saved.calibration.rangeMax) <= 3, what);
    }
};

SERVODESK_GUILESS_TEST(TestRandomArms)
#include "tst_random_arms.moc"
