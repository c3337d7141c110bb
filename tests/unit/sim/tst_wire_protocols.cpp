// SPDX-License-Identifier: GPL-3.0-or-later
// Feetech, Modbus and LX servos on one simulated line: each receives its own protocol only, Modbus
// lives by its silences, and faults, echo and collisions befall all alike. Frames are those of the
// protocol descriptions or built here from their rules.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"

using namespace std::chrono_literals;
using base::Bytes;
using base::Duration;

namespace {
constexpr int baud = 115'200;
const char* const mixedServos = "smsmb@1,sm40blhv@1,lx16a@1";

Bytes modbus(Bytes body)
{
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : body) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xA001U : crc >> 1;
    }
    body.push_back(static_cast<std::uint8_t>(crc & 0xFF));
    body.push_back(static_cast<std::uint8_t>(crc >> 8));
    return body;
}

Bytes lx(std::uint8_t id, std::uint8_t command, const Bytes& params = {})
{
    Bytes bytes{0x55, 0x55, id, static_cast<std::uint8_t>(params.size() + 3), command};
    for (const std::uint8_t param : params)
        bytes.push_back(param);
    bytes.push_back(
        static_cast<std::uint8_t>(~std::accumulate(bytes.begin() + 2, bytes.end(), 0U)));
    return bytes;
}

const Bytes modbusRead{0x01, 0x03, 0x00, 0x0A, 0x00, 0x01, 0xA4, 0x08}; ///< the station's number
const Bytes modbusReply = modbus({0x01, 0x03, 0x02, 0x00, 0x01});
const Bytes lxRead = lx(1, 14);
const Bytes lxReply = lx(1, 14, {1});

Duration characterTime(double count)
{
    return Duration(static_cast<Duration::rep>(count * 1e7 / baud));
}

/// A bus at 115200 that has been silent for a while.
struct IdleBus {
    explicit IdleBus(const char* servos, const sim::WireConfig& config = {})
        : bus(wire::bus(servos, baud, config))
    {
        bus->setHostBaud(baud);
        bus->hostReads(now);
    }
    Bytes ask(const Bytes& request, Duration timeout = 50ms)
    {
        return wire::ask(*bus, request, now, baud, timeout);
    }
    /// Sends the parts with pauses between the end of one and the start of the next.
    Bytes requestWithPauses(const Bytes& first, Duration pause, const Bytes& second)
    {
        bus->hostWrites(first, baud, now);
        bus->hostWrites(second, baud, now + characterTime(double(first.size())) + pause);
        now += 50ms;
        return bus->hostReads(now);
    }

    std::unique_ptr<sim::VirtualBus> bus;
    Duration now = 1ms;
};
} // namespace

class TestWireProtocols : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void eachAnswersItsProtocol_data()
    {
        QTest::addColumn<Bytes>("request");
        QTest::addColumn<Bytes>("reply");
        const auto row = [](const char* name, const Bytes& request, const Bytes& reply) {
            QTest::newRow(name) << request << reply;
        };
        row("Modbus read", modbusRead, modbusReply);
        row("Modbus torque on", {0x01, 0x06, 0x00, 0x81, 0x00, 0x01, 0x18, 0x22},
            {0x01, 0x06, 0x00, 0x81, 0x00, 0x01, 0x18, 0x22});
        row("Modbus unlock", {0x01, 0x06, 0x00, 0x85, 0x00, 0x00, 0x98, 0x23},
            {0x01, 0x06, 0x00, 0x85, 0x00, 0x00, 0x98, 0x23});
        row("Modbus burst",
            {0x01, 0x10, 0x00, 0x80, 0x00, 0x04, 0x08, 0x08, 0x00, 0x00, 0x01, 0x00, 0x0A, 0x00,
             0x32, 0x29, 0xB5},
            {0x01, 0x10, 0x00, 0x80, 0x00, 0x04, 0xC0, 0x22});
        row("Modbus report ID", {0x01, 0x11, 0xC0, 0x2C},
            {0x01, 0x11, 0x03, 0x01, 0x00, 0x00, 0xAC, 0x4D});
        row("Modbus report ID to all", {0x00, 0x11, 0xC1, 0xBC},
            {0x01, 0x11, 0x03, 0x01, 0x00, 0x00, 0xAC, 0x4D});
        row("Modbus exception", modbus({0x01, 0x03, 0x00, 0x64, 0x00, 0x01}),
            {0x01, 0x83, 0x02, 0xC0, 0xF1});
        row("Modbus unknown function", modbus({0x01, 0x2B, 0x0E, 0x01, 0x00}),
            modbus({0x01, 0xAB, 0x01}));
        row("Modbus reboot", {0x01, 0x41, 0xC0, 0x10}, {});
        row("Modbus wrong CRC", {0x01, 0x03, 0x00, 0x0A, 0x00, 0x01, 0xA4, 0x09}, {});
        row("Modbus other station", modbus({0x02, 0x03, 0x00, 0x0A, 0x00, 0x01}), {});
        row("Feetech ping", wire::ping(1), wire::frame(1, 0x00));
        row("LX ID", lxRead, lxReply);
        row("LX ID by broadcast", {0x55, 0x55, 0xFE, 0x03, 0x0E, 0xF0}, lxReply);
        row("LX offset tried", {0x55, 0x55, 0x01, 0x04, 0x11, 0xE2, 0x07}, {});
        row("LX wrong checksum", {0x55, 0x55, 0x01, 0x03, 0x0E, 0xEE}, {});
        row("LX other ID", lx(2, 14), {});
    }
    void eachAnswersItsProtocol()
    {
        QFETCH(Bytes, request);
        QFETCH(Bytes, reply);
        IdleBus line(mixedServos);
        QCOMPARE(line.ask(request), reply);
    }

    // One after the other in any order, each with a silence before it.
    void noneIsConfusedByTheOthers()
    {
        IdleBus line(mixedServos);
        const std::pair<Bytes, Bytes> talks[] = {
            {modbusRead, modbusReply}, {wire::ping(1), wire::frame(1, 0x00)}, {lxRead, lxReply}};
        for (const auto& [request, reply] : talks) {
            for (const auto& [next, answer] : talks) {
                QCOMPARE(line.ask(request, 20ms), reply);
                QCOMPARE(line.ask(next, 20ms), answer);
            }
        }
    }

    void aModbusReplyWaitsForTheSilence_data()
    {
        QTest::addColumn<int>("rate");
        QTest::addColumn<int>("delay");
        QTest::newRow("115200, 0 us") << 115200 << 0;
        QTest::newRow("115200, 500 us") << 115200 << 500;
        QTest::newRow("9600, 0 us") << 9600 << 0;
        QTest::newRow("256000, 100 us") << 256000 << 100;
    }
    void aModbusReplyWaitsForTheSilence()
    {
        QFETCH(int, rate);
        QFETCH(int, delay);
        const auto bus = wire::bus("smsmb@1", rate);
        bus->servo(1)->poke(QStringLiteral("return_delay"), delay);
        bus->setHostBaud(rate);
        bus->hostReads(0us);
        bus->hostWrites(modbusRead, rate, 0us);
        const auto silent = bus->nextHostRun(1s);
        QVERIFY(silent);
        QVERIFY(bus->hostReads(*silent).empty());
        const auto whole = bus->nextHostRun(1s);
        QVERIFY(whole);
        const double bytes = 8 + 3.5 + 7;
        const double expected = bytes * 1e7 / rate + delay;
        QVERIFY2(std::abs(double(whole->count()) - expected) <= 2,
                 qPrintable(QString::number(whole->count())));
        QCOMPARE(bus->hostReads(*whole), modbusReply);
    }

    void aGapEndsAFrame_data()
    {
        QTest::addColumn<double>("gap"); // characters
        QTest::addColumn<bool>("whole");
        QTest::newRow("none") << 0.0 << true;
        QTest::newRow("one character") << 1.0 << true;
        QTest::newRow("3.4 characters") << 3.4 << true;
        QTest::newRow("3.6 characters") << 3.6 << false;
        QTest::newRow("long") << 40.0 << false;
    }
    void aGapEndsAFrame()
    {
        QFETCH(double, gap);
        QFETCH(bool, whole);
        for (std::size_t cut = 1; cut < modbusRead.size(); ++cut) {
            IdleBus line("smsmb@1");
            const auto middle = modbusRead.begin() + static_cast<std::ptrdiff_t>(cut);
            const Bytes reply = line.requestWithPauses(
                {modbusRead.begin(), middle}, characterTime(gap), {middle, modbusRead.end()});
            QCOMPARE(reply, whole ? modbusReply : Bytes{});
            QCOMPARE(line.ask(modbusRead), modbusReply);
        }
    }

    void bytesWithoutASilenceBelongToTheFrameBefore_data()
    {
        QTest::addColumn<Bytes>("before");
        QTest::addColumn<double>("gap");
        QTest::addColumn<bool>("heard");
        const Bytes broadcast = modbus({0x00, 0x06, 0x00, 0x85, 0x00, 0x00});
        QTest::newRow("Modbus, glued") << broadcast << 0.0 << false;
        QTest::newRow("Modbus, 3 characters") << broadcast << 3.0 << false;
        QTest::newRow("Modbus, 4 characters") << broadcast << 4.0 << true;
        QTest::newRow("LX, glued") << lx(254, 12) << 0.0 << false;
        QTest::newRow("LX, 4 characters") << lx(254, 12) << 4.0 << true;
        QTest::newRow("Feetech, 3 characters") << wire::frame(0xFE, 0x05) << 3.0 << false;
        QTest::newRow("Feetech, 4 characters") << wire::frame(0xFE, 0x05) << 4.0 << true;
        QTest::newRow("one byte of noise, glued") << Bytes{0x00} << 0.0 << false;
        QTest::newRow("one byte of noise, 4 characters") << Bytes{0x00} << 4.0 << true;
    }
    void bytesWithoutASilenceBelongToTheFrameBefore()
    {
        QFETCH(Bytes, before);
        QFETCH(double, gap);
        QFETCH(bool, heard);
        IdleBus line(mixedServos);
        const Bytes reply = line.requestWithPauses(before, characterTime(gap), modbusRead);
        QCOMPARE(reply, heard ? modbusReply : Bytes{});
        QCOMPARE(line.bus->servos()[0]->raw(QStringLiteral("lock")),
                 before.size() == 8 && gap > 3.5 ? 0 : 1);
    }

    // A station receives the replies of others, but not its own.
    void anothersReplyNeedsASilenceAfterIt_data()
    {
        QTest::addColumn<Bytes>("first");
        QTest::addColumn<double>("gap");
        QTest::addColumn<bool>("heard");
        QTest::newRow("LX reply, at once") << lxRead << 0.5 << false;
        QTest::newRow("LX reply, silence") << lxRead << 4.0 << true;
        QTest::newRow("Feetech reply, at once") << wire::ping(1) << 0.5 << false;
        QTest::newRow("Feetech reply, silence") << wire::ping(1) << 4.0 << true;
        QTest::newRow("its own reply, at once") << modbusRead << 0.5 << true;
    }
    void anothersReplyNeedsASilenceAfterIt()
    {
        QFETCH(Bytes, first);
        QFETCH(double, gap);
        QFETCH(bool, heard);
        IdleBus line(mixedServos);
        line.bus->hostWrites(first, baud, line.now);
        auto whole = line.bus->nextHostRun(line.now + 100ms);
        while (whole && line.bus->hostReads(*whole).empty())
            whole = line.bus->nextHostRun(line.now + 100ms);
        QVERIFY(whole);
        line.now = *whole + characterTime(gap);
        QCOMPARE(line.ask(modbusRead), heard ? modbusReply : Bytes{});
    }

    // However slowly a client hands its bytes over, they are one frame if they leave as one.
    void aFrameMayArriveByteByByte()
    {
        IdleBus line("smsmb@1");
        for (const std::uint8_t byte : modbusRead) {
            line.bus->hostWrites(Bytes{byte}, baud, line.now);
            line.bus->nextHostRun(line.now + 20ms);
            line.now += characterTime(3);
        }
        QCOMPARE(line.ask({}), modbusReply);
    }

    void anIncompleteLxFrameIsDropped()
    {
        IdleBus line("lx16a@1");
        QVERIFY(line.ask({0x55, 0x55, 0x01}).empty());
        QCOMPARE(line.ask(lxRead), lxReply);
    }

    void theAdapterEchoesAnyProtocol_data()
    {
        QTest::addColumn<Bytes>("request");
        QTest::addColumn<Bytes>("reply");
        QTest::newRow("Modbus") << modbusRead << modbusReply;
        QTest::newRow("LX") << lxRead << lxReply;
        QTest::newRow("LX write") << lx(1, 33, {1}) << Bytes{};
    }
    void theAdapterEchoesAnyProtocol()
    {
        QFETCH(Bytes, request);
        QFETCH(Bytes, reply);
        sim::WireConfig config;
        config.echo = true;
        IdleBus line(mixedServos, config);
        QCOMPARE(line.ask(request), wire::joined({request, reply}));
    }

    void faultsApplyToAll_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<Bytes>("request");
        QTest::addColumn<Bytes>("reply");
        for (const char* fault : {"drop=1", "corrupt=1", "truncate=1", "garbage=1", "late=1",
                                  "drop-request=1", "mute=1"}) {
            QTest::addRow("Modbus %s", fault)
                << QString::fromLatin1(fault) << modbusRead << modbusReply;
            QTest::addRow("LX %s", fault) << QString::fromLatin1(fault) << lxRead << lxReply;
        }
    }
    void faultsApplyToAll()
    {
        QFETCH(QString, fault);
        QFETCH(Bytes, request);
        QFETCH(Bytes, reply);
        sim::WireConfig config;
        config.faults = *sim::parseFaults(fault);
        IdleBus line(mixedServos, config);
        const Bytes early = line.ask(request, 25ms);
        QVERIFY(early != reply);
        const Bytes later = line.ask({}, 100ms);
        QCOMPARE(later, fault == QLatin1String("late=1") ? reply : Bytes{});
    }

    void duplicateIdsCollide_data()
    {
        QTest::addColumn<QString>("servos");
        QTest::addColumn<Bytes>("request");
        QTest::newRow("Modbus") << QStringLiteral("smsmb@1,smsmb@1")
                                << modbus({0x01, 0x03, 0x01, 0x00, 0x00, 0x08});
        QTest::newRow("LX") << QStringLiteral("lx16a@1,lx224hv@1") << lx(1, 27);
    }
    void duplicateIdsCollide()
    {
        QFETCH(QString, servos);
        QFETCH(Bytes, request);
        const QString alone = servos.section(QLatin1Char(','), 0, 0);
        IdleBus both(qPrintable(servos));
        both.bus->servos()[0]->environment().supplyVolts = 7.9;
        both.bus->servos()[1]->setTemperature(51);
        both.now += 1s;
        IdleBus one(qPrintable(alone));
        one.bus->servos()[0]->environment().supplyVolts = 7.9;
        one.now += 1s;
        const Bytes clear = one.ask(request);
        QVERIFY(clear.size() > 7);
        QVERIFY(both.ask(request) != clear);
    }

    void aCutWireDisconnectsAll()
    {
        IdleBus line(mixedServos);
        line.bus->cutLink();
        QVERIFY(line.ask(modbusRead).empty());
        QVERIFY(line.ask(lxRead).empty());
        line.bus->restoreLink();
        QCOMPARE(line.ask(modbusRead), modbusReply);
        QCOMPARE(line.ask(lxRead), lxReply);
    }

    // HLS: the second ID obeys group requests, and does not reply.
    void anHlsServoAcceptsItsSecondaryId()
    {
        const auto bus = wire::bus("hls3606m@1,hls3606m@2");
        Duration now = 1ms;
        bus->hostReads(now);
        for (sim::VirtualServo* servo : bus->servos())
            servo->poke(QStringLiteral("secondary_id"), 9);
        const auto torque = [&](std::size_t place) {
            return bus->servos()[place]->raw(QStringLiteral("torque_switch"));
        };
        QVERIFY(wire::ask(*bus, wire::ping(9), now).empty());
        QVERIFY(wire::ask(*bus, wire::read(9, 5, 1), now).empty());
        QVERIFY(wire::ask(*bus, wire::write(9, 40, 1), now).empty());
        QCOMPARE(torque(0), 1);
        QCOMPARE(torque(1), 1);
        QVERIFY(wire::ask(*bus, wire::frame(0xFE, 0x83, {40, 1, 9, 0}), now).empty());
        QCOMPARE(torque(0), 0);
        QCOMPARE(torque(1), 0);
        QVERIFY(wire::ask(*bus, wire::frame(9, 0x04, {40, 1}), now).empty());
        QVERIFY(wire::ask(*bus, wire::frame(9, 0x05), now).empty());
        QCOMPARE(torque(0), 1);
        QCOMPARE(torque(1), 1);
        QVERIFY(!wire::ask(*bus, wire::write(2, 40, 0), now).empty());
        QCOMPARE(torque(0), 1);
        QCOMPARE(torque(1), 0);
    }
};

SERVODESK_GUILESS_TEST(TestWireProtocols)
#include "tst_wire_protocols.moc"
