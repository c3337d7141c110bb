// SPDX-License-Identifier: GPL-3.0-or-later
// How blocks become rows: joined by round, in time order, also when some blocks are missed.
#include "integration/watch_support.h"
#include "jobs/watch/watch_decoder.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using namespace watch_support;
using std::chrono::milliseconds;
using std::chrono::seconds;
using support::SimFixture;
using support::SimFixtureOptions;

class TestWatchRows : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void joinsDistantRegistersInOneRow();
    void rowsAreInTimeOrder();
    void joinsRowsWithMissedBlocks();
    void neverJoinsBlocksOfTwoRounds();
};

void TestWatchRows::joinsDistantRegistersInOneRow()
{
    SimFixture fixture(QStringLiteral("sts3215@1+ambient=25,sts3250@2+ambient=25"));
    auto spec = specFor(fixture, {1, 2}, milliseconds(20), milliseconds(200));
    spec.keys = {QStringLiteral("present_temperature"), QStringLiteral("id"),
                 QStringLiteral("torque_switch")};
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QCOMPARE(headers(report->columns),
             QStringList({QStringLiteral("present_temperature[degC]"), QStringLiteral("id[]"),
                          QStringLiteral("torque_switch[]")}));
    QVERIFY(rows.size() >= 18 && rows.size() <= 22);
    for (const jobs::WatchRow& row : rows) {
        QCOMPARE(row.values[0], std::optional<double>(25.0));
        QCOMPARE(row.values[1], std::optional<double>(row.id));
        QCOMPARE(row.values[2], std::optional<double>(0.0));
    }
}

void TestWatchRows::rowsAreInTimeOrder()
{
    SimFixtureOptions options;
    options.servoBaud = fast;
    SimFixture fixture(QStringLiteral("demo"), options);
    const auto [report, rows] =
        watch(fixture, specFor(fixture, {1, 2, 3, 4, 5, 6}, base::Duration{}, seconds(1)));
    QVERIFY(report);
    QVERIFY(rows.size() > 600);
    QVERIFY(std::is_sorted(rows.begin(), rows.end(),
                           [](const auto& a, const auto& b) { return a.at < b.at; }));
    // Nobody is starved.
    const auto share = rows.size() / 6;
    for (int id = 1; id <= 6; ++id) {
        const std::size_t own = rowsOf(rows, id).size();
        QVERIFY(own >= share - 2 && own <= share + 2);
    }
}

void TestWatchRows::joinsRowsWithMissedBlocks()
{
    SimFixtureOptions options;
    options.wire.seed = 7;
    SimFixture fixture(QStringLiteral("sts3215@1+ambient=25,sts3215@2+ambient=25"), options);
    auto spec = specFor(fixture, {1, 2}, milliseconds(100), seconds(60));
    spec.keys = {QStringLiteral("id"), QStringLiteral("present_temperature")};
    fixture.wireConfig().faults.drop = 0.3;
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QVERIFY(report->missed > 200);
    int partial = 0;
    for (const jobs::WatchRow& row : rows) {
        partial += row.values[0].has_value() != row.values[1].has_value() ? 1 : 0;
        QCOMPARE(row.answered, row.values[0].has_value() || row.values[1].has_value());
        QCOMPARE(row.values[0].value_or(row.id), double(row.id));
        QCOMPARE(row.values[1].value_or(25.0), 25.0);
    }
    QVERIFY(partial > 100);
    QVERIFY(std::is_sorted(rows.begin(), rows.end(),
                           [](const auto& a, const auto& b) { return a.at < b.at; }));
    // A block missed ends the row of its round; no row mixes two rounds.
    for (const int id : {1, 2}) {
        const Rows own = rowsOf(rows, id);
        for (std::size_t i = 1; i < own.size(); ++i)
            QVERIFY(own[i].at - own[i - 1].at > milliseconds(10));
    }
}

// Blocks as a bus may hand them over when one is missed: the row ends there, whatever follows.
void TestWatchRows::neverJoinsBlocksOfTwoRounds()
{
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2"));
    auto spec = specFor(fixture, {1, 2}, milliseconds(100), seconds(1));
    spec.keys = {QStringLiteral("id"), QStringLiteral("present_temperature")};
    auto decoder = jobs::WatchDecoder::make(spec);
    QVERIFY(decoder);
    const auto add = [&](int ms, int id, int address, std::optional<std::uint8_t> value) {
        bus::Sample sample;
        sample.id = id;
        sample.address = address;
        sample.at = milliseconds(ms);
        sample.answered = value.has_value();
        sample.endsRound = address == 63;
        if (value)
            sample.data = {*value};
        return decoder->add(sample);
    };
    const auto has = [](const jobs::WatchRow& row) {
        return std::pair(row.values[0].has_value(), row.values[1].has_value());
    };
    const auto missed = add(0, 1, 5, std::nullopt);
    QCOMPARE(missed.size(), std::size_t{1});
    QVERIFY(!missed[0].answered);
    const auto second = add(30, 1, 63, std::uint8_t{25}); // of the same round, after all
    QCOMPARE(second.size(), std::size_t{1});
    QCOMPARE(has(second[0]), std::pair(false, true));

    // The second block stays out: the row waits, and later rows of others wait behind it.
    QVERIFY(add(100, 1, 5, std::uint8_t{1}).empty());
    QVERIFY(add(101, 2, 5, std::uint8_t{2}).empty());
    QVERIFY(add(102, 2, 63, std::uint8_t{25}).empty());
    const auto next = add(200, 1, 5, std::uint8_t{1});
    QCOMPARE(next.size(), std::size_t{2});
    QCOMPARE(next[0].id, 1);
    QCOMPARE(has(next[0]), std::pair(true, false));
    QCOMPARE(next[1].id, 2);
    QCOMPARE(has(next[1]), std::pair(true, true));

    // Nobody waits for ever: a servo that a job holds does not keep the others back.
    const auto released = add(1'300, 2, 5, std::nullopt);
    QCOMPARE(released.size(), std::size_t{2});
    QCOMPARE(released[0].at, base::Duration(milliseconds(200)));
    QVERIFY(decoder->flush().empty());
}

SERVODESK_GUILESS_TEST(TestWatchRows)
#include "tst_watch_rows.moc"
