// SPDX-License-Identifier: GPL-3.0-or-later
// The output of the built command line about changes that are unfinished or could not be recorded:
// the adapter has got another name, the disk became full during a change, the history is locked.
#include "history/history_file.h"
#include "history/history_timeout.h"
#include "integration/flood_cable.h"
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <sys/resource.h>

using support::CliProgram;
using support::FloodCable;
using support::ProgramResult;
using support::SimProgram;
using support::words;

namespace {
QJsonArray list(const ProgramResult& result, const char* name)
{
    return result.json()[QLatin1String(name)].toArray();
}

/// The command that the program suggests, without the name of the program.
QStringList advised(const ProgramResult& result)
{
    QStringList command = result.json()[QLatin1String("try")].toString().split(QLatin1Char(' '));
    command.removeFirst();
    return command;
}

constexpr const char* fourRegisters =
    "write 1 max_temperature=60 max_voltage=85 position_p=20 overload_torque=70";
/// Both have a servo of the same model and ID.
struct TwoPorts {
    CliProgram cli;
    SimProgram own{words("--servos sts3215@1 --latency-ms 60")};
    SimProgram other{words("--servos sts3215@1")};
};
} // namespace

class TestCliRecover : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void anAdapterUnderAnotherNameHidesNothing();
    void openChangesAreListedWithoutAPort();
    void aMissingPortIsNotSuggested();
    void anAmbiguousNameDiscardsNothing();
    void aSimulatedBusIgnoresRealChanges();
    void aChangeInProgressIsNotDiscarded();
    void aDuplicateOnAnotherPortIsIgnored();
    void aSelectedChangeUsesAPresentPort();
    void aFullDiskAtTheEndHidesNoWrite();
    void aLostLinkLeavesTheRestUnsent();
    void aLockedHistoryIsReported();

private:
    void killDuringWrite(CliProgram& cli, const char* command = fourRegisters);
    void killOnOwnPort(TwoPorts& ports);
};

void TestCliRecover::killDuringWrite(CliProgram& cli, const char* command)
{
    const int before = std::max(0, cli.openIntents());
    cli.start(words(command));
    QTRY_VERIFY(cli.openIntents() > before);
    cli.signal(SIGKILL);
    QCOMPARE(cli.finish().exit, -1);
}

void TestCliRecover::killOnOwnPort(TwoPorts& ports)
{
    ports.cli.setPort(ports.own.port());
    killDuringWrite(ports.cli);
    ports.cli.setPort(ports.other.port());
}

void TestCliRecover::anAdapterUnderAnotherNameHidesNothing()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --latency-ms 60"));
    QString before;
    {
        const FloodCable cable(FloodCable::Endpoint::Tcp, sim.port());
        before = cable.port();
        cli.setPort(before);
        killDuringWrite(cli);
        if (QTest::currentTestFailed())
            return;
    }
    const FloodCable cable(FloodCable::Endpoint::Terminal, sim.port());
    cli.setPort(cable.port());
    const ProgramResult text = cli.run("recover");
    QCOMPARE(text.exit, 1);
    QVERIFY2(text.out.contains(before), qPrintable(text.out));
    QVERIFY2(!text.out.contains(QStringLiteral("No unfinished changes.")), qPrintable(text.out));

    const ProgramResult look = cli.json("recover");
    QCOMPARE(look.exit, 1);
    QCOMPARE(list(look, "intents").size(), 0);
    QCOMPARE(list(look, "elsewhere").size(), 1);
    QCOMPARE(list(look, "elsewhere")[0][QLatin1String("port")].toString(), before);
    QCOMPARE(list(look, "elsewhere")[0][QLatin1String("items")].toArray().size(), 4);
    QVERIFY2(text.out.contains(look.json()[QLatin1String("try")].toString()), qPrintable(text.out));

    // The suggested command, unchanged.
    cli.setPort({});
    const QStringList command = advised(look);
    const ProgramResult there = cli.run(QStringList(command) << QStringLiteral("--json"));
    QCOMPARE(there.exit, 0);
    QCOMPARE(list(there, "intents").size(), 1);
    QVERIFY(list(there, "intents")[0][QLatin1String("finding")].toString() !=
            QStringLiteral("no-answer"));
    const ProgramResult finished =
        cli.run(QStringList(command) << QStringLiteral("--finish") << QStringLiteral("--json"));
    QVERIFY2(finished.exit == 0, qPrintable(finished.out));
    QCOMPARE(list(finished, "intents")[0][QLatin1String("done")].toBool(), true);

    cli.setPort(cable.port());
    const ProgramResult after = cli.json("recover");
    QCOMPARE(after.exit, 0);
    QVERIFY(list(after, "intents").isEmpty() && list(after, "elsewhere").isEmpty());
    const ProgramResult read = cli.json("read 1 overload_torque lock");
    const QJsonArray rows = list(read, "registers");
    QVERIFY2(rows.size() == 2, qPrintable(read.out + read.err));
    QCOMPARE(rows[0][QLatin1String("raw")].toInt(), 70);
    QCOMPARE(rows[1][QLatin1String("raw")].toInt(), 1);
}

void TestCliRecover::openChangesAreListedWithoutAPort()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --latency-ms 60"));
    cli.setPort(sim.port());
    killDuringWrite(cli);
    if (QTest::currentTestFailed())
        return;
    cli.setPort(QStringLiteral("/dev/no-such-servo-port"));
    const ProgramResult result = cli.json("recover");
    QCOMPARE(result.exit, 3);
    QCOMPARE(result.json()[QLatin1String("error")][QLatin1String("code")].toString(),
             QStringLiteral("port-missing"));
    QCOMPARE(list(result, "elsewhere")[0][QLatin1String("port")].toString(), sim.port());
    const ProgramResult text = cli.run("recover");
    QCOMPARE(text.exit, 3);
    QVERIFY2(text.out.contains(sim.port()), qPrintable(text.out));
}

/// A suggested command never names a missing port, and the document contains it once. Another
/// program may get the number of a closed terminal, so the history gets port names that cannot
/// exist.
void TestCliRecover::aMissingPortIsNotSuggested()
{
    CliProgram cli;
    SimProgram first(words("--servos sts3215@1 --latency-ms 60"));
    SimProgram second(words("--servos sts3215@1 --latency-ms 60"));
    for (SimProgram* sim : {&first, &second}) {
        cli.setPort(sim->port());
        killDuringWrite(cli);
        if (QTest::currentTestFailed())
            return;
    }
    const QString gone = QStringLiteral("/dev/no-such-servo-port1");
    {
        const auto file = history::HistoryFile::open(cli.historyFile(), std::chrono::seconds(1));
        QVERIFY(file);
        QVERIFY((*file)->run(QStringLiteral("UPDATE intents SET port = '/dev/no-such-servo-port' "
                                            "|| (SELECT COUNT(*) FROM intents AS earlier "
                                            "WHERE earlier.number <= intents.number)"),
                             {}));
    }
    cli.setPort(gone);
    const ProgramResult result = cli.json("recover");
    QCOMPARE(result.exit, 3);
    QCOMPARE(result.out.count(QStringLiteral("\n  \"try\"")), 1);
    QCOMPARE(result.json()[QLatin1String("try")].toString(),
             QStringLiteral("servodesk-cli recover --any-port --port PORT"));
    const ProgramResult text = cli.run("recover");
    QVERIFY2(text.out.contains(QStringLiteral("--port PORT")), qPrintable(text.out));
    QVERIFY2(!text.out.contains(QStringLiteral("--port ") + gone), qPrintable(text.out));
}

/// Two changes whose names start alike: neither is abandoned.
void TestCliRecover::anAmbiguousNameDiscardsNothing()
{
    CliProgram cli;
    SimProgram first(words("--servos sts3215@1 --latency-ms 60"));
    SimProgram second(words("--servos sts3215@1 --latency-ms 60"));
    for (SimProgram* sim : {&first, &second}) {
        cli.setPort(sim->port());
        killDuringWrite(cli);
        if (QTest::currentTestFailed())
            return;
    }
    {
        const auto file = history::HistoryFile::open(cli.historyFile(), std::chrono::seconds(1));
        QVERIFY(file);
        QVERIFY((*file)->run(QStringLiteral("UPDATE intents SET uuid = 'same-' || number"), {}));
    }
    cli.setPort(QStringLiteral("/dev/no-such-servo-port"));
    const ProgramResult result = cli.run("recover --forget same-");
    QCOMPARE(result.exit, 2);
    QVERIFY2(result.err.contains(QStringLiteral("several changes")), qPrintable(result.err));
    QCOMPARE(cli.openIntents(), 2);
}

void TestCliRecover::aSimulatedBusIgnoresRealChanges()
{
    CliProgram cli;
    cli.setPort(QStringLiteral("sim:sts3215@1"));
    // The simulated bus answers at once: a plain write can be over before anybody looks.
    killDuringWrite(cli, "step-response 1 --size 300 --repeats 2 --hold 900 --try position_p=10");
    if (QTest::currentTestFailed())
        return;
    SimProgram sim(words("--servos sts3215@1"));
    cli.setPort(sim.port());
    const ProgramResult result = cli.json("recover --any-port");
    QCOMPARE(result.exit, 0);
    QVERIFY(list(result, "intents").isEmpty() && list(result, "elsewhere").isEmpty());
}

/// Another program that runs a test finishes its own change; if it is killed, its unfinished change
/// is found.
void TestCliRecover::aChangeInProgressIsNotDiscarded()
{
    CliProgram running;
    SimProgram sim(words("--servos sts3215@1"));
    running.setPort(sim.port());
    QCOMPARE(running.run("mode 1 speed").exit, 0);
    running.start(words("sweep 1 --from 1500 --to 2600 --delay 900 --cycles 50 --switch-mode"));
    QTRY_VERIFY(running.openIntents() > 0);
    CliProgram cli;
    cli.setEnvironment(QStringLiteral("SERVODESK_DATA_DIR"), running.dataFolder());
    cli.setPort(sim.port());
    const ProgramResult given = cli.json("recover --forget all");
    QVERIFY2(given.exit == 1, qPrintable(given.out));
    QVERIFY(list(given, "forgotten").isEmpty());
    QCOMPARE(list(given, "under_way").size(), 1);
    const ProgramResult text = cli.run("recover");
    QCOMPARE(text.exit, 3);
    QVERIFY2(!text.out.contains(QStringLiteral("other ports")), qPrintable(text.out));
    QVERIFY2(text.out.contains(QStringLiteral("in another program")), qPrintable(text.out));
    QVERIFY2(!text.out.contains(QStringLiteral("--any-port")), qPrintable(text.out));
    const ProgramResult look = cli.json("recover");
    QCOMPARE(list(look, "here").size(), 1);
    QCOMPARE(list(look, "here")[0][QLatin1String("under_way")].toBool(), true);
    QVERIFY(list(look, "elsewhere").isEmpty());
    QVERIFY(running.openIntents() > 0);

    running.signal(SIGKILL);
    QCOMPARE(running.finish().exit, -1);
    const ProgramResult undone = cli.json("recover --undo");
    QVERIFY2(undone.exit == 0, qPrintable(undone.out));
    QCOMPARE(list(undone, "intents").size(), 1);
    QCOMPARE(list(undone, "intents")[0][QLatin1String("under_way")].toBool(), false);
    const ProgramResult read = cli.json("read 1 operating_mode");
    QCOMPARE(list(read, "registers")[0][QLatin1String("raw")].toInt(), 1);
}

void TestCliRecover::aDuplicateOnAnotherPortIsIgnored()
{
    TwoPorts ports;
    CliProgram& cli = ports.cli;
    killOnOwnPort(ports);
    if (QTest::currentTestFailed())
        return;
    const ProgramResult look = cli.json("recover");
    QCOMPARE(look.exit, 1);
    QCOMPARE(list(look, "elsewhere")[0][QLatin1String("port_present")].toBool(), true);
    QCOMPARE(look.json()[QLatin1String("try")].toString(),
             QStringLiteral("servodesk-cli recover --port ") + ports.own.port());
    for (const char* how : {"recover --any-port", "recover --any-port --undo"}) {
        const ProgramResult result = cli.json(how);
        QVERIFY2(result.exit == 1, qPrintable(result.out));
        QVERIFY(list(result, "intents").isEmpty());
        QCOMPARE(list(result, "elsewhere").size(), 1);
    }
    cli.setPort({});
    const QStringList command = advised(look);
    const ProgramResult undone =
        cli.run(QStringList(command) << QStringLiteral("--undo") << QStringLiteral("--json"));
    QVERIFY2(undone.exit == 0, qPrintable(undone.out + undone.err));
    QCOMPARE(list(undone, "intents")[0][QLatin1String("done")].toBool(), true);
}

void TestCliRecover::aSelectedChangeUsesAPresentPort()
{
    TwoPorts ports;
    CliProgram& cli = ports.cli;
    killOnOwnPort(ports);
    if (QTest::currentTestFailed())
        return;
    const QString uuid =
        list(cli.json("recover"), "elsewhere")[0][QLatin1String("uuid")].toString();
    const QStringList named{QStringLiteral("recover"), QStringLiteral("--any-port"),
                            QStringLiteral("--change"), uuid.left(8)};
    const ProgramResult text = cli.run(named);
    QCOMPARE(text.exit, 0);
    QVERIFY2(text.out.contains(ports.own.port()) &&
                 text.out.contains(QStringLiteral("You have confirmed")),
             qPrintable(text.out));
    const ProgramResult undone =
        cli.run(QStringList(named) << QStringLiteral("--undo") << QStringLiteral("--json"));
    QVERIFY2(undone.exit == 0, qPrintable(undone.out));
    QCOMPARE(list(undone, "intents")[0][QLatin1String("done")].toBool(), true);
    QCOMPARE(cli.json("recover --change nothing").exit, 2);
}

void TestCliRecover::aFullDiskAtTheEndHidesNoWrite()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --latency-ms 60"));
    cli.setPort(sim.port());
    cli.start(words(fourRegisters) << QStringLiteral("--json"));
    QTRY_VERIFY(cli.openIntents() > 0);
    // From here on, no file of this program can grow.
    const rlimit little{256, 256};
    QCOMPARE(prlimit(pid_t(cli.process().processId()), RLIMIT_FSIZE, &little, nullptr), 0);
    const ProgramResult result = cli.finish();
    QVERIFY2(result.exit == 5, qPrintable(result.out + result.err));
    const QJsonArray writes = list(result, "writes");
    QCOMPARE(writes.size(), 4);
    for (const QJsonValue& write : writes)
        QCOMPARE(write[QLatin1String("outcome")].toString(), QStringLiteral("kept"));
    QCOMPARE(result.json()[QLatin1String("lock")].toString(), QStringLiteral("closed"));
    QStringList notes;
    for (const QJsonValue& note : list(result, "notes"))
        notes << note[QLatin1String("code")].toString();
    QVERIFY2(notes.contains(QStringLiteral("not-recorded")), qPrintable(result.out));

    // It is unfinished, and recovery finds everything written.
    const ProgramResult look = cli.json("recover");
    QCOMPARE(list(look, "intents").size(), 1);
    QCOMPARE(list(look, "intents")[0][QLatin1String("finding")].toString(),
             QStringLiteral("all-new"));
    QCOMPARE(cli.run("recover --finish").exit, 0);
}

void TestCliRecover::aLostLinkLeavesTheRestUnsent()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1"));
    FloodCable cable(FloodCable::Endpoint::Tcp, sim.port());
    cli.setPort(cable.port());
    cable.cutAt(QByteArray::fromHex("01040315")); // WRITE 21; 13 and 14 share a frame before it
    const ProgramResult result = cli.run(words(fourRegisters) << QStringLiteral("--json"));
    QCOMPARE(result.exit, 3);
    QStringList outcomes;
    for (const QJsonValue& write : list(result, "writes"))
        outcomes << write[QLatin1String("outcome")].toString();
    const QString notSent = QStringLiteral("not-sent");
    QCOMPARE(outcomes.size(), 4);
    QCOMPARE(outcomes[2], QStringLiteral("unknown"));
    QCOMPARE(outcomes[3], notSent);
    QVERIFY(cli.openIntents() > 0);
}

void TestCliRecover::aLockedHistoryIsReported()
{
    static_assert(2 * history::historyTimeout < std::chrono::seconds(2));
    CliProgram cli;
    QCOMPARE(cli.run("write 1 max_temperature=61").exit, 0);
    const auto other = history::HistoryFile::open(cli.historyFile(), std::chrono::seconds(5));
    QVERIFY(other);
    ProgramResult result;
    const auto held = (*other)->transaction([&]() -> base::Result<void> {
        QElapsedTimer timer;
        timer.start();
        result = cli.run("write 1 max_temperature=62");
        qInfo("said after %lld ms", timer.elapsed());
        return {};
    });
    QVERIFY(held);
    QCOMPARE(result.exit, 5);
    QVERIFY2(result.err.contains(QStringLiteral("he history has been locked for too long")),
             qPrintable(result.out + result.err));
    QCOMPARE(cli.run("write 1 max_temperature=62").exit, 0);
}

SERVODESK_GUILESS_TEST(TestCliRecover)
#include "tst_cli_recover.moc"
