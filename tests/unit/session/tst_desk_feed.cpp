// SPDX-License-Identifier: GPL-3.0-or-later
// What is read regularly on a simulated bus: everybody's wishes at once, in as few packets as the
// family allows, beside whatever else the bus does; what was not answered is told too.
#include "device/reader.h"

#include "session_bench.h"
#include <atomic>
#include <set>

using namespace std::chrono_literals;
using session::Reading;

namespace {
const QString position = QStringLiteral("present_position");
const QString speed = QStringLiteral("present_speed");
const QString volts = QStringLiteral("present_voltage");
const QString six =
    QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3,sts3215@4,sts3215@5,sts3215@6");

/// Everything that was told since it was made.
struct Listener : QObject {
    explicit Listener(Desk& desk)
    {
        connect(&desk, &Desk::readings, this, [this](const std::vector<Reading>& batch) {
            ++batches;
            all.insert(all.end(), batch.begin(), batch.end());
        });
        connect(&desk, &Desk::marked, this,
                [this](const record::Mark& mark) { marks.push_back(mark); });
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
    bool has(record::MarkKind kind, int id) const
    {
        return std::any_of(marks.begin(), marks.end(), [&](const record::Mark& mark) {
            return mark.kind == kind && mark.servoId == id;
        });
    }
    std::vector<Reading> all;
    std::vector<record::Mark> marks;
    int batches = 0;
};

const session::ReadValue* valueOf(const Reading& reading, const QString& key)
{
    for (const session::ReadValue& value : reading.values) {
        if (value.reg->key == key)
            return &value;
    }
    return nullptr;
}
} // namespace

class TestDeskFeed : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void sixServosShareOnePacket()
    {
        Bench bench(six);
        QVERIFY(bench.search());
        Listener heard(bench.desk);
        session::FeedWish wish;
        for (const ServoRef ref : bench.desk.servos())
            wish.parts.push_back({ref, {position, speed, volts}});
        bench.desk.connection()->bus().takeTrace();
        bench.desk.wish(user, wish);
        for (const ServoRef ref : bench.desk.servos()) {
            QTRY_VERIFY(heard.answered(ref) > 3);
            const Reading& reading = *heard.last(ref);
            QCOMPARE(reading.values.size(), std::size_t(3));
            const auto* shown = valueOf(reading, volts);
            QVERIFY(shown != nullptr && shown->physical > 4 && shown->physical < 9);
            QCOMPARE(bench.raw(ref, volts), std::optional(shown->raw)); // merged
        }
        std::set<int> instructions;
        for (const bus::TraceEntry& entry : bench.desk.connection()->bus().takeTrace()) {
            if (entry.kind == bus::TraceKind::Sent)
                instructions.insert(entry.bytes.at(4));
        }
        QCOMPARE(instructions, std::set<int>{0x82}); // nothing but sync reads
        QVERIFY(std::is_sorted(heard.all.begin(), heard.all.end(),
                               [](const Reading& a, const Reading& b) { return a.at < b.at; }));
    }

    void everybodysWishesAreServed()
    {
        Bench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        Listener heard(bench.desk);
        bench.desk.wish(QStringLiteral("memory"), {{{ref, {position}}}, 50ms});
        QTRY_VERIFY(heard.last(ref) != nullptr);
        QVERIFY(valueOf(*heard.last(ref), volts) == nullptr);
        bench.desk.wish(QStringLiteral("operate"), {{{ref, {volts}}}, 5ms});
        QTRY_VERIFY(valueOf(*heard.last(ref), volts) != nullptr);
        QVERIFY(valueOf(*heard.last(ref), position) != nullptr);
        bench.desk.wish(QStringLiteral("operate"), {});
        const auto ended = bench.desk.now();
        QTRY_VERIFY(heard.answered(ref, ended) > 2);
        QVERIFY(valueOf(*heard.last(ref), volts) == nullptr);
        QVERIFY(valueOf(*heard.last(ref), position) != nullptr);
        QCOMPARE(heard.answered(bench.at(2)), 0); // nobody wished for it
    }

    /// However many readings there were, a list hears of each servo once a batch.
    void listsHearOnceABatch()
    {
        Bench bench(six);
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(3);
        Listener heard(bench.desk);
        int changes = 0;
        connect(&bench.desk, &Desk::tableChanged, &bench.desk,
                [&](ServoRef changed) { changes += changed == ref ? 1 : 0; });
        bench.desk.wish(user, {{{ref, {position}}}, {}});
        QTRY_VERIFY(heard.batches > 10);
        QCOMPARE(changes, heard.batches);
        QVERIFY(heard.answered(ref) > 2 * heard.batches);
    }

    void itGoesOnBesideWritesAndASearch()
    {
        Bench bench(six);
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        Listener heard(bench.desk);
        bench.desk.wish(user, {{{ref, {position}}}, 2ms});
        QTRY_VERIFY(heard.answered(ref) > 0);
        auto begun = bench.desk.now();
        QVERIFY(bench.write(bench.at(2), positionP, 40));
        auto ended = bench.desk.now();
        QTRY_VERIFY(heard.answered(ref, ended) > 0);
        QVERIFY(heard.answered(ref, begun) - heard.answered(ref, ended) > 1);
        begun = bench.desk.now();
        QVERIFY(bench.search({.firstId = 0, .lastId = 60, .bauds = {}}));
        ended = bench.desk.now();
        QTRY_VERIFY(heard.answered(ref, ended) > 0);
        QVERIFY(heard.answered(ref, begun) - heard.answered(ref, ended) > 1);
        QVERIFY(!heard.has(record::MarkKind::LinkError, 1));
    }

    void silenceIsToldAndMarked()
    {
        Bench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        Listener heard(bench.desk);
        bench.desk.wish(user, {{{ref, {position}}, {bench.at(2), {position}}}, {}});
        QTRY_VERIFY(heard.answered(ref) > 0 && heard.answered(bench.at(2)) > 0);
        QVERIFY(bench.desk.communication(ref).answering);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QTRY_VERIFY(heard.has(record::MarkKind::LinkError, 1));
        QVERIFY(!heard.has(record::MarkKind::LinkError, 2));
        const auto missed =
            std::find_if(heard.all.begin(), heard.all.end(),
                         [&](const Reading& one) { return one.servo == ref && !one.answered; });
        QVERIFY(missed != heard.all.end());
        QVERIFY(missed->values.empty());
        QCOMPARE(missed->error, base::ErrorCode::NoAnswer);
        const session::Communication state = bench.desk.communication(ref);
        QVERIFY(!state.answering);
        QVERIFY(state.silentSince.has_value());
        QVERIFY(state.timeOuts > 0);
        const catalog::Register& reg = *bench.entry(ref).servo.profile->find(position);
        QTRY_VERIFY(!bench.entry(ref).shown(reg));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QTRY_VERIFY(heard.has(record::MarkKind::LinkBack, 1));
        QTRY_VERIFY(bench.desk.communication(ref).answering);
        QVERIFY(bench.entry(ref).shown(reg));
    }

    /// What a task reads tells at once that the servo is there, and only as long as it is.
    void aServoThatATaskReadsIsHeard()
    {
        Bench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        std::atomic<bool> reads{true};
        session::Task task;
        task.name = QStringLiteral("test");
        task.lasting = true;
        task.work = [&reads](session::TaskContext& context) -> base::Result<void> {
            while (!context.stop.requested()) {
                if (reads)
                    (void)device::readRoles(context.device, context.servo,
                                            {catalog::Role::PresentPosition});
                context.device.bus.clock().sleepFor(20ms);
            }
            return {};
        };
        bench.desk.perform(ref, std::move(task));
        QTRY_VERIFY(bench.desk.testing());
        const base::Duration begun = bench.desk.now();
        QTRY_VERIFY(bench.entry(ref).lastSeen > begun + 500ms);
        reads = false;
        QVERIFY(QTest::qWaitFor([&] { return bench.desk.now() > begun + 1500ms; }));
        const base::Duration heard = bench.entry(ref).lastSeen;
        bench.desk.stopTask();
        QVERIFY(bench.settle());
        QCOMPARE(bench.entry(ref).lastSeen, heard); // its end is no answer
    }

    /// Garbage in the place of an answer is not called silence.
    void garbageIsNotSilence()
    {
        Bench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        Listener heard(bench.desk);
        bench.desk.wish(user, {{{ref, {position}}}, {}});
        QTRY_VERIFY(heard.answered(ref) > 0);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.corrupt = 1; });
        QTRY_VERIFY(bench.entry(ref).silent);
        QTRY_VERIFY(bench.entry(ref).garbled);
        bench.withWire([](sim::VirtualBus& bus) {
            bus.config().faults.corrupt = 0;
            bus.config().faults.muteIds = {1};
        });
        QTRY_VERIFY(!bench.entry(ref).garbled);
        QVERIFY(bench.entry(ref).silent);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QTRY_VERIFY(!bench.entry(ref).silent);
    }

    /// The rate shown is the rate of what came.
    void theRateIsTrue()
    {
        Bench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        Listener heard(bench.desk);
        bench.desk.wish(user, {{{ref, {position}}}, 10ms});
        const auto begun = bench.desk.now();
        QTRY_VERIFY(bench.desk.now() - begun > 1500ms && heard.answered(ref) > 20);
        const session::FeedRate rate = bench.desk.rate(ref);
        QVERIFY(rate.lastAt == heard.last(ref)->at);
        const double counted = heard.answered(ref, *rate.lastAt - 1s);
        QVERIFY2(std::abs(rate.hz - counted) <= 0.2 * counted,
                 qPrintable(QStringLiteral("%1 %2").arg(rate.hz).arg(counted)));
        QCOMPARE(rate.missed, std::uint64_t(0));
        bench.desk.wish(user, {});
        QCOMPARE(bench.desk.rate(ref).hz, 0.0);
        QVERIFY(bench.desk.rate(ref).lastAt.has_value());
    }

    /// Another program may change what the numbers mean.
    void aChangeOfPhaseIsHonoured()
    {
        Bench bench(QStringLiteral("sim:sm40blhv@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        const QString phase = QStringLiteral("phase");
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        const std::int64_t before = *bench.raw(ref, phase);
        bench.withWire([&](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("operating_mode"), 1);
            bus.servo(1)->poke(QStringLiteral("goal_speed"), 50);
        });
        Listener heard(bench.desk);
        bench.desk.wish(user, {{{ref, {speed}, {phase}}}, 5ms});
        const auto scale = [&] {
            const auto* value =
                heard.last(ref) != nullptr ? valueOf(*heard.last(ref), speed) : nullptr;
            return value != nullptr && value->raw != 0 ? value->physical / double(value->raw) : 0.0;
        };
        QTRY_VERIFY(scale() > 0);
        const double was = scale();
        bench.withWire([&](sim::VirtualBus& bus) { bus.servo(1)->poke(phase, before ^ 4); });
        QTRY_VERIFY(scale() > 0 && std::abs(scale() - was) > 1e-3);
    }

    void whoIsAtAnotherRateIsNotAsked()
    {
        Bench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        const ServoRef moved = bench.at(1);
        const ServoRef other = bench.at(2);
        Listener heard(bench.desk);
        bench.desk.wish(user, {{{moved, {position}}, {other, {position}}}, {}});
        QTRY_VERIFY(heard.answered(moved) > 0);
        const catalog::Register& rate =
            *bench.entry(moved).servo.profile->byRole(catalog::Role::BaudRate);
        const auto slow =
            std::find_if(rate.values.begin(), rate.values.end(),
                         [](const auto& value) { return value.key == QLatin1String("115200"); });
        QVERIFY(bench.write(moved, rate.key, slow->value));
        const ServoRef here = bench.desk.baud() == 115'200 ? moved : other;
        const auto since = bench.desk.now();
        QTRY_VERIFY(heard.answered(here, since) > 3);
        QCOMPARE(heard.answered(here == moved ? other : moved, since), 0);
        QVERIFY(!heard.has(record::MarkKind::LinkError, 1));
        QVERIFY(!heard.has(record::MarkKind::LinkError, 2));
    }

    void writesAndMovesAreMarked()
    {
        Bench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        Listener heard(bench.desk);
        QVERIFY(bench.write(ref, positionP, 40));
        QCOMPARE(heard.marks.size(), std::size_t(1));
        QCOMPARE(heard.marks[0].kind, record::MarkKind::Write);
        QCOMPARE(heard.marks[0].text, QStringLiteral("position_p 32 → 40"));
        QCOMPARE(heard.marks[0].servoId, 1);
        QVERIFY(bench.write(ref, positionP, 41, true));
        QCOMPARE(heard.marks[1].text, QStringLiteral("position_p 40 → 41, temporary"));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QVERIFY(bench.write(ref, positionP, 42));
        QVERIFY2(heard.marks[2].text.contains(QStringLiteral("no-answer")),
                 qPrintable(heard.marks[2].text));
        bench.desk.noteMove(ref, QStringLiteral("goal 2048"));
        QCOMPARE(heard.marks.back().kind, record::MarkKind::Move);
        QVERIFY(heard.marks.back().at <= bench.desk.now());
    }

    /// Two turns by speed mode are two turns on the display.
    void turnsAreCounted()
    {
        Bench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        bench.desk.wish(user, {{{ref, {position, speed}, {QStringLiteral("operating_mode")}}}, {}});
        bench.withWire([](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("operating_mode"), 1);
            bus.servo(1)->poke(QStringLiteral("goal_speed"), 2000);
        });
        QTRY_VERIFY(bench.entry(ref).turns.value() &&
                    std::abs(bench.entry(ref).turns.value()->turns) >= 2);
        double shaft = 0;
        bench.withWire([&](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("goal_speed"), 0);
            shaft = bus.servo(1)->shaftDegrees();
        });
        QVERIFY(!bench.entry(ref).turns.value()->absolute);
        QVERIFY(std::abs(bench.entry(ref).turns.value()->degrees - shaft) < 400);
        bench.desk.powerCycle();
        QVERIFY(!bench.entry(ref).turns.value() || bench.entry(ref).turns.value()->turns == 0);
    }
};

QTEST_GUILESS_MAIN(TestDeskFeed)
#include "tst_desk_feed.moc"
