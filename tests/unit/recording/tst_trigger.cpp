// SPDX-License-Identifier: GPL-3.0-or-later
// When a trigger fires, held against plain arithmetic on the same samples; and what it shows.
#include "recording/trigger.h"
#include "support/test_main.h"

#include <QtTest>

#include <limits>
#include <random>

using base::Duration;
using recording::Mark;
using recording::MarkKind;
using recording::Trigger;
using recording::TriggerSpec;
using Kind = TriggerSpec::Kind;
using State = Trigger::State;

namespace {
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr int channel = 3;

TriggerSpec level(Kind kind, double at, double hysteresis = 0)
{
    TriggerSpec spec;
    spec.kind = kind;
    spec.channel = channel;
    spec.level = at;
    spec.hysteresis = hysteresis;
    spec.pre = 10 * ms;
    spec.post = 20 * ms;
    return spec;
}

/// Index of the sample that fires it, a millisecond each; -1: none does.
int triggerIndex(const TriggerSpec& spec, const std::vector<double>& values)
{
    Trigger trigger;
    trigger.arm(spec);
    for (std::size_t i = 0; i < values.size(); ++i) {
        trigger.sample(channel + 1, ms * int(i), 1e9); // is nobody's business
        trigger.sample(channel, ms * int(i), values[i]);
        if (trigger.firedAt())
            return int(*trigger.firedAt() / ms);
    }
    return -1;
}

int naiveTriggerIndex(const TriggerSpec& spec, const std::vector<double>& values)
{
    const double sign = spec.kind == Kind::Below || spec.kind == Kind::Falling ? -1 : 1;
    const bool edge = spec.kind == Kind::Rising || spec.kind == Kind::Falling;
    for (std::size_t i = 0; i < values.size(); ++i) {
        bool seen = !edge;
        for (std::size_t j = 0; j < i; ++j)
            seen = seen || sign * values[j] < sign * spec.level - spec.hysteresis;
        if (seen && sign * values[i] >= sign * spec.level)
            return int(i);
    }
    return -1;
}
} // namespace

class TestTrigger : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void levelsAndEdges_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("hysteresis");
        QTest::addColumn<QList<double>>("values");
        QTest::addColumn<int>("at");
        const auto row = [](const char* name, Kind kind, double hysteresis,
                            const QList<double>& values, int at) {
            QTest::newRow(name) << int(kind) << hysteresis << values << at;
        };
        row("above at once", Kind::Above, 0, {12, 13}, 0);
        row("above, the level itself", Kind::Above, 0, {9, 10}, 1);
        row("above never", Kind::Above, 0, {9, 9.9}, -1);
        row("below at once", Kind::Below, 0, {3}, 0);
        row("below", Kind::Below, 0, {11, 10.5, 10}, 2);
        row("rising", Kind::Rising, 0, {9, 11}, 1);
        row("rising is not being above", Kind::Rising, 0, {11, 12, 13}, -1);
        row("rising after falling", Kind::Rising, 0, {11, 9, 11}, 2);
        row("rising onto the level", Kind::Rising, 0, {9, 10}, 1);
        row("rising, too little before", Kind::Rising, 2, {11, 9, 11}, -1);
        row("rising, enough before", Kind::Rising, 2, {11, 7.9, 9, 11}, 3);
        row("falling", Kind::Falling, 0, {11, 9}, 1);
        row("falling is not being below", Kind::Falling, 0, {9, 8}, -1);
        row("falling, enough before", Kind::Falling, 2, {9, 12.5, 11, 10}, 3);
    }
    void levelsAndEdges()
    {
        QFETCH(int, kind);
        QFETCH(double, hysteresis);
        QFETCH(QList<double>, values);
        QTEST(triggerIndex(level(Kind(kind), 10, hysteresis), {values.begin(), values.end()}),
              "at");
    }

    void matchesPlainArithmetic()
    {
        std::mt19937 random(3);
        for (int i = 0; i < 4000; ++i) {
            std::vector<double> values;
            for (unsigned count = random() % 12; count > 0; --count)
                values.push_back(int(random() % 9) - 4);
            const auto spec = level(Kind(random() % 4), int(random() % 5) - 2, random() % 3);
            QCOMPARE(triggerIndex(spec, values), naiveTriggerIndex(spec, values));
        }
    }

    void aGapResetsTheEdge()
    {
        Trigger trigger;
        trigger.arm(level(Kind::Rising, 10));
        trigger.sample(channel, ms, 5);
        trigger.gap(channel + 1);
        trigger.gap(channel);
        trigger.sample(channel, 2 * ms, 15);
        QCOMPARE(trigger.state(), State::Armed);
        trigger.sample(channel, 3 * ms, 5);
        trigger.sample(channel, 4 * ms, std::numeric_limits<double>::quiet_NaN());
        trigger.sample(channel, 5 * ms, 15);
        QCOMPARE(trigger.state(), State::Armed);
        trigger.sample(channel, 6 * ms, 5);
        trigger.gap(channel + 1);
        trigger.sample(channel, 7 * ms, 15);
        QCOMPARE(trigger.firedAt(), 7 * ms);
    }

    void waitsForPostTriggerSamples()
    {
        Trigger trigger;
        QCOMPARE(trigger.state(), State::Idle);
        trigger.sample(channel, ms, 50);
        QCOMPARE(trigger.state(), State::Idle);
        trigger.arm(level(Kind::Above, 10));
        trigger.advanceTo(99 * ms);
        QCOMPARE(trigger.state(), State::Armed);
        QVERIFY(!trigger.window());
        trigger.sample(channel, 100 * ms, 12);
        QCOMPARE(trigger.state(), State::Fired);
        QCOMPARE(trigger.window(), (recording::TimeSpan{90 * ms, 120 * ms}));
        trigger.sample(channel, 110 * ms, 5);
        trigger.sample(channel, 111 * ms, 50);
        trigger.advanceTo(120 * ms - Duration(1));
        QCOMPARE(trigger.state(), State::Fired);
        trigger.advanceTo(120 * ms);
        QCOMPARE(trigger.state(), State::Complete);
        QCOMPARE(trigger.firedAt(), 100 * ms);
        trigger.sample(channel, 130 * ms, 50); // once
        QCOMPARE(trigger.firedAt(), 100 * ms);

        trigger.arm(level(Kind::Above, 10)); // again
        QCOMPARE(trigger.state(), State::Armed);
        QVERIFY(!trigger.firedAt());
        trigger.disarm();
        trigger.sample(channel, 140 * ms, 50);
        QCOMPARE(trigger.state(), State::Idle);
        QVERIFY(!trigger.window());
    }

    // Samples of any channel tell the time.
    void completedBySamples()
    {
        Trigger trigger;
        trigger.arm(level(Kind::Above, 10));
        trigger.sample(channel, 100 * ms, 12);
        trigger.sample(channel + 1, 121 * ms, 0);
        QCOMPARE(trigger.state(), State::Complete);

        TriggerSpec spec = level(Kind::Above, 10);
        spec.post = {};
        trigger.arm(spec);
        trigger.sample(channel, 100 * ms, 12);
        QCOMPARE(trigger.state(), State::Complete);
    }

    void marks()
    {
        TriggerSpec spec;
        spec.kind = Kind::Mark;
        spec.mark = MarkKind::Fault;
        spec.servoId = 4;
        Trigger trigger;
        const auto fires = [&](const Mark& mark) {
            trigger.arm(spec);
            trigger.sample(-1, ms, 1);
            trigger.mark(mark);
            return trigger.firedAt() == mark.at;
        };
        QVERIFY(!fires({5 * ms, MarkKind::Write, 4, {}}));
        QVERIFY(!fires({5 * ms, MarkKind::Fault, 5, {}}));
        QVERIFY(fires({5 * ms, MarkKind::Fault, 4, {}}));
        QVERIFY(fires({5 * ms, MarkKind::Fault, -1, {}})); // concerns all
        spec.servoId = -1;
        QVERIFY(fires({5 * ms, MarkKind::Fault, 5, {}}));
        spec = level(Kind::Above, 10);
        QVERIFY(!fires({5 * ms, MarkKind::Fault, 4, {}}));
    }

    void marksHaveNames()
    {
        QStringList names;
        for (int kind = 0; kind <= int(MarkKind::Note); ++kind) {
            const QString name = recording::markName(MarkKind(kind));
            QVERIFY(!name.isEmpty());
            QVERIFY(!names.contains(name));
            names << name;
            QCOMPARE(recording::markFromName(name), MarkKind(kind));
        }
        QVERIFY(!recording::markFromName(QStringLiteral("nothing")));
        QVERIFY(!recording::markFromName(QString()));
    }
};

SERVODESK_GUILESS_TEST(TestTrigger)
#include "tst_trigger.moc"
