// SPDX-License-Identifier: GPL-3.0-or-later
// The search on lines that carry Modbus and LX servos as well: who is found, how soon, in which
// order the languages are tried, and what is never sent.
#include "integration/scan_help.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using base::ErrorCode;
using base::Protocol;
using std::chrono::milliseconds;
using std::chrono::seconds;
using support::BenchOptions;
using support::SimBench;

using scan_help::fast;
using scan_help::find;
using scan_help::idsOf;

namespace {
constexpr int common = 115'200; ///< every language can be met at this rate

BenchOptions at(int baud)
{
    BenchOptions options;
    options.baud = baud;
    options.servoBaud = baud;
    return options;
}

jobs::ScanSpec in(std::vector<Protocol> protocols)
{
    jobs::ScanSpec spec;
    spec.protocols = std::move(protocols);
    return spec;
}

Protocol languageOf(const base::Bytes& frame)
{
    const bool twice = frame.size() > 4 && frame[0] == frame[1];
    return twice && frame[0] == 0xFF   ? Protocol::Feetech
           : twice && frame[0] == 0x55 ? Protocol::Lx
                                       : Protocol::Modbus;
}

int framesIn(SimBench& bench, Protocol protocol)
{
    const auto& frames = bench.tap().written;
    return int(std::count_if(frames.begin(), frames.end(), [&](const base::Bytes& frame) {
        return languageOf(frame) == protocol;
    }));
}

/// The searches in the order in which they were told, repetitions left out.
using Searches = std::vector<std::pair<int, Protocol>>;

struct Told {
    Searches searches;
    std::vector<jobs::Progress> progress;

    jobs::ProgressFn listener()
    {
        return [this](const jobs::Progress& now) {
            const std::pair search(now.baud, now.protocol);
            if (searches.empty() || searches.back() != search)
                searches.push_back(search);
            progress.push_back(now);
        };
    }
};

/// "feetech 1, lx 1, modbus 9"
QString listOf(const jobs::ScanReport& report)
{
    QStringList words;
    for (const jobs::Found& found : report.found)
        words << QStringLiteral("%1 %2")
                     .arg(base::protocolName(found.servo.protocol))
                     .arg(found.servo.id);
    return words.join(QStringLiteral(", "));
}
} // namespace

Q_DECLARE_METATYPE(base::Protocol)

class TestScanLanguages : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aServoThatIsAloneIsFoundAtOnce_data();
    void aServoThatIsAloneIsFoundAtOnce();
    void listsEveryLanguageOnOneLine();
    void sweepTakesItsTimeAndNoMore_data();
    void sweepTakesItsTimeAndNoMore();
    void triesWhatCanBeMetAtTheRate_data();
    void triesWhatCanBeMetAtTheRate();
    void triesOnlyWhatIsAskedFor();
    void quickSearchesComeFirst();
    void whoSpeaksUpIsSearchedFirst();
    void countsLateRepliesForTheIdTheyName_data();
    void countsLateRepliesForTheIdTheyName();
    void suspectsTwins_data();
    void suspectsTwins();
    void lostQuestionHidesNobody_data();
    void lostQuestionHidesNobody();
    void showsAlarmsOfModbusServos();
    void listsANeighbouringRateOnce();
    void stopsWithin100Milliseconds_data();
    void stopsWithin100Milliseconds();
    void tellsThatFamiliesAreMixed_data();
    void tellsThatFamiliesAreMixed();
    void refusesWhatNoLanguageHas_data();
    void refusesWhatNoLanguageHas();
};

void TestScanLanguages::aServoThatIsAloneIsFoundAtOnce_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<QString>("name");
    QTest::newRow("LX") << QStringLiteral("lx16a@77") << Protocol::Lx << QStringLiteral("LX");
    QTest::newRow("Modbus") << QStringLiteral("smsmb@240") << Protocol::Modbus
                            << QStringLiteral("SMSMB");
}

void TestScanLanguages::aServoThatIsAloneIsFoundAtOnce()
{
    QFETCH(QString, servo);
    QFETCH(Protocol, protocol);
    SimBench bench(servo, at(common));
    const base::Duration start = bench.clock().now();
    std::vector<base::Duration> heardAt;
    Told told;
    const auto report =
        jobs::scan(bench.context(), {}, told.listener(), [&](const jobs::Found& found) {
            heardAt.push_back(bench.clock().now() - start);
            QVERIFY(found.servo.profile);
        });
    QVERIFY(report);
    QCOMPARE(report->found.size(), std::size_t{1});
    const jobs::Found& found = report->found.front();
    QCOMPARE(found.servo.protocol, protocol);
    QTEST(found.servo.profile->modelName, "name");
    QVERIFY(!found.twinsSuspected && !found.heardLate);
    // Told once, long before the IDs have been gone through.
    QCOMPARE(heardAt.size(), std::size_t{1});
    QVERIFY2(heardAt.front() < milliseconds(400),
             qPrintable(QString::number(heardAt.front().count())));
    QVERIFY(report->elapsed > seconds(5));
    QVERIFY(std::all_of(told.progress.begin(), told.progress.end(),
                        [](const jobs::Progress& p) { return p.found <= 1; }));
    QCOMPARE(told.progress.back().found, 1);
    QVERIFY(bench.onlyAsked());
}

void TestScanLanguages::listsEveryLanguageOnOneLine()
{
    SimBench bench(QStringLiteral("sts3215@1,scs15@40,lx16a@1,lx224@2,lx224hv@253,smsmb@1,smsmb@9"),
                   at(common));
    QStringList announced;
    const auto report = jobs::scan(bench.context(), {}, {}, [&](const jobs::Found& found) {
        announced << QString::number(found.servo.id);
    });
    QVERIFY(report);
    QCOMPARE(listOf(*report), QStringLiteral("feetech 1, modbus 1, lx 1, lx 2, modbus 9, "
                                             "feetech 40, lx 253"));
    QCOMPARE(announced.size(), 7);
    for (const jobs::Found& found : report->found) {
        QVERIFY(found.servo.profile);
        QCOMPARE(found.servo.profile->protocol, found.servo.protocol);
        QCOMPARE(found.servo.baud, common);
        QVERIFY(!found.twinsSuspected && !found.heardLate);
    }
    QVERIFY(!report->garbledHeard && !report->slowPassAdvised);
    QVERIFY(bench.onlyAsked());
    QVERIFY2(report->elapsed < seconds(18), qPrintable(QString::number(report->elapsed.count())));
}

void TestScanLanguages::sweepTakesItsTimeAndNoMore_data()
{
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("mostMs");
    QTest::newRow("LX") << Protocol::Lx << common << 8'000;
    QTest::newRow("Modbus") << Protocol::Modbus << common << 247 * 50;
    QTest::newRow("Modbus at 9600") << Protocol::Modbus << 9'600 << 247 * 80;
}

void TestScanLanguages::sweepTakesItsTimeAndNoMore()
{
    QFETCH(Protocol, protocol);
    QFETCH(int, baud);
    QFETCH(int, mostMs);
    BenchOptions options;
    options.baud = baud;
    SimBench bench(QStringLiteral("sts3215@1"), options); // silent in every other language
    const jobs::ScanSpec spec = in({protocol});
    const base::Duration estimate = jobs::scanEstimate(bench.context(), spec);
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY2(report->elapsed <= milliseconds(mostMs),
             qPrintable(QString::number(report->elapsed.count())));
    QVERIFY2(report->elapsed > estimate * 9 / 10 && report->elapsed < estimate * 11 / 10,
             qPrintable(QString::number(estimate.count())));
}

void TestScanLanguages::triesWhatCanBeMetAtTheRate_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("lx");
    QTest::addColumn<bool>("modbus");
    QTest::newRow("1000000") << fast << false << false;
    QTest::newRow("500000") << 500'000 << false << false;
    QTest::newRow("115200") << common << true << true;
    QTest::newRow("57600") << 57'600 << false << true;
    QTest::newRow("256000") << 256'000 << false << true;
}

void TestScanLanguages::triesWhatCanBeMetAtTheRate()
{
    QFETCH(int, baud);
    SimBench bench(QStringLiteral("sts3215@3:1000000"));
    jobs::ScanSpec spec;
    spec.lastId = 5;
    spec.bauds = {baud};
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QVERIFY(framesIn(bench, Protocol::Feetech) > 0);
    QTEST(framesIn(bench, Protocol::Lx) > 0, "lx");
    QTEST(framesIn(bench, Protocol::Modbus) > 0, "modbus");
}

void TestScanLanguages::triesOnlyWhatIsAskedFor()
{
    SimBench bench(QStringLiteral("sts3215@1,lx16a@1,smsmb@1"), at(common));
    for (const Protocol protocol : base::allProtocols) {
        bench.forgetFrames();
        const auto report = jobs::scan(bench.context(), in({protocol}));
        QVERIFY(report);
        QCOMPARE(listOf(*report), base::protocolName(protocol) + QStringLiteral(" 1"));
        QCOMPARE(framesIn(bench, protocol), int(bench.frameCount()));
    }
}

void TestScanLanguages::quickSearchesComeFirst()
{
    SimBench bench(QStringLiteral("sts3215@3:57600"));
    jobs::ScanSpec spec;
    spec.lastId = 5;
    spec.bauds = {common, 57'600};
    Told told;
    const auto report = jobs::scan(bench.context(), spec, told.listener());
    QVERIFY(report);
    const auto feetech = std::pair(57'600, Protocol::Feetech);
    const auto last = std::find(told.searches.rbegin(), told.searches.rend(), feetech);
    const Searches after(last.base(), told.searches.end());
    QCOMPARE(
        after,
        (Searches{{common, Protocol::Lx}, {common, Protocol::Modbus}, {57'600, Protocol::Modbus}}));
    QCOMPARE(told.progress.back().fraction, 1.0);
    QCOMPARE(bench.bus().baud(), fast);
}

// Several answers to the question to all collide: somebody is there, so that language goes first.
void TestScanLanguages::whoSpeaksUpIsSearchedFirst()
{
    SimBench bench(QStringLiteral("lx16a@1,lx16a@2,lx16a@3"), at(common));
    Told told;
    const auto report = jobs::scan(bench.context(), {}, told.listener());
    QVERIFY(report);
    QCOMPARE(listOf(*report), QStringLiteral("lx 1, lx 2, lx 3"));
    QCOMPARE(told.searches, (Searches{{common, Protocol::Feetech},
                                      {common, Protocol::Lx},
                                      {common, Protocol::Modbus},
                                      {common, Protocol::Lx},
                                      {common, Protocol::Feetech},
                                      {common, Protocol::Modbus}}));
}

void TestScanLanguages::countsLateRepliesForTheIdTheyName_data()
{
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<QString>("servos");
    QTest::newRow("LX") << Protocol::Lx << QStringLiteral("lx16a@5,lx16a@6,lx16a@200");
    QTest::newRow("Modbus") << Protocol::Modbus << QStringLiteral("smsmb@5,smsmb@6,smsmb@200");
}

void TestScanLanguages::countsLateRepliesForTheIdTheyName()
{
    QFETCH(Protocol, protocol);
    QFETCH(QString, servos);
    BenchOptions options = at(common);
    options.wire.adapterLatency = milliseconds(36); // beyond the patience of the sweep
    SimBench bench(servos, options);
    const auto report = jobs::scan(bench.context(), in({protocol}));
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5, 6, 200}));
    for (const jobs::Found& found : report->found) {
        QVERIFY(found.heardLate);
        QVERIFY(!found.twinsSuspected);
        QVERIFY(found.servo.profile);
    }
    QCOMPARE(report->lateReplies, 3);
    QVERIFY(report->slowPassAdvised);
}

void TestScanLanguages::suspectsTwins_data()
{
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<QString>("model");
    QTest::newRow("LX") << Protocol::Lx << QStringLiteral("LX-16A");
    QTest::newRow("Modbus") << Protocol::Modbus << QStringLiteral("SMSMB");
}

void TestScanLanguages::suspectsTwins()
{
    QFETCH(Protocol, protocol);
    QFETCH(QString, model);
    // Alike but for where their shafts stand.
    const std::vector<sim::ServoRecipe> servos{{model, 5, {}, {}, 60, {}, {}},
                                               {model, 5, {}, {}, 150, {}, {}},
                                               {model, 6, {}, {}, 60, {}, {}}};
    BenchOptions options;
    options.baud = common;
    SimBench bench(servos, options);
    const auto report = jobs::scan(bench.context(), in({protocol}));
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5, 6}));
    QVERIFY(find(*report, 5)->twinsSuspected);
    QVERIFY(!find(*report, 6)->twinsSuspected);
}

void TestScanLanguages::lostQuestionHidesNobody_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<Protocol>("protocol");
    QTest::newRow("LX") << QStringLiteral("lx16a@7") << Protocol::Lx;
    QTest::newRow("Modbus") << QStringLiteral("smsmb@7") << Protocol::Modbus;
}

void TestScanLanguages::lostQuestionHidesNobody()
{
    QFETCH(QString, servo);
    QFETCH(Protocol, protocol);
    SimBench bench(servo, at(common));
    bench.tap().onWrite = [&](const base::Bytes&) { // the first frame in this language is lost
        bench.wireConfig().faults.dropRequest = framesIn(bench, protocol) == 1 ? 1.0 : 0.0;
    };
    const base::Duration start = bench.clock().now();
    base::Duration heardAt{};
    const auto report = jobs::scan(bench.context(), {}, {}, [&](const jobs::Found&) {
        heardAt = bench.clock().now() - start;
    });
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({7}));
    QVERIFY(heardAt > base::Duration{} && heardAt < milliseconds(400));
}

void TestScanLanguages::showsAlarmsOfModbusServos()
{
    SimBench bench(QStringLiteral("smsmb@1,smsmb@2"), at(common));
    bench.poke(2, QStringLiteral("torque_switch"), 1); // a state of the status register, no fault
    bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->injectStatus(2); });
    bench.letTimePass(milliseconds(20));
    const auto report = jobs::scan(bench.context(), in({Protocol::Modbus}));
    QVERIFY(report);
    QCOMPARE(int(find(*report, 1)->servo.status), 2); // sensor
    QCOMPARE(int(find(*report, 2)->servo.status), 0);
    QCOMPARE(bench.raw(2, QStringLiteral("servo_status")), std::int64_t{16});
}

void TestScanLanguages::listsANeighbouringRateOnce()
{
    SimBench bench(QStringLiteral("smsmb@3:57600"));
    jobs::ScanSpec spec = in({Protocol::Modbus});
    spec.lastId = 5;
    spec.bauds = {56'000, 57'600};
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({3}));
    QCOMPARE(report->found.front().servo.baud, 57'600);
}

void TestScanLanguages::stopsWithin100Milliseconds_data()
{
    QTest::addColumn<int>("frame");
    for (const int frame : {1, 3, 5, 250, 300, 600, 700})
        QTest::addRow("at frame %d", frame) << frame;
}

void TestScanLanguages::stopsWithin100Milliseconds()
{
    QFETCH(int, frame);
    SimBench bench(QStringLiteral("lx16a@9,smsmb@8"), at(common));
    base::Duration requestedAt{};
    bench.tap().onWrite = [&](const base::Bytes&) {
        if (int(bench.frameCount()) != frame)
            return;
        requestedAt = bench.clock().now();
        bench.stop().request();
    };
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QVERIFY(report->stopped);
    QVERIFY(bench.clock().now() - requestedAt <= milliseconds(100));
    QCOMPARE(int(bench.frameCount()), frame);
}

void TestScanLanguages::tellsThatFamiliesAreMixed_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<bool>("mixed");
    QTest::newRow("SCS beside STS") << QStringLiteral("sts3215@1,scs15@2,scs15@3") << true;
    QTest::newRow("SCS beside SMS") << QStringLiteral("sm40blhv@1,scs15@2") << true;
    QTest::newRow("STS and SMS") << QStringLiteral("sts3215@1,sm40blhv@2") << false;
    QTest::newRow("STS and HLS") << QStringLiteral("sts3215@1,hls3606@2") << false;
    QTest::newRow("SCS alone") << QStringLiteral("scs15@1,scs0009@2") << false;
}

void TestScanLanguages::tellsThatFamiliesAreMixed()
{
    QFETCH(QString, servos);
    QFETCH(bool, mixed);
    SimBench bench(servos, at(fast));
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    const auto& notices = bench.notices();
    QCOMPARE(std::count_if(notices.begin(), notices.end(),
                           [](const device::Notice& notice) {
                               return notice.code == device::NoticeCode::FamiliesMixed;
                           }),
             mixed ? 1 : 0);
}

void TestScanLanguages::refusesWhatNoLanguageHas_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::newRow("broadcast") << 0 << 0;
    QTest::newRow("beyond") << 248 << 253;
}

void TestScanLanguages::refusesWhatNoLanguageHas()
{
    QFETCH(int, first);
    QFETCH(int, last);
    SimBench bench(QStringLiteral("smsmb@1"), at(common));
    jobs::ScanSpec spec = in({Protocol::Modbus});
    spec.firstId = first;
    spec.lastId = last;
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::BadArgument);
    QCOMPARE(bench.frameCount(), std::size_t{0});
    // Beside a language that has them they are searched.
    spec.protocols = {Protocol::Modbus, Protocol::Lx};
    QVERIFY(jobs::scan(bench.context(), spec));
    QCOMPARE(framesIn(bench, Protocol::Modbus), 0);
}

QTEST_GUILESS_MAIN(TestScanLanguages)
#include "tst_scan_languages.moc"
