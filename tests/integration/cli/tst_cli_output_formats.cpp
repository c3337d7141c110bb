// SPDX-License-Identifier: GPL-3.0-or-later
// The output of servodesk-cli on a healthy simulated bus: JSON structure, exit codes, both
// languages. Numbers come from the published register tables, not from our code.
#include "cli/command.h"
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

using support::CliProgram;
using support::ProgramResult;

namespace {
QSet<QString> keysOf(const QJsonValue& value)
{
    const QStringList keys = value.toObject().keys();
    return {keys.begin(), keys.end()};
}

QSet<QString> names(const char* line)
{
    const QStringList list = support::words(line);
    return {list.begin(), list.end()};
}

QJsonObject registerIn(const QJsonObject& document, const char* key)
{
    for (const QJsonValue& row : document[QLatin1String("registers")].toArray()) {
        if (row[QLatin1String("key")].toString() == QLatin1String(key))
            return row.toObject();
    }
    return {};
}

QString named(const QJsonObject& object, const char* key)
{
    return object[QLatin1String(key)].toString();
}

bool containsChinese(const QString& text)
{
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    return text.contains(han);
}
} // namespace

class TestCliOutputFormats : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aRawGoalWriteWarnsOfTorqueOn();
    void scanListsEveryServo();
    void emptyScanIsNoAnswer();
    void dumpHasTheWholeTable();
    void readKeepsTheRequestedOrder();
    void rawIsSignedForSignedRegisters();
    void writeReportsOutcomeAndLock_data();
    void writeReportsOutcomeAndLock();
    void errorsAreJsonDocumentsToo_data();
    void errorsAreJsonDocumentsToo();
    void consentWritesTheIdToo();
    void noticesGoToStderr();
    void infoShowsAlarmAndRemedy();
    void clearAlarmMovesOnlyWhenAllowed();
    void identifyRestoresTheLed();
    void setIdChangesTheId();
    void moveReachesItsGoal();
    void watchStreamsOneDocument();
    void csvHasOneHeaderLine();
    void rawShowsTheReply();
    void snapshotRoundTrip();
    void restoreDefaultsSavesASnapshotFirst();
    void recoverWithoutOpenChangesNeedsNoPort();
    void portsListSimulatedBuses();
    void humanTablesInBothLanguages_data();
    void humanTablesInBothLanguages();
    void helpInBothLanguages_data();
    void helpInBothLanguages();
    void helpListsEveryCommandOnce();
    void tourVerifiesItsClaims();
    void tourRefusesARealPort();
};

void TestCliOutputFormats::aRawGoalWriteWarnsOfTorqueOn()
{
    CliProgram cli;
    const ProgramResult result = cli.json("write 1 goal_position=2100");
    QCOMPARE(result.exit, 0);
    const QJsonArray notes = result.json()[QLatin1String("notes")].toArray();
    QCOMPARE(notes.size(), 1);
    QCOMPARE(notes[0][QLatin1String("code")].toString(), QStringLiteral("torque-switched-on"));
}

void TestCliOutputFormats::scanListsEveryServo()
{
    CliProgram cli;
    const ProgramResult result = cli.json("scan --ids 0-10");
    QCOMPARE(result.exit, 0);
    const QJsonObject json = result.json();
    QCOMPARE(keysOf(json), names("port elapsed_ms found notes"));
    // SCS and STS on one bus: one notice.
    const QJsonArray notes = json[QLatin1String("notes")].toArray();
    QCOMPARE(notes.size(), 1);
    QCOMPARE(notes[0][QLatin1String("code")].toString(), QStringLiteral("families-mixed"));
    QCOMPARE(named(json, "port"), QStringLiteral("sim:demo"));
    QVERIFY(json[QLatin1String("elapsed_ms")].isDouble());
    const QJsonArray found = json[QLatin1String("found")].toArray();
    QCOMPARE(found.size(), 6);
    for (const QJsonValue& servo : found) {
        QCOMPARE(keysOf(servo), names("id protocol model model_id map firmware baud status"));
        QCOMPARE(servo[QLatin1String("protocol")].toString(), QStringLiteral("feetech"));
        QCOMPARE(servo[QLatin1String("baud")].toInt(), 1000000);
    }
    QCOMPARE(found[0][QLatin1String("model")].toString(), QStringLiteral("STS3215"));
    QCOMPARE(found[0][QLatin1String("model_id")].toString(), QStringLiteral("9.3"));
    QCOMPARE(found[4][QLatin1String("map")].toString(), QStringLiteral("scs"));
    QVERIFY(found[0][QLatin1String("status")].toArray().isEmpty());
    QCOMPARE(found[5][QLatin1String("status")].toArray(), QJsonArray{QStringLiteral("voltage")});
}

void TestCliOutputFormats::emptyScanIsNoAnswer()
{
    CliProgram cli;
    const ProgramResult result = cli.json("scan --ids 100-110");
    QCOMPARE(result.exit, 4);
    QCOMPARE(result.json()[QLatin1String("found")].toArray().size(), 0);
    QVERIFY(result.json().contains(QLatin1String("found")));
}

void TestCliOutputFormats::dumpHasTheWholeTable()
{
    CliProgram cli;
    const ProgramResult result = cli.json("dump 1");
    QCOMPARE(result.exit, 0);
    const QJsonObject json = result.json();
    QCOMPARE(keysOf(json), names("id registers"));
    QCOMPARE(json[QLatin1String("id")].toInt(), 1);
    int address = -1;
    for (const QJsonValue& row : json[QLatin1String("registers")].toArray()) {
        QCOMPARE(keysOf(row), names("key address raw value unit area access"));
        QVERIFY(row[QLatin1String("address")].toInt() > address);
        address = row[QLatin1String("address")].toInt();
        QVERIFY(row[QLatin1String("raw")].isDouble());
    }
    const QJsonObject limit = registerIn(json, "max_angle_limit");
    QCOMPARE(limit[QLatin1String("address")].toInt(), 11);
    QCOMPARE(limit[QLatin1String("raw")].toInt(), 4095);
    QCOMPARE(limit[QLatin1String("value")].toDouble(), 4095 * 360.0 / 4096);
    QCOMPARE(named(limit, "unit"), QStringLiteral("deg"));
    QCOMPARE(named(limit, "area"), QStringLiteral("EPROM"));
    QCOMPARE(named(limit, "access"), QStringLiteral("rw"));
    QCOMPARE(registerIn(json, "present_voltage")[QLatin1String("value")].toDouble(), 7.4);
    QCOMPARE(registerIn(json, "baud_rate")[QLatin1String("value")].toInt(), 1000000);
    QCOMPARE(named(registerIn(json, "operating_mode"), "value"), QStringLiteral("position"));
}

void TestCliOutputFormats::readKeepsTheRequestedOrder()
{
    CliProgram cli;
    const ProgramResult result = cli.json("read 1 lock id position_p");
    QCOMPARE(result.exit, 0);
    const QJsonArray rows = result.json()[QLatin1String("registers")].toArray();
    QCOMPARE(rows.size(), 3);
    QCOMPARE(rows[0][QLatin1String("key")].toString(), QStringLiteral("lock"));
    QCOMPARE(rows[1][QLatin1String("raw")].toInt(), 1);
    QCOMPARE(rows[2][QLatin1String("address")].toInt(), 21);
}

void TestCliOutputFormats::rawIsSignedForSignedRegisters()
{
    CliProgram cli;
    const ProgramResult result = cli.json("write 1 position_offset=-100 --dangerous");
    QCOMPARE(result.exit, 0);
    const QJsonValue write = result.json()[QLatin1String("writes")].toArray().at(0);
    QCOMPARE(write[QLatin1String("new")].toInt(), -100);
    QCOMPARE(write[QLatin1String("read_back")].toInt(), -100);
}

void TestCliOutputFormats::writeReportsOutcomeAndLock_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("outcome");
    QTest::addColumn<QString>("lock");
    QTest::addColumn<int>("value");
    const auto row = [](const char* name, const char* command, const char* outcome,
                        const char* lock, int value) {
        QTest::newRow(name) << QString::fromLatin1(command) << QString::fromLatin1(outcome)
                            << QString::fromLatin1(lock) << value;
    };
    row("kept", "write 1 max_temperature=60", "kept", "closed", 60);
    row("physical value", "write 1 max_voltage=8.5V", "kept", "closed", 85);
    row("enum name", "write 1 operating_mode=speed --dangerous", "kept", "closed", 1);
    row("bits by name", "write 1 led_alarm_condition=overload+voltage", "kept", "closed", 33);
    row("temporary", "write 1 max_temperature=60 --temporary", "temporary", "closed", 60);
    row("RAM", "write 1 torque_limit=50%", "temporary", "none", 500);
    row("other family", "write 5 max_temperature=60", "kept", "closed", 60);
}

void TestCliOutputFormats::writeReportsOutcomeAndLock()
{
    QFETCH(QString, command);
    QFETCH(QString, outcome);
    QFETCH(QString, lock);
    QFETCH(int, value);
    CliProgram cli;
    const ProgramResult result = cli.json(qPrintable(command));
    QCOMPARE(result.exit, 0);
    const QJsonObject json = result.json();
    QCOMPARE(keysOf(json) - names("notes"), names("id writes lock snapshot"));
    QCOMPARE(named(json, "lock"), lock);
    const QJsonArray writes = json[QLatin1String("writes")].toArray();
    QCOMPARE(writes.size(), 1);
    QCOMPARE(keysOf(writes[0]), names("key address old new read_back outcome"));
    QCOMPARE(writes[0][QLatin1String("outcome")].toString(), outcome);
    QCOMPARE(writes[0][QLatin1String("read_back")].toInt(), value);
}

void TestCliOutputFormats::errorsAreJsonDocumentsToo_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* name, const char* command, int exit, const char* code) {
        QTest::newRow(name) << QString::fromUtf8(command) << exit << QString::fromLatin1(code);
    };
    row("silent", "info 99", 4, "no-answer");
    row("unknown command", "scann", 2, "bad-argument");
    row("unknown register", "read 1 speeed", 2, "unknown-register");
    row("read only", "write 1 present_position=1", 2, "read-only");
    row("range", "write 1 max_temperature=101", 2, "out-of-range");
    row("consent", "write 1 phase=0", 2, "needs-consent");
    row("id by write", "write 1 id=3", 2, "not-supported");
    row("rate by write", "write 1 baud_rate=500000", 2, "not-supported");
    row("taken ID", "set-id 1 2", 1, "id-in-use");
    row("travel time on STS", "move 1=1000 --time 500", 2, "not-supported");
    row("multi-turn holds nothing it does not know", "mode 1 acrobat", 2, "not-supported");
    row("no file", "snapshot show /nowhere/x.servo.json", 5, "file-missing");
    row("no folder", "snapshot save 1 /nowhere/x.servo.json", 5, "file-unwritable");
}

void TestCliOutputFormats::errorsAreJsonDocumentsToo()
{
    QFETCH(QString, command);
    QFETCH(int, exit);
    QFETCH(QString, code);
    CliProgram cli;
    const ProgramResult result = cli.json(qPrintable(command));
    const QJsonObject error = result.json()[QLatin1String("error")].toObject();
    QCOMPARE(named(error, "code"), code);
    QCOMPARE(result.exit, exit);
    QVERIFY(!named(error, "message").isEmpty());
    QVERIFY(!named(error, "remedy").isEmpty());

    const ProgramResult human = cli.run(qPrintable(command));
    QCOMPARE(human.exit, exit);
    QVERIFY2(human.err.contains(named(error, "message")), qPrintable(human.err));
}

/// With consent "write" does what the memory table of the window does.
void TestCliOutputFormats::consentWritesTheIdToo()
{
    CliProgram cli;
    cli.setServos(QStringLiteral("sts3215@1"));
    const ProgramResult result = cli.json("write 1 id=21 position_p=40 --dangerous");
    QVERIFY2(result.exit == 0, qPrintable(result.err));
    QCOMPARE(result.json()[QLatin1String("writes")].toArray().size(), 2);
    QCOMPARE(named(result.json(), "lock"), QStringLiteral("closed"));
    QCOMPARE(cli.json("read 21 position_p").exit, 0);
    QCOMPARE(cli.json("info 1").exit, 4);

    const ProgramResult partly = cli.json("write 21 position_p=41 baud_rate=99 --dangerous");
    QVERIFY(partly.exit != 0);
}

void TestCliOutputFormats::noticesGoToStderr()
{
    CliProgram cli;
    const QJsonObject json = cli.json("mode 1 speed").json();
    QCOMPARE(named(json, "mode"), QStringLiteral("speed"));
    QSet<QString> codes;
    for (const QJsonValue& note : json[QLatin1String("notes")].toArray())
        codes.insert(note[QLatin1String("code")].toString());
    QVERIFY(codes.contains(QStringLiteral("command-zeroed")));
    QVERIFY(codes.contains(QStringLiteral("torque-stays-off")));
}

void TestCliOutputFormats::infoShowsAlarmAndRemedy()
{
    CliProgram cli;
    const QJsonObject json = cli.json("info 6").json();
    QCOMPARE(named(json, "model"), QStringLiteral("SCS0009"));
    QCOMPARE(json[QLatin1String("status")].toArray(), QJsonArray{QStringLiteral("voltage")});
    QCOMPARE(json[QLatin1String("notes")][0][QLatin1String("code")].toString(),
             QStringLiteral("voltage-holds"));
    const QJsonObject healthy = cli.json("info 1").json();
    QCOMPARE(named(healthy, "mode"), QStringLiteral("position"));
    QCOMPARE(named(healthy, "torque"), QStringLiteral("off"));
    QCOMPARE(healthy[QLatin1String("voltage")].toDouble(), 7.4);
    QCOMPARE(healthy[QLatin1String("position")].toDouble(), 180.0);
}

/// Servo 5 of this bus is pressed against its end stop.
void TestCliOutputFormats::clearAlarmMovesOnlyWhenAllowed()
{
    CliProgram cli;
    cli.setPort(QStringLiteral("sim:trouble"));
    const ProgramResult asked = cli.json("clear-alarm 5");
    QCOMPARE(asked.exit, 1);
    QCOMPARE(named(asked.json(), "next"), QStringLiteral("turn-back"));
    QVERIFY(!asked.json()[QLatin1String("acted")].toBool());
    const ProgramResult done = cli.json("clear-alarm 5 --move");
    QCOMPARE(done.exit, 0);
    QVERIFY(done.json()[QLatin1String("cleared")].toBool());
    QVERIFY(done.json()[QLatin1String("alarms")].toArray().isEmpty());
    QVERIFY(cli.run("clear-alarm 5").out.contains(QStringLiteral("overload")));
}

void TestCliOutputFormats::identifyRestoresTheLed()
{
    CliProgram cli;
    const ProgramResult result = cli.json("identify 1");
    QCOMPARE(result.exit, 0);
    QVERIFY(result.json()[QLatin1String("blinks")].toInt() >= 3);
    QCOMPARE(named(result.json(), "register"), QStringLiteral("led_alarm_condition"));
    QCOMPARE(cli.json("recover").json()[QLatin1String("intents")].toArray().size(), 0);
}

void TestCliOutputFormats::setIdChangesTheId()
{
    CliProgram cli;
    const ProgramResult result = cli.json("set-id 1 77");
    QCOMPARE(result.exit, 0);
    const QJsonObject json = result.json();
    QCOMPARE(named(json, "lock"), QStringLiteral("closed"));
    const QJsonValue write = json[QLatin1String("writes")].toArray().at(0);
    QCOMPARE(write[QLatin1String("address")].toInt(), 5);
    QCOMPARE(write[QLatin1String("old")].toInt(), 1);
    QCOMPARE(write[QLatin1String("read_back")].toInt(), 77);
    QCOMPARE(write[QLatin1String("outcome")].toString(), QStringLiteral("kept"));
}

void TestCliOutputFormats::moveReachesItsGoal()
{
    CliProgram cli;
    const ProgramResult result = cli.json("move 1=90deg 2=1700 --how sync --wait");
    QCOMPARE(result.exit, 0);
    const QJsonArray moves = result.json()[QLatin1String("moves")].toArray();
    QCOMPARE(moves.size(), 2);
    QCOMPARE(moves[0][QLatin1String("goal")].toInt(), 1024);
    QVERIFY(std::abs(moves[0][QLatin1String("value")].toDouble() - 90.0) < 2.0);
    // Only the given registers have been written.
    QCOMPARE(moves[0][QLatin1String("fields")].toArray().size(), 1);
}

void TestCliOutputFormats::watchStreamsOneDocument()
{
    CliProgram cli;
    const ProgramResult result = cli.json("watch 1 5 --rate 50 --duration 0.3");
    QCOMPARE(result.exit, 0);
    const QJsonObject json = result.json();
    QCOMPARE(keysOf(json), names("port columns rows summary"));
    const QJsonArray rows = json[QLatin1String("rows")].toArray();
    const qsizetype columns = json[QLatin1String("columns")].toArray().size();
    QVERIFY(rows.size() >= 10);
    QCOMPARE(rows[0][QLatin1String("time_us")].toInt(), 0);
    qint64 last = 0;
    for (const QJsonValue& row : rows) {
        QVERIFY(row[QLatin1String("time_us")].toInteger() >= last);
        last = row[QLatin1String("time_us")].toInteger();
        QCOMPARE(row[QLatin1String("values")].toArray().size(), columns);
    }
    QCOMPARE(json[QLatin1String("summary")][QLatin1String("readings")].toInt(), rows.size());
}

void TestCliOutputFormats::csvHasOneHeaderLine()
{
    CliProgram cli;
    const QString path = cli.dataFolder() + QStringLiteral("/w.csv");
    QCOMPARE(cli.run(support::words("watch 1 2 --rate max --duration 0.2 --csv") << path).exit, 0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArrayList lines = file.readAll().trimmed().split('\n');
    QVERIFY(lines.size() > 10);
    QVERIFY(lines[0].startsWith("time_us,id,present_position[deg],present_speed[rpm],"));
    qint64 last = 0;
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QByteArrayList cells = lines[i].split(',');
        QCOMPARE(cells.size(), lines[0].split(',').size());
        QVERIFY(cells[0].toLongLong() >= last);
        last = cells[0].toLongLong();
    }
}

void TestCliOutputFormats::rawShowsTheReply()
{
    CliProgram cli;
    const ProgramResult result = cli.json("raw FF FF 01 02 01 FB");
    QCOMPARE(result.exit, 0);
    QCOMPARE(named(result.json(), "received"), QStringLiteral("FF FF 01 02 00 FC"));
    QCOMPARE(cli.json("raw FFFF630201 99").exit, 4); // there is no ID 99
}

void TestCliOutputFormats::snapshotRoundTrip()
{
    CliProgram cli;
    const QString path = cli.dataFolder() + QStringLiteral("/one.servo.json");
    QCOMPARE(cli.run(support::words("snapshot save 3") << path).exit, 0);
    cli.setPort({});
    const ProgramResult shown = cli.run(support::words("snapshot show --json") << path);
    QCOMPARE(shown.exit, 0);
    const QJsonObject json = shown.json();
    QCOMPARE(named(json, "model"), QStringLiteral("STS3250"));
    QCOMPARE(registerIn(json, "max_angle_limit")[QLatin1String("raw")].toInt(), 4095);
}

void TestCliOutputFormats::restoreDefaultsSavesASnapshotFirst()
{
    CliProgram cli;
    const ProgramResult result = cli.json("restore-defaults 1");
    QCOMPARE(result.exit, 0);
    const QString saved = named(result.json(), "snapshot");
    QVERIFY2(saved.startsWith(cli.dataFolder()), qPrintable(saved));
    QVERIFY(QFile::exists(saved));
    QCOMPARE(named(result.json(), "lock"), QStringLiteral("closed"));
}

void TestCliOutputFormats::recoverWithoutOpenChangesNeedsNoPort()
{
    CliProgram cli;
    cli.setPort({});
    const ProgramResult result = cli.json("recover");
    QCOMPARE(result.exit, 0);
    QCOMPARE(result.json()[QLatin1String("intents")].toArray().size(), 0);
}

void TestCliOutputFormats::portsListSimulatedBuses()
{
    CliProgram cli;
    cli.setPort({});
    const ProgramResult result = cli.json("ports");
    QCOMPARE(result.exit, 0);
    QStringList paths;
    for (const QJsonValue& port : result.json()[QLatin1String("ports")].toArray())
        paths << port[QLatin1String("path")].toString();
    QVERIFY(paths.contains(QStringLiteral("sim:demo")));
    QVERIFY(paths.contains(QStringLiteral("sim:trouble")));
}

void TestCliOutputFormats::humanTablesInBothLanguages_data()
{
    QTest::addColumn<QString>("command");
    for (const char* command :
         {"ports", "scan --ids 1-6", "info 6", "dump 1", "read 5 id", "write 1 max_temperature=60",
          "torque 1 2 on", "torque 3 off", "mode 5 motor", "move 1=1800", "watch 1 --duration 0.1",
          "raw FFFF010201FB", "recover", "reboot 1", "center 1", "set-baud 1 500000"})
        QTest::newRow(command) << QString::fromLatin1(command);
}

void TestCliOutputFormats::humanTablesInBothLanguages()
{
    QFETCH(QString, command);
    CliProgram cli;
    const ProgramResult english = cli.run(support::words(qPrintable(command)));
    QCOMPARE(english.exit, 0);
    QVERIFY(!english.out.isEmpty());
    QVERIFY2(!containsChinese(english.out + english.err), qPrintable(english.out));
    const ProgramResult chinese =
        cli.run(support::words(qPrintable(command + QStringLiteral(" --lang zh_CN"))));
    QCOMPARE(chinese.exit, 0);
    QVERIFY2(containsChinese(chinese.out), qPrintable(chinese.out));
    static const QRegularExpression placeholder(QStringLiteral("%[0-9]"));
    QVERIFY(!english.out.contains(placeholder) && !chinese.out.contains(placeholder));
}

void TestCliOutputFormats::helpInBothLanguages_data()
{
    QTest::addColumn<QString>("command");
    QTest::newRow("all") << QString();
    for (const char* command :
         {"ports",    "scan",        "info",     "dump",          "read",
          "write",    "set-id",      "set-baud", "center",        "restore-defaults",
          "reboot",   "torque",      "stop",     "mode",          "move",
          "watch",    "raw",         "recover",  "snapshot save", "snapshot show",
          "identify", "clear-alarm", "tour"})
        QTest::newRow(command) << QString::fromLatin1(command);
}

void TestCliOutputFormats::helpInBothLanguages()
{
    QFETCH(QString, command);
    CliProgram cli;
    const ProgramResult english =
        cli.run(support::words(qPrintable(command)) << QStringLiteral("--help"));
    QCOMPARE(english.exit, 0);
    QVERIFY(english.out.contains(QStringLiteral("Usage: servodesk-cli")));
    QVERIFY(english.out.contains(command));
    QVERIFY(!containsChinese(english.out));
    cli.setEnvironment(QStringLiteral("LANG"), QStringLiteral("zh_CN.UTF-8"));
    const ProgramResult chinese =
        cli.run(support::words(qPrintable(command)) << QStringLiteral("--help"));
    QCOMPARE(chinese.exit, 0);
    QVERIFY(chinese.out.contains(QStringLiteral("用法：")));
    QCOMPARE(cli.run(QStringList{QStringLiteral("help")} + support::words(qPrintable(command))).out,
             chinese.out);
}

void TestCliOutputFormats::helpListsEveryCommandOnce()
{
    CliProgram cli;
    const ProgramResult all = cli.run("help");
    QCOMPARE(all.exit, 0);
    QCOMPARE(all.out, cli.run("--help").out);
    for (const cli::Command& command : cli::commands()) {
        const QRegularExpression line(
            QStringLiteral("^  %1( [A-Z\\[].*|  .*)$").arg(QLatin1String(command.name)),
            QRegularExpression::MultilineOption);
        QVERIFY2(all.out.count(line) == 1, command.name);
    }
    QVERIFY(cli.run("help snapshot").err.contains(QStringLiteral("snapshot save, snapshot show")));
    QVERIFY(cli.run("snapshot restor").err.contains(QStringLiteral("snapshot restore")));
    const ProgramResult typo = cli.run("help snapsht");
    QCOMPARE(typo.exit, 2);
    QVERIFY2(typo.err.contains(QStringLiteral("did you mean snapshot?")), qPrintable(typo.err));
}

void TestCliOutputFormats::tourVerifiesItsClaims()
{
    CliProgram cli;
    cli.setPort({});
    const ProgramResult result = cli.json("tour");
    QCOMPARE(result.exit, 0);
    const QJsonObject json = result.json();
    QCOMPARE(json[QLatin1String("found")].toArray().size(), 6);
    QCOMPARE(json[QLatin1String("kept_survived")].toBool(), true);
    QCOMPARE(json[QLatin1String("temporary_gone")].toBool(), true);
    QVERIFY(json[QLatin1String("differing")].toArray().isEmpty());
    QCOMPARE(json[QLatin1String("twins_suspected")].toBool(), true);
    QVERIFY(QFile::exists(named(json, "snapshot")));
}

void TestCliOutputFormats::tourRefusesARealPort()
{
    CliProgram cli;
    cli.setPort(QStringLiteral("/dev/ttyUSB0"));
    const ProgramResult result = cli.run("tour");
    QCOMPARE(result.exit, 2);
    QVERIFY(result.err.contains(QStringLiteral("sim:demo")));
}

SERVODESK_GUILESS_TEST(TestCliOutputFormats)
#include "tst_cli_output_formats.moc"
