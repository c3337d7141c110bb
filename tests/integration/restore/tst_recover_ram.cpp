// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted writes of registers that are lost at power-off, and the mark of a restart: what is
// said of them has been read, what undo and finish ask for is written and read back, and what would
// move the servo or is another value by now stays.
#include "device/motion/motion.h"
#include "device/writer.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

using base::Bytes;
using device::WriteItem;
using jobs::Finding;
using jobs::RecoveryAction;
using jobs::RecoveryResult;
using support::SimFixture;
using support::utf8;

namespace {
constexpr int acceleration = 41;
constexpr int torqueLimit = 48;

bool writes(const Bytes& frame, int address)
{
    return frame.size() > 5 && frame[4] == support::Write && frame[5] == address;
}

/// The cable is cut once the frame has arrived, or before it arrives.
void interrupt(SimFixture& fixture, const std::vector<WriteItem>& items, int address, bool arrives)
{
    device::Servo servo = fixture.servo(1);
    bool sent = false;
    fixture.tap().onWrite = [&](const Bytes& frame) {
        const bool now = writes(frame, address);
        if (arrives ? sent : now)
            fixture.cutLink();
        sent = sent || now;
    };
    const auto report =
        device::write(fixture.context(), servo, items, {false, device::Consent::confirmed()});
    QVERIFY(report && !report->isSuccessful());
    fixture.tap().onWrite = nullptr;
    fixture.reconnect(1'000'000);
    fixture.clearFrames();
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

/// Of one open change.
RecoveryResult recover(SimFixture& fixture, RecoveryAction action)
{
    auto all = jobs::recover(fixture.context(), action);
    if (!all || all->size() != 1)
        qFatal("one change was to be recovered");
    return std::move(all->front());
}

base::IntentResult lastEnd(SimFixture& fixture, std::size_t entry)
{
    return fixture.journal().entries()->at(entry).end.value_or(base::IntentResult{});
}
} // namespace

class TestRecoverRam : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void aWriteIsReadThenRecovered_data();
    void aWriteIsReadThenRecovered();
    void aPartialWriteIsFoundAndRecovered_data();
    void aPartialWriteIsFoundAndRecovered();
    void valuesReloadedByARestartAreKept();
    void aGoalIsNeverWritten();
    void torqueIsNeverSwitchedOn();
    void theRestartMarkerIsReverted_data();
    void theRestartMarkerIsReverted();
    void nothingIsPendingAfterTheRestart();
    void aRefusedValueIsNotReportedDone();
    void aModeLostAtPowerOffIsRecovered_data();
    void aModeLostAtPowerOffIsRecovered();
};

void TestRecoverRam::aWriteIsReadThenRecovered_data()
{
    QTest::addColumn<bool>("arrives");
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("expected");
    QTest::newRow("arrived, undo") << true << int(RecoveryAction::Undo) << 1000;
    QTest::newRow("arrived, finish") << true << int(RecoveryAction::Finish) << 500;
    QTest::newRow("lost, undo") << false << int(RecoveryAction::Undo) << 1000;
    QTest::newRow("lost, finish") << false << int(RecoveryAction::Finish) << 500;
}

void TestRecoverRam::aWriteIsReadThenRecovered()
{
    QFETCH(bool, arrives);
    QFETCH(int, action);
    QFETCH(int, expected);
    SimFixture fixture(utf8("sts3215@1"));
    interrupt(fixture, {{utf8("torque_limit"), 500}}, torqueLimit, arrives);
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), arrives ? 500 : 1000);
    const RecoveryResult look = recover(fixture, RecoveryAction::Preview);
    QCOMPARE(look.before.finding, arrives ? Finding::AllNew : Finding::AllOld);
    QVERIFY(fixture.onlyReadsSent());
    const RecoveryResult settled = recover(fixture, RecoveryAction(action));
    QVERIFY(settled.done && settled.skippedKeys.isEmpty());
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), expected);
    QVERIFY(fixture.journal().open()->empty());
    QCOMPARE(lastEnd(fixture, 0).outcome,
             action == int(RecoveryAction::Undo) ? utf8("undone") : utf8("done"));
}

void TestRecoverRam::aPartialWriteIsFoundAndRecovered_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("limit");
    QTest::newRow("undo") << int(RecoveryAction::Undo) << 1000;
    QTest::newRow("finish") << int(RecoveryAction::Finish) << 400;
}

void TestRecoverRam::aPartialWriteIsFoundAndRecovered()
{
    QFETCH(int, action);
    QFETCH(int, limit);
    SimFixture fixture(utf8("sts3215@1"));
    const std::int64_t before = fixture.raw(1, utf8("acceleration"));
    interrupt(fixture, {{utf8("acceleration"), 20}, {utf8("torque_limit"), 400}}, torqueLimit,
              false);
    QCOMPARE(fixture.raw(1, utf8("acceleration")), 20);
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
    QCOMPARE(recover(fixture, RecoveryAction::Preview).before.finding, Finding::Mixed);
    QVERIFY(recover(fixture, RecoveryAction(action)).done);
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), limit);
    QCOMPARE(fixture.raw(1, utf8("acceleration")), limit == 400 ? 20 : before);
}

/// Neither the old value nor the new one: nothing of the change is left in the servo.
void TestRecoverRam::valuesReloadedByARestartAreKept()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("torque_limit"), 800);
    interrupt(fixture, {{utf8("torque_limit"), 500}}, torqueLimit, true);
    fixture.powerCycle();
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
    QCOMPARE(recover(fixture, RecoveryAction::Preview).before.finding, Finding::Replaced);
    const RecoveryResult settled = recover(fixture, RecoveryAction::Undo);
    QVERIFY(settled.done && settled.isAllSkipped);
    QCOMPARE(settled.skippedKeys, QStringList{utf8("torque_limit")});
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
    QCOMPARE(lastEnd(fixture, 0).outcome, utf8("abandoned"));
}

void TestRecoverRam::aGoalIsNeverWritten()
{
    constexpr int goal = 42;
    SimFixture fixture(utf8("sts3215@1"));
    const std::int64_t before = fixture.raw(1, utf8("acceleration"));
    interrupt(fixture, {{utf8("acceleration"), 20}, {utf8("goal_position"), 2100}}, acceleration,
              true);
    QCOMPARE(fixture.raw(1, utf8("goal_position")), 2100); // one frame carries both
    const RecoveryResult settled = recover(fixture, RecoveryAction::Undo);
    QVERIFY(settled.done && !settled.isAllSkipped);
    QCOMPARE(settled.skippedKeys, QStringList{utf8("goal_position")});
    QCOMPARE(fixture.raw(1, utf8("acceleration")), before);
    QVERIFY(std::none_of(fixture.tap().written.begin(), fixture.tap().written.end(),
                         [](const Bytes& frame) { return writes(frame, goal); }));
    const auto end = lastEnd(fixture, 0);
    QCOMPARE(end.outcome, utf8("undone"));
    QCOMPARE(end.items.size(), std::size_t(1)); // that one is not undone
    QCOMPARE(end.items.front().key, utf8("goal_position"));
    QCOMPARE(end.items.front().outcome, utf8("unknown"));
}

void TestRecoverRam::torqueIsNeverSwitchedOn()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("torque_switch"), 1);
    interrupt(fixture, {{utf8("torque_switch"), 0}}, 40, true);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    const RecoveryResult settled = recover(fixture, RecoveryAction::Undo);
    QVERIFY(settled.done && settled.isAllSkipped);
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

void TestRecoverRam::theRestartMarkerIsReverted_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mark");
    QTest::addColumn<int>("action");
    for (const auto action : {RecoveryAction::Undo, RecoveryAction::Finish}) {
        const char* name = action == RecoveryAction::Undo ? "undo" : "finish";
        QTest::addRow("STS, %s", name) << utf8("sts3215@1") << utf8("torque_limit") << int(action);
        QTest::addRow("SCS, %s", name)
            << utf8("scs15@1:1000000") << utf8("goal_time") << int(action);
    }
}

/// Cut at the restart command: the servo has not restarted, and its mark is still set.
void TestRecoverRam::theRestartMarkerIsReverted()
{
    QFETCH(QString, servo);
    QFETCH(QString, mark);
    QFETCH(int, action);
    SimFixture fixture(servo);
    device::Servo one = fixture.servo(1);
    const std::int64_t before = fixture.raw(1, mark);
    fixture.tap().replyOverride = [&fixture](const Bytes& frame) {
        if (frame[4] != support::Reboot)
            return std::optional<Bytes>();
        fixture.cutLink();
        return std::optional(Bytes());
    };
    QVERIFY(!jobs::reboot(fixture.context(), one));
    fixture.tap().replyOverride = nullptr;
    fixture.reconnect(1'000'000);
    QVERIFY(fixture.raw(1, mark) != before);
    QCOMPARE(recover(fixture, RecoveryAction::Preview).before.finding, Finding::AllNew);
    QVERIFY(recover(fixture, RecoveryAction(action)).done);
    QCOMPARE(fixture.raw(1, mark), before);
    QCOMPARE(lastEnd(fixture, 0).outcome, utf8("undone"));
}

void TestRecoverRam::nothingIsPendingAfterTheRestart()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    bool asked = false;
    fixture.tap().onWrite = [&](const Bytes& frame) {
        if (asked)
            fixture.cutLink();
        asked = asked || frame[4] == support::Reboot;
    };
    QVERIFY(!jobs::reboot(fixture.context(), one));
    fixture.tap().onWrite = nullptr;
    fixture.runFor(std::chrono::seconds(3));
    fixture.reconnect(1'000'000);
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
    fixture.clearFrames();
    QCOMPARE(recover(fixture, RecoveryAction::Preview).before.finding, Finding::AllOld);
    QVERIFY(recover(fixture, RecoveryAction::Undo).done);
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(fixture.raw(1, utf8("torque_limit")), 1000);
}

/// The servo acknowledges what puts the old value back, and keeps the new one.
void TestRecoverRam::aRefusedValueIsNotReportedDone()
{
    SimFixture fixture(utf8("sts3215@1"));
    interrupt(fixture, {{utf8("torque_limit"), 500}}, torqueLimit, true);
    const Bytes acknowledged{0xFF, 0xFF, 0x01, 0x02, 0x00, 0xFC};
    fixture.tap().replyOverride = [&](const Bytes& frame) {
        return writes(frame, torqueLimit) ? std::optional(acknowledged) : std::nullopt;
    };
    const RecoveryResult refused = recover(fixture, RecoveryAction::Undo);
    QVERIFY(!refused.done && refused.error);
    QCOMPARE(refused.error->code, base::ErrorCode::Refused);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

void TestRecoverRam::aModeLostAtPowerOffIsRecovered_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("undo") << int(RecoveryAction::Undo);
    QTest::newRow("finish") << int(RecoveryAction::Finish);
}

/// An LX servo loses its mode at power-off, but it is a setting like any other until then.
void TestRecoverRam::aModeLostAtPowerOffIsRecovered()
{
    constexpr int modeWrite = 29;
    QFETCH(int, action);
    SimFixture fixture(utf8("lx16a@1"), {.baud = 115'200});
    device::Servo servo = fixture.servo(1, base::Protocol::Lx);
    const QString before = servo.mode()->key;
    bool sent = false;
    fixture.tap().onWrite = [&](const Bytes& frame) {
        if (sent)
            fixture.cutLink();
        sent = sent || (frame.size() > 4 && frame[4] == modeWrite);
    };
    const auto report = device::switchMode(fixture.context(), servo, utf8("motor"));
    QVERIFY(report && !report->isSuccessful() && sent);
    fixture.tap().onWrite = nullptr;
    fixture.reconnect(115'200);
    QCOMPARE(fixture.servo(1, base::Protocol::Lx).mode()->key, utf8("motor"));
    QCOMPARE(recover(fixture, RecoveryAction::Preview).before.finding, Finding::AllNew);
    QVERIFY(recover(fixture, RecoveryAction(action)).done);
    const device::Servo after = fixture.servo(1, base::Protocol::Lx);
    QCOMPARE(after.mode()->key, action == int(RecoveryAction::Undo) ? before : utf8("motor"));
    QCOMPARE(fixture.raw(1, utf8("load")), 0);
    QVERIFY(fixture.journal().open()->empty());
}

SERVODESK_GUILESS_TEST(TestRecoverRam)
#include "tst_recover_ram.moc"
