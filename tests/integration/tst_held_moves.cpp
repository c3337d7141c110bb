// SPDX-License-Identifier: GPL-3.0-or-later
// Held moves (REG WRITE, then ACTION) on a line that loses frames: each frame of them in turn, as a
// request and as its answer, and many by chance. What the servos have done is asked of their
// shafts, what was sent is counted on the wire. A move is made once or not at all, and never
// another one.
#include "device/motion.h"
#include "device/reader.h"
#include "support/feetech_bytes.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <random>

using base::ErrorCode;
using device::MoveHow;
using device::MovePlan;
using support::SimBench;
using namespace std::chrono_literals;

namespace {
constexpr int goalAddress = 42;

QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

double shaft(SimBench& bench, int id)
{
    return bench.withWire([id](sim::VirtualBus& wire) { return wire.servo(id)->shaftDegrees(); });
}

enum class Lost { Request, Answer };

/// Loses what `picks` says, and hears everything else.
void lose(SimBench& bench, Lost what, std::function<bool(const base::Bytes&)> picks)
{
    bench.tap().onWrite = [&bench, what, picks = std::move(picks)](const base::Bytes& frame) {
        auto& faults = bench.wireConfig().faults;
        const double chance = picks(frame) ? 1.0 : 0.0;
        (what == Lost::Request ? faults.dropRequest : faults.drop) = chance;
    };
}

void hearEverything(SimBench& bench)
{
    bench.tap().onWrite = nullptr;
    bench.wireConfig().faults.drop = 0;
    bench.wireConfig().faults.dropRequest = 0;
}

std::vector<MovePlan> plansFor(SimBench& bench, std::vector<device::Servo>& servos,
                               const QString& goal)
{
    std::vector<MovePlan> plans;
    for (device::Servo& servo : servos) {
        device::MoveOrder order;
        order.servo = &servo;
        order.goal = goal;
        auto plan = device::planMove(bench.context(), order);
        if (!plan)
            qFatal("plan");
        plans.push_back(*plan);
    }
    return plans;
}

/// 64, as the servo tells it on a good line.
std::int64_t flag(SimBench& bench, int id)
{
    device::Servo servo = bench.servo(id);
    if (!device::readKeys(bench.context(), servo, {text("async_write_flag")}))
        return -1;
    return servo.raw(text("async_write_flag")).value_or(-1);
}

/// A program that knows only bytes says one frame and does not wait for the answer.
void sayBytes(SimBench& bench, int id, int instruction, const QByteArray& params = {})
{
    const QByteArray frame = support::feetechFrame(id, instruction, params);
    bus::Transaction transaction;
    transaction.request = protocol::Request::raw({frame.begin(), frame.end()});
    (void)bench.bus().transact(transaction);
}

/// REG WRITE of a goal by another program.
void holdForeign(SimBench& bench, int id, int goal)
{
    sayBytes(bench, id, support::RegWrite,
             QByteArray(1, goalAddress).append(char(goal & 0xFF)).append(char(goal >> 8)));
    QCOMPARE(flag(bench, id), 1);
}

void actAll(SimBench& bench)
{
    sayBytes(bench, 254, support::Action);
    bench.letTimePass(4s);
}

/// As one of those in which a goal may wait.
bool isNamed(const base::Error& error, int id)
{
    QString ids = error.detail;
    if (!ids.startsWith(text("forget-held")))
        return false;
    ids.remove(text("forget-held"));
    const QStringList several = ids.split(text(","), Qt::SkipEmptyParts);
    return error.id == id || std::any_of(several.begin(), several.end(), [id](const QString& one) {
               return one.trimmed() == QString::number(id);
           });
}

QByteArray whatHappened(const base::Result<void>& result)
{
    return result ? QByteArray("done")
                  : base::errorName(result.error().code).toUtf8() + " of servo " +
                        QByteArray::number(result.error().id);
}

/// Two servos at 180° with torque on, and a move of both: to 1024 (90°), or by 512 steps (45°).
struct Pair {
    explicit Pair(bool relative)
        : bench(text("sts3215@1,sts3215@2"))
        , way(relative ? 45.0 : -90.0)
    {
        for (const int id : {1, 2}) {
            device::Servo servo = bench.servo(id);
            if (relative && !device::switchMode(bench.context(), servo, text("step")))
                qFatal("mode");
            if (!device::setTorque(bench.context(), servo, device::Torque::On))
                qFatal("torque");
            servos.push_back(bench.servo(id));
        }
        bench.letTimePass(1s);
        plans = plansFor(bench, servos, relative ? text("512") : text("1024"));
        for (const int id : {1, 2})
            start[id] = shaft(bench, id);
        bench.notices().clear();
        bench.forgetFrames();
    }
    double moved(int id) { return shaft(bench, id) - start[id]; }
    bool whole(int id) { return std::abs(moved(id) - way) < 4; }
    bool none(int id) { return std::abs(moved(id)) < 4; }
    /// Sends it, with time enough to arrive afterwards.
    base::Result<void> move()
    {
        const auto sent = device::sendMoves(bench.context(), plans, MoveHow::Async);
        hearEverything(bench);
        bench.letTimePass(4s);
        return sent;
    }
    QByteArray story(const base::Result<void>& sent)
    {
        return whatHappened(sent) + ": " + QByteArray::number(moved(1)) + "°, " +
               QByteArray::number(moved(2)) + "°";
    }

    SimBench bench;
    double way;
    std::vector<device::Servo> servos;
    std::vector<MovePlan> plans;
    std::map<int, double> start;
};
} // namespace

class TestHeldMoves : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void eachFrameLostOnce_data();
    void eachFrameLostOnce();
    void manyLostByChance_data();
    void manyLostByChance();
    void aForgottenGoalIsNotTakenForOurs();
    void aMoveGivenUpLeavesNothingThatWaits();
    void aStartThatIsNeverHeardLeavesNothingThatWaits();
    void whoFallsSilentAtTheStartIsNamed();
    void cutLineNamesAllThatMayHoldAGoal_data();
    void cutLineNamesAllThatMayHoldAGoal();
    void whatHasStartedIsHeldNoMore();
    void storedMovesThatWereStartedAreHeldNoMore();
};

void TestHeldMoves::eachFrameLostOnce_data()
{
    QTest::addColumn<bool>("relative");
    QTest::addColumn<Lost>("what");
    QTest::newRow("goals, requests") << false << Lost::Request;
    QTest::newRow("goals, answers") << false << Lost::Answer;
    QTest::newRow("steps, requests") << true << Lost::Request;
    QTest::newRow("steps, answers") << true << Lost::Answer;
}

/// One frame lost: the move is made all the same, by both, once.
void TestHeldMoves::eachFrameLostOnce()
{
    QFETCH(bool, relative);
    QFETCH(Lost, what);
    std::size_t frames = 1;
    for (std::size_t lost = 0; lost < frames; ++lost) {
        Pair pair(relative);
        std::size_t count = 0;
        lose(pair.bench, what, [&](const base::Bytes&) { return count++ == lost; });
        const auto sent = pair.move();
        frames = std::max(frames, count);
        const QByteArray story = "frame " + QByteArray::number(int(lost)) + ": " + pair.story(sent);
        QVERIFY2(sent.has_value(), story.constData());
        for (const int id : {1, 2}) {
            QVERIFY2(pair.whole(id), story.constData());
            QCOMPARE(flag(pair.bench, id), 0);
        }
        // A goal is held once, or again because its answer was lost; the start likewise.
        QVERIFY2(pair.bench.frames(support::RegWrite) <= 3, story.constData());
        QVERIFY2(pair.bench.frames(support::Action) <= 2, story.constData());
    }
    QVERIFY(frames > 6);
}

void TestHeldMoves::manyLostByChance_data()
{
    QTest::addColumn<bool>("relative");
    QTest::addColumn<double>("chance");
    QTest::newRow("goals, 20 %") << false << 0.2;
    QTest::newRow("goals, 50 %") << false << 0.5;
    QTest::newRow("steps, 20 %") << true << 0.2;
    QTest::newRow("steps, 50 %") << true << 0.5;
}

/// Done is done, by both; what failed has moved whole or not at all, and a start later on finds
/// nothing that the error has not named.
void TestHeldMoves::manyLostByChance()
{
    QFETCH(bool, relative);
    QFETCH(double, chance);
    int done = 0;
    // Where half of all frames are lost one move in a hundred is made.
    const std::uint32_t seeds = chance < 0.3 ? 40 : 400;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        Pair pair(relative);
        std::mt19937 dice(seed);
        pair.bench.tap().onWrite = [&](const base::Bytes&) {
            auto& faults = pair.bench.wireConfig().faults;
            std::uniform_real_distribution<double> roll(0, 1);
            faults.dropRequest = roll(dice) < chance ? 1.0 : 0.0;
            faults.drop = roll(dice) < chance ? 1.0 : 0.0;
        };
        const auto sent = pair.move();
        const QByteArray story = "seed " + QByteArray::number(seed) + ": " + pair.story(sent);
        done += sent ? 1 : 0;
        for (const int id : {1, 2}) {
            QVERIFY2(pair.whole(id) || (!sent && pair.none(id)), story.constData());
            // A goal that still waits is said to.
            if (flag(pair.bench, id) == 1)
                QVERIFY2(!sent && (sent.error().id == id || isNamed(sent.error(), id)),
                         story.constData());
        }
    }
    QVERIFY2(done > (chance < 0.3 ? 10 : 0), qPrintable(QString::number(done)));
}

/// A goal of another program waits in the servo, and ours never arrives: the flag that says "one
/// waits" speaks of the other one, which must not be started in our name.
void TestHeldMoves::aForgottenGoalIsNotTakenForOurs()
{
    Pair pair(false);
    holdForeign(pair.bench, 1, 3000);
    lose(pair.bench, Lost::Request,
         [](const base::Bytes& frame) { return frame[4] == support::RegWrite && frame[2] == 1; });
    const auto sent = pair.move();
    QVERIFY2(!sent, pair.story(sent).constData());
    QCOMPARE(sent.error().id, 1);
    QVERIFY2(pair.none(1) && pair.none(2), pair.story(sent).constData());
    // Where ours arrives, it takes the other one's place.
    pair.plans = plansFor(pair.bench, pair.servos, text("1024"));
    const auto again = pair.move();
    QVERIFY2(again.has_value(), pair.story(again).constData());
    QVERIFY2(pair.whole(1) && pair.whole(2), pair.story(again).constData());
}

/// The second servo cannot be told its goal, so the move is not made: nor by the first one when
/// another program starts what it holds.
void TestHeldMoves::aMoveGivenUpLeavesNothingThatWaits()
{
    Pair pair(false);
    lose(pair.bench, Lost::Request,
         [](const base::Bytes& frame) { return frame[4] == support::RegWrite && frame[2] == 2; });
    const auto sent = pair.move();
    QVERIFY(!sent);
    QCOMPARE(sent.error().id, 2);
    QCOMPARE(flag(pair.bench, 1), 0);
    QCOMPARE(pair.bench.raw(1, text("torque_switch")), 1);
    actAll(pair.bench);
    QVERIFY2(pair.none(1) && pair.none(2), pair.story(sent).constData());
}

/// No start is heard: both are named, because nothing proves what they hold, and a start by another
/// program moves none.
void TestHeldMoves::aStartThatIsNeverHeardLeavesNothingThatWaits()
{
    Pair pair(false);
    lose(pair.bench, Lost::Request,
         [](const base::Bytes& frame) { return frame[4] == support::Action; });
    const auto sent = pair.move();
    QVERIFY(!sent);
    QVERIFY2(isNamed(sent.error(), 1) && isNamed(sent.error(), 2), qPrintable(sent.error().detail));
    QVERIFY(pair.bench.frames(support::Action) > 1);
    actAll(pair.bench);
    QVERIFY2(pair.none(1) && pair.none(2), pair.story(sent).constData());
}

/// Whether it has heard the start cannot be known.
void TestHeldMoves::whoFallsSilentAtTheStartIsNamed()
{
    Pair pair(false);
    lose(pair.bench, Lost::Request, [&](const base::Bytes& frame) {
        if (frame[4] == support::Action)
            pair.bench.wireConfig().faults.muteIds = {2};
        return false;
    });
    const auto sent = pair.move();
    pair.bench.wireConfig().faults.muteIds.clear();
    QVERIFY(!sent);
    QCOMPARE(sent.error().id, 2);
    QVERIFY2(pair.whole(1) && pair.whole(2), pair.story(sent).constData());
}

void TestHeldMoves::cutLineNamesAllThatMayHoldAGoal_data()
{
    QTest::addColumn<int>("cutAfter");
    QTest::addColumn<QList<int>>("holding");
    QTest::newRow("after the first goal") << 1 << QList<int>{1};
    QTest::newRow("after the second goal") << 2 << QList<int>{1, 2};
}

/// The cable comes loose between the held goals and the start.
void TestHeldMoves::cutLineNamesAllThatMayHoldAGoal()
{
    QFETCH(int, cutAfter);
    QFETCH(QList<int>, holding);
    Pair pair(false);
    int held = 0;
    lose(pair.bench, Lost::Request, [&](const base::Bytes& frame) {
        const bool cut = held >= cutAfter;
        held += frame[4] == support::RegWrite ? 1 : 0;
        return cut;
    });
    const auto sent = pair.move();
    QVERIFY(!sent);
    for (const int id : {1, 2}) {
        QCOMPARE(flag(pair.bench, id), holding.contains(id) ? 1 : 0);
        QVERIFY2(isNamed(sent.error(), id) == holding.contains(id),
                 qPrintable(sent.error().detail));
        QVERIFY(pair.none(id));
    }
}

/// A start that failed for one of them: whoever asks next must not start the other once more.
void TestHeldMoves::whatHasStartedIsHeldNoMore()
{
    Pair pair(false);
    const auto held = device::holdMoves(pair.bench.context(), pair.plans);
    QVERIFY2(held.has_value(), whatHappened(held).constData());
    for (const MovePlan& plan : pair.plans)
        QCOMPARE(plan.held, std::optional(true));
    lose(pair.bench, Lost::Request, [&](const base::Bytes& frame) {
        if (frame[4] == support::Action)
            pair.bench.wireConfig().faults.muteIds = {2};
        return false;
    });
    QVERIFY(!device::startHeld(pair.bench.context(), pair.plans));
    hearEverything(pair.bench);
    QCOMPARE(pair.plans[0].held, std::optional(false));
    QCOMPARE(pair.plans[1].held, std::optional(true)); // nobody knows
}

void TestHeldMoves::storedMovesThatWereStartedAreHeldNoMore()
{
    support::BenchOptions options;
    options.baud = 115'200;
    SimBench bench(text("lx16a@1,lx16a@2"), options);
    std::vector<device::Servo> servos;
    for (const int id : {1, 2}) {
        device::Servo servo = bench.servo(id, base::Protocol::Lx);
        QVERIFY(device::setTorque(bench.context(), servo, device::Torque::On));
        servos.push_back(bench.servo(id, base::Protocol::Lx));
    }
    auto plans = plansFor(bench, servos, text("600"));
    for (const MovePlan& plan : plans)
        QVERIFY(!plan.held);
    QVERIFY(device::holdMoves(bench.context(), plans));
    for (const MovePlan& plan : plans)
        QCOMPARE(plan.held, std::optional(true));
    // Silent before the start: nothing was started, and both wait.
    bench.wireConfig().faults.muteIds = {2};
    QVERIFY(!device::startHeld(bench.context(), plans));
    for (const MovePlan& plan : plans)
        QCOMPARE(plan.held, std::optional(true));
    bench.wireConfig().faults.muteIds.clear();
    QVERIFY(device::startHeld(bench.context(), plans));
    for (const MovePlan& plan : plans)
        QCOMPARE(plan.held, std::optional(false));
}

QTEST_GUILESS_MAIN(TestHeldMoves)
#include "tst_held_moves.moc"
