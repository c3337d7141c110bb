// SPDX-License-Identifier: GPL-3.0-or-later
// Settings for the length of a job, against simulated servos: they act, they go back on every way
// out, the EPROM never sees them, and where they could not be put back the journal knows, and
// recovery puts them back another day. The sweep test in a mode that is not the servo's own.
#include "device/motion/motion.h"
#include "device/motion/stop_frames.h"
#include "device/temporary_values.h"
#include "jobs/recover/recover.h"
#include "jobs/sweep/sweep.h"
#include "jobs/temporary_settings.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using jobs::Finding;
using jobs::RecoveryAction;
using jobs::TemporarySettings;
using results::SweepEnd;
using support::SimFixture;
using support::utf8;
using namespace std::chrono_literals;

namespace {
const std::vector<device::WriteItem>& gains()
{
    static const std::vector<device::WriteItem> items{{utf8("position_p"), 20},
                                                      {utf8("position_i"), 1}};
    return items;
}

base::Bytes eprom(SimFixture& fixture, int id = 1)
{
    return fixture.withBus([id](sim::VirtualBus& wire) { return wire.servo(id)->epromImage(); });
}

base::Result<results::SweepRun> sweep(SimFixture& fixture, std::vector<device::Servo>& servos,
                                      const jobs::SweepCallbacks& watch = {},
                                      const char* to = "1500", const char* from = "1000")
{
    jobs::SweepRequest order;
    order.spec.range = {utf8(from), utf8(to)};
    order.spec.pace = results::SweepPace::Dwell;
    order.spec.pause = 200ms;
    order.spec.cycles = 2;
    order.switchMode = true;
    order.limits.resize(servos.size());
    return jobs::sweep(fixture.context(), servos, order, watch);
}

int countOpenIntents(SimFixture& fixture)
{
    return int(fixture.journal().open()->size());
}

/// A servo that stands in this mode, with torque off, as switching there leaves it.
void enterModeDirectly(SimFixture& fixture, const char* mode, base::Protocol protocol)
{
    device::Servo servo = fixture.servo(1, protocol);
    const auto report = device::switchMode(fixture.context(), servo, utf8(mode));
    QVERIFY(report && report->isSuccessful());
    fixture.notices().clear();
}
} // namespace

class TestTemporaryWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void gainsTakeEffectAndAreRestored();
    void anOpenLockIsClosedFirst();
    void matchingValuesAreNotWritten();
    void permanentRegistersAreRefused();
    void aRefusalLeavesNothingBehind();
    void aFullDiskPreventsIt();
    void aStopStillRestoresThem();
    void gainsAreRestoredAfterAnEmergencyStop();
    void aLostLinkLeavesTheIntentOpen_data();
    void aLostLinkLeavesTheIntentOpen();
    void aPowerCycleResetsThem();
    void theSweepSwitchesTheMode_data();
    void theSweepSwitchesTheMode();
    void theSweepAlwaysRestoresTheMode_data();
    void theSweepAlwaysRestoresTheMode();
    void rememberedLimitsAreUnchanged();
    void anUnrestoredModeIsFound_data();
    void anUnrestoredModeIsFound();
    void twoServosInTwoModes();
};

void TestTemporaryWrites::gainsTakeEffectAndAreRestored()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    const auto before = eprom(fixture);
    const auto p = fixture.raw(1, utf8("position_p"));
    {
        const auto trial = TemporarySettings::set(fixture.context(), servo, gains());
        QVERIFY(trial);
        QCOMPARE((*trial)->items().size(), std::size_t(2));
        QCOMPARE(fixture.raw(1, utf8("position_p")), 20);
        QCOMPARE(fixture.raw(1, utf8("position_i")), 1);
        QCOMPARE(countOpenIntents(fixture), 1);
        QCOMPARE(fixture.journal().open()->front().kind, base::IntentKind::Trial);
        QVERIFY(fixture.journal().open()->front().temporary);
        QVERIFY((*trial)->revert());
        QCOMPARE(fixture.raw(1, utf8("position_p")), p);
        QCOMPARE(countOpenIntents(fixture), 0);
        fixture.clearFrames();
    }
    QCOMPARE(fixture.frameCount(), std::size_t(0)); // once is enough
    QVERIFY(before == eprom(fixture));
    QCOMPARE(fixture.journal().entries()->size(), std::size_t(1));
    QCOMPARE(fixture.journal().entries()->front().end->outcome, utf8("undone"));
}

void TestTemporaryWrites::anOpenLockIsClosedFirst()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("lock"), 0);
    device::Servo servo = fixture.servo(1);
    const auto before = eprom(fixture);
    {
        const auto trial = TemporarySettings::set(fixture.context(), servo, gains());
        QVERIFY(trial);
        QCOMPARE(fixture.raw(1, utf8("lock")), 1);
        QCOMPARE(fixture.raw(1, utf8("position_p")), 20);
    }
    QVERIFY(fixture.hasNotice(device::NoticeCode::LockFoundOpen));
    QVERIFY(before == eprom(fixture));
    QCOMPARE(countOpenIntents(fixture), 0);
}

void TestTemporaryWrites::matchingValuesAreNotWritten()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    fixture.clearFrames();
    const auto trial = TemporarySettings::set(
        fixture.context(), servo, {{utf8("position_p"), fixture.raw(1, utf8("position_p"))}});
    QVERIFY(trial);
    QVERIFY((*trial)->items().empty());
    QVERIFY(fixture.onlyReadsSent());
    QVERIFY(fixture.journal().entries()->empty());
}

void TestTemporaryWrites::permanentRegistersAreRefused()
{
    SimFixture fixture(utf8("lx16a@1"), {.baud = 115'200});
    device::Servo servo = fixture.servo(1, base::Protocol::Lx);
    const auto was = fixture.raw(1, utf8("temp_limit"));
    fixture.clearFrames();
    const auto trial =
        TemporarySettings::set(fixture.context(), servo, {{utf8("temp_limit"), was - 5}});
    QVERIFY(!trial);
    QCOMPARE(trial.error().code, ErrorCode::NotSupported);
    QCOMPARE(trial.error().detail, utf8("always-kept"));
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(countOpenIntents(fixture), 0);
}

/// Neither in the servo nor in the report of its values.
void TestTemporaryWrites::aRefusalLeavesNothingBehind()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    const auto p = fixture.raw(1, utf8("position_p"));
    fixture.clearFrames();
    QVERIFY(!TemporarySettings::set(fixture.context(), servo, {{utf8("position_p"), 9999}}));
    QCOMPARE(fixture.frames(support::Write), 0);
    QCOMPARE(fixture.raw(1, utf8("position_p")), p);
    QCOMPARE(countOpenIntents(fixture), 0);
    const auto entries = fixture.journal().entries();
    QCOMPARE(entries->size(), std::size_t(1));
    const base::IntentResult& end = *entries->front().end;
    QCOMPARE(end.outcome, utf8("failed"));
    QCOMPARE(end.items.size(), std::size_t(1));
    QCOMPARE(end.items.front().key, utf8("position_p"));
    QCOMPARE(end.items.front().outcome, utf8("not-sent"));
    QVERIFY(device::temporaryValues(fixture.journal(), servo)->empty());
}

void TestTemporaryWrites::aFullDiskPreventsIt()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    fixture.journal().setError(ErrorCode::DiskFull);
    fixture.clearFrames();
    const auto trial = TemporarySettings::set(fixture.context(), servo, gains());
    QVERIFY(!trial);
    QCOMPARE(trial.error().code, ErrorCode::DiskFull);
    QVERIFY(fixture.onlyReadsSent());
}

void TestTemporaryWrites::aStopStillRestoresThem()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    const auto p = fixture.raw(1, utf8("position_p"));
    const auto trial = TemporarySettings::set(fixture.context(), servo, gains());
    QVERIFY(trial);
    fixture.stop().request();
    QVERIFY((*trial)->revert());
    QCOMPARE(fixture.raw(1, utf8("position_p")), p);
    QCOMPARE(countOpenIntents(fixture), 0);
}

void TestTemporaryWrites::gainsAreRestoredAfterAnEmergencyStop()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    fixture.bus().setStopFrames(device::stopFrames({base::Protocol::Feetech}, servos));
    const auto p = fixture.raw(1, utf8("position_p"));
    const auto trial = TemporarySettings::set(fixture.context(), servos[0], gains());
    QVERIFY(trial);
    QVERIFY(device::setTorque(fixture.context(), servos[0], device::Torque::On));
    fixture.bus().emergency();
    QVERIFY((*trial)->revert());
    QCOMPARE(fixture.raw(1, utf8("position_p")), p);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0); // nothing turned torque on
    QCOMPARE(countOpenIntents(fixture), 0);
}

void TestTemporaryWrites::aLostLinkLeavesTheIntentOpen_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("undo") << int(RecoveryAction::Undo);
    QTest::newRow("finish means the same") << int(RecoveryAction::Finish);
}

void TestTemporaryWrites::aLostLinkLeavesTheIntentOpen()
{
    QFETCH(int, action);
    SimFixture fixture(utf8("sts3215@1"));
    const auto before = eprom(fixture);
    const auto p = fixture.raw(1, utf8("position_p"));
    {
        device::Servo servo = fixture.servo(1);
        const auto trial = TemporarySettings::set(fixture.context(), servo, gains());
        QVERIFY(trial);
        fixture.cutLink();
        const auto back = (*trial)->revert();
        QVERIFY(!back);
        QCOMPARE(back.error().code, ErrorCode::LinkLost);
        QVERIFY(fixture.hasNotice(device::NoticeCode::SettingNotRestored));
    }
    QCOMPARE(countOpenIntents(fixture), 1);
    fixture.reconnect(1'000'000);
    const auto preview = jobs::recover(fixture.context(), RecoveryAction::Preview);
    QVERIFY(preview);
    QCOMPARE(preview->size(), std::size_t(1));
    QCOMPARE(preview->front().before.finding, Finding::AllNew);
    QCOMPARE(fixture.raw(1, utf8("position_p")), 20);
    const auto settled = jobs::recover(fixture.context(), RecoveryAction(action));
    QVERIFY(settled && settled->front().done);
    QCOMPARE(fixture.raw(1, utf8("position_p")), p);
    QCOMPARE(fixture.raw(1, utf8("position_i")), 0);
    QCOMPARE(countOpenIntents(fixture), 0);
    QVERIFY(before == eprom(fixture));
}

void TestTemporaryWrites::aPowerCycleResetsThem()
{
    SimFixture fixture(utf8("sts3215@1"));
    const auto p = fixture.raw(1, utf8("position_p"));
    {
        device::Servo servo = fixture.servo(1);
        const auto trial = TemporarySettings::set(fixture.context(), servo, gains());
        QVERIFY(trial);
        fixture.cutLink();
    }
    fixture.powerCycle();
    fixture.reconnect(1'000'000);
    QCOMPARE(fixture.raw(1, utf8("position_p")), p);
    const auto preview = jobs::recover(fixture.context(), RecoveryAction::Preview);
    QVERIFY(preview);
    QCOMPARE(preview->front().before.finding, Finding::AllOld);
    const auto settled = jobs::recover(fixture.context(), RecoveryAction::Undo);
    QVERIFY(settled && settled->front().done);
    QCOMPARE(fixture.raw(1, utf8("position_p")), p);
}

void TestTemporaryWrites::theSweepSwitchesTheMode_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::addColumn<int>("protocol");
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    const int feetech = int(base::Protocol::Feetech);
    const auto row = [&](const char* name, const char* servo, const char* mode, int protocol,
                         const char* from, const char* to) {
        QTest::newRow(name) << utf8(servo) << utf8(mode) << protocol << utf8(from) << utf8(to);
    };
    row("STS wheel", "sts3215@1", "speed", feetech, "1000", "1500");
    row("STS PWM", "sts3215@1", "pwm", feetech, "1000", "1500");
    row("STS steps, limits 0", "sts3215@1", "step", feetech, "1000", "1500");
    row("SCS motor, limits 0", "scs15@1:1000000", "motor", feetech, "300", "500");
    row("HLS current", "hls3606@1", "current", feetech, "1000", "1500");
    row("SMCL wheel", "sm60-360m@1:1000000", "speed", feetech, "1000", "1500");
    row("LX motor", "lx16a@1:1000000", "motor", int(base::Protocol::Lx), "300", "500");
}

void TestTemporaryWrites::theSweepSwitchesTheMode()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    QFETCH(int, protocol);
    QFETCH(QString, from);
    QFETCH(QString, to);
    const auto language = base::Protocol(protocol);
    const bool lx = language == base::Protocol::Lx;
    SimFixture fixture(servo.section(QLatin1Char(':'), 0, 0),
                       lx ? support::SimFixtureOptions{.baud = 115'200}
                          : support::SimFixtureOptions{.baud = 1'000'000, .servoBaud = 1'000'000});
    enterModeDirectly(fixture, mode.toLatin1().constData(), language);
    const auto before = eprom(fixture);
    std::vector<device::Servo> servos{fixture.servo(1, language)};
    const std::size_t intents = fixture.journal().entries()->size();
    const auto done =
        sweep(fixture, servos, {}, to.toLatin1().constData(), from.toLatin1().constData());
    QVERIFY2(done, done ? ""
                        : qPrintable(base::errorName(done.error().code) + QLatin1Char(' ') +
                                     done.error().detail + done.error().registerKey));
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->servos.at(0).legs.size(), std::size_t(4));
    for (const results::SweepLeg& leg : done->servos.at(0).legs)
        QVERIFY(!leg.missed);
    device::Servo after = fixture.servo(1, language);
    QCOMPARE(after.mode()->key, mode);
    QVERIFY(before == eprom(fixture));
    QCOMPARE(fixture.raw(1, lx ? utf8("load") : utf8("torque_switch")), 0);
    QCOMPARE(countOpenIntents(fixture), 0);
    QCOMPARE(fixture.journal().entries()->size(), intents + 1);
    // The report shows the servo's own settings.
    for (const snapshot::SnapshotRegister& reg : done->servos.at(0).parameters.registers) {
        const catalog::Register* own = after.profile->find(reg.key);
        if (own != nullptr && own->role == catalog::Role::OperatingMode)
            QCOMPARE(reg.raw, after.raw(*own).value());
    }
    // Switched on, it stands: the command of its mode is zero.
    const auto place = [&] {
        return fixture.withBus([](sim::VirtualBus& wire) { return wire.servo(1)->shaftDegrees(); });
    };
    if (mode != QLatin1StringView("step")) {
        QVERIFY(device::setTorque(fixture.context(), after, device::Torque::On));
        fixture.runFor(500ms);
        const double rests = place();
        fixture.runFor(2s);
        QVERIFY(std::abs(place() - rests) < 2);
    }
}

void TestTemporaryWrites::theSweepAlwaysRestoresTheMode_data()
{
    QTest::addColumn<QString>("end");
    for (const char* end : {"stopped", "alarm", "jammed", "bad range"})
        QTest::newRow(end) << utf8(end);
}

void TestTemporaryWrites::theSweepAlwaysRestoresTheMode()
{
    QFETCH(QString, end);
    SimFixture fixture(utf8("sts3215@1"));
    enterModeDirectly(fixture, "speed", base::Protocol::Feetech);
    const auto before = eprom(fixture);
    std::vector<device::Servo> servos{fixture.servo(1)};
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 1 && end == QLatin1StringView("stopped"))
            fixture.stop().request();
        if (leg.number == 1 && end == QLatin1StringView("alarm"))
            fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->injectStatus(4); });
    };
    if (end == QLatin1StringView("jammed")) {
        fixture.withBus([](sim::VirtualBus& wire) {
            wire.servo(1)->load().stopLow = 2000.0 / 4096 * 2 * M_PI;
        });
    }
    const bool badRange = end == QLatin1StringView("bad range");
    const auto done = sweep(fixture, servos, watch, badRange ? "5000" : "1500");
    QCOMPARE(done.has_value(), !badRange);
    QCOMPARE(fixture.raw(1, utf8("operating_mode")), 1);
    QCOMPARE(fixture.raw(1, utf8("goal_speed")), 0);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(countOpenIntents(fixture), 0);
    QVERIFY(before == eprom(fixture));
}

/// The limits of a servo during a test are not those saved for its way back from motor mode.
void TestTemporaryWrites::rememberedLimitsAreUnchanged()
{
    SimFixture fixture(utf8("scs15@1"), {.baud = 1'000'000, .servoBaud = 1'000'000});
    fixture.poke(1, utf8("min_angle_limit"), 0);
    fixture.poke(1, utf8("max_angle_limit"), 0);
    std::vector<device::Servo> servos{fixture.servo(1)};
    const auto identity = servos[0].identity();
    QVERIFY(sweep(fixture, servos, {}, "500", "300"));
    QCOMPARE(fixture.raw(1, utf8("max_angle_limit")), 0);
    QVERIFY(!fixture.journal().servoValues(identity, utf8("limits")).value());
    QVERIFY(fixture.hasNotice(device::NoticeCode::LimitsSetToDefault));
    QVERIFY(!fixture.hasNotice(device::NoticeCode::LimitsSaved));
}

void TestTemporaryWrites::anUnrestoredModeIsFound_data()
{
    QTest::addColumn<QString>("how");
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::newRow("lost link, STS") << utf8("link") << utf8("sts3215@1") << utf8("speed");
    QTest::newRow("lost link, limits") << utf8("link") << utf8("sts3215@1") << utf8("step");
    QTest::newRow("lost link, LX") << utf8("link") << utf8("lx16a@1") << utf8("motor");
    QTest::newRow("emergency stop") << utf8("emergency") << utf8("sts3215@1") << utf8("speed");
}

void TestTemporaryWrites::anUnrestoredModeIsFound()
{
    QFETCH(QString, how);
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    const bool lx = servo.startsWith(QLatin1StringView("lx"));
    const auto language = lx ? base::Protocol::Lx : base::Protocol::Feetech;
    const int baud = lx ? 115'200 : 1'000'000;
    SimFixture fixture(servo, {.baud = baud});
    enterModeDirectly(fixture, mode.toLatin1().constData(), language);
    const auto before = eprom(fixture);
    const bool emergency = how == QLatin1StringView("emergency");
    {
        std::vector<device::Servo> servos{fixture.servo(1, language)};
        fixture.bus().setStopFrames(device::stopFrames({language}, servos));
        jobs::SweepCallbacks watch;
        watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
            if (leg.number == 2)
                emergency ? fixture.bus().emergency() : fixture.cutLink();
        };
        const auto done = sweep(fixture, servos, watch, lx ? "500" : "1500", lx ? "300" : "1000");
        QVERIFY(done);
        QCOMPARE(done->end, emergency ? SweepEnd::Emergency : SweepEnd::LinkLost);
        QVERIFY(fixture.hasNotice(device::NoticeCode::SettingNotRestored));
    }
    QCOMPARE(countOpenIntents(fixture), 1);
    QVERIFY(before == eprom(fixture));
    if (emergency)
        QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    fixture.reconnect(baud);
    const auto found = jobs::recover(fixture.context(), RecoveryAction::Preview);
    QVERIFY(found);
    QCOMPARE(found->front().before.finding, Finding::AllNew);
    const auto settled = jobs::recover(fixture.context(), RecoveryAction::Undo);
    QVERIFY(settled);
    QVERIFY2(settled->front().done,
             settled->front().error ? qPrintable(settled->front().error->detail) : "");
    device::Servo after = fixture.servo(1, language);
    QCOMPARE(after.mode()->key, mode);
    QCOMPARE(fixture.raw(1, lx ? utf8("load") : utf8("torque_switch")), 0);
    QCOMPARE(countOpenIntents(fixture), 0);
    QVERIFY(before == eprom(fixture));
}

void TestTemporaryWrites::twoServosInTwoModes()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    enterModeDirectly(fixture, "speed", base::Protocol::Feetech);
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    const auto done = sweep(fixture, servos);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(fixture.raw(1, utf8("operating_mode")), 1);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(2, utf8("operating_mode")), 0);
    QCOMPARE(fixture.raw(2, utf8("torque_switch")), 1); // it holds, as it would alone
}

SERVODESK_GUILESS_TEST(TestTemporaryWrites)
#include "tst_temporary_writes.moc"
