// SPDX-License-Identifier: GPL-3.0-or-later
// After an emergency stop, on a simulated bus: torque is proven off, what was asked for before says
// nothing more, what waits in a servo cannot fire, and nothing moves until torque is switched on.
#include "device/motion.h"
#include "device/talk.h"

#include "session_bench.h"
#include <atomic>
#include <thread>

using session::Effect;
using session::Event;
using session::Task;
using session::TaskContext;
using session::TaskEnd;

namespace {
const QString torque = QStringLiteral("torque_switch");
const QString goal = QStringLiteral("goal_position");

struct StopBench : Bench {
    explicit StopBench(const QString& port)
        : Bench(port)
    {
        QObject::connect(&desk, &Desk::happened, &desk, [this](const Event& event) {
            if (event.kind == Event::Kind::StopChecked)
                checks.push_back(event);
            if (event.kind == Event::Kind::StopUnconfirmed)
                unconfirmed.push_back(event);
        });
    }
    bool stopAndCheck()
    {
        const std::size_t before = checks.size();
        desk.emergencyStop();
        return QTest::qWaitFor([&] { return checks.size() > before; }, 20000);
    }
    /// Runs `work` as a task and waits for its end.
    std::optional<base::Error> run(ServoRef ref,
                                   std::function<base::Result<void>(TaskContext&)> work,
                                   Effect effect = Effect::None,
                                   const std::vector<ServoRef>& others = {})
    {
        std::optional<TaskEnd> end;
        Task task;
        task.name = QStringLiteral("test");
        task.effect = effect;
        task.others = others;
        task.work = std::move(work);
        task.guard = &desk;
        task.done = [&](const TaskEnd& how) { end = how; };
        desk.perform(ref, std::move(task));
        if (!QTest::qWaitFor([&] { return end.has_value(); }, 20000))
            qFatal("a task never ended");
        return end->error;
    }
    std::int64_t real(int id, const QString& key)
    {
        std::int64_t value = 0;
        withWire([&](sim::VirtualBus& bus) { value = bus.servo(id)->raw(key); });
        return value;
    }
    double shaft(int id)
    {
        double degrees = 0;
        withWire([&](sim::VirtualBus& bus) { degrees = bus.servo(id)->shaftDegrees(); });
        return degrees;
    }
    std::vector<Event> checks;
    std::vector<Event> unconfirmed;
};

base::Result<void> say(TaskContext& task, protocol::Request request)
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

class TestDeskStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void torqueIsProvenOff()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1,sts3215@2,scs15@3"));
        QVERIFY(bench.search());
        QVERIFY(bench.write(bench.at(1), torque, 1));
        QVERIFY(bench.write(bench.at(2), torque, 1));
        int stops = 0;
        connect(&bench.desk, &Desk::marked, &bench.desk, [&](const record::Mark& mark) {
            stops += mark.kind == record::MarkKind::Stop ? 1 : 0;
        });
        QVERIFY(bench.stopAndCheck());
        QCOMPARE(stops, 1);
        const session::StopCheck& check = bench.checks.back().stop;
        QVERIFY(check.good());
        QCOMPARE(check.off.size(), std::size_t(3));
        for (const int id : {1, 2, 3})
            QCOMPARE(bench.real(id, torque), 0);
        QCOMPARE(bench.raw(bench.at(1), torque), std::optional<std::int64_t>(0));
    }

    /// What keeps the check waiting does not keep its absence from being said.
    void aStopThatIsNotConfirmedSoonSaysSo()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        QVERIFY(bench.settle());
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
        bench.desk.perform(bench.at(1), std::move(task));
        const bool waits = QTest::qWaitFor([&] { return begun.load(); }, 20000);
        bench.desk.emergencyStop();
        const bool said = QTest::qWaitFor([&] { return !bench.unconfirmed.empty(); }, 20000);
        done = true;
        QVERIFY(waits && said);
        QCOMPARE(bench.unconfirmed.front().stop.silent.size(), std::size_t(2));
        QTRY_VERIFY_WITH_TIMEOUT(!bench.checks.empty(), 20000);
        QVERIFY(bench.checks.back().stop.good());
        QCOMPARE(bench.unconfirmed.size(), std::size_t(1));
    }

    /// Also those whose check has ended already without an answer.
    void aStopInSilenceNamesEveryServo()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        QVERIFY(bench.settle());
        bench.desk.connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 1; });
        bench.desk.emergencyStop();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.checks.empty(), 60000);
        QCOMPARE(bench.checks.back().stop.silent.size(), std::size_t(2));
        for (const Event& event : bench.unconfirmed)
            QCOMPARE(event.stop.silent.size(), std::size_t(2));
    }

    /// Whose answers are lost is not shown as answering.
    void whoFallsSilentWithTheStopIsShownAsSilent()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        QVERIFY(bench.write(bench.at(1), torque, 1));
        QVERIFY(!bench.entry(bench.at(1)).silent);
        bench.withWire([](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
        bench.desk.emergencyStop();
        QTRY_VERIFY_WITH_TIMEOUT(bench.entry(bench.at(1)).silent, 20000);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.checks.empty(), 20000);
        QCOMPARE(bench.checks.back().stop.silent.size(), std::size_t(1));
    }

    /// Requests get lost on this wire, the stop's own too.
    void whoIsStillOnIsToldAgain()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3"));
        QVERIFY(bench.search());
        for (const int id : {1, 2, 3})
            QVERIFY(bench.write(bench.at(id), torque, 1));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 0.5; });
        QVERIFY(bench.stopAndCheck());
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 0; });
        const session::StopCheck& check = bench.checks.back().stop;
        QCOMPARE(check.off.size() + check.stillOn.size() + check.silent.size(), std::size_t(3));
        for (const ServoRef ref : check.off)
            QCOMPARE(bench.real(bench.entry(ref).servo.id, torque), 0);
        for (const ServoRef ref : check.stillOn)
            QCOMPARE(bench.real(bench.entry(ref).servo.id, torque), 1);
    }

    void whoDoesNotAnswerIsNamed()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        QVERIFY(bench.stopAndCheck());
        const session::StopCheck& check = bench.checks.back().stop;
        QCOMPARE(check.off, std::vector{bench.at(1)});
        QCOMPARE(check.silent, std::vector{bench.at(2)});
        QVERIFY(!check.good());
        QVERIFY(bench.entry(bench.at(2)).silent);
        QVERIFY(!bench.entry(bench.at(1)).silent);
    }

    void nothingMovesUntilTorqueIsSwitchedOn()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.stopAndCheck());
        QVERIFY(bench.entry(ref).stopped);
        const std::int64_t before = bench.real(1, goal);
        QVERIFY(bench.write(ref, goal, 3000, true));
        QTRY_COMPARE(bench.outcome(ref, goal), std::optional(device::WriteOutcome::Refused));
        const auto& refused = bench.entry(ref).writes.at(goal).error;
        QCOMPARE(refused->code, base::ErrorCode::Preempted);
        QCOMPARE(refused->detail, QStringLiteral("torque-first"));
        QCOMPARE(bench.real(1, goal), before);
        bool ran = false;
        const auto work = [&](TaskContext&) -> base::Result<void> {
            ran = true;
            return {};
        };
        QCOMPARE(bench.run(ref, work, Effect::Moves)->code, base::ErrorCode::Preempted);
        // Also where it is one of several.
        QCOMPARE(bench.run(bench.at(2), work, Effect::Moves, {ref})->code,
                 base::ErrorCode::Preempted);
        QVERIFY(!ran);
        const auto both = bench.run(ref, work, Effect::Moves, {bench.at(2)});
        QCOMPARE(both->id, 1);
        QCOMPARE(both->detail, QStringLiteral("torque-first 1, 2"));
        QVERIFY(bench.write(ref, positionP, 40)); // a setting moves nothing
        QCOMPARE(bench.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QVERIFY(bench.entry(ref).stopped);

        QVERIFY(!bench.run(ref, torqueOn, Effect::Energises));
        // The one that is held is named, whichever the task begins with.
        const auto other = bench.run(ref, work, Effect::Moves, {bench.at(2)});
        QCOMPARE(other->id, 2);
        QCOMPARE(other->detail, QStringLiteral("torque-first"));
        QVERIFY(!bench.entry(ref).stopped);
        QVERIFY(bench.entry(bench.at(2)).stopped); // for each servo
        QVERIFY(bench.write(ref, goal, 2100, true));
        QCOMPARE(bench.real(1, goal), 2100);
        QVERIFY(bench.write(bench.at(2), torque, 1, true)); // by the table, too
        QVERIFY(!bench.entry(bench.at(2)).stopped);
    }

    /// Torque that could not be switched on releases nothing.
    void aFailedTorqueOnReleasesNothing()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.stopAndCheck());
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QVERIFY(bench.run(ref, torqueOn, Effect::Energises));
        QVERIFY(bench.entry(ref).stopped);
    }

    void aGoalThatWaitsInAServoCannotFire_data()
    {
        QTest::addColumn<QString>("port");
        QTest::addRow("STS") << QStringLiteral("sim:sts3215@1");
        QTest::addRow("SCS") << QStringLiteral("sim:scs15@1");
        QTest::addRow("LX that tells") << QStringLiteral("sim:lx224@1");
        QTest::addRow("LX that does not") << QStringLiteral("sim:lx16a@1");
    }
    void aGoalThatWaitsInAServoCannotFire()
    {
        QFETCH(const QString, port);
        StopBench bench(port);
        QVERIFY(bench.search({.firstId = 0, .lastId = 3, .bauds = {}}));
        const ServoRef ref = bench.desk.servos().front();
        QVERIFY(!bench.run(ref, torqueOn, Effect::Energises));
        const double before = bench.shaft(1);
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
            return device::holdMoves(task.device, plans);
        };
        const auto held = bench.run(ref, hold, Effect::Moves);
        QVERIFY2(!held, held ? qPrintable(base::errorName(held->code) + held->detail) : "");
        QVERIFY(bench.stopAndCheck());
        const session::StopCheck& check = bench.checks.back().stop;
        QCOMPARE(check.off.size(), std::size_t(1));
        QVERIFY(check.stillHeld.empty());
        const auto on = bench.run(ref, torqueOn, Effect::Energises);
        QVERIFY2(!on, on ? qPrintable(base::errorName(on->code) + on->detail) : "");
        bool moved = false;
        const auto act = [&](TaskContext& task) -> base::Result<void> {
            const auto said = say(task, protocol::Request::action());
            // Ten looks; the servos live on while somebody speaks.
            for (int i = 0; said && i < 10; ++i) {
                task.device.bus.pauseUntil(
                    task.device.bus.clock().now() + std::chrono::milliseconds(20), nullptr);
                if (const auto read = device::readRoles(task.device, task.servo,
                                                        {catalog::Role::PresentPosition});
                    !read)
                    return read;
                moved = moved || std::abs(bench.shaft(1) - before) > 3;
            }
            return said;
        };
        QVERIFY(!bench.run(ref, act));
        QVERIFY2(!moved, qPrintable(QString::number(bench.shaft(1) - before)));
    }

    /// A servo without torque can be turned by hand: a start must not turn it back.
    void aServoTurnedByHandSinceStaysWhereItIs()
    {
        StopBench bench(QStringLiteral("sim:lx224@1"));
        QVERIFY(bench.search({.firstId = 0, .lastId = 3, .bauds = {}}));
        const ServoRef ref = bench.desk.servos().front();
        QVERIFY(bench.stopAndCheck());
        const QString stored = QStringLiteral("wait_angle");
        const double before = bench.shaft(1);
        bench.withWire([&](sim::VirtualBus& bus) {
            bus.servo(1)->load().springRate = 2; // a hand
            bus.servo(1)->load().springCentre = (before - 40) / 57.3;
        });
        // It lets go of a shaft at rest; time passes for servos while somebody speaks.
        const auto rest = [&](TaskContext& task) -> base::Result<void> {
            for (int still = 0; still < 5;) {
                const double last = bench.shaft(1);
                task.device.bus.pauseUntil(
                    task.device.bus.clock().now() + std::chrono::milliseconds(20), nullptr);
                if (const auto read = device::readRoles(task.device, task.servo,
                                                        {catalog::Role::PresentPosition});
                    !read)
                    return read;
                const double here = bench.shaft(1);
                still = std::abs(here - last) < 0.1 && std::abs(here - before) > 20 ? still + 1 : 0;
            }
            return {};
        };
        QVERIFY(!bench.run(ref, rest));
        bench.withWire([](sim::VirtualBus& bus) { bus.servo(1)->load().springRate = 0; });
        QVERIFY(!bench.run(ref, torqueOn, Effect::Energises));
        QVERIFY(bench.settle());
        QVERIFY(!bench.entry(ref).stopped);
        const double here = bench.shaft(1) / 0.24; // steps of 0.24°
        QVERIFY2(std::abs(double(bench.real(1, stored)) - here) < 15,
                 qPrintable(QStringLiteral("%1 %2 %3")
                                .arg(bench.real(1, stored))
                                .arg(here)
                                .arg(before / 0.24)));
    }

    /// Modbus has nothing that waits.
    void modbusIsProvenOffToo()
    {
        StopBench bench(QStringLiteral("sim:modbus"));
        QVERIFY(bench.search({.firstId = 1, .lastId = 3, .bauds = {}}));
        const ServoRef ref = bench.desk.servos().front();
        QVERIFY(!bench.run(ref, torqueOn, Effect::Energises));
        QCOMPARE(bench.real(1, torque), 1);
        QVERIFY(bench.stopAndCheck());
        QVERIFY(bench.checks.back().stop.good());
        QCOMPARE(bench.real(1, torque), 0);
    }

    void whatWaitsInTheQueueNeverRuns()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        for (const std::int64_t raw : {40, 41, 42})
            bench.desk.write(ref, {{{positionP, raw}}, false, false});
        bool ran = false;
        std::optional<TaskEnd> end;
        Task task;
        task.name = QStringLiteral("late");
        task.work = [&](TaskContext&) -> base::Result<void> {
            ran = true;
            return {};
        };
        task.guard = &bench.desk;
        task.done = [&](const TaskEnd& how) { end = how; };
        bench.desk.perform(ref, std::move(task));
        QVERIFY(bench.stopAndCheck());
        QTRY_VERIFY(end);
        QCOMPARE(end->error->code, base::ErrorCode::Preempted);
        QVERIFY(!ran);
        QTRY_VERIFY(!bench.entry(ref).writing());
        QVERIFY(bench.real(1, positionP) != 42);
        QCOMPARE(bench.real(1, QStringLiteral("lock")), 1); // closed, wherever the first one was
        QVERIFY(bench.session.journal().open()->empty());
    }

    void aTaskThatLooksAwaySaysNothingAfterTheStop_data()
    {
        QTest::addColumn<bool>("known");
        QTest::addColumn<base::ErrorCode>("code");
        QTest::newRow("a servo written to before") << true << base::ErrorCode::Preempted;
        // The look for a second servo comes before the first frame, and it does heed the stop.
        QTest::newRow("a servo never written to") << false << base::ErrorCode::Stopped;
    }

    /// Between a task's last look at its stop and its first frame there is a moment.
    void aTaskThatLooksAwaySaysNothingAfterTheStop()
    {
        QFETCH(const bool, known);
        QFETCH(const base::ErrorCode, code);
        StopBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        if (known)
            QVERIFY(bench.write(ref, positionP, 33));
        const std::int64_t before = bench.real(1, goal);
        std::atomic<bool> begun = false;
        std::vector<base::ErrorCode> codes;
        std::optional<TaskEnd> end;
        Task task;
        task.name = QStringLiteral("late");
        task.work = [&](TaskContext& context) -> base::Result<void> {
            begun = true;
            while (!context.stop.requested())
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
        task.guard = &bench.desk;
        task.done = [&](const TaskEnd& how) { end = how; };
        bench.desk.perform(ref, std::move(task));
        QTRY_VERIFY(begun);
        QVERIFY(bench.stopAndCheck());
        QTRY_VERIFY(end);
        QCOMPARE(codes, std::vector(4, code));
        QCOMPARE(bench.real(1, goal), before);
        QCOMPARE(bench.real(1, torque), 0);
    }

    void severalServosAreOneTask()
    {
        StopBench bench(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3"));
        QVERIFY(bench.search());
        const auto readAll = [](TaskContext& task) -> base::Result<void> {
            for (device::Servo* servo : task.others) {
                const auto read = device::readKeys(task.device, *servo, {positionP});
                if (!read)
                    return read;
            }
            return device::readKeys(task.device, task.servo, {positionP});
        };
        QVERIFY(!bench.run(bench.at(2), readAll, Effect::None, {bench.at(1), bench.at(3)}));
        for (const int id : {1, 2, 3})
            QCOMPARE(bench.raw(bench.at(id), positionP), std::optional<std::int64_t>(32));
        bool ran = false;
        const auto nothing = [&](TaskContext&) -> base::Result<void> {
            ran = true;
            return {};
        };
        QCOMPARE(bench.run(bench.at(2), nothing, Effect::None, {bench.at(1), 999})->code,
                 base::ErrorCode::NoAnswer);
        QVERIFY(!ran);
    }
};

QTEST_GUILESS_MAIN(TestDeskStop)
#include "tst_desk_stop.moc"
