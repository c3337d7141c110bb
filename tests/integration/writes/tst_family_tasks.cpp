// SPDX-License-Identifier: GPL-3.0-or-later
// One list of tasks for every family of the trade: the same commands find a servo, read its table,
// change a setting that survives a power cycle, give it another ID, move it and watch it, in every
// protocol, which is detected, never given. One family, and each in the deep check, is simulated by
// a program of its own behind a pseudo-terminal.
#include "support/cli_program.h"
#include "support/deep_check.h"
#include "support/test_main.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;
using support::words;

namespace {
const QLatin1String servosName("found");

QJsonObject only(const QJsonArray& list)
{
    return list.size() == 1 ? list.first().toObject() : QJsonObject();
}

QJsonObject readOne(CliProgram& cli, int id, const QString& key)
{
    const ProgramResult result =
        cli.json(qPrintable(QStringLiteral("read %1 %2").arg(id).arg(key)));
    return only(result.json()[QLatin1String("registers")].toArray());
}
} // namespace

class TestFamilyTasks : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void sameTasksForEveryFamily_data();
    void sameTasksForEveryFamily();

private:
    void scan(CliProgram& cli, int id);
    void dump(CliProgram& cli, int id);
    void write(CliProgram& cli, int id);
    void setId(CliProgram& cli, int from, int to);
    void move(CliProgram& cli, int id);
    void watch(CliProgram& cli, int id);
    void tasksUntilPowerCycle(CliProgram& cli);

    bool m_isOtherProgram = false; ///< the servos are; else each command is a power cycle for them
};

void TestFamilyTasks::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestFamilyTasks::sameTasksForEveryFamily_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("baud");
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<QString>("map");
    QTest::addColumn<int>("registers");    ///< rows of the sheet that exist in this firmware
    QTest::addColumn<QString>("key");      ///< a setting that is kept at power-off
    QTest::addColumn<int>("value");        ///< another one than it leaves the factory with
    QTest::addColumn<QString>("position"); ///< what the sheet calls it

    const auto row = [](const char* name, const char* model, const char* baud, const char* protocol,
                        const char* map, int registers, const char* key, int value,
                        const char* position = "present_position") {
        QTest::newRow(name) << model << baud << protocol << map << registers << key << value
                            << position;
    };
    row("STS", "sts3215", "1000000", "feetech", "sts-sms", 59, "max_temperature", 61);
    row("SCS", "scs15", "1000000", "feetech", "scs", 47, "max_temperature", 61);
    row("Modbus", "smsmb", "115200", "modbus", "sms-modbus", 54, "position_p", 21);
    row("LX", "lx16a", "115200", "lx", "lx", 19, "temp_limit", 71, "position");
    if (!support::isDeepCheck())
        return; // tst_all_families has every family, in one program
    row("SMS", "sm40blhv", "115200", "feetech", "sts-sms", 59, "max_temperature", 61);
    row("HLS", "hls3606", "1000000", "feetech", "hls", 65, "max_temperature", 61);
    row("SMCL", "sm60-360m", "115200", "feetech", "smcl", 45, "max_temperature", 61);
    row("SCS-2", "scs15-2", "1000000", "feetech", "scs2", 43, "max_temperature", 61);
}

/// Without knowing the servos and their protocol.
void TestFamilyTasks::scan(CliProgram& cli, int id)
{
    QFETCH(QString, protocol);
    QFETCH(QString, map);
    ProgramResult result = cli.json("scan --ids 0-6");
    // On a busy machine its answer may come later than a search waits.
    for (int again = 0; again < 4 && result.json()[servosName].toArray().isEmpty(); ++again)
        result = cli.json("scan --ids 0-6");
    QCOMPARE(result.exit, 0);
    const QJsonObject found = only(result.json()[servosName].toArray());
    QCOMPARE(found[QLatin1String("id")].toInt(-1), id);
    QCOMPARE(found[QLatin1String("protocol")].toString(), protocol);
    QCOMPARE(found[QLatin1String("map")].toString(), map);
    // LX servos report no alarms at all, which is not the same as none.
    QCOMPARE(found[QLatin1String("status")].isNull(), protocol == QLatin1String("lx"));
}

void TestFamilyTasks::dump(CliProgram& cli, int id)
{
    QFETCH(int, registers);
    const ProgramResult result = cli.json(qPrintable(QStringLiteral("dump %1").arg(id)));
    QCOMPARE(result.exit, 0);
    const QJsonArray rows = result.json()[QLatin1String("registers")].toArray();
    QCOMPARE(rows.size(), registers);
    for (const QJsonValue& row : rows) {
        const QString key = row[QLatin1String("key")].toString();
        // The stored move cannot be read from this model, as the sheet knows.
        if (!key.startsWith(QLatin1String("wait_")))
            QVERIFY2(row[QLatin1String("raw")].isDouble(), qPrintable(key));
    }
}

void TestFamilyTasks::write(CliProgram& cli, int id)
{
    QFETCH(QString, key);
    QFETCH(int, value);
    const auto assignment = QStringLiteral("write %1 %2=%3").arg(id).arg(key).arg(value);
    const ProgramResult result = cli.json(qPrintable(assignment));
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    const QJsonObject write = only(result.json()[QLatin1String("writes")].toArray());
    QCOMPARE(write[QLatin1String("outcome")].toString(), QStringLiteral("kept"));
    QCOMPARE(write[QLatin1String("read_back")].toInt(-1), value);
    QVERIFY(write[QLatin1String("old")].toInt(-1) != value);
    const QString lock = result.json()[QLatin1String("lock")].toString();
    QVERIFY2(lock == QLatin1String("closed") || lock == QLatin1String("none"), qPrintable(lock));
}

void TestFamilyTasks::setId(CliProgram& cli, int from, int to)
{
    const ProgramResult result =
        cli.json(qPrintable(QStringLiteral("set-id %1 %2").arg(from).arg(to)));
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    QCOMPARE(result.json()[QLatin1String("id")].toInt(-1), to);
}

void TestFamilyTasks::move(CliProgram& cli, int id)
{
    QFETCH(QString, position);
    QFETCH(QString, model);
    const auto now = [&] {
        return readOne(cli, id, position)[QLatin1String("value")].toDouble(NAN);
    };
    const QJsonObject before = readOne(cli, id, position);
    const bool degrees = before[QLatin1String("unit")] == QLatin1String("deg");
    const double goal = degrees ? 100 : 400;
    QVERIFY(std::abs(before[QLatin1String("value")].toDouble(NAN) - goal) > 10);
    const ProgramResult result = cli.json(qPrintable(
        QStringLiteral("move %1=%2%3 --wait").arg(id).arg(goal).arg(degrees ? "deg" : "")));
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    // What counts as arrival: a 64th of a turn, 16 of 1024 steps. Friction decides where inside it.
    const double arrived = degrees ? 360.0 / 64 : 16;
    const QJsonObject report = only(result.json()[QLatin1String("moves")].toArray());
    const QJsonValue reached = report[QLatin1String(degrees ? "value" : "position")];
    QVERIFY2(std::abs(reached.toDouble(NAN) - goal) <= arrived, qPrintable(result.out));
    if (m_isOtherProgram) // else it has been switched off, and is where it was made
        QTRY_VERIFY(std::abs(now() - goal) <= arrived); // it may still come to rest
    QCOMPARE(cli.run(qPrintable(QStringLiteral("torque %1 off").arg(id))).exit, 0);
}

void TestFamilyTasks::watch(CliProgram& cli, int id)
{
    QFETCH(QString, position);
    const ProgramResult result =
        cli.json(qPrintable(QStringLiteral("watch %1 --rate 20 --duration 0.5").arg(id)));
    QCOMPARE(result.exit, 0);
    const QJsonArray columns = result.json()[QLatin1String("columns")].toArray();
    const QJsonArray rows = result.json()[QLatin1String("rows")].toArray();
    QVERIFY(rows.size() >= 5);
    int place = -1;
    for (int i = 0; i < columns.size(); ++i) {
        if (columns[i][QLatin1String("key")].toString() == position)
            place = i;
    }
    QVERIFY(place >= 0);
    qsizetype read = 0;
    for (const QJsonValue& row : rows) {
        const QJsonArray values = row[QLatin1String("values")].toArray();
        if (values.isEmpty())
            continue; // on a busy machine the simulator answers too late now and then
        QCOMPARE(values.size(), columns.size());
        QVERIFY(values[place].isDouble());
        ++read;
    }
    QVERIFY2(read >= 5, qPrintable(result.out));
}

void TestFamilyTasks::tasksUntilPowerCycle(CliProgram& cli)
{
    for (auto task : {&TestFamilyTasks::scan, &TestFamilyTasks::dump, &TestFamilyTasks::write,
                      &TestFamilyTasks::move, &TestFamilyTasks::watch}) {
        (this->*task)(cli, 1);
        if (QTest::currentTestFailed())
            return;
    }
    setId(cli, 1, 4);
}

void TestFamilyTasks::sameTasksForEveryFamily()
{
    QFETCH(QString, model);
    QFETCH(QString, baud);
    QFETCH(QString, key);
    QFETCH(int, value);
    CliProgram cli;
    cli.setGlobals({QStringLiteral("--baud"), baud});
    const QString servo = model + QStringLiteral("@1");
    std::unique_ptr<SimProgram> sim;
    const auto powerUp = [&] {
        sim.reset();
        sim = std::make_unique<SimProgram>(
            QStringList{QStringLiteral("--servos"), servo, QStringLiteral("--state"),
                        cli.dataFolder() + QStringLiteral("/eproms")});
        QVERIFY(!sim->port().isEmpty());
        cli.setPort(sim->port());
    };
    m_isOtherProgram = support::isDeepCheck() || QTest::currentDataTag() == QByteArray("STS");
    if (m_isOtherProgram)
        powerUp();
    else
        cli.setServos(servo);
    tasksUntilPowerCycle(cli);
    if (m_isOtherProgram)
        powerUp();
    if (!QTest::currentTestFailed())
        scan(cli, 4);
    if (QTest::currentTestFailed())
        return;
    QCOMPARE(readOne(cli, 4, key)[QLatin1String("raw")].toInt(-1), value);
    QCOMPARE(cli.json("recover").json()[QLatin1String("intents")].toArray().size(), 0);
}

SERVODESK_GUILESS_TEST(TestFamilyTasks)
#include "tst_family_tasks.moc"
