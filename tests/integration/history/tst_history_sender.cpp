// SPDX-License-Identifier: GPL-3.0-or-later
// Sending copies while the program runs, against a real PostgreSQL server that is away, comes, goes
// and hangs: what was missed arrives later, servo writes and the end of the program wait for
// nobody, and browsing says what is wrong. Without PostgreSQL installed there is nothing to test.
#include "device/writer.h"
#include "session/history/history_sender.h"
#include "session/history/history_server_choice.h"
#include "session/history/history_server_source.h"
#include "session/history/history_service.h"
#include "support/cli_program.h"
#include "support/history_example.h"
#include "support/history_sender_times.h"
#include "support/history_server_fixture.h"
#include "support/silent_server.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QJsonArray>
#include <QtTest>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

using history::History;
using history::HistoryServer;
using history_example::Bench;
using history_example::everything;
using session::HistorySender;
using support::serverErrorKind;
using support::shortSenderTimes;
using support::utf8;
using Phase = session::SendState::Phase;
using namespace std::chrono_literals;

class TestHistorySender : public QObject, private support::HistoryServerFixture {
    Q_OBJECT

private:
    void verifyCopied(const Bench& bench)
    {
        QCOMPARE(everything(*browse()), everything(*bench.open()));
    }
    /// Its folder goes with the test object: a thread left behind closes the history in its own
    /// time, and both would delete the same files.
    Bench& newBench() { return *m_benches.emplace_back(std::make_unique<Bench>()); }

    std::vector<std::unique_ptr<Bench>> m_benches;

private Q_SLOTS:
    void initTestCase() { startServer(); }
    void init()
    {
        QTest::failOnWarning(QRegularExpression(utf8(".*")));
        newDatabase();
    }

    void disabledUntilAServerIsSet();
    void newEntriesAreSent();
    void changesOfOtherProgramsAreSentToo();
    void serverComesUpLater();
    void aRestartedServerMissesNothing();
    void aHungServerIsAnError();
    void servoWritesDoNotWait();
    void shutdownDoesNotWait_data();
    void shutdownDoesNotWait();
    void switchingServersMidway();
    void theWindowBrowses();
    void browsingAHungServer();
    void theServerIsRemembered();
    void anUnreachableServerIsNotSaved();
    void theCommandLineSendsAndBrowses();
};

void TestHistorySender::disabledUntilAServerIsSet()
{
    Bench& bench = newBench();
    history_example::fill(bench);
    HistorySender sender(bench.path, shortSenderTimes());
    sender.notifyChanged();
    QCOMPARE(int(sender.state().phase), int(Phase::Off));
    QVERIFY(sender.state().server.isEmpty());
}

void TestHistorySender::newEntriesAreSent()
{
    Bench& bench = newBench();
    history_example::fill(bench);
    HistorySender::Timing slowTimes = shortSenderTimes();
    slowTimes.checkInterval = 1h;
    HistorySender sender(bench.path, slowTimes);
    QList<Phase> phases;
    connect(&sender, &HistorySender::stateChanged, this,
            [&] { phases.append(sender.state().phase); });
    sender.setServer(address(), utf8("Bench 1"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    QVERIFY(phases.contains(Phase::Sending));
    QVERIFY(sender.state().upToDate.isValid());
    QCOMPARE(sender.state().pending, std::optional<std::int64_t>(0));
    QCOMPARE(sender.state().server,
             utf8("postgres@127.0.0.1:%1/%2").arg(m_pg.port()).arg(m_database));
    verifyCopied(bench);

    history_example::write(bench.journal, 4, 1);
    sender.notifyChanged();
    QCOMPARE(int(sender.state().phase), int(Phase::Waiting));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
}

void TestHistorySender::changesOfOtherProgramsAreSentToo()
{
    Bench& bench = newBench();
    HistorySender sender(bench.path, shortSenderTimes());
    sender.setServer(address(), utf8("Bench 1"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    history_example::write(bench.journal, 4, 1); // nobody pokes
    const QString count = utf8("SELECT count(*) FROM servodesk.writes");
    QTRY_COMPARE(m_pg.query(m_database, count), utf8("2"));
}

void TestHistorySender::serverComesUpLater()
{
    Bench& bench = newBench();
    history_example::fill(bench);
    m_pg.stop();
    {
        HistorySender sender(bench.path, shortSenderTimes());
        sender.setServer(address(), utf8("Bench 1"));
        QTRY_COMPARE(int(sender.state().phase), int(Phase::Failed));
        QCOMPARE(serverErrorKind(*sender.state().error), utf8("away"));
        QVERIFY(sender.state().nextTry.isValid());
        QVERIFY(!sender.state().pending);
        QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
        QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
        QVERIFY(!sender.state().error);
        verifyCopied(bench);
    }
    // Missed by a program that has ended, sent by the next one.
    m_pg.stop();
    {
        HistorySender sender(bench.path, shortSenderTimes());
        sender.setServer(address(), utf8("Bench 1"));
        history_example::write(bench.journal, 1, 99);
        sender.notifyChanged();
        QTRY_COMPARE(int(sender.state().phase), int(Phase::Failed));
    }
    QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
    HistorySender sender(bench.path, shortSenderTimes());
    sender.setServer(address(), utf8("Bench 1"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
}

void TestHistorySender::aRestartedServerMissesNothing()
{
    Bench& bench = newBench();
    HistorySender sender(bench.path, shortSenderTimes());
    sender.setServer(address(), utf8("Bench 1"));
    for (int round = 0; round < 3; ++round) {
        for (int i = 0; i < 40; ++i)
            history_example::write(bench.journal, 1 + i % 3, i);
        sender.notifyChanged();
        m_pg.kill();
        history_example::write(bench.journal, 1, round);
        sender.notifyChanged(); // all before may have been sent while the server ended
        QTRY_COMPARE(int(sender.state().phase), int(Phase::Failed));
        QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
        QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    }
    QTRY_COMPARE(everything(*browse()), everything(*bench.open()));
}

void TestHistorySender::aHungServerIsAnError()
{
    Bench& bench = newBench();
    history_example::fill(bench);
    HistorySender sender(bench.path, shortSenderTimes(200ms));
    sender.setServer(address(), utf8("Bench 1"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    m_pg.suspend();
    history_example::write(bench.journal, 1, 1);
    QTRY_COMPARE(int(sender.state().phase), int(Phase::Failed));
    QCOMPARE(serverErrorKind(*sender.state().error), utf8("hung"));
    QCOMPARE(sender.state().pending, std::optional<std::int64_t>(1));
    m_pg.resume();
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
}

/// Safe writes to a servo, journalled in the very file that is to be copied, on a thread of their
/// own as in the program: while the server hangs they are as many in the same time as without one.
void TestHistorySender::servoWritesDoNotWait()
{
    Bench& bench = newBench();
    history_example::write(bench.journal, 2, 1); // something to send from the beginning
    const support::SilentServer silent;
    HistorySender sender(bench.path, shortSenderTimes(200ms));
    sender.setServer(silent.address(), utf8("Bench 1"));
    QCOMPARE(int(sender.state().phase), int(Phase::Waiting));
    support::SimFixture wire(utf8("sts3215@1"));
    const device::Context own = wire.context();
    const device::Context context{own.bus, own.catalog, bench.journal, own.stop, own.notices};
    device::Servo servo = wire.servo(1);
    for (int i = 0; i < 50; ++i) {
        const auto report =
            device::write(context, servo, {{utf8("max_temperature"), 50 + i % 20}}, {});
        QVERIFY(report.has_value());
        QVERIFY(report->isSuccessful());
        sender.notifyChanged();
        QCoreApplication::processEvents();
        QVERIFY(sender.state().phase != Phase::UpToDate);
    }
    QCOMPARE(wire.raw(1, utf8("max_temperature")), std::int64_t(59));
    // The server has not said a word yet, and everything is done and written down.
    QCOMPARE(history_example::writes(*bench.open()).size(), qsizetype(52));
    QVERIFY(bench.journal.open().value().empty());
    QTRY_COMPARE(int(sender.state().phase), int(Phase::Failed));
    QCOMPARE(serverErrorKind(*sender.state().error), utf8("hung"));
    sender.setServer(address(), utf8("Bench 1"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
}

void TestHistorySender::shutdownDoesNotWait_data()
{
    QTest::addColumn<bool>("connecting");
    QTest::newRow("while connecting") << true;
    QTest::newRow("in a transaction") << false;
}

/// The server never answers: that this test ends at all is what it is about.
void TestHistorySender::shutdownDoesNotWait()
{
    QFETCH(bool, connecting);
    Bench& bench = newBench();
    history_example::fill(bench);
    const support::SilentServer silent;
    HistorySender::Timing times = shortSenderTimes(200ms);
    times.silence = 24h;
    auto sender = std::make_unique<HistorySender>(bench.path, times);
    if (connecting) {
        sender->setServer(silent.address() + utf8(" connect_timeout=100000"), utf8("Bench 1"));
        QTRY_VERIFY(silent.isAsked());
    } else {
        sender->setServer(address(), utf8("Bench 1"));
        QTRY_COMPARE(int(sender->state().phase), int(Phase::UpToDate));
        m_pg.suspend();
        history_example::write(bench.journal, 1, 1);
        QTRY_COMPARE(int(sender->state().phase), int(Phase::Sending));
    }
    sender.reset();
    m_pg.resume();
}

void TestHistorySender::switchingServersMidway()
{
    Bench& bench = newBench();
    history_example::fill(bench);
    const support::SilentServer silent;
    HistorySender sender(bench.path, shortSenderTimes(200ms));
    sender.setServer(silent.address(), utf8("Bench 1"));
    sender.setServer(address(), utf8("Bench 1"));
    QTRY_COMPARE(int(sender.state().phase), int(Phase::UpToDate));
    verifyCopied(bench);
    sender.setServer(QString(), QString());
    QCOMPARE(int(sender.state().phase), int(Phase::Off));
}

void TestHistorySender::theWindowBrowses()
{
    Bench one;
    Bench two;
    history_example::fill(one);
    history_example::write(two.journal, 9, 1);
    for (const Bench* bench : {&one, &two}) {
        session::HistoryUploader sending(bench->path, address(),
                                         bench == &one ? utf8("A") : utf8("B"));
        QVERIFY(sending.send().has_value());
    }
    session::HistoryService historyService(
        std::make_unique<session::HistoryServerSource>(address()));
    std::optional<std::vector<history::HistoryBench>> benches;
    historyService.benches(this, [&](const auto& found) { benches = found.value(); });
    QTRY_VERIFY(benches.has_value());
    QCOMPARE(benches->size(), std::size_t(2));

    std::optional<std::int64_t> count;
    historyService.countWrites({}, this, [&](const auto& found) { count = found.value(); });
    QTRY_COMPARE(count, std::optional<std::int64_t>(16));
    historyService.selectBench(benches->at(1).number);
    historyService.countWrites({}, this, [&](const auto& found) { count = found.value(); });
    QTRY_COMPARE(count, std::optional<std::int64_t>(2));
    historyService.selectBench(benches->at(0).number);

    session::SharedSnapshot snapshot;
    historyService.snapshots({}, this, [&](const auto& found) {
        historyService.loadSnapshot(found.value().front().number, this,
                                    [&](const auto& loaded) { snapshot = loaded.value(); });
    });
    QTRY_VERIFY(snapshot != nullptr);
    const auto log = one.open();
    QCOMPARE(*snapshot, log->log().snapshot(log->log().snapshots().value().front().number).value());
    session::SharedRun run;
    historyService.list({}, this, [&](const auto& found) {
        historyService.load(found.value().front().number, this,
                            [&](const auto& loaded) { run = loaded.value(); });
    });
    QTRY_VERIFY(run != nullptr);
    QCOMPARE(run->servos.size(), sweep_example::run().servos.size());

    QSignalSpy failed(&historyService, &session::HistoryService::failed);
    historyService.setNote(1, utf8("mine"));
    QTRY_COMPARE(failed.count(), 1);

    // Gone and back again: said, and then forgotten.
    m_pg.stop();
    std::optional<base::Error> trouble;
    historyService.countWrites({}, this, [&](const auto& found) { trouble = found.error(); });
    QTRY_VERIFY(trouble.has_value());
    QCOMPARE(serverErrorKind(*trouble), utf8("away"));
    QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
    count.reset();
    historyService.countWrites({}, this, [&](const auto& found) { count = found.value(); });
    QTRY_COMPARE(count, std::optional<std::int64_t>(14));
}

void TestHistorySender::browsingAHungServer()
{
    Bench& bench = newBench();
    history_example::fill(bench);
    session::HistoryUploader sending(bench.path, address(), utf8("A"));
    QVERIFY(sending.send().has_value());
    auto historyService = std::make_unique<session::HistoryService>(
        std::make_unique<session::HistoryServerSource>(address(), 200ms));
    std::optional<std::int64_t> count;
    historyService->countWrites({}, this, [&](const auto& found) { count = found.value(); });
    QTRY_VERIFY(count.has_value());
    m_pg.suspend();
    std::optional<base::Error> trouble;
    historyService->countWrites({}, this, [&](const auto& found) { trouble = found.error(); });
    QTRY_VERIFY(trouble.has_value());
    QCOMPARE(serverErrorKind(*trouble), utf8("hung"));
    historyService->countWrites({}, this, [](const auto&) { QFAIL("nobody is there any more"); });
    historyService.reset();
    m_pg.resume();
}

void TestHistorySender::theServerIsRemembered()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(utf8("settings.ini"));
    {
        session::Settings settings(path);
        const auto none = session::historyServerChoice(settings);
        QVERIFY(none.address.isEmpty());
        QVERIFY(!none.bench.isEmpty());
        session::setHistoryServerChoice(settings,
                                        {utf8("postgresql://shop/history"), utf8("Tor 3")});
    }
    const session::Settings settings(path);
    QCOMPARE(session::historyServerChoice(settings).address, utf8("postgresql://shop/history"));
    QCOMPARE(session::historyServerChoice(settings).bench, utf8("Tor 3"));
    qputenv("SERVODESK_HISTORY_SERVER", "host=elsewhere");
    const auto overridden = session::historyServerChoice(settings);
    qunsetenv("SERVODESK_HISTORY_SERVER");
    QCOMPARE(overridden.address, utf8("host=elsewhere"));
    QVERIFY(overridden.isFixedByEnvironment);
    QVERIFY(!session::historyServerChoice(settings).isFixedByEnvironment);
}

/// An empty history says nothing about the server, and only one that was reached is stored.
void TestHistorySender::anUnreachableServerIsNotSaved()
{
    support::CliProgram cli;
    cli.setPort(QString());
    const QStringList sync{utf8("history"), utf8("sync"), utf8("--remember"), utf8("--server")};
    const support::ProgramResult away =
        cli.run(sync + QStringList{utf8("postgresql://u@127.0.0.1:1/db")});
    QCOMPARE(away.exit, 3);
    QVERIFY2(away.err.contains(utf8("were not saved")), qPrintable(away.err));
    for (const char* server : {"bogus=1", "host=127.0.0.1 oauth_client_secret=swordfish",
                               "host=127.0.0.1 options=-cpassword=swordfish"}) {
        const support::ProgramResult refused = cli.run(sync + QStringList{utf8(server)});
        QCOMPARE(refused.exit, 2);
        QVERIFY(!(refused.out + refused.err).contains(utf8("swordfish")));
    }
    QCOMPARE(cli.run("history sync").exit, 2); // no server is set
    const support::ProgramResult reached = cli.run(sync + QStringList{address()});
    QVERIFY2(reached.exit == 0, qPrintable(reached.err));
    QVERIFY2(reached.out.contains(utf8("Server and bench name saved")), qPrintable(reached.out));
    QCOMPARE(cli.run("history sync").exit, 0);
}

void TestHistorySender::theCommandLineSendsAndBrowses()
{
    support::CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    QCOMPARE(cli.run("write 1 max_temperature=61").exit, 0);
    cli.setPort(QString());
    QCOMPARE(cli.run("history sync").exit, 2); // no server is set
    const QString server = address();
    const QStringList sync{utf8("history"), utf8("sync"),    utf8("--json"), utf8("--server"),
                           server,          utf8("--bench"), utf8("Tor 3"),  utf8("--remember")};
    const support::ProgramResult sent = cli.run(sync);
    QVERIFY2(sent.exit == 0, qPrintable(sent.err));
    QVERIFY(sent.json().value(utf8("sent")).toInt() > 0);
    QVERIFY(!(sent.out + sent.err).contains(m_pg.superuserPassword()));
    const support::ProgramResult again =
        cli.run("history sync --json"); // server and name are remembered
    QCOMPARE(again.json().value(utf8("sent")).toInt(-1), 0);
    QCOMPARE(again.json().value(utf8("bench")).toString(), utf8("Tor 3"));

    const support::ProgramResult local = cli.run("history --json");
    const support::ProgramResult copy = cli.run("history --json --server default");
    QVERIFY2(copy.exit == 0, qPrintable(copy.err));
    const auto keysOf = [](const support::ProgramResult& result) {
        QStringList keys;
        for (const QJsonValue row : result.json().value(utf8("writes")).toArray())
            keys << row.toObject().value(utf8("register")).toString() +
                        row.toObject().value(utf8("new")).toVariant().toString();
        return keys;
    };
    QCOMPARE(keysOf(copy), keysOf(local));
    QVERIFY(!keysOf(copy).isEmpty());
    const support::ProgramResult benches = cli.run("history --kind benches --server default");
    QVERIFY2(benches.out.contains(utf8("Tor 3")), qPrintable(benches.out + benches.err));
    const support::ProgramResult unknownBench = cli.run("history --bench nobody");
    QCOMPARE(unknownBench.exit, 2);
    QVERIFY2(unknownBench.err.contains(utf8("Tor 3")), qPrintable(unknownBench.err));
    const QString file = cli.dataFolder() + utf8("/out.servo.json");
    const support::ProgramResult taken = cli.run(
        {utf8("history"), utf8("snapshot"), utf8("1"), file, utf8("--server"), utf8("default")});
    QVERIFY2(taken.exit == 0, qPrintable(taken.err));
    QVERIFY(snapshot::loadSnapshot(file).has_value());

    m_pg.stop();
    const support::ProgramResult away = cli.run("history sync");
    QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
    QCOMPARE(away.exit, 3);
    QVERIFY2(away.err.contains(utf8("history server")), qPrintable(away.err));
    QVERIFY(!away.err.contains(utf8("recover"))); // no servo is concerned
}

SERVODESK_GUILESS_TEST(TestHistorySender)
#include "tst_history_sender.moc"
