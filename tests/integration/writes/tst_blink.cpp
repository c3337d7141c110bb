// SPDX-License-Identifier: GPL-3.0-or-later
// Making one servo recognizable: its LED is really seen to blink, its setting is as before on every
// way out, nothing survives a power-off, and what was interrupted is put back by recovery.
#include "device/reader.h"
#include "jobs/change/blink.h"
#include "jobs/recover/recover.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

using namespace std::chrono_literals;
using base::Protocol;
using jobs::RecoveryAction;
using support::SimFixture;
using support::utf8;

namespace {
bool ledOn(SimFixture& fixture)
{
    return fixture.withBus([](sim::VirtualBus& wire) { return wire.servos().front()->ledOn(); });
}

/// How often the LED changed, sampled whenever the host sends something.
struct LedObserver {
    explicit LedObserver(SimFixture& fixture)
    {
        fixture.tap().onWrite = [this, &fixture](const base::Bytes&) {
            const bool on = ledOn(fixture);
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
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void blinksAndRestoresTheLed_data();
    void blinksAndRestoresTheLed();
    void blinkingNeedsAnLed_data();
    void blinkingNeedsAnLed();
    void nothingIsSavedWithAnOpenLock();
    void stopEndsItAtOnce();
    void stopBeforeStartWritesNothing();
    void linkLostAtEveryByte_data();
    void linkLostAtEveryByte();
    void fullDiskWritesNothing();
};

void TestBlink::blinksAndRestoresTheLed_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<int>("protocol");
    QTest::addColumn<int>("baud");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("before");
    const auto row = [](const char* servo, Protocol protocol, int baud, const char* key,
                        int before) {
        QTest::addRow("%s, %s %d", servo, key, before)
            << utf8(servo) << int(protocol) << baud << utf8(key) << before;
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

void TestBlink::blinksAndRestoresTheLed()
{
    QFETCH(QString, servo);
    QFETCH(int, protocol);
    QFETCH(int, baud);
    QFETCH(QString, key);
    QFETCH(int, before);
    SimFixture fixture(servo, {baud});
    fixture.poke(1, key, before);
    fixture.powerCycle();
    auto one = fixture.servo(1, Protocol(protocol));
    const std::int64_t written = fixture.raw(1, key);
    LedObserver observer(fixture);
    const auto report = jobs::blink(fixture.context(), one);
    QVERIFY(report);
    QCOMPARE(report->key, key);
    QVERIFY(report->blinks >= 3);
    QVERIFY2(observer.changes >= 5, qPrintable(QString::number(observer.changes)));
    QCOMPARE(fixture.raw(1, key), written);
    QVERIFY(!report->stopped);
    QVERIFY(fixture.journal().open()->empty());
    QCOMPARE(fixture.journal().entries()->size(), std::size_t(1));
    fixture.tap().onWrite = nullptr;
    fixture.powerCycle();
    QCOMPARE(fixture.raw(1, key), written);
}

void TestBlink::blinkingNeedsAnLed_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<int>("protocol");
    QTest::addColumn<QString>("why");
    QTest::newRow("Modbus") << utf8("smsmb@1") << int(Protocol::Modbus) << utf8("factory-led");
}

void TestBlink::blinkingNeedsAnLed()
{
    QFETCH(QString, servo);
    QFETCH(int, protocol);
    QFETCH(QString, why);
    SimFixture fixture(servo, {115'200});
    auto one = fixture.servo(1, Protocol(protocol));
    fixture.clearFrames();
    const auto report = jobs::blink(fixture.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, base::ErrorCode::NotSupported);
    QCOMPARE(report.error().detail, why);
    QCOMPARE(fixture.frameCount(), std::size_t(0));
    QVERIFY(fixture.journal().entries()->empty());
}

/// With the lock left open each blink would go into the EPROM.
void TestBlink::nothingIsSavedWithAnOpenLock()
{
    SimFixture fixture(utf8("sts3215@1"));
    auto one = fixture.servo(1);
    fixture.poke(1, utf8("lock"), 0);
    const std::int64_t before = fixture.raw(1, utf8("led_alarm_condition"));
    bool openWhileOff = false;
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (fixture.raw(1, utf8("led_alarm_condition")) != before)
            openWhileOff |= fixture.raw(1, utf8("lock")) == 0;
    };
    QVERIFY(jobs::blink(fixture.context(), one));
    QVERIFY(!openWhileOff);
    QCOMPARE(fixture.notices().front().code, base::NoticeCode::LockFoundOpen);
    QCOMPARE(fixture.raw(1, utf8("lock")), 1);
}

void TestBlink::stopEndsItAtOnce()
{
    SimFixture fixture(utf8("sts3215@1"));
    auto one = fixture.servo(1);
    const std::int64_t before = fixture.raw(1, utf8("led_alarm_condition"));
    const base::Duration start = fixture.clock().now();
    base::Duration asked{};
    const auto report = jobs::blink(fixture.context(), one, 6s, [&](const jobs::Progress&) {
        if (fixture.clock().now() - start < 1s)
            return;
        asked = fixture.clock().now();
        fixture.stop().request();
    });
    QVERIFY(report);
    QVERIFY(report->stopped);
    QVERIFY(fixture.clock().now() - asked < 100ms);
    QCOMPARE(fixture.raw(1, utf8("led_alarm_condition")), before);
    QVERIFY(fixture.journal().open()->empty());
}

void TestBlink::stopBeforeStartWritesNothing()
{
    SimFixture fixture(utf8("sts3215@1"));
    auto one = fixture.servo(1);
    fixture.clearFrames();
    fixture.stop().request();
    const auto report = jobs::blink(fixture.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, base::ErrorCode::Stopped);
    QVERIFY(fixture.onlyReadsSent());
}

void TestBlink::linkLostAtEveryByte_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("finish") << int(RecoveryAction::Finish);
    QTest::newRow("undo") << int(RecoveryAction::Undo);
}

/// Both finishing and undoing restore the old value.
void TestBlink::linkLostAtEveryByte()
{
    QFETCH(int, action);
    constexpr auto time = 1s;
    SimFixture whole(utf8("sts3215@1"));
    whole.clearFrames();
    {
        auto one = device::identify(whole.context(), 1);
        QVERIFY(one && jobs::blink(whole.context(), *one, time));
    }
    std::size_t length = 0;
    for (const base::Bytes& frame : whole.tap().written)
        length += frame.size();
    int interrupted = 0;
    for (std::size_t cut = 1; cut < length; ++cut) {
        SimFixture fixture(utf8("sts3215@1"));
        const std::int64_t before = fixture.raw(1, utf8("led_alarm_condition"));
        fixture.cutAfterHostBytes(cut);
        auto one = device::identify(fixture.context(), 1);
        if (one)
            QVERIFY(!jobs::blink(fixture.context(), *one, time));
        fixture.reconnect(1'000'000);
        const auto open = *fixture.journal().open();
        if (open.empty()) {
            QCOMPARE(fixture.raw(1, utf8("led_alarm_condition")), before);
            continue;
        }
        ++interrupted;
        QCOMPARE(open.front().kind, base::IntentKind::Identify);
        const auto settled = jobs::recover(fixture.context(), RecoveryAction(action));
        QVERIFY(settled && settled->size() == 1);
        QVERIFY2(settled->front().done, qPrintable(QString::number(cut)));
        QCOMPARE(fixture.raw(1, utf8("led_alarm_condition")), before);
        QVERIFY(fixture.journal().open()->empty());
    }
    QVERIFY(interrupted > 10);
}

void TestBlink::fullDiskWritesNothing()
{
    SimFixture fixture(utf8("sts3215@1"));
    auto one = fixture.servo(1);
    fixture.journal().setError(base::ErrorCode::DiskFull);
    fixture.clearFrames();
    const auto report = jobs::blink(fixture.context(), one);
    QVERIFY(!report);
    QCOMPARE(report.error().code, base::ErrorCode::DiskFull);
    QVERIFY(fixture.onlyReadsSent());
}

SERVODESK_GUILESS_TEST(TestBlink)
#include "tst_blink.moc"
