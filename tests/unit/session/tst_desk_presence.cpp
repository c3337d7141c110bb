// SPDX-License-Identifier: GPL-3.0-or-later
// A servo that is exchanged on the open line, that falls silent, or that somebody else writes to:
// the list never shows one servo for another, and no write reaches the wrong one.
#include "session/sweep_test.h"

#include <QSignalSpy>

#include "session_bench.h"

namespace {
using session::Event;
using Value = std::optional<std::int64_t>;

const QString maxVoltage = QStringLiteral("max_voltage");
const QString position = QStringLiteral("present_position");

/// An STS3215 on the wire, an SCS15 with the same ID beside it, not plugged in.
struct SpareBench : Bench {
    SpareBench()
        : Bench(QStringLiteral("sim:sts3215@1,scs15@1"))
    {
        withWire([](sim::VirtualBus& bus) { bus.unplug(1); });
        QObject::connect(&desk, &Desk::happened, &desk,
                         [this](const Event& event) { events.push_back(event); });
    }
    void exchange()
    {
        withWire([](sim::VirtualBus& bus) {
            bus.unplug(0);
            bus.plug(1);
        });
    }
    std::int64_t inside(std::size_t place, const QString& key)
    {
        std::int64_t raw = 0;
        withWire([&](sim::VirtualBus& bus) { raw = bus.servos()[place]->raw(key); });
        return raw;
    }
    QString model() const
    {
        const ServoRef ref = at(1);
        return ref != 0 ? entry(ref).servo.profile->modelName : QString();
    }
    int count(Event::Kind kind) const
    {
        return int(std::count_if(events.begin(), events.end(),
                                 [kind](const Event& event) { return event.kind == kind; }));
    }

    std::vector<Event> events;
};
} // namespace

class TestDeskPresence : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /// Also after writes that were fine, when this connection knows its servo well.
    void nothingIsWrittenToAnExchangedServo()
    {
        SpareBench bench;
        QVERIFY(bench.search());
        const ServoRef old = bench.at(1);
        QVERIFY(bench.write(old, maxVoltage, 100));
        QCOMPARE(bench.inside(0, maxVoltage), 100);
        bench.exchange();
        const std::int64_t before = bench.inside(1, maxVoltage);
        QVERIFY(bench.write(old, maxVoltage, 61));
        QCOMPARE(bench.inside(1, maxVoltage), before);
        const Event& told =
            *std::find_if(bench.events.rbegin(), bench.events.rend(),
                          [](const Event& event) { return event.kind == Event::Kind::Written; });
        QVERIFY(told.error && !told.report);
        QCOMPARE(told.error->code, base::ErrorCode::IdentityDiffers);
        QCOMPARE(told.error->detail, QStringLiteral("SCS15"));
        QTRY_COMPARE(bench.model(), QStringLiteral("SCS15"));
        QVERIFY(bench.at(1) != old);
        QVERIFY(bench.desk.servo(old) == nullptr);
        QCOMPARE(bench.count(Event::Kind::Exchanged), 1);
        QCOMPARE(bench.events.back().servo, bench.at(1));
        QCOMPARE(bench.events.back().task, QStringLiteral("STS3215"));
        QVERIFY(bench.desk.nextUndo() == nullptr); // it was the other one's
    }

    void noWayBackReachesAnExchangedServo()
    {
        SpareBench bench;
        QVERIFY(bench.search());
        QVERIFY(bench.write(bench.at(1), maxVoltage, 100));
        bench.exchange();
        const std::int64_t before = bench.inside(1, maxVoltage);
        bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.inside(1, maxVoltage), before);
        QTRY_COMPARE(bench.model(), QStringLiteral("SCS15"));
    }

    void aServoThatAnswersAgainIsIdentified_data()
    {
        QTest::addColumn<bool>("exchanged");
        QTest::newRow("the same") << false;
        QTest::newRow("another one") << true;
    }
    void aServoThatAnswersAgainIsIdentified()
    {
        QFETCH(bool, exchanged);
        SpareBench bench;
        QVERIFY(bench.search());
        const ServoRef old = bench.at(1);
        bench.desk.wish(user, {{{old, {position}}}, {}});
        QTRY_VERIFY(bench.raw(old, position));
        bench.withWire([](sim::VirtualBus& bus) { bus.unplug(0); });
        QTRY_VERIFY(bench.entry(old).silent);
        QStringList shown; // while it counted as answering
        connect(&bench.desk, &Desk::servoChanged, &bench.desk, [&](ServoRef ref) {
            if (!bench.entry(ref).silent)
                shown << bench.entry(ref).servo.profile->modelName;
        });
        bench.withWire([exchanged](sim::VirtualBus& bus) { bus.plug(exchanged ? 1 : 0); });
        QTRY_VERIFY(bench.at(1) != 0 && !bench.entry(bench.at(1)).silent);
        QCOMPARE(bench.model(), exchanged ? QStringLiteral("SCS15") : QStringLiteral("STS3215"));
        QCOMPARE(bench.at(1) == old, !exchanged);
        QCOMPARE(bench.count(Event::Kind::Exchanged), exchanged ? 1 : 0);
        QVERIFY(!exchanged || !shown.contains(QStringLiteral("STS3215")));
    }

    /// Without a moment of silence: the table that is polled shows the model.
    void aPolledTableShowsAnotherServo()
    {
        SpareBench bench;
        QVERIFY(bench.search());
        const ServoRef old = bench.at(1);
        QStringList all;
        for (const catalog::Register& reg : bench.entry(old).servo.profile->registers)
            all << reg.key;
        bench.desk.wish(user, {{{old, all}}, {}});
        QTRY_VERIFY(bench.raw(old, position));
        bench.exchange();
        QTRY_COMPARE(bench.model(), QStringLiteral("SCS15"));
        QVERIFY(bench.desk.servo(old) == nullptr);
    }

    /// It knows the servo longer than anything else that runs.
    void anExchangeThatATestFindsShowsInTheList()
    {
        SpareBench bench;
        QVERIFY(bench.search());
        session::SweepTest test(bench.desk);
        session::SweepTestOrder order;
        order.servos = {bench.at(1)};
        order.limits = {record::builtInSweepLimits(QStringLiteral("STS3215"), {})};
        order.spec.range = {QStringLiteral("1900"), QStringLiteral("2100")};
        order.spec.pause = std::chrono::milliseconds(700);
        order.spec.cycles = 500;
        QVERIFY(test.start(order));
        QTRY_VERIFY_WITH_TIMEOUT(test.run() && !test.run()->servos.front().legs.empty(), 20'000);
        bench.exchange();
        QTRY_VERIFY_WITH_TIMEOUT(!test.running(), 20'000);
        QCOMPARE(record::sweepEndName(test.run()->end), QStringLiteral("exchanged"));
        QCOMPARE(test.run()->verdict(), record::Grade::NotMeasured);
        QVERIFY(test.torqueLeft().empty());
        QCOMPARE(bench.inside(1, QStringLiteral("torque_switch")), 0);
        QTRY_COMPARE(bench.model(), QStringLiteral("SCS15"));
        QCOMPARE(bench.count(Event::Kind::Exchanged), 1);
    }

    void readingATableFindsAnotherServo()
    {
        SpareBench bench;
        QVERIFY(bench.search());
        const ServoRef old = bench.at(1);
        bench.exchange();
        bench.desk.readTable(old);
        QTRY_COMPARE(bench.model(), QStringLiteral("SCS15"));
        QVERIFY(bench.desk.servo(old) == nullptr);
    }

    /// Nobody polls the second one; that a task asks it in vain is enough.
    void aServoThatATaskAsksInVainIsSilent()
    {
        Bench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        const ServoRef second = bench.at(2);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        session::Task task;
        task.name = QStringLiteral("test");
        task.others = {second};
        task.work = [](session::TaskContext& context) -> base::Result<void> {
            (void)device::readAll(context.device, *context.others.front());
            return {}; // says nothing of it
        };
        bench.desk.perform(bench.at(1), task);
        QTRY_VERIFY(bench.entry(second).silent);
        QVERIFY(!bench.entry(bench.at(1)).silent);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        bench.desk.readTable(second);
        QTRY_VERIFY(!bench.entry(second).silent);
    }

    void undoDoesNotWriteOverAnothersValue_data()
    {
        QTest::addColumn<bool>("redo");
        QTest::newRow("undo") << false;
        QTest::newRow("redo") << true;
    }
    void undoDoesNotWriteOverAnothersValue()
    {
        QFETCH(bool, redo);
        SpareBench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        const std::int64_t factory = bench.inside(0, maxVoltage);
        QVERIFY(bench.write(ref, maxVoltage, 100));
        if (redo) {
            bench.desk.undo();
            QVERIFY(bench.settle());
        }
        bench.withWire([](sim::VirtualBus& bus) { bus.servo(1)->poke(maxVoltage, 120); });
        redo ? bench.desk.redo(true) : bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.inside(0, maxVoltage), 120);
        const Event& told = bench.events.back();
        QVERIFY(told.error && !told.report);
        QCOMPARE(told.error->code, base::ErrorCode::Mismatch);
        QCOMPARE(told.error->registerKey, maxVoltage);
        QCOMPARE(told.error->detail, redo ? QStringLiteral("120 %1 100").arg(factory)
                                          : QStringLiteral("120 100 %1").arg(factory));
        QCOMPARE(bench.raw(ref, maxVoltage), Value(120));
        QCOMPARE(bench.outcome(ref, maxVoltage), std::optional(device::WriteOutcome::NotSent));
        QVERIFY(bench.desk.nextUndo() == nullptr);
        QVERIFY(bench.desk.nextRedo() == nullptr);
    }

    /// What is as it shall be already is no conflict.
    void undoPassesAValueThatIsBackAlready()
    {
        SpareBench bench;
        QVERIFY(bench.search());
        const std::int64_t factory = bench.inside(0, maxVoltage);
        QVERIFY(bench.write(bench.at(1), maxVoltage, 100));
        bench.withWire([&](sim::VirtualBus& bus) { bus.servo(1)->poke(maxVoltage, factory); });
        bench.desk.undo();
        QVERIFY(bench.settle());
        QVERIFY2(bench.troubles().isEmpty(), bench.troubles());
        QVERIFY(bench.desk.nextRedo() != nullptr);
    }

    void aSearchNamesTheServosThatAreMissing()
    {
        SpareBench bench;
        QVERIFY(bench.search());
        bench.desk.expect(7);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QVERIFY(bench.search());
        const auto ended =
            std::find_if(bench.events.rbegin(), bench.events.rend(),
                         [](const Event& event) { return event.kind == Event::Kind::SearchEnded; });
        QCOMPARE(ended->missing, (std::vector<int>{1, 7}));
        bench.desk.expect(std::nullopt);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QVERIFY(bench.search()); // those that were not in the list are not missed
        QVERIFY(bench.events.back().missing.empty());
    }
};

QTEST_GUILESS_MAIN(TestDeskPresence)
#include "tst_desk_presence.moc"
