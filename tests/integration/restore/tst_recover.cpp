// SPDX-License-Identifier: GPL-3.0-or-later
// The link is cut at every single byte of an ID change, a rate change, a mode switch and a write of
// five registers. Afterwards, with the cable back, recover must leave no lock open, lose nothing
// and claim nothing that is not so.
#include "device/motion/motion.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

#include <map>

using device::WriteItem;
using jobs::Finding;
using jobs::RecoveryAction;
using support::SimFixture;
using support::utf8;

namespace {
enum class Task { SetId, SetBaud, Mode, FiveRegisters };

const std::vector<WriteItem>& fiveRegisters()
{
    static const std::vector<WriteItem> items{{utf8("min_angle_limit"), 500},
                                              {utf8("max_angle_limit"), 3500},
                                              {utf8("max_temperature"), 61},
                                              {utf8("position_p"), 20},
                                              {utf8("overload_torque"), 70}};
    return items;
}

base::Result<void> run(SimFixture& fixture, Task task)
{
    auto servo = device::identify(fixture.context(), 1);
    if (!servo)
        return tl::unexpected(servo.error());
    base::Result<device::WriteReport> report;
    switch (task) {
    case Task::SetId:
        report = jobs::changeId(fixture.context(), *servo, 9);
        break;
    case Task::SetBaud:
        report = jobs::changeBaud(fixture.context(), *servo, 115'200);
        break;
    case Task::Mode:
        report = device::switchMode(fixture.context(), *servo, utf8("step"));
        break;
    case Task::FiveRegisters:
        report = device::write(fixture.context(), *servo, fiveRegisters(), {});
        break;
    }
    if (!report)
        return tl::unexpected(report.error());
    if (!report->isSuccessful())
        return base::fail(base::ErrorCode::Refused);
    return {};
}

std::size_t bytesOf(Task task)
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.clearFrames();
    if (!run(fixture, task))
        qFatal("the task does not work on a whole line");
    std::size_t bytes = 0;
    for (const base::Bytes& frame : fixture.tap().written)
        bytes += frame.size();
    return bytes;
}

using Eprom = std::map<QString, std::int64_t>;

Eprom eprom(SimFixture& fixture)
{
    return fixture.withBus([](sim::VirtualBus& wire) {
        Eprom values;
        sim::VirtualServo& servo = *wire.servos().front();
        for (const catalog::Register& reg : servo.profile().registers) {
            if (reg.eprom())
                values[reg.key] = servo.raw(reg.key);
        }
        return values;
    });
}

bool isLockOpen(SimFixture& fixture)
{
    return fixture.withBus(
        [](sim::VirtualBus& wire) { return wire.servos().front()->raw(utf8("lock")) == 0; });
}

Eprom wanted(Task task)
{
    SimFixture fixture(utf8("sts3215@1"));
    if (!run(fixture, task))
        qFatal("the task does not work on a whole line");
    return eprom(fixture);
}
} // namespace

class TestRecover : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void linkLostAtEveryByte_data();
    void linkLostAtEveryByte();
    void viewingWritesNothing();
    void otherServoIsNotChanged();
    void otherValuesAreNotChanged();
    void laterOwnWritesAreKept_data();
    void laterOwnWritesAreKept();
    void noiseIsNotAnotherServo();
    void factoryResetThatChangedTheId_data();
    void factoryResetThatChangedTheId();
    void otherPortIsNotAffected();
    void silentServoStaysOpen();
};

void TestRecover::linkLostAtEveryByte_data()
{
    QTest::addColumn<int>("task");
    QTest::addColumn<int>("action");
    QTest::addColumn<bool>("powerCycle");
    const std::map<const char*, Task> tasks{{"set-id", Task::SetId},
                                            {"set-baud", Task::SetBaud},
                                            {"mode", Task::Mode},
                                            {"five registers", Task::FiveRegisters}};
    for (const auto& [name, task] : tasks) {
        for (const auto action : {RecoveryAction::Finish, RecoveryAction::Undo}) {
            for (const bool cycle : {false, true}) {
                QTest::addRow("%s, %s%s", name,
                              action == RecoveryAction::Finish ? "finish" : "undo",
                              cycle ? ", after a power cycle" : "")
                    << int(task) << int(action) << cycle;
            }
        }
    }
}

void TestRecover::linkLostAtEveryByte()
{
    QFETCH(int, task);
    QFETCH(int, action);
    QFETCH(bool, powerCycle);
    const auto doing = Task(task);
    const auto wish = RecoveryAction(action);
    const Eprom after = wanted(doing);
    const std::size_t length = bytesOf(doing);
    int interrupted = 0;
    for (std::size_t cut = 1; cut < length; ++cut) {
        SimFixture fixture(utf8("sts3215@1"));
        const Eprom before = eprom(fixture);
        fixture.cutAfterHostBytes(cut);
        const auto done = run(fixture, doing);
        const auto open = *fixture.journal().open();
        QVERIFY2(!done || open.empty(), "claimed done although the journal says otherwise");
        if (powerCycle)
            fixture.powerCycle();
        fixture.reconnect(1'000'000);
        // Nothing is ever left open without the journal knowing.
        if (isLockOpen(fixture))
            QVERIFY2(!open.empty(), qPrintable(QString::number(cut)));
        if (open.empty()) {
            const Eprom now = eprom(fixture);
            QVERIFY2(now == before || now == after, qPrintable(QString::number(cut)));
            continue;
        }
        ++interrupted;
        const auto recovered = jobs::recover(fixture.context(), wish);
        QVERIFY2(recovered, recovered ? "" : qPrintable(base::errorName(recovered.error().code)));
        QCOMPARE(recovered->size(), std::size_t(1));
        QVERIFY2(recovered->front().done,
                 qPrintable(utf8("cut %1 finding %2 error %3")
                                .arg(cut)
                                .arg(int(recovered->front().before.finding))
                                .arg(recovered->front().error
                                         ? base::errorName(recovered->front().error->code)
                                         : QString())));
        QVERIFY2(!isLockOpen(fixture), qPrintable(QString::number(cut)));
        QVERIFY2(eprom(fixture) == (wish == RecoveryAction::Finish ? after : before),
                 qPrintable(QString::number(cut)));
        QVERIFY(fixture.journal().open()->empty());
        // What was finished or undone holds after a power-off as well.
        fixture.powerCycle();
        QVERIFY(eprom(fixture) == (wish == RecoveryAction::Finish ? after : before));
    }
    QVERIFY(interrupted > 10);
}

namespace {
/// A five-register write cut in its middle.
void interrupt(SimFixture& fixture)
{
    fixture.tap().onWrite = [&fixture](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 21)
            fixture.cutLink();
    };
    QVERIFY(!run(fixture, Task::FiveRegisters));
    fixture.tap().onWrite = nullptr;
    fixture.reconnect(1'000'000);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
    QVERIFY(isLockOpen(fixture));
}
} // namespace

void TestRecover::viewingWritesNothing()
{
    SimFixture fixture(utf8("sts3215@1"));
    interrupt(fixture);
    fixture.clearFrames();
    const auto seen = jobs::recover(fixture.context(), RecoveryAction::Preview);
    QVERIFY(seen);
    QCOMPARE(seen->front().before.finding, Finding::Mixed);
    QCOMPARE(seen->front().before.lockOpen, std::optional<bool>(true));
    QVERIFY(!seen->front().done);
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

void TestRecover::otherServoIsNotChanged()
{
    SimFixture fixture(utf8("sts3215@1,sts3250@7"));
    interrupt(fixture);
    // Overnight another model gets this ID.
    fixture.withBus([](sim::VirtualBus& wire) {
        wire.servo(1)->poke(utf8("id"), 20);
        wire.servo(7)->poke(utf8("id"), 1);
    });
    fixture.runFor(std::chrono::milliseconds(50));
    fixture.clearFrames();
    for (const auto action : {RecoveryAction::Finish, RecoveryAction::Undo}) {
        const auto recovered = jobs::recover(fixture.context(), action);
        QVERIFY(recovered);
        QCOMPARE(recovered->front().before.finding, Finding::OtherServo);
        QVERIFY(!recovered->front().done);
        QVERIFY(fixture.onlyReadsSent());
    }
}

void TestRecover::otherValuesAreNotChanged()
{
    SimFixture fixture(utf8("sts3215@1"));
    interrupt(fixture);
    fixture.poke(1, utf8("max_temperature"), 44); // neither the old value nor the new
    fixture.runFor(std::chrono::milliseconds(50));
    fixture.clearFrames();
    const auto recovered = jobs::recover(fixture.context(), RecoveryAction::Finish);
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::OtherServo);
    QVERIFY(fixture.onlyReadsSent());
}

void TestRecover::laterOwnWritesAreKept_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("finish") << int(RecoveryAction::Finish);
    QTest::newRow("undo") << int(RecoveryAction::Undo);
}

/// After the interruption the program itself has written another value to the same servo.
void TestRecover::laterOwnWritesAreKept()
{
    QFETCH(int, action);
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    fixture.tap().onWrite = [&fixture](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 13)
            fixture.cutLink();
    };
    QVERIFY(device::write(fixture.context(), servo, {{utf8("max_temperature"), 60}}, {}));
    fixture.tap().onWrite = nullptr;
    fixture.reconnect(1'000'000);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
    device::Servo again = fixture.servo(1);
    const auto later = device::write(fixture.context(), again, {{utf8("max_temperature"), 65}}, {});
    QVERIFY(later && later->isSuccessful());
    const auto recovered = jobs::recover(fixture.context(), RecoveryAction(action));
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::Replaced);
    QVERIFY(recovered->front().done);
    QVERIFY(fixture.journal().open()->empty());
    QCOMPARE(fixture.raw(1, utf8("max_temperature")), 65);
}

void TestRecover::noiseIsNotAnotherServo()
{
    SimFixture fixture(utf8("sts3215@1"));
    interrupt(fixture);
    fixture.wireConfig().faults.corrupt = 1;
    const auto recovered = jobs::recover(fixture.context(), RecoveryAction::Finish);
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::Unreadable);
    QVERIFY(!recovered->front().done);
    QCOMPARE(recovered->front().error->code, base::ErrorCode::Garbled);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

void TestRecover::factoryResetThatChangedTheId_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("id");
    QTest::newRow("finish") << int(RecoveryAction::Finish) << 1;
    QTest::newRow("undo") << int(RecoveryAction::Undo) << 7;
}

/// Killed while its defaults were restored, which gave it the factory ID as well.
void TestRecover::factoryResetThatChangedTheId()
{
    QFETCH(int, action);
    QFETCH(int, id);
    SimFixture fixture(utf8("sts3215@7"));
    device::Servo servo = fixture.servo(7);
    base::Intent intent;
    intent.kind = base::IntentKind::Restore;
    intent.lockOpened = true;
    intent.servo = servo.identity();
    intent.items = {{utf8("id"), 5, 7, 7}, {utf8("max_temperature"), 13, 60, 60}};
    QVERIFY(fixture.journal().begin(intent));
    fixture.poke(7, utf8("lock"), 0);
    fixture.poke(7, utf8("id"), 1);
    fixture.runFor(std::chrono::milliseconds(50));
    const auto seen = jobs::recover(fixture.context(), RecoveryAction::Preview);
    QVERIFY(seen);
    QCOMPARE(seen->front().before.foundId, 1);
    QCOMPARE(seen->front().before.lockOpen, std::optional<bool>(true));
    const auto recovered = jobs::recover(fixture.context(), RecoveryAction(action));
    QVERIFY(recovered);
    QVERIFY2(recovered->front().done,
             recovered->front().error ? qPrintable(base::errorName(recovered->front().error->code))
                                      : "");
    QVERIFY(fixture.journal().open()->empty());
    QCOMPARE(fixture.raw(id, utf8("lock")), 1);
    QCOMPARE(fixture.raw(id, utf8("max_temperature")),
             RecoveryAction(action) == RecoveryAction::Undo ? 60 : 70);
}

void TestRecover::otherPortIsNotAffected()
{
    SimFixture fixture(utf8("sts3215@1"));
    base::Intent elsewhere;
    elsewhere.servo.port = utf8("/dev/ttyUSB7");
    QVERIFY(fixture.journal().begin(elsewhere));
    QCOMPARE(jobs::recover(fixture.context(), RecoveryAction::Finish)->size(), std::size_t(0));
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

void TestRecover::silentServoStaysOpen()
{
    SimFixture fixture(utf8("sts3215@1"));
    interrupt(fixture);
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    const auto recovered = jobs::recover(fixture.context(), RecoveryAction::Finish);
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::NoReply);
    QVERIFY(!recovered->front().done);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

SERVODESK_GUILESS_TEST(TestRecover)
#include "tst_recover.moc"
