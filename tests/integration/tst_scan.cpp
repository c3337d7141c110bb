// SPDX-License-Identifier: GPL-3.0-or-later
// The search, on the simulated bus and the manual clock: who is listed, what is never sent, how
// long it takes in the bus' own time.
#include "device/reader.h"
#include "jobs/scan.h"
#include "jobs/scan_twins.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using base::ErrorCode;
using std::chrono::milliseconds;
using support::BenchOptions;
using support::SimBench;

namespace {
constexpr int fast = 1'000'000;
const QString six =
    QStringLiteral("sts3215@0,sts3250@7,scs15@100,sts3215@101,scs0009@200,sts3215@253");

QList<int> idsOf(const jobs::ScanReport& report)
{
    QList<int> ids;
    for (const jobs::Found& found : report.found)
        ids.append(found.servo.id);
    return ids;
}

const jobs::Found* find(const jobs::ScanReport& report, int id)
{
    const auto found = std::find_if(report.found.begin(), report.found.end(),
                                    [id](const jobs::Found& f) { return f.servo.id == id; });
    return found == report.found.end() ? nullptr : &*found;
}

BenchOptions slowAdapter()
{
    BenchOptions options;
    options.wire.adapterLatency = milliseconds(16);
    return options;
}

std::vector<sim::ServoRecipe> twins(const QString& one, const QString& other)
{
    return {{one, 5, fast, 7.4, 180, {}, nullptr},
            {other, 5, fast, 7.4, 95, {}, nullptr},
            {QStringLiteral("STS3215"), 9, fast, 7.4, 180, {}, nullptr}};
}
} // namespace

class TestScan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void listsEveryServoAndOnlyAsks();
    void listsAlarmedServos();
    void asksOnlyTheRange();
    void countsLateRepliesForTheIdTheyName();
    void oneLateReplyAdvisesNothing();
    void slowPassFindsWhoWasSilent();
    void searchesAllRatesAndReturnsToItsOwn();
    void listsAServoHeardAtANeighbouringRateOnce();
    void tellsWhichRatesTheAdapterRefuses();
    void restoresTheRateAfterAnError();
    void lostFirstTransactionHidesNobody();
    void progressRisesToTheEnd();
    void stopsWithin100Milliseconds_data();
    void stopsWithin100Milliseconds();
    void suspectsTwins_data();
    void suspectsTwins();
    void suspectsTwinsThatAnswerOneAfterTheOther();
    void listsAServoThatOnlyAnswersBroken();
    void oneBrokenAnswerIsNoTwin();
    void noiseIsReportedAndProvesNobody();
    void silentBusIsAnEmptyList_data();
    void silentBusIsAnEmptyList();
    void linkCutEndsTheScan_data();
    void linkCutEndsTheScan();
    void refusesNonsense_data();
    void refusesNonsense();
    void oneServoCouldSayThis_data();
    void oneServoCouldSayThis();
};

void TestScan::listsEveryServoAndOnlyAsks()
{
    SimBench bench(six, {fast, fast, {}});
    std::vector<int> announced;
    const auto report = jobs::scan(bench.context(), {}, {}, [&](const jobs::Found& found) {
        announced.push_back(found.servo.id);
    });
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({0, 7, 100, 101, 200, 253}));
    QCOMPARE(announced, (std::vector<int>{0, 7, 100, 101, 200, 253}));
    QCOMPARE(find(*report, 7)->servo.profile->modelName, QStringLiteral("STS3250"));
    QCOMPARE(find(*report, 100)->servo.profile->modelName, QStringLiteral("SCS15"));
    QCOMPARE(find(*report, 253)->servo.baud, fast);
    for (const jobs::Found& found : report->found)
        QVERIFY2(!found.twinsSuspected && !found.heardLate,
                 qPrintable(QString::number(found.servo.id)));
    QVERIFY(bench.onlyAsked());
    QVERIFY(!report->slowPassAdvised && !report->garbledHeard && !report->stopped);
    QCOMPARE(report->lateReplies, 0);
    QVERIFY2(report->elapsed <= milliseconds(1500),
             qPrintable(QString::number(report->elapsed.count())));
}

void TestScan::listsAlarmedServos()
{
    SimBench bench(QStringLiteral("demo"));
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1, 2, 3, 4, 5, 6}));
    QCOMPARE(int(find(*report, 6)->servo.status), 1); // voltage
    QCOMPARE(find(*report, 6)->servo.profile->modelName, QStringLiteral("SCS0009"));
    QCOMPARE(int(find(*report, 1)->servo.status), 0);
}

void TestScan::asksOnlyTheRange()
{
    SimBench bench(QStringLiteral("sts3215@1,sts3215@10,sts3215@20,sts3215@21"));
    jobs::ScanSpec spec;
    spec.firstId = 10;
    spec.lastId = 20;
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({10, 20}));
    QCOMPARE(bench.framesTo(9) + bench.framesTo(21), 0);
    for (int id = 10; id <= 20; ++id)
        QVERIFY(bench.framesTo(id) > 0);
}

void TestScan::countsLateRepliesForTheIdTheyName()
{
    BenchOptions options = slowAdapter();
    options.servoBaud = fast;
    SimBench bench(six, options);
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({0, 7, 100, 101, 200, 253}));
    for (const jobs::Found& found : report->found) {
        QVERIFY(found.heardLate);
        QVERIFY(!found.twinsSuspected);
        QVERIFY(found.servo.profile);
        QCOMPARE(found.servo.raw(QStringLiteral("id")),
                 std::optional<std::int64_t>(found.servo.id));
    }
    QCOMPARE(report->lateReplies, 6);
    QVERIFY(report->slowPassAdvised);
    QVERIFY2(report->elapsed <= milliseconds(2000),
             qPrintable(QString::number(report->elapsed.count())));
}

void TestScan::oneLateReplyAdvisesNothing()
{
    SimBench bench(QStringLiteral("sts3215@30"), slowAdapter());
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({30}));
    QCOMPARE(report->lateReplies, 1);
    QVERIFY(!report->slowPassAdvised);
}

void TestScan::slowPassFindsWhoWasSilent()
{
    jobs::ScanSpec spec;
    spec.lastId = 60;
    for (const bool slowPass : {false, true}) {
        SimBench bench(QStringLiteral("sts3215@1,sts3215@2,sts3215@30"), slowAdapter());
        bench.tap().onWrite = [&](const base::Bytes&) { // 30 does not answer the first time
            bench.wireConfig().faults.muteIds =
                bench.framesTo(30) < 2 ? std::vector<int>{30} : std::vector<int>{};
        };
        spec.slowPass = slowPass;
        const auto report = jobs::scan(bench.context(), spec);
        QVERIFY(report);
        QCOMPARE(idsOf(*report), slowPass ? QList<int>({1, 2, 30}) : QList<int>({1, 2}));
        QCOMPARE(report->slowPassAdvised, !slowPass);
    }
}

void TestScan::searchesAllRatesAndReturnsToItsOwn()
{
    BenchOptions options;
    options.baud = 500'000;
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2:500000,sm40blhv@3:115200,scs15@4:38400"),
                   options);
    jobs::ScanSpec spec;
    spec.lastId = 10;
    spec.bauds = {fast, 500'000, 115'200, 38'400, fast};
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1, 2, 3, 4}));
    QCOMPARE(find(*report, 1)->servo.baud, fast);
    QCOMPARE(find(*report, 2)->servo.baud, 500'000);
    QCOMPARE(find(*report, 3)->servo.baud, 115'200);
    QCOMPARE(find(*report, 4)->servo.baud, 38'400);
    QCOMPARE(report->rates, (std::vector<int>{fast, 500'000, 115'200, 38'400}));
    QCOMPARE(bench.bus().baud(), 500'000);
    QVERIFY(bench.onlyAsked());
    // Nobody is left held: the bus serves others again.
    QVERIFY(device::identify(bench.context(), 2));
}

void TestScan::listsAServoHeardAtANeighbouringRateOnce()
{
    SimBench bench(QStringLiteral("sts3215@1:250000"));
    jobs::ScanSpec spec;
    spec.lastId = 3;
    spec.bauds = {256'000, 250'000};
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({1}));
    QCOMPARE(report->found.front().servo.baud, 250'000);

    // With only the neighbour searched it is better than nothing.
    spec.bauds = {256'000};
    const auto near = jobs::scan(bench.context(), spec);
    QVERIFY(near);
    QCOMPARE(idsOf(*near), QList<int>({1}));
    QCOMPARE(near->found.front().servo.baud, 256'000);
}

void TestScan::tellsWhichRatesTheAdapterRefuses()
{
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2:500000"));
    bench.tap().refusedRates = {128'000, 76'800};
    jobs::ScanSpec spec;
    spec.lastId = 5;
    spec.bauds = {fast, 128'000, 500'000, 76'800};
    double last = 0;
    const auto report =
        jobs::scan(bench.context(), spec, [&](const jobs::Progress& p) { last = p.fraction; });
    QVERIFY(report);
    QCOMPARE(report->rates, (std::vector<int>{fast, 500'000}));
    QCOMPARE(report->ratesRefused, (std::vector<int>{128'000, 76'800}));
    QCOMPARE(idsOf(*report), QList<int>({1, 2}));
    QCOMPARE(last, 1.0);
    QCOMPARE(bench.bus().baud(), fast);
}

void TestScan::restoresTheRateAfterAnError()
{
    SimBench bench(QStringLiteral("sts3215@1"));
    jobs::ScanSpec spec;
    spec.bauds = {500'000};
    bench.tap().onWrite = [&](const base::Bytes&) {
        if (bench.frameCount() == 20)
            bench.bus().emergency();
    };
    const auto report = jobs::scan(bench.context(), spec);
    bench.tap().onWrite = {};
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Preempted);
    QCOMPARE(bench.bus().baud(), fast);
}

void TestScan::lostFirstTransactionHidesNobody()
{
    SimBench bench(QStringLiteral("sts3215@0,sts3215@4"));
    jobs::ScanSpec spec;
    spec.lastId = 4;
    bench.tap().onWrite = [&](const base::Bytes&) {
        bench.wireConfig().faults.dropRequest = bench.frames(support::Ping) == 1 ? 1.0 : 0.0;
    };
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({0, 4}));
}

void TestScan::progressRisesToTheEnd()
{
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2:500000"));
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000};
    const base::Duration estimate = jobs::scanEstimate(spec, fast);
    std::vector<jobs::Progress> seen;
    const auto report =
        jobs::scan(bench.context(), spec, [&](const jobs::Progress& p) { seen.push_back(p); });
    QVERIFY(report);
    QVERIFY(seen.size() > 10);
    QCOMPARE(seen.front().fraction, 0.0);
    QCOMPARE(seen.front().baud, fast);
    QCOMPARE(seen.back().baud, 500'000);
    QCOMPARE(seen.back().fraction, 1.0);
    QCOMPARE(seen.back().found, 2);
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
    SimBench bench(six, {fast, fast, slowAdapter().wire});
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000};
    base::Duration requestedAt{};
    bench.tap().onWrite = [&](const base::Bytes&) {
        if (int(bench.frameCount()) != frame)
            return;
        requestedAt = bench.clock().now();
        bench.stop().request();
    };
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QVERIFY(report->stopped);
    QVERIFY2(bench.clock().now() - requestedAt <= milliseconds(100),
             qPrintable(QString::number((bench.clock().now() - requestedAt).count())));
    QCOMPARE(int(bench.frameCount()), frame); // no new step begins
    QCOMPARE(bench.bus().baud(), fast);
}

void TestScan::suspectsTwins_data()
{
    QTest::addColumn<QString>("one");
    QTest::addColumn<QString>("other");
    QTest::addColumn<int>("latencyMs");
    const QString sts = QStringLiteral("STS3215");
    for (const int latency : {0, 16}) {
        QTest::addRow("same model, latency %d", latency) << sts << sts << latency;
        QTest::addRow("same series, latency %d", latency)
            << sts << QStringLiteral("STS3250") << latency;
        QTest::addRow("other series, latency %d", latency)
            << sts << QStringLiteral("SCS15") << latency;
    }
}

void TestScan::suspectsTwins()
{
    QFETCH(QString, one);
    QFETCH(QString, other);
    QFETCH(int, latencyMs);
    BenchOptions options;
    options.wire.adapterLatency = milliseconds(latencyMs);
    SimBench bench(twins(one, other), options);
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5, 9}));
    QVERIFY(find(*report, 5)->twinsSuspected);
    QVERIFY(!find(*report, 9)->twinsSuspected);
    QVERIFY(bench.onlyAsked());
}

// Two SMS servos with different reply delays: each answer comes whole, and there are two of them.
void TestScan::suspectsTwinsThatAnswerOneAfterTheOther()
{
    const QString sms = QStringLiteral("SM40BLHV");
    const auto slow = [](sim::VirtualServo& servo) {
        servo.poke(QStringLiteral("return_delay"), 250);
    };
    SimBench bench({{sms, 5, fast, 12.0, 180, {}, nullptr}, {sms, 5, fast, 12.0, 180, {}, slow}});
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5}));
    QVERIFY(report->found.front().twinsSuspected);
}

void TestScan::listsAServoThatOnlyAnswersBroken()
{
    BenchOptions options;
    options.wire.faults.corrupt = 1.0;
    SimBench bench(QStringLiteral("sts3215@17"), options);
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({17}));
    QVERIFY(report->found.front().twinsSuspected);
    QVERIFY(!report->found.front().servo.profile);
}

void TestScan::oneBrokenAnswerIsNoTwin()
{
    SimBench bench(QStringLiteral("sts3215@17"));
    bench.tap().onWrite = [&](const base::Bytes&) {
        bench.wireConfig().faults.corrupt = bench.framesTo(17) == 1 ? 1.0 : 0.0;
    };
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({17}));
    QVERIFY(!report->found.front().twinsSuspected);
    QVERIFY(report->found.front().servo.profile);
    QVERIFY(!report->garbledHeard); // it was explained
}

void TestScan::noiseIsReportedAndProvesNobody()
{
    SimBench bench(QStringLiteral("sts3215@40"));
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        // A frame cut short by noise: bytes come, once, and never again.
        sim::FaultPlan& faults = bench.wireConfig().faults;
        faults.muteIds = bench.framesTo(40) > 1 ? std::vector<int>{40} : std::vector<int>{};
        faults.truncate = frame[2] == 40 ? 1.0 : 0.0;
    };
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY(report->garbledHeard);
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
    BenchOptions options;
    options.wire.faults.muteIds = {mute};
    SimBench bench(servos, options);
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY(!report->garbledHeard);
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
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2"));
    jobs::ScanSpec spec;
    spec.bauds = {fast, 500'000};
    bench.tap().onWrite = [&](const base::Bytes&) {
        if (int(bench.frameCount()) == frame)
            bench.cutLink();
    };
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::LinkLost);

    bench.tap().onWrite = {};
    bench.reconnect(fast);
    const auto again = jobs::scan(bench.context(), {});
    QVERIFY(again);
    QCOMPARE(idsOf(*again), QList<int>({1, 2}));
}

void TestScan::refusesNonsense_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("baud");
    QTest::newRow("negative ID") << -1 << 10 << fast;
    QTest::newRow("broadcast ID") << 0 << 254 << fast;
    QTest::newRow("range backwards") << 10 << 9 << fast;
    QTest::newRow("no rate") << 0 << 10 << 0;
}

void TestScan::refusesNonsense()
{
    QFETCH(int, first);
    QFETCH(int, last);
    QFETCH(int, baud);
    SimBench bench(QStringLiteral("sts3215@1"));
    jobs::ScanSpec spec;
    spec.firstId = first;
    spec.lastId = last;
    spec.bauds = {baud};
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::BadArgument);
    QCOMPARE(bench.frameCount(), std::size_t{0});
}

void TestScan::oneServoCouldSayThis_data()
{
    QTest::addColumn<int>("before");
    QTest::addColumn<int>("after");
    QTest::addColumn<int>("speed");
    QTest::addColumn<int>("temperature");
    QTest::addColumn<bool>("possible");
    QTest::newRow("at rest, same") << 2048 << 2048 << 0 << 30 << true;
    QTest::newRow("at rest, jitter") << 2048 << 2051 << 0 << 30 << true;
    QTest::newRow("at rest, elsewhere") << 2048 << 2148 << 0 << 30 << false;
    QTest::newRow("moving on") << 2048 << 2068 << 3000 << 30 << true;
    QTest::newRow("moving, too far") << 2048 << 3000 << 3000 << 30 << false;
    QTest::newRow("over the seam") << 4094 << 3 << 0 << 30 << true;
    QTest::newRow("sudden heat") << 2048 << 2048 << 0 << 45 << false;
}

void TestScan::oneServoCouldSayThis()
{
    QFETCH(int, before);
    QFETCH(int, after);
    QFETCH(int, speed);
    QFETCH(int, temperature);
    QFETCH(bool, possible);
    device::Servo a;
    a.profile = support::builtInCatalog().resolve({3, 10, 0, 9, 3});
    const auto low = [](int value) { return std::uint8_t(value & 0xFF); };
    const auto high = [](int value) { return std::uint8_t(value >> 8); };
    const std::uint8_t moving = speed != 0 ? 1 : 0;
    const auto feedback = [&](int position, int degrees) {
        return base::Bytes{low(position),
                           high(position),
                           low(speed),
                           high(speed),
                           0,
                           0,
                           74,
                           std::uint8_t(degrees),
                           0,
                           0,
                           moving,
                           0,
                           0,
                           0,
                           0};
    };
    device::Servo b = a;
    a.image.store(56, feedback(before, 30), {});
    b.image.store(56, feedback(after, temperature), {});
    QCOMPARE(jobs::couldBeOneServo(a, b, milliseconds(4)), possible);
}

QTEST_GUILESS_MAIN(TestScan)
#include "tst_scan.moc"
