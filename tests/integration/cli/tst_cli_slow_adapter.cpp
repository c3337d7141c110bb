// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli with servos that know only bytes and an adapter that delivers their replies late:
// it finds no second servos and no reboots that did not happen, and its exit codes are right.
#include "integration/raw_servo_bus.h"
#include "support/cli_program.h"
#include "support/deep_check.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::ProgramResult;
using support::utf8;
using namespace std::chrono_literals;

class TestCliSlowAdapter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void takenIdIsRefused_data() { links(); }
    void takenIdIsRefused();
    void freeIdIsAssigned_data() { links(); }
    void freeIdIsAssigned();
    void restartIsVerifiedOrNotReported_data();
    void restartIsVerifiedOrNotReported();

private:
    static void links()
    {
        QTest::addColumn<int>("latency");
        QTest::addColumn<QString>("options");
        for (const int latency : {0, 20, 60, 150}) {
            if (latency != 20 || support::isDeepCheck())
                QTest::addRow("%d ms", latency) << latency << QString();
        }
        QTest::newRow("60 ms, --timeout 200") << 60 << utf8("--timeout 200");
    }
    static void setUp(CliProgram& cli, const bytes::Bus& bus, const QString& options = {})
    {
        cli.setPort(bus.port());
        if (!options.isEmpty())
            cli.setGlobals(support::words(qPrintable(options)));
    }
};

void TestCliSlowAdapter::takenIdIsRefused()
{
    QFETCH(int, latency);
    QFETCH(QString, options);
    bytes::Bus bus({1, 9}, std::chrono::milliseconds(latency));
    CliProgram cli;
    setUp(cli, bus, options);
    const ProgramResult result = cli.json("set-id 1 9");
    QCOMPARE(result.exit, 1);
    QCOMPARE(result.errorCode(), utf8("id-in-use"));
    QCOMPARE(bus.writes(), 0);
    QVERIFY(bus.has(1) && bus.has(9));
}

void TestCliSlowAdapter::freeIdIsAssigned()
{
    QFETCH(int, latency);
    QFETCH(QString, options);
    bytes::Bus bus({1, 2}, std::chrono::milliseconds(latency));
    CliProgram cli;
    setUp(cli, bus, options);
    const ProgramResult result = cli.json("set-id 1 9");
    QVERIFY2(result.exit == 0, qPrintable(result.out));
    QVERIFY(!bus.has(1));
    QVERIFY(bus.has(2));
    QVERIFY(bus.has(9));
    QCOMPARE(bus.byteAt(9, 55), 1); // locked
    QVERIFY(cli.json("recover").json()[QLatin1String("intents")].toArray().isEmpty());
}

void TestCliSlowAdapter::restartIsVerifiedOrNotReported_data()
{
    QTest::addColumn<bytes::RestartBehavior>("restart");
    QTest::addColumn<int>("latency");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("says");
    for (const int latency : {0, 60}) {
        QTest::addRow("ignored, %d ms", latency)
            << bytes::RestartBehavior::Ignored << latency << 1 << utf8("the servo did not reboot");
        QTest::addRow("acknowledged only, %d ms", latency)
            << bytes::RestartBehavior::AcknowledgedOnly << latency << 1
            << utf8("the servo acknowledged the reboot command but did not reboot");
        QTest::addRow("too quick to see, %d ms", latency)
            << bytes::RestartBehavior::TooFastToDetect << latency << 0
            << utf8("Servo 1 has rebooted.");
    }
}

void TestCliSlowAdapter::restartIsVerifiedOrNotReported()
{
    QFETCH(bytes::RestartBehavior, restart);
    QFETCH(int, latency);
    QFETCH(int, exit);
    QFETCH(QString, says);
    bytes::Bus bus({1}, std::chrono::milliseconds(latency), restart);
    CliProgram cli;
    setUp(cli, bus);
    const ProgramResult result = cli.run("reboot 1");
    QVERIFY(bus.restarts() > 0);
    QCOMPARE(result.exit, exit);
    const QString all = result.out + result.err;
    QVERIFY2(all.contains(says), qPrintable(all));
    QCOMPARE(all.contains(utf8("has rebooted")), exit == 0);
    QCOMPARE(bus.byteAt(1, 48) + 256 * bus.byteAt(1, 49), 1000); // the mark is gone
}

SERVODESK_GUILESS_TEST(TestCliSlowAdapter)
#include "tst_cli_slow_adapter.moc"
