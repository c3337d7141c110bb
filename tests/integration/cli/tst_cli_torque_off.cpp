// SPDX-License-Identifier: GPL-3.0-or-later
// "torque … off" and "stop" for several servos that know only bytes: the order of the frames, and
// that nothing is read before the command for the last servo has been sent.
#include "integration/raw_servo_bus.h"
#include "support/cli_program.h"
#include "support/feetech_bytes.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::goalAddress;
using support::modeAddress;
using support::ProgramResult;
using support::torqueSwitch;
using namespace std::chrono_literals;

namespace {
constexpr int broadcastId = 254;
constexpr int readInstruction = 0x02;
constexpr int writeInstruction = 0x03;
constexpr int syncWriteInstruction = 0x83;
constexpr int speedAddress = 46;
constexpr int placeAddress = 56;
constexpr int speedMode = 1;

using Frames = std::vector<QByteArray>;

int at(const QByteArray& frame, int place)
{
    return place < frame.size() ? static_cast<unsigned char>(frame[place]) : -1;
}

/// Index of the first READ of `id` (-1: of any servo); the number of frames if there is none. The
/// probe for an echo is a READ of the broadcast ID, to which there is no reply.
std::size_t firstRead(const Frames& frames, int id = -1)
{
    const auto found = std::find_if(frames.begin(), frames.end(), [id](const QByteArray& frame) {
        return at(frame, 4) == readInstruction &&
               (id < 0 ? at(frame, 2) != broadcastId : at(frame, 2) == id);
    });
    return std::size_t(found - frames.begin());
}

/// Index of the first WRITE of `address` to only this servo.
std::size_t firstWrite(const Frames& frames, int id, int address)
{
    const auto found = std::find_if(frames.begin(), frames.end(), [&](const QByteArray& frame) {
        return at(frame, 2) == id && at(frame, 4) == writeInstruction && at(frame, 5) == address;
    });
    return std::size_t(found - frames.begin());
}

std::size_t firstPacket(const Frames& frames)
{
    const auto found = std::find_if(frames.begin(), frames.end(), [](const QByteArray& frame) {
        return at(frame, 4) == syncWriteInstruction;
    });
    return std::size_t(found - frames.begin());
}

qint64 readsBefore(const Frames& frames, std::size_t place)
{
    return std::count_if(frames.begin(), frames.begin() + std::ptrdiff_t(place),
                         [](const QByteArray& frame) {
                             return at(frame, 4) == readInstruction && at(frame, 2) != broadcastId;
                         });
}

/// Torque on, turning as a wheel.
void turn(bytes::Bus& bus, const std::vector<int>& ids)
{
    for (const int id : ids) {
        bus.setByte(id, modeAddress, speedMode);
        bus.setByte(id, torqueSwitch, 1);
        bus.setByte(id, speedAddress, 200);
    }
}
} // namespace

class TestCliTorqueOff : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void torqueOffIsSentToAllBeforeReading_data();
    void torqueOffIsSentToAllBeforeReading();
    void silentServosDoNotDelayTorqueOff();
    void packetsStayWithinTheSizeLimit();
    void resultsBeforeCtrlCAreReported_data();
    void resultsBeforeCtrlCAreReported();
    void unstartedWorkAtCtrlCIsReported();
    void unknownRateDoesNotDelayTorqueOff();
    void silentServosDoNotDelayAStop();
    void aLostReplyDelaysNoStop();
    void allAreStoppedBeforeAnyConfirmation_data();
    void allAreStoppedBeforeAnyConfirmation();
};

void TestCliTorqueOff::torqueOffIsSentToAllBeforeReading_data()
{
    QTest::addColumn<int>("latency");
    QTest::newRow("prompt adapter") << 1;
    QTest::newRow("slow adapter") << 60;
}

void TestCliTorqueOff::torqueOffIsSentToAllBeforeReading()
{
    QFETCH(int, latency);
    bytes::Bus bus({1, 2, 3, 4, 9}, std::chrono::milliseconds(latency));
    turn(bus, {1, 2, 3, 4, 9});
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.run("torque 1-4 off --protocol feetech");
    QVERIFY2(result.exit == 0, qPrintable(result.err));
    const Frames frames = bus.frames();
    const std::size_t read = firstRead(frames);
    const std::size_t packet = firstPacket(frames);
    QVERIFY(packet < read);
    QCOMPARE(frames[packet].mid(4, 11), QByteArray::fromHex("8328010100020003000400"));
    for (const int id : {1, 2, 3, 4}) {
        QVERIFY(firstWrite(frames, id, torqueSwitch) < read);
        QCOMPARE(bus.byteAt(id, torqueSwitch), 0);
    }
    QCOMPARE(bus.byteAt(9, torqueSwitch), 1); // was not named
    QVERIFY2(result.err.contains(QStringLiteral("1, 2, 3, 4")), qPrintable(result.err));
}

void TestCliTorqueOff::silentServosDoNotDelayTorqueOff()
{
    bytes::Bus bus({1}, 1ms);
    turn(bus, {1});
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.run("torque 30-34 1 off --protocol feetech");
    QCOMPARE(result.exit, 4);
    const Frames frames = bus.frames();
    for (const int id : {30, 34, 1})
        QVERIFY(firstWrite(frames, id, torqueSwitch) < firstRead(frames));
    QCOMPARE(bus.byteAt(1, torqueSwitch), 0);
    QVERIFY2(result.out.contains(QStringLiteral("Servo 1: torque off")), qPrintable(result.out));
}

void TestCliTorqueOff::packetsStayWithinTheSizeLimit()
{
    bytes::Bus bus({200}, 1ms);
    turn(bus, {200});
    CliProgram cli;
    cli.setPort(bus.port());
    cli.start(support::words("torque 0-200 off --protocol feetech"));
    QTRY_COMPARE(bus.byteAt(200, torqueSwitch), 0);
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QVERIFY2(result.err.contains(QStringLiteral("Canceled before confirmation")),
             qPrintable(result.err));
    QVERIFY(!result.err.contains(QStringLiteral("were not executed")));
    QSet<int> named;
    for (const QByteArray& frame : bus.frames()) {
        if (at(frame, 4) != syncWriteInstruction)
            continue;
        QVERIFY(frame.size() <= 250);
        for (int place = 7; place < frame.size() - 1; place += 2)
            named.insert(at(frame, place));
    }
    QCOMPARE(named.size(), 201);
}

void TestCliTorqueOff::resultsBeforeCtrlCAreReported_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("done");
    QTest::newRow("torque off") << QStringLiteral("torque 30-49 1 off --protocol feetech")
                                << QStringLiteral("Servo 1: torque off");
    QTest::newRow("stop") << QStringLiteral("stop 30-49 1 --protocol feetech")
                          << QStringLiteral("Servo 1: stopped");
}

void TestCliTorqueOff::resultsBeforeCtrlCAreReported()
{
    QFETCH(QString, command);
    QFETCH(QString, done);
    bytes::Bus bus({1}, 1ms);
    turn(bus, {1});
    CliProgram cli;
    cli.setPort(bus.port());
    cli.start(command.split(QLatin1Char(' ')));
    const auto isAsked = [&] { // the silent servo, after all that reply
        const Frames frames = bus.frames();
        return firstRead(frames, 30) < frames.size();
    };
    QTRY_VERIFY(isAsked());
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QVERIFY(result.exit != 0);
    QVERIFY2(result.out.contains(done), qPrintable(result.out + result.err));
    QVERIFY2(
        result.err.contains(QRegularExpression(QStringLiteral("confirmation \\(ID [^)]*49\\)"))),
        qPrintable(result.err));
    QVERIFY2(!result.err.contains(QStringLiteral("stopped")), qPrintable(result.err));
}

void TestCliTorqueOff::unstartedWorkAtCtrlCIsReported()
{
    bytes::Bus bus({1}, 1ms);
    CliProgram cli;
    cli.setPort(bus.port());
    cli.start(support::words("torque 1 30-49 on --protocol feetech"));
    const auto isAsked = [&] {
        const Frames frames = bus.frames();
        return firstRead(frames, 30) < frames.size();
    };
    QTRY_VERIFY(isAsked());
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QVERIFY2(result.out.contains(QStringLiteral("Servo 1: torque on")), qPrintable(result.out));
    QVERIFY2(result.err.contains(QRegularExpression(QStringLiteral("sent \\(ID [^)]*49\\)"))),
             qPrintable(result.err));
    QVERIFY2(!result.err.contains(QStringLiteral("orque may still be on")), qPrintable(result.err));
}

/// A pseudo-terminal carries bytes at any rate.
void TestCliTorqueOff::unknownRateDoesNotDelayTorqueOff()
{
    bytes::Bus bus({1, 2}, 1ms);
    turn(bus, {1, 2});
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.run("torque 1 2 off --protocol feetech --baud auto");
    QVERIFY2(result.exit == 0, qPrintable(result.err));
    const Frames frames = bus.frames();
    for (const int id : {1, 2})
        QVERIFY(firstWrite(frames, id, torqueSwitch) < firstRead(frames));
}

void TestCliTorqueOff::silentServosDoNotDelayAStop()
{
    bytes::Bus bus({1}, 1ms);
    turn(bus, {1});
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.run("stop 30-33 1 --protocol feetech");
    QCOMPARE(result.exit, 4);
    const Frames frames = bus.frames();
    const std::size_t stopped = firstWrite(frames, 1, speedAddress);
    QVERIFY(stopped < frames.size());
    for (const int id : {30, 31, 32, 33}) {
        QVERIFY(stopped < firstRead(frames, id));
        QVERIFY(firstWrite(frames, id, torqueSwitch) < frames.size()); // it may be turning
    }
    QCOMPARE(bus.byteAt(1, speedAddress), 0);
    QCOMPARE(bus.byteAt(1, torqueSwitch), 1);
}

/// A servo that missed the first PING is commanded with the others.
void TestCliTorqueOff::aLostReplyDelaysNoStop()
{
    bytes::Bus bus({1, 2}, 1ms);
    turn(bus, {1, 2});
    bus.dropPings(1, 1);
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.run("stop 1 2 --protocol feetech");
    QVERIFY2(result.exit == 0, qPrintable(result.err));
    QVERIFY2(result.err.contains(QStringLiteral("(ID 2, 1)")),
             qPrintable(result.err)); // confirming both
    QVERIFY2(!result.err.contains(QStringLiteral("No reply yet")), qPrintable(result.err));
    for (const int id : {1, 2})
        QCOMPARE(bus.byteAt(id, speedAddress), 0);
}

void TestCliTorqueOff::allAreStoppedBeforeAnyConfirmation_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<int>("command");
    QTest::newRow("wheels") << speedMode << speedAddress;
    QTest::newRow("positions") << 0 << goalAddress;
}

void TestCliTorqueOff::allAreStoppedBeforeAnyConfirmation()
{
    QFETCH(int, mode);
    QFETCH(int, command);
    constexpr int maxReadsPerServo = 5;
    const std::vector<int> ids{1, 2, 3, 4};
    bytes::Bus bus({1, 2, 3, 4}, 20ms);
    turn(bus, ids);
    for (const int id : ids)
        bus.setByte(id, modeAddress, mode);
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.run("stop 1-4 --protocol feetech");
    QVERIFY2(result.exit == 0, qPrintable(result.err));
    const Frames frames = bus.frames();
    for (const int id : ids) {
        const std::size_t stopped = firstWrite(frames, id, command);
        QVERIFY(stopped < frames.size());
        const auto reads = readsBefore(frames, stopped);
        QVERIFY2(reads <= maxReadsPerServo * id, qPrintable(QString::number(reads)));
        QCOMPARE(bus.byteAt(id, command),
                 command == goalAddress ? bus.byteAt(id, placeAddress) : 0);
        QCOMPARE(bus.byteAt(id, torqueSwitch), 1);
    }
    QVERIFY2(result.err.contains(QStringLiteral("1, 2, 3, 4")), qPrintable(result.err));
}

SERVODESK_GUILESS_TEST(TestCliTorqueOff)
#include "tst_cli_torque_off.moc"
