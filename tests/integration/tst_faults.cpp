// SPDX-License-Identifier: GPL-3.0-or-later
// A bad line: whatever it does, a value that is shown was really read from that servo and register.
// Every reading is held against the simulator's truth, past the wire.
#include "device/reader.h"
#include "device/talk.h"
#include "jobs/scan.h"
#include "jobs/watch.h"
#include "support/sim_bench.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <map>

using base::ErrorCode;
using std::chrono::milliseconds;
using std::chrono::seconds;
using support::BenchOptions;
using support::SimBench;

namespace {
constexpr int fast = 1'000'000;

/// Registers whose values differ from servo to servo and from one another, so that a reading that
/// belongs elsewhere shows: temperature limit 50 + id, overload torque 60 + id, and so on.
void makeDistinct(SimBench& bench, const std::vector<int>& ids)
{
    for (const int id : ids) {
        bench.poke(id, QStringLiteral("max_temperature"), 50 + id);
        bench.poke(id, QStringLiteral("max_voltage"), 80 + id);
        bench.poke(id, QStringLiteral("position_p"), 20 + id);
        bench.poke(id, QStringLiteral("cw_dead_zone"), id);
        bench.poke(id, QStringLiteral("max_torque"), 900 + id);
    }
}

struct Tally {
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
Tally readRegisters(SimBench& bench, const std::vector<int>& ids, const QStringList& keys,
                    int rounds, int retries, base::Duration patience = {})
{
    std::map<int, device::Servo> servos;
    for (const int id : ids)
        servos[id].profile = support::builtInCatalog().resolve({3, 10, 0, 9, 3});
    Tally tally;
    for (int round = 0; round < rounds; ++round) {
        for (const int id : ids) {
            for (const QString& key : keys) {
                device::Servo& servo = servos[id];
                const catalog::Register& reg = *servo.profile->find(key);
                bus::Transaction read;
                read.request = protocol::Request::read(id, reg.address, reg.size);
                read.retries = retries;
                read.patience = patience;
                const auto outcome = bench.bus().transact(read);
                if (!outcome) {
                    ++tally.failed[outcome.error().code];
                    continue;
                }
                servo.image.store(reg.address, outcome->data(), {});
                ++(servo.raw(reg) == bench.raw(id, key) ? tally.right : tally.wrong);
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

    void aBadLineGivesNoWrongValue_data();
    void aBadLineGivesNoWrongValue();
    void blocksFromABadLineAreRightToo();
    void lateRepliesAreNeverTakenForAnother_data();
    void lateRepliesAreNeverTakenForAnother();
    void occasionalLateRepliesAreNeverTakenForAnother();
    void watchingABadLineShowsNothingWrong();
    void watchingThroughASlowAdapterShowsNothingWrong();
    void scanOfABadLineListsNobodyWhoIsNotThere_data();
    void scanOfABadLineListsNobodyWhoIsNotThere();
    void troublePresetIsTold();
    void echoingAdapterChangesNothing();
    void aCutLinkFailsEveryCallAfterwards();
};

void TestFaults::aBadLineGivesNoWrongValue_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<int>("retries");
    for (const int seed : {1, 2, 3}) {
        QTest::addRow("seed %d, with retries", seed) << seed << 2;
        QTest::addRow("seed %d, without", seed) << seed << 0;
    }
}

void TestFaults::aBadLineGivesNoWrongValue()
{
    QFETCH(int, seed);
    QFETCH(int, retries);
    BenchOptions options;
    options.wire.seed = std::uint64_t(seed);
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2,sts3215@3"), options);
    makeDistinct(bench, {1, 2, 3});
    sim::FaultPlan& faults = bench.wireConfig().faults;
    faults.drop = 0.05;
    faults.corrupt = 0.02;
    faults.garbage = 0.05;
    faults.truncate = 0.01;
    const Tally tally = readRegisters(bench, {1, 2, 3}, mixedKeys, 300, retries);
    QCOMPARE(tally.wrong, 0);
    QCOMPARE(tally.right + tally.failures(), 300 * 3 * 5);
    // About 8 in 100 answers fail; with two repetitions fewer than 1 in 1000 readings.
    const int expectedFailures = retries == 0 ? 360 : 3;
    QVERIFY2(tally.failures() <= expectedFailures * 2 + 5,
             qPrintable(QString::number(tally.failures())));
    QVERIFY(retries > 0 || tally.failures() > expectedFailures / 2);
    for (const auto& [code, count] : tally.failed)
        QVERIFY(code == ErrorCode::NoAnswer || code == ErrorCode::Garbled);
    const bus::Statistics statistics = bench.bus().statistics();
    QVERIFY(statistics.total.timeOuts > 0);
    QVERIFY(statistics.total.badChecks > 0);
    QVERIFY(statistics.total.noiseBytes > 0);
    QCOMPARE(statistics.total.retried > 0, retries > 0);
}

void TestFaults::blocksFromABadLineAreRightToo()
{
    BenchOptions options;
    options.wire.seed = 4;
    SimBench bench(QStringLiteral("sts3215@1,sts3250@2"), options);
    makeDistinct(bench, {1, 2});
    device::Servo servos[] = {bench.servo(1), bench.servo(2)};
    sim::FaultPlan& faults = bench.wireConfig().faults;
    faults.drop = 0.05;
    faults.corrupt = 0.02;
    faults.garbage = 0.05;
    int read = 0;
    for (int round = 0; round < 500; ++round) {
        for (device::Servo& servo : servos) {
            servo.image.clear();
            if (!device::readSettings(bench.context(), servo))
                continue;
            ++read;
            for (const QString& key : mixedKeys)
                QCOMPARE(servo.raw(key), std::optional(bench.raw(servo.id, key)));
        }
    }
    QVERIFY(read > 990);
}

void TestFaults::lateRepliesAreNeverTakenForAnother_data()
{
    QTest::addColumn<int>("latencyMs");
    QTest::addColumn<int>("patienceMs");
    QTest::addColumn<int>("retries");
    for (const int latency : {6, 16, 19}) {
        for (const int patience : {1, 5, 12}) {
            for (const int retries : {0, 2})
                QTest::addRow("latency %d, patience %d, retries %d", latency, patience, retries)
                    << latency << patience << retries;
        }
    }
}

// The trap of short deadlines: two registers of equal length in turn, every answer too late for its
// own request and just in time for the next.
void TestFaults::lateRepliesAreNeverTakenForAnother()
{
    QFETCH(int, latencyMs);
    QFETCH(int, patienceMs);
    QFETCH(int, retries);
    BenchOptions options;
    options.wire.adapterLatency = milliseconds(latencyMs);
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2"), options);
    makeDistinct(bench, {1, 2});
    const QStringList equalLength = {QStringLiteral("max_temperature"),
                                     QStringLiteral("position_p"), QStringLiteral("max_voltage")};
    const Tally tally =
        readRegisters(bench, {1, 2}, equalLength, 100, retries, milliseconds(patienceMs));
    QCOMPARE(tally.wrong, 0);
    QCOMPARE(tally.right + tally.failures(), 600);
    const Tally same =
        readRegisters(bench, {1}, equalLength, 200, retries, milliseconds(patienceMs));
    QCOMPARE(same.wrong, 0);
    QVERIFY(latencyMs < patienceMs || tally.failures() + same.failures() > 0);
}

void TestFaults::occasionalLateRepliesAreNeverTakenForAnother()
{
    BenchOptions options;
    options.wire.seed = 5;
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2"), options);
    makeDistinct(bench, {1, 2});
    bench.wireConfig().faults.late = 0.1;
    bench.wireConfig().faults.lateBy = milliseconds(30);
    const Tally tally = readRegisters(bench, {1, 2}, mixedKeys, 400, 2);
    QCOMPARE(tally.wrong, 0);
    // The bus has learnt to wait: late is not lost.
    QVERIFY2(tally.failures() < 10, qPrintable(QString::number(tally.failures())));
}

void TestFaults::watchingABadLineShowsNothingWrong()
{
    BenchOptions options;
    options.wire.seed = 6;
    options.servoBaud = fast;
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2,sts3215@3,scs15@4"), options);
    makeDistinct(bench, {1, 2, 3});
    bench.poke(4, QStringLiteral("max_temperature"), 54);
    bench.poke(4, QStringLiteral("max_torque"), 904);
    jobs::WatchSpec spec;
    for (const int id : {1, 2, 3, 4})
        spec.servos.push_back(bench.servo(id));
    spec.keys = {QStringLiteral("max_temperature"), QStringLiteral("max_torque"),
                 QStringLiteral("present_temperature")};
    spec.length = seconds(30);
    sim::FaultPlan& faults = bench.wireConfig().faults;
    faults.drop = 0.05;
    faults.corrupt = 0.02;
    faults.garbage = 0.05;
    int wrong = 0;
    const auto report = jobs::watch(bench.context(), spec, [&](const jobs::WatchRow& row) {
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

void TestFaults::watchingThroughASlowAdapterShowsNothingWrong()
{
    BenchOptions options;
    options.wire.adapterLatency = milliseconds(16);
    SimBench bench(QStringLiteral("sts3215@1,sts3215@2"), options);
    makeDistinct(bench, {1, 2});
    jobs::WatchSpec spec;
    for (const int id : {1, 2})
        spec.servos.push_back(bench.servo(id));
    // Two blocks of equal length.
    spec.keys = {QStringLiteral("max_temperature"), QStringLiteral("present_temperature")};
    spec.length = seconds(20);
    bench.bus().setPatience(milliseconds(5));
    bench.wireConfig().faults.late = 0.2;
    bench.wireConfig().faults.lateBy = milliseconds(12);
    int wrong = 0;
    const auto report = jobs::watch(bench.context(), spec, [&](const jobs::WatchRow& row) {
        wrong += row.values[0].value_or(50 + row.id) == 50 + row.id ? 0 : 1;
        wrong += row.values[1].value_or(25) == 25 ? 0 : 1;
        return base::Result<void>{};
    });
    QVERIFY(report);
    QCOMPARE(wrong, 0);
    QVERIFY(report->rows > 100);
}

void TestFaults::scanOfABadLineListsNobodyWhoIsNotThere_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 8; ++seed)
        QTest::addRow("seed %d", seed) << seed;
}

void TestFaults::scanOfABadLineListsNobodyWhoIsNotThere()
{
    QFETCH(int, seed);
    BenchOptions options;
    options.wire.seed = std::uint64_t(seed);
    options.wire.faults.corrupt = 0.02;
    options.wire.faults.garbage = 0.05;
    options.wire.adapterLatency = milliseconds(seed % 2 == 0 ? 16 : 0);
    SimBench bench(QStringLiteral("demo"), options);
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QList<int> ids;
    for (const jobs::Found& found : report->found) {
        ids.append(found.servo.id);
        // Identified means rightly identified.
        if (found.servo.profile)
            QCOMPARE(found.servo.raw(QStringLiteral("model_minor")),
                     std::optional(bench.raw(found.servo.id, QStringLiteral("model_minor"))));
    }
    QCOMPARE(ids, QList<int>({1, 2, 3, 4, 5, 6}));
}

void TestFaults::troublePresetIsTold()
{
    SimBench bench(QStringLiteral("trouble"));
    jobs::ScanSpec spec;
    spec.lastId = 20;
    spec.bauds = {fast, 500'000, 115'200};
    const auto report = jobs::scan(bench.context(), spec);
    QVERIFY(report);
    std::map<int, const jobs::Found*> found;
    for (const jobs::Found& one : report->found)
        found[one.servo.id] = &one;
    QCOMPARE(found.size(), std::size_t{5});
    QVERIFY(found.at(1)->twinsSuspected);
    QCOMPARE(found.at(2)->servo.baud, 500'000);
    QCOMPARE(found.at(3)->servo.baud, 115'200);
    QVERIFY(!found.at(4)->twinsSuspected);
    QCOMPARE(int(found.at(5)->servo.status), 32); // overload, listed all the same
    QVERIFY(bench.onlyAsked());
    QCOMPARE(bench.raw(4, QStringLiteral("lock")), std::int64_t{0}); // looking closes nothing
}

void TestFaults::echoingAdapterChangesNothing()
{
    BenchOptions options;
    options.wire.echo = true;
    options.wire.seed = 9;
    SimBench bench(QStringLiteral("sts3215@0,sts3215@1,sts3215@2"), options);
    QVERIFY(bench.bus().echoes());
    makeDistinct(bench, {0, 1, 2});
    const auto report = jobs::scan(bench.context(), {});
    QVERIFY(report);
    QCOMPARE(report->found.size(), std::size_t{3});
    for (const jobs::Found& found : report->found) {
        QCOMPARE(int(found.servo.status), 0); // the echo of PING 1 would read "voltage error"
        QVERIFY(!found.twinsSuspected && !found.heardLate);
    }
    bench.wireConfig().faults.drop = 0.05;
    bench.wireConfig().faults.corrupt = 0.02;
    const Tally tally = readRegisters(bench, {0, 1, 2}, mixedKeys, 100, 2);
    QCOMPARE(tally.wrong, 0);
    QVERIFY(tally.failures() < 10);
}

void TestFaults::aCutLinkFailsEveryCallAfterwards()
{
    SimBench bench(QStringLiteral("sts3215@1"));
    device::Servo servo = bench.servo(1);
    bench.cutLink();
    const auto read = device::readSettings(bench.context(), servo);
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::LinkLost);
    const auto scan = jobs::scan(bench.context(), {});
    QVERIFY(!scan);
    QCOMPARE(scan.error().code, ErrorCode::LinkLost);
    jobs::WatchSpec spec;
    spec.servos = {servo};
    const auto watch = jobs::watch(bench.context(), spec,
                                   [](const jobs::WatchRow&) { return base::Result<void>{}; });
    QVERIFY(!watch);
    QCOMPARE(watch.error().code, ErrorCode::LinkLost);

    bench.reconnect(fast);
    QVERIFY(device::readSettings(bench.context(), servo));
}

QTEST_GUILESS_MAIN(TestFaults)
#include "tst_faults.moc"
