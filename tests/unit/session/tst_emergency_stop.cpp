// SPDX-License-Identifier: GPL-3.0-or-later
// After an emergency stop, on a simulated bus: torque is proven off, what was asked for before says
// nothing more, what waits in a servo cannot fire, and nothing moves until torque is switched on.
#include "device/motion/motion.h"
#include "device/transactions.h"
#include "support/test_main.h"

#include "session_fixture.h"
#include <atomic>
#include <thread>

using session::Effect;
using session::Event;
using session::Task;
using session::TaskCompletion;
using session::TaskContext;

namespace {
const QString torque = QStringLiteral("torque_switch");
const QString goal = QStringLiteral("goal_position");

struct StopFixture : SessionFixture {
    explicit StopFixture(const QString& port)
        : SessionFixture(port)
    {
        QObject::connect(&workbench, &Workbench::eventOccurred, &workbench,
                         [this](const Event& event) {
                             if (event.kind == Event::Kind::StopVerified)
                                 checks.push_back(event);
                             if (event.kind == Event::Kind::StopUnconfirmed)
                                 unconfirmed.push_back(event);
                         });
    }
    bool stopAndCheck()
    {
        const std::size_t before = checks.size();
        workbench.emergencyStop().trigger();
        return support::waitFor([&] { return checks.size() > before; });
    }
    /// Runs `work` as a task and waits for its end.
    std::optional<base::Error> run(ServoRef ref,
                                   std::function<base::Result<void>(TaskContext&)> work,
                                   Effect effect = Effect::None,
                                   const std::vector<ServoRef>& others = {})
    {
        std::optional<TaskCompletion> end;
        Task task;
        task.name = QStringLiteral("test");
        task.effect = effect;
        task.otherServos = others;
        task.work = std::move(work);
        task.guard = &workbench;
        task.done = [&](const TaskCompletion& how) { end = how; };
        workbench.tasks().perform(ref, std::move(task));
        if (!support::waitFor([&] { return end.has_value(); }))
            qFatal("a task never ended");
        return end->error;
    }
    std::int64_t real(int id, const QString& key)
    {
        std::int64_t value = 0;
        withBus([&](sim::VirtualBus& bus) { value = bus.servo(id)->raw(key); });
        return value;
    }
    double shaft(int id)
    {
        double degrees = 0;
        withBus([&](sim::VirtualBus& bus) { degrees = bus.servo(id)->shaftDegrees(); });
        return degrees;
    }
    std::vector<Event> checks;
    std::vector<Event> unconfirmed;
};

base::Result<void> send(TaskContext& task, protocol::Request request)
{
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.request.protocol = task.servo.protocol;
    return task.device.bus.transact(transaction).map([](const bus::Outcome&) {});
}

base::Result<void> torqueOn(TaskContext& task)
{
    return device::setTorque(task.device, task.servo, device::Torque::On);
}
} // namespace

class TestEmergencyStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void torqueOffIsVerified()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2,scs15@3"));
        QVERIFY(fixture.search());
        QVERIFY(fixture.write(fixture.at(1), torque, 1));
        QVERIFY(fixture.write(fixture.at(2), torque, 1));
        int stops = 0;
        connect(&fixture.workbench.polling(), &session::PollController::markAdded,
                &fixture.workbench, [&](const recording::Mark& mark) {
                    stops += mark.kind == recording::MarkKind::Stop ? 1 : 0;
                });
        QVERIFY(fixture.stopAndCheck());
        QCOMPARE(stops, 1);
        const session::StopResult& check = fixture.checks.back().stop;
        QVERIFY(check.isConfirmed());
        QCOMPARE(check.off.size(), std::size_t(3));
        for (const int id : {1, 2, 3})
            QCOMPARE(fixture.real(id, torque), 0);
        QCOMPARE(fixture.raw(fixture.at(1), torque), std::optional<std::int64_t>(0));
    }

    /// What keeps the check waiting does not keep its absence from being said.
    void anUnconfirmedStopIsReported()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        QVERIFY(fixture.waitUntilIdle());
        std::atomic<bool> begun = false;
        std::atomic<bool> done = false;
        Task task;
        task.name = QStringLiteral("test");
        task.work = [&](TaskContext&) -> base::Result<void> {
            begun = true;
            while (!done)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return {};
        };
        fixture.workbench.tasks().perform(fixture.at(1), std::move(task));
        const bool waits = support::waitFor([&] { return begun.load(); });
        fixture.workbench.emergencyStop().trigger();
        const bool said = support::waitFor([&] { return !fixture.unconfirmed.empty(); });
        done = true;
        QVERIFY(waits && said);
        QCOMPARE(fixture.unconfirmed.front().stop.silent.size(), std::size_t(2));
        QTRY_VERIFY(!fixture.checks.empty());
        QVERIFY(fixture.checks.back().stop.isConfirmed());
        QCOMPARE(fixture.unconfirmed.size(), std::size_t(1));
    }

    /// A firmware update has the port at the bootloader's rate: the servos are asked at theirs,
    /// when it has ended.
    void aStopAtAnotherRateIsVerifiedAfterwards()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        QVERIFY(fixture.write(fixture.at(2), torque, 1));
        QVERIFY(fixture.waitUntilIdle());
        std::atomic<bool> isAway = false;
        std::atomic<bool> mayReturn = false;
        Task task;
        task.name = QStringLiteral("update-firmware");
        task.changesPortBaud = true;
        task.work = [&](TaskContext& context) -> base::Result<void> {
            const auto away = context.device.bus.setBaud(500'000);
            isAway = true;
            while (!mayReturn)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return away ? context.device.bus.setBaud(1'000'000) : away;
        };
        fixture.workbench.tasks().perform(fixture.at(1), std::move(task));
        const bool begun = support::waitFor([&] { return isAway.load(); });
        fixture.workbench.emergencyStop().trigger();
        mayReturn = true;
        QVERIFY(begun);
        QTRY_VERIFY(!fixture.checks.empty());
        const session::StopResult& check = fixture.checks.back().stop;
        QVERIFY(check.isConfirmed());
        QCOMPARE(check.off.size(), std::size_t(2));
        QCOMPARE(fixture.real(2, torque), 0);
    }

    /// Also those whose check has ended already without an answer.
    void aStopWithoutRepliesNamesEveryServo()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        QVERIFY(fixture.waitUntilIdle());
        fixture.workbench.link().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 1; });
        fixture.workbench.emergencyStop().trigger();
        QTRY_VERIFY(!fixture.checks.empty());
        QCOMPARE(fixture.checks.back().stop.silent.size(), std::size_t(2));
        for (const Event& event : fixture.unconfirmed)
            QCOMPARE(event.stop.silent.size(), std::size_t(2));
    }

    /// Whose answers are lost is not shown as answering.
    void servosSilentAfterTheStopAreMarkedSilent()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        QVERIFY(fixture.write(fixture.at(1), torque, 1));
        QVERIFY(!fixture.entry(fixture.at(1)).silent);
        fixture.withBus([](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
        fixture.workbench.emergencyStop().trigger();
        QTRY_VERIFY(fixture.entry(fixture.at(1)).silent);
        QTRY_VERIFY(!fixture.checks.empty());
        QCOMPARE(fixture.checks.back().stop.silent.size(), std::size_t(1));
    }

    /// Requests get lost on this wire, the stop's own too.
    void servosStillOnAreStoppedAgain()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3"));
        QVERIFY(fixture.search());
        for (const int id : {1, 2, 3})
            QVERIFY(fixture.write(fixture.at(id), torque, 1));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 0.5; });
        QVERIFY(fixture.stopAndCheck());
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 0; });
        const session::StopResult& check = fixture.checks.back().stop;
        QCOMPARE(check.off.size() + check.stillOn.size() + check.silent.size(), std::size_t(3));
        for (const ServoRef ref : check.off)
            QCOMPARE(fixture.real(fixture.entry(ref).servo.id, torque), 0);
        for (const ServoRef ref : check.stillOn)
            QCOMPARE(fixture.real(fixture.entry(ref).servo.id, torque), 1);
    }

    void silentServosAreReported()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        QVERIFY(fixture.stopAndCheck());
        const session::StopResult& check = fixture.checks.back().stop;
        QCOMPARE(check.off, std::vector{fixture.at(1)});
        QCOMPARE(check.silent, std::vector{fixture.at(2)});
        QVERIFY(!check.isConfirmed());
        QVERIFY(fixture.entry(fixture.at(2)).silent);
        QVERIFY(!fixture.entry(fixture.at(1)).silent);
    }

    void nothingMovesUntilTorqueIsSwitchedOn()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.stopAndCheck());
        QVERIFY(fixture.entry(ref).stopped);
        const std::int64_t before = fixture.real(1, goal);
        QVERIFY(fixture.write(ref, goal, 3000, true));
        QTRY_COMPARE(fixture.outcome(ref, goal), std::optional(device::WriteOutcome::Refused));
        const auto& refused = fixture.entry(ref).writes.at(goal).error;
        QCOMPARE(refused->code, base::ErrorCode::Preempted);
        QCOMPARE(refused->detail, QStringLiteral("torque-first"));
        QCOMPARE(fixture.real(1, goal), before);
        bool ran = false;
        const auto work = [&](TaskContext&) -> base::Result<void> {
            ran = true;
            return {};
        };
        QCOMPARE(fixture.run(ref, work, Effect::Moves)->code, base::ErrorCode::Preempted);
        // Also where it is one of several.
        QCOMPARE(fixture.run(fixture.at(2), work, Effect::Moves, {ref})->code,
                 base::ErrorCode::Preempted);
        QVERIFY(!ran);
        const auto both = fixture.run(ref, work, Effect::Moves, {fixture.at(2)});
        QCOMPARE(both->id, 1);
        QCOMPARE(both->detail, QStringLiteral("torque-first 1, 2"));
        QVERIFY(fixture.write(ref, positionP, 40)); // a setting moves nothing
        QCOMPARE(fixture.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QVERIFY(fixture.entry(ref).stopped);

        QVERIFY(!fixture.run(ref, torqueOn, Effect::EnablesTorque));
        // The one that is held is named, whichever the task begins with.
        const auto other = fixture.run(ref, work, Effect::Moves, {fixture.at(2)});
        QCOMPARE(other->id, 2);
        QCOMPARE(other->detail, QStringLiteral("torque-first"));
        QVERIFY(!fixture.entry(ref).stopped);
        QVERIFY(fixture.entry(fixture.at(2)).stopped); // for each servo
        QVERIFY(fixture.write(ref, goal, 2100, true));
        QCOMPARE(fixture.real(1, goal), 2100);
        QVERIFY(fixture.write(fixture.at(2), torque, 1, true)); // by the table, too
        QVERIFY(!fixture.entry(fixture.at(2)).stopped);
    }

    /// Torque that could not be switched on releases nothing.
    void aFailedTorqueOnKeepsTheStop()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.stopAndCheck());
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QVERIFY(fixture.run(ref, torqueOn, Effect::EnablesTorque));
        QVERIFY(fixture.entry(ref).stopped);
    }

    void aStoredGoalCannotExecute_data()
    {
        QTest::addColumn<QString>("port");
        QTest::addRow("STS") << QStringLiteral("sim:sts3215@1");
        QTest::addRow("SCS") << QStringLiteral("sim:scs15@1");
        QTest::addRow("LX that tells") << QStringLiteral("sim:lx224@1");
        QTest::addRow("LX that does not") << QStringLiteral("sim:lx16a@1");
    }
    void aStoredGoalCannotExecute()
    {
        QFETCH(const QString, port);
        StopFixture fixture(port);
        QVERIFY(fixture.search({.firstId = 0, .lastId = 3, .bauds = {}}));
        const ServoRef ref = fixture.workbench.registry().order().front();
        QVERIFY(!fixture.run(ref, torqueOn, Effect::EnablesTorque));
        const double before = fixture.shaft(1);
        // Somebody else's program left it there, so nobody here knows.
        const auto hold = [](TaskContext& task) -> base::Result<void> {
            std::vector<device::MovePlan> plans;
            auto plan = device::planMove(task.device,
                                         {&task.servo, task.servo.protocol == base::Protocol::Lx
                                                           ? QStringLiteral("900")
                                                           : QStringLiteral("600")});
            if (!plan)
                return tl::unexpected(plan.error());
            plans.push_back(std::move(*plan));
            return device::sendAsyncMoves(task.device, plans);
        };
        const auto held = fixture.run(ref, hold, Effect::Moves);
        QVERIFY2(!held, held ? qPrintable(base::errorName(held->code) + held->detail) : "");
        QVERIFY(fixture.stopAndCheck());
        const session::StopResult& check = fixture.checks.back().stop;
        QCOMPARE(check.off.size(), std::size_t(1));
        QVERIFY(check.stillHeld.empty());
        const auto on = fixture.run(ref, torqueOn, Effect::EnablesTorque);
        QVERIFY2(!on, on ? qPrintable(base::errorName(on->code) + on->detail) : "");
        bool moved = false;
        const auto act = [&](TaskContext& task) -> base::Result<void> {
            const auto said = send(task, protocol::Request::action());
            // Ten looks; the servos live on while somebody speaks.
            for (int i = 0; said && i < 10; ++i) {
                task.device.bus.pauseUntil(
                    task.device.bus.clock().now() + std::chrono::milliseconds(20), nullptr);
                if (const auto read = device::readRoles(task.device, task.servo,
                                                        {catalog::Role::PresentPosition});
                    !read)
                    return read;
                moved = moved || std::abs(fixture.shaft(1) - before) > 3;
            }
            return said;
        };
        QVERIFY(!fixture.run(ref, act));
        QVERIFY2(!moved, qPrintable(QString::number(fixture.shaft(1) - before)));
    }

    /// A servo without torque can be turned by hand: a start must not turn it back.
    void aServoTurnedByHandKeepsItsPosition()
    {
        StopFixture fixture(QStringLiteral("sim:lx224@1"));
        QVERIFY(fixture.search({.firstId = 0, .lastId = 3, .bauds = {}}));
        const ServoRef ref = fixture.workbench.registry().order().front();
        QVERIFY(fixture.stopAndCheck());
        const QString stored = QStringLiteral("wait_angle");
        const double before = fixture.shaft(1);
        fixture.withBus([&](sim::VirtualBus& bus) {
            bus.servo(1)->load().springRate = 2; // a hand
            bus.servo(1)->load().springCenter = (before - 40) / 57.3;
        });
        // It lets go of a shaft at rest; time passes for servos while somebody speaks.
        const auto rest = [&](TaskContext& task) -> base::Result<void> {
            for (int still = 0; still < 5;) {
                const double last = fixture.shaft(1);
                task.device.bus.pauseUntil(
                    task.device.bus.clock().now() + std::chrono::milliseconds(20), nullptr);
                if (const auto read = device::readRoles(task.device, task.servo,
                                                        {catalog::Role::PresentPosition});
                    !read)
                    return read;
                const double here = fixture.shaft(1);
                still = std::abs(here - last) < 0.1 && std::abs(here - before) > 20 ? still + 1 : 0;
            }
            return {};
        };
        QVERIFY(!fixture.run(ref, rest));
        fixture.withBus([](sim::VirtualBus& bus) { bus.servo(1)->load().springRate = 0; });
        QVERIFY(!fixture.run(ref, torqueOn, Effect::EnablesTorque));
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!fixture.entry(ref).stopped);
        const double here = fixture.shaft(1) / 0.24; // steps of 0.24°
        QVERIFY2(std::abs(double(fixture.real(1, stored)) - here) < 15,
                 qPrintable(QStringLiteral("%1 %2 %3")
                                .arg(fixture.real(1, stored))
                                .arg(here)
                                .arg(before / 0.24)));
    }

    /// Modbus has nothing that waits.
    void modbusTorqueOffIsVerifiedToo()
    {
        StopFixture fixture(QStringLiteral("sim:modbus"));
        QVERIFY(fixture.search({.firstId = 1, .lastId = 3, .bauds = {}}));
        const ServoRef ref = fixture.workbench.registry().order().front();
        QVERIFY(!fixture.run(ref, torqueOn, Effect::EnablesTorque));
        QCOMPARE(fixture.real(1, torque), 1);
        QVERIFY(fixture.stopAndCheck());
        QVERIFY(fixture.checks.back().stop.isConfirmed());
        QCOMPARE(fixture.real(1, torque), 0);
    }

    void queuedTasksNeverRun()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        for (const std::int64_t raw : {40, 41, 42})
            fixture.workbench.writes().write(ref, {{{positionP, raw}}, false, {}});
        bool ran = false;
        std::optional<TaskCompletion> end;
        Task task;
        task.name = QStringLiteral("late");
        task.work = [&](TaskContext&) -> base::Result<void> {
            ran = true;
            return {};
        };
        task.guard = &fixture.workbench;
        task.done = [&](const TaskCompletion& how) { end = how; };
        fixture.workbench.tasks().perform(ref, std::move(task));
        QVERIFY(fixture.stopAndCheck());
        QTRY_VERIFY(end);
        QCOMPARE(end->error->code, base::ErrorCode::Preempted);
        QVERIFY(!ran);
        QTRY_VERIFY(!fixture.entry(ref).writing());
        QVERIFY(fixture.real(1, positionP) != 42);
        QCOMPARE(fixture.real(1, QStringLiteral("lock")), 1); // closed, wherever the first one was
        QVERIFY(fixture.session.journal().open()->empty());
    }

    void aRunningTaskSendsNothingAfterTheStop_data()
    {
        QTest::addColumn<bool>("known");
        QTest::addColumn<base::ErrorCode>("code");
        QTest::newRow("a servo written to before") << true << base::ErrorCode::Preempted;
        // The look for a second servo comes before the first frame, and it does heed the stop.
        QTest::newRow("a servo never written to") << false << base::ErrorCode::Stopped;
    }

    /// Between a task's last look at its stop and its first frame there is a moment.
    void aRunningTaskSendsNothingAfterTheStop()
    {
        QFETCH(const bool, known);
        QFETCH(const base::ErrorCode, code);
        StopFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        if (known)
            QVERIFY(fixture.write(ref, positionP, 33));
        const std::int64_t before = fixture.real(1, goal);
        std::atomic<bool> begun = false;
        std::vector<base::ErrorCode> codes;
        std::optional<TaskCompletion> end;
        Task task;
        task.name = QStringLiteral("late");
        task.work = [&](TaskContext& context) -> base::Result<void> {
            begun = true;
            while (!context.stop.isRequested())
                std::this_thread::yield();
            // It does not care, and tries again and again, in holds of its own and without.
            for (int i = 0; i < 3; ++i) {
                const device::Owned owned = device::own(context.device, {context.servo.id});
                const auto& reg = *context.servo.profile->find(goal);
                const auto sent = device::writeBlock(
                    owned.context, context.servo,
                    {reg.writeOffset, reg.offset, device::wireBytes(context.servo, reg, 3000)},
                    protocol::Repeat::Safe);
                codes.push_back(sent ? base::ErrorCode::BadArgument : sent.error().code);
            }
            const auto& reg = *context.servo.profile->find(goal);
            const auto sent = device::writeBlock(
                context.device, context.servo,
                {reg.writeOffset, reg.offset, device::wireBytes(context.servo, reg, 3000)},
                protocol::Repeat::Safe);
            codes.push_back(sent ? base::ErrorCode::BadArgument : sent.error().code);
            return {};
        };
        task.guard = &fixture.workbench;
        task.done = [&](const TaskCompletion& how) { end = how; };
        fixture.workbench.tasks().perform(ref, std::move(task));
        QTRY_VERIFY(begun);
        QVERIFY(fixture.stopAndCheck());
        QTRY_VERIFY(end);
        QCOMPARE(codes, std::vector(4, code));
        QCOMPARE(fixture.real(1, goal), before);
        QCOMPARE(fixture.real(1, torque), 0);
    }

    void severalServosAreOneTask()
    {
        StopFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3"));
        QVERIFY(fixture.search());
        const auto readAll = [](TaskContext& task) -> base::Result<void> {
            for (device::Servo* servo : task.otherServos) {
                const auto read = device::readKeys(task.device, *servo, {positionP});
                if (!read)
                    return read;
            }
            return device::readKeys(task.device, task.servo, {positionP});
        };
        QVERIFY(!fixture.run(fixture.at(2), readAll, Effect::None, {fixture.at(1), fixture.at(3)}));
        for (const int id : {1, 2, 3})
            QCOMPARE(fixture.raw(fixture.at(id), positionP), std::optional<std::int64_t>(32));
        bool ran = false;
        const auto nothing = [&](TaskContext&) -> base::Result<void> {
            ran = true;
            return {};
        };
        QCOMPARE(fixture.run(fixture.at(2), nothing, Effect::None, {fixture.at(1), 999})->code,
                 base::ErrorCode::NoReply);
        QVERIFY(!ran);
    }
};

SERVODESK_GUILESS_TEST(TestEmergencyStop)
#include "tst_emergency_stop.moc"
