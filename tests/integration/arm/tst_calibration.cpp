// SPDX-License-Identifier: GPL-3.0-or-later
// From a recorded range to offset and limits, worked out by hand: Present = Actual − Offset, the
// middle of the range reads 2048, and no offset is beyond ±2047. And how readings become a range:
// through the encoder's seam, and never by guessing.
#include "device/reader.h"
#include "jobs/arm/calibration.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QtTest>

#include <algorithm>

using base::JointKind;
using base::JointState;
using jobs::JointCalibration;
using support::SimFixture;
using namespace std::chrono_literals;

namespace {
const QString program = QStringLiteral("test");

jobs::JointRange recorded(std::int64_t low, std::int64_t high)
{
    jobs::JointRange range;
    range.state = JointState::Recorded;
    range.low = low;
    range.high = high;
    return range;
}

/// Feeds it with positions in steps, a reading each 20 ms, at most `stride` apart.
class Hand {
public:
    explicit Hand(const device::Servo& servo)
        : m_recorder(servo)
    {}
    Hand& moveTo(int steps, int stride = 40)
    {
        while (m_at != steps) {
            m_at += std::clamp(steps - m_at, -stride, stride);
            read(20ms, stride * 360.0 / 4096 / 0.02);
        }
        return *this;
    }
    Hand& startAt(int steps)
    {
        m_at = steps;
        return read(20ms, 0);
    }
    Hand& jumpTo(int steps, base::Duration gap, double degreesPerSecond)
    {
        m_at = steps;
        return read(gap, degreesPerSecond);
    }
    const jobs::JointRange& range() const { return m_recorder.range(); }

private:
    Hand& read(base::Duration gap, double degreesPerSecond)
    {
        m_time += gap;
        const int shown = ((m_at % 4096) + 4096) % 4096;
        m_recorder.add(shown, degreesPerSecond, m_time);
        return *this;
    }

    jobs::JointRangeRecorder m_recorder;
    int m_at = 0;
    base::Duration m_time{};
};
} // namespace

class TestCalibration : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theMiddleReads2048_data()
    {
        QTest::addColumn<int>("oldOffset");
        QTest::addColumn<int>("low"); // as read under the old offset
        QTest::addColumn<int>("high");
        QTest::addColumn<int>("offset");
        QTest::addColumn<int>("newLow");
        // Middle 2048 already.
        QTest::newRow("already in the middle") << 0 << 1048 << 3048 << 0 << 1048;
        QTest::newRow("above") << 0 << 2000 << 4000 << 952 << 1048;
        QTest::newRow("below") << 0 << 100 << 1100 << -1448 << 1548;
        QTest::newRow("through the seam") << 0 << 3500 << 5000 << -1894 << 1298;
        QTest::newRow("with an old offset") << 850 << 100 << 1100 << -598 << 1548;
        // Middle 0: −2048 cannot be stored, so it reads 2047.
        QTest::newRow("on the seam") << 0 << -500 << 500 << -2047 << 1547;
        // Actual middle 2046 + 2048: 2046.
        QTest::newRow("the largest") << 0 << 3594 << 4594 << 2046 << 1548;
    }
    void theMiddleReads2048()
    {
        QFETCH(int, oldOffset);
        QFETCH(int, low);
        QFETCH(int, high);
        QFETCH(int, offset);
        QFETCH(int, newLow);
        SimFixture fixture(QStringLiteral("sts3215@1"));
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("position_offset"), oldOffset);
        const device::Servo servo = readServo(fixture);
        const auto values = jobs::calibrationOf(servo, JointKind::Limited, recorded(low, high));
        QVERIFY(values);
        QCOMPARE(values->homingOffset, offset);
        QCOMPARE(values->rangeMin, newLow);
        QCOMPARE(values->rangeMax, newLow + high - low);
    }

    /// LeRobot's procedure: the pose that is shown reads 2047.
    void theShownPoseReads2047()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        const device::Servo servo = readServo(fixture);
        const auto values =
            jobs::calibrationOf(servo, JointKind::Limited, recorded(1000, 3000), 1500);
        QVERIFY(values);
        QCOMPARE(*values, (JointCalibration{1500 - 2047, 1547, 3547}));
        const auto tooFar =
            jobs::calibrationOf(servo, JointKind::Limited, recorded(1000, 3900), 1500);
        QVERIFY(!tooFar);
        QCOMPARE(tooFar.error().detail, QStringLiteral("joint-beyond-turn"));
    }

    void whatTurnsFreelyKeepsItsOffset()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("position_offset"), -77);
        jobs::JointRange range = recorded(0, 4090);
        range.state = JointState::FullTurn;
        const device::Servo servo = readServo(fixture);
        const auto values = jobs::calibrationOf(servo, JointKind::Continuous, range);
        QVERIFY(values);
        QCOMPARE(*values, (JointCalibration{-77, 0, 4095}));
        // A joint with two stops cannot: another servo has its ID, or it is loose.
        const auto refused = jobs::calibrationOf(servo, JointKind::Limited, range);
        QVERIFY(!refused);
        QCOMPARE(refused.error().detail, QStringLiteral("joint-full-turn"));
    }

    void anUnknownRangeIsRefused()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        const device::Servo servo = readServo(fixture);
        for (const JointState state : {JointState::NotMoved, JointState::KeepMoving,
                                       JointState::LostTrack, JointState::NoReply}) {
            jobs::JointRange range = recorded(1000, 3000);
            range.state = state;
            const auto values = jobs::calibrationOf(servo, JointKind::Limited, range);
            QVERIFY(!values);
            QCOMPARE(values.error().detail, state == JointState::LostTrack
                                                ? QStringLiteral("joint-lost-track")
                                                : QStringLiteral("joint-not-recorded"));
            QCOMPARE(values.error().id, 1);
        }
    }

    /// There the register holds the remaining distance.
    void aJointInStepModeIsRefused()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("operating_mode"), 3);
        const auto possible = jobs::requireCalibratable(readServo(fixture));
        QVERIFY(!possible);
        QCOMPARE(possible.error().detail, QStringLiteral("joint-in-step-mode"));
    }

    void valuesOfAnotherArmAreRefused_data()
    {
        QTest::addColumn<int>("offset");
        QTest::addColumn<int>("min");
        QTest::addColumn<int>("max");
        QTest::addColumn<bool>("isValid");
        QTest::newRow("largest") << 2047 << 0 << 4095 << true;
        QTest::newRow("smallest") << -2047 << 1 << 2 << true;
        QTest::newRow("offset beyond") << 2048 << 1000 << 3000 << false;
        QTest::newRow("offset of another maker") << -30'000 << 1000 << 3000 << false;
        QTest::newRow("no limits") << 0 << 0 << 0 << false;
        QTest::newRow("turned around") << 0 << 3000 << 1000 << false;
        QTest::newRow("below") << 0 << -1 << 1000 << false;
        QTest::newRow("above") << 0 << 0 << 4096 << false;
    }
    void valuesOfAnotherArmAreRefused()
    {
        QFETCH(int, offset);
        QFETCH(int, min);
        QFETCH(int, max);
        QFETCH(bool, isValid);
        SimFixture fixture(QStringLiteral("sts3215@1"));
        QCOMPARE(jobs::requireValid(readServo(fixture), {offset, min, max}).has_value(), isValid);
    }

    void aServoWithoutOffsetGetsItsLimitsOnly()
    {
        SimFixture fixture(QStringLiteral("scs15@1"));
        const device::Servo servo = readServo(fixture);
        const auto values = jobs::calibrationOf(servo, JointKind::Limited, recorded(200, 900));
        QVERIFY(values);
        QCOMPARE(*values, (JointCalibration{0, 200, 900}));
        const auto written = jobs::calibrationTemplate(servo, JointKind::Limited, *values, program);
        QVERIFY(written.find(QStringLiteral("position_offset")) == nullptr);
        QCOMPARE(written.find(QStringLiteral("min_angle_limit"))->raw,
                 std::optional<std::int64_t>(200));
    }

    /// A joint in wheel mode would turn on and on, and LeRobot clears the bit that counts turns; a
    /// wheel keeps its mode.
    void jointsGetPositionModeAndWheelsKeepTheirs()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        const device::Servo unchanged = readServo(fixture);
        QVERIFY(jobs::changesOf(unchanged, jobs::positionSettings(unchanged, JointKind::Gripper))
                    .empty());
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("operating_mode"), 1);
        fixture.poke(1, QStringLiteral("phase"), 12 | 16);
        const device::Servo servo = readServo(fixture);
        const auto joint =
            jobs::calibrationTemplate(servo, JointKind::Gripper, {10, 1000, 3000}, program);
        QCOMPARE(joint.find(QStringLiteral("operating_mode"))->raw, std::optional<std::int64_t>(0));
        QCOMPARE(joint.find(QStringLiteral("phase"))->raw, std::optional<std::int64_t>(12));
        const auto wheel =
            jobs::calibrationTemplate(servo, JointKind::Wheel, {0, 0, 4095}, program);
        QVERIFY(wheel.find(QStringLiteral("operating_mode")) == nullptr);
        QVERIFY(wheel.isTemplate);
    }

    void theRangeGrowsThroughTheSeam()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        Hand hand(readServo(fixture));
        QCOMPARE(hand.range().state, JointState::NoReply);
        hand.startAt(3900);
        QCOMPARE(hand.range().state, JointState::NotMoved);
        hand.moveTo(4050);
        QCOMPARE(hand.range().state, JointState::KeepMoving);
        hand.moveTo(5200).moveTo(2900);
        QCOMPARE(hand.range().state, JointState::Recorded);
        QCOMPARE(hand.range().high - hand.range().low, std::int64_t(2300));
        QCOMPARE(hand.range().now, hand.range().low);
        hand.moveTo(7000);
        QCOMPARE(hand.range().state, JointState::FullTurn);
    }

    /// Lost readings are bridged while half a turn was out of reach meanwhile.
    void lostReadingsAreNotGuessed()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        const device::Servo servo = readServo(fixture);
        Hand bridged(servo);
        bridged.startAt(1000).moveTo(2000).jumpTo(2300, 200ms, 150).moveTo(2600);
        QCOMPARE(bridged.range().state, JointState::Recorded);
        QCOMPARE(bridged.range().high - bridged.range().low, std::int64_t(1600));

        Hand fast(servo);
        fast.startAt(1000).moveTo(2000).jumpTo(3900, 300ms, 700);
        QCOMPARE(fast.range().state, JointState::LostTrack);
        fast.moveTo(4500); // what follows does not make it known again
        QCOMPARE(fast.range().state, JointState::LostTrack);

        Hand late(servo); // its speed at both ends says nothing about the time between
        late.startAt(1000).moveTo(2000).jumpTo(2050, 800ms, 0);
        QCOMPARE(late.range().state, JointState::LostTrack);
    }

private:
    static device::Servo readServo(SimFixture& fixture)
    {
        device::Servo servo = fixture.servo(1);
        if (!device::readAll(fixture.context(), servo))
            qFatal("not readable");
        return servo;
    }
};

SERVODESK_GUILESS_TEST(TestCalibration)
#include "tst_calibration.moc"
