// SPDX-License-Identifier: GPL-3.0-or-later
// A servo that is exchanged on the open line, that falls silent, or that somebody else writes to:
// the list never shows one servo for another, and no write reaches the wrong one.
#include "session/sweep/sweep_test.h"
#include "support/test_main.h"

#include <QSignalSpy>

#include "session_fixture.h"

namespace {
using session::Event;
using Value = std::optional<std::int64_t>;

const QString maxVoltage = QStringLiteral("max_voltage");

/// An STS3215 on the wire, an SCS15 with the same ID beside it, not plugged in.
struct ReplacementServoFixture : SessionFixture {
    ReplacementServoFixture()
        : SessionFixture(QStringLiteral("sim:sts3215@1,scs15@1"))
    {
        withBus([](sim::VirtualBus& bus) { bus.unplug(1); });
        QObject::connect(&workbench, &Workbench::eventOccurred, &workbench,
                         [this](const Event& event) { events.push_back(event); });
    }
    void exchange()
    {
        withBus([](sim::VirtualBus& bus) {
            bus.unplug(0);
            bus.plug(1);
        });
    }
    std::int64_t inside(std::size_t place, const QString& key)
    {
        std::int64_t raw = 0;
        withBus([&](sim::VirtualBus& bus) { raw = bus.servos()[place]->raw(key); });
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

class TestServoPresence : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /// Also after writes that were fine, when this connection knows its servo well.
    void nothingIsWrittenToAReplacedServo()
    {
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef old = fixture.at(1);
        QVERIFY(fixture.write(old, maxVoltage, 100));
        QCOMPARE(fixture.inside(0, maxVoltage), 100);
        fixture.exchange();
        const std::int64_t before = fixture.inside(1, maxVoltage);
        QVERIFY(fixture.write(old, maxVoltage, 61));
        QCOMPARE(fixture.inside(1, maxVoltage), before);
        const Event& reported =
            *std::find_if(fixture.events.rbegin(), fixture.events.rend(),
                          [](const Event& event) { return event.kind == Event::Kind::Written; });
        QVERIFY(reported.error && !reported.report);
        QCOMPARE(reported.error->code, base::ErrorCode::IdentityMismatch);
        QCOMPARE(reported.error->detail, QStringLiteral("SCS15"));
        QTRY_COMPARE(fixture.model(), QStringLiteral("SCS15"));
        QVERIFY(fixture.at(1) != old);
        QVERIFY(fixture.workbench.registry().servo(old) == nullptr);
        QCOMPARE(fixture.count(Event::Kind::Replaced), 1);
        QCOMPARE(fixture.events.back().servo, fixture.at(1));
        QCOMPARE(fixture.events.back().task, QStringLiteral("STS3215"));
        QVERIFY(fixture.workbench.writes().undoStep() == nullptr); // it was the other one's
    }

    void noRollbackReachesAReplacedServo()
    {
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        QVERIFY(fixture.write(fixture.at(1), maxVoltage, 100));
        fixture.exchange();
        const std::int64_t before = fixture.inside(1, maxVoltage);
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.inside(1, maxVoltage), before);
        QTRY_COMPARE(fixture.model(), QStringLiteral("SCS15"));
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
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef old = fixture.at(1);
        fixture.workbench.polling().subscribe(user, {{{old, {position}}}, {}});
        QTRY_VERIFY(fixture.raw(old, position));
        fixture.withBus([](sim::VirtualBus& bus) { bus.unplug(0); });
        QTRY_VERIFY(fixture.entry(old).silent);
        QStringList shown; // while it counted as answering
        connect(&fixture.workbench.registry(), &session::ServoRegistry::servoChanged,
                &fixture.workbench, [&](ServoRef ref) {
                    if (!fixture.entry(ref).silent)
                        shown << fixture.entry(ref).servo.profile->modelName;
                });
        fixture.withBus([exchanged](sim::VirtualBus& bus) { bus.plug(exchanged ? 1 : 0); });
        QTRY_VERIFY(fixture.at(1) != 0 && !fixture.entry(fixture.at(1)).silent);
        QCOMPARE(fixture.model(), exchanged ? QStringLiteral("SCS15") : QStringLiteral("STS3215"));
        QCOMPARE(fixture.at(1) == old, !exchanged);
        QCOMPARE(fixture.count(Event::Kind::Replaced), exchanged ? 1 : 0);
        QVERIFY(!exchanged || !shown.contains(QStringLiteral("STS3215")));
    }

    /// Without a moment of silence: the table that is polled shows the model.
    void pollingDetectsAReplacedServo()
    {
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef old = fixture.at(1);
        QStringList all;
        for (const catalog::Register& reg : fixture.entry(old).servo.profile->registers)
            all << reg.key;
        fixture.workbench.polling().subscribe(user, {{{old, all}}, {}});
        QTRY_VERIFY(fixture.raw(old, position));
        fixture.exchange();
        QTRY_COMPARE(fixture.model(), QStringLiteral("SCS15"));
        QVERIFY(fixture.workbench.registry().servo(old) == nullptr);
    }

    /// It knows the servo longer than anything else that runs.
    void aReplacementFoundByATestShowsInTheList()
    {
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        session::SweepTest& test = fixture.workbench.sweepTest();
        session::SweepTestRequest order;
        order.servos = {fixture.at(1)};
        order.limits = {results::builtInSweepLimits(QStringLiteral("STS3215"), {})};
        order.spec.range = {QStringLiteral("1900"), QStringLiteral("2100")};
        order.spec.pause = std::chrono::milliseconds(700);
        order.spec.cycles = 500;
        QVERIFY(test.start(order));
        QTRY_VERIFY(test.run() && !test.run()->servos.front().legs.empty());
        fixture.exchange();
        QTRY_VERIFY(!test.isRunning());
        QCOMPARE(results::sweepEndName(test.run()->end), QStringLiteral("exchanged"));
        QCOMPARE(test.run()->verdict(), results::Grade::NotMeasured);
        QVERIFY(test.unreleasedTorque().empty());
        QCOMPARE(fixture.inside(1, QStringLiteral("torque_switch")), 0);
        QTRY_COMPARE(fixture.model(), QStringLiteral("SCS15"));
        QCOMPARE(fixture.count(Event::Kind::Replaced), 1);
    }

    void readingATableDetectsAReplacedServo()
    {
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef old = fixture.at(1);
        fixture.exchange();
        fixture.workbench.writes().readTable(old);
        QTRY_COMPARE(fixture.model(), QStringLiteral("SCS15"));
        QVERIFY(fixture.workbench.registry().servo(old) == nullptr);
    }

    /// Nobody polls the second one; that a task asks it in vain is enough.
    void aServoNotAnsweringATaskIsSilent()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        const ServoRef second = fixture.at(2);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        session::Task task;
        task.name = QStringLiteral("test");
        task.otherServos = {second};
        task.work = [](session::TaskContext& context) -> base::Result<void> {
            (void)device::readAll(context.device, *context.otherServos.front());
            return {}; // says nothing of it
        };
        fixture.workbench.tasks().perform(fixture.at(1), task);
        QTRY_VERIFY(fixture.entry(second).silent);
        QVERIFY(!fixture.entry(fixture.at(1)).silent);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        fixture.workbench.writes().readTable(second);
        QTRY_VERIFY(!fixture.entry(second).silent);
    }

    void undoDoesNotOverwriteForeignValues_data()
    {
        QTest::addColumn<bool>("redo");
        QTest::newRow("undo") << false;
        QTest::newRow("redo") << true;
    }
    void undoDoesNotOverwriteForeignValues()
    {
        QFETCH(bool, redo);
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        const std::int64_t factory = fixture.inside(0, maxVoltage);
        QVERIFY(fixture.write(ref, maxVoltage, 100));
        if (redo) {
            fixture.workbench.writes().undo();
            QVERIFY(fixture.waitUntilIdle());
        }
        fixture.withBus([](sim::VirtualBus& bus) { bus.servo(1)->poke(maxVoltage, 120); });
        redo ? fixture.workbench.writes().redo(device::Consent::confirmed())
             : fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.inside(0, maxVoltage), 120);
        const Event& reported = fixture.events.back();
        QVERIFY(reported.error && !reported.report);
        QCOMPARE(reported.error->code, base::ErrorCode::Mismatch);
        QCOMPARE(reported.error->registerKey, maxVoltage);
        QCOMPARE(reported.error->detail, redo ? QStringLiteral("120 %1 100").arg(factory)
                                              : QStringLiteral("120 100 %1").arg(factory));
        QCOMPARE(fixture.raw(ref, maxVoltage), Value(120));
        QCOMPARE(fixture.outcome(ref, maxVoltage), std::optional(device::WriteOutcome::NotSent));
        QVERIFY(fixture.workbench.writes().undoStep() == nullptr);
        QVERIFY(fixture.workbench.writes().redoStep() == nullptr);
    }

    /// What is as it shall be already is no conflict.
    void undoAcceptsAnAlreadyRestoredValue()
    {
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        const std::int64_t factory = fixture.inside(0, maxVoltage);
        QVERIFY(fixture.write(fixture.at(1), maxVoltage, 100));
        fixture.withBus([&](sim::VirtualBus& bus) { bus.servo(1)->poke(maxVoltage, factory); });
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY2(fixture.troubles().isEmpty(), fixture.troubles());
        QVERIFY(fixture.workbench.writes().redoStep() != nullptr);
    }

    void aSearchReportsMissingServos()
    {
        ReplacementServoFixture fixture;
        QVERIFY(fixture.search());
        fixture.workbench.search().setExpectedId(7);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QVERIFY(fixture.search());
        const auto ended =
            std::find_if(fixture.events.rbegin(), fixture.events.rend(),
                         [](const Event& event) { return event.kind == Event::Kind::SearchEnded; });
        QCOMPARE(ended->missing, (std::vector<int>{1, 7}));
        fixture.workbench.search().setExpectedId(std::nullopt);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QVERIFY(fixture.search()); // those that were not in the list are not missed
        QVERIFY(fixture.events.back().missing.empty());
    }
};

SERVODESK_GUILESS_TEST(TestServoPresence)
#include "tst_servo_presence.moc"
