// SPDX-License-Identifier: GPL-3.0-or-later
// The history server over TLS and over a bad network: a real PostgreSQL with certificates made by
// openssl, a relay before it that cuts, swallows and crawls, and whatever else may answer at its
// address. Another computer must prove who it is unless the user says otherwise; the program never
// hangs, says cause and remedy, and whatever was missed arrives later.
#include "session/history/history_sender.h"
#include "support/canned_reply_server.h"
#include "support/cli_program.h"
#include "support/deep_check.h"
#include "support/history_example.h"
#include "support/history_sender_times.h"
#include "support/history_server_fixture.h"
#include "support/relay.h"
#include "support/silent_server.h"
#include "support/test_main.h"
#include "support/text.h"
#include "support/tls_files.h"
#include "text/error_text.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QtTest>

#include <csignal>

using history_example::Bench;
using history_example::everything;
using session::HistorySender;
using session::HistoryUploader;
using support::serverErrorKind;
using support::shortSenderTimes;
using support::utf8;
using Phase = session::SendState::Phase;
using namespace std::chrono_literals;

namespace {
const QString host = QStringLiteral("bench.example");
} // namespace

class TestHistoryTls : public QObject, private support::HistoryServerFixture {
    Q_OBJECT

private:
    /// The server as another computer: its name, and where that is.
    QString named(const QString& name, const QString& rest) const
    {
        return QString(address()).replace(utf8("host=127.0.0.1"),
                                          utf8("host=%1 hostaddr=127.0.0.1").arg(name)) +
               u' ' + rest;
    }
    QString trustedAddress() const
    {
        return named(host, utf8("sslrootcert=%1").arg(m_authority.root()));
    }
    QString through(const support::Relay& relay) const
    {
        return trustedAddress().replace(utf8("port=%1").arg(m_pg.port()),
                                        utf8("port=%1").arg(relay.port()));
    }
    base::Result<session::SendProgress> sendTo(const Bench& bench, const QString& server) const
    {
        return HistoryUploader(bench.path, server, utf8("Bench")).send();
    }
    void verifyCopied(const Bench& bench)
    {
        QCOMPARE(everything(*browse()), everything(*bench.open()));
    }

    support::TlsAuthority m_authority;
    support::TlsAuthority m_other;

private Q_SLOTS:
    void initTestCase()
    {
        for (support::TlsAuthority* authority : {&m_authority, &m_other})
            QVERIFY2(authority->make() && authority->issue(host),
                     qPrintable(authority->errorString()));
        QVERIFY2(m_pg.enableTls(m_authority.certificate(), m_authority.key()),
                 qPrintable(m_pg.errorString()));
        startServer();
    }
    void init()
    {
        QTest::failOnWarning(QRegularExpression(utf8(".*")));
        newDatabase();
    }

    void theServerIsVerified_data();
    void theServerIsVerified();
    void aServerWithoutTls();
    void verificationCanBeDisabled_data();
    void verificationCanBeDisabled();
    void connectionLostAnywhereLosesNothing();
    void silenceAnywhereTimesOut_data();
    void silenceAnywhereTimesOut();
    void aSlowServerIsWaitedFor();
    void anotherServiceAnswers_data();
    void anotherServiceAnswers();
    void theCommandLineReportsIt();
    void theCommandLineCanBeInterrupted_data();
    void theCommandLineCanBeInterrupted();
    void noPasswordIsStored_data();
    void noPasswordIsStored();
    void aPasswordInTheSettingsIsNotUsed();
};

void TestHistoryTls::theServerIsVerified_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("rest"); ///< %1: our authority, %2: another one
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("remedy");
    QTest::newRow("a known authority") << host << "sslrootcert=%1"
                                       << ""
                                       << "";
    QTest::newRow("another authority") << host << "sslrootcert=%2"
                                       << "certificate"
                                       << "sslrootcert=";
    QTest::newRow("no authorities") << host << "sslrootcert=/nowhere"
                                    << "certificate"
                                    << "~/.postgresql/root.crt";
    QTest::newRow("nothing said about it") << host << ""
                                           << "certificate"
                                           << "~/.postgresql/root.crt";
    QTest::newRow("another name") << "other.example"
                                  << "sslrootcert=%1"
                                  << "host-name"
                                  << "sslmode=verify-ca";
}

void TestHistoryTls::theServerIsVerified()
{
    QFETCH(QString, name);
    QFETCH(QString, rest);
    QFETCH(QString, kind);
    QFETCH(QString, remedy);
    rest.replace(utf8("%1"), m_authority.root()).replace(utf8("%2"), m_other.root());
    Bench bench;
    history_example::fill(bench);
    const auto sent = sendTo(bench, named(name, rest));
    if (kind.isEmpty()) {
        QVERIFY2(sent, sent ? "" : qPrintable(sent.error().detail));
    } else {
        QVERIFY(!sent);
        QCOMPARE(serverErrorKind(sent.error()), kind);
        const text::Description words = text::describe(sent.error());
        QVERIFY2(words.message.contains(utf8("certificate")), qPrintable(words.message));
        QVERIFY(!words.cause.isEmpty());
        QVERIFY2(words.remedy.contains(remedy), qPrintable(words.remedy));
        // Nothing was given away, and nothing is lost.
        QCOMPARE(m_pg.query(m_database, utf8("SELECT count(*) FROM pg_namespace WHERE nspname = "
                                             "'servodesk'")),
                 utf8("0"));
        QVERIFY(sendTo(bench, trustedAddress()).has_value());
    }
    verifyCopied(bench);
}

/// Somebody between who takes TLS away gets nothing.
void TestHistoryTls::aServerWithoutTls()
{
    support::Postgres plain;
    QVERIFY2(plain.start(), qPrintable(plain.errorString()));
    const QString otherServer =
        plain.address(utf8("postgres"))
            .replace(utf8("host=127.0.0.1"), utf8("host=%1 hostaddr=127.0.0.1").arg(host));
    Bench bench;
    history_example::fill(bench);
    const auto refused = sendTo(bench, otherServer);
    QVERIFY(!refused);
    QCOMPARE(serverErrorKind(refused.error()), utf8("tls"));
    QVERIFY(text::describe(refused.error()).remedy.contains(utf8("sslmode=disable")));
    const auto permitted = sendTo(bench, otherServer + utf8(" sslmode=disable"));
    QVERIFY2(permitted, permitted ? "" : qPrintable(permitted.error().detail));
    // This very computer needs none.
    QVERIFY(sendTo(bench, plain.address(utf8("postgres"))).has_value());
}

void TestHistoryTls::verificationCanBeDisabled_data()
{
    QTest::addColumn<QString>("rest");
    QTest::addColumn<QString>("environment");
    QTest::newRow("in the string, encrypted") << "sslmode=require"
                                              << "";
    QTest::newRow("in the string, plain") << "sslmode=disable"
                                          << "";
    QTest::newRow("by libpq's variable") << ""
                                         << "require";
}

void TestHistoryTls::verificationCanBeDisabled()
{
    QFETCH(QString, rest);
    QFETCH(QString, environment);
    if (!environment.isEmpty())
        qputenv("PGSSLMODE", environment.toUtf8());
    Bench bench;
    history_example::fill(bench);
    const auto sent = sendTo(bench, named(host, rest));
    qunsetenv("PGSSLMODE");
    QVERIFY2(sent, sent ? "" : qPrintable(sent.error().detail));
    verifyCopied(bench);
}

/// The line breaks after so many bytes, in the handshake and at any point after it; what is written
/// meanwhile waits for nobody, and in the end everything is there once.
void TestHistoryTls::connectionLostAnywhereLosesNothing()
{
    Bench bench;
    history_example::fill(bench);
    support::Relay relay(m_pg.port());
    HistorySender sender(bench.path, shortSenderTimes());
    int troubles = 0;
    connect(&sender, &HistorySender::stateChanged, this, [&] {
        const session::SendState& state = sender.state();
        if (state.phase != Phase::Failed)
            return;
        ++troubles;
        QCOMPARE(serverErrorKind(*state.error), utf8("away"));
        QVERIFY(!text::describe(*state.error).remedy.isEmpty());
    });
    for (const qint64 bytes : {0, 8, 100, 700, 1500, 3000, 6000, 12000, 25000}) {
        relay.limitTo(bytes, support::Relay::LimitAction::Cut);
        const int before = relay.connections();
        sender.setServer(through(relay), utf8("Bench"));
        QTRY_VERIFY(relay.connections() >= before + 2);
        history_example::write(bench.journal, 1, bytes);
    }
    QVERIFY(troubles > 0);
    relay.removeLimit();
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    sender.setServer(through(relay), utf8("Bench"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
}

void TestHistoryTls::silenceAnywhereTimesOut_data()
{
    QTest::addColumn<int>("bytes");
    for (const int bytes : {0, 100, 1500, 6000}) {
        if (bytes == 0 || bytes == 1500 || support::isDeepCheck())
            QTest::addRow("%d bytes", bytes) << bytes;
    }
}

/// From some point on everything is swallowed: that counts as hung, and neither the next try nor
/// the end of the program waits for it.
void TestHistoryTls::silenceAnywhereTimesOut()
{
    QFETCH(int, bytes);
    Bench bench;
    history_example::fill(bench);
    support::Relay relay(m_pg.port());
    relay.limitTo(bytes, support::Relay::LimitAction::Discard);
    HistorySender sender(bench.path, shortSenderTimes(500ms));
    sender.setServer(through(relay), utf8("Bench"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::Failed));
    QCOMPARE(serverErrorKind(*sender.state().error), utf8("hung"));
    history_example::write(bench.journal, 1, 7);
    relay.removeLimit();
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
    relay.limitTo(bytes, support::Relay::LimitAction::Discard);
    history_example::write(bench.journal, 1, 8);
    auto left = std::make_unique<HistorySender>(bench.path, shortSenderTimes(500ms));
    left->setServer(through(relay), utf8("Bench"));
    left.reset();
}

void TestHistoryTls::aSlowServerIsWaitedFor()
{
    Bench bench;
    history_example::fill(bench);
    support::Relay relay(m_pg.port());
    relay.setRateLimit(60);
    HistorySender sender(bench.path, shortSenderTimes());
    sender.setServer(through(relay), utf8("Bench"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
}

void TestHistoryTls::anotherServiceAnswers_data()
{
    QTest::addColumn<QByteArray>("answer");
    QTest::newRow("hangs up") << QByteArray();
    QTest::newRow("a web server") << QByteArray("HTTP/1.1 400 Bad Request\r\n\r\n");
    QTest::newRow("yes to TLS, then nonsense")
        << QByteArray("S\x15\x03\x01garbage garbage garbage");
    QTest::newRow("an error with escapes")
        << QByteArray("E\x1b[2J\x1b]0;owned\x07 no entry") + QByteArray(3000, 'x');
}

/// Whatever it is, it ends with words about the history server, and no control characters in them.
void TestHistoryTls::anotherServiceAnswers()
{
    QFETCH(QByteArray, answer);
    const support::CannedReplyServer server(answer);
    Bench bench;
    history_example::fill(bench);
    HistorySender sender(bench.path, shortSenderTimes(500ms));
    sender.setServer(
        utf8("host=%1 hostaddr=127.0.0.1 port=%2 user=u dbname=d").arg(host).arg(server.port()),
        utf8("Bench"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::Failed));
    const text::Description words = text::describe(*sender.state().error);
    QVERIFY2(words.message.contains(utf8("history server")), qPrintable(words.message));
    QVERIFY(!words.remedy.isEmpty());
    for (const QChar c : words.message)
        QVERIFY2(c.isPrint(), qPrintable(words.message));
    sender.setServer(trustedAddress(), utf8("Bench"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
}

void TestHistoryTls::theCommandLineReportsIt()
{
    support::CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    QCOMPARE(cli.run("write 1 max_temperature=61").exit, 0);
    cli.setPort(QString());
    const auto sync = [&](const QString& server) {
        return cli.run({utf8("history"), utf8("sync"), utf8("--server"), server});
    };
    const support::ProgramResult untrusted =
        sync(named(host, utf8("sslrootcert=%1").arg(m_other.root())));
    QVERIFY2(untrusted.exit == 3, qPrintable(untrusted.err));
    QVERIFY2(untrusted.err.contains(utf8("cannot be verified")) &&
                 untrusted.err.contains(utf8("sslrootcert=FILE")),
             qPrintable(untrusted.err));
    const support::SilentServer silent;
    const support::ProgramResult hung = sync(silent.address());
    QVERIFY2(hung.exit == 3, qPrintable(hung.err));
    QVERIFY2(hung.err.contains(utf8("does not respond")), qPrintable(hung.err));
    const support::ProgramResult sent = sync(trustedAddress());
    QVERIFY2(sent.exit == 0, qPrintable(sent.err));
    const support::ProgramResult listed =
        cli.run({utf8("history"), utf8("--json"), utf8("--server"), trustedAddress()});
    QVERIFY2(listed.exit == 0, qPrintable(listed.err));
    QCOMPARE(listed.json().value(utf8("writes")).toArray().size(), 1);
}

void TestHistoryTls::theCommandLineCanBeInterrupted_data()
{
    QTest::addColumn<bool>("connecting");
    QTest::newRow("while connecting") << true;
    QTest::newRow("while it waits for rows") << false;
}

void TestHistoryTls::theCommandLineCanBeInterrupted()
{
    QFETCH(bool, connecting);
    Bench bench;
    history_example::fill(bench);
    QVERIFY(sendTo(bench, trustedAddress()).has_value());
    support::Relay relay(m_pg.port());
    relay.limitTo(connecting ? 8 : -1, support::Relay::LimitAction::Discard);
    QProcess holder; // of the table that is asked for
    holder.start(utf8("psql"), {utf8("-X"), utf8("-c"), utf8("BEGIN; LOCK TABLE servodesk.writes"),
                                utf8("-c"), utf8("SELECT pg_sleep(3600)"), address()});
    const auto count = [&](const char* what) {
        return m_pg.query(m_database, utf8("SELECT count(*) FROM ") + utf8(what));
    };
    QTRY_COMPARE(count("pg_locks l JOIN pg_database d ON d.oid = l.database WHERE d.datname = "
                       "current_database() AND "
                       "l.mode = 'AccessExclusiveLock' AND l.granted"),
                 utf8("1"));
    support::CliProgram cli;
    cli.setPort(QString());
    cli.start({utf8("history"), utf8("--server"), through(relay) + utf8(" connect_timeout=30")});
    if (connecting)
        QTRY_VERIFY(relay.hasSwallowed());
    else
        QTRY_COMPARE(count("pg_stat_activity WHERE datname = current_database() AND "
                           "application_name = 'servodesk' AND wait_event_type = 'Lock'"),
                     utf8("1"));
    cli.signal(SIGINT);
    const support::ProgramResult ended = cli.finish();
    holder.kill();
    holder.waitForFinished();
    QCOMPARE(ended.exit, 1);
    QVERIFY2(ended.err.contains(utf8("stopped"), Qt::CaseInsensitive), qPrintable(ended.err));
}

void TestHistoryTls::noPasswordIsStored_data()
{
    QTest::addColumn<QString>("server");
    QTest::newRow("uri") << "postgresql://u:swordfish@127.0.0.1:1/db";
    QTest::newRow("words") << "host=127.0.0.1 port=1 password=swordfish";
    QTest::newRow("nonsense") << "host=127.0.0.1 password='swordfish";
    QTest::newRow("another word") << "host=127.0.0.1 pwd=swordfish";
}

void TestHistoryTls::noPasswordIsStored()
{
    QFETCH(QString, server);
    support::CliProgram cli;
    cli.setPort(QString());
    const QList<QStringList> commands{
        {utf8("history"), utf8("sync"), utf8("--server"), server, utf8("--remember")},
        {utf8("history"), utf8("sync"), utf8("--json"), utf8("--server"), server},
        {utf8("history"), utf8("--server"), server},
        {utf8("history"), utf8("sync"), server},
        {utf8("history"), utf8("sync"), utf8("--bench"), utf8("x"), utf8("--bench"), server}};
    for (const QStringList& command : commands) {
        const support::ProgramResult result = cli.run(command);
        QVERIFY(result.exit != 0);
        QVERIFY2(!(result.out + result.err).contains(utf8("swordfish")),
                 qPrintable(result.out + result.err));
    }
    if (server.contains(u'@'))
        QVERIFY(cli.run(commands.front()).err.contains(utf8("~/.pgpass")));
    QDirIterator files(cli.dataFolder(), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(!file.readAll().contains("swordfish"), qPrintable(file.fileName()));
    }
}

/// Typed into the file by hand: the window and the command refuse it.
void TestHistoryTls::aPasswordInTheSettingsIsNotUsed()
{
    support::CliProgram cli;
    const QString config = cli.dataFolder() + utf8("/config/servodesk");
    cli.setPort(QString());
    QVERIFY(QDir().mkpath(config));
    QFile settings(config + utf8("/servodesk.ini"));
    QVERIFY(settings.open(QIODevice::WriteOnly));
    settings.write("[General]\nversion=1\n\n[history]\nbench=Tor 3\n"
                   "server=postgresql://u:swordfish@127.0.0.1:1/db\n");
    settings.close();
    const support::ProgramResult refused = cli.run("history --server default");
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.err.contains(utf8("contains a password")) &&
                 refused.err.contains(utf8("~/.pgpass")) &&
                 !refused.err.contains(utf8("swordfish")),
             qPrintable(refused.err));
}

SERVODESK_GUILESS_TEST(TestHistoryTls)
#include "tst_history_tls.moc"
