// SPDX-License-Identifier: GPL-3.0-or-later
// The diagnosis of random simulated buses, each broken in one or two ways: the first cause is one
// of them in at least 95 % of the cases, one of the first two always. Only reads are sent.
#include "integration/scan_support.h"
#include "jobs/diagnose/diagnose.h"
#include "support/test_main.h"
#include "transport/port_opener.h"

#include <QRegularExpression>
#include <QTest>

#include <random>

using base::Cause;
using scan_support::fast;
using std::chrono::milliseconds;
using support::SimFixture;
using support::SimFixtureOptions;

namespace {
constexpr int moderate = 115'200;

struct BrokenBus {
    std::vector<sim::ServoSpec> servos;
    SimFixtureOptions options;
    std::vector<base::Protocol> protocols; ///< selected by the user
    bool unplugged = false;
    /// The reply of whatever stands in place of an adapter; the bytes may be random.
    std::function<base::Bytes(std::mt19937_64&)> device;
    QStringList names;
    std::vector<Cause> causes; ///< empty: nothing is wrong
};

using Random = std::mt19937_64;

int below(Random& random, int limit)
{
    return int(random() % std::uint64_t(limit));
}

template <typename T>
const T& oneOf(Random& random, const std::vector<T>& choices)
{
    return choices[random() % choices.size()];
}

base::Bytes bytesOf(const char* text)
{
    const QByteArray bytes(text);
    return {bytes.begin(), bytes.end()};
}

/// A way to break a bus. `group`: of two ways each must be of another one.
struct Way {
    const char* name;
    int group;
    std::vector<Cause> causes;
    std::function<void(BrokenBus&, Random&)> apply;
};

enum Group { Servos, Line, Adapter };

void setLevel0(sim::VirtualServo& servo)
{
    servo.poke(QStringLiteral("response_level"), 0);
}

sim::ServoSpec lx(int id)
{
    return {QStringLiteral("LX-16A"), id, {}, {}, 120, {}, nullptr};
}

sim::ServoSpec modbus(int id)
{
    return {QStringLiteral("SMSMB"), id, moderate, {}, 120, {}, nullptr};
}

void duplicate(BrokenBus& bus, Random& random, int copies)
{
    for (int i = 0; i < copies; ++i) {
        sim::ServoSpec twin = bus.servos.front();
        twin.initialDegrees = 100.0 + below(random, 160);
        bus.servos.push_back(twin);
    }
}

const std::vector<Way>& ways()
{
    static const std::vector<Way> all{
        {"healthy", Servos, {}, [](BrokenBus&, Random&) {}},
        {"supply too low",
         Servos,
         {},
         [](BrokenBus& bus, Random&) { bus.servos.front().supplyVolts = 4.5; }},
        {"all at another rate",
         Servos,
         {Cause::WrongBaudRate},
         [](BrokenBus& bus, Random& random) {
             const int baud = oneOf(random, std::vector{500'000, 250'000, 115'200, 57'600, 38'400});
             for (sim::ServoSpec& servo : bus.servos)
                 servo.baud = baud;
         }},
        {"one at another rate",
         Servos,
         {Cause::WrongBaudRate},
         [](BrokenBus& bus, Random& random) {
             bus.servos.front().baud = oneOf(random, std::vector{500'000, 115'200, 38'400});
         }},
        {"two with one ID",
         Servos,
         {Cause::TwoServosOneId},
         [](BrokenBus& bus, Random& random) { duplicate(bus, random, 1); }},
        {"many with one ID",
         Servos,
         {Cause::TwoServosOneId},
         [](BrokenBus& bus, Random& random) { duplicate(bus, random, 2 + below(random, 4)); }},
        {"response level 0",
         Servos,
         {Cause::ResponseLevel0},
         [](BrokenBus& bus, Random&) { bus.servos.front().prepare = setLevel0; }},
        {"response level 0 everywhere",
         Servos,
         {Cause::ResponseLevel0},
         [](BrokenBus& bus, Random&) {
             for (sim::ServoSpec& servo : bus.servos)
                 servo.prepare = setLevel0;
         }},
        {"LX servos, port at 1 Mbaud",
         Servos,
         {Cause::WrongBaudRate},
         [](BrokenBus& bus, Random& random) {
             bus.servos = {lx(1 + below(random, 100)), lx(150)};
         }},
        {"Modbus servo, port at 1 Mbaud",
         Servos,
         {Cause::WrongBaudRate},
         [](BrokenBus& bus, Random& random) { bus.servos = {modbus(1 + below(random, 240))}; }},
        {"LX servos, Feetech selected",
         Servos,
         {Cause::OtherProtocol},
         [](BrokenBus& bus, Random& random) {
             bus.servos = {lx(1 + below(random, 100)), lx(150)};
             bus.options.baud = moderate;
             bus.protocols = {base::Protocol::Feetech};
         }},
        {"LX selected",
         Servos,
         {Cause::OtherProtocol},
         [](BrokenBus& bus, Random&) { bus.protocols = {base::Protocol::Lx}; }},
        {"no servo",
         Servos,
         {Cause::NoServoOrNoPower},
         [](BrokenBus& bus, Random&) { bus.unplugged = true; }},
        {"no servo, echo",
         Adapter,
         {Cause::EchoOnly},
         [](BrokenBus& bus, Random&) {
             bus.unplugged = true;
             bus.options.wire.echo = true;
         }},
        {"an update cut off",
         Servos,
         {Cause::Bootloader},
         [](BrokenBus& bus, Random&) {
             bus.servos.resize(1);
             bus.servos.front().defects.firmwareLost = true;
         }},
        {"reply wire broken",
         Line,
         {Cause::NoServoOrNoPower},
         [](BrokenBus& bus, Random&) {
             for (const sim::ServoSpec& servo : bus.servos)
                 bus.options.wire.faults.muteIds.push_back(servo.id);
         }},
        {"damaged replies",
         Line,
         {Cause::Noise},
         [](BrokenBus& bus, Random& random) {
             bus.options.wire.faults.corrupt = 0.1 + 0.05 * below(random, 7);
         }},
        {"lost replies",
         Line,
         {Cause::Noise},
         [](BrokenBus& bus, Random& random) {
             bus.options.wire.faults.drop = 0.1 + 0.05 * below(random, 7);
         }},
        {"short replies",
         Line,
         {Cause::Noise},
         [](BrokenBus& bus, Random& random) {
             bus.options.wire.faults.truncate = 0.1 + 0.05 * below(random, 7);
         }},
        {"lost requests",
         Line,
         {Cause::Noise},
         [](BrokenBus& bus, Random& random) {
             bus.options.wire.faults.dropRequest = 0.1 + 0.05 * below(random, 7);
         }},
        {"adapter 1 ms late",
         Adapter,
         {},
         [](BrokenBus& bus, Random&) { bus.options.wire.adapterLatency = milliseconds(1); }},
        {"adapter 16 ms late",
         Adapter,
         {},
         [](BrokenBus& bus, Random&) { bus.options.wire.adapterLatency = milliseconds(16); }},
        {"adapter 40 ms late",
         Adapter,
         {Cause::LateAdapter},
         [](BrokenBus& bus, Random&) { bus.options.wire.adapterLatency = milliseconds(40); }},
        {"adapter 60 ms late",
         Adapter,
         {Cause::LateAdapter},
         [](BrokenBus& bus, Random&) { bus.options.wire.adapterLatency = milliseconds(60); }},
        {"echo", Adapter, {}, [](BrokenBus& bus, Random&) { bus.options.wire.echo = true; }},
        {"a board prints its log",
         Adapter,
         {Cause::BoardNotAdapter},
         [](BrokenBus& bus, Random&) {
             bus.device = [](Random&) { return bytesOf("E (312) i2c: bus timeout\r\n"); };
         }},
        {"random bytes for every request",
         Adapter,
         {Cause::Noise},
         [](BrokenBus& bus, Random&) {
             bus.device = [](Random& random) {
                 base::Bytes bytes(3 + random() % 10);
                 std::generate(bytes.begin(), bytes.end(), random);
                 return bytes;
             };
         }},
    };
    return all;
}

BrokenBus makeBus(std::uint64_t seed)
{
    Random random(seed);
    BrokenBus bus;
    bus.options.wire.seed = seed * 1000;
    const QString model =
        oneOf(random, std::vector<QString>{QStringLiteral("STS3215"), QStringLiteral("STS3250"),
                                           QStringLiteral("SCS15"), QStringLiteral("SM40BLHV")});
    const int count = 1 + below(random, 6);
    for (int i = 0; i < count; ++i)
        bus.servos.push_back({model,
                              1 + i * 3 + below(random, 3),
                              fast,
                              {},
                              100.0 + below(random, 160),
                              {},
                              nullptr});
    const Way& first = ways()[seed % ways().size()];
    const Way& second = oneOf(random, ways());
    std::vector<const Way*> applied{&first};
    if (below(random, 2) == 1 && second.group != first.group)
        applied.push_back(&second);
    for (const Way* way : applied) {
        way->apply(bus, random);
        bus.names << QString::fromLatin1(way->name);
        bus.causes.insert(bus.causes.end(), way->causes.begin(), way->causes.end());
    }
    const bool isSilent = bus.unplugged || !bus.options.wire.faults.muteIds.empty();
    if (isSilent && bus.options.wire.echo)
        bus.causes = {Cause::EchoOnly};
    if (bus.causes.empty())
        bus.causes.push_back(Cause::Found);
    return bus;
}

jobs::DiagnosisSpec allRates(const BrokenBus& bus)
{
    return {transport::standardBaudRates(), bus.protocols};
}

bool contains(const std::vector<Cause>& causes, Cause cause)
{
    return std::find(causes.begin(), causes.end(), cause) != causes.end();
}
} // namespace

class TestDiagnose : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void namesTheCauseOfBrokenBuses();
    void namesAnotherProgramFirst();
    void aRestartIsNoLostFirmware();
    void keepsWhatItFoundWhenItIsStopped();
    void emergencyReachesTheServosAtTheirOwnRate();
    void theEndDoesNotMoveAway_data();
    void theEndDoesNotMoveAway();
    void silenceCountsTheRatesThatWereTried_data();
    void silenceCountsTheRatesThatWereTried();
};

void TestDiagnose::namesTheCauseOfBrokenBuses()
{
    constexpr int buses = 300;
    QStringList notFirst;
    QStringList missed;
    for (int seed = 1; seed <= buses; ++seed) {
        const BrokenBus bus = makeBus(std::uint64_t(seed));
        SimFixture fixture(bus.servos, bus.options);
        if (bus.unplugged)
            fixture.withBus([](sim::VirtualBus& wire) { wire.unplugAll(); });
        Random random(static_cast<std::uint64_t>(seed));
        if (bus.device) {
            fixture.tap().replyOverride = [&](const base::Bytes&) {
                return std::optional(bus.device(random));
            };
        }
        fixture.clearFrames();
        const base::Duration began = fixture.clock().now();
        const auto report = jobs::diagnose(fixture.context(), allRates(bus));
        QVERIFY(report);
        QVERIFY(fixture.onlyReadsSent());
        QCOMPARE(fixture.bus().baud(), bus.options.baud);
        const base::Diagnosis& diagnosis = report->diagnosis;
        QString result =
            QStringLiteral("%1: %2 -> %3")
                .arg(seed)
                .arg(bus.names.join(QStringLiteral(" + ")), base::causeName(diagnosis.cause));
        for (const Cause cause : diagnosis.also)
            result += QStringLiteral(", ") + base::causeName(cause);
        result += QStringLiteral(" in %1 s")
                      .arg(std::chrono::duration<double>(fixture.clock().now() - began).count());
        if (contains(bus.causes, diagnosis.cause))
            continue;
        notFirst << result;
        if (diagnosis.also.empty() || !contains(bus.causes, diagnosis.also.front()))
            missed << result;
    }
    if (!notFirst.isEmpty())
        qInfo("Not first:\n%s", qPrintable(notFirst.join(QLatin1Char('\n'))));
    QCOMPARE(missed, QStringList());
    QVERIFY(notFirst.size() <= buses * 5 / 100);
}

void TestDiagnose::namesAnotherProgramFirst()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    jobs::DiagnosisSpec spec;
    spec.otherPrograms = QStringLiteral("minicom (1234)");
    const auto report = jobs::diagnose(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(report->diagnosis.cause, Cause::PortBusy);
    QCOMPARE(int(report->found.size()), 1);
}

/// At a restart every servo is in its bootloader for a moment.
void TestDiagnose::aRestartIsNoLostFirmware()
{
    const base::Bytes preamble{'1', 'f', 'B', 'V', 'A'};
    const auto causeOf = [&preamble](int replies) {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        fixture.withBus([](sim::VirtualBus& wire) { wire.unplugAll(); });
        fixture.tap().replyOverride = [&](const base::Bytes& sent) {
            const bool replied = sent == preamble && replies-- > 0;
            return replied ? std::optional(base::Bytes{0x06}) : std::nullopt;
        };
        return jobs::diagnose(fixture.context(), {})->diagnosis.cause;
    };
    QCOMPARE(causeOf(1), Cause::NoServoOrNoPower);
    QCOMPARE(causeOf(2), Cause::Bootloader);
}

void TestDiagnose::keepsWhatItFoundWhenItIsStopped()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    const auto report = jobs::diagnose(fixture.context(), {{500'000, 115'200}}, {},
                                       [&](const base::Evidence& evidence) {
                                           if (evidence.kind == base::EvidenceKind::ServosFound)
                                               fixture.stop().request();
                                       });
    QVERIFY(report);
    QVERIFY(report->diagnosis.stopped);
    QCOMPARE(int(report->found.size()), 1);
    QCOMPARE(fixture.bus().baud(), fast);
}

void TestDiagnose::emergencyReachesTheServosAtTheirOwnRate()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    fixture.poke(1, QStringLiteral("goal_position"), 3000); // switches torque on
    // WRITE to all, address 40: 0.
    fixture.bus().setStopFrames(
        {{base::Protocol::Feetech, {0xFF, 0xFF, 0xFE, 0x04, 0x03, 0x28, 0x00, 0xD2}}});
    bool isStopped = false;
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (fixture.bus().baud() == 115'200 && !std::exchange(isStopped, true))
            fixture.bus().requestEmergency();
    };
    const auto report = jobs::diagnose(fixture.context(), {{500'000, 115'200}});
    QVERIFY(!report);
    QCOMPARE(report.error().code, base::ErrorCode::Preempted);
    QCOMPARE(fixture.bus().baud(), fast);
    static_cast<void>(fixture.bus().listen(milliseconds(5)));
    QCOMPARE(fixture.raw(1, QStringLiteral("torque_switch")), std::int64_t{0});
}

void TestDiagnose::theEndDoesNotMoveAway_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<bool>("silent");
    QTest::newRow("found at once") << QStringLiteral("sts3215@1,sts3215@2") << false;
    QTest::newRow("found at another rate") << QStringLiteral("sts3215@1+500000") << false;
    QTest::newRow("nothing found") << QStringLiteral("sts3215@1") << true;
}

/// What is left gets less and less, and nothing is left at the end.
void TestDiagnose::theEndDoesNotMoveAway()
{
    QFETCH(QString, servos);
    QFETCH(bool, silent);
    SimFixtureOptions options;
    if (servos.contains(QLatin1Char('+')))
        options.servoBaud = servos.section(QLatin1Char('+'), 1).toInt();
    SimFixture fixture(servos.section(QLatin1Char('+'), 0, 0), options);
    if (silent)
        fixture.withBus([](sim::VirtualBus& wire) { wire.unplugAll(); });
    std::vector<jobs::Progress> reports;
    const auto report =
        jobs::diagnose(fixture.context(), {{500'000, 115'200, 57'600}},
                       [&](const jobs::Progress& progress) { reports.push_back(progress); });
    QVERIFY(report);
    QCOMPARE(report->found.empty(), silent);
    QVERIFY(reports.size() > 10);
    for (std::size_t i = 1; i < reports.size(); ++i) {
        QVERIFY(reports[i].remaining && reports[i].remaining <= reports[i - 1].remaining);
        QVERIFY(reports[i].fraction >= reports[i - 1].fraction);
    }
    const jobs::Progress& last = reports.back();
    QVERIFY2(last.fraction > 0.9, qPrintable(QString::number(last.fraction)));
    QVERIFY(*last.remaining < std::chrono::seconds(1));
}

void TestDiagnose::silenceCountsTheRatesThatWereTried_data()
{
    QTest::addColumn<bool>("rateIsFixed");
    QTest::addColumn<bool>("refuses");
    QTest::addColumn<int>("rates");
    QTest::newRow("adapter") << false << false << 3;
    QTest::newRow("adapter that cannot run one") << false << true << 2;
    QTest::newRow("network bridge") << true << false << 1;
}

void TestDiagnose::silenceCountsTheRatesThatWereTried()
{
    QFETCH(bool, rateIsFixed);
    QFETCH(bool, refuses);
    SimFixture fixture(QStringLiteral("sts3215@1"));
    fixture.tap().rateIsFixed = rateIsFixed;
    fixture.reconnect(fast);
    fixture.withBus([](sim::VirtualBus& wire) { wire.unplugAll(); });
    if (refuses)
        fixture.tap().refusedRates = {500'000};
    const auto report = jobs::diagnose(fixture.context(), {{500'000, 115'200}});
    QVERIFY(report);
    QCOMPARE(report->diagnosis.cause, Cause::NoServoOrNoPower);
    const auto& evidence = report->diagnosis.evidence;
    const auto silence = std::find_if(evidence.begin(), evidence.end(), [](const auto& one) {
        return one.kind == base::EvidenceKind::NothingReceived;
    });
    QVERIFY(silence != evidence.end());
    QTEST(silence->count, "rates");
}

SERVODESK_GUILESS_TEST(TestDiagnose)
#include "tst_diagnose.moc"
