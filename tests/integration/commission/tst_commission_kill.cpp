// SPDX-License-Identifier: GPL-3.0-or-later
// The program killed (kill -9) while it sets up a servo: within the template, before and after the
// ID is written, at the rate. The simulator is a program of its own; between them a
// cable that follows the rate, and kills at one frame. The same line started again finishes that
// servo and gives the next one an ID of its own.
#include "integration/kill_cable.h"
#include "integration/raw_client.h"
#include "results/commission_batch.h"
#include "support/cli_program.h"
#include "support/commission_fixture.h"
#include "support/deep_check.h"
#include "support/test_main.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::KillCable;
using support::KillPoint;
using support::ProgramResult;

namespace {
// Of an STS3215.
constexpr int idAddress = 5;
constexpr int rateAddress = 6;
constexpr int gainAddress = 21;

constexpr int gain = 24; ///< the template's, another than the factory's

QJsonArray listOf(const ProgramResult& result, const char* name)
{
    return result.json()[QLatin1String(name)].toArray();
}

/// The line on one batch, with the servos' bag and the cable between.
struct CommissionKillFixture {
    CommissionKillFixture()
        : sim(support::words("--preset line+deaf=1+run-to-goal=1"))
        , cable(sim.port())
    {
        cli.setPort(cable.port());
        const auto saved = snapshot::saveSnapshot(
            support::templateOf("sts3215", {{"position_p", gain}, {"max_temperature", 65}}),
            file("template.servo.json"));
        if (!saved)
            qFatal("template");
        line = support::words("commission --auto --first-id 11 --count 2 --to-baud 500000")
               << QStringLiteral("--template") << file("template.servo.json")
               << QStringLiteral("--batch") << file("batch.csv");
    }
    QString file(const char* name) const { return folder.filePath(QLatin1String(name)); }
    void start()
    {
        cable.resetConnection();
        cli.start(line);
    }
    void sendHotplugCommand(const char* command)
    {
        sim.sendLine(command);
        (void)sim.nextLine(); // done
    }
    ProgramResult run(const char* words)
    {
        cable.resetConnection();
        return cli.run(words);
    }
    results::CommissionBatch batch() const
    {
        return results::openCommissionBatch(file("batch.csv")).value_or(results::CommissionBatch());
    }
    QMap<QString, int> values(int id)
    {
        const ProgramResult read = run(qPrintable(
            QStringLiteral("read %1 lock torque_switch position_p max_temperature --baud 500000 "
                           "--json")
                .arg(id)));
        QMap<QString, int> found;
        for (const QJsonValue& row : listOf(read, "registers"))
            found.insert(row[QLatin1String("key")].toString(), row[QLatin1String("raw")].toInt(-1));
        return found;
    }

    QTemporaryDir folder;
    raw::Simulator sim;
    KillCable cable;
    CliProgram cli;
    QStringList line;
};

const QMap<QString, int> expectedValues{{QStringLiteral("lock"), 1},
                                        {QStringLiteral("torque_switch"), 0},
                                        {QStringLiteral("position_p"), gain},
                                        {QStringLiteral("max_temperature"), 65}};
} // namespace

class TestCommissionKill : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void killedWhileCommissioningAServo_data();
    void killedWhileCommissioningAServo();

private:
    void finish(CommissionKillFixture& fixture, bool withNext);
    void verifyRow(const results::CommissionRow& row, const QString& firstTable);
    void verifyNext(CommissionKillFixture& fixture, const results::CommissionBatch& batch);
};

void TestCommissionKill::killedWhileCommissioningAServo_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<bool>("heard");
    QTest::newRow("ID, not heard") << idAddress << false;
    QTest::newRow("rate, heard") << rateAddress << true;
    if (!support::isDeepCheck())
        return;
    QTest::newRow("template, heard") << gainAddress << true;
    QTest::newRow("ID, heard") << idAddress << true;
}

void TestCommissionKill::killedWhileCommissioningAServo()
{
    QFETCH(int, address);
    QFETCH(bool, heard);
    CommissionKillFixture fixture;
    fixture.sendHotplugCommand("next");
    fixture.start();
    fixture.cable.killAt({address, heard}, fixture.cli.process().processId());
    const ProgramResult killed = fixture.cli.finish();
    QVERIFY2(fixture.cable.killed(), qPrintable(killed.out + killed.err));
    QCOMPARE(killed.exit, -1);
    // Nothing is said to be done; what was begun is known, with the table it came with.
    const results::CommissionBatch left = fixture.batch();
    QVERIFY(left.rows.empty());
    QCOMPARE(left.pending.size(), std::size_t{1});
    QCOMPARE(left.pending.front().newId, 11);
    QVERIFY(killed.out.isEmpty());
    QVERIFY(killed.err.contains(left.pending.front().snapshot));
    finish(fixture, address == idAddress);
}

/// The same line again: the servo is finished, and on request the next one set up.
void TestCommissionKill::finish(CommissionKillFixture& fixture, bool withNext)
{
    const QString firstTable = fixture.batch().pending.front().snapshot;
    fixture.start();
    bool done = fixture.cli.waitForError("ID 11 is done.");
    if (done && withNext) {
        fixture.sendHotplugCommand("next");
        done = fixture.cli.waitForError("ID 12 is done.");
        fixture.sendHotplugCommand("unplug");
    } else {
        fixture.cli.signal(SIGINT); // it stays on the wire, to be looked at
    }
    const ProgramResult result = fixture.cli.finish();
    QVERIFY2(done, qPrintable(result.out + result.err));
    if (withNext) {
        QCOMPARE(result.exit, 0);
        fixture.sendHotplugCommand("plug 1");
        fixture.sendHotplugCommand("plug 2");
    }
    QCOMPARE(fixture.values(11), expectedValues);
    QVERIFY(listOf(fixture.run("recover --json"), "intents").isEmpty());

    const results::CommissionBatch batch = fixture.batch();
    QVERIFY(batch.pending.empty());
    QCOMPARE(batch.rows.size(), std::size_t(withNext ? 2 : 1));
    verifyRow(batch.rows.front(), firstTable);
    if (withNext && !QTest::currentTestFailed())
        verifyNext(fixture, batch);
}

void TestCommissionKill::verifyRow(const results::CommissionRow& row, const QString& firstTable)
{
    QCOMPARE(row.verdict, results::CommissionVerdict::Good);
    QCOMPARE(row.servo.id, 1);
    QCOMPARE(row.oldBaud, 1'000'000);
    QCOMPARE(row.newId, 11);
    QCOMPARE(row.newBaud, 500'000);
    QCOMPARE(row.snapshot, firstTable);
    const auto table = snapshot::loadSnapshot(firstTable);
    QVERIFY(table);
    QCOMPARE(table->servo.id, 1);
    QVERIFY(table->find(QStringLiteral("position_p"))->raw != gain);
}

void TestCommissionKill::verifyNext(CommissionKillFixture& fixture,
                                    const results::CommissionBatch& batch)
{
    QCOMPARE(fixture.values(12), expectedValues);
    QCOMPARE(batch.done(), 2);
    QCOMPARE(batch.rows.back().newId, 12);
    // Each has its name in the history.
    QStringList labels;
    for (const QJsonValue& one : listOf(fixture.run("history --kind servos --json"), "servos")) {
        if (one[QLatin1String("id")].toInt() > 10)
            labels.append(one[QLatin1String("label")].toString());
    }
    labels.sort();
    QCOMPARE(labels, (QStringList{batch.rows.front().label, batch.rows.back().label}));
}

SERVODESK_GUILESS_TEST(TestCommissionKill)
#include "tst_commission_kill.moc"
