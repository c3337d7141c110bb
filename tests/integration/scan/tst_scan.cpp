// SPDX-License-Identifier: GPL-3.0-or-later
// The search, on the simulated bus and the manual clock: which servos are listed, what is never
// sent, how long it takes in the bus' own time.
#include "device/reader.h"
#include "integration/scan_support.h"
#include "jobs/scan/scan_all.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using base::ErrorCode;
using std::chrono::milliseconds;
using support::SimFixture;
using support::SimFixtureOptions;

using scan_support::fast;
using scan_support::find;
using scan_support::idsOf;
using scan_support::slowAdapterOptions;

namespace {
const QString six =
    QStringLiteral("sts3215@0,sts3250@7,scs15@100,sts3215@101,scs0009@200,sts3215@253");

/// The search reports its progress for the first time after the PING of this ID.
int idAtFirstProgress()
{
    SimFixture fixture(QStringLiteral("sts3215@200"));
    std::optional<int> id;
    const auto report = jobs::scan(fixture.context(), {}, [&](const jobs::Progress&) {
        if (fixture.framesSentTo(2) > 0 && !id)
            id = fixture.tap().written.back()[2];
    });
    return report ? id.value() : -1;
}
} // namespace

class TestScan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void listsEveryServoAndOnlyReads();
    void listsAlarmedServos();
    void scansOnlyTheRange();
    void lateRepliesAreCountedByTheirId();
    void oneLateReplyGivesNoAdvice();
    void lateEchoesAreNoServos();
    void slowPassFindsSilentServos();
    void anExpectedServoIsRetried();
    void findsServosWhoseRequestsWereSentInOneGo();
    void aBundleIncludesServosSilentOnce();
    void inconsistentScansAreRefused();
    void searchesAllRatesAndReturnsToItsOwn();
    void untilFoundEndsWithTheFirstRate();
    void untilFoundEndsOnASilentBus();
    void untilFoundTriesLxEverywhereAtTheEnd();
    void untilFoundTellsNeighboringRatesApart();
    void untilFoundEndsWithCollidingReplies();
    void untilFoundDoesNotEndWithNoise();
    void listsAServoSeenAtANeighboringRateOnce();
    void reportsRatesTheAdapterRefuses();
    void emergencyReachesTheServosAtTheirOwnRate();
    void lostFirstTransactionHidesNoServo();
    void progressRisesToTheEnd();
    void stopsWithin100Milliseconds_data();
    void stopsWithin100Milliseconds();
    void silentBusIsAnEmptyList_data();
    void silentBusIsAnEmptyList();
    void linkCutEndsTheScan_data();
    void linkCutEndsTheScan();
    void refusesInvalidSpecs_data();
    void refusesInvalidSpecs();
};

void TestScan::listsEveryServoAndOnlyReads()
{
    SimFixture fixture(six, {fast, fast, {}});
    std::vector<int> announced;
    const auto report = jobs::scan(fixture.context(), {}, {}, [&](const jobs::FoundServo& found) {
        announced.push_back(found.servo.id);
    });
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({0, 7, 100, 101, 200, 253}));
    QCOMPARE(announced, (std::vector<int>{0, 7, 100, 101, 200, 253}));
    QCOMPARE(find(*report, 7)->servo.profile->modelName, QStringLiteral("STS3250"));
    QCOMPARE(find(*report, 100)->servo.profile->modelName, QStringLiteral("SCS15"));
    QCOMPARE(find(*report, 253)->servo.baud, fast);
    for (const jobs::FoundServo& found : report->found)
        QVERIFY2(!found.duplicateSuspected && !found.lateReplySeen,
                 qPrintable(QString::number(found.servo.id)));
    QVERIFY(fixture.onlyReadsSent());
    QVERIFY(!report->slowPassAdvised && !report->hasGarbledReplies && !report->stopped);
    QCOMPARE(report->lateReplies, 0);
    QVERIFY2(report->elapsed <= milliseconds(1500),
             qPrintable(QString::number(report->elapsed.count())));
}

void TestScan::listsAlarmedServos()
{
    SimFixture fixture(QStringLiteral("demo"));
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1, 2, 3, 4, 5, 6}));
    QCOMPARE(int(find(*report, 6)->servo.status), 1); // voltage
    QCOMPARE(find(*report, 6)->servo.profile->modelName, QStringLiteral("SCS0009"));
    QCOMPARE(int(find(*report, 1)->servo.status), 0);
}

void TestScan::scansOnlyTheRange()
{
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@10,sts3215@20,sts3215@21"));
    jobs::ScanSpec spec;
    spec.firstId = 10;
    spec.lastId = 20;
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({10, 20}));
    QCOMPARE(fixture.framesSentTo(9) + fixture.framesSentTo(21), 0);
    for (int id = 10; id <= 20; ++id)
        QVERIFY(fixture.framesSentTo(id) > 0);
}

void TestScan::lateRepliesAreCountedByTheirId()
{
    SimFixtureOptions options = slowAdapterOptions();
    options.servoBaud = fast;
    SimFixture fixture(six, options);
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({0, 7, 100, 101, 200, 253}));
    for (const jobs::FoundServo& found : report->found) {
        QVERIFY(found.lateReplySeen);
        QVERIFY(!found.duplicateSuspected);
        QVERIFY(found.servo.profile);
        QCOMPARE(found.servo.raw(QStringLiteral("id")),
                 std::optional<std::int64_t>(found.servo.id));
    }
    QCOMPARE(report->lateReplies, 6);
    // All 254, the one that is asked ahead of them, and each late one once more by itself.
    QCOMPARE(fixture.frames(support::Ping), 254 + 1 + 6);
    QVERIFY(report->slowPassAdvised);
    QVERIFY2(report->elapsed <= milliseconds(2000),
             qPrintable(QString::number(report->elapsed.count())));
}

void TestScan::oneLateReplyGivesNoAdvice()
{
    SimFixture fixture(QStringLiteral("sts3215@30"), slowAdapterOptions());
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({30}));
    QCOMPARE(report->lateReplies, 1);
    QVERIFY(!report->slowPassAdvised);
}

// The echo of a PING reads like the reply of a servo with a voltage alarm.
void TestScan::lateEchoesAreNoServos()
{
    SimFixtureOptions options = slowAdapterOptions();
    options.wire.echo = true;
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@5"), options);
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(5)->environment().supplyVolts = 9; });
    fixture.runFor(milliseconds(200));
    QVERIFY(fixture.bus().hasEcho());
    jobs::ScanSpec spec;
    spec.lastId = 20;
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1, 5}));
    QCOMPARE(int(find(*report, 1)->servo.status), 0);
    QCOMPARE(int(find(*report, 5)->servo.status), 1);
}

void TestScan::slowPassFindsSilentServos()
{
    jobs::ScanSpec spec;
    spec.lastId = 60;
    for (const bool slowPass : {false, true}) {
        SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2,sts3215@30"), slowAdapterOptions());
        fixture.tap().onWrite = [&](const base::Bytes&) { // 30 does not answer the first time
            fixture.wireConfig().faults.muteIds =
                fixture.framesSentTo(30) < 2 ? std::vector<int>{30} : std::vector<int>{};
        };
        spec.slowPass = slowPass;
        const auto report = jobs::scan(fixture.context(), spec);
        QVERIFY(report);
        QCOMPARE(idsOf(*report), slowPass ? QList<int>({1, 2, 30}) : QList<int>({1, 2}));
        QCOMPARE(report->slowPassAdvised, !slowPass);
    }
}

/// One reply was lost. Who was not there before is not asked twice.
void TestScan::anExpectedServoIsRetried()
{
    for (const bool expected : {false, true}) {
        SimFixture fixture(six, {fast, fast, {}});
        bool lost = false;
        fixture.tap().replyOverride = [&](const base::Bytes& frame) -> std::optional<base::Bytes> {
            if (frame[2] != 100 || frame[4] != support::Ping || std::exchange(lost, true))
                return std::nullopt;
            return base::Bytes();
        };
        jobs::ScanSpec spec;
        if (expected)
            spec.expected = {{100, fast, base::Protocol::Feetech}, {5, fast}, {100, 500'000}};
        const auto report = jobs::scan(fixture.context(), spec);
        QVERIFY(report && lost);
        QCOMPARE(idsOf(*report), expected ? QList<int>({0, 7, 100, 101, 200, 253})
                                          : QList<int>({0, 7, 101, 200, 253}));
        QVERIFY(fixture.onlyReadsSent());
    }
}

/// A busy computer holds back the PING of one servo and sends it right before the next one, so that
/// reply and PING collide, and is busy again when what is left of them arrives.
void TestScan::findsServosWhoseRequestsWereSentInOneGo()
{
    const int second = idAtFirstProgress();
    const int first = second - 1;
    constexpr std::chrono::microseconds step(125);
    for (base::Duration delay{}; delay < milliseconds(10); delay += step) {
        SimFixture fixture(QStringLiteral("sts3215@%1,sts3215@%2,sts3215@%3")
                               .arg(first)
                               .arg(second)
                               .arg(second + 1));
        base::Bytes heldBack;
        fixture.tap().replyOverride = [&](const base::Bytes& frame) -> std::optional<base::Bytes> {
            const int id = frame[2];
            if ((id != first && id != second) || fixture.framesSentTo(id) != 1)
                return std::nullopt;
            heldBack.insert(heldBack.end(), frame.begin(), frame.end());
            if (id == second) {
                fixture.withBus([&](sim::VirtualBus& wire) {
                    wire.hostWrites(heldBack, fast, fixture.clock().now() + delay);
                });
            }
            return base::Bytes();
        };
        const auto report = jobs::scan(fixture.context(), {}, [&](const jobs::Progress&) {
            if (fixture.framesSentTo(second) == 1 && fixture.framesSentTo(second + 1) == 0)
                fixture.clock().advance(milliseconds(3));
        });
        QVERIFY(report);
        QCOMPARE(idsOf(*report), QList<int>({first, second, second + 1}));
        QVERIFY(!report->hasGarbledReplies);
        for (const jobs::FoundServo& found : report->found)
            QVERIFY(!found.duplicateSuspected);
    }
}

void TestScan::aBundleIncludesServosSilentOnce()
{
    SimFixture fixture(six, {fast, fast, {}});
    const auto mute = [&](std::vector<int> ids) {
        fixture.withBus([&](sim::VirtualBus& bus) {
            bus.config().faults.muteIds = {ids.begin(), ids.end()};
        });
    };
    mute({7, 100});
    double before = 0;
    int searches = 1;
    const auto servos = jobs::scanAll(fixture.context(), {}, [&](const jobs::Progress& progress) {
        if (progress.fraction < before) {
            ++searches;
            mute({});
        }
        before = progress.fraction;
    });
    QVERIFY(servos);
    QCOMPARE(int(servos->size()), 6);
    QCOMPARE(searches, 3);
    QVERIFY(fixture.onlyReadsSent());
}

void TestScan::inconsistentScansAreRefused()
{
    SimFixture fixture(six, {fast, fast, {}});
    double before = 1;
    bool silent = false;
    const auto servos = jobs::scanAll(fixture.context(), {}, [&](const jobs::Progress& progress) {
        if (progress.fraction < before)
            fixture.withBus([&](sim::VirtualBus& bus) {
                silent = !silent;
                bus.config().faults.muteIds.clear();
                if (silent)
                    bus.config().faults.muteIds = {100};
            });
        before = progress.fraction;
    });
    QVERIFY(!servos);
    QCOMPARE(servos.error().code, ErrorCode::Garbled);
    QCOMPARE(servos.error().id, 100);
}

void TestScan::searchesAllRatesAndReturnsToItsOwn()
{
    SimFixtureOptions options;
    options.baud = 500'000;
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2:500000,sm40blhv@3:115200,scs15@4:38400"),
                       options);
    jobs::ScanSpec spec;
    spec.lastId = 10;
    spec.bauds = {fast, 500'000, 115'200, 38'400, fast};
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1, 2, 3, 4}));
    QCOMPARE(find(*report, 1)->servo.baud, fast);
    QCOMPARE(find(*report, 2)->servo.baud, 500'000);
    QCOMPARE(find(*report, 3)->servo.baud, 115'200);
    QCOMPARE(find(*report, 4)->servo.baud, 38'400);
    QCOMPARE(report->rates, (std::vector<int>{fast, 500'000, 115'200, 38'400}));
    QCOMPARE(fixture.bus().baud(), 500'000);
    QVERIFY(fixture.onlyReadsSent());
    // Nobody is left held: the bus serves others again.
    QVERIFY(device::identify(fixture.context(), 2));
}

/// All servos of the first rate that has one; the other rates are left out.
void TestScan::untilFoundEndsWithTheFirstRate()
{
    SimFixture fixture(
        QStringLiteral("sts3215@1:500000,sts3215@9:500000,sm40blhv@3:115200,scs15@4:38400"));
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000, 115'200, 38'400};
    spec.untilFound = true;
    double last = 0;
    const auto report = jobs::scan(
        fixture.context(), spec, [&](const jobs::Progress& progress) { last = progress.fraction; });
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1, 9}));
    QCOMPARE(report->rates, (std::vector<int>{fast, 500'000}));
    QVERIFY(last > 0 && last <= 1);
    QCOMPARE(fixture.bus().baud(), fast);
    QVERIFY(fixture.onlyReadsSent());
}

/// No longer than was estimated, and without the long searches of LX and Modbus.
void TestScan::untilFoundEndsOnASilentBus()
{
    SimFixture fixture(QStringLiteral("sts3215@1:57600")); // hears nothing of it
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000, 115'200};
    const base::Duration thorough = jobs::estimateScanTime(fixture.context(), spec);
    spec.untilFound = true;
    const base::Duration estimate = jobs::estimateScanTime(fixture.context(), spec);
    QVERIFY(estimate < thorough / 3);
    double last = 0;
    const auto report = jobs::scan(
        fixture.context(), spec, [&](const jobs::Progress& progress) { last = progress.fraction; });
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY2(report->elapsed < estimate * 3 / 2,
             qPrintable(QString::number(double(report->elapsed.count()) / 1e6)));
    QCOMPARE(last, 1.0);
}

void TestScan::untilFoundTriesLxEverywhereAtTheEnd()
{
    SimFixture fixture(QStringLiteral("lx16a@3:9600"));
    jobs::ScanSpec spec;
    spec.bauds = {fast, 115'200, 9600};
    spec.untilFound = true;
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({3}));
    QCOMPARE(report->found.front().servo.baud, 9600);
    QCOMPARE(report->found.front().servo.protocol, base::Protocol::Lx);
    QCOMPARE(fixture.bus().baud(), fast);
    QVERIFY(fixture.onlyReadsSent());
}

void TestScan::untilFoundTellsNeighboringRatesApart()
{
    SimFixture fixture(QStringLiteral("smsmb@1:56000"));
    jobs::ScanSpec spec;
    spec.bauds = {57'600, 38'400, 56'000};
    spec.untilFound = true;
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1}));
    QCOMPARE(report->found.front().servo.baud, 56'000);
    QCOMPARE(report->rates, (std::vector<int>{57'600, 56'000}));
}

/// Servos hear PINGs at their own rate only, so replies that collide each time prove it.
void TestScan::untilFoundEndsWithCollidingReplies()
{
    SimFixture fixture(QStringLiteral("new-arm"));
    jobs::ScanSpec spec;
    spec.bauds = {500'000, fast, 115'200, 38'400};
    spec.untilFound = true;
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(report->rates, (std::vector<int>{500'000, fast}));
    QVERIFY(find(*report, 1) != nullptr && find(*report, 1)->duplicateSuspected);
    QVERIFY(fixture.onlyReadsSent());
}

/// Three broken replies, and then silence.
void TestScan::untilFoundDoesNotEndWithNoise()
{
    SimFixture fixture(QStringLiteral("sts3215@40,sts3215@5:500000"));
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        sim::FaultPlan& faults = fixture.wireConfig().faults;
        faults.muteIds = fixture.framesSentTo(40) > 3 ? std::vector<int>{40} : std::vector<int>{};
        faults.truncate = frame[2] == 40 ? 1.0 : 0.0;
    };
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000, 38'400};
    spec.untilFound = true;
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(report->rates, (std::vector<int>{fast, 500'000}));
    QVERIFY(find(*report, 5) != nullptr);
}

void TestScan::listsAServoSeenAtANeighboringRateOnce()
{
    SimFixture fixture(QStringLiteral("sts3215@1:250000"));
    jobs::ScanSpec spec;
    spec.lastId = 3;
    spec.bauds = {256'000, 250'000};
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1}));
    QCOMPARE(report->found.front().servo.baud, 250'000);

    // With only the neighbor searched it is better than nothing.
    spec.bauds = {256'000};
    const auto near = jobs::scan(fixture.context(), spec);
    QVERIFY(near);
    QCOMPARE(idsOf(*near), QList<int>({1}));
    QCOMPARE(near->found.front().servo.baud, 256'000);
}

void TestScan::reportsRatesTheAdapterRefuses()
{
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2:500000"));
    fixture.tap().refusedRates = {128'000, 76'800};
    jobs::ScanSpec spec;
    spec.lastId = 5;
    spec.bauds = {fast, 128'000, 500'000, 76'800};
    double last = 0;
    const auto report =
        jobs::scan(fixture.context(), spec, [&](const jobs::Progress& p) { last = p.fraction; });
    QVERIFY(report);
    QCOMPARE(report->rates, (std::vector<int>{fast, 500'000}));
    QCOMPARE(report->unsupportedRates, (std::vector<int>{128'000, 76'800}));
    QCOMPARE(idsOf(*report), QList<int>({1, 2}));
    QCOMPARE(last, 1.0);
    QCOMPARE(fixture.bus().baud(), fast);
}

void TestScan::emergencyReachesTheServosAtTheirOwnRate()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    fixture.poke(1, QStringLiteral("goal_position"), 3000); // switches torque on
    QCOMPARE(fixture.raw(1, QStringLiteral("torque_switch")), std::int64_t{1});
    // WRITE to all, address 40: 0.
    fixture.bus().setStopFrames(
        {{base::Protocol::Feetech, {0xFF, 0xFF, 0xFE, 0x04, 0x03, 0x28, 0x00, 0xD2}}});
    jobs::ScanSpec spec;
    spec.bauds = {500'000};
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (frame[4] == support::Ping && fixture.frameCount() == 20)
            fixture.bus().requestEmergency();
    };
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Preempted);
    QCOMPARE(fixture.bus().baud(), fast);
    QVERIFY(fixture.framesSentTo(protocol::broadcastId) >= 2);
    fixture.runFor(milliseconds(5));
    QCOMPARE(fixture.raw(1, QStringLiteral("torque_switch")), std::int64_t{0});
}

void TestScan::lostFirstTransactionHidesNoServo()
{
    SimFixture fixture(QStringLiteral("sts3215@0,sts3215@4"));
    jobs::ScanSpec spec;
    spec.lastId = 4;
    fixture.tap().onWrite = [&](const base::Bytes&) {
        fixture.wireConfig().faults.dropRequest = fixture.frames(support::Ping) == 1 ? 1.0 : 0.0;
    };
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({0, 4}));
}

void TestScan::progressRisesToTheEnd()
{
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2:500000"));
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000};
    const base::Duration estimate = jobs::estimateScanTime(fixture.context(), spec);
    std::vector<jobs::Progress> seen;
    const auto report =
        jobs::scan(fixture.context(), spec, [&](const jobs::Progress& p) { seen.push_back(p); });
    QVERIFY(report);
    QVERIFY(seen.size() > 10);
    QCOMPARE(seen.front().fraction, 0.0);
    QCOMPARE(seen.front().baud, fast);
    QCOMPARE(seen.back().baud, 500'000);
    QCOMPARE(seen.back().fraction, 1.0);
    QCOMPARE(seen.back().found, 2);
    // Whoever has answered counts at once, not at the end of its rate.
    QVERIFY(std::any_of(seen.begin(), seen.end(), [](const jobs::Progress& p) {
        return p.baud == fast && p.fraction < 0.4 && p.found == 1;
    }));
    QVERIFY(std::is_sorted(seen.begin(), seen.end(), [](const auto& a, const auto& b) {
        return a.fraction < b.fraction || a.remaining > b.remaining;
    }));
    // Told before the start, and close to what it took.
    QVERIFY(report->elapsed > estimate * 9 / 10);
    QVERIFY(report->elapsed < estimate * 13 / 10);
}

void TestScan::stopsWithin100Milliseconds_data()
{
    QTest::addColumn<int>("frame");
    for (const int frame : {1, 2, 50, 200, 255, 256, 258, 261, 264, 300, 420})
        QTest::addRow("at frame %d", frame) << frame;
}

void TestScan::stopsWithin100Milliseconds()
{
    QFETCH(int, frame);
    SimFixture fixture(six, {fast, fast, slowAdapterOptions().wire});
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000};
    base::Duration requestedAt{};
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (int(fixture.frameCount()) != frame)
            return;
        requestedAt = fixture.clock().now();
        fixture.stop().request();
    };
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QVERIFY(report->stopped);
    QVERIFY2(fixture.clock().now() - requestedAt <= milliseconds(100),
             qPrintable(QString::number((fixture.clock().now() - requestedAt).count())));
    QCOMPARE(int(fixture.frameCount()), frame); // no new step begins
    QCOMPARE(fixture.bus().baud(), fast);
}

void TestScan::silentBusIsAnEmptyList_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<int>("mute");
    QTest::newRow("wrong rate") << QStringLiteral("sts3215@1:115200,sts3215@2:500000") << -1;
    QTest::newRow("mute servo") << QStringLiteral("sts3215@3") << 3;
}

void TestScan::silentBusIsAnEmptyList()
{
    QFETCH(QString, servos);
    QFETCH(int, mute);
    SimFixtureOptions options;
    options.wire.faults.muteIds = {mute};
    SimFixture fixture(servos, options);
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY(!report->hasGarbledReplies);
    QVERIFY(report->elapsed <= milliseconds(1500));
}

void TestScan::linkCutEndsTheScan_data()
{
    QTest::addColumn<int>("frame");
    for (const int frame : {1, 3, 100, 255, 257, 260})
        QTest::addRow("at frame %d", frame) << frame;
}

void TestScan::linkCutEndsTheScan()
{
    QFETCH(int, frame);
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2"));
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000};
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (int(fixture.frameCount()) == frame)
            fixture.cutLink();
    };
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::LinkLost);

    fixture.tap().onWrite = {};
    fixture.reconnect(fast);
    const auto again = jobs::scan(fixture.context(), {});
    QVERIFY(again);
    QCOMPARE(idsOf(*again), QList<int>({1, 2}));
}

void TestScan::refusesInvalidSpecs_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("baud");
    QTest::newRow("negative ID") << -1 << 10 << fast;
    QTest::newRow("broadcast ID") << 0 << 254 << fast;
    QTest::newRow("range backwards") << 10 << 9 << fast;
    QTest::newRow("no rate") << 0 << 10 << 0;
}

void TestScan::refusesInvalidSpecs()
{
    QFETCH(int, first);
    QFETCH(int, last);
    QFETCH(int, baud);
    SimFixture fixture(QStringLiteral("sts3215@1"));
    jobs::ScanSpec spec;
    spec.firstId = first;
    spec.lastId = last;
    spec.bauds = {baud};
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::BadArgument);
    QCOMPARE(fixture.frameCount(), std::size_t{0});
}

SERVODESK_GUILESS_TEST(TestScan)
#include "tst_scan.moc"
