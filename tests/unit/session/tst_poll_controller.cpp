// SPDX-License-Identifier: GPL-3.0-or-later
// What is read regularly on a simulated bus: everybody's wishes at once, in as few packets as the
// family allows, beside whatever else the bus does; what was not answered is told too.
#include "device/reader.h"
#include "support/test_main.h"

#include "session_fixture.h"
#include <atomic>
#include <set>

using namespace std::chrono_literals;
using session::Reading;

namespace {
const QString speed = QStringLiteral("present_speed");
const QString volts = QStringLiteral("present_voltage");
const QString six =
    QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3,sts3215@4,sts3215@5,sts3215@6");

/// Everything that was told since it was made.
struct SignalRecorder : QObject {
    explicit SignalRecorder(Workbench& workbench)
    {
        connect(&workbench.polling(), &session::PollController::readingsReceived, this,
                [this](const std::vector<Reading>& batch) {
                    ++batches;
                    all.insert(all.end(), batch.begin(), batch.end());
                });
        connect(&workbench.polling(), &session::PollController::markAdded, this,
                [this](const recording::Mark& mark) { marks.push_back(mark); });
    }
    int answered(ServoRef ref, base::Duration since = {}) const
    {
        return int(std::count_if(all.begin(), all.end(), [=](const Reading& reading) {
            return reading.servo == ref && reading.answered && reading.at >= since;
        }));
    }
    const Reading* last(ServoRef ref) const
    {
        const auto place = std::find_if(all.rbegin(), all.rend(), [ref](const Reading& reading) {
            return reading.servo == ref && reading.answered;
        });
        return place == all.rend() ? nullptr : &*place;
    }
    bool has(recording::MarkKind kind, int id) const
    {
        return std::any_of(marks.begin(), marks.end(), [&](const recording::Mark& mark) {
            return mark.kind == kind && mark.servoId == id;
        });
    }
    std::vector<Reading> all;
    std::vector<recording::Mark> marks;
    int batches = 0;
};

const jobs::PollValue* valueOf(const Reading& reading, const QString& key)
{
    for (const jobs::PollValue& value : reading.values) {
        if (value.reg->key == key)
            return &value;
    }
    return nullptr;
}
} // namespace

class TestPollController : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void sixServosShareOnePacket()
    {
        SessionFixture fixture(six);
        QVERIFY(fixture.search());
        SignalRecorder recorder(fixture.workbench);
        session::Subscription subscription;
        for (const ServoRef ref : fixture.workbench.registry().order())
            subscription.parts.push_back({ref, {position, speed, volts}});
        fixture.workbench.link().connection()->bus().takeTrace();
        fixture.workbench.polling().subscribe(user, subscription);
        for (const ServoRef ref : fixture.workbench.registry().order()) {
            QTRY_VERIFY(recorder.answered(ref) > 3);
            const Reading& reading = *recorder.last(ref);
            QCOMPARE(reading.values.size(), std::size_t(3));
            const auto* shown = valueOf(reading, volts);
            QVERIFY(shown != nullptr && shown->physical > 4 && shown->physical < 9);
            QCOMPARE(fixture.raw(ref, volts), std::optional(shown->raw)); // merged
        }
        std::set<int> instructions;
        for (const bus::TraceEntry& entry :
             fixture.workbench.link().connection()->bus().takeTrace()) {
            if (entry.kind == bus::TraceKind::Sent)
                instructions.insert(entry.bytes.at(4));
        }
        QCOMPARE(instructions, std::set<int>{0x82}); // nothing but sync reads
        QVERIFY(std::is_sorted(recorder.all.begin(), recorder.all.end(),
                               [](const Reading& a, const Reading& b) { return a.at < b.at; }));
    }

    void allSubscriptionsAreServed()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        SignalRecorder recorder(fixture.workbench);
        fixture.workbench.polling().subscribe(QStringLiteral("memory"),
                                              {{{ref, {position}}}, 50ms});
        QTRY_VERIFY(recorder.last(ref) != nullptr);
        QVERIFY(valueOf(*recorder.last(ref), volts) == nullptr);
        fixture.workbench.polling().subscribe(QStringLiteral("operate"), {{{ref, {volts}}}, 5ms});
        QTRY_VERIFY(valueOf(*recorder.last(ref), volts) != nullptr);
        QVERIFY(valueOf(*recorder.last(ref), position) != nullptr);
        fixture.workbench.polling().subscribe(QStringLiteral("operate"), {});
        const auto ended = fixture.workbench.now();
        QTRY_VERIFY(recorder.answered(ref, ended) > 2);
        QVERIFY(valueOf(*recorder.last(ref), volts) == nullptr);
        QVERIFY(valueOf(*recorder.last(ref), position) != nullptr);
        QCOMPARE(recorder.answered(fixture.at(2)), 0); // nobody wished for it
    }

    /// However many readings there were, a list hears of each servo once a batch.
    void listsAreNotifiedOncePerBatch()
    {
        SessionFixture fixture(six);
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(3);
        SignalRecorder recorder(fixture.workbench);
        int changes = 0;
        connect(&fixture.workbench.registry(), &session::ServoRegistry::tableChanged,
                &fixture.workbench, [&](ServoRef changed) { changes += changed == ref ? 1 : 0; });
        fixture.workbench.polling().subscribe(user, {{{ref, {position}}}, {}});
        QTRY_VERIFY(recorder.batches > 10);
        QCOMPARE(changes, recorder.batches);
        QVERIFY(recorder.answered(ref) > 2 * recorder.batches);
    }

    void pollingContinuesDuringWritesAndASearch()
    {
        SessionFixture fixture(six);
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        SignalRecorder recorder(fixture.workbench);
        fixture.workbench.polling().subscribe(user, {{{ref, {position}}}, 2ms});
        QTRY_VERIFY(recorder.answered(ref) > 0);
        auto begun = fixture.workbench.now();
        QVERIFY(fixture.write(fixture.at(2), positionP, 40));
        auto ended = fixture.workbench.now();
        QTRY_VERIFY(recorder.answered(ref, ended) > 0);
        QVERIFY(recorder.answered(ref, begun) - recorder.answered(ref, ended) > 1);
        begun = fixture.workbench.now();
        QVERIFY(fixture.search({.firstId = 0, .lastId = 60, .bauds = {}}));
        ended = fixture.workbench.now();
        QTRY_VERIFY(recorder.answered(ref, ended) > 0);
        QVERIFY(recorder.answered(ref, begun) - recorder.answered(ref, ended) > 1);
        QVERIFY(!recorder.has(recording::MarkKind::LinkError, 1));
    }

    void silenceIsReportedAndMarked()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        SignalRecorder recorder(fixture.workbench);
        fixture.workbench.polling().subscribe(
            user, {{{ref, {position}}, {fixture.at(2), {position}}}, {}});
        QTRY_VERIFY(recorder.answered(ref) > 0 && recorder.answered(fixture.at(2)) > 0);
        QVERIFY(!fixture.entry(ref).silent);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QTRY_VERIFY(recorder.has(recording::MarkKind::LinkError, 1));
        QVERIFY(!recorder.has(recording::MarkKind::LinkError, 2));
        const auto missed =
            std::find_if(recorder.all.begin(), recorder.all.end(),
                         [&](const Reading& one) { return one.servo == ref && !one.answered; });
        QVERIFY(missed != recorder.all.end());
        QVERIFY(missed->values.empty());
        QCOMPARE(missed->error, base::ErrorCode::NoReply);
        QVERIFY(fixture.entry(ref).silent);
        QVERIFY(fixture.entry(ref).linkMonitor.silentSince().has_value());
        const catalog::Register& reg = *fixture.entry(ref).servo.profile->find(position);
        QTRY_VERIFY(!fixture.entry(ref).displayedRaw(reg));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QTRY_VERIFY(recorder.has(recording::MarkKind::LinkRestored, 1));
        QTRY_VERIFY(!fixture.entry(ref).silent);
        QVERIFY(fixture.entry(ref).displayedRaw(reg));
    }

    /// What a task reads tells at once that the servo is there, and only as long as it is.
    void aServoReadByATaskIsNotSilent()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        std::atomic<bool> reads{true};
        session::Task task;
        task.name = QStringLiteral("test");
        task.isLongRunning = true;
        task.work = [&reads](session::TaskContext& context) -> base::Result<void> {
            while (!context.stop.isRequested()) {
                if (reads)
                    (void)device::readRoles(context.device, context.servo,
                                            {catalog::Role::PresentPosition});
                context.device.bus.clock().sleepFor(20ms);
            }
            return {};
        };
        fixture.workbench.tasks().perform(ref, std::move(task));
        QTRY_VERIFY(fixture.workbench.tasks().isTesting());
        const base::Duration begun = fixture.workbench.now();
        QTRY_VERIFY(fixture.entry(ref).lastSeen > begun + 500ms);
        reads = false;
        QVERIFY(support::waitFor([&] { return fixture.workbench.now() > begun + 1500ms; }));
        const base::Duration recorder = fixture.entry(ref).lastSeen;
        fixture.workbench.tasks().stop();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.entry(ref).lastSeen, recorder); // its end is no answer
    }

    /// Garbage in the place of an answer is not called silence.
    void garbageIsNotSilence()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        SignalRecorder recorder(fixture.workbench);
        fixture.workbench.polling().subscribe(user, {{{ref, {position}}}, {}});
        QTRY_VERIFY(recorder.answered(ref) > 0);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.corrupt = 1; });
        QTRY_VERIFY(fixture.entry(ref).silent);
        QTRY_VERIFY(fixture.entry(ref).garbled);
        fixture.withBus([](sim::VirtualBus& bus) {
            bus.config().faults.corrupt = 0;
            bus.config().faults.muteIds = {1};
        });
        QTRY_VERIFY(!fixture.entry(ref).garbled);
        QVERIFY(fixture.entry(ref).silent);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QTRY_VERIFY(!fixture.entry(ref).silent);
    }

    /// The rate shown is the rate of what came.
    void theRateIsAccurate()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        SignalRecorder recorder(fixture.workbench);
        fixture.workbench.polling().subscribe(user, {{{ref, {position}}}, 10ms});
        const auto begun = fixture.workbench.now();
        QTRY_VERIFY(fixture.workbench.now() - begun > 1500ms && recorder.answered(ref) > 20);
        const session::PollRate rate = fixture.workbench.polling().pollRate(ref);
        QVERIFY(rate.lastAt == recorder.last(ref)->at);
        const double counted = recorder.answered(ref, *rate.lastAt - 1s);
        QVERIFY2(std::abs(rate.hz - counted) <= 0.2 * counted,
                 qPrintable(QStringLiteral("%1 %2").arg(rate.hz).arg(counted)));
        QCOMPARE(rate.missed, std::uint64_t(0));
        fixture.workbench.polling().subscribe(user, {});
        QCOMPARE(fixture.workbench.polling().pollRate(ref).hz, 0.0);
        QVERIFY(fixture.workbench.polling().pollRate(ref).lastAt.has_value());
    }

    /// Another program may change what the numbers mean.
    void aPhaseChangeIsRespected()
    {
        SessionFixture fixture(QStringLiteral("sim:sm40blhv@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        const QString phase = QStringLiteral("phase");
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        const std::int64_t before = *fixture.raw(ref, phase);
        fixture.withBus([&](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("operating_mode"), 1);
            bus.servo(1)->poke(QStringLiteral("goal_speed"), 50);
        });
        SignalRecorder recorder(fixture.workbench);
        fixture.workbench.polling().subscribe(user, {{{ref, {speed}, {phase}}}, 5ms});
        const auto scale = [&] {
            const auto* value =
                recorder.last(ref) != nullptr ? valueOf(*recorder.last(ref), speed) : nullptr;
            return value != nullptr && value->raw != 0 ? value->physical / double(value->raw) : 0.0;
        };
        QTRY_VERIFY(scale() > 0);
        const double was = scale();
        fixture.withBus([&](sim::VirtualBus& bus) { bus.servo(1)->poke(phase, before ^ 4); });
        QTRY_VERIFY(scale() > 0 && std::abs(scale() - was) > 1e-3);
    }

    void servosAtAnotherRateAreNotPolled()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        const ServoRef moved = fixture.at(1);
        const ServoRef other = fixture.at(2);
        SignalRecorder recorder(fixture.workbench);
        fixture.workbench.polling().subscribe(user,
                                              {{{moved, {position}}, {other, {position}}}, {}});
        QTRY_VERIFY(recorder.answered(moved) > 0);
        const catalog::Register& rate =
            *fixture.entry(moved).servo.profile->byRole(catalog::Role::BaudRate);
        const auto slow =
            std::find_if(rate.values.begin(), rate.values.end(),
                         [](const auto& value) { return value.key == QLatin1String("115200"); });
        QVERIFY(fixture.write(moved, rate.key, slow->value));
        const ServoRef here = fixture.workbench.link().baud() == 115'200 ? moved : other;
        const auto since = fixture.workbench.now();
        QTRY_VERIFY(recorder.answered(here, since) > 3);
        QCOMPARE(recorder.answered(here == moved ? other : moved, since), 0);
        QVERIFY(!recorder.has(recording::MarkKind::LinkError, 1));
        QVERIFY(!recorder.has(recording::MarkKind::LinkError, 2));
    }

    void writesAndMovesAreMarked()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        SignalRecorder recorder(fixture.workbench);
        QVERIFY(fixture.write(ref, positionP, 40));
        QCOMPARE(recorder.marks.size(), std::size_t(1));
        QCOMPARE(recorder.marks[0].kind, recording::MarkKind::Write);
        QCOMPARE(recorder.marks[0].text, QStringLiteral("position_p 32 → 40"));
        QCOMPARE(recorder.marks[0].servoId, 1);
        QVERIFY(fixture.write(ref, positionP, 41, true));
        QCOMPARE(recorder.marks[1].text, QStringLiteral("position_p 40 → 41, temporary"));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QVERIFY(fixture.write(ref, positionP, 42));
        QVERIFY2(recorder.marks[2].text.contains(QStringLiteral("no-answer")),
                 qPrintable(recorder.marks[2].text));
        fixture.workbench.polling().markMove(ref, QStringLiteral("goal 2048"));
        QCOMPARE(recorder.marks.back().kind, recording::MarkKind::Move);
        QVERIFY(recorder.marks.back().at <= fixture.workbench.now());
    }

    /// Two turns by speed mode are two turns on the display.
    void turnsAreCounted()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        fixture.workbench.polling().subscribe(
            user, {{{ref, {position, speed}, {QStringLiteral("operating_mode")}}}, {}});
        fixture.withBus([](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("operating_mode"), 1);
            bus.servo(1)->poke(QStringLiteral("goal_speed"), 2000);
        });
        QTRY_VERIFY(fixture.entry(ref).turns.value() &&
                    std::abs(fixture.entry(ref).turns.value()->turns) >= 2);
        double shaft = 0;
        fixture.withBus([&](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("goal_speed"), 0);
            shaft = bus.servo(1)->shaftDegrees();
        });
        QVERIFY(!fixture.entry(ref).turns.value()->absolute);
        QVERIFY(std::abs(fixture.entry(ref).turns.value()->degrees - shaft) < 400);
        fixture.workbench.link().powerCycle();
        QVERIFY(!fixture.entry(ref).turns.value() || fixture.entry(ref).turns.value()->turns == 0);
    }
};

SERVODESK_GUILESS_TEST(TestPollController)
#include "tst_poll_controller.moc"
