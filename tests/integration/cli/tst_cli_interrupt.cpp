// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C, SIGQUIT and SIGTERM for the built program: it ends soon, reports its results, and leaves
// no lock open.
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;
using support::words;

namespace {
/// A full pipe without a reader: a write to it blocks.
class FullPipe {
public:
    explicit FullPipe(const QString& path)
        : m_path(path)
    {
        const QByteArray name = QFile::encodeName(path);
        ::mkfifo(name.constData(), 0600);
        m_descriptor = ::open(name.constData(), O_RDWR | O_NONBLOCK);
        const QByteArray block(4096, 'x');
        while (::write(m_descriptor, block.constData(), std::size_t(block.size())) > 0) {
        }
    }
    ~FullPipe() { ::close(m_descriptor); }
    FullPipe(const FullPipe&) = delete;
    FullPipe& operator=(const FullPipe&) = delete;
    QString path() const { return m_path; }

private:
    QString m_path;
    int m_descriptor = -1;
};
} // namespace

class TestCliInterrupt : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void watchEndsWithItsSummary_data();
    void watchEndsWithItsSummary();
    void writeStopsBetweenStepsAndLocks();
    void scanShowsFoundServos();
    void tourEndsAtOnce();
    void secondSignalEndsAHungProgram();
    void killedWriteIsRecovered_data();
    void killedWriteIsRecovered();
    void openChangeCanBeDiscarded();
    void discardedChangesAreReported();

private:
    void killDuringWrite(CliProgram& cli);
};

void TestCliInterrupt::watchEndsWithItsSummary_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl-C") << SIGINT;
    QTest::newRow("quit") << SIGQUIT;
    QTest::newRow("terminate") << SIGTERM;
    QTest::newRow("hang up") << SIGHUP;
}

void TestCliInterrupt::watchEndsWithItsSummary()
{
    QFETCH(int, signal);
    CliProgram cli;
    const QString csv = cli.dataFolder() + QStringLiteral("/w.csv");
    cli.start(words("watch 1-6 --json --csv") << csv);
    QVERIFY(cli.waitForOutput("time_us"));
    cli.signal(signal);
    const ProgramResult result = cli.finish();
    QCOMPARE(result.exit, 0);
    QVERIFY(result.json().contains(QLatin1String("summary")));
    QFile file(csv);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().endsWith('\n'));
}

void TestCliInterrupt::writeStopsBetweenStepsAndLocks()
{
    CliProgram cli;
    // 60 ms a transaction: five registers take some seconds, enough for a busy machine.
    SimProgram sim(words("--servos sts3215@1 --latency-ms 60"));
    cli.setPort(sim.port());
    cli.start(words("write 1 max_temperature=60 max_voltage=85 position_p=20 speed_p=20 "
                    "overload_torque=70 --json"));
    QTRY_VERIFY(cli.openIntents() > 0);
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QCOMPARE(result.exit, 1);
    QCOMPARE(result.json()[QLatin1String("lock")].toString(), QStringLiteral("closed"));
    const QJsonArray writes = result.json()[QLatin1String("writes")].toArray();
    QCOMPARE(writes.size(), 5);
    QCOMPARE(writes[4][QLatin1String("outcome")].toString(), QStringLiteral("not-sent"));

    const ProgramResult after =
        cli.json("read 1 max_temperature max_voltage position_p speed_p overload_torque lock");
    QHash<QString, int> shown;
    for (const QJsonValue& row : after.json()[QLatin1String("registers")].toArray())
        shown[row[QLatin1String("key")].toString()] = row[QLatin1String("raw")].toInt();
    for (const QJsonValue& write : writes) {
        // Registers that were not written any more are unchanged and were not read back.
        const bool read = write[QLatin1String("read_back")].isDouble();
        const QLatin1String expected(read ? "read_back" : "old");
        QCOMPARE(shown.value(write[QLatin1String("key")].toString(), -1), write[expected].toInt());
    }
    QVERIFY(writes[4][QLatin1String("read_back")].isNull());
    QCOMPARE(shown.value(QStringLiteral("lock")), 1);
    QCOMPARE(cli.json("recover").json()[QLatin1String("intents")].toArray().size(), 0);
}

void TestCliInterrupt::scanShowsFoundServos()
{
    CliProgram cli;
    cli.start(words("scan --bauds all --json"));
    QVERIFY(cli.waitForError("baud")); // the progress appears after a second
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QCOMPARE(result.exit, 1);
    QCOMPARE(result.json()[QLatin1String("stopped")].toBool(), true);
}

void TestCliInterrupt::tourEndsAtOnce()
{
    CliProgram cli;
    cli.start(words("tour"));
    QVERIFY(cli.waitForOutput("1/9"));
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QCOMPARE(result.exit, 1);
    QVERIFY2(!result.out.contains(QStringLiteral("3/9")), qPrintable(result.out));
}

void TestCliInterrupt::secondSignalEndsAHungProgram()
{
    CliProgram cli;
    const FullPipe pipe(cli.dataFolder() + QStringLiteral("/pipe"));
    cli.process().setStandardOutputFile(pipe.path());
    cli.start(words("watch 1"));
    QVERIFY(cli.waitForError("SIMULATED"));
    QElapsedTimer timer;
    timer.start();
    // Signals of the same kind do not queue, hence the repetition.
    do {
        cli.signal(SIGINT);
    } while (!cli.process().waitForFinished(50) && timer.elapsed() < 60'000);
    QCOMPARE(cli.process().state(), QProcess::NotRunning);
    QCOMPARE(cli.process().exitStatus(), QProcess::CrashExit);
    QCOMPARE(cli.process().exitCode(), SIGINT); // with CrashExit: the signal that ended it
    QVERIFY2(timer.elapsed() >= 1900, "a lock being closed has two seconds");
}

void TestCliInterrupt::killedWriteIsRecovered_data()
{
    QTest::addColumn<QString>("how");
    QTest::addColumn<int>("temperature");
    QTest::addColumn<int>("overload");
    QTest::newRow("finish") << QStringLiteral("--finish") << 60 << 70;
    QTest::newRow("undo") << QStringLiteral("--undo") << 70 << 80;
}

void TestCliInterrupt::killDuringWrite(CliProgram& cli)
{
    cli.start(words("write 1 max_temperature=60 max_voltage=85 position_p=20 overload_torque=70"));
    QTRY_VERIFY(cli.openIntents() > 0);
    cli.signal(SIGKILL);
    QCOMPARE(cli.finish().exit, -1);
}

/// The servo and the port no longer exist.
void TestCliInterrupt::openChangeCanBeDiscarded()
{
    CliProgram cli;
    {
        SimProgram sim(words("--servos sts3215@1 --latency-ms 60"));
        cli.setPort(sim.port());
        killDuringWrite(cli);
        if (QTest::currentTestFailed())
            return;
    }
    // Not the name of the terminal: the next simulator may have got it.
    cli.setPort(QStringLiteral("/dev/no-such-servo-port"));
    QCOMPARE(cli.json("recover").exit, 3);
    QCOMPARE(cli.json("recover --forget nobody").exit, 2);
    const ProgramResult result = cli.json("recover --forget all");
    QCOMPARE(result.exit, 0);
    QCOMPARE(result.json()[QLatin1String("forgotten")].toArray().size(), 1);
    const QJsonObject given = result.json()[QLatin1String("given_up")][0].toObject();
    QCOMPARE(given[QLatin1String("id")].toInt(), 1);
    QCOMPARE(given[QLatin1String("items")].toArray().size(), 4);
    QCOMPARE(given[QLatin1String("lock_may_be_open")].toBool(), true);
    QCOMPARE(cli.json("recover").json()[QLatin1String("intents")].toArray().size(), 0);
}

void TestCliInterrupt::discardedChangesAreReported()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --latency-ms 60"));
    cli.setPort(sim.port());
    killDuringWrite(cli);
    if (QTest::currentTestFailed())
        return;
    const ProgramResult result = cli.run("recover --forget all");
    QCOMPARE(result.exit, 0);
    for (const char* said : {"servo 1", "max_temperature 70 → 60", "overload_torque",
                             "old or its new value", "EPROM may be unlocked"})
        QVERIFY2(result.out.contains(QString::fromUtf8(said)), qPrintable(result.out));
}

void TestCliInterrupt::killedWriteIsRecovered()
{
    QFETCH(QString, how);
    QFETCH(int, temperature);
    QFETCH(int, overload);
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --latency-ms 60"));
    cli.setPort(sim.port());
    killDuringWrite(cli);
    if (QTest::currentTestFailed())
        return;

    const ProgramResult look = cli.json("recover");
    QCOMPARE(look.exit, 0);
    const QJsonArray intents = look.json()[QLatin1String("intents")].toArray();
    QCOMPARE(intents.size(), 1);
    QCOMPARE(intents[0][QLatin1String("kind")].toString(), QStringLiteral("write"));
    QCOMPARE(intents[0][QLatin1String("items")].toArray().size(), 4);
    QCOMPARE(intents[0][QLatin1String("done")].toBool(true), false);

    const ProgramResult settled = cli.run(words("recover --json") << how);
    QVERIFY2(settled.exit == 0, qPrintable(settled.out));
    QCOMPARE(settled.json()[QLatin1String("intents")][0][QLatin1String("done")].toBool(), true);
    const QJsonArray rows = cli.json("read 1 max_temperature overload_torque lock")
                                .json()[QLatin1String("registers")]
                                .toArray();
    QCOMPARE(rows[0][QLatin1String("raw")].toInt(), temperature);
    QCOMPARE(rows[1][QLatin1String("raw")].toInt(), overload);
    QCOMPARE(rows[2][QLatin1String("raw")].toInt(), 1);
    QCOMPARE(cli.json("recover").json()[QLatin1String("intents")].toArray().size(), 0);
}

SERVODESK_GUILESS_TEST(TestCliInterrupt)
#include "tst_cli_interrupt.moc"
