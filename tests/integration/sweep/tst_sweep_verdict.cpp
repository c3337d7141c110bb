// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of sweep tests that were broken off, that follow a sine, or that are too short, on
// simulated servos and on one that knows only bytes: it obeys a scripted position, whatever goals
// it is sent.
#include "integration/sweep_support.h"
#include "jobs/sweep/sweep_proposal.h"
#include "results/sweep_json.h"
#include "results/sweep_verdict.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <numbers>

using base::Duration;
using results::Grade;
using results::NoVerdictReason;
using results::SweepEnd;
using results::SweepShape;
using support::SimFixture;
using support::utf8;
using sweep_support::metric;
using sweep_support::run;
using namespace std::chrono_literals;

namespace {
/// A servo of bytes: a memory, a wire with some time to the answer, and a position of the script's.
class ScriptedServo final : public transport::Link {
public:
    using Script = std::function<double(Duration now, double goal)>;

    /// `like`: whose table it has.
    ScriptedServo(base::ManualClock& clock, SimFixture& like, Script script, Duration latency)
        : m_clock(clock)
        , m_script(std::move(script))
        , m_latency(latency)
    {
        const device::Servo servo = like.servo(1);
        for (const catalog::Register& reg : servo.profile->registers) {
            const std::int64_t raw = like.raw(1, reg.key);
            for (int i = 0; i < reg.size; ++i)
                m_memory[std::size_t(reg.offset + i)] = std::uint8_t(raw >> (8 * i));
        }
        put(42, 1000);
        m_memory[66] = 1; // it moves
    }

    void ignoreTorqueOff() { m_ignoresTorqueOff = true; }
    void unplug(Duration from, Duration until)
    {
        m_awayFrom = from;
        m_awayUntil = until;
    }

    base::Result<void> write(base::ByteView bytes) override
    {
        m_request.insert(m_request.end(), bytes.begin(), bytes.end());
        while (m_request.size() >= 6 && m_request.size() >= m_request[3] + 4U) {
            answer({m_request.begin(), m_request.begin() + m_request[3] + 4});
            m_request.erase(m_request.begin(), m_request.begin() + m_request[3] + 4);
        }
        return {};
    }
    base::Result<std::size_t> read(base::Bytes& buffer) override
    {
        if (m_clock.now() < m_readyAt)
            return std::size_t(0);
        const std::size_t count = m_reply.size();
        buffer.insert(buffer.end(), m_reply.begin(), m_reply.end());
        m_reply.clear();
        return count;
    }
    base::Result<bool> waitForReadyRead(Duration span) override
    {
        const bool comes = !m_reply.empty() && m_readyAt - m_clock.now() <= span;
        m_clock.advance(comes ? std::max(m_readyAt - m_clock.now(), Duration(1)) : span);
        return comes;
    }
    base::Result<void> setBaud(int baud) override
    {
        m_baud = baud;
        return {};
    }
    int baud() const override { return m_baud; }
    QString name() const override { return utf8("sim:scripted"); }

private:
    void put(int address, int value)
    {
        m_memory[std::size_t(address)] = std::uint8_t(value);
        m_memory[std::size_t(address) + 1] = std::uint8_t(value >> 8);
    }

    void answer(const base::Bytes& frame)
    {
        if (frame[2] != m_memory[5])
            return; // not this one's, or everybody's
        if (m_clock.now() >= m_awayFrom && m_clock.now() < m_awayUntil)
            return;
        base::Bytes data;
        const int address = frame.size() > 6 ? frame[5] : 0;
        if (frame[4] == support::Read) {
            const double goal = m_memory[42] + 256 * m_memory[43];
            put(56, int(std::lround(m_script(m_clock.now(), goal))));
            data.assign(m_memory.begin() + address, m_memory.begin() + address + frame[6]);
        } else if (frame[4] == support::Write) {
            std::copy(frame.begin() + 6, frame.end() - 1, m_memory.begin() + address);
            m_memory[40] = m_ignoresTorqueOff ? 1 : m_memory[40];
        }
        base::Bytes reply{0xFF, 0xFF, frame[2], std::uint8_t(data.size() + 2), 0};
        reply.insert(reply.end(), data.begin(), data.end());
        int sum = 0;
        for (std::size_t i = 2; i < reply.size(); ++i)
            sum += reply[i];
        reply.push_back(std::uint8_t(~sum));
        m_reply.insert(m_reply.end(), reply.begin(), reply.end());
        m_readyAt = m_clock.now() + m_latency;
    }

    base::ManualClock& m_clock;
    Script m_script;
    Duration m_latency; ///< until an answer is there
    std::array<std::uint8_t, 512> m_memory{};
    base::Bytes m_request;
    base::Bytes m_reply;
    Duration m_readyAt{};
    int m_baud = 1'000'000;
    bool m_ignoresTorqueOff = false;
    Duration m_awayFrom{};
    Duration m_awayUntil{};
};

results::SweepSpec sine(Duration period)
{
    results::SweepSpec spec;
    spec.shape = SweepShape::Sine;
    spec.range = {utf8("1000"), utf8("3000")};
    spec.period = period;
    spec.cycles = 2;
    spec.speed = utf8("3000");
    spec.acceleration = utf8("200");
    spec.stopOnStall = false; // what is asked is the figures' verdict
    return spec;
}

results::SweepSpec sweepThereAndBack()
{
    results::SweepSpec spec;
    spec.range = {utf8("1000"), utf8("2000")};
    spec.pause = 1500ms;
    spec.cycles = 3;
    spec.speed = utf8("2000");
    spec.acceleration = utf8("50");
    return spec;
}

NoVerdictReason reason(const results::SweepRun& run, std::size_t servo = 0)
{
    return results::sweepVerdict(run, run.servos.at(servo)).reason;
}
} // namespace

class TestSweepVerdict : public QObject {
    Q_OBJECT

private:
    base::Result<results::SweepRun> scripted(const results::SweepSpec& spec,
                                             const ScriptedServo::Script& script,
                                             Duration latency = 200us,
                                             const jobs::SweepCallbacks& watch = {});
    bool m_isTorqueOn = false;       ///< whatever it is told
    ScriptedServo* m_wire = nullptr; ///< while a scripted run lasts

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void aStopAfterAGoodLegGivesNoVerdict();
    void onlyTheServoWithTheAlarmFails();
    void aSlowSinePasses_data();
    void aSlowSinePasses();
    void notFollowingTheSineFails_data();
    void notFollowingTheSineFails();
    void aFollowingServoPasses();
    void aSineFasterThanItTurnsNeverPasses();
    void tooFewSamplesGiveNoVerdict();
    void aSlowAdapterFailsNoServo_data();
    void aSlowAdapterFailsNoServo();
    void anUnobservedLegPassesNoServo();
    void aLagWithinLinkDelayGivesNoVerdict();
    void halfAPeriodGivesNoVerdict();
    void limitsWithoutSineMetricsGiveNoVerdict();
    void randomTargetsAreJudged();
    void aSingleRandomTargetGivesNoVerdict();
    void unobservedArrivalsGiveNoVerdict();
    void shortMovesGiveNoVerdict_data();
    void shortMovesGiveNoVerdict();
    void aWideToleranceGivesNoVerdict();
    void torqueLeftOnIsReported();
};

base::Result<results::SweepRun> TestSweepVerdict::scripted(const results::SweepSpec& spec,
                                                           const ScriptedServo::Script& script,
                                                           Duration latency,
                                                           const jobs::SweepCallbacks& watch)
{
    SimFixture like(utf8("sts3215@1"));
    base::ManualClock clock;
    auto wire = std::make_unique<ScriptedServo>(clock, like, script, latency);
    if (m_isTorqueOn)
        wire->ignoreTorqueOff();
    m_wire = wire.get();
    bus::BusCore bus(std::move(wire), protocol::feetechCodec(), clock, bus::CoreOptions{});
    support::MemoryJournal journal;
    base::StopToken stop;
    device::Notices notices;
    const device::Context context{bus, support::builtInCatalog(), journal, stop, notices};
    auto servo = device::identify(context, 1, base::Protocol::Feetech);
    if (!servo)
        return tl::unexpected(servo.error());
    std::vector<device::Servo> servos{std::move(*servo)};
    return run(context, servos, spec, watch);
}

void TestSweepVerdict::aStopAfterAGoodLegGivesNoVerdict()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 2)
            fixture.stop().request();
    };
    const auto done = run(fixture.context(), servos, sweepThereAndBack(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Stopped);
    for (const results::SweepServo& servo : done->servos) {
        QVERIFY(servo.legs.size() >= 2);
        QVERIFY(!servo.legs[0].missed && servo.legs[0].steadyError);
        QCOMPARE(results::worstGrade(servo.lines), Grade::Pass); // as far as it went
        QCOMPARE(servo.verdict, Grade::NotMeasured);
    }
    QCOMPARE(reason(*done), NoVerdictReason::Ended);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QVERIFY(!results::encodeSweepRun(*done).contains("\"verdict\": \"pass\""));
}

void TestSweepVerdict::onlyTheServoWithTheAlarmFails()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 2)
            fixture.withBus([](sim::VirtualBus& wire) {
                wire.servo(2)->load().stopHigh = 1500.0 / 4096 * 2 * M_PI;
            });
    };
    const auto done = run(fixture.context(), servos, sweepThereAndBack(), watch);
    QVERIFY(done);
    QVERIFY(done->end == SweepEnd::Stall || done->end == SweepEnd::Alarm);
    QCOMPARE(done->endedBy, 2);
    QCOMPARE(done->servos[0].verdict, Grade::NotMeasured);
    QCOMPARE(done->servos[1].verdict, Grade::Fail);
    QCOMPARE(done->verdict(), Grade::Fail);
}

void TestSweepVerdict::aSlowSinePasses_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("speed");
    QTest::newRow("STS") << utf8("sts3215@1") << utf8("1000") << utf8("3000") << utf8("3000");
    QTest::newRow("HLS") << utf8("hls3606@1") << utf8("1000") << utf8("3000") << utf8("40");
    QTest::newRow("SCS") << utf8("scs15@1:1000000") << utf8("300") << utf8("700") << utf8("1000");
}

void TestSweepVerdict::aSlowSinePasses()
{
    QFETCH(QString, servos);
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, speed);
    SimFixture fixture(servos);
    std::vector<device::Servo> all{fixture.servo(1)};
    results::SweepSpec spec = sine(8s);
    spec.range = {from, to};
    spec.speed = speed;
    spec.acceleration.clear();
    const auto done = run(fixture.context(), all, spec);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    const results::SweepServo& one = done->servos.front();
    const QString figures = utf8("%1 %, %2 degrees, %3 readings")
                                .arg(metric(one, "following_error_relative").value_or(-1))
                                .arg(metric(one, "phase_lag").value_or(-1))
                                .arg(metric(one, "readings_per_period").value_or(-1));
    QVERIFY2(one.verdict == Grade::Pass, qPrintable(figures));
    QVERIFY2(*metric(one, "phase_lag") > 0 && *metric(one, "phase_lag") < 15, qPrintable(figures));
    QVERIFY2(*metric(one, "readings_per_period") > 100, qPrintable(figures));
    QVERIFY(*metric(one, "following_error_relative") < 25);
    const auto again = results::decodeSweepRun(results::encodeSweepRun(*done));
    QVERIFY(again && again->verdict() == Grade::Pass);
    QCOMPARE(again->servos.front().legs[1].phaseLag, one.legs[1].phaseLag);
}

void TestSweepVerdict::notFollowingTheSineFails_data()
{
    QTest::addColumn<double>("share"); ///< of the amplitude that it goes
    QTest::addColumn<int>("lateMs");
    QTest::newRow("ignores its goals") << 0.0 << 0;
    QTest::newRow("goes a third of the way") << 0.3 << 0;
    QTest::newRow("goes the wrong way") << -1.0 << 0;
    QTest::newRow("comes half a second late") << 1.0 << 500;
}

/// The wave begins with the first goal that is not the start.
void TestSweepVerdict::notFollowingTheSineFails()
{
    QFETCH(double, share);
    QFETCH(int, lateMs);
    std::map<Duration, double> goals;
    const auto done = scripted(sine(4s), [&](Duration now, double goal) {
        goals[now] = goal;
        const auto then = goals.upper_bound(now - std::chrono::milliseconds(lateMs));
        const double commanded = then == goals.begin() ? 1000 : std::prev(then)->second;
        return 1000 + share * (commanded - 1000);
    });
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    const results::SweepServo& servo = done->servos.front();
    QCOMPARE(servo.legs.size(), std::size_t(4));
    QCOMPARE(servo.verdict, Grade::Fail);
    QCOMPARE(done->verdict(), Grade::Fail);
    QVERIFY(*metric(servo, "following_error_relative") > 50);
    if (lateMs > 0)
        QVERIFY(std::abs(*metric(servo, "phase_lag") - 45) < 4); // half a second of four
    if (share == 0)
        QVERIFY(!metric(servo, "phase_lag")); // there is no phase of what stands
}

void TestSweepVerdict::aFollowingServoPasses()
{
    const auto done = scripted(sine(4s), [](Duration, double goal) { return goal; });
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    const results::SweepServo& servo = done->servos.front();
    for (const results::VerdictLine& line : servo.lines)
        QVERIFY2(line.grade != Grade::Warn, qPrintable(line.limit.metric));
    QCOMPARE(servo.verdict, Grade::Pass);
    QVERIFY(*metric(servo, "following_error_relative") < 5);
    QVERIFY(std::abs(*metric(servo, "phase_lag")) < 2);
}

void TestSweepVerdict::aSineFasterThanItTurnsNeverPasses()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sine(4s); // π · 2000 / 4 steps/s
    spec.speed = utf8("500");
    const auto look = jobs::estimateSweep(fixture.context(), servos[0], spec, {});
    QVERIFY(look && look->tooShort);
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(done);
    QVERIFY(done->verdict() != Grade::Pass && done->verdict() != Grade::Warn);
    // Nor does one that is quicker than it was told to be.
    const auto quick = scripted(spec, [](Duration, double goal) { return goal; });
    QVERIFY(quick);
    QCOMPARE(quick->servos.front().verdict, Grade::NotMeasured);
    QCOMPARE(reason(*quick), NoVerdictReason::TooFast);
}

void TestSweepVerdict::tooFewSamplesGiveNoVerdict()
{
    results::SweepSpec spec = sine(500ms);
    spec.range.to = utf8("1100");
    spec.cycles = 6;
    const auto follow = [](Duration, double goal) { return goal; };
    const auto done = scripted(spec, follow, 35ms); // an adapter that takes its time
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QCOMPARE(reason(*done), NoVerdictReason::TooFewReadings);
    QVERIFY(!metric(done->servos.front(), "phase_lag"));
    const auto enough = scripted(spec, follow);
    QVERIFY(enough);
    QCOMPARE(enough->verdict(), Grade::Pass);
}

void TestSweepVerdict::aSlowAdapterFailsNoServo_data()
{
    QTest::addColumn<int>("latencyMs");
    QTest::addColumn<int>("periodMs");
    for (const int latency : {60, 80, 110, 150, 200}) {
        for (const int period : {3000, 6000})
            QTest::addRow("%d ms, sine of %d ms", latency, period) << latency << period;
    }
}

/// What an adapter is late by is none of the servo's: it passes, or nothing is said of it.
void TestSweepVerdict::aSlowAdapterFailsNoServo()
{
    QFETCH(int, latencyMs);
    QFETCH(int, periodMs);
    support::SimFixtureOptions options;
    options.wire.adapterLatency = std::chrono::milliseconds(latencyMs);
    SimFixture fixture(utf8("sts3215@1"), options);
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sine(std::chrono::milliseconds(periodMs));
    spec.range = {utf8("1500"), utf8("2500")};
    spec.cycles = 1;
    spec.speed.clear();
    spec.acceleration.clear();
    spec.stopOnStall = true;
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    QVERIFY2(done->verdict() != Grade::Fail,
             qPrintable(utf8("%1 %, %2°")
                            .arg(metric(done->servos[0], "following_error_relative").value_or(-1))
                            .arg(metric(done->servos[0], "phase_lag").value_or(-1))));
}

namespace {
/// A servo that goes a third of the way.
double lagging(Duration, double goal)
{
    return 1000 + 0.3 * (goal - 1000);
}

Grade gradeOf(const results::SweepServo& servo, const char* metric)
{
    for (const results::VerdictLine& line : servo.lines) {
        if (line.limit.metric == QLatin1String(metric))
            return line.grade;
    }
    return Grade::NotMeasured;
}
} // namespace

/// The other legs show the lag, read often enough.
void TestSweepVerdict::anUnobservedLegPassesNoServo()
{
    jobs::SweepCallbacks watch;
    watch.onGoal = [this](std::size_t, int leg, Duration at) {
        if (leg == 1)
            m_wire->unplug(at, at + 3500ms);
    };
    for (const bool stops : {false, true}) {
        results::SweepSpec spec = sine(4s);
        spec.cycles = 6;
        spec.stopOnFailure = stops;
        const auto done = scripted(spec, lagging, 200us, watch);
        QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
        const results::SweepServo& servo = done->servos.front();
        QCOMPARE(gradeOf(servo, "following_error_relative"), Grade::Fail);
        QCOMPARE(servo.verdict, Grade::Fail);
        QCOMPARE(reason(*done), NoVerdictReason::None);
        QCOMPARE(done->end, stops ? SweepEnd::Failure : SweepEnd::Finished);
        QVERIFY(*metric(servo, "readings_per_period") < results::minReadingsToFailSine);
    }
}

void TestSweepVerdict::aLagWithinLinkDelayGivesNoVerdict()
{
    const auto done = scripted(sine(4s), lagging, 60ms);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    const results::SweepServo& servo = done->servos.front();
    for (const results::SweepLeg& leg : servo.legs)
        QVERIFY2(2 * leg.samples >= results::minReadingsPerPeriod &&
                     2 * leg.samples < results::minReadingsToFailSine,
                 qPrintable(QString::number(leg.samples)));
    QVERIFY(*metric(servo, "following_error_relative") > 50);
    QCOMPARE(gradeOf(servo, "following_error_relative"), Grade::NotMeasured);
    QCOMPARE(servo.verdict, Grade::NotMeasured);
    QCOMPARE(reason(*done), NoVerdictReason::SlowLink);
}

void TestSweepVerdict::halfAPeriodGivesNoVerdict()
{
    results::SweepSpec spec = sine(4s);
    spec.cycles = 0;
    spec.length = 1s;
    const auto done = scripted(spec, [](Duration, double goal) { return goal; });
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->servos.front().legs.size(), std::size_t(1));
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QCOMPARE(reason(*done), NoVerdictReason::TooShort);
}

/// A file of one's own from before there were such limits.
void TestSweepVerdict::limitsWithoutSineMetricsGiveNoVerdict()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    jobs::SweepRequest order;
    order.spec = sine(8s);
    results::SweepLimits limits;
    limits.name = utf8("own");
    limits.lines = {{utf8("alarms"), QString(), {}, 0.0}, {utf8("overshoot"), utf8("%"), 3, 5}};
    order.limits = {limits};
    const auto done = jobs::sweep(fixture.context(), servos, order, {});
    QVERIFY(done);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QCOMPARE(reason(*done), NoVerdictReason::NoLimit);
}

void TestSweepVerdict::randomTargetsAreJudged()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepThereAndBack();
    spec.shape = SweepShape::Random;
    spec.pace = results::SweepPace::Dwell;
    spec.pause = 400ms;
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(done);
    const results::SweepServo& one = done->servos.front();
    QVERIFY2(one.verdict == Grade::Pass,
             qPrintable(QString::number(metric(one, "following_error_relative").value_or(-1))));
    QVERIFY(metric(one, "following_error_relative"));
    QVERIFY(std::none_of(one.lines.begin(), one.lines.end(), [](const results::VerdictLine& line) {
        return line.limit.metric == utf8("phase_lag");
    }));
    spec.pace = results::SweepPace::Delay;
    const auto ignored = scripted(spec, [](Duration, double) { return 1000.0; });
    QVERIFY(ignored);
    QVERIFY(ignored->verdict() == Grade::Fail);
}

void TestSweepVerdict::aSingleRandomTargetGivesNoVerdict()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepThereAndBack();
    spec.shape = SweepShape::Random;
    spec.cycles = 0;
    spec.length = 1s;
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(done);
    QCOMPARE(done->servos.front().legs.size(), std::size_t(1));
    QCOMPARE(reason(*done), NoVerdictReason::TooShort);
}

/// The adapter is so slow that no leg is seen from beginning to end.
void TestSweepVerdict::unobservedArrivalsGiveNoVerdict()
{
    results::SweepSpec spec = sweepThereAndBack();
    spec.pause = 900ms;
    const auto follow = [](Duration, double goal) { return goal; };
    const auto slow = scripted(spec, follow, 160ms);
    QVERIFY2(slow, slow ? "" : qPrintable(slow.error().detail));
    QCOMPARE(slow->end, SweepEnd::Finished);
    QCOMPARE(reason(*slow), NoVerdictReason::NotMeasured);
    QCOMPARE(slow->verdict(), Grade::NotMeasured);
    const auto quick = scripted(spec, follow);
    QVERIFY(quick);
    QCOMPARE(reason(*quick), NoVerdictReason::None);
}

void TestSweepVerdict::shortMovesGiveNoVerdict_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::newRow("within the tolerance") << utf8("2043") << utf8("2053");
    QTest::newRow("both ends within it") << utf8("2037") << utf8("2059");
}

/// The servo never moves, and the test says beforehand that it cannot tell.
void TestSweepVerdict::shortMovesGiveNoVerdict()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    results::SweepSpec spec = sweepThereAndBack();
    spec.range = {from, to};
    for (const auto shape : {SweepShape::Sweep, SweepShape::BothSides, SweepShape::Random}) {
        spec.shape = shape;
        const auto done = scripted(spec, [](Duration, double) { return 2048.0; });
        QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
        QCOMPARE(done->end, SweepEnd::Finished);
        QVERIFY(done->verdict() == Grade::NotMeasured || done->verdict() == Grade::Fail);
        if (done->verdict() == Grade::NotMeasured)
            QCOMPARE(reason(*done), NoVerdictReason::ShortMoves);
        QVERIFY(!metric(done->servos.front(), "missed_targets"));
    }
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    spec.shape = SweepShape::Sweep;
    const auto limits = results::builtInSweepLimits(utf8("STS3215"), utf8("STS"));
    const auto look = jobs::estimateSweep(fixture.context(), servo, spec, limits);
    QVERIFY(look);
    QCOMPARE(look->minMove, 3 * look->axis.tolerance);
    spec.range = {utf8("2000"), utf8("2040")};
    const auto enough = jobs::estimateSweep(fixture.context(), servo, spec, limits);
    QVERIFY(enough);
    QCOMPARE(enough->minMove, 0.0);
}

void TestSweepVerdict::aWideToleranceGivesNoVerdict()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.withBus(
        [](sim::VirtualBus& wire) { wire.servo(1)->load().stopHigh = 1500.0 / 4096 * 2 * M_PI; });
    std::vector<device::Servo> servos{fixture.servo(1)};
    jobs::SweepRequest order;
    order.spec = sweepThereAndBack();
    order.spec.stopOnAlarm = false;
    results::SweepLimits limits = results::builtInSweepLimits(utf8("STS3215"), utf8("STS"));
    limits.tolerance = 5000;
    std::erase_if(limits.lines,
                  [](const results::SweepLimit& line) { return line.metric == utf8("alarms"); });
    order.limits = {limits};
    const auto done = jobs::sweep(fixture.context(), servos, order, {});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(done->verdict() != Grade::Pass && done->verdict() != Grade::Warn);
    QCOMPARE(done->servos.front().limits.name, utf8("STS3215, custom")); // no longer built in
}

void TestSweepVerdict::torqueLeftOnIsReported()
{
    results::SweepSpec spec = sweepThereAndBack();
    spec.cycles = 1;
    spec.releaseAtEnd = true;
    std::vector<int> left;
    jobs::SweepCallbacks watch;
    watch.onUnreleasedTorque = [&left](const jobs::UnreleasedTorque& one) {
        left.push_back(one.id);
    };
    const auto follow = [](Duration, double goal) { return goal; };
    QVERIFY(scripted(spec, follow, 200us, watch));
    QVERIFY(left.empty());
    m_isTorqueOn = true;
    const auto done = scripted(spec, follow, 200us, watch);
    m_isTorqueOn = false;
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(left, std::vector<int>{1});
}

SERVODESK_GUILESS_TEST(TestSweepVerdict)
#include "tst_sweep_verdict.moc"
