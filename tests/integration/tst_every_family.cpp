// SPDX-License-Identifier: GPL-3.0-or-later
// Device and jobs against the simulated wire in every language: bad lines, cables pulled at every
// byte, twins, real motion. What is claimed is held against what the servo really has.
#include "device/motion.h"
#include "jobs/change.h"
#include "jobs/recover.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <deque>

using base::ErrorCode;
using catalog::Role;
using device::MoveHow;
using device::MoveOrder;
using device::WriteOutcome;
using jobs::RecoverAction;
using support::SimBench;
using namespace std::chrono_literals;

namespace {
QString text(const char* word)
{
    return QString::fromLatin1(word);
}

const std::vector<base::Protocol> all(base::allProtocols.begin(), base::allProtocols.end());

device::Servo known(SimBench& bench, int id)
{
    auto found = device::identifyAmong(bench.context(), id, all);
    if (!found || !device::readSettings(bench.context(), *found))
        qFatal("servo %d does not answer", id);
    return *found;
}

support::BenchOptions at(int baud)
{
    support::BenchOptions options;
    options.baud = baud;
    return options;
}

bool lockOpen(SimBench& bench, int id)
{
    return bench.withWire([&](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(id);
        const catalog::Register* lock = servo.profile().byRole(Role::Lock);
        return lock != nullptr && servo.raw(lock->key) != 1;
    });
}

std::int64_t rawOf(SimBench& bench, int id, Role role)
{
    return bench.withWire([&](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(id);
        return servo.raw(servo.profile().byRole(role)->key);
    });
}

bool present(SimBench& bench, int id)
{
    return bench.withWire([&](sim::VirtualBus& wire) { return wire.servo(id) != nullptr; });
}

/// About a tenth of a turn a second.
QString slowSpeed(const device::Servo& servo)
{
    const catalog::Register& speed = *servo.profile->byRole(Role::GoalSpeed);
    if (servo.meaning(speed).unit == text("rpm"))
        return text("6rpm");
    return QString::number(servo.profile->stepsPerTurn / 10);
}

void addFamilies()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::newRow("STS") << "sts3215" << 1'000'000 << "max_temperature" << 61;
    QTest::newRow("SCS") << "scs15" << 1'000'000 << "max_temperature" << 61;
    QTest::newRow("HLS") << "hls3606" << 1'000'000 << "protection_current" << 311;
    QTest::newRow("SMCL") << "sm60-360m" << 115'200 << "max_temperature" << 61;
    QTest::newRow("SCS-2") << "scs15-2" << 1'000'000 << "min_startup_force" << 300;
    QTest::newRow("Modbus") << "smsmb" << 115'200 << "position_p" << 21;
    QTest::newRow("Modbus, factory block") << "smsmb" << 115'200 << "max_temperature" << 61;
    QTest::newRow("LX") << "lx16a" << 115'200 << "angle_limit_max" << 900;
    QTest::newRow("LX, saved by command") << "lx224hv" << 115'200 << "angle_offset" << 20;
}
} // namespace

class TestEveryFamily : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void silentLanguagesCostOneQuestion();
    void lostAnswersAreAskedForAgain();
    void badLines_data() { addFamilies(); }
    void badLines();
    void writeCutAtEveryByte_data() { addFamilies(); }
    void writeCutAtEveryByte();
    void newIdCutAtEveryByte_data();
    void newIdCutAtEveryByte();
    void twinsAreNotTaken_data();
    void twinsAreNotTaken();
    void movesArrive_data();
    void movesArrive();
    void haltStopsHere_data() { movesArrive_data(); }
    void haltStopsHere();
    void motorRunsAndStops();
    void storedMovesStartTogether();
    void centreIsKept_data();
    void centreIsKept();
    void overheatedLxIsTold();
};

/// Every command begins with this, so it must not pay for what is not there.
void TestEveryFamily::silentLanguagesCostOneQuestion()
{
    SimBench bench(text("lx16a@1"), at(115200));
    bench.forgetFrames();
    QVERIFY(device::identifyAmong(bench.context(), 1, all).has_value());
    QCOMPARE(bench.frameCount(), all.size());
}

void TestEveryFamily::lostAnswersAreAskedForAgain()
{
    SimBench bench(text("smsmb@1"), at(115200));
    bench.wireConfig().faults.drop = 0.5;
    int known = 0;
    for (int i = 0; i < 20; ++i)
        known += device::identifyAmong(bench.context(), 1, all) ? 1 : 0;
    QVERIFY2(known >= 16, qPrintable(QString::number(known))); // of four tries each one in 16 fails
}

/// Checksum errors, lost requests, lost and torn replies: whatever is called kept survives,
/// whatever is called refused has not happened, and the lock is closed or the journal knows.
void TestEveryFamily::badLines()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(QString, key);
    QFETCH(int, value);
    int kept = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        auto options = at(baud);
        options.wire.seed = seed;
        SimBench bench(model + text("@1"), options);
        device::Servo servo = known(bench, 1);
        const auto before = bench.raw(1, key);
        auto& faults = bench.wireConfig().faults;
        faults.corrupt = 0.1;
        faults.drop = 0.05;
        faults.dropRequest = 0.05;
        faults.truncate = 0.05;
        faults.garbage = 0.1;
        const auto report = device::write(bench.context(), servo, {{key, value}}, {false, true});
        faults = {};
        const bool open = !bench.journal().open()->empty();
        QVERIFY(open || !lockOpen(bench, 1));
        bench.powerCycle();
        const auto now = bench.raw(1, key);
        QVERIFY(now == before || now == value);
        if (!report || open)
            continue;
        if (report->writes[0].outcome == WriteOutcome::Kept) {
            QCOMPARE(now, std::int64_t(value));
            ++kept;
        } else if (report->writes[0].outcome == WriteOutcome::Refused) {
            QCOMPARE(now, before);
        }
    }
    QVERIFY2(kept >= 6, qPrintable(QString::number(kept)));
}

void TestEveryFamily::writeCutAtEveryByte()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(QString, key);
    QFETCH(int, value);
    int interrupted = 0;
    for (const auto wish : {RecoverAction::Finish, RecoverAction::Undo}) {
        for (std::size_t cut = 1;; ++cut) {
            SimBench bench(model + text("@1"), at(baud));
            device::Servo servo = known(bench, 1);
            const auto before = bench.raw(1, key);
            bench.cutAfterHostBytes(cut);
            const auto report =
                device::write(bench.context(), servo, {{key, value}}, {false, true});
            bench.reconnect(baud);
            if (report && report->allGood())
                break;
            if (bench.journal().open()->empty()) {
                QVERIFY(!lockOpen(bench, 1));
                QCOMPARE(bench.raw(1, key), before);
                continue;
            }
            ++interrupted;
            const auto recovered = jobs::recover(bench.context(), wish);
            QVERIFY(recovered);
            QVERIFY2(recovered->front().done, qPrintable(QString::number(cut)));
            QVERIFY(!lockOpen(bench, 1));
            QVERIFY(bench.journal().open()->empty());
            bench.powerCycle();
            QCOMPARE(bench.raw(1, key), wish == RecoverAction::Finish ? value : before);
        }
    }
    QVERIFY(interrupted > 10);
}

void TestEveryFamily::newIdCutAtEveryByte_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::newRow("HLS") << "hls3606" << 1'000'000;
    QTest::newRow("SMCL") << "sm60-360m" << 115'200;
    QTest::newRow("SCS-2") << "scs15-2" << 1'000'000;
    QTest::newRow("Modbus") << "smsmb" << 115'200;
    QTest::newRow("LX") << "lx16a" << 115'200;
}

void TestEveryFamily::newIdCutAtEveryByte()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    for (std::size_t cut = 1;; ++cut) {
        SimBench bench(model + text("@1"), at(baud));
        device::Servo servo = known(bench, 1);
        bench.cutAfterHostBytes(cut);
        const auto report = jobs::changeId(bench.context(), servo, 9);
        bench.reconnect(baud);
        if (report && report->allGood()) {
            bench.powerCycle();
            QVERIFY(present(bench, 9));
            break;
        }
        if (bench.journal().open()->empty()) {
            QVERIFY(present(bench, 1));
            QVERIFY(!lockOpen(bench, 1));
            continue;
        }
        const auto recovered = jobs::recover(bench.context(), RecoverAction::Finish);
        QVERIFY(recovered);
        QVERIFY2(recovered->front().done, qPrintable(QString::number(cut)));
        bench.powerCycle();
        QVERIFY2(present(bench, 9), qPrintable(QString::number(cut)));
        QVERIFY(!lockOpen(bench, 9));
    }
}

void TestEveryFamily::twinsAreNotTaken_data()
{
    newIdCutAtEveryByte_data();
}

/// Two servos with one ID disagree about themselves: nothing is written to either.
void TestEveryFamily::twinsAreNotTaken()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    SimBench bench(QStringLiteral("%1@1,%1@2").arg(model), at(baud));
    const catalog::ProfilePtr profile = known(bench, 1).profile;
    const QString key = profile->byRole(Role::MinAngle)->key;
    const QString other = profile->byRole(Role::MaxAngle)->key;
    device::Servo servo = known(bench, 1);
    bench.poke(2, key, 77);
    bench.poke(2, profile->byRole(Role::Id)->key, 1);
    bench.forgetFrames();
    const auto report = device::write(bench.context(), servo, {{other, 900}}, {});
    QVERIFY(!report);
    QCOMPARE(base::errorName(report.error().code), base::errorName(ErrorCode::SeveralServos));
    QVERIFY(bench.onlyAsked());
}

void TestEveryFamily::movesArrive_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("away"); ///< from where it stands, in steps
    QTest::addColumn<QString>("time");
    QTest::newRow("STS") << "sts3215" << 1'000'000 << 900 << "";
    QTest::newRow("HLS") << "hls3606" << 1'000'000 << -900 << "";
    QTest::newRow("SMCL") << "sm60-360m" << 115'200 << 900 << "";
    QTest::newRow("SCS-2") << "scs15-2" << 1'000'000 << 250 << "";
    QTest::newRow("Modbus") << "smsmb" << 115'200 << -900 << "";
    QTest::newRow("LX, as fast as it can") << "lx16a" << 115'200 << -250 << "";
    QTest::newRow("LX, in two seconds") << "lx16a" << 115'200 << -300 << "2000";
}

void TestEveryFamily::movesArrive()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(int, away);
    QFETCH(QString, time);
    SimBench bench(model + text("@1"), at(baud));
    device::Servo servo = known(bench, 1);
    const auto goal = rawOf(bench, 1, Role::PresentPosition) + away;
    MoveOrder order{&servo, QString::number(goal)};
    if (!time.isEmpty())
        order.time = time;
    auto plan = device::planMove(bench.context(), order);
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    const base::Duration start = bench.clock().now();
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    const auto arrived = device::waitForArrival(bench.context(), plans, 30s, {});
    QVERIFY2(arrived, arrived ? "" : qPrintable(arrived.error().detail));
    QVERIFY(std::abs(rawOf(bench, 1, Role::PresentPosition) - goal) <= 12);
    QCOMPARE(rawOf(bench, 1, Role::TorqueSwitch), std::int64_t(1));
    if (!time.isEmpty())
        QVERIFY(bench.clock().now() - start >= std::chrono::milliseconds(time.toInt()));
}

void TestEveryFamily::haltStopsHere()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(int, away);
    SimBench bench(model + text("@1"), at(baud));
    device::Servo servo = known(bench, 1);
    const auto from = rawOf(bench, 1, Role::PresentPosition);
    MoveOrder order{&servo, QString::number(from + away)};
    // Slow enough to be caught on the way.
    if (servo.profile->byRole(Role::StoredGoal) != nullptr)
        order.time = text("3000");
    else
        order.speed = slowSpeed(servo);
    auto plan = device::planMove(bench.context(), order);
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    bench.letTimePass(500ms);
    QVERIFY(device::halt(bench.context(), servo));
    bench.letTimePass(300ms);
    const auto here = rawOf(bench, 1, Role::PresentPosition);
    bench.letTimePass(3s);
    QVERIFY(std::abs(rawOf(bench, 1, Role::PresentPosition) - here) <= 3);
    QVERIFY(std::abs(here - from) > 5);
    QVERIFY(std::abs(here - (from + away)) > 20);
    QCOMPARE(rawOf(bench, 1, Role::TorqueSwitch), std::int64_t(1));
}

/// MOVE_STOP does not end motor mode; speed 0 does.
void TestEveryFamily::motorRunsAndStops()
{
    SimBench bench(text("lx16a@1"), at(115'200));
    device::Servo servo = known(bench, 1);
    const auto switched = device::switchMode(bench.context(), servo, text("motor"));
    QVERIFY(switched && switched->allGood());
    QCOMPARE(bench.raw(1, text("load")), std::int64_t(0));
    auto plan = device::planMove(bench.context(), {&servo, text("-400")});
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    const auto from = bench.raw(1, text("position"));
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    QCOMPARE(bench.raw(1, text("motor_speed")), std::int64_t(-400));
    bench.letTimePass(300ms);
    QVERIFY(bench.raw(1, text("position")) != from);
    QVERIFY(device::halt(bench.context(), servo));
    bench.letTimePass(500ms);
    const auto here = bench.raw(1, text("position"));
    bench.letTimePass(1s);
    QVERIFY(std::abs(bench.raw(1, text("position")) - here) <= 2);
}

void TestEveryFamily::storedMovesStartTogether()
{
    SimBench bench(text("lx16a@1,lx224hv@2"), at(115'200));
    std::deque<device::Servo> servos{known(bench, 1), known(bench, 2)};
    std::vector<device::MovePlan> plans;
    for (device::Servo& servo : servos) {
        MoveOrder order{&servo, QString::number(bench.raw(servo.id, text("position")) + 200)};
        order.time = text("1000");
        auto plan = device::planMove(bench.context(), order);
        QVERIFY(plan);
        plans.push_back(*plan);
    }
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Sync));
    bench.letTimePass(500ms);
    for (const device::MovePlan& plan : plans) {
        const auto rest = plan.goalRaw - bench.raw(plan.servo->id, text("position"));
        QVERIFY2(rest > 20 && rest < 180, qPrintable(QString::number(rest)));
    }
    QVERIFY(device::waitForArrival(bench.context(), plans, 10s, {}));
}

void TestEveryFamily::centreIsKept_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::newRow("HLS") << "hls3606" << 1'000'000;
    QTest::newRow("Modbus") << "smsmb" << 115'200;
}

void TestEveryFamily::centreIsKept()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    SimBench bench(model + text("@1"), at(baud));
    device::Servo servo = known(bench, 1);
    auto plan = device::planMove(bench.context(), {&servo, text("1500")});
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    QVERIFY(device::waitForArrival(bench.context(), plans, 20s, {}));
    const auto report = jobs::center(bench.context(), servo);
    QVERIFY2(report, report ? "" : qPrintable(report.error().detail));
    QVERIFY(!lockOpen(bench, 1));
    QVERIFY(std::abs(bench.raw(1, text("present_position")) - 2048) <= 12);
    bench.powerCycle();
    bench.letTimePass(500ms);
    QCOMPARE(bench.raw(1, text("position_offset")), *report->offsetAfter);
    QVERIFY(std::abs(bench.raw(1, text("present_position")) - 2048) <= 12);
}

void TestEveryFamily::overheatedLxIsTold()
{
    SimBench bench(text("lx16a@1"), at(115'200));
    device::Servo servo = known(bench, 1);
    bench.withWire(
        [](sim::VirtualBus& wire) { wire.servo(1)->surroundings().ambientCelsius = 120; });
    bench.letTimePass(600s);
    device::noteAlarms(bench.context(), servo);
    const auto& notices = bench.notices();
    QVERIFY(std::any_of(notices.begin(), notices.end(), [](const device::Notice& notice) {
        return notice.code == device::NoticeCode::DerivedTemperature;
    }));
    QCOMPARE(int(servo.status), 0);
}

QTEST_GUILESS_MAIN(TestEveryFamily)
#include "tst_every_family.moc"
