// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted writes of registers that are lost at power-off, and the mark of a restart: what is
// said of them has been read, what undo and finish ask for is written and read back, and what would
// move the servo or is another value by now stays.
#include "device/motion.h"
#include "device/writer.h"
#include "jobs/change.h"
#include "jobs/recover.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

using base::Bytes;
using device::WriteItem;
using jobs::Finding;
using jobs::RecoverAction;
using jobs::Recovered;
using support::SimBench;

namespace {
constexpr int acceleration = 41;
constexpr int torqueLimit = 48;

QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

bool writes(const Bytes& frame, int address)
{
    return frame.size() > 5 && frame[4] == support::Write && frame[5] == address;
}

/// The cable is cut once the frame has arrived, or before it arrives.
void interrupt(SimBench& bench, const std::vector<WriteItem>& items, int address, bool arrives)
{
    device::Servo servo = bench.servo(1);
    bool sent = false;
    bench.tap().onWrite = [&](const Bytes& frame) {
        const bool now = writes(frame, address);
        if (arrives ? sent : now)
            bench.cutLink();
        sent = sent || now;
    };
    const auto report = device::write(bench.context(), servo, items, {false, true});
    QVERIFY(report && !report->allGood());
    bench.tap().onWrite = nullptr;
    bench.reconnect(1'000'000);
    bench.forgetFrames();
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
}

/// Of one open change.
Recovered recover(SimBench& bench, RecoverAction action)
{
    auto all = jobs::recover(bench.context(), action);
    if (!all || all->size() != 1)
        qFatal("one change was to be recovered");
    return std::move(all->front());
}

base::IntentEnd lastEnd(SimBench& bench, std::size_t entry)
{
    return bench.journal().entries()->at(entry).end.value_or(base::IntentEnd{});
}
} // namespace

class TestRecoverRam : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void aWriteIsReadThenSettled_data();
    void aWriteIsReadThenSettled();
    void halfOfAWriteIsFoundAndSettled_data();
    void halfOfAWriteIsFoundAndSettled();
    void whatARestartHasLoadedStays();
    void aGoalIsNeverWritten();
    void torqueIsNeverSwitchedOn();
    void theMarkOfARestartIsTakenBack_data();
    void theMarkOfARestartIsTakenBack();
    void afterTheRestartNothingIsOwed();
    void aRefusedValueIsNotClaimed();
    void aModeThatIsForgottenIsSettled_data();
    void aModeThatIsForgottenIsSettled();
};

void TestRecoverRam::aWriteIsReadThenSettled_data()
{
    QTest::addColumn<bool>("arrives");
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("expected");
    QTest::newRow("arrived, undo") << true << int(RecoverAction::Undo) << 1000;
    QTest::newRow("arrived, finish") << true << int(RecoverAction::Finish) << 500;
    QTest::newRow("lost, undo") << false << int(RecoverAction::Undo) << 1000;
    QTest::newRow("lost, finish") << false << int(RecoverAction::Finish) << 500;
}

void TestRecoverRam::aWriteIsReadThenSettled()
{
    QFETCH(bool, arrives);
    QFETCH(int, action);
    QFETCH(int, expected);
    SimBench bench(text("sts3215@1"));
    interrupt(bench, {{text("torque_limit"), 500}}, torqueLimit, arrives);
    QCOMPARE(bench.raw(1, text("torque_limit")), arrives ? 500 : 1000);
    const Recovered look = recover(bench, RecoverAction::Look);
    QCOMPARE(look.before.finding, arrives ? Finding::AllNew : Finding::AllOld);
    QVERIFY(bench.onlyAsked());
    const Recovered settled = recover(bench, RecoverAction(action));
    QVERIFY(settled.done && settled.left.isEmpty());
    QCOMPARE(bench.raw(1, text("torque_limit")), expected);
    QVERIFY(bench.journal().open()->empty());
    QCOMPARE(lastEnd(bench, 0).outcome,
             action == int(RecoverAction::Undo) ? text("undone") : text("done"));
}

void TestRecoverRam::halfOfAWriteIsFoundAndSettled_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("limit");
    QTest::newRow("undo") << int(RecoverAction::Undo) << 1000;
    QTest::newRow("finish") << int(RecoverAction::Finish) << 400;
}

void TestRecoverRam::halfOfAWriteIsFoundAndSettled()
{
    QFETCH(int, action);
    QFETCH(int, limit);
    SimBench bench(text("sts3215@1"));
    const std::int64_t before = bench.raw(1, text("acceleration"));
    interrupt(bench, {{text("acceleration"), 20}, {text("torque_limit"), 400}}, torqueLimit, false);
    QCOMPARE(bench.raw(1, text("acceleration")), 20);
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
    QCOMPARE(recover(bench, RecoverAction::Look).before.finding, Finding::Mixed);
    QVERIFY(recover(bench, RecoverAction(action)).done);
    QCOMPARE(bench.raw(1, text("torque_limit")), limit);
    QCOMPARE(bench.raw(1, text("acceleration")), limit == 400 ? 20 : before);
}

/// Neither the old value nor the new one: nothing of the change is left in the servo.
void TestRecoverRam::whatARestartHasLoadedStays()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("torque_limit"), 800);
    interrupt(bench, {{text("torque_limit"), 500}}, torqueLimit, true);
    bench.powerCycle();
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
    QCOMPARE(recover(bench, RecoverAction::Look).before.finding, Finding::Replaced);
    const Recovered settled = recover(bench, RecoverAction::Undo);
    QVERIFY(settled.done && settled.allLeft);
    QCOMPARE(settled.left, QStringList{text("torque_limit")});
    QVERIFY(bench.onlyAsked());
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
    QCOMPARE(lastEnd(bench, 0).outcome, text("abandoned"));
}

void TestRecoverRam::aGoalIsNeverWritten()
{
    constexpr int goal = 42;
    SimBench bench(text("sts3215@1"));
    const std::int64_t before = bench.raw(1, text("acceleration"));
    interrupt(bench, {{text("acceleration"), 20}, {text("goal_position"), 2100}}, acceleration,
              true);
    QCOMPARE(bench.raw(1, text("goal_position")), 2100); // one frame carries both
    const Recovered settled = recover(bench, RecoverAction::Undo);
    QVERIFY(settled.done && !settled.allLeft);
    QCOMPARE(settled.left, QStringList{text("goal_position")});
    QCOMPARE(bench.raw(1, text("acceleration")), before);
    QVERIFY(std::none_of(bench.tap().written.begin(), bench.tap().written.end(),
                         [](const Bytes& frame) { return writes(frame, goal); }));
    const auto end = lastEnd(bench, 0);
    QCOMPARE(end.outcome, text("undone"));
    QCOMPARE(end.items.size(), std::size_t(1)); // that one is not undone
    QCOMPARE(end.items.front().key, text("goal_position"));
    QCOMPARE(end.items.front().outcome, text("unknown"));
}

void TestRecoverRam::torqueIsNeverSwitchedOn()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("torque_switch"), 1);
    interrupt(bench, {{text("torque_switch"), 0}}, 40, true);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    const Recovered settled = recover(bench, RecoverAction::Undo);
    QVERIFY(settled.done && settled.allLeft);
    QVERIFY(bench.onlyAsked());
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
}

void TestRecoverRam::theMarkOfARestartIsTakenBack_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mark");
    QTest::addColumn<int>("action");
    for (const auto action : {RecoverAction::Undo, RecoverAction::Finish}) {
        const char* name = action == RecoverAction::Undo ? "undo" : "finish";
        QTest::addRow("STS, %s", name) << text("sts3215@1") << text("torque_limit") << int(action);
        QTest::addRow("SCS, %s", name)
            << text("scs15@1:1000000") << text("goal_time") << int(action);
    }
}

/// Cut when the restart is asked for: the servo has not restarted, and its mark stands.
void TestRecoverRam::theMarkOfARestartIsTakenBack()
{
    QFETCH(QString, servo);
    QFETCH(QString, mark);
    QFETCH(int, action);
    SimBench bench(servo);
    device::Servo one = bench.servo(1);
    const std::int64_t before = bench.raw(1, mark);
    bench.tap().answerInstead = [&bench](const Bytes& frame) {
        if (frame[4] != support::Reboot)
            return std::optional<Bytes>();
        bench.cutLink();
        return std::optional(Bytes());
    };
    QVERIFY(!jobs::reboot(bench.context(), one));
    bench.tap().answerInstead = nullptr;
    bench.reconnect(1'000'000);
    QVERIFY(bench.raw(1, mark) != before);
    QCOMPARE(recover(bench, RecoverAction::Look).before.finding, Finding::AllNew);
    QVERIFY(recover(bench, RecoverAction(action)).done);
    QCOMPARE(bench.raw(1, mark), before);
    QCOMPARE(lastEnd(bench, 0).outcome, text("undone"));
}

void TestRecoverRam::afterTheRestartNothingIsOwed()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    bool asked = false;
    bench.tap().onWrite = [&](const Bytes& frame) {
        if (asked)
            bench.cutLink();
        asked = asked || frame[4] == support::Reboot;
    };
    QVERIFY(!jobs::reboot(bench.context(), one));
    bench.tap().onWrite = nullptr;
    bench.letTimePass(std::chrono::seconds(3));
    bench.reconnect(1'000'000);
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
    bench.forgetFrames();
    QCOMPARE(recover(bench, RecoverAction::Look).before.finding, Finding::AllOld);
    QVERIFY(recover(bench, RecoverAction::Undo).done);
    QVERIFY(bench.onlyAsked());
    QCOMPARE(bench.raw(1, text("torque_limit")), 1000);
}

/// The servo acknowledges what puts the old value back, and keeps the new one.
void TestRecoverRam::aRefusedValueIsNotClaimed()
{
    SimBench bench(text("sts3215@1"));
    interrupt(bench, {{text("torque_limit"), 500}}, torqueLimit, true);
    const Bytes acknowledged{0xFF, 0xFF, 0x01, 0x02, 0x00, 0xFC};
    bench.tap().answerInstead = [&](const Bytes& frame) {
        return writes(frame, torqueLimit) ? std::optional(acknowledged) : std::nullopt;
    };
    const Recovered refused = recover(bench, RecoverAction::Undo);
    QVERIFY(!refused.done && refused.error);
    QCOMPARE(refused.error->code, base::ErrorCode::Refused);
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
}

void TestRecoverRam::aModeThatIsForgottenIsSettled_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("undo") << int(RecoverAction::Undo);
    QTest::newRow("finish") << int(RecoverAction::Finish);
}

/// An LX servo loses its mode at power-off, but it is a setting like any other until then.
void TestRecoverRam::aModeThatIsForgottenIsSettled()
{
    constexpr int modeWrite = 29;
    QFETCH(int, action);
    SimBench bench(text("lx16a@1"), {.baud = 115'200});
    device::Servo servo = bench.servo(1, base::Protocol::Lx);
    const QString before = servo.mode()->key;
    bool sent = false;
    bench.tap().onWrite = [&](const Bytes& frame) {
        if (sent)
            bench.cutLink();
        sent = sent || (frame.size() > 4 && frame[4] == modeWrite);
    };
    const auto report = device::switchMode(bench.context(), servo, text("motor"));
    QVERIFY(report && !report->allGood() && sent);
    bench.tap().onWrite = nullptr;
    bench.reconnect(115'200);
    QCOMPARE(bench.servo(1, base::Protocol::Lx).mode()->key, text("motor"));
    QCOMPARE(recover(bench, RecoverAction::Look).before.finding, Finding::AllNew);
    QVERIFY(recover(bench, RecoverAction(action)).done);
    const device::Servo after = bench.servo(1, base::Protocol::Lx);
    QCOMPARE(after.mode()->key, action == int(RecoverAction::Undo) ? before : text("motor"));
    QCOMPARE(bench.raw(1, text("load")), 0);
    QVERIFY(bench.journal().open()->empty());
}

QTEST_GUILESS_MAIN(TestRecoverRam)
#include "tst_recover_ram.moc"
