// SPDX-License-Identifier: GPL-3.0-or-later
// The program killed (kill -9) at every fourth write of a restore of twenty rows (the deep check:
// at every one), against a simulator that is a program of its own. Between them a bridge that
// counts the frames and kills before or after one of them has reached the servo. What the killed
// program leaves, the next one finds: no lock stays open, and finishing or restoring again
// completes it.
#include "integration/raw_client.h"
#include "integration/twenty_registers.h"
#include "support/cli_program.h"
#include "support/deep_check.h"
#include "support/port_endpoints.h"
#include "support/simulator_priority.h"
#include "support/test_main.h"
#include "transport/tty_speed.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <netinet/tcp.h>

using support::CliProgram;
using support::ProgramResult;

namespace {
enum class KillTime { Before, After }; ///< the servo has received the frame

/// A network bridge to the simulator's terminal, on this thread.
class TcpBridge {
public:
    explicit TcpBridge(const QString& terminal)
        : m_terminal(open(qPrintable(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC))
        , m_tcp(support::listenOnLoopback())
    {
        support::makeRaw(m_terminal);
        transport::setTtySpeed(m_terminal, 1'000'000);
        support::raisePriority();
    }
    ~TcpBridge()
    {
        leave();
        close(m_tcp.listener);
        close(m_terminal);
    }
    TcpBridge(const TcpBridge&) = delete;
    TcpBridge& operator=(const TcpBridge&) = delete;

    QString port() const { return m_tcp.port; }

    /// Runs a command through the bridge. `killAt`: number of the WRITE frame; 0: never.
    ProgramResult run(CliProgram& cli, const QStringList& arguments, int killAt = 0,
                      KillTime kill = KillTime::Before)
    {
        m_writes = 0;
        m_killed = false;
        m_buffer.clear();
        cli.start(arguments);
        while (!cli.process().waitForFinished(0) && cli.process().state() != QProcess::NotRunning)
            serve(cli, killAt, kill);
        leave();
        drain();
        return cli.finish();
    }

    int writes() const { return m_writes; }
    bool killed() const { return m_killed; }

private:
    void leave()
    {
        if (m_client >= 0)
            close(m_client);
        m_client = -1;
    }

    /// Replies that no program waits for any more. The servo answers in order: once it has answered
    /// a question no command asks, all before that have come.
    void drain() const
    {
        const QByteArray threeBytes = raw::bytes("FFFF0104020003F5");
        const QByteArray answer = raw::bytes("FFFF010500030A00EC");
        QByteArray delivered;
        for (int tries = 0; tries < 400 && !delivered.contains(answer); ++tries) {
            pass(threeBytes); // deaf while it writes its EPROM
            char chunk[512];
            pollfd state{m_terminal, POLLIN, 0};
            while (poll(&state, 1, 50) > 0 && !delivered.contains(answer)) {
                const ssize_t got = read(m_terminal, chunk, sizeof chunk);
                if (got <= 0)
                    break;
                delivered.append(chunk, got);
            }
        }
        if (!delivered.contains(answer))
            qFatal("the servo does not answer");
    }

    void serve(CliProgram& cli, int killAt, KillTime kill)
    {
        pollfd states[2] = {{m_client >= 0 ? m_client : m_tcp.listener, POLLIN, 0},
                            {m_terminal, POLLIN, 0}};
        if (poll(states, 2, 5) <= 0)
            return;
        if (states[0].revents != 0 && m_client < 0) {
            m_client = accept4(m_tcp.listener, nullptr, nullptr, SOCK_CLOEXEC);
            const int on = 1;
            setsockopt(m_client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        } else if (states[0].revents != 0) {
            fromHost(cli, killAt, kill);
        }
        if ((states[1].revents & POLLIN) != 0)
            fromServo();
    }

    void fromServo()
    {
        char chunk[512];
        const ssize_t got = read(m_terminal, chunk, sizeof chunk);
        if (got > 0 && m_client >= 0)
            (void)send(m_client, chunk, std::size_t(got), MSG_NOSIGNAL);
    }

    void fromHost(CliProgram& cli, int killAt, KillTime kill)
    {
        char chunk[512];
        const ssize_t got = recv(m_client, chunk, sizeof chunk, 0);
        if (got <= 0)
            return leave();
        m_buffer.append(chunk, got);
        for (QByteArray frame = nextFrame(); !frame.isEmpty(); frame = nextFrame()) {
            const bool isWrite = frame.size() > 5 && frame[4] == char(support::Write);
            m_writes += isWrite ? 1 : 0;
            const bool now = isWrite && m_writes == killAt;
            if (!now || kill == KillTime::After)
                pass(frame);
            if (!now)
                continue;
            cli.signal(SIGKILL);
            m_killed = true;
            return leave();
        }
    }

    /// Whole frames only, so that each is counted once. Empty: not yet.
    QByteArray nextFrame()
    {
        constexpr qsizetype head = 4;
        const qsizetype begin = m_buffer.indexOf("\xFF\xFF");
        if (begin < 0 || m_buffer.size() < begin + head)
            return {};
        const qsizetype size = head + static_cast<unsigned char>(m_buffer[begin + 3]);
        if (m_buffer.size() < begin + size)
            return {};
        const QByteArray frame = m_buffer.mid(begin, size);
        m_buffer.remove(0, begin + size);
        return frame;
    }

    void pass(const QByteArray& frame) const
    {
        if (write(m_terminal, frame.constData(), std::size_t(frame.size())) != frame.size())
            qFatal("terminal");
    }

    int m_terminal;
    support::TcpPort m_tcp;
    int m_client = -1;
    int m_writes = 0;
    bool m_killed = false;
    QByteArray m_buffer;
};

QJsonArray listOf(const ProgramResult& result, const char* name)
{
    return result.json()[QLatin1String(name)].toArray();
}
} // namespace

class TestRestoreKill : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void killedAtEveryWrite_data();
    void killedAtEveryWrite();

private:
    void complete(TcpBridge& bridge, CliProgram& cli, const QStringList& restore, bool again,
                  bool open);
};

void TestRestoreKill::killedAtEveryWrite_data()
{
    QTest::addColumn<int>("kill");
    QTest::newRow("before the servo hears it") << int(KillTime::Before);
    QTest::newRow("after the servo has heard it") << int(KillTime::After);
}

void TestRestoreKill::complete(TcpBridge& bridge, CliProgram& cli, const QStringList& restore,
                               bool again, bool open)
{
    if (again) {
        const ProgramResult result = bridge.run(cli, restore);
        QVERIFY2(result.exit == 0, qPrintable(result.err + result.out));
    } else {
        const ProgramResult result = bridge.run(cli, support::words("recover --finish --json"));
        QVERIFY2(result.exit == 0, qPrintable(result.err + result.out));
        QCOMPARE(listOf(result, "intents").isEmpty(), !open);
    }
}

void TestRestoreKill::killedAtEveryWrite()
{
    QFETCH(int, kill);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("wanted.servo.json"));
    QVERIFY(snapshot::saveSnapshot(support::twentyRegisterSnapshot(), file));
    const QStringList restore = QStringList(support::words("snapshot restore 1"))
                                << file << QStringLiteral("--dangerous")
                                << QStringLiteral("--json");
    // tst_restore_interrupted does it at every moment, in one process.
    const int step = support::isDeepCheck() ? 1 : 4;
    int kills = 0;
    for (int at = 1;; at += step) {
        const raw::Simulator simulator(
            support::words("--servos sts3215@1+deaf=1+run-to-goal=1 --baud 1000000"));
        TcpBridge bridge(simulator.port());
        CliProgram cli;
        cli.setPort(bridge.port());
        const ProgramResult ended = bridge.run(cli, restore, at, KillTime(kill));
        if (!bridge.killed()) {
            QCOMPARE(ended.exit, 0); // there were no more writes
            break;
        }
        ++kills;
        QCOMPARE(ended.exit, -1);
        const QByteArray where = QByteArray::number(at);

        // The journal knows what is owed, and looking writes nothing.
        const ProgramResult look = bridge.run(cli, support::words("recover --json"));
        QCOMPARE(bridge.writes(), 0);
        const QJsonArray intents = listOf(look, "intents");
        const ProgramResult lock = bridge.run(cli, support::words("read 1 lock --json"));
        const bool lockOpen =
            listOf(lock, "registers").first().toObject()[QLatin1String("raw")].toInt(-1) == 0;
        QVERIFY2(!lockOpen || intents.size() == 1, where.constData());
        for (const QJsonValue& intent : intents) {
            QCOMPARE(intent[QLatin1String("items")].toArray().size(), 20);
            QCOMPARE(intent[QLatin1String("kind")].toString(), QStringLiteral("snapshot-restore"));
        }

        complete(bridge, cli, restore, kills % 2 == 0 || intents.isEmpty(), !intents.isEmpty());
        const ProgramResult left = bridge.run(cli, support::words("recover --json"));
        QVERIFY2(listOf(left, "intents").isEmpty(), where.constData());
        const ProgramResult closed = bridge.run(cli, support::words("read 1 lock --json"));
        QCOMPARE(listOf(closed, "registers").first().toObject()[QLatin1String("raw")].toInt(-1), 1);
        const ProgramResult diff = bridge.run(cli, QStringList(support::words("snapshot diff 1"))
                                                       << file << QStringLiteral("--json"));
        for (const QJsonValue& row : listOf(diff, "rows")) {
            if (support::twentyRegisters().count(row[QLatin1String("key")].toString()) > 0)
                QCOMPARE(row[QLatin1String("verdict")].toString(), QStringLiteral("identical"));
        }
        const ProgramResult again = bridge.run(cli, restore);
        QCOMPARE(again.json()[QLatin1String("verdict")].toString(), QStringLiteral("already-so"));
        QCOMPARE(bridge.writes(), 0);
    }
    QVERIFY(kills > 8 / step);
}

SERVODESK_GUILESS_TEST(TestRestoreKill)
#include "tst_restore_kill.moc"
