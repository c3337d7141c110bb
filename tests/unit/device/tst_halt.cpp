// SPDX-License-Identifier: GPL-3.0-or-later
// "Stopped" means that the shaft rests; a servo that keeps turning loses its torque.
#include "device/motion/motion.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QTest>

#include "fake_bus.h"
#include <cmath>

using catalog::Role;
using device::NoticeCode;
using fake::DeviceFixture;
using protocol::Op;
using support::utf8;
using namespace std::chrono_literals;

namespace {
/// A servo in speed mode whose shaft keeps turning after its command is 0; `speed` gives the steps
/// per second at a number of seconds after that.
class CoastingServo {
public:
    CoastingServo(DeviceFixture& fixture, std::function<double(double)> speed, bool showsIt = true)
        : m_fixture(fixture)
        , m_speed(std::move(speed))
        , m_showsIt(showsIt)
    {
        fixture.fake().poke(utf8("operating_mode"), 1);
        fixture.fake().poke(utf8("torque_switch"), 1);
        fixture.fake().poke(utf8("goal_speed"), 500);
        fixture.bus.onRequest = [this](const protocol::Request&) { turn(); };
    }

private:
    void turn()
    {
        fake::Servo& servo = m_fixture.fake();
        const base::Duration now = m_fixture.bus.time.now();
        if (servo.raw(utf8("goal_speed")) != 0)
            m_haltedAt = now;
        const double elapsed = std::chrono::duration<double>(now - m_haltedAt).count();
        const bool driven = servo.raw(utf8("torque_switch")) == 1;
        const double speed = driven ? m_speed(elapsed) : 0;
        m_place += speed * std::chrono::duration<double>(now - m_last).count();
        m_last = now;
        servo.poke(utf8("present_position"), std::lround(m_place) % 4096);
        servo.poke(utf8("present_speed"), m_showsIt ? std::lround(speed) : 0);
        servo.poke(utf8("moving"), m_showsIt && speed > 0 ? 1 : 0);
    }

    DeviceFixture& m_fixture;
    std::function<double(double)> m_speed;
    bool m_showsIt;
    double m_place = 1000;
    base::Duration m_last{};
    base::Duration m_haltedAt{};
};
} // namespace

class TestHalt : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aTurningWheelIsReleased_data();
    void aTurningWheelIsReleased();
    void aBrakingWheelIsWaitedFor_data();
    void aBrakingWheelIsWaitedFor();
    void aBlockedWheelIsReleased();
    void aSwingingServoHolds();
    void aServoThatStopsAnsweringIsReleased();
    void severalAreCommandedFirst();
};

void TestHalt::aTurningWheelIsReleased_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<bool>("showsIt");
    QTest::newRow("full speed") << 2900.0 << true;
    QTest::newRow("slow") << 50.0 << true;
    QTest::newRow("only its position tells") << 2900.0 << false;
}

void TestHalt::aTurningWheelIsReleased()
{
    QFETCH(double, speed);
    QFETCH(bool, showsIt);
    DeviceFixture fixture(utf8("STS"));
    const CoastingServo wheel(
        fixture, [speed](double) { return speed; }, showsIt);
    device::Servo servo = fixture.servo();
    QVERIFY(device::halt(fixture.context(), servo));
    QCOMPARE(fixture.fake().raw(utf8("goal_speed")), std::int64_t(0));
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(0));
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueSwitchedOff), 1);
    QCOMPARE(fixture.noticeCount(NoticeCode::HoldingAt), 0);
    QVERIFY(fixture.bus.time.now() < 3s);
}

void TestHalt::aBrakingWheelIsWaitedFor_data()
{
    QTest::addColumn<double>("braking"); ///< steps/s²
    QTest::newRow("at once") << 1e6;
    QTest::newRow("acceleration 10") << 1000.0;
    QTest::newRow("acceleration 5") << 500.0;
}

void TestHalt::aBrakingWheelIsWaitedFor()
{
    QFETCH(double, braking);
    DeviceFixture fixture(utf8("STS"));
    const CoastingServo wheel(
        fixture, [braking](double elapsed) { return std::max(0.0, 2900 - braking * elapsed); });
    device::Servo servo = fixture.servo();
    QVERIFY(device::halt(fixture.context(), servo));
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(1));
    QCOMPARE(fixture.fake().raw(utf8("present_speed")), std::int64_t(0));
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueSwitchedOff), 0);
    QCOMPARE(fixture.noticeCount(NoticeCode::HoldingAt), 1);
}

/// It would go on as soon as what blocks it is gone.
void TestHalt::aBlockedWheelIsReleased()
{
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().poke(utf8("operating_mode"), 1);
    fixture.fake().poke(utf8("torque_switch"), 1);
    fixture.fake().poke(utf8("moving"), 1);
    device::Servo servo = fixture.servo();
    QVERIFY(device::halt(fixture.context(), servo));
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(0));
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueSwitchedOff), 1);
}

/// A soft loop never shows two equal places; near its goal that is rest.
void TestHalt::aSwingingServoHolds()
{
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().poke(utf8("torque_switch"), 1);
    fixture.fake().poke(utf8("moving"), 1);
    fixture.bus.onRequest = [&](const protocol::Request&) {
        const double seconds = std::chrono::duration<double>(fixture.bus.time.now()).count();
        fixture.fake().poke(utf8("present_position"),
                            2048 + std::lround(20 * std::sin(9 * seconds)));
    };
    device::Servo servo = fixture.servo();
    QVERIFY(device::halt(fixture.context(), servo));
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(1));
    QCOMPARE(fixture.noticeCount(NoticeCode::HoldingAt), 1);
}

void TestHalt::aServoThatStopsAnsweringIsReleased()
{
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().poke(utf8("operating_mode"), 1);
    fixture.fake().poke(utf8("torque_switch"), 1);
    fixture.fake().poke(utf8("goal_speed"), 500);
    device::Servo servo = fixture.servo();
    bool commanded = false;
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        const int speed = fixture.fake().reg(utf8("present_speed")).offset;
        commanded = commanded || fixture.fake().raw(utf8("goal_speed")) == 0;
        const bool covers = request.op == Op::Read && request.address <= speed &&
                            request.address + request.count > speed;
        fixture.fake().baud = commanded && covers ? 1 : 115'200; // this one goes unanswered
    };
    QVERIFY(device::halt(fixture.context(), servo)); // reading shows torque off
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(0));
    QCOMPARE(fixture.noticeCount(NoticeCode::HoldingAt), 0);
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueSwitchedOff), 1);
}

/// The second one does not run on while the first one brakes.
void TestHalt::severalAreCommandedFirst()
{
    DeviceFixture fixture({{"STS", 1}, {"STS", 2}});
    const CoastingServo wheel(fixture,
                              [](double elapsed) { return std::max(0.0, 2900 - 1000 * elapsed); });
    const auto turning = fixture.bus.onRequest;
    fixture.fake(1).poke(utf8("torque_switch"), 1);
    fixture.fake(1).poke(utf8("operating_mode"), 1);
    fixture.fake(1).poke(utf8("goal_speed"), 500);
    device::Servo first = fixture.servo(0);
    device::Servo second = fixture.servo(1);
    const base::Duration begin = fixture.bus.time.now();
    base::Duration commanded{};
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        turning(request);
        if (request.op == Op::Write && request.id == 2)
            commanded = fixture.bus.time.now() - begin;
    };
    const auto halted = device::haltAll(fixture.context(), {&first, &second});
    QCOMPARE(halted.size(), std::size_t(2));
    QVERIFY(halted[0] && halted[1]);
    QVERIFY(commanded > 0ms && commanded < 100ms);
    QCOMPARE(fixture.fake(0).raw(utf8("torque_switch")), std::int64_t(1));
    QCOMPARE(fixture.fake(1).raw(utf8("torque_switch")), std::int64_t(1));
}

SERVODESK_GUILESS_TEST(TestHalt)
#include "tst_halt.moc"
