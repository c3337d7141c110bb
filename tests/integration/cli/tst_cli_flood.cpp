// SPDX-License-Identifier: GPL-3.0-or-later
// The built command line on a line that is never silent: valid frames or garbage at 1 MB/s, or one
// byte per millisecond. Every command ends by itself and names the cause; Ctrl-C ends it; torque is
// off and the lock closed as far as frames reach the servo; the memory is unchanged.
#include "integration/flood_cable.h"
#include "support/cli_program.h"
#include "support/deep_check.h"
#include "support/test_main.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::FloodCable;
using support::ProgramResult;
using support::SimProgram;
using support::words;

namespace {
constexpr double megabyte = 1e6;

QByteArray frames()
{
    return support::statusPacket(1).repeated(100);
}

/// WRITE of the goal position.
const QByteArray goalWriteBytes = QByteArray::fromHex("032A");

const QString neverSilentText = QStringLiteral("bus is never idle");

/// Peak memory of the program, in KiB.
int peakMemory(qint64 pid)
{
    QFile file(QStringLiteral("/proc/%1/status").arg(pid));
    if (!file.open(QIODevice::ReadOnly))
        return -1;
    for (const QByteArray& line : file.readAll().split('\n')) {
        if (line.startsWith("VmHWM:"))
            return line.simplified().split(' ').value(1).toInt();
    }
    return -1;
}
} // namespace

class TestCliFlood : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyCommandReportsTheCause_data();
    void everyCommandReportsTheCause();
    void aSlowStreamIsNoise();
    void ctrlCEndsAWriteAndClosesTheLock_data();
    void ctrlCEndsAWriteAndClosesTheLock();
    void torqueGoesOffInAFlood_data();
    void torqueGoesOffInAFlood();
    void aFloodDuringASweepLeavesTorqueOff();
    void aFloodedTestReportsTheCause_data();
    void aFloodedTestReportsTheCause();
    void watchEndsByItselfInFlatMemory();
    void aScanDistinguishesServosFromTheFlood();
};

void TestCliFlood::everyCommandReportsTheCause_data()
{
    QTest::addColumn<FloodCable::Endpoint>("front");
    QTest::addColumn<QByteArray>("unit");
    QTest::addColumn<QString>("line");
    const std::pair<const char*, FloodCable::Endpoint> fronts[] = {
        {"terminal", FloodCable::Endpoint::Terminal}, {"TCP", FloodCable::Endpoint::Tcp}};
    for (const auto& [name, front] : fronts) {
        for (const char* line :
             {"scan", "read 1 id", "write 1 max_temperature=60", "torque 1 on", "watch 1",
              "set-id 1 9", "move 1=2048", "sweep 1 --from 1000 --to 2000 --delay 500 --cycles 1",
              "step-response 1 --size 300",
              "commission --auto --first-id 9 --count 1 --batch @/b.csv"}) {
            const bool terminal = front == FloodCable::Endpoint::Terminal;
            if (terminal || support::isDeepCheck())
                QTest::addRow("frames, %s, %s", name, line)
                    << front << frames() << QString::fromLatin1(line);
            if (!terminal || support::isDeepCheck())
                QTest::addRow("garbage, %s, %s", name, line)
                    << front << support::garbage(4096) << QString::fromLatin1(line);
        }
    }
}

void TestCliFlood::everyCommandReportsTheCause()
{
    QFETCH(const FloodCable::Endpoint, front);
    QFETCH(const QByteArray, unit);
    QFETCH(const QString, line);
    FloodCable cable(front, {});
    CliProgram cli;
    cli.setPort(cable.port());
    cable.flood(unit, megabyte);
    const ProgramResult result =
        cli.run(words(qPrintable(QString(line).replace(u'@', cli.dataFolder()))));
    QVERIFY2(result.err.contains(neverSilentText), qPrintable(result.out + result.err));
    QCOMPARE(result.exit, 4);
    QVERIFY2(!result.out.contains(QStringLiteral("found on")), qPrintable(result.out));
}

void TestCliFlood::aSlowStreamIsNoise()
{
    FloodCable cable(FloodCable::Endpoint::Terminal, {});
    CliProgram cli;
    cli.setPort(cable.port());
    cable.flood(QByteArray(1, 'U'), 1000);
    const ProgramResult result = cli.run("read 1 id");
    QVERIFY2(result.err.contains(QStringLiteral("could not be decoded")),
             qPrintable(result.out + result.err));
    QCOMPARE(result.exit, 4);
}

void TestCliFlood::ctrlCEndsAWriteAndClosesTheLock_data()
{
    QTest::addColumn<QByteArray>("unit");
    QTest::addColumn<double>("rate");
    QTest::newRow("frames") << frames() << megabyte;
    QTest::newRow("garbage") << support::garbage(4096) << megabyte;
    QTest::newRow("a byte each millisecond") << QByteArray(1, 'U') << 1000.0;
}

void TestCliFlood::ctrlCEndsAWriteAndClosesTheLock()
{
    QFETCH(const QByteArray, unit);
    QFETCH(const double, rate);
    SimProgram sim(words("--servos sts3215@1"));
    FloodCable cable(FloodCable::Endpoint::Terminal, sim.port());
    CliProgram cli;
    cli.setPort(cable.port());
    // WRITE 55 := 0: the lock is open from here on.
    cable.floodOnFrame(QByteArray::fromHex("033700"), unit, rate);
    cli.start(words("write 1 max_temperature=60 max_voltage=85 position_p=20 speed_p=20 "
                    "overload_torque=70 --json"));
    QTRY_VERIFY(cable.flooding() || cli.process().state() == QProcess::NotRunning);
    QElapsedTimer timer;
    timer.start();
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    // 500 ms are promised; tests share the processor.
    QVERIFY2(timer.elapsed() < 2000, qPrintable(QString::number(timer.elapsed())));
    QVERIFY2(result.exit > 0, qPrintable(result.out + result.err));
    cable.flood({}, 0);
    // The commands of the program have reached the servo: its lock is closed.
    // Late replies of a busy machine do not matter here.
    const ProgramResult after = cli.json("read 1 lock --timeout 200");
    QCOMPARE(after.json()[QLatin1String("registers")][0][QLatin1String("raw")].toInt(-1), 1);
    QCOMPARE(cli.run("recover --undo --timeout 200").exit, 0);
    QVERIFY(cli.json("recover").json()[QLatin1String("intents")].toArray().isEmpty());
}

void TestCliFlood::torqueGoesOffInAFlood_data()
{
    QTest::addColumn<QString>("line");
    for (const char* line : {"torque 1 off", "stop 1", "stop 1-3"})
        QTest::newRow(line) << QString::fromLatin1(line);
}

/// Not even its identity can be read.
void TestCliFlood::torqueGoesOffInAFlood()
{
    QFETCH(const QString, line);
    SimProgram sim(words("--servos sts3215@1"));
    FloodCable cable(FloodCable::Endpoint::Terminal, sim.port());
    CliProgram cli;
    cli.setPort(cable.port());
    QCOMPARE(cli.run("torque 1 on").exit, 0);
    cable.flood(frames(), megabyte);
    const ProgramResult result = cli.run(words(qPrintable(line)));
    QVERIFY2(result.err.contains(QStringLiteral("torque-off command was sent")),
             qPrintable(result.out + result.err));
    QVERIFY(result.exit != 0);
    cable.flood({}, 0);
    const ProgramResult after = cli.json("read 1 torque_switch");
    QCOMPARE(after.json()[QLatin1String("registers")][0][QLatin1String("raw")].toInt(-1), 0);
}

void TestCliFlood::aFloodDuringASweepLeavesTorqueOff()
{
    SimProgram sim(words("--servos sts3215@1"));
    FloodCable cable(FloodCable::Endpoint::Terminal, sim.port());
    CliProgram cli;
    cli.setPort(cable.port());
    cable.floodOnFrame(goalWriteBytes, frames(), megabyte);
    cli.start(words("sweep 1 --from 1000 --to 3000 --delay 800 --cycles 50 --torque-off"));
    QTRY_VERIFY(cable.flooding());
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QVERIFY2(result.exit > 0, qPrintable(result.out + result.err));
    cable.flood({}, 0);
    const ProgramResult after = cli.json("read 1 torque_switch");
    QCOMPARE(after.json()[QLatin1String("registers")][0][QLatin1String("raw")].toInt(-1), 0);
}

void TestCliFlood::aFloodedTestReportsTheCause_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QByteArray>("trigger");
    QTest::newRow("sweep") << QStringLiteral(
                                  "sweep 1 --from 1000 --to 3000 --delay 800 --cycles 50")
                           << goalWriteBytes;
    QTest::newRow("step response")
        << QStringLiteral("step-response 1 --size 300") << QByteArray::fromHex("0329");
}

/// The message names the noise, because the adapter is still connected.
void TestCliFlood::aFloodedTestReportsTheCause()
{
    QFETCH(const QString, line);
    QFETCH(const QByteArray, trigger);
    SimProgram sim(words("--servos sts3215@1"));
    FloodCable cable(FloodCable::Endpoint::Terminal, sim.port());
    CliProgram cli;
    cli.setPort(cable.port());
    cable.floodOnFrame(trigger, frames(), megabyte);
    const ProgramResult result = cli.run(words(qPrintable(line)));
    QVERIFY(cable.flooding());
    QVERIFY2(result.err.contains(neverSilentText), qPrintable(result.out + result.err));
    QVERIFY2(result.exit > 0 && !result.out.contains(QStringLiteral("Pass")),
             qPrintable(result.out));
}

void TestCliFlood::watchEndsByItselfInFlatMemory()
{
    SimProgram sim(words("--servos sts3215@1"));
    FloodCable cable(FloodCable::Endpoint::Tcp, sim.port());
    CliProgram cli;
    cli.setPort(cable.port());
    // The address sanitizer keeps up to 256 MB of freed memory, which does not count.
    cli.setEnvironment(QStringLiteral("ASAN_OPTIONS"), qEnvironmentVariable("ASAN_OPTIONS") +
                                                           QStringLiteral(":quarantine_size_mb=1"));
    cli.start(words("watch 1"));
    QVERIFY(cli.waitForOutput("0.5"));
    const int before = peakMemory(cli.process().processId());
    cable.flood(frames(), 20 * megabyte);
    int during = before;
    while (!cli.process().waitForFinished(100))
        during = std::max(during, peakMemory(cli.process().processId()));
    const ProgramResult result = cli.finish();
    QCOMPARE(result.exit, 4);
    QVERIFY2(result.err.contains(neverSilentText), qPrintable(result.out + result.err));
    // KiB, for the line, its trace and unexpected frames; the sanitizer doubles them. The flood is
    // 20 MB a second.
    constexpr int buffers = 20 * 1024;
    qInfo("peak %d KiB before the flood, %d KiB in it", before, during);
    QVERIFY2(before > 0 && during < before + buffers, qPrintable(QString::number(during)));
}

void TestCliFlood::aScanDistinguishesServosFromTheFlood()
{
    SimProgram sim(words("--servos sts3215@1,sts3215@7"));
    FloodCable cable(FloodCable::Endpoint::Terminal, sim.port());
    CliProgram cli;
    cli.setPort(cable.port());
    // Noise with pauses: the servos are found, and the noise is reported.
    cable.flood(QByteArray(1, 'U'), 1000);
    const ProgramResult result = cli.json("scan --ids 0-20 --slow");
    const QJsonArray found = result.json()[QLatin1String("found")].toArray();
    QCOMPARE(found.size(), 2);
    QCOMPARE(found[0][QLatin1String("id")].toInt(), 1);
    QCOMPARE(found[1][QLatin1String("id")].toInt(), 7);
    // Packets of an absent servo are not taken for replies.
    cable.flood(frames(), megabyte);
    const ProgramResult busy = cli.run("scan --ids 0-20");
    QCOMPARE(busy.exit, 4);
    QVERIFY2(busy.err.contains(neverSilentText), qPrintable(busy.out + busy.err));
}

SERVODESK_GUILESS_TEST(TestCliFlood)
#include "tst_cli_flood.moc"
