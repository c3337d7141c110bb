// SPDX-License-Identifier: GPL-3.0-or-later
// Making one servo recognisable: its LED is really seen to blink, its setting is as before on every
// way out, nothing survives a power-off, and what was interrupted is put back by recovery.
#include "device/reader.h"
#include "jobs/blink.h"
#include "jobs/recover.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

using namespace std::chrono_literals;
using base::Protocol;
using jobs::RecoverAction;
using support::SimBench;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

bool ledOn(SimBench& bench)
{
    return bench.withWire([](sim::VirtualBus& wire) { return wire.servos().front()->ledOn(); });
}

/// How often the LED was seen to change, looking whenever the host says something.
struct Witness {
    explicit Witness(SimBench& bench)
    {
        bench.tap().onWrite = [this, &bench](const base::Bytes&) {
            const bool on = ledOn(bench);
            changes += known && on != was ? 1 : 0;
            known = true;
            was = on;
        };
    }
    bool known = false;
    bool was = false;
    int changes = 0;
};
} // namespace

class TestBlink : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void blinksAndPutsBack_data();
    void blinksAndPutsBack();
    void notWithout_data();
    void notWithout();
    void nothingIsKeptWhereALockIsOpen();
    void stopEndsItAtOnce();
    void stopBeforehandWritesNothing();
    void cutAtEveryByte_data();
    void cutAtEveryByte();
    void fullDiskWritesNothing();
};

void TestBlink::blinksAndPutsBack_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<int>("protocol");
    QTest::addColumn<int>("baud");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("before");
    const auto row = [](const char* servo, Protocol protocol, int baud, const char* key,
                        int before) {
        QTest::addRow("%s, %s %d", servo, key, before)
            << text(servo) << int(protocol) << baud << text(key) << before;
    };
    row("sts3215@1", Protocol::Feetech, 1'000'000, "led_alarm_condition", 45);
    row("sts3215@1", Protocol::Feetech, 1'000'000, "led_alarm_condition", 0);
    row("sm40blhv@1", Protocol::Feetech, 115'200, "led_alarm_condition", 45);
    row("scs15@1", Protocol::Feetech, 1'000'000, "led_alarm_condition", 37);
    row("scs15-2@1", Protocol::Feetech, 1'000'000, "led_alarm_condition", 37);
    row("hls3606@1", Protocol::Feetech, 1'000'000, "led_alarm_condition", 15);
    row("sm60-360m@1", Protocol::Feetech, 115'200, "led_alarm_condition", 37);
    row("lx16a@1", Protocol::Lx, 115'200, "led", 0);
    row("lx16a@1", Protocol::Lx, 115'200, "led", 1);
}

void TestBlink::blinksAndPutsBack()
{
    QFETCH(QString, servo);
    QFETCH(int, protocol);
    QFETCH(int, baud);
    QFETCH(QString, key);
    QFETCH(int, before);
    SimBench bench(servo, {baud});
    bench.poke(1, key, before);
    bench.powerCycle();
    auto one = bench.servo(1, Protocol(protocol));
    const std::int64_t written = bench.raw(1, key);
    Witness witness(bench);
    const auto report = jobs::blink(bench.context(), one);
    QVERIFY(report);
    QCOMPARE(report->key, key);
    QVERIFY(report->blinks >= 3);
    QVERIFY2(witness.changes >= 5, qPrintable(QString::number(witness.changes)));
    QCOMPARE(bench.raw(1, key), written);
    QVERIFY(!report->stopped);
    QVERIFY(bench.journal().open()->empty());
    QCOMPARE(bench.journal().entries()->size(), std::size_t(1));
    bench.tap().onWrite = nullptr;
    bench.powerCycle();
    QCOMPARE(bench.raw(1, key), written);
}

void TestBlink::notWithout_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<int>("protocol");
    QTest::addColumn<QString>("why");
    QTest::newRow("Modbus") << text("smsmb@1") << int(Protocol::Modbus) << text("factory-led");
}

void TestBlink::notWithout()
{
    QFETCH(QString, servo);
    QFETCH(int, protocol);
    QFETCH(QString, why);
    SimBench bench(servo, {115'200});
    auto one = bench.servo(1, Protocol(protocol));
    bench.forgetFrames();
    const auto report = jobs::blink(bench.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, base::ErrorCode::NotSupported);
    QCOMPARE(report.error().detail, why);
    QCOMPARE(bench.frameCount(), std::size_t(0));
    QVERIFY(bench.journal().entries()->empty());
}

/// With the lock left open each blink would go into the EPROM.
void TestBlink::nothingIsKeptWhereALockIsOpen()
{
    SimBench bench(text("sts3215@1"));
    auto one = bench.servo(1);
    bench.poke(1, text("lock"), 0);
    const std::int64_t before = bench.raw(1, text("led_alarm_condition"));
    bool openWhileOff = false;
    bench.tap().onWrite = [&](const base::Bytes&) {
        if (bench.raw(1, text("led_alarm_condition")) != before)
            openWhileOff |= bench.raw(1, text("lock")) == 0;
    };
    QVERIFY(jobs::blink(bench.context(), one));
    QVERIFY(!openWhileOff);
    QCOMPARE(bench.notices().front().code, base::NoticeCode::LockFoundOpen);
    QCOMPARE(bench.raw(1, text("lock")), 1);
}

void TestBlink::stopEndsItAtOnce()
{
    SimBench bench(text("sts3215@1"));
    auto one = bench.servo(1);
    const std::int64_t before = bench.raw(1, text("led_alarm_condition"));
    const base::Duration start = bench.clock().now();
    base::Duration asked{};
    const auto report = jobs::blink(bench.context(), one, 6s, [&](const jobs::Progress&) {
        if (bench.clock().now() - start < 1s)
            return;
        asked = bench.clock().now();
        bench.stop().request();
    });
    QVERIFY(report);
    QVERIFY(report->stopped);
    QVERIFY(bench.clock().now() - asked < 100ms);
    QCOMPARE(bench.raw(1, text("led_alarm_condition")), before);
    QVERIFY(bench.journal().open()->empty());
}

void TestBlink::stopBeforehandWritesNothing()
{
    SimBench bench(text("sts3215@1"));
    auto one = bench.servo(1);
    bench.forgetFrames();
    bench.stop().request();
    const auto report = jobs::blink(bench.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, base::ErrorCode::Stopped);
    QVERIFY(bench.onlyAsked());
}

void TestBlink::cutAtEveryByte_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("finish") << int(RecoverAction::Finish);
    QTest::newRow("undo") << int(RecoverAction::Undo);
}

/// Whichever way it is settled, the old value is what everybody wants.
void TestBlink::cutAtEveryByte()
{
    QFETCH(int, action);
    constexpr auto time = 1s;
    SimBench whole(text("sts3215@1"));
    whole.forgetFrames();
    {
        auto one = device::identify(whole.context(), 1);
        QVERIFY(one && jobs::blink(whole.context(), *one, time));
    }
    std::size_t length = 0;
    for (const base::Bytes& frame : whole.tap().written)
        length += frame.size();
    int interrupted = 0;
    for (std::size_t cut = 1; cut < length; ++cut) {
        SimBench bench(text("sts3215@1"));
        const std::int64_t before = bench.raw(1, text("led_alarm_condition"));
        bench.cutAfterHostBytes(cut);
        auto one = device::identify(bench.context(), 1);
        if (one)
            QVERIFY(!jobs::blink(bench.context(), *one, time));
        bench.reconnect(1'000'000);
        const auto open = *bench.journal().open();
        if (open.empty()) {
            QCOMPARE(bench.raw(1, text("led_alarm_condition")), before);
            continue;
        }
        ++interrupted;
        QCOMPARE(open.front().kind, base::IntentKind::Identify);
        const auto settled = jobs::recover(bench.context(), RecoverAction(action));
        QVERIFY(settled && settled->size() == 1);
        QVERIFY2(settled->front().done, qPrintable(QString::number(cut)));
        QCOMPARE(bench.raw(1, text("led_alarm_condition")), before);
        QVERIFY(bench.journal().open()->empty());
    }
    QVERIFY(interrupted > 10);
}

void TestBlink::fullDiskWritesNothing()
{
    SimBench bench(text("sts3215@1"));
    auto one = bench.servo(1);
    bench.journal().failWith(base::ErrorCode::DiskFull);
    bench.forgetFrames();
    const auto report = jobs::blink(bench.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, base::ErrorCode::DiskFull);
    QVERIFY(bench.onlyAsked());
}

QTEST_GUILESS_MAIN(TestBlink)
#include "tst_blink.moc"
