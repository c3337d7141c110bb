// SPDX-License-Identifier: GPL-3.0-or-later
// Device and jobs against the simulated wire in every protocol: bad lines, cables pulled at every
// byte, duplicate IDs, real motion. Reports are compared with the real content of the servo.
#include "device/motion/motion.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <deque>

using base::ErrorCode;
using catalog::Role;
using device::MoveCommand;
using device::MoveMethod;
using device::WriteOutcome;
using jobs::RecoveryAction;
using support::SimFixture;
using support::utf8;
using namespace std::chrono_literals;

namespace {
const std::vector<base::Protocol> all(base::allProtocols.begin(), base::allProtocols.end());

device::Servo known(SimFixture& fixture, int id)
{
    auto found = device::identifyAmong(fixture.context(), id, all);
    if (!found || !device::readSettings(fixture.context(), *found))
        qFatal("servo %d does not answer", id);
    return *found;
}

support::SimFixtureOptions at(int baud)
{
    support::SimFixtureOptions options;
    options.baud = baud;
    return options;
}

bool isLockOpen(SimFixture& fixture, int id)
{
    return fixture.withBus([&](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(id);
        const catalog::Register* lock = servo.profile().byRole(Role::Lock);
        return lock != nullptr && servo.raw(lock->key) != 1;
    });
}

std::int64_t rawOf(SimFixture& fixture, int id, Role role)
{
    return fixture.withBus([&](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(id);
        return servo.raw(servo.profile().byRole(role)->key);
    });
}

bool present(SimFixture& fixture, int id)
{
    return fixture.withBus([&](sim::VirtualBus& wire) { return wire.servo(id) != nullptr; });
}

/// About a tenth of a turn a second.
QString slowSpeed(const device::Servo& servo)
{
    const catalog::Register& speed = *servo.profile->byRole(Role::GoalSpeed);
    if (servo.meaning(speed).unit == utf8("rpm"))
        return utf8("6rpm");
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

class TestAllFamilies : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void silentProtocolsCostOneRequest();
    void lostRepliesAreRequestedAgain();
    void noisyLines_data() { addFamilies(); }
    void noisyLines();
    void writeInterruptedAtEveryByte_data() { addFamilies(); }
    void writeInterruptedAtEveryByte();
    void newIdInterruptedAtEveryByte_data();
    void newIdInterruptedAtEveryByte();
    void duplicateIdsAreNotUsed_data();
    void duplicateIdsAreNotUsed();
    void movesReachTheirGoal_data();
    void movesReachTheirGoal();
    void haltStopsAtThePresentPosition_data() { movesReachTheirGoal_data(); }
    void haltStopsAtThePresentPosition();
    void motorRunsAndStops();
    void storedMovesStartTogether();
    void centerIsSaved_data();
    void centerIsSaved();
    void overheatedLxIsReported();
};

/// Every command begins with this, so it must not pay for what is not there.
void TestAllFamilies::silentProtocolsCostOneRequest()
{
    SimFixture fixture(utf8("lx16a@1"), at(115200));
    fixture.clearFrames();
    QVERIFY(device::identifyAmong(fixture.context(), 1, all).has_value());
    QCOMPARE(fixture.frameCount(), all.size());
}

void TestAllFamilies::lostRepliesAreRequestedAgain()
{
    SimFixture fixture(utf8("smsmb@1"), at(115200));
    fixture.wireConfig().faults.drop = 0.5;
    int known = 0;
    for (int i = 0; i < 20; ++i)
        known += device::identifyAmong(fixture.context(), 1, all) ? 1 : 0;
    QVERIFY2(known >= 16, qPrintable(QString::number(known))); // of four tries each one in 16 fails
}

/// Checksum errors, lost requests, lost and torn replies: values reported as kept
/// survive, writes reported as refused have not happened, and the lock is closed or the journal has
/// an open intent.
void TestAllFamilies::noisyLines()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(QString, key);
    QFETCH(int, value);
    int kept = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        auto options = at(baud);
        options.wire.seed = seed;
        SimFixture fixture(model + utf8("@1"), options);
        device::Servo servo = known(fixture, 1);
        const auto before = fixture.raw(1, key);
        auto& faults = fixture.wireConfig().faults;
        faults.corrupt = 0.1;
        faults.drop = 0.05;
        faults.dropRequest = 0.05;
        faults.truncate = 0.05;
        faults.garbage = 0.1;
        const auto report = device::write(fixture.context(), servo, {{key, value}},
                                          {false, device::Consent::confirmed()});
        faults = {};
        const bool open = !fixture.journal().open()->empty();
        QVERIFY(open || !isLockOpen(fixture, 1));
        fixture.powerCycle();
        const auto now = fixture.raw(1, key);
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

void TestAllFamilies::writeInterruptedAtEveryByte()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(QString, key);
    QFETCH(int, value);
    int interrupted = 0;
    for (const auto wish : {RecoveryAction::Finish, RecoveryAction::Undo}) {
        for (std::size_t cut = 1;; ++cut) {
            SimFixture fixture(model + utf8("@1"), at(baud));
            device::Servo servo = known(fixture, 1);
            const auto before = fixture.raw(1, key);
            fixture.cutAfterHostBytes(cut);
            const auto report = device::write(fixture.context(), servo, {{key, value}},
                                              {false, device::Consent::confirmed()});
            fixture.reconnect(baud);
            if (report && report->isSuccessful())
                break;
            if (fixture.journal().open()->empty()) {
                QVERIFY(!isLockOpen(fixture, 1));
                QCOMPARE(fixture.raw(1, key), before);
                continue;
            }
            ++interrupted;
            const auto recovered = jobs::recover(fixture.context(), wish);
            QVERIFY(recovered);
            QVERIFY2(recovered->front().done, qPrintable(QString::number(cut)));
            QVERIFY(!isLockOpen(fixture, 1));
            QVERIFY(fixture.journal().open()->empty());
            fixture.powerCycle();
            QCOMPARE(fixture.raw(1, key), wish == RecoveryAction::Finish ? value : before);
        }
    }
    QVERIFY(interrupted > 10);
}

void TestAllFamilies::newIdInterruptedAtEveryByte_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::newRow("HLS") << "hls3606" << 1'000'000;
    QTest::newRow("SMCL") << "sm60-360m" << 115'200;
    QTest::newRow("SCS-2") << "scs15-2" << 1'000'000;
    QTest::newRow("Modbus") << "smsmb" << 115'200;
    QTest::newRow("LX") << "lx16a" << 115'200;
}

void TestAllFamilies::newIdInterruptedAtEveryByte()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    for (std::size_t cut = 1;; ++cut) {
        SimFixture fixture(model + utf8("@1"), at(baud));
        device::Servo servo = known(fixture, 1);
        fixture.cutAfterHostBytes(cut);
        const auto report = jobs::changeId(fixture.context(), servo, 9);
        fixture.reconnect(baud);
        if (report && report->isSuccessful()) {
            fixture.powerCycle();
            QVERIFY(present(fixture, 9));
            break;
        }
        if (fixture.journal().open()->empty()) {
            QVERIFY(present(fixture, 1));
            QVERIFY(!isLockOpen(fixture, 1));
            continue;
        }
        const auto recovered = jobs::recover(fixture.context(), RecoveryAction::Finish);
        QVERIFY(recovered);
        QVERIFY2(recovered->front().done, qPrintable(QString::number(cut)));
        fixture.powerCycle();
        QVERIFY2(present(fixture, 9), qPrintable(QString::number(cut)));
        QVERIFY(!isLockOpen(fixture, 9));
    }
}

void TestAllFamilies::duplicateIdsAreNotUsed_data()
{
    newIdInterruptedAtEveryByte_data();
}

/// Two servos with one ID disagree about themselves: nothing is written to either.
void TestAllFamilies::duplicateIdsAreNotUsed()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    SimFixture fixture(QStringLiteral("%1@1,%1@2").arg(model), at(baud));
    const catalog::ProfilePtr profile = known(fixture, 1).profile;
    const QString key = profile->byRole(Role::MinAngle)->key;
    const QString other = profile->byRole(Role::MaxAngle)->key;
    device::Servo servo = known(fixture, 1);
    fixture.poke(2, key, 77);
    fixture.poke(2, profile->byRole(Role::Id)->key, 1);
    fixture.clearFrames();
    const auto report = device::write(fixture.context(), servo, {{other, 900}}, {});
    QVERIFY(!report);
    QCOMPARE(base::errorName(report.error().code), base::errorName(ErrorCode::DuplicateId));
    QVERIFY(fixture.onlyReadsSent());
}

void TestAllFamilies::movesReachTheirGoal_data()
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

void TestAllFamilies::movesReachTheirGoal()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(int, away);
    QFETCH(QString, time);
    SimFixture fixture(model + utf8("@1"), at(baud));
    device::Servo servo = known(fixture, 1);
    const auto goal = rawOf(fixture, 1, Role::PresentPosition) + away;
    MoveCommand order{&servo, QString::number(goal)};
    if (!time.isEmpty())
        order.time = time;
    auto plan = device::planMove(fixture.context(), order);
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    const base::Duration start = fixture.clock().now();
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    const auto arrived = device::waitForArrival(fixture.context(), plans, 30s, {});
    QVERIFY2(arrived, arrived ? "" : qPrintable(arrived.error().detail));
    QVERIFY(std::abs(rawOf(fixture, 1, Role::PresentPosition) - goal) <= 12);
    QCOMPARE(rawOf(fixture, 1, Role::TorqueSwitch), std::int64_t(1));
    if (!time.isEmpty())
        QVERIFY(fixture.clock().now() - start >= std::chrono::milliseconds(time.toInt()));
}

void TestAllFamilies::haltStopsAtThePresentPosition()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(int, away);
    SimFixture fixture(model + utf8("@1"), at(baud));
    device::Servo servo = known(fixture, 1);
    const auto from = rawOf(fixture, 1, Role::PresentPosition);
    MoveCommand order{&servo, QString::number(from + away)};
    // Slow enough to be caught on the way.
    if (servo.profile->byRole(Role::StoredGoal) != nullptr)
        order.time = utf8("3000");
    else
        order.speed = slowSpeed(servo);
    auto plan = device::planMove(fixture.context(), order);
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    fixture.runFor(500ms);
    QVERIFY(device::halt(fixture.context(), servo));
    fixture.runFor(300ms);
    const auto here = rawOf(fixture, 1, Role::PresentPosition);
    fixture.runFor(3s);
    QVERIFY(std::abs(rawOf(fixture, 1, Role::PresentPosition) - here) <= 3);
    QVERIFY(std::abs(here - from) > 5);
    QVERIFY(std::abs(here - (from + away)) > 20);
    QCOMPARE(rawOf(fixture, 1, Role::TorqueSwitch), std::int64_t(1));
}

/// MOVE_STOP does not end motor mode; speed 0 does.
void TestAllFamilies::motorRunsAndStops()
{
    SimFixture fixture(utf8("lx16a@1"), at(115'200));
    device::Servo servo = known(fixture, 1);
    const auto switched = device::switchMode(fixture.context(), servo, utf8("motor"));
    QVERIFY(switched && switched->isSuccessful());
    QCOMPARE(fixture.raw(1, utf8("load")), std::int64_t(0));
    auto plan = device::planMove(fixture.context(), {&servo, utf8("-400")});
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    const auto from = fixture.raw(1, utf8("position"));
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    QCOMPARE(fixture.raw(1, utf8("motor_speed")), std::int64_t(-400));
    fixture.runFor(300ms);
    QVERIFY(fixture.raw(1, utf8("position")) != from);
    QVERIFY(device::halt(fixture.context(), servo));
    fixture.runFor(500ms);
    const auto here = fixture.raw(1, utf8("position"));
    fixture.runFor(1s);
    QVERIFY(std::abs(fixture.raw(1, utf8("position")) - here) <= 2);
}

void TestAllFamilies::storedMovesStartTogether()
{
    auto options = at(115'200);
    options.wire.identicalServos = true; // room for the move
    SimFixture fixture(utf8("lx16a@1,lx224hv@2"), options);
    std::deque<device::Servo> servos{known(fixture, 1), known(fixture, 2)};
    std::vector<device::MovePlan> plans;
    for (device::Servo& servo : servos) {
        MoveCommand order{&servo, QString::number(fixture.raw(servo.id, utf8("position")) + 200)};
        order.time = utf8("1000");
        auto plan = device::planMove(fixture.context(), order);
        QVERIFY(plan);
        plans.push_back(*plan);
    }
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Sync));
    fixture.runFor(500ms);
    for (const device::MovePlan& plan : plans) {
        const auto rest = plan.goalRaw - fixture.raw(plan.servo->id, utf8("position"));
        QVERIFY2(rest > 20 && rest < 180, qPrintable(QString::number(rest)));
    }
    QVERIFY(device::waitForArrival(fixture.context(), plans, 10s, {}));
}

void TestAllFamilies::centerIsSaved_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::newRow("HLS") << "hls3606" << 1'000'000;
    QTest::newRow("Modbus") << "smsmb" << 115'200;
}

void TestAllFamilies::centerIsSaved()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    SimFixture fixture(model + utf8("@1"), at(baud));
    device::Servo servo = known(fixture, 1);
    auto plan = device::planMove(fixture.context(), {&servo, utf8("1500")});
    QVERIFY(plan);
    std::vector<device::MovePlan> plans{*plan};
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    QVERIFY(device::waitForArrival(fixture.context(), plans, 20s, {}));
    const auto report = jobs::center(fixture.context(), servo);
    QVERIFY2(report, report ? "" : qPrintable(report.error().detail));
    QVERIFY(!isLockOpen(fixture, 1));
    QVERIFY(std::abs(fixture.raw(1, utf8("present_position")) - 2048) <= 12);
    fixture.powerCycle();
    fixture.runFor(500ms);
    QCOMPARE(fixture.raw(1, utf8("position_offset")), *report->offsetAfter);
    QVERIFY(std::abs(fixture.raw(1, utf8("present_position")) - 2048) <= 12);
}

void TestAllFamilies::overheatedLxIsReported()
{
    SimFixture fixture(utf8("lx16a@1"), at(115'200));
    device::Servo servo = known(fixture, 1);
    fixture.withBus(
        [](sim::VirtualBus& wire) { wire.servo(1)->environment().ambientCelsius = 120; });
    fixture.runFor(600s);
    device::addAlarmNotices(fixture.context(), servo);
    const auto& notices = fixture.notices();
    QVERIFY(std::any_of(notices.begin(), notices.end(), [](const device::Notice& notice) {
        return notice.code == device::NoticeCode::DerivedTemperature;
    }));
    QCOMPARE(int(servo.status), 0);
}

SERVODESK_GUILESS_TEST(TestAllFamilies)
#include "tst_all_families.moc"
