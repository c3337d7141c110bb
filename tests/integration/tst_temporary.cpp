// SPDX-License-Identifier: GPL-3.0-or-later
// Settings for the length of a job, against simulated servos: they act, they go back on every way
// out, the EPROM never sees them, and where they could not be put back the journal knows, and
// recovery puts them back another day. The sweep test in a mode that is not the servo's own.
#include "device/motion.h"
#include "device/stop_frames.h"
#include "device/temporary_values.h"
#include "jobs/recover.h"
#include "jobs/sweep.h"
#include "jobs/temporary.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using jobs::Finding;
using jobs::RecoverAction;
using jobs::TemporarySettings;
using record::SweepEnd;
using support::SimBench;
using namespace std::chrono_literals;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

const std::vector<device::WriteItem>& gains()
{
    static const std::vector<device::WriteItem> items{{text("position_p"), 20},
                                                      {text("position_i"), 1}};
    return items;
}

base::Bytes eprom(SimBench& bench, int id = 1)
{
    return bench.withWire([id](sim::VirtualBus& wire) { return wire.servo(id)->epromImage(); });
}

base::Result<record::SweepRun> sweep(SimBench& bench, std::vector<device::Servo>& servos,
                                     const jobs::SweepWatch& watch = {}, const char* to = "1500",
                                     const char* from = "1000")
{
    jobs::SweepOrder order;
    order.spec.range = {text(from), text(to)};
    order.spec.pace = record::SweepPace::Dwell;
    order.spec.pause = 200ms;
    order.spec.cycles = 2;
    order.switchMode = true;
    order.limits.resize(servos.size());
    return jobs::sweep(bench.context(), servos, order, watch);
}

int openIntents(SimBench& bench)
{
    return int(bench.journal().open()->size());
}

bool noted(SimBench& bench, device::NoticeCode code)
{
    return std::any_of(bench.notices().begin(), bench.notices().end(),
                       [code](const device::Notice& notice) { return notice.code == code; });
}

/// A servo that stands in this mode, with torque off, as switching there leaves it.
void bringInto(SimBench& bench, const char* mode, base::Protocol protocol)
{
    device::Servo servo = bench.servo(1, protocol);
    const auto report = device::switchMode(bench.context(), servo, text(mode));
    QVERIFY(report && report->allGood());
    bench.notices().clear();
}
} // namespace

class TestTemporary : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void gainsActAndGoBack();
    void anOpenLockIsClosedFirst();
    void whatIsSoAlreadyIsNotWritten();
    void whatIsAlwaysKeptIsRefused();
    void whatIsRefusedLeavesNothingBehind();
    void aFullDiskForbidsIt();
    void stopDoesNotKeepThemFromGoingBack();
    void gainsGoBackAfterAnEmergencyStop();
    void aLostLinkLeavesTheIntentOpen_data();
    void aLostLinkLeavesTheIntentOpen();
    void aPowerCycleForgetsThem();
    void theSweepSwitchesTheMode_data();
    void theSweepSwitchesTheMode();
    void theSweepPutsTheModeBackHoweverItEnds_data();
    void theSweepPutsTheModeBackHoweverItEnds();
    void rememberedLimitsStayWhatTheyWere();
    void aModeThatIsLeftBehindIsFound_data();
    void aModeThatIsLeftBehindIsFound();
    void twoServosInTwoModes();
};

void TestTemporary::gainsActAndGoBack()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    const auto before = eprom(bench);
    const auto p = bench.raw(1, text("position_p"));
    {
        const auto trial = TemporarySettings::set(bench.context(), servo, gains());
        QVERIFY(trial);
        QCOMPARE((*trial)->items().size(), std::size_t(2));
        QCOMPARE(bench.raw(1, text("position_p")), 20);
        QCOMPARE(bench.raw(1, text("position_i")), 1);
        QCOMPARE(openIntents(bench), 1);
        QCOMPARE(bench.journal().open()->front().kind, base::IntentKind::Trial);
        QVERIFY(bench.journal().open()->front().temporary);
        QVERIFY((*trial)->putBack());
        QCOMPARE(bench.raw(1, text("position_p")), p);
        QCOMPARE(openIntents(bench), 0);
        bench.forgetFrames();
    }
    QCOMPARE(bench.frameCount(), std::size_t(0)); // once is enough
    QVERIFY(before == eprom(bench));
    QCOMPARE(bench.journal().entries()->size(), std::size_t(1));
    QCOMPARE(bench.journal().entries()->front().end->outcome, text("undone"));
}

void TestTemporary::anOpenLockIsClosedFirst()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("lock"), 0);
    device::Servo servo = bench.servo(1);
    const auto before = eprom(bench);
    {
        const auto trial = TemporarySettings::set(bench.context(), servo, gains());
        QVERIFY(trial);
        QCOMPARE(bench.raw(1, text("lock")), 1);
        QCOMPARE(bench.raw(1, text("position_p")), 20);
    }
    QVERIFY(noted(bench, device::NoticeCode::LockFoundOpen));
    QVERIFY(before == eprom(bench));
    QCOMPARE(openIntents(bench), 0);
}

void TestTemporary::whatIsSoAlreadyIsNotWritten()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    bench.forgetFrames();
    const auto trial = TemporarySettings::set(
        bench.context(), servo, {{text("position_p"), bench.raw(1, text("position_p"))}});
    QVERIFY(trial);
    QVERIFY((*trial)->items().empty());
    QVERIFY(bench.onlyAsked());
    QVERIFY(bench.journal().entries()->empty());
}

void TestTemporary::whatIsAlwaysKeptIsRefused()
{
    SimBench bench(text("lx16a@1"), {.baud = 115'200});
    device::Servo servo = bench.servo(1, base::Protocol::Lx);
    const auto was = bench.raw(1, text("temp_limit"));
    bench.forgetFrames();
    const auto trial =
        TemporarySettings::set(bench.context(), servo, {{text("temp_limit"), was - 5}});
    QVERIFY(!trial);
    QCOMPARE(trial.error().code, ErrorCode::NotSupported);
    QCOMPARE(trial.error().detail, text("always-kept"));
    QVERIFY(bench.onlyAsked());
    QCOMPARE(openIntents(bench), 0);
}

/// Neither in the servo nor in what is said of its values.
void TestTemporary::whatIsRefusedLeavesNothingBehind()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    const auto p = bench.raw(1, text("position_p"));
    bench.forgetFrames();
    QVERIFY(!TemporarySettings::set(bench.context(), servo, {{text("position_p"), 9999}}));
    QCOMPARE(bench.frames(support::Write), 0);
    QCOMPARE(bench.raw(1, text("position_p")), p);
    QCOMPARE(openIntents(bench), 0);
    const auto entries = bench.journal().entries();
    QCOMPARE(entries->size(), std::size_t(1));
    const base::IntentEnd& end = *entries->front().end;
    QCOMPARE(end.outcome, text("failed"));
    QCOMPARE(end.items.size(), std::size_t(1));
    QCOMPARE(end.items.front().key, text("position_p"));
    QCOMPARE(end.items.front().outcome, text("not-sent"));
    QVERIFY(device::temporaryValues(bench.journal(), servo)->empty());
}

void TestTemporary::aFullDiskForbidsIt()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    bench.journal().failWith(ErrorCode::DiskFull);
    bench.forgetFrames();
    const auto trial = TemporarySettings::set(bench.context(), servo, gains());
    QVERIFY(!trial);
    QCOMPARE(trial.error().code, ErrorCode::DiskFull);
    QVERIFY(bench.onlyAsked());
}

void TestTemporary::stopDoesNotKeepThemFromGoingBack()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    const auto p = bench.raw(1, text("position_p"));
    const auto trial = TemporarySettings::set(bench.context(), servo, gains());
    QVERIFY(trial);
    bench.stop().request();
    QVERIFY((*trial)->putBack());
    QCOMPARE(bench.raw(1, text("position_p")), p);
    QCOMPARE(openIntents(bench), 0);
}

void TestTemporary::gainsGoBackAfterAnEmergencyStop()
{
    SimBench bench(text("sts3215@1"));
    std::vector<device::Servo> servos{bench.servo(1)};
    bench.bus().setStopFrames(device::stopFrames({base::Protocol::Feetech}, servos));
    const auto p = bench.raw(1, text("position_p"));
    const auto trial = TemporarySettings::set(bench.context(), servos[0], gains());
    QVERIFY(trial);
    QVERIFY(device::setTorque(bench.context(), servos[0], device::Torque::On));
    bench.bus().emergency();
    QVERIFY((*trial)->putBack());
    QCOMPARE(bench.raw(1, text("position_p")), p);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0); // nothing energised it
    QCOMPARE(openIntents(bench), 0);
}

void TestTemporary::aLostLinkLeavesTheIntentOpen_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("undo") << int(RecoverAction::Undo);
    QTest::newRow("finish means the same") << int(RecoverAction::Finish);
}

void TestTemporary::aLostLinkLeavesTheIntentOpen()
{
    QFETCH(int, action);
    SimBench bench(text("sts3215@1"));
    const auto before = eprom(bench);
    const auto p = bench.raw(1, text("position_p"));
    {
        device::Servo servo = bench.servo(1);
        const auto trial = TemporarySettings::set(bench.context(), servo, gains());
        QVERIFY(trial);
        bench.cutLink();
        const auto back = (*trial)->putBack();
        QVERIFY(!back);
        QCOMPARE(back.error().code, ErrorCode::LinkLost);
        QVERIFY(noted(bench, device::NoticeCode::SettingNotPutBack));
    }
    QCOMPARE(openIntents(bench), 1);
    bench.reconnect(1'000'000);
    const auto looked = jobs::recover(bench.context(), RecoverAction::Look);
    QVERIFY(looked);
    QCOMPARE(looked->size(), std::size_t(1));
    QCOMPARE(looked->front().before.finding, Finding::AllNew);
    QCOMPARE(bench.raw(1, text("position_p")), 20);
    const auto settled = jobs::recover(bench.context(), RecoverAction(action));
    QVERIFY(settled && settled->front().done);
    QCOMPARE(bench.raw(1, text("position_p")), p);
    QCOMPARE(bench.raw(1, text("position_i")), 0);
    QCOMPARE(openIntents(bench), 0);
    QVERIFY(before == eprom(bench));
}

void TestTemporary::aPowerCycleForgetsThem()
{
    SimBench bench(text("sts3215@1"));
    const auto p = bench.raw(1, text("position_p"));
    {
        device::Servo servo = bench.servo(1);
        const auto trial = TemporarySettings::set(bench.context(), servo, gains());
        QVERIFY(trial);
        bench.cutLink();
    }
    bench.powerCycle();
    bench.reconnect(1'000'000);
    QCOMPARE(bench.raw(1, text("position_p")), p);
    const auto looked = jobs::recover(bench.context(), RecoverAction::Look);
    QVERIFY(looked);
    QCOMPARE(looked->front().before.finding, Finding::AllOld);
    const auto settled = jobs::recover(bench.context(), RecoverAction::Undo);
    QVERIFY(settled && settled->front().done);
    QCOMPARE(bench.raw(1, text("position_p")), p);
}

void TestTemporary::theSweepSwitchesTheMode_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::addColumn<int>("protocol");
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    const int feetech = int(base::Protocol::Feetech);
    const auto row = [&](const char* name, const char* servo, const char* mode, int protocol,
                         const char* from, const char* to) {
        QTest::newRow(name) << text(servo) << text(mode) << protocol << text(from) << text(to);
    };
    row("STS wheel", "sts3215@1", "speed", feetech, "1000", "1500");
    row("STS PWM", "sts3215@1", "pwm", feetech, "1000", "1500");
    row("STS steps, limits 0", "sts3215@1", "step", feetech, "1000", "1500");
    row("SCS motor, limits 0", "scs15@1:1000000", "motor", feetech, "300", "500");
    row("HLS current", "hls3606@1", "current", feetech, "1000", "1500");
    row("SMCL wheel", "sm60-360m@1:1000000", "speed", feetech, "1000", "1500");
    row("LX motor", "lx16a@1:1000000", "motor", int(base::Protocol::Lx), "300", "500");
}

void TestTemporary::theSweepSwitchesTheMode()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    QFETCH(int, protocol);
    QFETCH(QString, from);
    QFETCH(QString, to);
    const auto language = base::Protocol(protocol);
    const bool lx = language == base::Protocol::Lx;
    SimBench bench(servo.section(QLatin1Char(':'), 0, 0),
                   lx ? support::BenchOptions{.baud = 115'200}
                      : support::BenchOptions{.baud = 1'000'000, .servoBaud = 1'000'000});
    bringInto(bench, mode.toLatin1().constData(), language);
    const auto before = eprom(bench);
    std::vector<device::Servo> servos{bench.servo(1, language)};
    const std::size_t intents = bench.journal().entries()->size();
    const auto done =
        sweep(bench, servos, {}, to.toLatin1().constData(), from.toLatin1().constData());
    QVERIFY2(done, done ? ""
                        : qPrintable(base::errorName(done.error().code) + QLatin1Char(' ') +
                                     done.error().detail + done.error().registerKey));
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->servos.at(0).legs.size(), std::size_t(4));
    for (const record::SweepLeg& leg : done->servos.at(0).legs)
        QVERIFY(!leg.missed);
    device::Servo after = bench.servo(1, language);
    QCOMPARE(after.mode()->key, mode);
    QVERIFY(before == eprom(bench));
    QCOMPARE(bench.raw(1, lx ? text("load") : text("torque_switch")), 0);
    QCOMPARE(openIntents(bench), 0);
    QCOMPARE(bench.journal().entries()->size(), intents + 1);
    // The report shows the servo's own settings.
    for (const record::SnapshotRegister& reg : done->servos.at(0).parameters.registers) {
        const catalog::Register* own = after.profile->find(reg.key);
        if (own != nullptr && own->role == catalog::Role::OperatingMode)
            QCOMPARE(reg.raw, after.raw(*own).value());
    }
    // Switched on, it stands: the command of its mode is zero.
    const auto place = [&] {
        return bench.withWire([](sim::VirtualBus& wire) { return wire.servo(1)->shaftDegrees(); });
    };
    if (mode != QLatin1StringView("step")) {
        QVERIFY(device::setTorque(bench.context(), after, device::Torque::On));
        bench.letTimePass(500ms);
        const double rests = place();
        bench.letTimePass(2s);
        QVERIFY(std::abs(place() - rests) < 2);
    }
}

void TestTemporary::theSweepPutsTheModeBackHoweverItEnds_data()
{
    QTest::addColumn<QString>("end");
    for (const char* end : {"stopped", "alarm", "jammed", "bad range"})
        QTest::newRow(end) << text(end);
}

void TestTemporary::theSweepPutsTheModeBackHoweverItEnds()
{
    QFETCH(QString, end);
    SimBench bench(text("sts3215@1"));
    bringInto(bench, "speed", base::Protocol::Feetech);
    const auto before = eprom(bench);
    std::vector<device::Servo> servos{bench.servo(1)};
    jobs::SweepWatch watch;
    watch.onLeg = [&](std::size_t, const record::SweepLeg& leg) {
        if (leg.number == 1 && end == QLatin1StringView("stopped"))
            bench.stop().request();
        if (leg.number == 1 && end == QLatin1StringView("alarm"))
            bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->injectStatus(4); });
    };
    if (end == QLatin1StringView("jammed")) {
        bench.withWire([](sim::VirtualBus& wire) {
            wire.servo(1)->load().stopLow = 2000.0 / 4096 * 2 * M_PI;
        });
    }
    const bool badRange = end == QLatin1StringView("bad range");
    const auto done = sweep(bench, servos, watch, badRange ? "5000" : "1500");
    QCOMPARE(done.has_value(), !badRange);
    QCOMPARE(bench.raw(1, text("operating_mode")), 1);
    QCOMPARE(bench.raw(1, text("goal_speed")), 0);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    QCOMPARE(openIntents(bench), 0);
    QVERIFY(before == eprom(bench));
}

/// The limits a servo has while it is tested are not what its way back from motor mode remembers.
void TestTemporary::rememberedLimitsStayWhatTheyWere()
{
    SimBench bench(text("scs15@1"), {.baud = 1'000'000, .servoBaud = 1'000'000});
    bench.poke(1, text("min_angle_limit"), 0);
    bench.poke(1, text("max_angle_limit"), 0);
    std::vector<device::Servo> servos{bench.servo(1)};
    const auto identity = servos[0].identity();
    QVERIFY(sweep(bench, servos, {}, "500", "300"));
    QCOMPARE(bench.raw(1, text("max_angle_limit")), 0);
    QVERIFY(!bench.journal().kept(identity, text("limits")).value());
    QVERIFY(noted(bench, device::NoticeCode::LimitsDefaulted));
    QVERIFY(!noted(bench, device::NoticeCode::LimitsKept));
}

void TestTemporary::aModeThatIsLeftBehindIsFound_data()
{
    QTest::addColumn<QString>("how");
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::newRow("lost link, STS") << text("link") << text("sts3215@1") << text("speed");
    QTest::newRow("lost link, limits") << text("link") << text("sts3215@1") << text("step");
    QTest::newRow("lost link, LX") << text("link") << text("lx16a@1") << text("motor");
    QTest::newRow("emergency stop") << text("emergency") << text("sts3215@1") << text("speed");
}

void TestTemporary::aModeThatIsLeftBehindIsFound()
{
    QFETCH(QString, how);
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    const bool lx = servo.startsWith(QLatin1StringView("lx"));
    const auto language = lx ? base::Protocol::Lx : base::Protocol::Feetech;
    const int baud = lx ? 115'200 : 1'000'000;
    SimBench bench(servo, {.baud = baud});
    bringInto(bench, mode.toLatin1().constData(), language);
    const auto before = eprom(bench);
    const bool emergency = how == QLatin1StringView("emergency");
    {
        std::vector<device::Servo> servos{bench.servo(1, language)};
        bench.bus().setStopFrames(device::stopFrames({language}, servos));
        jobs::SweepWatch watch;
        watch.onLeg = [&](std::size_t, const record::SweepLeg& leg) {
            if (leg.number == 2)
                emergency ? bench.bus().emergency() : bench.cutLink();
        };
        const auto done = sweep(bench, servos, watch, lx ? "500" : "1500", lx ? "300" : "1000");
        QVERIFY(done);
        QCOMPARE(done->end, emergency ? SweepEnd::Emergency : SweepEnd::LinkLost);
        QVERIFY(noted(bench, device::NoticeCode::SettingNotPutBack));
    }
    QCOMPARE(openIntents(bench), 1);
    QVERIFY(before == eprom(bench));
    if (emergency)
        QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    bench.reconnect(baud);
    const auto found = jobs::recover(bench.context(), RecoverAction::Look);
    QVERIFY(found);
    QCOMPARE(found->front().before.finding, Finding::AllNew);
    const auto settled = jobs::recover(bench.context(), RecoverAction::Undo);
    QVERIFY(settled);
    QVERIFY2(settled->front().done,
             settled->front().error ? qPrintable(settled->front().error->detail) : "");
    device::Servo after = bench.servo(1, language);
    QCOMPARE(after.mode()->key, mode);
    QCOMPARE(bench.raw(1, lx ? text("load") : text("torque_switch")), 0);
    QCOMPARE(openIntents(bench), 0);
    QVERIFY(before == eprom(bench));
}

void TestTemporary::twoServosInTwoModes()
{
    SimBench bench(text("sts3215@1,sts3215@2"));
    bringInto(bench, "speed", base::Protocol::Feetech);
    std::vector<device::Servo> servos{bench.servo(1), bench.servo(2)};
    const auto done = sweep(bench, servos);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(bench.raw(1, text("operating_mode")), 1);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    QCOMPARE(bench.raw(2, text("operating_mode")), 0);
    QCOMPARE(bench.raw(2, text("torque_switch")), 1); // it holds, as it would alone
}

QTEST_GUILESS_MAIN(TestTemporary)
#include "tst_temporary.moc"
