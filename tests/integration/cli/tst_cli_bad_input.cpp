// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of users and machines in the built program: arguments, ports, files, disks, model files.
// Each ends with a message, a remedy and the right exit code, never with a crash.
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <sys/resource.h>

using support::CliProgram;
using support::ProgramResult;
using support::words;

namespace {
void writeFile(const QString& path, const QByteArray& text)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}
/// Like an exhausted quota: there is room for the lock file of the port, but not for the journal.
void limitDiskSpace()
{
    const rlimit little{256, 256};
    setrlimit(RLIMIT_FSIZE, &little);
}
} // namespace

class TestCliBadInput : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void hostileArguments_data();
    void hostileArguments();
    void typosAreAnswered_data();
    void typosAreAnswered();
    void badPorts_data();
    void badPorts();
    void withoutAPortTheChoicesAreShown();
    void fullDiskEndsAWatch();
    void fullDiskForTheResult();
    void aClosedPipeIsNoError();
    void withoutAJournalNothingIsWritten_data();
    void withoutAJournalNothingIsWritten();
    void withoutASavedTableNoFirmwareIsSent_data();
    void withoutASavedTableNoFirmwareIsSent();
    void badSnapshotFiles_data();
    void badSnapshotFiles();
    void badModelFilesCauseAWarning_data();
    void badModelFilesCauseAWarning();
    void anUnknownLocaleIsSilent();
};

void TestCliBadInput::hostileArguments_data()
{
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char* name, const QStringList& arguments) {
        QTest::newRow(name) << arguments;
    };
    const auto line = [&row](const char* text) { row(text, words(text)); };
    row("nothing", {});
    row("empty words", {QString(), QString()});
    row("empty ID", {QStringLiteral("info"), QString()});
    row("blank ID", {QStringLiteral("info"), QStringLiteral(" 1")});
    row("NUL-like", {QStringLiteral("info"), QStringLiteral("\\0")});
    row("Arabic digits", {QStringLiteral("info"), QStringLiteral("١")});
    row("very long", {QStringLiteral("read"), QStringLiteral("1"), QString(100'000, u'a')});
    row("empty value", {QStringLiteral("write"), QStringLiteral("1"), QStringLiteral("id=")});
    row("markup", {QStringLiteral("read"), QStringLiteral("1"), QStringLiteral("%1%n\n\033[31m")});
    for (const char* text : {"info",
                             "info -1",
                             "info 254",
                             "info 255",
                             "info 1.0",
                             "info 0x1",
                             "info 1e0",
                             "info 99999999999999999999",
                             "info 1 2",
                             "info --",
                             "scan --ids 5-1",
                             "scan --ids -",
                             "scan --ids 1-254",
                             "scan --bauds 0",
                             "scan --bauds all,all",
                             "scan --bauds 1,",
                             "scan extra",
                             "read 1",
                             "read x id",
                             "write 1",
                             "write 1 id",
                             "write 1 =5",
                             "write 1 max_temperature==5",
                             "write 1 max_temperature=nan",
                             "write 1 max_temperature=inf",
                             "write 1 max_temperature=1e3",
                             "write 1 max_temperature=0x7fffffffffffffffff",
                             "write 1 max_voltage=8.5A",
                             "write 1 max_temperature=60 max_temperature=61",
                             "write 1 led_alarm_condition=fire",
                             "set-id 1",
                             "set-id 1 254",
                             "set-id 1 -3",
                             "set-baud 1 9601",
                             "set-baud 1 all",
                             "torque on",
                             "torque 1",
                             "torque 1 sideways",
                             "torque 1-300 on",
                             "mode 1",
                             "mode 1 fly",
                             "move",
                             "move 1",
                             "move 1=",
                             "move =5",
                             "move 1=5 1=6",
                             "move 1=2048 --how shout",
                             "move 1=2048 --speed fast",
                             "move 1=2048 --speed",
                             "watch",
                             "watch 1 --rate 0",
                             "watch 1 --rate -5",
                             "watch 1 --rate fast",
                             "watch 1 --duration 0",
                             "watch 1 --duration forever",
                             "raw",
                             "raw ZZ",
                             "raw 0x",
                             "recover --finish --undo",
                             "snapshot",
                             "snapshot save",
                             "snapshot save 1",
                             "snapshot show",
                             "snapshot sing",
                             "tour twice",
                             "--baud 7 ports",
                             "--baud",
                             "--timeout -1 ports",
                             "--timeout soon ports",
                             "--retries 1000 ports",
                             "--lang tlh ports",
                             "--lang",
                             "--frobnicate ports",
                             "-x ports",
                             "ports --json=maybe",
                             "dump 1 --csv x",
                             "ports scan"})
        line(text);
}

void TestCliBadInput::hostileArguments()
{
    QFETCH(QStringList, arguments);
    CliProgram cli;
    const ProgramResult result = cli.run(arguments);
    QCOMPARE(result.exit, 2);
    QVERIFY(result.out.isEmpty());
    QVERIFY(!result.err.trimmed().isEmpty());
    QVERIFY2(!result.err.contains(QStringLiteral("p0")), qPrintable(result.err));
    static const QRegularExpression control(QStringLiteral("[\\x00-\\x09\\x0b-\\x1f]"));
    QVERIFY2(!result.err.contains(control), "terminal control characters were echoed");
}

void TestCliBadInput::typosAreAnswered_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* command, const char* said) {
        QTest::newRow(command) << QString::fromLatin1(command) << QString::fromLatin1(said);
    };
    row("scna", "scan");
    row("setid 1 2", "set-id");
    row("read 1 goal_positon", "goal_position");
    row("read 1 temperature", "max_temperature");
    row("write 1 id=5", "set-id");
    row("write 1 baud_rate=500000", "set-baud");
    row("write 1 torque_switch=1", "torque");
    row("write 1 phase=0", "--dangerous");
    row("write 1 max_temperature=hot", "0 to 100");
    row("write 1 operating_mode=fast --dangerous", "position, speed, pwm, step");
    row("mode 5 speed", "position, motor");
    row("info 42", "--bauds all");
}

void TestCliBadInput::typosAreAnswered()
{
    QFETCH(QString, command);
    QFETCH(QString, said);
    CliProgram cli;
    const ProgramResult result = cli.run(qPrintable(command));
    QVERIFY(result.exit == 2 || result.exit == 4);
    QVERIFY2(result.err.contains(said), qPrintable(result.err));
}

void TestCliBadInput::badPorts_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* port, int exit, const char* code) {
        QTest::newRow(port) << QString::fromLatin1(port) << exit << QString::fromLatin1(code);
    };
    row("/dev/ttyUSB99", 3, "port-missing");
    row("ttyNOWHERE7", 3, "port-missing");
    row("/dev/null", 3, "port-failed");
    row("tcp://127.0.0.1:1", 3, "port-failed");
    row("tcp://", 2, "bad-argument");
    row("tcp://127.0.0.1:99999", 2, "bad-argument");
    row("sim:", 2, "bad-argument");
    row("sim:nothing", 2, "bad-argument");
    row("sim:toaster@1", 2, "bad-argument");
    row("sim:sts3215@254", 2, "bad-argument");
}

void TestCliBadInput::badPorts()
{
    QFETCH(QString, port);
    QFETCH(int, exit);
    QFETCH(QString, code);
    CliProgram cli;
    cli.setPort(port);
    const ProgramResult result = cli.json("info 1");
    QCOMPARE(result.errorCode(), code);
    QCOMPARE(result.exit, exit);
}

void TestCliBadInput::withoutAPortTheChoicesAreShown()
{
    CliProgram cli;
    cli.setPort({});
    const ProgramResult result = cli.run("info 1");
    QCOMPARE(result.exit, 2);
    QVERIFY2(result.err.contains(QStringLiteral("sim:demo")), qPrintable(result.err));
}

void TestCliBadInput::fullDiskEndsAWatch()
{
    CliProgram cli;
    const ProgramResult result = cli.run("watch 1 --csv /dev/full");
    QCOMPARE(result.exit, 5);
    QVERIFY2(result.err.contains(QStringLiteral("/dev/full")), qPrintable(result.err));
    const ProgramResult json = cli.json("watch 1 --csv /dev/full");
    QCOMPARE(json.exit, 5);
    QCOMPARE(json.errorCode(), QStringLiteral("disk-full"));
}

void TestCliBadInput::fullDiskForTheResult()
{
    CliProgram cli;
    cli.process().setStandardOutputFile(QStringLiteral("/dev/full"));
    const ProgramResult result = cli.run("dump 1");
    QCOMPARE(result.exit, 5);
    QVERIFY2(result.err.contains(QStringLiteral("No space left")), qPrintable(result.err));
}

void TestCliBadInput::aClosedPipeIsNoError()
{
    CliProgram cli;
    QProcess head;
    cli.process().setStandardOutputProcess(&head);
    head.start(QStringLiteral("head"), {QStringLiteral("-n"), QStringLiteral("2")});
    const ProgramResult result = cli.run("watch 1 --rate max");
    QVERIFY(head.waitForFinished());
    QCOMPARE(result.exit, 5);
    QVERIFY2(!result.err.contains(QStringLiteral("could not be written")), qPrintable(result.err));
}

void TestCliBadInput::withoutAJournalNothingIsWritten_data()
{
    QTest::addColumn<QString>("folder");
    QTest::addColumn<bool>("full");
    QTest::newRow("full disk") << QString() << true;
    QTest::newRow("not a folder") << QStringLiteral("/dev/null") << false;
    QTest::newRow("cannot be made") << QStringLiteral("/proc/nowhere") << false;
}

void TestCliBadInput::withoutAJournalNothingIsWritten()
{
    QFETCH(QString, folder);
    QFETCH(bool, full);
    CliProgram cli;
    support::SimProgram sim(words("--servos sts3215@1"));
    cli.setPort(sim.port());
    if (full)
        cli.process().setChildProcessModifier(limitDiskSpace);
    else
        cli.setEnvironment(QStringLiteral("SERVODESK_DATA_DIR"), folder);
    const ProgramResult result = cli.json("write 1 max_temperature=60");
    QCOMPARE(result.exit, 5);
    // For Qt a quota is not a full disk; what matters is that no write was begun.
    const QString code = result.errorCode();
    QVERIFY2(code.startsWith(QLatin1String("file-un")) ||
                 (full && code == QLatin1String("disk-full")),
             qPrintable(code));
    cli.process().setChildProcessModifier({});
    const ProgramResult after = cli.json("read 1 max_temperature lock");
    QCOMPARE(after.exit, 0);
    QCOMPARE(after.json()[QLatin1String("registers")][0][QLatin1String("raw")].toInt(), 70);
    QCOMPARE(after.json()[QLatin1String("registers")][1][QLatin1String("raw")].toInt(), 1);
}

void TestCliBadInput::withoutASavedTableNoFirmwareIsSent_data()
{
    withoutAJournalNothingIsWritten_data();
}

/// Only a table that is saved can be restored: accepting it is the user's decision.
void TestCliBadInput::withoutASavedTableNoFirmwareIsSent()
{
    QFETCH(QString, folder);
    QFETCH(bool, full);
    CliProgram cli;
    const QString image = cli.dataFolder() + QStringLiteral("/SCServo21-GD32-TTL-250306.bin");
    writeFile(image, QByteArray(640, 'x'));
    cli.setPort(QStringLiteral("sim:sts3215@1"));
    if (full)
        cli.process().setChildProcessModifier(limitDiskSpace);
    else
        cli.setEnvironment(QStringLiteral("SERVODESK_DATA_DIR"), folder);
    const QStringList update{QStringLiteral("firmware"), QStringLiteral("update"), image,
                             QStringLiteral("1"), QStringLiteral("--json")};
    const ProgramResult refused = cli.run(update);
    QCOMPARE(refused.exit, 1);
    const QJsonValue servo = refused.json()[QLatin1String("servos")][0];
    QCOMPARE(servo[QLatin1String("outcome")].toString(), QStringLiteral("not-started"));
    QVERIFY(servo[QLatin1String("snapshot")].isNull());
    const ProgramResult accepted = cli.run(update + words("--accept saved-table"));
    QVERIFY2(accepted.exit == 0, qPrintable(accepted.out + accepted.err));
}

void TestCliBadInput::badSnapshotFiles_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("noise") << QByteArray("\x00\xff\xfe{", 4);
    QTest::newRow("other JSON") << QByteArray("[1, 2, 3]");
    QTest::newRow("truncated") << QByteArray("{\"format\": \"servodesk");
    QTest::newRow("deep") << QByteArray(50'000, '[');
}

void TestCliBadInput::badSnapshotFiles()
{
    QFETCH(QByteArray, content);
    CliProgram cli;
    const QString path = cli.dataFolder() + QStringLiteral("/bad.servo.json");
    writeFile(path, content);
    const ProgramResult result = cli.run(words("snapshot show --json") << path);
    QCOMPARE(result.exit, 5);
    QCOMPARE(result.errorCode(), QStringLiteral("file-format"));
}

void TestCliBadInput::badModelFilesCauseAWarning_data()
{
    badSnapshotFiles_data();
    QTest::newRow("hostile row") << QByteArray(
        R"({"maps": [{"key": "sts-sms", "registers": [{"key": "x", "address": -5, "size": 900}]}]})");
}

void TestCliBadInput::badModelFilesCauseAWarning()
{
    QFETCH(QByteArray, content);
    CliProgram cli;
    writeFile(cli.dataFolder() + QStringLiteral("/config/servodesk/models/mine.json"), content);
    const ProgramResult result = cli.run("info 1");
    QCOMPARE(result.exit, 0);
    QVERIFY2(result.err.contains(QStringLiteral("mine.json")), qPrintable(result.err));
    QVERIFY(result.out.contains(QStringLiteral("STS3215")));
}

void TestCliBadInput::anUnknownLocaleIsSilent()
{
    CliProgram cli;
    cli.setEnvironment(QStringLiteral("LANG"), QStringLiteral("xx_YY.ISO-8859-1"));
    const ProgramResult result = cli.run("read 5 id");
    QCOMPARE(result.exit, 0);
    QVERIFY2(!result.err.contains(QStringLiteral("locale")), qPrintable(result.err));
}

SERVODESK_GUILESS_TEST(TestCliBadInput)
#include "tst_cli_bad_input.moc"
