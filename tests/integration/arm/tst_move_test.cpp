// SPDX-License-Identifier: GPL-3.0-or-later
// The move test of a joint: to both ends of its limits and back with little torque; what is in its
// way is told, and however it ends, the servo is without torque and has its own torque limit again.
#include "device/reader.h"
#include "jobs/arm/joint_access.h"
#include "jobs/arm/move_test.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QtTest>

#include <numbers>

using base::MoveTestState;
using support::SimFixture;

namespace {
constexpr double degree = std::numbers::pi / 180;
constexpr double stepsPerDegree = 4096.0 / 360;

/// A joint at 180°, limits 1000 and 3000 (88° and 264°), with its stops at these angles.
std::vector<sim::ServoSpec> joint(double stopLow, double stopHigh)
{
    sim::ServoSpec spec{QStringLiteral("STS3215"), 1, 1'000'000, {}, {}, {}, nullptr};
    spec.initialDegrees = 180;
    spec.load.stopLow = stopLow * degree;
    spec.load.stopHigh = stopHigh * degree;
    return {spec};
}

device::Servo calibrated(SimFixture& fixture)
{
    fixture.poke(1, QStringLiteral("lock"), 0);
    fixture.poke(1, QStringLiteral("min_angle_limit"), 1000);
    fixture.poke(1, QStringLiteral("max_angle_limit"), 3000);
    fixture.poke(1, QStringLiteral("lock"), 1);
    device::Servo servo = fixture.servo(1);
    if (!jobs::readJoint(fixture.context(), servo))
        qFatal("not readable");
    return servo;
}
} // namespace

class TestMoveTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void bothEndsAreReached()
    {
        SimFixture fixture(joint(80, 270));
        device::Servo servo = calibrated(fixture);
        std::int64_t lowest = 4095;
        std::int64_t highest = 0;
        std::int64_t torqueLimit = 0;
        const auto report = jobs::testMoves(fixture.context(), servo, 30, [&](const auto& now) {
            QCOMPARE(now.state, MoveTestState::Moving);
            lowest = std::min(lowest, now.position);
            highest = std::max(highest, now.position);
            torqueLimit = fixture.raw(1, QStringLiteral("torque_limit"));
        });
        QVERIFY(report);
        QCOMPARE(report->state, MoveTestState::Reached);
        QCOMPARE(torqueLimit, std::int64_t(300));
        // A twentieth of the range away from either end: what is there may be a mechanical stop.
        QVERIFY2(lowest > 1050 && lowest < 1150, QByteArray::number(qint64(lowest)));
        QVERIFY2(highest > 2850 && highest < 2950, QByteArray::number(qint64(highest)));
        QVERIFY(std::abs(report->position - 2048) < 50); // back where it was
        verifySafe(fixture);
    }

    void whatIsInTheWayIsTold()
    {
        SimFixture fixture(joint(80, 230));
        device::Servo servo = calibrated(fixture);
        const auto report = jobs::testMoves(fixture.context(), servo, 30);
        QVERIFY(report);
        QCOMPARE(report->state, MoveTestState::NotReached);
        QCOMPARE(report->goal, std::int64_t(2900));
        QVERIFY(std::abs(double(report->position) - 230 * stepsPerDegree) < 50);
        verifySafe(fixture);
    }

    /// A limit that the user has set lower still is kept.
    void aLowerTorqueLimitStays()
    {
        SimFixture fixture(joint(80, 270));
        device::Servo servo = calibrated(fixture);
        fixture.poke(1, QStringLiteral("torque_limit"), 200);
        std::int64_t torqueLimit = 0;
        const auto report = jobs::testMoves(fixture.context(), servo, 60, [&](const auto&) {
            torqueLimit = fixture.raw(1, QStringLiteral("torque_limit"));
        });
        QVERIFY(report);
        QCOMPARE(torqueLimit, std::int64_t(200));
        QCOMPARE(fixture.raw(1, QStringLiteral("torque_limit")), std::int64_t(200));
    }

    void aStopLeavesItSafe()
    {
        SimFixture fixture(joint(80, 270));
        device::Servo servo = calibrated(fixture);
        const auto report = jobs::testMoves(fixture.context(), servo, 30, [&](const auto& now) {
            if (now.position < 1500)
                fixture.stop().request();
        });
        QVERIFY(!report);
        QCOMPARE(report.error().code, base::ErrorCode::Stopped);
        verifySafe(fixture);
    }

    /// Which turns torque off by itself.
    void anEmergencyStopEndsIt()
    {
        SimFixture fixture(joint(80, 270));
        device::Servo servo = calibrated(fixture);
        const auto report = jobs::testMoves(fixture.context(), servo, 30, [&](const auto& now) {
            if (now.position < 1500)
                fixture.bus().emergency();
        });
        QVERIFY(!report);
        QCOMPARE(report.error().code, base::ErrorCode::Preempted);
        QCOMPARE(fixture.raw(1, QStringLiteral("torque_limit")), std::int64_t(1000));
    }

    /// Held fast before it has begun: told with the goal next to where it stands.
    void aJointThatCannotMoveAtAllIsTold()
    {
        SimFixture fixture(joint(190, 270));
        device::Servo servo = calibrated(fixture);
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("max_angle_limit"), 2000); // below where it stands
        fixture.poke(1, QStringLiteral("lock"), 1);
        QVERIFY(jobs::readJoint(fixture.context(), servo));
        const auto report = jobs::testMoves(fixture.context(), servo, 30);
        QVERIFY(report);
        QCOMPARE(report->state, MoveTestState::NotReached);
        QCOMPARE(report->goal, std::int64_t(1950));
        QVERIFY(std::abs(double(report->position) - 190 * stepsPerDegree) < 50);
        verifySafe(fixture);
    }

    /// The cable falls out while it moves: the torque limit is restored by recovery.
    void aLostLinkLeavesAnOpenIntent()
    {
        SimFixture fixture(joint(80, 270));
        device::Servo servo = calibrated(fixture);
        const auto report = jobs::testMoves(fixture.context(), servo, 30, [&](const auto& now) {
            if (now.position < 1500)
                fixture.cutLink();
        });
        QVERIFY(!report);
        QCOMPARE(report.error().code, base::ErrorCode::LinkLost);
        const auto entries = fixture.journal().entries();
        QVERIFY(entries);
        QVERIFY(std::any_of(entries->begin(), entries->end(), [](const base::JournalEntry& one) {
            return !one.end && one.intent.kind == base::IntentKind::Trial &&
                   one.intent.items.front().key == QLatin1String("torque_limit");
        }));
    }

    void aWheelIsRefusedBeforeAnythingIsWritten()
    {
        SimFixture fixture(joint(80, 270));
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("operating_mode"), 1);
        device::Servo servo = calibrated(fixture);
        const auto report = jobs::testMoves(fixture.context(), servo, 30);
        QVERIFY(!report);
        QCOMPARE(report.error().reason, base::Reason::NotInPositionMode);
        QVERIFY(fixture.onlyReadsSent());
    }

    void aServoWithoutTorqueLimitIsRefused()
    {
        support::SimFixtureOptions options;
        options.baud = 115'200;
        SimFixture fixture(QStringLiteral("lx16a@1"), options);
        device::Servo servo = fixture.servo(1, base::Protocol::Lx);
        QVERIFY(jobs::readJoint(fixture.context(), servo));
        const auto report = jobs::testMoves(fixture.context(), servo, 30);
        QVERIFY(!report);
        QCOMPARE(report.error().detail, QStringLiteral("no-torque-limit"));
        QVERIFY(fixture.onlyReadsSent());
    }

private:
    static void verifySafe(SimFixture& fixture)
    {
        QCOMPARE(fixture.raw(1, QStringLiteral("torque_switch")), std::int64_t(0));
        QCOMPARE(fixture.raw(1, QStringLiteral("torque_limit")), std::int64_t(1000));
        QCOMPARE(fixture.raw(1, QStringLiteral("lock")), std::int64_t(1));
        // As after power-up.
        QCOMPARE(fixture.raw(1, QStringLiteral("goal_speed")), std::int64_t(2900));
        QCOMPARE(fixture.raw(1, QStringLiteral("acceleration")), std::int64_t(0));
        for (const base::Notice& notice : fixture.notices())
            QVERIFY(notice.code != base::NoticeCode::TorqueSwitchedOn);
    }
};

SERVODESK_GUILESS_TEST(TestMoveTest)
#include "tst_move_test.moc"
