// SPDX-License-Identifier: GPL-3.0-or-later
// Watching servos that speak Modbus or LX, and families that must not share a packet: what is read
// each round, what every so often, and where alarms come from when replies carry none.
#include "integration/watch_support.h"
#include "jobs/watch/watch_decoder.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using base::Protocol;
using std::chrono::milliseconds;
using std::chrono::seconds;
using support::SimFixture;
using support::SimFixtureOptions;

using namespace watch_support;

namespace {
constexpr int commonBaud = 115'200;

SimFixtureOptions atCommonBaud()
{
    SimFixtureOptions options;
    options.baud = commonBaud;
    options.servoBaud = commonBaud;
    return options;
}

jobs::WatchSpec specOf(SimFixture& fixture, const std::vector<std::pair<Protocol, int>>& servos,
                       base::Duration period, base::Duration length)
{
    jobs::WatchSpec spec;
    for (const auto& [protocol, id] : servos)
        spec.servos.push_back(fixture.servo(id, protocol));
    spec.period = period;
    spec.length = length;
    fixture.clearFrames();
    return spec;
}

int measured(const Rows& rows, std::size_t column)
{
    return int(std::count_if(rows.begin(), rows.end(), [column](const jobs::WatchRow& row) {
        return row.values[column].has_value();
    }));
}

int notes(SimFixture& fixture, device::NoticeCode code)
{
    const auto& notices = fixture.notices();
    return int(std::count_if(notices.begin(), notices.end(),
                             [code](const device::Notice& notice) { return notice.code == code; }));
}
} // namespace

class TestWatchProtocols : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void lxPositionEveryRoundOthersNowAndThen_data();
    void lxPositionEveryRoundOthersNowAndThen();
    void lxAsFastAsTheWireAllows();
    void slowReadingsAloneAreReadEveryRound();
    void lxRowsAreJoinedByRound();
    void lxShowsTheServosValues();
    void lxAlarmsAreDerivedAndReportedOnce();
    void modbusReadsItsFeedbackAtOnce();
    void modbusAlarmsComeFromItsStatusRegister_data();
    void modbusAlarmsComeFromItsStatusRegister();
    void oneIdInTwoProtocols();
    void familiesDoNotShareAPacket();
};

void TestWatchProtocols::lxPositionEveryRoundOthersNowAndThen_data()
{
    QTest::addColumn<int>("periodMs");
    QTest::addColumn<int>("every");
    QTest::newRow("100 Hz") << 10 << 100;
    QTest::newRow("20 Hz") << 50 << 20;
    QTest::newRow("1 Hz") << 1000 << 1;
    QTest::newRow("once in two seconds") << 2000 << 1;
}

void TestWatchProtocols::lxPositionEveryRoundOthersNowAndThen()
{
    QFETCH(int, periodMs);
    QFETCH(int, every);
    SimFixture fixture(QStringLiteral("lx16a@3"), atCommonBaud());
    const auto spec = specOf(fixture, {{Protocol::Lx, 3}}, milliseconds(periodMs), seconds(10));
    QCOMPARE(headers(jobs::watchColumns(spec)),
             QStringList({QStringLiteral("temperature[degC]"), QStringLiteral("vin[V]"),
                          QStringLiteral("position[deg]")}));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QCOMPARE(report->missed, std::uint64_t{0});
    const int rounds = int(rows.size());
    QVERIFY(std::abs(rounds - 10'000 / periodMs) <= 1);
    const int slow = (rounds + every - 1) / every;
    QCOMPARE(measured(rows, 0), slow);
    QCOMPARE(measured(rows, 1), slow);
    QCOMPARE(measured(rows, 2), rounds);
    QVERIFY(rows.front().values[0].has_value()); // nobody waits a second for the first one
    QCOMPARE(int(fixture.frameCount()), rounds + 2 * slow);
    QVERIFY(fixture.onlyReadsSent());
}

void TestWatchProtocols::lxAsFastAsTheWireAllows()
{
    SimFixture fixture(QStringLiteral("lx16a@3"), atCommonBaud());
    const auto spec = specOf(fixture, {{Protocol::Lx, 3}}, {}, seconds(5));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    // The slow readings cost a few per cent of the wire at most.
    QVERIFY(measured(rows, 2) >= int(double(fixture.frameCount()) * 0.97));
    QVERIFY(measured(rows, 0) >= 10);
}

void TestWatchProtocols::slowReadingsAloneAreReadEveryRound()
{
    SimFixture fixture(QStringLiteral("lx16a@3"), atCommonBaud());
    auto spec = specOf(fixture, {{Protocol::Lx, 3}}, milliseconds(50), seconds(2));
    spec.keys = {QStringLiteral("vin"), QStringLiteral("temperature")};
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QCOMPARE(measured(rows, 0), int(rows.size()));
    QCOMPARE(measured(rows, 1), int(rows.size()));
}

// Blocks come fast ones first, whatever their addresses: position is read ahead of temperature.
void TestWatchProtocols::lxRowsAreJoinedByRound()
{
    SimFixture fixture(QStringLiteral("lx16a@1"), atCommonBaud());
    const auto spec = specOf(fixture, {{Protocol::Lx, 1}}, milliseconds(50), seconds(1));
    auto decoder = jobs::WatchDecoder::make(spec);
    QVERIFY(decoder);
    enum Command { Temperature = 26, Voltage = 27, Position = 28 };
    const auto add = [&](int ms, Command command, bool answered, bool endsRound) {
        bus::Sample sample;
        sample.protocol = Protocol::Lx;
        sample.id = 1;
        sample.address = 8 * command;
        sample.at = milliseconds(ms);
        sample.answered = answered;
        sample.endsRound = endsRound;
        sample.data.assign(answered ? (command == Temperature ? 1 : 2) : 0, 40);
        QStringList rows;
        for (const jobs::WatchRow& row : decoder->add(sample)) {
            QString measured;
            for (const auto& value : row.values)
                measured += value ? QLatin1Char('x') : QLatin1Char('-');
            rows << measured;
        }
        return rows.join(QLatin1Char(' '));
    };
    // A round with everything in it: temperature, voltage, position.
    QCOMPARE(add(0, Position, true, false), QString());
    QCOMPARE(add(3, Temperature, true, false), QString());
    QCOMPARE(add(6, Voltage, true, true), QStringLiteral("xxx"));
    // Rounds of the position alone are told at once.
    QCOMPARE(add(50, Position, true, true), QStringLiteral("--x"));
    QCOMPARE(add(100, Position, true, true), QStringLiteral("--x"));
    // A block that is missed ends the row; what else the round brings makes another one.
    QCOMPARE(add(150, Position, true, false), QString());
    QCOMPARE(add(180, Temperature, false, false), QStringLiteral("--x"));
    QCOMPARE(add(210, Voltage, true, true), QStringLiteral("-x-"));
    // The rest of a round never came (a job held the servo): the next one does not wait for it.
    QCOMPARE(add(250, Position, true, false), QString());
    QCOMPARE(add(300, Position, true, true), QStringLiteral("--x --x"));
}

void TestWatchProtocols::lxShowsTheServosValues()
{
    SimFixture fixture(QStringLiteral("lx16a@3"), atCommonBaud());
    const auto spec = specOf(fixture, {{Protocol::Lx, 3}}, milliseconds(50), seconds(1));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    const auto raw = [&](const char* key) {
        return double(fixture.raw(3, QString::fromLatin1(key)));
    };
    QCOMPARE(*rows.front().values[0], raw("temperature"));
    QVERIFY(std::abs(*rows.front().values[1] - raw("vin") / 1000) < 0.05);
    QVERIFY(std::abs(*rows.back().values[2] - raw("position") * 0.24) < 0.5);
    QCOMPARE(int(rows.back().status), 0);
}

void TestWatchProtocols::lxAlarmsAreDerivedAndReportedOnce()
{
    SimFixture fixture(QStringLiteral("lx16a@3,lx16a@4"), atCommonBaud());
    fixture.withBus([](sim::VirtualBus& wire) {
        wire.servo(3)->environment().ambientCelsius = 95;
        wire.servo(3)->setTemperature(95);
        wire.servo(4)->environment().supplyVolts = 5;
    });
    const auto spec =
        specOf(fixture, {{Protocol::Lx, 3}, {Protocol::Lx, 4}}, milliseconds(50), seconds(10));
    fixture.notices().clear();
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QCOMPARE(notes(fixture, device::NoticeCode::DerivedTemperature), 1);
    QCOMPARE(notes(fixture, device::NoticeCode::DerivedVoltage), 1);
    for (const device::Notice& notice : fixture.notices())
        QCOMPARE(notice.id, notice.code == device::NoticeCode::DerivedTemperature ? 3 : 4);
    // Nothing the servo has not said itself.
    QVERIFY(std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.status == 0; }));
}

void TestWatchProtocols::modbusReadsItsFeedbackAtOnce()
{
    SimFixture fixture(QStringLiteral("smsmb@7"), atCommonBaud());
    const auto spec = specOf(fixture, {{Protocol::Modbus, 7}}, milliseconds(20), seconds(2));
    QCOMPARE(headers(jobs::watchColumns(spec)),
             QStringList({QStringLiteral("servo_status[]"), QStringLiteral("present_position[deg]"),
                          QStringLiteral("present_speed[rpm]"), QStringLiteral("present_load[%]"),
                          QStringLiteral("present_voltage[V]"),
                          QStringLiteral("present_temperature[degC]"), QStringLiteral("moving[]"),
                          QStringLiteral("present_current[mA]")}));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QCOMPARE(fixture.frameCount(), rows.size());
    // Eight registers from 256.
    const base::Bytes wanted{7, 3, 1, 0, 0, 8};
    for (const base::Bytes& frame : fixture.tap().written)
        QCOMPARE(base::Bytes(frame.begin(), frame.begin() + 6), wanted);
    for (std::size_t i = 0; i < report->columns.size(); ++i)
        QCOMPARE(measured(rows, i), int(rows.size()));
    const auto voltage = column(report->columns, QStringLiteral("present_voltage"));
    QCOMPARE(*rows.back().values[voltage],
             double(fixture.raw(7, QStringLiteral("present_voltage"))) * 0.1);
}

void TestWatchProtocols::modbusAlarmsComeFromItsStatusRegister_data()
{
    QTest::addColumn<QStringList>("keys");
    QTest::newRow("feedback") << QStringList{};
    QTest::newRow("far from the status register")
        << QStringList{QStringLiteral("present_temperature")};
}

void TestWatchProtocols::modbusAlarmsComeFromItsStatusRegister()
{
    QFETCH(QStringList, keys);
    SimFixture fixture(QStringLiteral("smsmb@7"), atCommonBaud());
    fixture.poke(7, QStringLiteral("torque_switch"), 1);
    for (const int faults : {0, 2}) {
        fixture.withBus(
            [faults](sim::VirtualBus& wire) { wire.servo(7)->injectStatus(std::uint8_t(faults)); });
        fixture.runFor(milliseconds(20));
        QCOMPARE(fixture.raw(7, QStringLiteral("servo_status")) & 16, std::int64_t{16});
        auto spec = specOf(fixture, {{Protocol::Modbus, 7}}, milliseconds(50), seconds(1));
        spec.keys = keys;
        const auto [report, rows] = watch(fixture, spec);
        QVERIFY(report);
        QVERIFY(rows.size() > 10);
        // "Torque is on" is a bit of the register, and no alarm.
        for (const jobs::WatchRow& row : rows)
            QCOMPARE(int(row.status), faults);
        QCOMPARE(notes(fixture, device::NoticeCode::DerivedVoltage), 0);
    }
}

void TestWatchProtocols::oneIdInTwoProtocols()
{
    SimFixture fixture(QStringLiteral("sts3215@1,lx16a@1,smsmb@1"), atCommonBaud());
    const auto spec =
        specOf(fixture, {{Protocol::Feetech, 1}, {Protocol::Lx, 1}, {Protocol::Modbus, 1}},
               milliseconds(50), seconds(2));
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    QCOMPARE(report->missed, std::uint64_t{0});
    // One thing under two names is one column, by the name of the family that comes first.
    for (const jobs::WatchColumn& one : report->columns)
        QVERIFY(one.key != QLatin1String("position"));
    const auto feetech = column(report->columns, QStringLiteral("active_goal_position"));
    const auto all = column(report->columns, QStringLiteral("present_position"));
    QVERIFY(rows.size() > 100);
    for (const jobs::WatchRow& row : rows) {
        QCOMPARE(row.id, 1);
        QVERIFY(row.answered);
        QCOMPARE(row.values[feetech].has_value(), row.protocol == Protocol::Feetech);
        QVERIFY(row.values[all].has_value());
    }
}

void TestWatchProtocols::familiesDoNotShareAPacket()
{
    SimFixtureOptions options;
    options.servoBaud = fast;
    SimFixture fixture(QStringLiteral("sts3215@1,sts3250@2,hls3606@3,hls3915@4,sm60-360m@5"),
                       options);
    auto spec = specFor(fixture, {1, 2, 3, 4, 5}, milliseconds(50), seconds(1));
    spec.keys = {QStringLiteral("present_position")};
    fixture.clearFrames();
    const auto [report, rows] = watch(fixture, spec);
    QVERIFY(report);
    const int rounds = int(rowsOf(rows, 1).size());
    QCOMPARE(fixture.frames(support::SyncRead), 2 * rounds);
    QCOMPARE(fixture.framesSentTo(5), rounds); // SMCL knows no sync read
    QCOMPARE(int(rows.size()), 5 * rounds);
}

SERVODESK_GUILESS_TEST(TestWatchProtocols)
#include "tst_watch_protocols.moc"
