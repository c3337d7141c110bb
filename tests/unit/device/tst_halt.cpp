// SPDX-License-Identifier: GPL-3.0-or-later
// "Stopped" is said of a shaft that has come to rest; one that goes on turning loses its torque.
#include "device/motion.h"

#include <QTest>

#include "paper_bus.h"
#include <cmath>

using catalog::Role;
using device::NoticeCode;
using paper::Bench;
using protocol::Op;
using namespace std::chrono_literals;

namespace {
QString text(const char* word)
{
    return QString::fromLatin1(word);
}

/// A servo in speed mode whose shaft goes on after its command is 0, at this many steps a second at
/// so many seconds after that.
class Wheel {
public:
    Wheel(Bench& bench, std::function<double(double)> speed, bool showsIt = true)
        : m_bench(bench)
        , m_speed(std::move(speed))
        , m_showsIt(showsIt)
    {
        bench.paper().poke(text("operating_mode"), 1);
        bench.paper().poke(text("torque_switch"), 1);
        bench.paper().poke(text("goal_speed"), 500);
        bench.bus.onRequest = [this](const protocol::Request&) { turn(); };
    }

private:
    void turn()
    {
        paper::Servo& servo = m_bench.paper();
        const base::Duration now = m_bench.bus.time.now();
        if (servo.raw(text("goal_speed")) != 0)
            m_haltedAt = now;
        const double elapsed = std::chrono::duration<double>(now - m_haltedAt).count();
        const bool driven = servo.raw(text("torque_switch")) == 1;
        const double speed = driven ? m_speed(elapsed) : 0;
        m_place += speed * std::chrono::duration<double>(now - m_last).count();
        m_last = now;
        servo.poke(text("present_position"), std::lround(m_place) % 4096);
        servo.poke(text("present_speed"), m_showsIt ? std::lround(speed) : 0);
        servo.poke(text("moving"), m_showsIt && speed > 0 ? 1 : 0);
    }

    Bench& m_bench;
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

    void aWheelThatKeepsTurningLosesItsTorque_data();
    void aWheelThatKeepsTurningLosesItsTorque();
    void aBrakingWheelIsWaitedFor_data();
    void aBrakingWheelIsWaitedFor();
    void aBlockedWheelLosesItsTorque();
    void aSwingingServoHolds();
    void aServoThatStopsAnsweringLosesItsTorque();
    void severalAreCommandedFirst();
};

void TestHalt::aWheelThatKeepsTurningLosesItsTorque_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<bool>("showsIt");
    QTest::newRow("full speed") << 2900.0 << true;
    QTest::newRow("slow") << 50.0 << true;
    QTest::newRow("only its position tells") << 2900.0 << false;
}

void TestHalt::aWheelThatKeepsTurningLosesItsTorque()
{
    QFETCH(double, speed);
    QFETCH(bool, showsIt);
    Bench bench(text("STS"));
    const Wheel wheel(
        bench, [speed](double) { return speed; }, showsIt);
    device::Servo servo = bench.servo();
    QVERIFY(device::halt(bench.context(), servo));
    QCOMPARE(bench.paper().raw(text("goal_speed")), std::int64_t(0));
    QCOMPARE(bench.paper().raw(text("torque_switch")), std::int64_t(0));
    QCOMPARE(bench.noted(NoticeCode::TorqueSwitchedOff), 1);
    QCOMPARE(bench.noted(NoticeCode::HoldingAt), 0);
    QVERIFY(bench.bus.time.now() < 3s);
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
    Bench bench(text("STS"));
    const Wheel wheel(
        bench, [braking](double elapsed) { return std::max(0.0, 2900 - braking * elapsed); });
    device::Servo servo = bench.servo();
    QVERIFY(device::halt(bench.context(), servo));
    QCOMPARE(bench.paper().raw(text("torque_switch")), std::int64_t(1));
    QCOMPARE(bench.paper().raw(text("present_speed")), std::int64_t(0));
    QCOMPARE(bench.noted(NoticeCode::TorqueSwitchedOff), 0);
    QCOMPARE(bench.noted(NoticeCode::HoldingAt), 1);
}

/// It would go on as soon as what blocks it is gone.
void TestHalt::aBlockedWheelLosesItsTorque()
{
    Bench bench(text("STS"));
    bench.paper().poke(text("operating_mode"), 1);
    bench.paper().poke(text("torque_switch"), 1);
    bench.paper().poke(text("moving"), 1);
    device::Servo servo = bench.servo();
    QVERIFY(device::halt(bench.context(), servo));
    QCOMPARE(bench.paper().raw(text("torque_switch")), std::int64_t(0));
    QCOMPARE(bench.noted(NoticeCode::TorqueSwitchedOff), 1);
}

/// A soft loop never shows two equal places; near its goal that is rest.
void TestHalt::aSwingingServoHolds()
{
    Bench bench(text("STS"));
    bench.paper().poke(text("torque_switch"), 1);
    bench.paper().poke(text("moving"), 1);
    bench.bus.onRequest = [&](const protocol::Request&) {
        const double seconds = std::chrono::duration<double>(bench.bus.time.now()).count();
        bench.paper().poke(text("present_position"),
                           2048 + std::lround(20 * std::sin(9 * seconds)));
    };
    device::Servo servo = bench.servo();
    QVERIFY(device::halt(bench.context(), servo));
    QCOMPARE(bench.paper().raw(text("torque_switch")), std::int64_t(1));
    QCOMPARE(bench.noted(NoticeCode::HoldingAt), 1);
}

void TestHalt::aServoThatStopsAnsweringLosesItsTorque()
{
    Bench bench(text("STS"));
    bench.paper().poke(text("operating_mode"), 1);
    bench.paper().poke(text("torque_switch"), 1);
    bench.paper().poke(text("goal_speed"), 500);
    device::Servo servo = bench.servo();
    bool commanded = false;
    bench.bus.onRequest = [&](const protocol::Request& request) {
        const int speed = bench.paper().reg(text("present_speed")).offset;
        commanded = commanded || bench.paper().raw(text("goal_speed")) == 0;
        const bool covers = request.op == Op::Read && request.address <= speed &&
                            request.address + request.count > speed;
        bench.paper().baud = commanded && covers ? 1 : 115'200; // this one goes unanswered
    };
    QVERIFY(device::halt(bench.context(), servo)); // reading shows torque off
    QCOMPARE(bench.paper().raw(text("torque_switch")), std::int64_t(0));
    QCOMPARE(bench.noted(NoticeCode::HoldingAt), 0);
    QCOMPARE(bench.noted(NoticeCode::TorqueSwitchedOff), 1);
}

/// The second one does not run on while the first one brakes.
void TestHalt::severalAreCommandedFirst()
{
    Bench bench({{"STS", 1}, {"STS", 2}});
    const Wheel wheel(bench, [](double elapsed) { return std::max(0.0, 2900 - 1000 * elapsed); });
    const auto turning = bench.bus.onRequest;
    bench.paper(1).poke(text("torque_switch"), 1);
    bench.paper(1).poke(text("operating_mode"), 1);
    bench.paper(1).poke(text("goal_speed"), 500);
    device::Servo first = bench.servo(0);
    device::Servo second = bench.servo(1);
    const base::Duration begin = bench.bus.time.now();
    base::Duration commanded{};
    bench.bus.onRequest = [&](const protocol::Request& request) {
        turning(request);
        if (request.op == Op::Write && request.id == 2)
            commanded = bench.bus.time.now() - begin;
    };
    const auto halted = device::haltAll(bench.context(), {&first, &second});
    QCOMPARE(halted.size(), std::size_t(2));
    QVERIFY(halted[0] && halted[1]);
    QVERIFY(commanded > 0ms && commanded < 100ms);
    QCOMPARE(bench.paper(0).raw(text("torque_switch")), std::int64_t(1));
    QCOMPARE(bench.paper(1).raw(text("torque_switch")), std::int64_t(1));
}

QTEST_GUILESS_MAIN(TestHalt)
#include "tst_halt.moc"
