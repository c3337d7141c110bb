// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli diagnose: exit codes, the document for programs, and ports that cannot be opened.
// The causes themselves are tested on 300 simulated buses in tst_diagnose.
#include "session/session.h"
#include "support/cli_program.h"
#include "support/port_endpoints.h"
#include "support/test_main.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <atomic>
#include <csignal>
#include <poll.h>
#include <thread>
#include <unistd.h>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;
using support::words;

namespace {
/// Answers whatever it receives with a line of its log.
class TalkingBoard {
public:
    TalkingBoard()
        : m_terminal(support::makeTerminal())
        , m_thread([this] { talk(); })
    {}
    ~TalkingBoard()
    {
        m_over = true;
        m_thread.join();
        ::close(m_terminal.slave);
        ::close(m_terminal.master);
    }
    QString port() const { return m_terminal.port; }

private:
    void talk() const
    {
        constexpr char line[] = "E (312) uart: unknown command\r\n";
        char received[512];
        while (!m_over) {
            pollfd state{m_terminal.master, POLLIN, 0};
            if (::poll(&state, 1, 20) > 0 &&
                ::read(m_terminal.master, received, sizeof received) > 0)
                (void)!::write(m_terminal.master, line, sizeof line - 1);
        }
    }

    support::Terminal m_terminal;
    std::atomic<bool> m_over{false};
    std::thread m_thread;
};
} // namespace

class TestCliDiagnose : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void allIsWell();
    void aPortThatIsMissingIsACause();
    void noAdapterIsACause();
    void aBoardsTextIsACause();
    void explainsItselfAsText();
    void namesNoCauseWhenItIsStopped();
};

void TestCliDiagnose::allIsWell()
{
    CliProgram cli;
    const ProgramResult result = cli.json("diagnose --bauds 1000000");
    QCOMPARE(result.exit, 0);
    const QJsonObject document = result.json();
    QCOMPARE(document[QLatin1String("cause")].toString(), QStringLiteral("found"));
    QVERIFY(document[QLatin1String("also")].toArray().isEmpty());
    QVERIFY(document[QLatin1String("evidence")].toArray().size() > 3);
    QVERIFY(document[QLatin1String("remedy")].toString().startsWith(
        QLatin1String("If a servo is missing")));
}

void TestCliDiagnose::aPortThatIsMissingIsACause()
{
    CliProgram cli;
    cli.setPort(cli.dataFolder() + QStringLiteral("/ttyUSB0"));
    const ProgramResult result = cli.json("diagnose");
    QCOMPARE(result.exit, 1);
    QCOMPARE(result.json()[QLatin1String("cause")].toString(), QStringLiteral("port-missing"));
    QVERIFY(result.json()[QLatin1String("remedy")].toString().contains(QLatin1String("brltty")));
}

void TestCliDiagnose::aBoardsTextIsACause()
{
    TalkingBoard board;
    CliProgram cli;
    cli.setPort(board.port());
    const ProgramResult result = cli.json("diagnose --bauds 1000000");
    QCOMPARE(result.exit, 1);
    QCOMPARE(result.json()[QLatin1String("cause")].toString(), QStringLiteral("board-not-adapter"));
}

void TestCliDiagnose::noAdapterIsACause()
{
    if (!session::adapters().empty())
        QSKIP("an adapter is connected to this computer");
    CliProgram cli;
    cli.setPort({});
    const ProgramResult result = cli.json("diagnose");
    QCOMPARE(result.exit, 1);
    QCOMPARE(result.json()[QLatin1String("cause")].toString(), QStringLiteral("port-missing"));
}

void TestCliDiagnose::explainsItselfAsText()
{
    SimProgram sim(words("--servos sts3215@1,sts3215@2 --baud 500000"));
    CliProgram cli;
    cli.setPort(sim.port());
    const ProgramResult result = cli.run("diagnose --bauds 500000");
    QCOMPARE(result.exit, 1);
    QVERIFY2(
        result.out.contains(QLatin1String("2 servos found at 500000 baud (Feetech): ID 1, 2\n")),
        qPrintable(result.out));
    QVERIFY(
        result.out.contains(QLatin1String("\nCause: Some servos use a different baud rate.\n")));
    QVERIFY(result.out.contains(QLatin1String("\nWhat to do: Connect at the baud rate")));
}

void TestCliDiagnose::namesNoCauseWhenItIsStopped()
{
    CliProgram cli;
    cli.start(words("--baud 1000000 --protocol modbus diagnose"));
    QVERIFY(cli.waitForOutput("does not echo"));
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QVERIFY(result.exit != 0);
    QVERIFY2(result.out.contains(QLatin1String("\nThe diagnosis was stopped early.\n")),
             qPrintable(result.out));
    QVERIFY(!result.out.contains(QLatin1String("Cause:")));
}

SERVODESK_GUILESS_TEST(TestCliDiagnose)
#include "tst_cli_diagnose.moc"
