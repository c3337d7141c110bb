// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C, once and repeatedly, in the long tasks: sweep, step-response, bundle restore, commission.
// The simulator is another program; the cable between them interrupts the program at a given frame.
// A client that knows only bytes then reads the state: torque as promised, EPROM lock closed,
// temporary values restored.
#include "integration/kill_cable.h"
#include "integration/raw_client.h"
#include "results/commission_batch.h"
#include "support/cli_program.h"
#include "support/commission_fixture.h"
#include "support/deep_check.h"
#include "support/feetech_bytes.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::contentOf;
using support::goalAddress;
using support::InterruptPoint;
using support::KillCable;
using support::modeAddress;
using support::ProgramResult;
using support::torqueSwitch;
using support::words;

namespace {
// Of an STS3215.
constexpr int idAddress = 5;
constexpr int rateAddress = 6;
constexpr int maxTemperature = 13;
constexpr int gainAddress = 21;
constexpr int goalFrame = 41; ///< the write of the goal begins with the acceleration
constexpr int lockAddress = 55;
constexpr int presentPosition = 56;
constexpr int movingFlag = 66;

const QStringList timeout{QStringLiteral("--timeout"), QStringLiteral("200")};
constexpr int repeatedInterrupts = 6; ///< Ctrl-C at this many successive frames

struct CtrlC {
    explicit CtrlC(const char* servos)
        : sim(words(servos))
        , cable(sim.port())
    {
        cli.setPort(cable.port());
    }

    QString file(const char* name) const { return folder.filePath(QLatin1String(name)); }
    /// Nothing is interrupted here, so late replies of a busy machine must not matter.
    ProgramResult run(const char* line)
    {
        cable.resetConnection();
        return cli.run(words(line) + timeout);
    }
    ProgramResult interrupted(const QStringList& line, const InterruptPoint& point)
    {
        cable.resetConnection();
        cli.start(line);
        cable.interruptAt(point, cli.process().processId());
        return cli.finish();
    }
    /// Read by a client that knows only bytes; -1: no reply.
    int at(int id, int address, int count = 1, speed_t rate = B1000000)
    {
        cable.resetConnection();
        const raw::Client client(cable.port(), rate);
        QByteArray frame("\xFF\xFF");
        for (const int byte : {id, 4, 2, address, count})
            frame.append(char(byte));
        frame.append(char(~(id + 4 + 2 + address + count) & 0xFF));
        const QByteArray reply = client.requestUntilReply(frame.toHex().constData(), 6 + count);
        if (reply.size() != 6 + count)
            return -1;
        int value = 0;
        for (int i = count - 1; i >= 0; --i)
            value = value * 256 + static_cast<unsigned char>(reply[5 + i]);
        return value;
    }

    QTemporaryDir folder;
    raw::Simulator sim;
    KillCable cable;
    CliProgram cli;
};

enum class Always { None, Repeated }; ///< what runs outside the deep check too

void addOnceAndRepeated(const char* name, int address, int skip, Always always)
{
    if (support::isDeepCheck())
        QTest::addRow("%s", name) << address << skip << 1;
    if (always == Always::Repeated || support::isDeepCheck())
        QTest::addRow("%s, again and again", name) << address << skip << repeatedInterrupts;
}
} // namespace

class TestCliCtrlC : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void sweep_data();
    void sweep();
    void sweepInATemporaryMode_data();
    void sweepInATemporaryMode();
    void stepResponse_data();
    void stepResponse();
    void bundleRestore_data();
    void bundleRestore();
    void commission_data();
    void commission();
    void onASlowAdapter_data();
    void onASlowAdapter();
};

void TestCliCtrlC::sweep_data()
{
    QTest::addColumn<int>("skip");
    QTest::addColumn<int>("times");
    QTest::addColumn<bool>("release");
    const auto row = [](const char* name, int skip, int times, bool release) {
        QTest::addRow("%s, %d", name, times) << skip << times << release;
    };
    row("on the way to the start, hold", 0, 1, false);
    row("third goal, hold", 2, repeatedInterrupts, false);
    row("third goal, release", 2, 1, true);
    if (!support::isDeepCheck())
        return;
    row("on the way to the start, hold", 0, repeatedInterrupts, false);
    row("third goal, hold", 2, 1, false);
    row("third goal, release", 2, repeatedInterrupts, true);
}

/// The servo stops, with or without torque, and does not move to its last goal.
void TestCliCtrlC::sweep()
{
    QFETCH(int, skip);
    QFETCH(int, times);
    QFETCH(bool, release);
    CtrlC fixture("--servos sts3215@1");
    QStringList line = words("sweep 1 --from 1500 --to 2600 --delay 900 --cycles 50 --speed 900 "
                             "--report");
    line << fixture.file("r.json") << words(release ? "--torque-off --json" : "--json");
    const ProgramResult result = fixture.interrupted(line, {goalAddress, skip, times});
    QVERIFY(fixture.cable.interrupted());
    const QByteArray output = result.out.toUtf8().left(400) + result.err.toUtf8();
    QVERIFY2(result.exit == 1, output.constData());

    QCOMPARE(fixture.at(1, torqueSwitch), release ? 0 : 1);
    QCOMPARE(fixture.at(1, lockAddress), 1);
    QTRY_COMPARE(fixture.at(1, movingFlag), 0); // stopped
    const int place = fixture.at(1, presentPosition, 2);
    for (const int goal : {1500, 2600})
        QVERIFY2(std::abs(place - goal) > 100, qPrintable(QString::number(place)));
    if (!release)
        QVERIFY(std::abs(fixture.at(1, goalAddress, 2) - place) < 40);
    QVERIFY(fixture.cli.openIntents() == 0);

    for (const QByteArray& document : {result.out.toUtf8(), contentOf(fixture.file("r.json"))}) {
        const QJsonObject run = QJsonDocument::fromJson(document).object();
        QCOMPARE(run[QLatin1String("end")].toString(), QStringLiteral("stopped"));
        QVERIFY2(run[QLatin1String("verdict")].toString() != QLatin1String("pass"),
                 document.constData());
        QVERIFY(run.contains(QLatin1String("legs")));
        QVERIFY(run[QLatin1String("legs")].toArray().size() <= skip);
    }
    QVERIFY(contentOf(fixture.file("r.readings.csv")).count('\n') > 5);
    // Kept for later, and no better there.
    const ProgramResult kept = fixture.cli.json("sweep-runs");
    QCOMPARE(kept.exit, 0);
    QVERIFY2(kept.out.contains(QLatin1String("stopped")), qPrintable(kept.out));
    QVERIFY2(!kept.out.contains(QLatin1String("\"pass\"")), qPrintable(kept.out));
}

void TestCliCtrlC::sweepInATemporaryMode_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("skip");
    QTest::addColumn<int>("times");
    addOnceAndRepeated("while the mode is switched", modeAddress, 0, Always::Repeated);
    addOnceAndRepeated("while the servo moves", goalAddress, 3, Always::None);
}

void TestCliCtrlC::sweepInATemporaryMode()
{
    QFETCH(int, address);
    QFETCH(int, skip);
    QFETCH(int, times);
    CtrlC fixture("--servos sts3215@1");
    QCOMPARE(fixture.run("mode 1 speed").exit, 0);
    const ProgramResult result =
        fixture.interrupted(words("sweep 1 --from 1500 --to 2600 --delay 900 --cycles 50 "
                                  "--speed 900 --switch-mode"),
                            {address, skip, times});
    QVERIFY2(fixture.cable.interrupted(), qPrintable(result.out + result.err));
    QVERIFY2(result.exit == 1, qPrintable(result.out + result.err));
    QCOMPARE(fixture.at(1, modeAddress), 1);
    QCOMPARE(fixture.at(1, torqueSwitch), 0); // as in the help: torque is off then
    QCOMPARE(fixture.at(1, lockAddress), 1);
    QTRY_COMPARE(fixture.at(1, movingFlag), 0);
    QVERIFY(fixture.cli.openIntents() == 0);
    QVERIFY2(!result.out.contains(QLatin1String("Pass")), qPrintable(result.out));
}

void TestCliCtrlC::stepResponse_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("skip");
    QTest::addColumn<int>("times");
    addOnceAndRepeated("first run", goalFrame, 1, Always::None);
    addOnceAndRepeated("values of the trial written", gainAddress, 0, Always::Repeated);
    addOnceAndRepeated("trial, on its way", goalFrame, 4, Always::None);
}

/// The gains are restored, and the measurements so far are saved.
void TestCliCtrlC::stepResponse()
{
    QFETCH(int, address);
    QFETCH(int, skip);
    QFETCH(int, times);
    CtrlC fixture("--servos sts3215@1");
    const int own = fixture.at(1, gainAddress);
    QStringList line = words("step-response 1 --size 300 --repeats 1 --hold 700 --json --try "
                             "position_p=20,position_d=10 --report");
    line << fixture.file("s.json");
    const ProgramResult result = fixture.interrupted(line, {address, skip, times});
    const QByteArray output = result.out.toUtf8().left(600) + result.err.toUtf8();
    QVERIFY2(fixture.cable.interrupted(), output.constData());
    QVERIFY2(result.exit == 1, output.constData());
    QCOMPARE(fixture.at(1, gainAddress), own);
    QCOMPARE(fixture.at(1, gainAddress + 1), 32);
    QCOMPARE(fixture.at(1, lockAddress), 1);
    QTRY_COMPARE(fixture.at(1, movingFlag), 0);
    QVERIFY(fixture.cli.openIntents() == 0);
    const QJsonArray runs = result.json()[QLatin1String("runs")].toArray();
    QVERIFY2(!runs.isEmpty(), output.constData());
    const bool inTrial = address == gainAddress || skip > 1;
    QCOMPARE(runs[0][QLatin1String("end")].toString(),
             inTrial ? QStringLiteral("finished") : QStringLiteral("stopped"));
    QVERIFY(QFile::exists(fixture.file("s.json")));
    // The trial values were only in RAM: a reboot does not change the restored gains.
    QCOMPARE(fixture.run("reboot 1").exit, 0);
    QCOMPARE(fixture.at(1, gainAddress), own);
}

void TestCliCtrlC::bundleRestore_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("skip");
    QTest::addColumn<int>("times");
    addOnceAndRepeated("first servo, first row", maxTemperature, 0, Always::None);
    addOnceAndRepeated("first servo, lock opened", lockAddress, 0, Always::Repeated);
    addOnceAndRepeated("first servo, lock being closed", lockAddress, 1, Always::None);
    addOnceAndRepeated("second servo, first row", maxTemperature, 1, Always::None);
}

/// The result of each row is the value in the servo, and no lock is open.
void TestCliCtrlC::bundleRestore()
{
    QFETCH(int, address);
    QFETCH(int, skip);
    QFETCH(int, times);
    CtrlC fixture("--servos sts3215@1,sts3215@2");
    const QString file = fixture.file("all.bundle.json");
    QCOMPARE(fixture.run(qPrintable(QStringLiteral("bundle save ") + file)).exit, 0);
    for (const char* line : {"write 1 max_temperature=60 position_p=20 position_d=10",
                             "write 2 max_temperature=61 position_p=21 position_d=11"})
        QCOMPARE(fixture.run(line).exit, 0);
    const ProgramResult result =
        fixture.interrupted(words("bundle restore --json") << file, {address, skip, times});
    const QByteArray output = result.out.toUtf8() + result.err.toUtf8();
    QVERIFY2(fixture.cable.interrupted(), output.constData());
    QVERIFY2(result.exit == 1, output.constData());
    for (const int id : {1, 2}) {
        QCOMPARE(fixture.at(id, lockAddress), 1);
        QCOMPARE(fixture.at(id, torqueSwitch), 0);
    }
    QVERIFY2(fixture.cli.openIntents() == 0, output.constData());
    const QJsonArray servos = result.json()[QLatin1String("servos")].toArray();
    QCOMPARE(servos.size(), 2);
    // Values reported as kept survive a reboot; the others are unchanged.
    for (const int id : {1, 2}) {
        const QJsonObject one = servos[id - 1].toObject();
        const QJsonObject outcome = one[QLatin1String("outcome")].toObject();
        QVERIFY(one[QLatin1String("verdict")].toString() != QLatin1String("done") ||
                fixture.at(id, gainAddress) == 32);
        const std::map<QString, std::pair<int, int>> changed{
            {QStringLiteral("max_temperature"), {maxTemperature, 59 + id}},
            {QStringLiteral("position_p"), {gainAddress, 19 + id}}};
        for (const auto& [key, where] : changed) {
            int expected = where.second;
            for (const QJsonValue& row : outcome[QLatin1String("results")].toArray()) {
                if (row[QLatin1String("key")] == key &&
                    row[QLatin1String("outcome")].toString() == QLatin1String("kept"))
                    expected = row[QLatin1String("read_back")].toInt();
            }
            QVERIFY2(fixture.at(id, where.first) == expected, output.constData());
        }
    }
    // Running it again finishes the restore.
    const ProgramResult again = fixture.run(qPrintable(QStringLiteral("bundle restore ") + file));
    QVERIFY2(again.exit == 0, qPrintable(again.out + again.err));
    QCOMPARE(fixture.at(1, gainAddress), 32);
    QCOMPARE(fixture.at(2, gainAddress), 32);
}

void TestCliCtrlC::commission_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("skip");
    QTest::addColumn<int>("times");
    addOnceAndRepeated("template", gainAddress, 0, Always::None);
    addOnceAndRepeated("lock opened", lockAddress, 0, Always::None);
    addOnceAndRepeated("ID", idAddress, 0, Always::Repeated);
    addOnceAndRepeated("rate", rateAddress, 0, Always::None);
}

/// The batch contains the servo as unfinished or set up, never otherwise; the same command finishes
/// it after the user has confirmed that it is the same servo.
void TestCliCtrlC::commission()
{
    QFETCH(int, address);
    QFETCH(int, skip);
    QFETCH(int, times);
    CtrlC fixture("--preset line");
    QVERIFY(snapshot::saveSnapshot(
        support::templateOf("sts3215", {{"position_p", 24}, {"max_temperature", 65}}),
        fixture.file("t.servo.json")));
    const QStringList line = words("commission --auto --first-id 11 --count 1 --to-baud 500000 "
                                   "--template")
                             << fixture.file("t.servo.json") << QStringLiteral("--batch")
                             << fixture.file("b.csv");
    fixture.sim.sendLine("next");
    (void)fixture.sim.nextLine();
    const ProgramResult result = fixture.interrupted(line, {address, skip, times});
    const QByteArray output = result.out.toUtf8() + result.err.toUtf8();
    QVERIFY2(fixture.cable.interrupted(), output.constData());
    QVERIFY2(result.exit == 1, output.constData());
    auto batch = results::openCommissionBatch(fixture.file("b.csv"));
    QVERIFY(batch);
    QVERIFY2(batch->rows.empty(), output.constData());
    QCOMPARE(batch->pending.size(), std::size_t{1});
    QVERIFY2(fixture.cli.openIntents() == 0, output.constData());
    QVERIFY2(result.err.contains(QLatin1String("1 unfinished")), output.constData());
    QVERIFY2(!result.err.contains(QLatin1String("\"recover\" shows")), output.constData());

    const bool atRate = address == rateAddress;
    const bool atId = atRate || address == idAddress;
    const speed_t rate = atRate ? B500000 : B1000000;
    QCOMPARE(fixture.at(atId ? 11 : 1, lockAddress, 1, rate), 1);
    QCOMPARE(fixture.at(atId ? 11 : 1, torqueSwitch, 1, rate), 0);

    fixture.cable.resetConnection();
    // It asks every ID, so the longer timeout would take 20 s.
    fixture.cli.start(line + words("--timeout 60"));
    // Its lock is closed, so nothing proves that it is the same servo.
    QVERIFY(fixture.cli.waitForError("Continue only if it is the one that is connected now"));
    fixture.cli.process().write("\n");
    QVERIFY(fixture.cli.waitForError("Unplug"));
    fixture.sim.sendLine("unplug");
    (void)fixture.sim.nextLine();
    const ProgramResult again = fixture.cli.finish();
    QVERIFY2(again.exit == 0, qPrintable(again.out + again.err));
    batch = results::openCommissionBatch(fixture.file("b.csv"));
    QVERIFY(batch && batch->rows.size() == 1 && batch->pending.empty());
    QCOMPARE(batch->rows.front().newId, 11);
}

void TestCliCtrlC::onASlowAdapter_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("skip");
    const auto row = [](const char* name, const char* line, int address, int skip) {
        QTest::newRow(name) << QString::fromLatin1(line) << address << skip;
    };
    const char* write = "write 1 max_temperature=60 position_p=20 position_d=10";
    row("write, lock opened", write, lockAddress, 0);
    row("sweep", "sweep 1 --from 1500 --to 2600 --delay 2500 --cycles 50 --speed 900 --torque-off",
        goalAddress, 2);
    if (!support::isDeepCheck())
        return;
    row("write, first row", write, maxTemperature, 0);
    row("write, lock being closed", write, lockAddress, 1);
    row("new ID", "set-id 1 9", idAddress, 0);
    row("mode", "mode 1 speed", modeAddress, 0);
}

/// The same with replies that are 150 ms late.
void TestCliCtrlC::onASlowAdapter()
{
    QFETCH(QString, line);
    QFETCH(int, address);
    QFETCH(int, skip);
    CtrlC fixture("--servos sts3215@1 --latency-ms 150");
    const ProgramResult result = fixture.interrupted(line.split(u' '), {address, skip, 1});
    const QByteArray output = result.out.toUtf8() + result.err.toUtf8();
    QVERIFY2(fixture.cable.interrupted(), output.constData());
    // A change that was almost complete may be reported as done.
    QVERIFY2(result.exit == 1 || (result.exit == 0 && address != goalAddress), output.constData());
    const int id = address == idAddress && fixture.at(9, idAddress) == 9 ? 9 : 1;
    QCOMPARE(fixture.at(id, lockAddress), 1);
    QCOMPARE(fixture.at(id, torqueSwitch), 0);
    QVERIFY2(fixture.cli.openIntents() == 0, output.constData());
    QVERIFY2(result.exit == 1 || address != idAddress || id == 9, output.constData());
    QTRY_COMPARE(fixture.at(id, movingFlag), 0);
}

SERVODESK_GUILESS_TEST(TestCliCtrlC)
#include "tst_cli_ctrl_c.moc"
