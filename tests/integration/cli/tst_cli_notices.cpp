// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of the command line beside its result: notices of a failed command, an interrupted
// change, a second servo; neither a closed pipe nor a full disk suppresses them.
#include "integration/raw_servo_bus.h"
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;
using support::utf8;
using support::words;
using namespace std::chrono_literals;

namespace {
constexpr qint64 promptMs = 5000; ///< ms

QStringList noticeCodes(const ProgramResult& result)
{
    QStringList codes;
    for (const QJsonValue& note : result.json()[utf8("notes")].toArray())
        codes << note[utf8("code")].toString();
    return codes;
}

void killDuringWrite(CliProgram& cli, bytes::Bus& bus)
{
    cli.start(words("write 1 max_temperature=60 max_voltage=85 position_p=20 overload_torque=70"));
    QTRY_VERIFY(bus.byteAt(1, 55) == 0); // unlocked
    cli.signal(SIGKILL);
    QCOMPARE(cli.finish().exit, -1);
    bus.setLatency(0ms); // it left time to kill the program
}

/// Limits the size of files of this program and of those that it starts.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN); // also for programs that are started
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit little = m_before;
        little.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &little);
    }
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &m_before); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit m_before = {};
};
} // namespace

class TestCliNotices : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void aFailedCommandShowsItsNotices();
    void anOpenChangeIsReportedByEveryCommand();
    void aFullDiskIsReportedAndHidesNothing();
    void nonFilesAreRefusedAtOnce_data();
    void nonFilesAreRefusedAtOnce();
    void duplicateIdsAreNotSaved();
};

void TestCliNotices::aFailedCommandShowsItsNotices()
{
    bytes::Bus bus({1}, 0ms, bytes::RestartBehavior::Ignored);
    bus.setByte(1, 40, 1);
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.json("reboot 1");
    QVERIFY(result.exit != 0);
    QVERIFY2(result.json().contains(utf8("error")), qPrintable(result.out + result.err));
    QCOMPARE(bus.byteAt(1, 40), 0);
    QVERIFY2(noticeCodes(result).contains(utf8("torque-switched-off")), qPrintable(result.out));
}

void TestCliNotices::anOpenChangeIsReportedByEveryCommand()
{
    CliProgram cli;
    bytes::Bus bus({1}, 60ms);
    cli.setPort(bus.port());
    QVERIFY(!cli.run("read 1 position_p").err.contains(utf8("recover")));
    killDuringWrite(cli, bus);
    if (QTest::currentTestFailed())
        return;
    const QString command = utf8("servodesk-cli recover --port ") + bus.port();
    for (const char* line : {"read 1 position_p", "info 1", "scan --ids 1", "torque 1 off"}) {
        const ProgramResult result = cli.run(line);
        QVERIFY2(result.err.contains(command), qPrintable(result.err + result.out));
        QVERIFY2(noticeCodes(cli.json(line)).contains(utf8("open-change")), line);
    }
    const ProgramResult info = cli.run("info 1");
    QVERIFY2(info.out.contains(command) && !info.out.contains(utf8("lock=1")),
             qPrintable(info.out));
    QVERIFY(!cli.run("recover").err.contains(command)); // it lists them
    QCOMPARE(cli.run("recover --finish").exit, 0);
    QVERIFY(!cli.run("read 1 position_p").err.contains(command));
}

void TestCliNotices::aFullDiskIsReportedAndHidesNothing()
{
    CliProgram cli;
    bytes::Bus bus({1}, 60ms);
    cli.setPort(bus.port());
    killDuringWrite(cli, bus);
    if (QTest::currentTestFailed())
        return;
    QFile::remove(cli.historyFile() + utf8("-shm"));
    {
        const FullDisk disk(4096); // no room for SQLite's index
        const ProgramResult recover = cli.json("recover");
        QCOMPARE(recover.json()[utf8("intents")].toArray().size(), 1);
        const ProgramResult history = cli.json("history");
        QVERIFY2(history.exit == 0, qPrintable(history.out + history.err));
        QCOMPARE(cli.run("write 1 position_p=33").exit, 5);
    }
    QCOMPARE(cli.run("recover --finish").exit, 0);
}

void TestCliNotices::nonFilesAreRefusedAtOnce_data()
{
    QTest::addColumn<QString>("line");
    QTest::newRow("snapshot save") << utf8("snapshot save 1 PIPE");
    QTest::newRow("bundle save") << utf8("bundle save PIPE 1");
    QTest::newRow("watch --csv") << utf8("watch 1 --csv PIPE");
    QTest::newRow("history --csv") << utf8("history --csv PIPE");
    QTest::newRow("commission --batch") << utf8("commission --batch PIPE --first-id 5 --auto");
    QTest::newRow("a file that waits") << utf8("snapshot show /proc/kmsg");
}

void TestCliNotices::nonFilesAreRefusedAtOnce()
{
    QFETCH(QString, line);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    QCOMPARE(cli.run("write 1 position_p=40").exit, 0); // there is a history
    const QString pipe = cli.dataFolder() + utf8("/pipe");
    QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
    QElapsedTimer timer;
    timer.start();
    cli.start(line.replace(utf8("PIPE"), pipe).split(QLatin1Char(' ')));
    QVERIFY(cli.process().waitForFinished(promptMs));
    const ProgramResult result = cli.finish();
    QVERIFY2(result.exit > 0, qPrintable(result.out + result.err));
    if (!line.contains(utf8("/proc/")))
        QVERIFY2(result.err.contains(utf8("not a regular file")), qPrintable(result.err));
}

void TestCliNotices::duplicateIdsAreNotSaved()
{
    CliProgram cli;
    SimProgram sim(words("--preset trouble"));
    cli.setPort(sim.port());
    const QString file = cli.dataFolder() + utf8("/one.servo.json");
    for (const QStringList& line : {QStringList{utf8("snapshot"), utf8("save"), utf8("1"), file},
                                    QStringList{utf8("bundle"), utf8("save"), file, utf8("1")}}) {
        const ProgramResult result = cli.run(QStringList(line) << utf8("--json"));
        QVERIFY2(result.exit != 0, qPrintable(result.out));
        // Usually their replies cannot even be read.
        const QString code = result.json()[utf8("error")][utf8("code")].toString();
        QVERIFY2(code == utf8("several-servos") || code == utf8("garbled"), qPrintable(code));
        QVERIFY(!QFile::exists(file));
    }
}

SERVODESK_GUILESS_TEST(TestCliNotices)
#include "tst_cli_notices.moc"
