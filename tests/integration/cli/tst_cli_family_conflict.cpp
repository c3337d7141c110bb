// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli with a servo that knows only bytes and has an unknown memory table: every command
// reads it, none writes to it, and each gives the reason.
#include "integration/raw_servo_bus.h"
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::ProgramResult;
using support::utf8;

namespace {
QJsonObject errorOf(const ProgramResult& result)
{
    return result.json()[QLatin1String("error")].toObject();
}

/// Firmware 3.25 and byte order flag 1; the model list has 9.3 with flag 0.
void setConflictingIdentity(bytes::Bus& bus)
{
    bus.setByte(1, 1, 25);
    bus.setByte(1, 2, 1);
}
} // namespace

class TestCliFamilyConflict : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void noCommandWrites_data();
    void noCommandWrites();
    void torqueGoesOff();
    void unknownFirmwareIsTheReason();
    void invalidLockValueIsTheReason();
    void theTableCanBeRead();
    void consentErrorNamesTheOption();
};

void TestCliFamilyConflict::noCommandWrites_data()
{
    QTest::addColumn<QString>("command");
    for (const char* command :
         {"write 1 max_temperature=61", "write 1 byte_13=61", "set-id 1 9", "set-baud 1 500000",
          "torque 1 on", "move 1=2100", "center 1", "reboot 1", "restore-defaults 1", "identify 1",
          "sweep 1 --from 1000 --to 2000 --delay 500", "step-response 1 --size 100"})
        QTest::newRow(command) << utf8(command);
}

void TestCliFamilyConflict::noCommandWrites()
{
    QFETCH(QString, command);
    bytes::Bus bus({1}, std::chrono::milliseconds(0));
    setConflictingIdentity(bus);
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.json(qPrintable(command));
    QCOMPARE(bus.writes(), 0);
    QCOMPARE(errorOf(result)[QLatin1String("code")].toString(), utf8("family-unclear"));
    const QString message = errorOf(result)[QLatin1String("message")].toString();
    for (const char* fact : {"3.25", "byte order flag 1", "9.3 (STS3215"})
        QVERIFY2(message.contains(utf8(fact)), qPrintable(message));
}

void TestCliFamilyConflict::torqueGoesOff()
{
    for (const char* command : {"torque 1 off", "stop 1"}) {
        bytes::Bus bus({1}, std::chrono::milliseconds(0));
        setConflictingIdentity(bus);
        bus.setByte(1, 40, 1);
        CliProgram cli;
        cli.setPort(bus.port());
        const ProgramResult result = cli.run(command);
        QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
        QCOMPARE(bus.byteAt(1, 40), 0);
    }
}

void TestCliFamilyConflict::unknownFirmwareIsTheReason()
{
    bytes::Bus bus({1}, std::chrono::milliseconds(0));
    bus.setByte(1, 0, 8);
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.json("write 1 max_temperature=61");
    QCOMPARE(errorOf(result)[QLatin1String("code")].toString(), utf8("unknown-model"));
    QCOMPARE(bus.writes(), 0);
}

void TestCliFamilyConflict::invalidLockValueIsTheReason()
{
    bytes::Bus bus({1}, std::chrono::milliseconds(0));
    bus.setByte(1, 55, 77);
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.json("write 1 max_temperature=61");
    QCOMPARE(errorOf(result)[QLatin1String("code")].toString(), utf8("family-unclear"));
    QVERIFY(errorOf(result)[QLatin1String("message")].toString().contains(
        utf8("the byte at that address is 77")));
    QCOMPARE(bus.writes(), 0);
    QVERIFY(cli.run("info 1").out.contains(utf8("the byte at that address is 77")));
}

void TestCliFamilyConflict::theTableCanBeRead()
{
    bytes::Bus bus({1}, std::chrono::milliseconds(0));
    setConflictingIdentity(bus);
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.json("read 1 byte_48 byte_55");
    QCOMPARE(result.exit, 0);
    const QJsonArray rows = result.json()[QLatin1String("registers")].toArray();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0][QLatin1String("raw")].toInt(), 0xE8);
    QCOMPARE(rows[1][QLatin1String("raw")].toInt(), 1);
    QVERIFY(cli.run("info 1").out.contains(utf8("the servo family is unclear")));
    QVERIFY(cli.run("scan").out.contains(utf8("family unclear, so read-only")));
    QCOMPARE(cli.run("dump 1").exit, 0);
    QCOMPARE(bus.writes(), 0);
}

void TestCliFamilyConflict::consentErrorNamesTheOption()
{
    bytes::Bus bus({1}, std::chrono::milliseconds(0));
    CliProgram cli;
    cli.setPort(bus.port());
    const ProgramResult result = cli.json("write 1 return_delay=3 phase=0");
    QCOMPARE(errorOf(result)[QLatin1String("code")].toString(), utf8("needs-consent"));
    QVERIFY(errorOf(result)[QLatin1String("remedy")].toString().contains(utf8("--dangerous")));
    QCOMPARE(bus.writes(), 0);
}

SERVODESK_GUILESS_TEST(TestCliFamilyConflict)
#include "tst_cli_family_conflict.moc"
