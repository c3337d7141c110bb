// SPDX-License-Identifier: GPL-3.0-or-later
// A bad line: whatever it does, a value that is shown was really read from that servo and register.
// Every reading is held against the simulator's truth, past the wire.
#include "device/reader.h"
#include "device/transactions.h"
#include "jobs/scan/scan.h"
#include "jobs/watch/watch.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <map>

using base::ErrorCode;
using std::chrono::milliseconds;
using std::chrono::seconds;
using support::SimFixture;
using support::SimFixtureOptions;

namespace {
constexpr int fast = 1'000'000;

/// Registers whose values differ from servo to servo and from one another, so that a reading that
/// belongs elsewhere shows: temperature limit 50 + id, overload torque 60 + id, and so on.
void setDistinctValues(SimFixture& fixture, const std::vector<int>& ids)
{
    for (const int id : ids) {
        fixture.poke(id, QStringLiteral("max_temperature"), 50 + id);
        fixture.poke(id, QStringLiteral("max_voltage"), 80 + id);
        fixture.poke(id, QStringLiteral("position_p"), 20 + id);
        fixture.poke(id, QStringLiteral("cw_dead_zone"), id);
        fixture.poke(id, QStringLiteral("max_torque"), 900 + id);
    }
}

struct CampaignTotals {
    int right = 0;
    int wrong = 0;
    std::map<ErrorCode, int> failed;
    int failures() const
    {
        int sum = 0;
        for (const auto& [code, count] : failed)
            sum += count;
        return sum;
    }
};

/// Reads one register after the other, of one servo after the other.
CampaignTotals readRegisters(SimFixture& fixture, const std::vector<int>& ids,
                             const QStringList& keys, int rounds, int retries,
                             base::Duration timeout = {})
{
    std::map<int, device::Servo> servos;
    for (const int id : ids)
        servos[id].profile = support::builtInCatalog().resolve({3, 10, 0, 9, 3});
    CampaignTotals tally;
    for (int round = 0; round < rounds; ++round) {
        for (const int id : ids) {
            for (const QString& key : keys) {
                device::Servo& servo = servos[id];
                const catalog::Register& reg = *servo.profile->find(key);
                bus::Transaction read;
                read.request = protocol::Request::read(id, reg.address, reg.size);
                read.retries = retries;
                read.timeout = timeout;
                const auto outcome = fixture.bus().transact(read);
                if (!outcome) {
                    ++tally.failed[outcome.error().code];
                    continue;
                }
                servo.image.store(reg.address, outcome->data(), {});
                ++(servo.raw(reg) == fixture.raw(id, key) ? tally.right : tally.wrong);
            }
        }
    }
    return tally;
}

const QStringList mixedKeys = {QStringLiteral("max_temperature"), QStringLiteral("max_voltage"),
                               QStringLiteral("position_p"), QStringLiteral("cw_dead_zone"),
                               QStringLiteral("max_torque")};
} // namespace

class TestFaults : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aNoisyLineGivesNoWrongValue_data();
    void aNoisyLineGivesNoWrongValue();
    void blocksFromANoisyLineAreCorrect();
    void lateRepliesAreNeverMismatched_data();
    void lateRepliesAreNeverMismatched();
    void occasionalLateRepliesAreNeverMismatched();
    void watchingANoisyLineShowsNoWrongValue();
    void watchingThroughASlowAdapterShowsNoWrongValue();
    void scanOfANoisyLineListsNoAbsentServo_data();
    void scanOfANoisyLineListsNoAbsentServo();
    void troublePresetIsReported();
    void echoingAdapterChangesNothing();
    void aLostLinkFailsEveryLaterCall();
};

void TestFaults::aNoisyLineGivesNoWrongValue_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<int>("retries");
    for (const int seed : {1, 2, 3}) {
        QTest::addRow("seed %d, with retries", seed) << seed << 2;
        QTest::addRow("seed %d, without", seed) << seed << 0;
    }
}

void TestFaults::aNoisyLineGivesNoWrongValue()
{
    QFETCH(int, seed);
    QFETCH(int, retries);
    SimFixtureOptions options;
    options.wire.seed = std::uint64_t(seed);
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2,sts3215@3"), options);
    setDistinctValues(fixture, {1, 2, 3});
    sim::FaultPlan& faults = fixture.wireConfig().faults;
    faults.drop = 0.05;
    faults.corrupt = 0.02;
    faults.garbage = 0.05;
    faults.truncate = 0.01;
    const CampaignTotals tally = readRegisters(fixture, {1, 2, 3}, mixedKeys, 300, retries);
    QCOMPARE(tally.wrong, 0);
    QCOMPARE(tally.right + tally.failures(), 300 * 3 * 5);
    // About 8 in 100 answers fail; with two repetitions fewer than 1 in 1000 readings.
    const int expectedFailures = retries == 0 ? 360 : 3;
    QVERIFY2(tally.failures() <= expectedFailures * 2 + 5,
             qPrintable(QString::number(tally.failures())));
    QVERIFY(retries > 0 || tally.failures() > expectedFailures / 2);
    for (const auto& [code, count] : tally.failed)
        QVERIFY(code == ErrorCode::NoReply || code == ErrorCode::Garbled);
    const bus::Statistics statistics = fixture.bus().statistics();
    QVERIFY(statistics.total.timeouts > 0);
    QVERIFY(statistics.total.badChecksums > 0);
    QVERIFY(statistics.total.noiseBytes > 0);
    QCOMPARE(statistics.total.retried > 0, retries > 0);
}

void TestFaults::blocksFromANoisyLineAreCorrect()
{
    SimFixtureOptions options;
    options.wire.seed = 4;
    SimFixture fixture(QStringLiteral("sts3215@1,sts3250@2"), options);
    setDistinctValues(fixture, {1, 2});
    device::Servo servos[] = {fixture.servo(1), fixture.servo(2)};
    sim::FaultPlan& faults = fixture.wireConfig().faults;
    faults.drop = 0.05;
    faults.corrupt = 0.02;
    faults.garbage = 0.05;
    int read = 0;
    for (int round = 0; round < 500; ++round) {
        for (device::Servo& servo : servos) {
            servo.image.clear();
            if (!device::readSettings(fixture.context(), servo))
                continue;
            ++read;
            for (const QString& key : mixedKeys)
                QCOMPARE(servo.raw(key), std::optional(fixture.raw(servo.id, key)));
        }
    }
    QVERIFY(read > 990);
}

void TestFaults::lateRepliesAreNeverMismatched_data()
{
    QTest::addColumn<int>("latencyMs");
    QTest::addColumn<int>("timeoutMs");
    QTest::addColumn<int>("retries");
    for (const int latency : {6, 16, 19}) {
        for (const int timeout : {1, 5, 12}) {
            for (const int retries : {0, 2})
                QTest::addRow("latency %d, patience %d, retries %d", latency, timeout, retries)
                    << latency << timeout << retries;
        }
    }
}

// The trap of short deadlines: two registers of equal length in turn, every answer too late for its
// own request and just in time for the next.
void TestFaults::lateRepliesAreNeverMismatched()
{
    QFETCH(int, latencyMs);
    QFETCH(int, timeoutMs);
    QFETCH(int, retries);
    SimFixtureOptions options;
    options.wire.adapterLatency = milliseconds(latencyMs);
    SimFixture fixture(QStringLiteral("sts3215@1+ambient=25,sts3215@2+ambient=25"), options);
    setDistinctValues(fixture, {1, 2});
    const QStringList equalLength = {QStringLiteral("max_temperature"),
                                     QStringLiteral("position_p"), QStringLiteral("max_voltage")};
    const CampaignTotals tally =
        readRegisters(fixture, {1, 2}, equalLength, 100, retries, milliseconds(timeoutMs));
    QCOMPARE(tally.wrong, 0);
    QCOMPARE(tally.right + tally.failures(), 600);
    const CampaignTotals same =
        readRegisters(fixture, {1}, equalLength, 200, retries, milliseconds(timeoutMs));
    QCOMPARE(same.wrong, 0);
    QVERIFY(latencyMs < timeoutMs || tally.failures() + same.failures() > 0);
}

void TestFaults::occasionalLateRepliesAreNeverMismatched()
{
    SimFixtureOptions options;
    options.wire.seed = 5;
    SimFixture fixture(QStringLiteral("sts3215@1+ambient=25,sts3215@2+ambient=25"), options);
    setDistinctValues(fixture, {1, 2});
    fixture.wireConfig().faults.late = 0.1;
    fixture.wireConfig().faults.lateBy = milliseconds(30);
    const CampaignTotals tally = readRegisters(fixture, {1, 2}, mixedKeys, 400, 2);
    QCOMPARE(tally.wrong, 0);
    // The bus has learnt to wait: late is not lost.
    QVERIFY2(tally.failures() < 10, qPrintable(QString::number(tally.failures())));
}

void TestFaults::watchingANoisyLineShowsNoWrongValue()
{
    SimFixtureOptions options;
    options.wire.seed = 6;
    options.servoBaud = fast;
    SimFixture fixture(
        QStringLiteral(
            "sts3215@1+ambient=25,sts3215@2+ambient=25,sts3215@3+ambient=25,scs15@4+ambient=25"),
        options);
    setDistinctValues(fixture, {1, 2, 3});
    fixture.poke(4, QStringLiteral("max_temperature"), 54);
    fixture.poke(4, QStringLiteral("max_torque"), 904);
    jobs::WatchSpec spec;
    for (const int id : {1, 2, 3, 4})
        spec.servos.push_back(fixture.servo(id));
    spec.keys = {QStringLiteral("max_temperature"), QStringLiteral("max_torque"),
                 QStringLiteral("present_temperature")};
    spec.length = seconds(30);
    sim::FaultPlan& faults = fixture.wireConfig().faults;
    faults.drop = 0.05;
    faults.corrupt = 0.02;
    faults.garbage = 0.05;
    int wrong = 0;
    const auto report = jobs::watch(fixture.context(), spec, [&](const jobs::WatchRow& row) {
        wrong += row.values[0].value_or(50 + row.id) == 50 + row.id ? 0 : 1;
        wrong += std::abs(row.values[1].value_or(90 + 0.1 * row.id) - (90 + 0.1 * row.id)) < 1e-6
                     ? 0
                     : 1;
        wrong += row.values[2].value_or(25) == 25 ? 0 : 1;
        return base::Result<void>{};
    });
    QVERIFY(report);
    QCOMPARE(wrong, 0);
    QVERIFY(report->rows > 5'000);
    QVERIFY(report->missed > 100);
}

void TestFaults::watchingThroughASlowAdapterShowsNoWrongValue()
{
    SimFixtureOptions options;
    options.wire.adapterLatency = milliseconds(16);
    SimFixture fixture(QStringLiteral("sts3215@1+ambient=25,sts3215@2+ambient=25"), options);
    setDistinctValues(fixture, {1, 2});
    jobs::WatchSpec spec;
    for (const int id : {1, 2})
        spec.servos.push_back(fixture.servo(id));
    // Two blocks of equal length.
    spec.keys = {QStringLiteral("max_temperature"), QStringLiteral("present_temperature")};
    spec.length = seconds(20);
    fixture.bus().setTimeout(milliseconds(5));
    fixture.wireConfig().faults.late = 0.2;
    fixture.wireConfig().faults.lateBy = milliseconds(12);
    int wrong = 0;
    const auto report = jobs::watch(fixture.context(), spec, [&](const jobs::WatchRow& row) {
        wrong += row.values[0].value_or(50 + row.id) == 50 + row.id ? 0 : 1;
        wrong += row.values[1].value_or(25) == 25 ? 0 : 1;
        return base::Result<void>{};
    });
    QVERIFY(report);
    QCOMPARE(wrong, 0);
    QVERIFY(report->rows > 100);
}

void TestFaults::scanOfANoisyLineListsNoAbsentServo_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 8; ++seed)
        QTest::addRow("seed %d", seed) << seed;
}

void TestFaults::scanOfANoisyLineListsNoAbsentServo()
{
    QFETCH(int, seed);
    SimFixtureOptions options;
    options.wire.seed = std::uint64_t(seed);
    options.wire.faults.corrupt = 0.02;
    options.wire.faults.garbage = 0.05;
    options.wire.adapterLatency = milliseconds(seed % 2 == 0 ? 16 : 0);
    SimFixture fixture(QStringLiteral("demo"), options);
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QList<int> ids;
    for (const jobs::FoundServo& found : report->found) {
        ids.append(found.servo.id);
        // Identified means rightly identified.
        if (found.servo.profile)
            QCOMPARE(found.servo.raw(QStringLiteral("model_minor")),
                     std::optional(fixture.raw(found.servo.id, QStringLiteral("model_minor"))));
    }
    QCOMPARE(ids, QList<int>({1, 2, 3, 4, 5, 6}));
}

void TestFaults::troublePresetIsReported()
{
    SimFixture fixture(QStringLiteral("trouble"));
    jobs::ScanSpec spec;
    spec.lastId = 20;
    spec.bauds = {fast, 500'000, 115'200};
    const auto report = jobs::scan(fixture.context(), spec);
    QVERIFY(report);
    std::map<int, const jobs::FoundServo*> found;
    for (const jobs::FoundServo& one : report->found)
        found[one.servo.id] = &one;
    QCOMPARE(found.size(), std::size_t{5});
    QVERIFY(found.at(1)->duplicateSuspected);
    QCOMPARE(found.at(2)->servo.baud, 500'000);
    QCOMPARE(found.at(3)->servo.baud, 115'200);
    QVERIFY(!found.at(4)->duplicateSuspected);
    QCOMPARE(int(found.at(5)->servo.status), 32); // overload, listed all the same
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(fixture.raw(4, QStringLiteral("lock")), std::int64_t{0}); // looking closes nothing
}

void TestFaults::echoingAdapterChangesNothing()
{
    SimFixtureOptions options;
    options.wire.echo = true;
    options.wire.seed = 9;
    SimFixture fixture(QStringLiteral("sts3215@0,sts3215@1,sts3215@2"), options);
    QVERIFY(fixture.bus().hasEcho());
    setDistinctValues(fixture, {0, 1, 2});
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(report->found.size(), std::size_t{3});
    for (const jobs::FoundServo& found : report->found) {
        QCOMPARE(int(found.servo.status), 0); // the echo of PING 1 would read "voltage error"
        QVERIFY(!found.duplicateSuspected && !found.lateReplySeen);
    }
    fixture.wireConfig().faults.drop = 0.05;
    fixture.wireConfig().faults.corrupt = 0.02;
    const CampaignTotals tally = readRegisters(fixture, {0, 1, 2}, mixedKeys, 100, 2);
    QCOMPARE(tally.wrong, 0);
    QVERIFY(tally.failures() < 10);
}

void TestFaults::aLostLinkFailsEveryLaterCall()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    fixture.cutLink();
    const auto read = device::readSettings(fixture.context(), servo);
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::LinkLost);
    const auto scan = jobs::scan(fixture.context(), {});
    QVERIFY(!scan);
    QCOMPARE(scan.error().code, ErrorCode::LinkLost);
    jobs::WatchSpec spec;
    spec.servos = {servo};
    const auto watch = jobs::watch(fixture.context(), spec,
                                   [](const jobs::WatchRow&) { return base::Result<void>{}; });
    QVERIFY(!watch);
    QCOMPARE(watch.error().code, ErrorCode::LinkLost);

    fixture.reconnect(fast);
    QVERIFY(device::readSettings(fixture.context(), servo));
}

SERVODESK_GUILESS_TEST(TestFaults)
#include "tst_faults.moc"
