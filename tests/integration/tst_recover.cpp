// SPDX-License-Identifier: GPL-3.0-or-later
// The link is cut at every single byte of an ID change, a rate change, a mode switch and a write of
// five registers. Afterwards, with the cable back, recover must leave no lock open, lose nothing
// and claim nothing that is not so.
#include "device/motion.h"
#include "jobs/change.h"
#include "jobs/recover.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

#include <map>

using device::WriteItem;
using jobs::Finding;
using jobs::RecoverAction;
using support::SimBench;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

enum class Task { SetId, SetBaud, Mode, FiveRegisters };

const std::vector<WriteItem>& fiveRegisters()
{
    static const std::vector<WriteItem> items{{text("min_angle_limit"), 500},
                                              {text("max_angle_limit"), 3500},
                                              {text("max_temperature"), 61},
                                              {text("position_p"), 20},
                                              {text("overload_torque"), 70}};
    return items;
}

base::Result<void> run(SimBench& bench, Task task)
{
    auto servo = device::identify(bench.context(), 1);
    if (!servo)
        return tl::unexpected(servo.error());
    base::Result<device::WriteReport> report;
    switch (task) {
    case Task::SetId:
        report = jobs::changeId(bench.context(), *servo, 9);
        break;
    case Task::SetBaud:
        report = jobs::changeBaud(bench.context(), *servo, 115'200);
        break;
    case Task::Mode:
        report = device::switchMode(bench.context(), *servo, text("step"));
        break;
    case Task::FiveRegisters:
        report = device::write(bench.context(), *servo, fiveRegisters(), {});
        break;
    }
    if (!report)
        return tl::unexpected(report.error());
    if (!report->allGood())
        return base::fail(base::ErrorCode::Refused);
    return {};
}

std::size_t bytesOf(Task task)
{
    SimBench bench(text("sts3215@1"));
    bench.forgetFrames();
    if (!run(bench, task))
        qFatal("the task does not work on a whole line");
    std::size_t bytes = 0;
    for (const base::Bytes& frame : bench.tap().written)
        bytes += frame.size();
    return bytes;
}

using Eprom = std::map<QString, std::int64_t>;

Eprom eprom(SimBench& bench)
{
    return bench.withWire([](sim::VirtualBus& wire) {
        Eprom values;
        sim::VirtualServo& servo = *wire.servos().front();
        for (const catalog::Register& reg : servo.profile().registers) {
            if (reg.eprom())
                values[reg.key] = servo.raw(reg.key);
        }
        return values;
    });
}

bool lockOpen(SimBench& bench)
{
    return bench.withWire(
        [](sim::VirtualBus& wire) { return wire.servos().front()->raw(text("lock")) == 0; });
}

Eprom wanted(Task task)
{
    SimBench bench(text("sts3215@1"));
    if (!run(bench, task))
        qFatal("the task does not work on a whole line");
    return eprom(bench);
}
} // namespace

class TestRecover : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void cutAtEveryByte_data();
    void cutAtEveryByte();
    void lookingWritesNothing();
    void otherServoIsLeftAlone();
    void otherValuesAreLeftAlone();
    void ownLaterWritesStay_data();
    void ownLaterWritesStay();
    void noiseIsNotAnotherServo();
    void defaultsThatMovedTheServo_data();
    void defaultsThatMovedTheServo();
    void otherPortIsNotConcerned();
    void silentServoStaysOpen();
};

void TestRecover::cutAtEveryByte_data()
{
    QTest::addColumn<int>("task");
    QTest::addColumn<int>("action");
    QTest::addColumn<bool>("powerCycle");
    const std::map<const char*, Task> tasks{{"set-id", Task::SetId},
                                            {"set-baud", Task::SetBaud},
                                            {"mode", Task::Mode},
                                            {"five registers", Task::FiveRegisters}};
    for (const auto& [name, task] : tasks) {
        for (const auto action : {RecoverAction::Finish, RecoverAction::Undo}) {
            for (const bool cycle : {false, true}) {
                QTest::addRow("%s, %s%s", name, action == RecoverAction::Finish ? "finish" : "undo",
                              cycle ? ", after a power cycle" : "")
                    << int(task) << int(action) << cycle;
            }
        }
    }
}

void TestRecover::cutAtEveryByte()
{
    QFETCH(int, task);
    QFETCH(int, action);
    QFETCH(bool, powerCycle);
    const auto doing = Task(task);
    const auto wish = RecoverAction(action);
    const Eprom after = wanted(doing);
    const std::size_t length = bytesOf(doing);
    int interrupted = 0;
    for (std::size_t cut = 1; cut < length; ++cut) {
        SimBench bench(text("sts3215@1"));
        const Eprom before = eprom(bench);
        bench.cutAfterHostBytes(cut);
        const auto done = run(bench, doing);
        const auto open = *bench.journal().open();
        QVERIFY2(!done || open.empty(), "claimed done although the journal says otherwise");
        if (powerCycle)
            bench.powerCycle();
        bench.reconnect(1'000'000);
        // Nothing is ever left open without the journal knowing.
        if (lockOpen(bench))
            QVERIFY2(!open.empty(), qPrintable(QString::number(cut)));
        if (open.empty()) {
            const Eprom now = eprom(bench);
            QVERIFY2(now == before || now == after, qPrintable(QString::number(cut)));
            continue;
        }
        ++interrupted;
        const auto recovered = jobs::recover(bench.context(), wish);
        QVERIFY2(recovered, recovered ? "" : qPrintable(base::errorName(recovered.error().code)));
        QCOMPARE(recovered->size(), std::size_t(1));
        QVERIFY2(recovered->front().done,
                 qPrintable(text("cut %1 finding %2 error %3")
                                .arg(cut)
                                .arg(int(recovered->front().before.finding))
                                .arg(recovered->front().error
                                         ? base::errorName(recovered->front().error->code)
                                         : QString())));
        QVERIFY2(!lockOpen(bench), qPrintable(QString::number(cut)));
        QVERIFY2(eprom(bench) == (wish == RecoverAction::Finish ? after : before),
                 qPrintable(QString::number(cut)));
        QVERIFY(bench.journal().open()->empty());
        // What was finished or undone holds after a power-off as well.
        bench.powerCycle();
        QVERIFY(eprom(bench) == (wish == RecoverAction::Finish ? after : before));
    }
    QVERIFY(interrupted > 10);
}

namespace {
/// A five-register write cut in its middle.
void interrupt(SimBench& bench)
{
    bench.tap().onWrite = [&bench](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 21)
            bench.cutLink();
    };
    QVERIFY(!run(bench, Task::FiveRegisters));
    bench.tap().onWrite = nullptr;
    bench.reconnect(1'000'000);
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
    QVERIFY(lockOpen(bench));
}
} // namespace

void TestRecover::lookingWritesNothing()
{
    SimBench bench(text("sts3215@1"));
    interrupt(bench);
    bench.forgetFrames();
    const auto seen = jobs::recover(bench.context(), RecoverAction::Look);
    QVERIFY(seen);
    QCOMPARE(seen->front().before.finding, Finding::Mixed);
    QCOMPARE(seen->front().before.lockOpen, std::optional<bool>(true));
    QVERIFY(!seen->front().done);
    QVERIFY(bench.onlyAsked());
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
}

void TestRecover::otherServoIsLeftAlone()
{
    SimBench bench(text("sts3215@1,sts3250@7"));
    interrupt(bench);
    // Overnight somebody puts another model under this ID.
    bench.withWire([](sim::VirtualBus& wire) {
        wire.servo(1)->poke(text("id"), 20);
        wire.servo(7)->poke(text("id"), 1);
    });
    bench.letTimePass(std::chrono::milliseconds(50));
    bench.forgetFrames();
    for (const auto action : {RecoverAction::Finish, RecoverAction::Undo}) {
        const auto recovered = jobs::recover(bench.context(), action);
        QVERIFY(recovered);
        QCOMPARE(recovered->front().before.finding, Finding::OtherServo);
        QVERIFY(!recovered->front().done);
        QVERIFY(bench.onlyAsked());
    }
}

void TestRecover::otherValuesAreLeftAlone()
{
    SimBench bench(text("sts3215@1"));
    interrupt(bench);
    bench.poke(1, text("max_temperature"), 44); // neither the old value nor the new
    bench.letTimePass(std::chrono::milliseconds(50));
    bench.forgetFrames();
    const auto recovered = jobs::recover(bench.context(), RecoverAction::Finish);
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::OtherServo);
    QVERIFY(bench.onlyAsked());
}

void TestRecover::ownLaterWritesStay_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("finish") << int(RecoverAction::Finish);
    QTest::newRow("undo") << int(RecoverAction::Undo);
}

/// After the interruption the program itself has written another value to the same servo.
void TestRecover::ownLaterWritesStay()
{
    QFETCH(int, action);
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    bench.tap().onWrite = [&bench](const base::Bytes& frame) {
        if (frame[4] == support::Write && frame[5] == 13)
            bench.cutLink();
    };
    QVERIFY(device::write(bench.context(), servo, {{text("max_temperature"), 60}}, {}));
    bench.tap().onWrite = nullptr;
    bench.reconnect(1'000'000);
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
    device::Servo again = bench.servo(1);
    const auto later = device::write(bench.context(), again, {{text("max_temperature"), 65}}, {});
    QVERIFY(later && later->allGood());
    const auto recovered = jobs::recover(bench.context(), RecoverAction(action));
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::Replaced);
    QVERIFY(recovered->front().done);
    QVERIFY(bench.journal().open()->empty());
    QCOMPARE(bench.raw(1, text("max_temperature")), 65);
}

void TestRecover::noiseIsNotAnotherServo()
{
    SimBench bench(text("sts3215@1"));
    interrupt(bench);
    bench.wireConfig().faults.corrupt = 1;
    const auto recovered = jobs::recover(bench.context(), RecoverAction::Finish);
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::Unreadable);
    QVERIFY(!recovered->front().done);
    QCOMPARE(recovered->front().error->code, base::ErrorCode::Garbled);
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
}

void TestRecover::defaultsThatMovedTheServo_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("id");
    QTest::newRow("finish") << int(RecoverAction::Finish) << 1;
    QTest::newRow("undo") << int(RecoverAction::Undo) << 7;
}

/// Killed while its defaults were restored, which gave it the factory ID as well.
void TestRecover::defaultsThatMovedTheServo()
{
    QFETCH(int, action);
    QFETCH(int, id);
    SimBench bench(text("sts3215@7"));
    device::Servo servo = bench.servo(7);
    base::Intent intent;
    intent.kind = base::IntentKind::Restore;
    intent.lockOpened = true;
    intent.servo = servo.identity();
    intent.items = {{text("id"), 5, 7, 7}, {text("max_temperature"), 13, 60, 60}};
    QVERIFY(bench.journal().begin(intent));
    bench.poke(7, text("lock"), 0);
    bench.poke(7, text("id"), 1);
    bench.letTimePass(std::chrono::milliseconds(50));
    const auto seen = jobs::recover(bench.context(), RecoverAction::Look);
    QVERIFY(seen);
    QCOMPARE(seen->front().before.foundId, 1);
    QCOMPARE(seen->front().before.lockOpen, std::optional<bool>(true));
    const auto recovered = jobs::recover(bench.context(), RecoverAction(action));
    QVERIFY(recovered);
    QVERIFY2(recovered->front().done,
             recovered->front().error ? qPrintable(base::errorName(recovered->front().error->code))
                                      : "");
    QVERIFY(bench.journal().open()->empty());
    QCOMPARE(bench.raw(id, text("lock")), 1);
    QCOMPARE(bench.raw(id, text("max_temperature")),
             RecoverAction(action) == RecoverAction::Undo ? 60 : 70);
}

void TestRecover::otherPortIsNotConcerned()
{
    SimBench bench(text("sts3215@1"));
    base::Intent elsewhere;
    elsewhere.servo.port = text("/dev/ttyUSB7");
    QVERIFY(bench.journal().begin(elsewhere));
    QCOMPARE(jobs::recover(bench.context(), RecoverAction::Finish)->size(), std::size_t(0));
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
}

void TestRecover::silentServoStaysOpen()
{
    SimBench bench(text("sts3215@1"));
    interrupt(bench);
    bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    const auto recovered = jobs::recover(bench.context(), RecoverAction::Finish);
    QVERIFY(recovered);
    QCOMPARE(recovered->front().before.finding, Finding::NoAnswer);
    QVERIFY(!recovered->front().done);
    QCOMPARE(bench.journal().open()->size(), std::size_t(1));
}

QTEST_GUILESS_MAIN(TestRecover)
#include "tst_recover.moc"
