// SPDX-License-Identifier: GPL-3.0-or-later
// Held moves (REG WRITE, then ACTION) on a line that loses frames: each frame of them in turn, as a
// request and as its answer, and many by chance. What the servos have done is asked of their
// shafts, what was sent is counted on the wire. A move is made once or not at all, and never
// another one.
#include "device/motion/motion.h"
#include "device/reader.h"
#include "support/feetech_bytes.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <random>

using base::ErrorCode;
using device::MoveMethod;
using device::MovePlan;
using support::SimFixture;
using support::utf8;
using namespace std::chrono_literals;

namespace {
constexpr int goalAddress = 42;

enum class LostFrame { Request, Answer };

/// Loses the frames that `picks` selects.
void lose(SimFixture& fixture, LostFrame what, std::function<bool(const base::Bytes&)> picks)
{
    fixture.tap().onWrite = [&fixture, what, picks = std::move(picks)](const base::Bytes& frame) {
        auto& faults = fixture.wireConfig().faults;
        const double chance = picks(frame) ? 1.0 : 0.0;
        (what == LostFrame::Request ? faults.dropRequest : faults.drop) = chance;
    };
}

void restoreReplies(SimFixture& fixture)
{
    fixture.tap().onWrite = nullptr;
    fixture.wireConfig().faults.drop = 0;
    fixture.wireConfig().faults.dropRequest = 0;
}

std::vector<MovePlan> plansFor(SimFixture& fixture, std::vector<device::Servo>& servos,
                               const QString& goal)
{
    std::vector<MovePlan> plans;
    for (device::Servo& servo : servos) {
        device::MoveCommand order;
        order.servo = &servo;
        order.goal = goal;
        auto plan = device::planMove(fixture.context(), order);
        if (!plan)
            qFatal("plan");
        plans.push_back(*plan);
    }
    return plans;
}

/// Register 64, read on a good line.
std::int64_t flag(SimFixture& fixture, int id)
{
    device::Servo servo = fixture.servo(id);
    if (!device::readKeys(fixture.context(), servo, {utf8("async_write_flag")}))
        return -1;
    return servo.raw(utf8("async_write_flag")).value_or(-1);
}

/// A program that knows only bytes sends one frame and does not wait for the reply.
void sendRawFrame(SimFixture& fixture, int id, int instruction, const QByteArray& params = {})
{
    const QByteArray frame = support::feetechFrame(id, instruction, params);
    bus::Transaction transaction;
    transaction.request = protocol::Request::raw({frame.begin(), frame.end()});
    (void)fixture.bus().transact(transaction);
}

/// REG WRITE of a goal by another program.
void storeForeignGoal(SimFixture& fixture, int id, int goal)
{
    sendRawFrame(fixture, id, support::RegWrite,
                 QByteArray(1, goalAddress).append(char(goal & 0xFF)).append(char(goal >> 8)));
    QCOMPARE(flag(fixture, id), 1);
}

void sendActionToAll(SimFixture& fixture)
{
    sendRawFrame(fixture, 254, support::Action);
    fixture.runFor(4s);
}

/// As one of those in which a goal may wait.
bool isNamed(const base::Error& error, int id)
{
    QString ids = error.detail;
    if (!ids.startsWith(utf8("forget-held")))
        return false;
    ids.remove(utf8("forget-held"));
    const QStringList several = ids.split(utf8(","), Qt::SkipEmptyParts);
    return error.id == id || std::any_of(several.begin(), several.end(), [id](const QString& one) {
               return one.trimmed() == QString::number(id);
           });
}

QByteArray messageFor(const base::Result<void>& result)
{
    return result ? QByteArray("done")
                  : base::errorName(result.error().code).toUtf8() + " of servo " +
                        QByteArray::number(result.error().id);
}

support::SimFixtureOptions identical()
{
    support::SimFixtureOptions options;
    options.wire.identicalServos = true;
    return options;
}

/// Two servos at 180° with torque on, and a move of both: to 1024 (90°), or by 512 steps (45°).
struct Pair {
    explicit Pair(bool relative)
        : fixture(utf8("sts3215@1,sts3215@2"), identical())
        , way(relative ? 45.0 : -90.0)
    {
        for (const int id : {1, 2}) {
            device::Servo servo = fixture.servo(id);
            if (relative && !device::switchMode(fixture.context(), servo, utf8("step")))
                qFatal("mode");
            if (!device::setTorque(fixture.context(), servo, device::Torque::On))
                qFatal("torque");
            servos.push_back(fixture.servo(id));
        }
        fixture.runFor(1s);
        plans = plansFor(fixture, servos, relative ? utf8("512") : utf8("1024"));
        for (const int id : {1, 2})
            start[id] = fixture.shaft(id);
        fixture.notices().clear();
        fixture.clearFrames();
    }
    double moved(int id) { return fixture.shaft(id) - start[id]; }
    bool whole(int id) { return std::abs(moved(id) - way) < 4; }
    bool none(int id) { return std::abs(moved(id)) < 4; }
    /// Sends it, with time enough to arrive afterwards.
    base::Result<void> move()
    {
        const auto sent = device::sendMoves(fixture.context(), plans, MoveMethod::Async);
        restoreReplies(fixture);
        fixture.runFor(4s);
        return sent;
    }
    QByteArray failureText(const base::Result<void>& sent)
    {
        return messageFor(sent) + ": " + QByteArray::number(moved(1)) + "°, " +
               QByteArray::number(moved(2)) + "°";
    }

    SimFixture fixture;
    double way;
    std::vector<device::Servo> servos;
    std::vector<MovePlan> plans;
    std::map<int, double> start;
};
} // namespace

class TestAsyncMoves : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void everyFrameIsLostOnce_data();
    void everyFrameIsLostOnce();
    void manyRandomLosses_data();
    void manyRandomLosses();
    void aForeignStoredGoalIsNotOurs();
    void aCanceledMoveLeavesNoStoredGoal();
    void aLostActionLeavesNoStoredGoal();
    void servosSilentAtTheStartAreReported();
    void lostLinkReportsAllPossibleStoredGoals_data();
    void lostLinkReportsAllPossibleStoredGoals();
    void startedMovesAreNoLongerStored();
    void executedStoredMovesAreCleared();
};

void TestAsyncMoves::everyFrameIsLostOnce_data()
{
    QTest::addColumn<bool>("relative");
    QTest::addColumn<LostFrame>("what");
    QTest::newRow("goals, requests") << false << LostFrame::Request;
    QTest::newRow("goals, answers") << false << LostFrame::Answer;
    QTest::newRow("steps, requests") << true << LostFrame::Request;
    QTest::newRow("steps, answers") << true << LostFrame::Answer;
}

/// One frame lost: the move is made all the same, by both, once.
void TestAsyncMoves::everyFrameIsLostOnce()
{
    QFETCH(bool, relative);
    QFETCH(LostFrame, what);
    std::size_t frames = 1;
    for (std::size_t lost = 0; lost < frames; ++lost) {
        Pair pair(relative);
        std::size_t count = 0;
        lose(pair.fixture, what, [&](const base::Bytes&) { return count++ == lost; });
        const auto sent = pair.move();
        frames = std::max(frames, count);
        const QByteArray failureText =
            "frame " + QByteArray::number(int(lost)) + ": " + pair.failureText(sent);
        QVERIFY2(sent.has_value(), failureText.constData());
        for (const int id : {1, 2}) {
            QVERIFY2(pair.whole(id), failureText.constData());
            QCOMPARE(flag(pair.fixture, id), 0);
        }
        // A goal is held once, or again because its answer was lost; the start likewise.
        QVERIFY2(pair.fixture.frames(support::RegWrite) <= 3, failureText.constData());
        QVERIFY2(pair.fixture.frames(support::Action) <= 2, failureText.constData());
    }
    QVERIFY(frames > 6);
}

void TestAsyncMoves::manyRandomLosses_data()
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
void TestAsyncMoves::manyRandomLosses()
{
    QFETCH(bool, relative);
    QFETCH(double, chance);
    int done = 0;
    // Where half of all frames are lost one move in a hundred is made.
    const std::uint32_t seeds = chance < 0.3 ? 40 : 400;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        Pair pair(relative);
        std::mt19937 dice(seed);
        pair.fixture.tap().onWrite = [&](const base::Bytes&) {
            auto& faults = pair.fixture.wireConfig().faults;
            std::uniform_real_distribution<double> roll(0, 1);
            faults.dropRequest = roll(dice) < chance ? 1.0 : 0.0;
            faults.drop = roll(dice) < chance ? 1.0 : 0.0;
        };
        const auto sent = pair.move();
        const QByteArray failureText =
            "seed " + QByteArray::number(seed) + ": " + pair.failureText(sent);
        done += sent ? 1 : 0;
        for (const int id : {1, 2}) {
            QVERIFY2(pair.whole(id) || (!sent && pair.none(id)), failureText.constData());
            // A goal that still waits is reported.
            if (flag(pair.fixture, id) == 1)
                QVERIFY2(!sent && (sent.error().id == id || isNamed(sent.error(), id)),
                         failureText.constData());
        }
    }
    QVERIFY2(done > (chance < 0.3 ? 10 : 0), qPrintable(QString::number(done)));
}

/// A goal of another program waits in the servo, and ours never arrives: the flag is
/// set for the other goal, which must not be started for ours.
void TestAsyncMoves::aForeignStoredGoalIsNotOurs()
{
    Pair pair(false);
    storeForeignGoal(pair.fixture, 1, 3000);
    lose(pair.fixture, LostFrame::Request,
         [](const base::Bytes& frame) { return frame[4] == support::RegWrite && frame[2] == 1; });
    const auto sent = pair.move();
    QVERIFY2(!sent, pair.failureText(sent).constData());
    QCOMPARE(sent.error().id, 1);
    QVERIFY2(pair.none(1) && pair.none(2), pair.failureText(sent).constData());
    // Where ours arrives, it takes the other one's place.
    pair.plans = plansFor(pair.fixture, pair.servos, utf8("1024"));
    const auto again = pair.move();
    QVERIFY2(again.has_value(), pair.failureText(again).constData());
    QVERIFY2(pair.whole(1) && pair.whole(2), pair.failureText(again).constData());
}

/// The second servo does not get its goal, so the move is not made: nor by the first one when
/// another program starts what it holds.
void TestAsyncMoves::aCanceledMoveLeavesNoStoredGoal()
{
    Pair pair(false);
    lose(pair.fixture, LostFrame::Request,
         [](const base::Bytes& frame) { return frame[4] == support::RegWrite && frame[2] == 2; });
    const auto sent = pair.move();
    QVERIFY(!sent);
    QCOMPARE(sent.error().id, 2);
    QCOMPARE(flag(pair.fixture, 1), 0);
    QCOMPARE(pair.fixture.raw(1, utf8("torque_switch")), 1);
    sendActionToAll(pair.fixture);
    QVERIFY2(pair.none(1) && pair.none(2), pair.failureText(sent).constData());
}

/// No start arrives: both are named, because nothing proves what they hold, and a start by another
/// program moves none.
void TestAsyncMoves::aLostActionLeavesNoStoredGoal()
{
    Pair pair(false);
    lose(pair.fixture, LostFrame::Request,
         [](const base::Bytes& frame) { return frame[4] == support::Action; });
    const auto sent = pair.move();
    QVERIFY(!sent);
    QVERIFY2(isNamed(sent.error(), 1) && isNamed(sent.error(), 2), qPrintable(sent.error().detail));
    QVERIFY(pair.fixture.frames(support::Action) > 1);
    sendActionToAll(pair.fixture);
    QVERIFY2(pair.none(1) && pair.none(2), pair.failureText(sent).constData());
}

/// It is not known whether the start arrived.
void TestAsyncMoves::servosSilentAtTheStartAreReported()
{
    Pair pair(false);
    lose(pair.fixture, LostFrame::Request, [&](const base::Bytes& frame) {
        if (frame[4] == support::Action)
            pair.fixture.wireConfig().faults.muteIds = {2};
        return false;
    });
    const auto sent = pair.move();
    pair.fixture.wireConfig().faults.muteIds.clear();
    QVERIFY(!sent);
    QCOMPARE(sent.error().id, 2);
    QVERIFY2(pair.whole(1) && pair.whole(2), pair.failureText(sent).constData());
}

void TestAsyncMoves::lostLinkReportsAllPossibleStoredGoals_data()
{
    QTest::addColumn<int>("cutAfter");
    QTest::addColumn<QList<int>>("holding");
    QTest::newRow("after the first goal") << 1 << QList<int>{1};
    QTest::newRow("after the second goal") << 2 << QList<int>{1, 2};
}

/// The cable comes loose between the held goals and the start.
void TestAsyncMoves::lostLinkReportsAllPossibleStoredGoals()
{
    QFETCH(int, cutAfter);
    QFETCH(QList<int>, holding);
    Pair pair(false);
    int held = 0;
    lose(pair.fixture, LostFrame::Request, [&](const base::Bytes& frame) {
        const bool cut = held >= cutAfter;
        held += frame[4] == support::RegWrite ? 1 : 0;
        return cut;
    });
    const auto sent = pair.move();
    QVERIFY(!sent);
    for (const int id : {1, 2}) {
        QCOMPARE(flag(pair.fixture, id), holding.contains(id) ? 1 : 0);
        QVERIFY2(isNamed(sent.error(), id) == holding.contains(id),
                 qPrintable(sent.error().detail));
        QVERIFY(pair.none(id));
    }
}

/// A start that failed for one of them: a later start must not start the other once more.
void TestAsyncMoves::startedMovesAreNoLongerStored()
{
    Pair pair(false);
    const auto held = device::sendAsyncMoves(pair.fixture.context(), pair.plans);
    QVERIFY2(held.has_value(), messageFor(held).constData());
    for (const MovePlan& plan : pair.plans)
        QCOMPARE(plan.held, std::optional(true));
    lose(pair.fixture, LostFrame::Request, [&](const base::Bytes& frame) {
        if (frame[4] == support::Action)
            pair.fixture.wireConfig().faults.muteIds = {2};
        return false;
    });
    QVERIFY(!device::startAsyncMoves(pair.fixture.context(), pair.plans));
    restoreReplies(pair.fixture);
    QCOMPARE(pair.plans[0].held, std::optional(false));
    QCOMPARE(pair.plans[1].held, std::optional(true)); // not known
}

void TestAsyncMoves::executedStoredMovesAreCleared()
{
    support::SimFixtureOptions options;
    options.baud = 115'200;
    SimFixture fixture(utf8("lx16a@1,lx16a@2"), options);
    std::vector<device::Servo> servos;
    for (const int id : {1, 2}) {
        device::Servo servo = fixture.servo(id, base::Protocol::Lx);
        QVERIFY(device::setTorque(fixture.context(), servo, device::Torque::On));
        servos.push_back(fixture.servo(id, base::Protocol::Lx));
    }
    auto plans = plansFor(fixture, servos, utf8("600"));
    for (const MovePlan& plan : plans)
        QVERIFY(!plan.held);
    QVERIFY(device::sendAsyncMoves(fixture.context(), plans));
    for (const MovePlan& plan : plans)
        QCOMPARE(plan.held, std::optional(true));
    // Silent before the start: nothing was started, and both wait.
    fixture.wireConfig().faults.muteIds = {2};
    QVERIFY(!device::startAsyncMoves(fixture.context(), plans));
    for (const MovePlan& plan : plans)
        QCOMPARE(plan.held, std::optional(true));
    fixture.wireConfig().faults.muteIds.clear();
    QVERIFY(device::startAsyncMoves(fixture.context(), plans));
    for (const MovePlan& plan : plans)
        QCOMPARE(plan.held, std::optional(false));
}

SERVODESK_GUILESS_TEST(TestAsyncMoves)
#include "tst_async_moves.moc"
