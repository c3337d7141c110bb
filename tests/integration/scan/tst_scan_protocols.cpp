// SPDX-License-Identifier: GPL-3.0-or-later
// The search on lines that carry Modbus and LX servos as well: which servos are found, how
// soon, in which order the protocols are tried, and what is never sent.
#include "integration/scan_support.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using base::ErrorCode;
using base::Protocol;
using std::chrono::milliseconds;
using std::chrono::seconds;
using support::SimFixture;
using support::SimFixtureOptions;

using scan_support::fast;
using scan_support::find;
using scan_support::idsOf;

namespace {
constexpr int commonBaud = 115'200; ///< every protocol is possible at this rate

SimFixtureOptions at(int baud)
{
    SimFixtureOptions options;
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

int framesIn(SimFixture& fixture, Protocol protocol)
{
    const auto& frames = fixture.tap().written;
    return int(std::count_if(frames.begin(), frames.end(), [&](const base::Bytes& frame) {
        return languageOf(frame) == protocol;
    }));
}

/// The searches in the order of the progress reports, without repetitions.
using Searches = std::vector<std::pair<int, Protocol>>;

struct ProgressLog {
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
    for (const jobs::FoundServo& found : report.found)
        words << QStringLiteral("%1 %2")
                     .arg(base::protocolName(found.servo.protocol))
                     .arg(found.servo.id);
    return words.join(QStringLiteral(", "));
}
} // namespace

class TestScanProtocols : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aSingleServoIsFoundAtOnce_data();
    void aSingleServoIsFoundAtOnce();
    void listsEveryProtocolOnOneBus();
    void fullScanTakesTheExpectedTime_data();
    void fullScanTakesTheExpectedTime();
    void triesProtocolsPossibleAtTheRate_data();
    void triesProtocolsPossibleAtTheRate();
    void triesOnlyRequestedProtocols();
    void quickScansComeFirst();
    void respondingProtocolIsScannedFirst();
    void lateRepliesAreCountedByTheirId_data();
    void lateRepliesAreCountedByTheirId();
    void suspectsDuplicateIds_data();
    void suspectsDuplicateIds();
    void lostRequestHidesNoServo_data();
    void lostRequestHidesNoServo();
    void showsAlarmsOfModbusServos();
    void listsANeighboringRateOnce();
    void stopsWithin100Milliseconds_data();
    void stopsWithin100Milliseconds();
    void reportsMixedFamilies_data();
    void reportsMixedFamilies();
    void refusesImpossibleIds_data();
    void refusesImpossibleIds();
};

void TestScanProtocols::aSingleServoIsFoundAtOnce_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<QString>("name");
    QTest::newRow("LX") << QStringLiteral("lx16a@77") << Protocol::Lx << QStringLiteral("LX");
    QTest::newRow("Modbus") << QStringLiteral("smsmb@240") << Protocol::Modbus
                            << QStringLiteral("SMSMB");
}

void TestScanProtocols::aSingleServoIsFoundAtOnce()
{
    QFETCH(QString, servo);
    QFETCH(Protocol, protocol);
    SimFixture fixture(servo, at(commonBaud));
    const base::Duration start = fixture.clock().now();
    std::vector<base::Duration> heardAt;
    ProgressLog log;
    const auto report =
        jobs::scan(fixture.context(), {}, log.listener(), [&](const jobs::FoundServo& found) {
            heardAt.push_back(fixture.clock().now() - start);
            QVERIFY(found.servo.profile);
        });
    QVERIFY(report);
    QCOMPARE(report->found.size(), std::size_t{1});
    const jobs::FoundServo& found = report->found.front();
    QCOMPARE(found.servo.protocol, protocol);
    QTEST(found.servo.profile->modelName, "name");
    QVERIFY(!found.duplicateSuspected && !found.lateReplySeen);
    // Told once, long before the IDs have been gone through.
    QCOMPARE(heardAt.size(), std::size_t{1});
    QVERIFY2(heardAt.front() < milliseconds(400),
             qPrintable(QString::number(heardAt.front().count())));
    QVERIFY(report->elapsed > seconds(5));
    QVERIFY(std::all_of(log.progress.begin(), log.progress.end(),
                        [](const jobs::Progress& p) { return p.found <= 1; }));
    QCOMPARE(log.progress.back().found, 1);
    QVERIFY(fixture.onlyReadsSent());
}

void TestScanProtocols::listsEveryProtocolOnOneBus()
{
    SimFixture fixture(
        QStringLiteral("sts3215@1,scs15@40,lx16a@1,lx224@2,lx224hv@253,smsmb@1,smsmb@9"),
        at(commonBaud));
    QStringList announced;
    const auto report = jobs::scan(fixture.context(), {}, {}, [&](const jobs::FoundServo& found) {
        announced << QString::number(found.servo.id);
    });
    QVERIFY(report);
    QCOMPARE(listOf(*report), QStringLiteral("feetech 1, modbus 1, lx 1, lx 2, modbus 9, "
                                             "feetech 40, lx 253"));
    QCOMPARE(announced.size(), 7);
    for (const jobs::FoundServo& found : report->found) {
        QVERIFY(found.servo.profile);
        QCOMPARE(found.servo.profile->protocol, found.servo.protocol);
        QCOMPARE(found.servo.baud, commonBaud);
        QVERIFY(!found.duplicateSuspected && !found.lateReplySeen);
    }
    QVERIFY(!report->hasGarbledReplies && !report->slowPassAdvised);
    QVERIFY(fixture.onlyReadsSent());
    QVERIFY2(report->elapsed < seconds(18), qPrintable(QString::number(report->elapsed.count())));
}

void TestScanProtocols::fullScanTakesTheExpectedTime_data()
{
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("maxMs");
    QTest::newRow("LX") << Protocol::Lx << commonBaud << 8'000;
    QTest::newRow("Modbus") << Protocol::Modbus << commonBaud << 247 * 50;
    QTest::newRow("Modbus at 9600") << Protocol::Modbus << 9'600 << 247 * 80;
}

void TestScanProtocols::fullScanTakesTheExpectedTime()
{
    QFETCH(Protocol, protocol);
    QFETCH(int, baud);
    QFETCH(int, maxMs);
    SimFixtureOptions options;
    options.baud = baud;
    SimFixture fixture(QStringLiteral("sts3215@1"), options); // silent in every other protocol
    const jobs::ScanSpec spec = in({protocol});
    const base::Duration estimate = jobs::estimateScanTime(fixture.context(), spec);
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY2(report->elapsed <= milliseconds(maxMs),
             qPrintable(QString::number(report->elapsed.count())));
    QVERIFY2(report->elapsed > estimate * 9 / 10 && report->elapsed < estimate * 11 / 10,
             qPrintable(QString::number(estimate.count())));
}

void TestScanProtocols::triesProtocolsPossibleAtTheRate_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("lx");
    QTest::addColumn<bool>("modbus");
    QTest::newRow("1000000") << fast << false << false;
    QTest::newRow("500000") << 500'000 << false << false;
    QTest::newRow("115200") << commonBaud << true << true;
    QTest::newRow("57600") << 57'600 << false << true;
    QTest::newRow("256000") << 256'000 << false << true;
}

void TestScanProtocols::triesProtocolsPossibleAtTheRate()
{
    QFETCH(int, baud);
    SimFixture fixture(QStringLiteral("sts3215@3:1000000"));
    jobs::ScanSpec spec;
    spec.lastId = 5;
    spec.bauds = {baud};
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QVERIFY(framesIn(fixture, Protocol::Feetech) > 0);
    QTEST(framesIn(fixture, Protocol::Lx) > 0, "lx");
    QTEST(framesIn(fixture, Protocol::Modbus) > 0, "modbus");
}

void TestScanProtocols::triesOnlyRequestedProtocols()
{
    SimFixture fixture(QStringLiteral("sts3215@1,lx16a@1,smsmb@1"), at(commonBaud));
    for (const Protocol protocol : base::allProtocols) {
        fixture.clearFrames();
        const auto report = jobs::scan(fixture.context(), in({protocol}));
        QVERIFY(report);
        QCOMPARE(listOf(*report), base::protocolName(protocol) + QStringLiteral(" 1"));
        QCOMPARE(framesIn(fixture, protocol), int(fixture.frameCount()));
    }
}

void TestScanProtocols::quickScansComeFirst()
{
    SimFixture fixture(QStringLiteral("sts3215@3:57600"));
    jobs::ScanSpec spec;
    spec.lastId = 5;
    spec.bauds = {commonBaud, 57'600};
    ProgressLog log;
    const auto report = jobs::scan(fixture.context(), spec, log.listener());
    QVERIFY(report);
    const auto feetech = std::pair(57'600, Protocol::Feetech);
    const auto last = std::find(log.searches.rbegin(), log.searches.rend(), feetech);
    const Searches after(last.base(), log.searches.end());
    QCOMPARE(after, (Searches{{commonBaud, Protocol::Lx},
                              {commonBaud, Protocol::Modbus},
                              {57'600, Protocol::Modbus}}));
    QCOMPARE(log.progress.back().fraction, 1.0);
    QCOMPARE(fixture.bus().baud(), fast);
}

// Several replies to the broadcast collide: there are servos, so that protocol goes first.
void TestScanProtocols::respondingProtocolIsScannedFirst()
{
    SimFixture fixture(QStringLiteral("lx16a@1,lx16a@2,lx16a@3"), at(commonBaud));
    ProgressLog log;
    const auto report = jobs::scan(fixture.context(), {}, log.listener());
    QVERIFY(report);
    QCOMPARE(listOf(*report), QStringLiteral("lx 1, lx 2, lx 3"));
    QCOMPARE(log.searches, (Searches{{commonBaud, Protocol::Feetech},
                                     {commonBaud, Protocol::Lx},
                                     {commonBaud, Protocol::Modbus},
                                     {commonBaud, Protocol::Lx},
                                     {commonBaud, Protocol::Feetech},
                                     {commonBaud, Protocol::Modbus}}));
}

void TestScanProtocols::lateRepliesAreCountedByTheirId_data()
{
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<QString>("servos");
    QTest::newRow("LX") << Protocol::Lx << QStringLiteral("lx16a@5,lx16a@6,lx16a@200");
    QTest::newRow("Modbus") << Protocol::Modbus << QStringLiteral("smsmb@5,smsmb@6,smsmb@200");
}

void TestScanProtocols::lateRepliesAreCountedByTheirId()
{
    QFETCH(Protocol, protocol);
    QFETCH(QString, servos);
    SimFixtureOptions options = at(commonBaud);
    options.wire.adapterLatency = milliseconds(36); // beyond the patience of the sweep
    SimFixture fixture(servos, options);
    const auto report = jobs::scan(fixture.context(), in({protocol}));
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5, 6, 200}));
    for (const jobs::FoundServo& found : report->found) {
        QVERIFY(found.lateReplySeen);
        QVERIFY(!found.duplicateSuspected);
        QVERIFY(found.servo.profile);
    }
    QCOMPARE(report->lateReplies, 3);
    QVERIFY(report->slowPassAdvised);
}

void TestScanProtocols::suspectsDuplicateIds_data()
{
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<QString>("model");
    QTest::newRow("LX") << Protocol::Lx << QStringLiteral("LX-16A");
    QTest::newRow("Modbus") << Protocol::Modbus << QStringLiteral("SMSMB");
}

void TestScanProtocols::suspectsDuplicateIds()
{
    QFETCH(Protocol, protocol);
    QFETCH(QString, model);
    // Alike but for where their shafts stand.
    const std::vector<sim::ServoSpec> servos{{model, 5, {}, {}, 60, {}, {}},
                                             {model, 5, {}, {}, 150, {}, {}},
                                             {model, 6, {}, {}, 60, {}, {}}};
    SimFixtureOptions options;
    options.baud = commonBaud;
    SimFixture fixture(servos, options);
    const auto report = jobs::scan(fixture.context(), in({protocol}));
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5, 6}));
    QVERIFY(find(*report, 5)->duplicateSuspected);
    QVERIFY(!find(*report, 6)->duplicateSuspected);
}

void TestScanProtocols::lostRequestHidesNoServo_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<Protocol>("protocol");
    QTest::newRow("LX") << QStringLiteral("lx16a@7") << Protocol::Lx;
    QTest::newRow("Modbus") << QStringLiteral("smsmb@7") << Protocol::Modbus;
}

void TestScanProtocols::lostRequestHidesNoServo()
{
    QFETCH(QString, servo);
    QFETCH(Protocol, protocol);
    SimFixture fixture(servo, at(commonBaud));
    fixture.tap().onWrite = [&](const base::Bytes&) { // the first frame in this protocol is lost
        fixture.wireConfig().faults.dropRequest = framesIn(fixture, protocol) == 1 ? 1.0 : 0.0;
    };
    const base::Duration start = fixture.clock().now();
    base::Duration heardAt{};
    const auto report = jobs::scan(fixture.context(), {}, {}, [&](const jobs::FoundServo&) {
        heardAt = fixture.clock().now() - start;
    });
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({7}));
    QVERIFY(heardAt > base::Duration{} && heardAt < milliseconds(400));
}

void TestScanProtocols::showsAlarmsOfModbusServos()
{
    SimFixture fixture(QStringLiteral("smsmb@1,smsmb@2"), at(commonBaud));
    fixture.poke(2, QStringLiteral("torque_switch"), 1); // a state of the status register, no fault
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->injectStatus(2); });
    fixture.runFor(milliseconds(20));
    const auto report = jobs::scan(fixture.context(), in({Protocol::Modbus}));
    QVERIFY(report);
    QCOMPARE(int(find(*report, 1)->servo.status), 2); // sensor
    QCOMPARE(int(find(*report, 2)->servo.status), 0);
    QCOMPARE(fixture.raw(2, QStringLiteral("servo_status")), std::int64_t{16});
}

void TestScanProtocols::listsANeighboringRateOnce()
{
    SimFixture fixture(QStringLiteral("smsmb@3:57600"));
    jobs::ScanSpec spec = in({Protocol::Modbus});
    spec.lastId = 5;
    spec.bauds = {56'000, 57'600};
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({3}));
    QCOMPARE(report->found.front().servo.baud, 57'600);
}

void TestScanProtocols::stopsWithin100Milliseconds_data()
{
    QTest::addColumn<int>("frame");
    for (const int frame : {1, 3, 5, 250, 300, 600, 700})
        QTest::addRow("at frame %d", frame) << frame;
}

void TestScanProtocols::stopsWithin100Milliseconds()
{
    QFETCH(int, frame);
    SimFixture fixture(QStringLiteral("lx16a@9,smsmb@8"), at(commonBaud));
    base::Duration requestedAt{};
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (int(fixture.frameCount()) != frame)
            return;
        requestedAt = fixture.clock().now();
        fixture.stop().request();
    };
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QVERIFY(report->stopped);
    QVERIFY(fixture.clock().now() - requestedAt <= milliseconds(100));
    QCOMPARE(int(fixture.frameCount()), frame);
}

void TestScanProtocols::reportsMixedFamilies_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<bool>("mixed");
    QTest::newRow("SCS beside STS") << QStringLiteral("sts3215@1,scs15@2,scs15@3") << true;
    QTest::newRow("SCS beside SMS") << QStringLiteral("sm40blhv@1,scs15@2") << true;
    QTest::newRow("STS and SMS") << QStringLiteral("sts3215@1,sm40blhv@2") << false;
    QTest::newRow("STS and HLS") << QStringLiteral("sts3215@1,hls3606@2") << false;
    QTest::newRow("SCS alone") << QStringLiteral("scs15@1,scs0009@2") << false;
}

void TestScanProtocols::reportsMixedFamilies()
{
    QFETCH(QString, servos);
    QFETCH(bool, mixed);
    SimFixture fixture(servos, at(fast));
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    const auto& notices = fixture.notices();
    QCOMPARE(std::count_if(notices.begin(), notices.end(),
                           [](const device::Notice& notice) {
                               return notice.code == device::NoticeCode::MixedFamilies;
                           }),
             mixed ? 1 : 0);
}

void TestScanProtocols::refusesImpossibleIds_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::newRow("broadcast") << 0 << 0;
    QTest::newRow("beyond") << 248 << 253;
}

void TestScanProtocols::refusesImpossibleIds()
{
    QFETCH(int, first);
    QFETCH(int, last);
    SimFixture fixture(QStringLiteral("smsmb@1"), at(commonBaud));
    jobs::ScanSpec spec = in({Protocol::Modbus});
    spec.firstId = first;
    spec.lastId = last;
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::BadArgument);
    QCOMPARE(fixture.frameCount(), std::size_t{0});
    // Together with a protocol that has them they are searched.
    spec.protocols = {Protocol::Modbus, Protocol::Lx};
    QVERIFY(jobs::scan(fixture.context(), spec));
    QCOMPARE(framesIn(fixture, Protocol::Modbus), 0);
}

SERVODESK_GUILESS_TEST(TestScanProtocols)
#include "tst_scan_protocols.moc"
