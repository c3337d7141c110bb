// SPDX-License-Identifier: GPL-3.0-or-later
// The program killed (kill -9) while it sets up a servo: within the template, before and after the
// ID is written, at the rate. The simulator is a program of its own; between them a
// cable that follows the rate, and kills at one frame. The same line started again finishes that
// servo and gives the next one an ID of its own.
#include "integration/kill_cable.h"
#include "integration/raw_client.h"
#include "record/commission_batch.h"
#include "support/cli_program.h"
#include "support/commission_bench.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::KillCable;
using support::KillPoint;
using support::Ran;

namespace {
// Of an STS3215.
constexpr int idAddress = 5;
constexpr int rateAddress = 6;
constexpr int gainAddress = 21;

constexpr int gain = 24; ///< the template's, another than the factory's

QJsonArray listOf(const Ran& ran, const char* name)
{
    return ran.json()[QLatin1String(name)].toArray();
}

/// The line on one batch, with the servos' bag and the cable between.
struct Killed {
    Killed()
        : sim(support::words("--preset line+deaf=1+run-to-goal=1"))
        , cable(sim.port())
    {
        cli.setPort(cable.port());
        const auto saved = record::saveSnapshot(
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
        cable.connectAnew();
        cli.start(line);
    }
    void hand(const char* deed)
    {
        sim.tell(deed);
        (void)sim.nextLine(); // done
    }
    Ran run(const char* words)
    {
        cable.connectAnew();
        return cli.run(words);
    }
    record::CommissionBatch batch() const
    {
        return record::openCommissionBatch(file("batch.csv")).value_or(record::CommissionBatch());
    }
    QMap<QString, int> values(int id)
    {
        const Ran read = run(qPrintable(
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

const QMap<QString, int> asWanted{{QStringLiteral("lock"), 1},
                                  {QStringLiteral("torque_switch"), 0},
                                  {QStringLiteral("position_p"), gain},
                                  {QStringLiteral("max_temperature"), 65}};
} // namespace

class TestCommissionKill : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void killedWhileAServoIsSetUp_data();
    void killedWhileAServoIsSetUp();

private:
    void finishesTheFirst(Killed& bench);
    void setsUpTheNext(Killed& bench);
};

void TestCommissionKill::killedWhileAServoIsSetUp_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<bool>("heard");
    QTest::newRow("template, heard") << gainAddress << true;
    QTest::newRow("ID, not heard") << idAddress << false;
    QTest::newRow("ID, heard") << idAddress << true;
    QTest::newRow("rate, heard") << rateAddress << true;
}

void TestCommissionKill::killedWhileAServoIsSetUp()
{
    QFETCH(int, address);
    QFETCH(bool, heard);
    Killed bench;
    bench.hand("next");
    bench.start();
    bench.cable.killAt({address, heard}, bench.cli.process().processId());
    const Ran killed = bench.cli.finish();
    QVERIFY2(bench.cable.killed(), qPrintable(killed.out + killed.err));
    QCOMPARE(killed.exit, -1);
    // Nothing is said to be done; what was begun is known, with the table it came with.
    const record::CommissionBatch left = bench.batch();
    QVERIFY(left.rows.empty());
    QCOMPARE(left.pending.size(), std::size_t{1});
    QCOMPARE(left.pending.front().newId, 11);
    QVERIFY(killed.out.isEmpty());
    QVERIFY(killed.err.contains(left.pending.front().snapshot));
    finishesTheFirst(bench);
    if (address == idAddress && !QTest::currentTestFailed())
        setsUpTheNext(bench);
}

void TestCommissionKill::finishesTheFirst(Killed& bench)
{
    const QString firstTable = bench.batch().pending.front().snapshot;
    bench.start();
    const bool done = bench.cli.waitForRemark("Unplug: ID 11 is done.");
    bench.cli.signal(SIGINT); // it stays on the wire, to be looked at
    const Ran ran = bench.cli.finish();
    QVERIFY2(done, qPrintable(ran.out + ran.err));
    QCOMPARE(bench.values(11), asWanted);
    QVERIFY(listOf(bench.run("recover --json"), "intents").isEmpty());

    const record::CommissionBatch batch = bench.batch();
    QVERIFY(batch.pending.empty());
    QCOMPARE(batch.rows.size(), std::size_t{1});
    const record::CommissionRow& row = batch.rows.front();
    QCOMPARE(row.verdict, record::CommissionVerdict::Good);
    QCOMPARE(row.servo.id, 1);
    QCOMPARE(row.oldBaud, 1'000'000);
    QCOMPARE(row.newId, 11);
    QCOMPARE(row.newBaud, 500'000);
    QCOMPARE(row.snapshot, firstTable);
    const auto table = record::loadSnapshot(firstTable);
    QVERIFY(table);
    QCOMPARE(table->servo.id, 1);
    QVERIFY(table->find(QStringLiteral("position_p"))->raw != gain);
}

void TestCommissionKill::setsUpTheNext(Killed& bench)
{
    bench.hand("next");
    bench.start();
    const bool done = bench.cli.waitForRemark("Unplug: ID 12 is done.");
    bench.hand("unplug");
    const Ran ran = bench.cli.finish();
    QVERIFY2(done, qPrintable(ran.out + ran.err));
    QCOMPARE(ran.exit, 0);
    bench.hand("plug 1");
    bench.hand("plug 2");
    for (const int id : {11, 12})
        QCOMPARE(bench.values(id), asWanted);
    const record::CommissionBatch batch = bench.batch();
    QCOMPARE(batch.done(), 2);
    QCOMPARE(batch.rows.back().newId, 12);
    // Each has its name in the history.
    QStringList labels;
    for (const QJsonValue& one : listOf(bench.run("history --kind servos --json"), "servos")) {
        if (one[QLatin1String("id")].toInt() > 10)
            labels.append(one[QLatin1String("label")].toString());
    }
    labels.sort();
    QCOMPARE(labels, (QStringList{batch.rows.front().label, batch.rows.back().label}));
}

QTEST_GUILESS_MAIN(TestCommissionKill)
#include "tst_commission_kill.moc"
