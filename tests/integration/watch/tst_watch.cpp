// SPDX-License-Identifier: GPL-3.0-or-later
// Watching servos through the poll plan: columns, units, rates, and what happens when answers stay
// out. Values are held against what the simulated servos really do.
#include "device/reader.h"
#include "integration/watch_support.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <cmath>

using base::ErrorCode;
using std::chrono::milliseconds;
using std::chrono::seconds;
using support::SimFixture;
using support::SimFixtureOptions;

using namespace watch_support;

class TestWatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void watchesTheFeedbackBlock();
    void unmeasuredIsNotZero();
    void eachUnitHasItsColumn();
    void readsAtTheRequestedRate_data();
    void readsAtTheRequestedRate();
    void showsTheServosValues();
    void speedMatchesTheDistance_data();
    void speedMatchesTheDistance();
    void usesSyncReadWhereSupported();
    void countsMissedReadings();
    void stopsWithin100Milliseconds();
    void endsWhenTheReceiverFails();
    void endsWhenTheLinkIsCut();
    void refusesUnreadableRegisters();
    void keepsUpForAnHour();
};

void TestWatch::watchesTheFeedbackBlock()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    const auto spec = specFor(fixture, {1}, milliseconds(20), seconds(1));
    QCOMPARE(
        headers(jobs::watchColumns(spec)),
        QStringList({QStringLiteral("present_position[deg]"), QStringLiteral("present_speed[rpm]"),
                     QStringLiteral("present_load[%]"), QStringLiteral("present_voltage[V]"),
                     QStringLiteral("present_temperature[degC]"),
                     QStringLiteral("async_write_flag[]"), QStringLiteral("servo_status[]"),
                     QStringLiteral("moving[]"), QStringLiteral("active_goal_position[deg]"),
                     QStringLiteral("present_current[mA]")}));
    fixture.clearFrames();
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QVERIFY(fixture.onlyReadsSent());
    QCOMPARE(report->columns, jobs::watchColumns(spec));
    QCOMPARE(report->rows, rows.size());
    QCOMPARE(report->missed, std::uint64_t{0});
    // One block read a round: 56 to 70 at once.
    QCOMPARE(fixture.frameCount(), rows.size());
    for (const jobs::WatchRow& row : rows)
        QVERIFY(std::all_of(row.values.begin(), row.values.end(),
                            [](const auto& value) { return value.has_value(); }));
}

void TestWatch::unmeasuredIsNotZero()
{
    SimFixture fixture(QStringLiteral("sts3215@1,scs15@2,sts3215@3"), {fast, fast, {}});
    fixture.poke(3, QStringLiteral("phase"), fixture.raw(3, QStringLiteral("phase")) | 32);
    const auto spec = specFor(fixture, {1, 2, 3}, milliseconds(20), milliseconds(200));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    const std::size_t current = column(report->columns, QStringLiteral("present_current"));
    for (const jobs::WatchRow& row : rows)
        QCOMPARE(row.values[current].has_value(), row.id == 1);
    // Nobody here has a sensor: there is no such column.
    const auto blind = specFor(fixture, {2, 3}, milliseconds(20), milliseconds(200));
    QVERIFY(!headers(jobs::watchColumns(blind)).contains(QStringLiteral("present_current[mA]")));
}

void TestWatch::eachUnitHasItsColumn()
{
    SimFixtureOptions options;
    options.servoBaud = fast;
    SimFixture fixture(QStringLiteral("sts3215@1,scs45@2,sts3250@3"), options);
    auto spec = specFor(fixture, {1, 2, 3}, milliseconds(20), milliseconds(100));
    spec.keys = {QStringLiteral("present_voltage"), QStringLiteral("present_speed"),
                 QStringLiteral("goal_time")};
    const auto columns = jobs::watchColumns(spec);
    QCOMPARE(
        headers(columns),
        QStringList({QStringLiteral("present_voltage[V]"), QStringLiteral("present_speed[rpm]"),
                     QStringLiteral("present_speed[step/s]"), QStringLiteral("goal_time[ms]")}));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QVERIFY(!rows.empty());
    for (const jobs::WatchRow& row : rows) {
        const bool scs = row.id == 2;
        QVERIFY(row.values[0].has_value());
        QCOMPARE(row.values[1].has_value(), !scs);
        QCOMPARE(row.values[2].has_value(), scs);
        QCOMPARE(row.values[3].has_value(), scs);
    }
}

void TestWatch::readsAtTheRequestedRate_data()
{
    QTest::addColumn<int>("periodUs");
    QTest::addColumn<int>("least");
    QTest::addColumn<int>("most");
    QTest::newRow("1 Hz") << 1'000'000 << 9 << 11;
    QTest::newRow("20 Hz") << 50'000 << 199 << 201;
    QTest::newRow("200 Hz") << 5'000 << 1'999 << 2'001;
    // 29 bytes of 10 µs: 3448 a second if nothing but the wire took time.
    QTest::newRow("as fast as it goes") << 0 << 25'000 << 34'500;
}

void TestWatch::readsAtTheRequestedRate()
{
    QFETCH(int, periodUs);
    QFETCH(int, least);
    QFETCH(int, most);
    SimFixture fixture(QStringLiteral("sts3215@1"));
    const auto spec = specFor(fixture, {1}, base::Duration(periodUs), seconds(10));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QVERIFY2(int(rows.size()) >= least && int(rows.size()) <= most,
             qPrintable(QString::number(rows.size())));
    QVERIFY(report->elapsed >= seconds(10) && report->elapsed < milliseconds(10'050));
}

void TestWatch::showsTheServosValues()
{
    SimFixtureOptions options;
    options.servoBaud = fast;
    SimFixture fixture(QStringLiteral("sts3215@1,scs15@2"), options);
    fixture.poke(1, QStringLiteral("goal_position"), 1000);
    fixture.poke(2, QStringLiteral("goal_position"), 300);
    fixture.runFor(seconds(4));
    const auto [report, rows] =
        watch(fixture, specFor(fixture, {1, 2}, milliseconds(20), milliseconds(200)));
    QVERIFY(report);
    const auto& columns = report->columns;
    for (const int id : {1, 2}) {
        const Rows own = rowsOf(rows, id);
        QVERIFY(!own.empty());
        const jobs::WatchRow& row = own.back();
        const auto raw = [&](const char* key) {
            return double(fixture.raw(id, QString::fromLatin1(key)));
        };
        const auto value = [&](const char* key) {
            // Of two columns with one key the servo fills its own.
            for (std::size_t i = 0; i < columns.size(); ++i) {
                if (columns[i].key == QLatin1String(key) && row.values[i])
                    return *row.values[i];
            }
            return std::nan("");
        };
        QCOMPARE(value("present_voltage"), raw("present_voltage") * 0.1);
        QCOMPARE(value("present_temperature"), raw("present_temperature"));
        QCOMPARE(value("moving"), 0.0);
        QCOMPARE(value("servo_status"), 0.0);
    }
    // At rest where it was sent: 1000 of 4096 steps.
    const auto position =
        column(columns, QStringLiteral("present_position"), QStringLiteral("deg"));
    QVERIFY(std::abs(*rowsOf(rows, 1).back().values[position] - 87.89) < 1.0);
}

void TestWatch::speedMatchesTheDistance_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<int>("speedRaw");
    QTest::newRow("unit 50 step/s") << 0x08 << 10;
    QTest::newRow("unit 1 step/s") << 0x0C << 500;
}

// Phase bit 2 chooses the unit of the raw speed; the shown speed must fit the shown way either way.
void TestWatch::speedMatchesTheDistance()
{
    QFETCH(int, phase);
    QFETCH(int, speedRaw);
    SimFixture fixture(QStringLiteral("sts3215@1"));
    fixture.poke(1, QStringLiteral("phase"), phase);
    fixture.poke(1, QStringLiteral("goal_speed"), speedRaw);
    fixture.poke(1, QStringLiteral("goal_position"), 3800);
    fixture.runFor(seconds(1));
    const auto [report, rows] = watch(fixture, specFor(fixture, {1}, milliseconds(20), seconds(1)));
    QVERIFY(report);
    const auto position = column(report->columns, QStringLiteral("present_position"));
    const auto speed = column(report->columns, QStringLiteral("present_speed"));
    QCOMPARE(report->columns[speed].unit, QStringLiteral("rpm"));
    const double degrees = *rows.back().values[position] - *rows.front().values[position];
    const double elapsedSeconds = double((rows.back().at - rows.front().at).count()) / 1e6;
    const double rpm = degrees / elapsedSeconds / 6.0;
    QVERIFY2(std::abs(*rows[rows.size() / 2].values[speed] - rpm) < 0.1 * std::abs(rpm),
             qPrintable(QString::number(rpm)));
    QVERIFY(std::abs(rpm) > 5.0);
}

void TestWatch::usesSyncReadWhereSupported()
{
    SimFixtureOptions options;
    options.servoBaud = fast;
    SimFixture fixture(QStringLiteral("sts3215@1,sts3250@2,scs15@3,scs0009@4"), options);
    const auto spec = specFor(fixture, {1, 2, 3, 4}, milliseconds(50), seconds(1));
    fixture.clearFrames();
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    const int rounds = int(rowsOf(rows, 1).size());
    QCOMPARE(fixture.frames(support::SyncRead), rounds);
    for (const int id : {1, 2})
        QCOMPARE(fixture.framesSentTo(id), 0);
    for (const int id : {3, 4}) // these do not know sync reads
        QCOMPARE(fixture.framesSentTo(id), rounds);
    QCOMPARE(int(rows.size()), 4 * rounds);
}

void TestWatch::countsMissedReadings()
{
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2"));
    const auto spec = specFor(fixture, {1, 2}, milliseconds(100), seconds(20));
    fixture.wireConfig().faults.muteIds = {2};
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    const Rows silent = rowsOf(rows, 2);
    QVERIFY(silent.size() >= 10); // an absent servo is asked less often, not given up
    QCOMPARE(report->missed, silent.size());
    for (const jobs::WatchRow& row : silent) {
        QVERIFY(!row.answered);
        QVERIFY(std::none_of(row.values.begin(), row.values.end(),
                             [](const auto& value) { return value.has_value(); }));
    }
    const Rows receivedRows = rowsOf(rows, 1);
    QVERIFY(receivedRows.size() >= 195 && receivedRows.size() <= 201);
    QCOMPARE(report->rows, receivedRows.size());
    QVERIFY(std::all_of(receivedRows.begin(), receivedRows.end(),
                        [](const auto& row) { return row.answered; }));
}

void TestWatch::stopsWithin100Milliseconds()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    const auto spec = specFor(fixture, {1}, milliseconds(10), {});
    base::Duration requestedAt{};
    std::size_t frames = 0;
    fixture.clearFrames();
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (++frames == 500) {
            requestedAt = fixture.clock().now();
            fixture.stop().request();
        }
    };
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QVERIFY(report->stopped);
    QVERIFY(fixture.clock().now() - requestedAt <= milliseconds(100));
    QCOMPARE(rows.size(), frames); // what was read is handed over
    // The poll is over: the bus is silent when time passes.
    const std::size_t before = fixture.frameCount();
    fixture.bus().pauseUntil(fixture.clock().now() + seconds(1), nullptr);
    QCOMPARE(fixture.frameCount(), before);
}

void TestWatch::endsWhenTheReceiverFails()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    const auto spec = specFor(fixture, {1}, milliseconds(10), seconds(10));
    int taken = 0;
    const auto report =
        jobs::watch(fixture.context(), spec, [&](const jobs::WatchRow&) -> base::Result<void> {
            if (++taken == 30)
                return base::fail(ErrorCode::DiskFull, QStringLiteral("csv"));
            return {};
        });
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::DiskFull);
    QCOMPARE(taken, 30);
    QVERIFY(fixture.clock().now() < seconds(1));
}

void TestWatch::endsWhenTheLinkIsCut()
{
    SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2"));
    const auto spec = specFor(fixture, {1, 2}, milliseconds(10), {});
    base::Duration cutAt{};
    fixture.clearFrames();
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (fixture.frameCount() == 100) {
            fixture.cutLink();
            cutAt = fixture.clock().now();
        }
    };
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::LinkLost);
    QVERIFY(!rows.empty());
    QVERIFY(fixture.clock().now() - cutAt <= milliseconds(200));
}

void TestWatch::refusesUnreadableRegisters()
{
    SimFixture fixture(QStringLiteral("sts3215@1,scs15@2"), {fast, fast, {}});
    auto spec = specFor(fixture, {1, 2}, milliseconds(10), seconds(1));
    spec.keys = {QStringLiteral("present_voltage"), QStringLiteral("colour")};
    const auto unknown = watch(fixture, spec);
    QVERIFY(!unknown.report);
    QCOMPARE(unknown.report.error().code, ErrorCode::UnknownRegister);
    QCOMPARE(unknown.report.error().registerKey, QStringLiteral("colour"));

    spec.keys = {QStringLiteral("acceleration")}; // SCS has none
    const auto missing = watch(fixture, spec);
    QVERIFY(!missing.report);
    QCOMPARE(missing.report.error().code, ErrorCode::UnknownRegister);
    QCOMPARE(missing.report.error().id, 2);

    const auto emptyResult = watch(fixture, {});
    QVERIFY(!emptyResult.report);
    QCOMPARE(emptyResult.report.error().code, ErrorCode::BadArgument);
}

void TestWatch::keepsUpForAnHour()
{
    SimFixture fixture(QStringLiteral("demo"));
    const auto spec = specFor(fixture, {1, 2, 3, 4, 5, 6}, milliseconds(50), std::chrono::hours(1));
    std::uint64_t good = 0;
    const auto report = jobs::watch(fixture.context(), spec, [&](const jobs::WatchRow& row) {
        good += row.answered && row.values.front().has_value() ? 1 : 0;
        return base::Result<void>{};
    });
    QVERIFY(report);
    QCOMPARE(report->missed, std::uint64_t{0});
    QVERIFY2(report->rows >= 431'900 && report->rows <= 432'012,
             qPrintable(QString::number(report->rows)));
}

SERVODESK_GUILESS_TEST(TestWatch)
#include "tst_watch.moc"
