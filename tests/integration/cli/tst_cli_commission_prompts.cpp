// SPDX-License-Identifier: GPL-3.0-or-later
// The input while servos are set up one after the other: Enter, a, s, or its end; and plugging the
// servos of servodesk-sim in and out by lines on its standard input and by a signal.
#include "integration/raw_client.h"
#include "results/commission_batch.h"
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

#include <cstring>
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

using support::CliProgram;
using support::ProgramResult;
using support::utf8;

namespace {
/// The command with six simulated servos and typed input.
class InteractiveCommission {
public:
    InteractiveCommission() { m_cli.setPort(utf8("sim:line")); }

    QString csv() const { return m_cli.dataFolder() + utf8("/batch.csv"); }
    void start(const char* line)
    {
        m_cli.start(support::words(line) << utf8("--batch") << csv(), CliProgram::Time::Skipped);
    }
    /// Whether it asks this; false: it has ended without asking.
    bool asks(const char* question) { return m_cli.waitForError(question); }
    /// Before start(); otherwise the input is a pipe.
    void attachTerminal()
    {
        m_terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        grantpt(m_terminal);
        unlockpt(m_terminal);
        m_cli.process().setChildProcessModifier([name = QByteArray(ptsname(m_terminal))] {
            setsid();
            const int keys = open(name.constData(), O_RDWR); // becomes the terminal of the session
            dup2(keys, STDIN_FILENO);
        });
    }
    void press(const char* keys)
    {
        if (m_terminal >= 0)
            (void)!::write(m_terminal, keys, strlen(keys));
        else
            m_cli.process().write(keys);
    }
    ProgramResult finish() { return m_cli.finish(); }

    /// The rows saved so far.
    std::vector<results::CommissionRow> rows() const
    {
        const auto batch = results::openCommissionBatch(csv());
        if (!batch)
            qFatal("no batch");
        return batch->rows;
    }

    ~InteractiveCommission()
    {
        if (m_terminal >= 0)
            close(m_terminal);
    }

private:
    int m_terminal = -1;
    CliProgram m_cli;
};

const QByteArray pingReply = raw::bytes("FFFF010200FC"); // of ID 1, no alarm

/// Simulated servos in another program, and a client on its bus.
class HotplugSimulator {
public:
    QString readLine() { return m_simulator.nextLine(); }
    void sendLine(const char* line) { m_simulator.sendLine(line); }
    void signal(int number) const { kill(static_cast<pid_t>(m_simulator.pid()), number); }
    /// The connected servo replies under the factory ID as soon as it has started.
    QByteArray ping() const { return m_client.requestUntilReply("FFFF010201FB", pingReply.size()); }
    bool silent() const
    {
        m_client.send(raw::bytes("FFFF010201FB"));
        constexpr int silenceMs = 100;
        return !m_client.readable(silenceMs);
    }
    int end() { return m_simulator.end(); }

private:
    raw::Simulator m_simulator{support::words("--preset line --eprom-ms 1")};
    raw::Client m_client{m_simulator.port()};
};
} // namespace

class TestCliCommissionPrompts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void enterConfiguresIt();
    void aRejectsIt();
    void sConfirmsTheInterruptedServo_data();
    void sConfirmsTheInterruptedServo();
    void anythingElseIsNo();
    void earlierInputIsNoAnswer();
    void closedStdinEndsTheBatch();
    void hotplugFollowsStdinCommands();
    void hotplugFollowsASignal();
    void unknownHotplugCommandsAreReported();
};

void TestCliCommissionPrompts::enterConfiguresIt()
{
    InteractiveCommission keys;
    keys.start("commission --first-id 5 --count 2");
    QVERIFY(keys.asks("be changed to ID 5."));
    QVERIFY(keys.rows().empty()); // not before it is confirmed
    keys.press("\n");
    QVERIFY(keys.asks("be changed to ID 6."));
    QCOMPARE(keys.rows().size(), std::size_t(1));
    keys.press("\n");
    const ProgramResult result = keys.finish();
    QVERIFY2(result.exit == 0, qPrintable(result.err));
    const auto rows = keys.rows();
    QCOMPARE(rows.size(), std::size_t(2));
    for (int i = 0; i < 2; ++i) {
        QCOMPARE(rows[std::size_t(i)].verdict, results::CommissionVerdict::Good);
        QCOMPARE(rows[std::size_t(i)].newId, 5 + i);
        QVERIFY(result.out.contains(QStringLiteral("ID %1").arg(5 + i)));
    }
}

void TestCliCommissionPrompts::aRejectsIt()
{
    InteractiveCommission keys;
    keys.start("commission --first-id 5 --count 1");
    QVERIFY(keys.asks("type \"a\" and press Enter to set the servo aside"));
    keys.press("a\n");
    QVERIFY(keys.asks("\nUnplug the servo.\n"));
    const auto rejected = keys.rows();
    QCOMPARE(rejected.size(), std::size_t(1));
    QCOMPARE(rejected[0].verdict, results::CommissionVerdict::Skipped);
    QCOMPARE(rejected[0].newId, -1);
    QVERIFY2(rejected[0].snapshot.isEmpty(), "nothing is written, so nothing is saved");
    // The ID is left for the next servo.
    QVERIFY(keys.asks("\nUnplug the servo.\nConnect the next servo (it will get ID 5).\nThe "
                      "STS3215 with ID 1 at"));
    keys.press("\n");
    const ProgramResult result = keys.finish();
    QCOMPARE(result.exit, 1); // one was not set up
    const auto rows = keys.rows();
    QCOMPARE(rows.size(), std::size_t(2));
    QCOMPARE(rows[1].verdict, results::CommissionVerdict::Good);
    QCOMPARE(rows[1].newId, 5);
    QVERIFY(result.err.contains(utf8("1 set up, 0 failed, 1 set aside; 0 unfinished")));
}

void TestCliCommissionPrompts::sConfirmsTheInterruptedServo_data()
{
    QTest::addColumn<QByteArray>("way");
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("unfinished");
    for (const char* way : {"", " --auto"}) {
        QTest::addRow("s%s", way) << QByteArray(way) << QByteArray("s\n") << 9 << 0;
        QTest::addRow("another one%s", way) << QByteArray(way) << QByteArray("\n") << 5 << 1;
        QTest::addRow("no answer%s", way) << QByteArray(way) << QByteArray() << -1 << 1;
    }
}

void TestCliCommissionPrompts::sConfirmsTheInterruptedServo()
{
    QFETCH(const QByteArray, way);
    QFETCH(const QByteArray, answer);
    QFETCH(const int, id);
    QFETCH(const int, unfinished);
    // The first servo, as identified by this program.
    InteractiveCommission first;
    first.start("commission --first-id 5 --count 1");
    QVERIFY(first.asks("be changed to ID 5."));
    first.press("\n");
    QCOMPARE(first.finish().exit, 0);
    const results::CommissionRow met = first.rows().front();

    // A servo like it was to get ID 9 when the program was killed; whether it has it is unknown.
    InteractiveCommission keys;
    results::PendingCommission left;
    left.at = met.at;
    left.servo = met.servo;
    left.oldBaud = left.newBaud = met.oldBaud;
    left.newId = 9;
    left.isIdSent = true;
    results::CommissionBatch batch;
    batch.pending = {left};
    QVERIFY(results::saveCommissionBatch(batch, keys.csv()));

    keys.start(QByteArray("commission --first-id 5 --count 1" + way).constData());
    QVERIFY(keys.asks(
        "its assigned ID is 9. If the connected servo is that one, type \"s\" and press Enter"));
    keys.press(answer.constData());
    const ProgramResult result = keys.finish();
    QCOMPARE(result.exit, unfinished);
    QVERIFY2(result.err.contains(utf8("one of these IDs: 1, 9")), qPrintable(result.err));
    const auto after = results::openCommissionBatch(keys.csv());
    QVERIFY(after);
    QCOMPARE(after->pending.size(), std::size_t(unfinished));
    QCOMPARE(after->rows.size(), std::size_t(id < 0 ? 0 : 1));
    if (id < 0)
        return;
    QCOMPARE(after->rows[0].verdict, results::CommissionVerdict::Good);
    QCOMPARE(after->rows[0].newId, id);
}

void TestCliCommissionPrompts::anythingElseIsNo()
{
    InteractiveCommission keys;
    keys.start("commission --first-id 5 --count 1");
    QVERIFY(keys.asks("be changed to ID 5."));
    keys.press("no\n");
    QVERIFY(keys.asks("Nothing was done."));
    QVERIFY(keys.rows().empty());
    keys.press("\n");
    QCOMPARE(keys.finish().exit, 0);
    QCOMPARE(keys.rows().size(), std::size_t(1));
}

/// At a terminal: an extra Enter at the first servo does not set up the second one.
void TestCliCommissionPrompts::earlierInputIsNoAnswer()
{
    InteractiveCommission keys;
    keys.attachTerminal();
    keys.start("commission --first-id 5 --count 2");
    QVERIFY(keys.asks("be changed to ID 5."));
    keys.press("\n\n\n");
    QVERIFY(keys.asks("be changed to ID 6. Press Enter"));
    QCOMPARE(keys.rows().size(), std::size_t(1));
    keys.press("a\n"); // the answer to the present question
    QVERIFY(keys.asks("\nUnplug the servo.\n"));
    const auto rows = keys.rows();
    QCOMPARE(rows.size(), std::size_t(2));
    QCOMPARE(rows[1].verdict, results::CommissionVerdict::Skipped);
    keys.press("\x03"); // Ctrl-C
    QCOMPARE(keys.finish().exit, 1);
}

void TestCliCommissionPrompts::closedStdinEndsTheBatch()
{
    InteractiveCommission keys;
    keys.start("commission --first-id 5 --count 1");
    QVERIFY(keys.asks("be changed to ID 5."));
    const ProgramResult result = keys.finish(); // the end of its standard input
    QCOMPARE(result.exit, 0);
    QVERIFY(keys.rows().empty());
    QVERIFY(result.err.contains(utf8("0 set up, 0 failed, 0 set aside; 0 unfinished")));
}

void TestCliCommissionPrompts::hotplugFollowsStdinCommands()
{
    HotplugSimulator bag;
    QVERIFY2(bag.silent(), "nobody is plugged in yet");
    bag.sendLine("next");
    const QString plugged = bag.readLine();
    QVERIFY2(plugged.startsWith(utf8("plugged: ")) && plugged.endsWith(utf8("(1 of 6)")),
             qPrintable(plugged));
    QCOMPARE(bag.ping(), pingReply);
    bag.sendLine("unplug");
    QCOMPARE(bag.readLine(), utf8("unplugged"));
    QVERIFY(bag.silent());
    bag.sendLine("plug 3");
    QVERIFY(bag.readLine().endsWith(utf8("(3 of 6)")));
    QCOMPARE(bag.ping(), pingReply);
    // The next servo replaces it; one that has been connected does not return.
    for (const int place : {2, 4, 5, 6}) {
        bag.sendLine("next");
        QVERIFY(bag.readLine().endsWith(QStringLiteral("(%1 of 6)").arg(place)));
        QCOMPARE(bag.ping(), pingReply);
    }
    bag.sendLine("next");
    QCOMPARE(bag.readLine(), utf8("unplugged; the bag is empty"));
    QVERIFY(bag.silent());
    QCOMPARE(bag.end(), 0);
}

void TestCliCommissionPrompts::hotplugFollowsASignal()
{
    HotplugSimulator bag;
    for (int place = 1; place <= 6; ++place) {
        bag.signal(SIGUSR1);
        const QString said = bag.readLine();
        QVERIFY2(said.endsWith(QStringLiteral("(%1 of 6)").arg(place)), qPrintable(said));
        QCOMPARE(bag.ping(), pingReply);
    }
    bag.signal(SIGUSR1);
    QCOMPARE(bag.readLine(), utf8("unplugged; the bag is empty"));
    QVERIFY(bag.silent());
    QCOMPARE(bag.end(), 0);
}

void TestCliCommissionPrompts::unknownHotplugCommandsAreReported()
{
    HotplugSimulator bag;
    for (const char* line : {"plug", "plug 0", "plug 7", "plug one", "plug 1 2", "shake", "NEXT"}) {
        bag.sendLine(line);
        QCOMPARE(bag.readLine(), utf8("not understood: ") + utf8(line));
    }
    QVERIFY(bag.silent());
    // An empty line is nothing.
    bag.sendLine("");
    bag.sendLine("next");
    QVERIFY(bag.readLine().endsWith(utf8("(1 of 6)")));
    QCOMPARE(bag.ping(), pingReply);
}

SERVODESK_GUILESS_TEST(TestCliCommissionPrompts)
#include "tst_cli_commission_prompts.moc"
