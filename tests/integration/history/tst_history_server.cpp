// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of the history on a real PostgreSQL server: what a bench has kept is there, once, whatever
// happens to bench, line or server in between, and is browsed as on the bench itself. The server is
// the test's own; without one installed (packaging/test-packages.txt) there is nothing to test.
#include "history/server/history_server.h"
#include "history/server/history_server_schema.h"
#include "session/history/history_uploader.h"
#include "support/history_example.h"
#include "support/history_server_fixture.h"
#include "support/test_main.h"
#include "support/text.h"
#include "text/error_text.h"

#include <QtTest>

#include <thread>

using base::ErrorCode;
using history::History;
using history::HistoryServer;
using history_example::Bench;
using history_example::everything;
using session::HistoryUploader;
using support::utf8;

namespace {
/// Which kind of trouble a detail names.
QString kindOf(const base::Error& error)
{
    return error.detail.left(error.detail.indexOf(u':'));
}
} // namespace

class TestHistoryServer : public QObject, private support::HistoryServerFixture {
    Q_OBJECT

private:
    std::int64_t send(const Bench& bench, const char* name = "Bench 1")
    {
        HistoryUploader sending(bench.path, address(), utf8(name));
        const auto sent = sending.send();
        if (!sent)
            qCritical("%s", qPrintable(sent.error().detail));
        return sent ? sent->sent : -1;
    }

    const HistoryServer& serverOf(const History& history)
    {
        return dynamic_cast<const HistoryServer&>(history.file());
    }

    QString asked(const QString& sql) { return m_pg.query(m_database, sql); }

private Q_SLOTS:
    void initTestCase() { startServer(); }
    void init()
    {
        QTest::failOnWarning(QRegularExpression(utf8(".*")));
        newDatabase();
    }

    void everythingIsCopied();
    void noColumnIsOmitted();
    void laterChangesFollow();
    void deletionsAreCopiedToo();
    void sendingAgainChangesNothing();
    void filtersMatchTheLocalHistory_data();
    void filtersMatchTheLocalHistory();
    void pagesAreTheSame();
    void benchesAreDistinguished();
    void benchesStartingTogether();
    void twoProgramsOfOneBench();
    void aRestoredBackup();
    void aCopiedFileHidesNothing();
    void killedInTheMiddle();
    void anyTextSurvives();
    void copiesAreReadOnly();
    void errorsAreReported_data();
    void errorsAreReported();
    void aNewerSchemaIsNotChanged();
    void anotherEncodingIsRefused();
    void missingPermissionsAreReported();
    void emptyServer();
};

void TestHistoryServer::everythingIsCopied()
{
    Bench bench;
    history_example::fill(bench);
    QVERIFY(send(bench) > 0);
    const auto local = bench.open();
    const auto copy = browse();
    QVERIFY(!everything(*local).isEmpty());
    QCOMPARE(everything(*copy), everything(*local));
    const auto run = copy->sweep(copy->runs().value().front().number);
    QVERIFY(run.has_value());
    QCOMPARE(run->servos.size(), sweep_example::run().servos.size());
    QCOMPARE(asked(utf8("SELECT content FROM servodesk.facts")), utf8("[\"1\",\"-2\"]"));
}

/// Whatever the history learns to keep, its copies keep as well.
void TestHistoryServer::noColumnIsOmitted()
{
    Bench bench;
    history_example::fill(bench);
    QVERIFY(send(bench) > 0);
    const auto local = bench.open();
    const auto columnsHere = [&](const QString& table) {
        QStringList names;
        const auto info = local->file().run(utf8("PRAGMA table_info(%1)").arg(table)).value();
        for (const QVariantList& row : info.rows)
            names.append(row.value(1).toString());
        names.removeAll(utf8("revision"));
        names.sort();
        return names;
    };
    const auto columnsThere = [&](const QString& table) {
        QStringList names = asked(utf8("SELECT column_name FROM information_schema.columns WHERE "
                                       "table_schema = 'servodesk' AND table_name = '%1'")
                                      .arg(table))
                                .split(u'\n');
        names.removeAll(utf8("bench"));
        names.sort();
        return names;
    };
    for (const history::ServerTable& table : history::serverTables()) {
        const QString name = utf8(table.name);
        QCOMPARE(columnsThere(name), columnsHere(name));
        QStringList sent = table.columns;
        sent << utf8("number") << utf8("uuid");
        if (table.ofServo)
            sent << utf8("servo");
        sent.sort();
        QCOMPARE(sent, columnsHere(name));
        for (const auto& child : table.children) {
            QCOMPARE(columnsThere(utf8(child.name)), columnsHere(utf8(child.name)));
            QStringList below = child.columns;
            below << utf8(child.parent);
            if (child.ofServo)
                below << utf8("servo");
            below.sort();
            QStringList here = columnsHere(utf8(child.name));
            here.removeAll(utf8("number"));
            QCOMPARE(below, here);
        }
    }
}

void TestHistoryServer::laterChangesFollow()
{
    Bench bench;
    history_example::fill(bench);
    const QString open = history_example::write(bench.journal, 5, 9, "");
    QVERIFY(send(bench) > 0);
    QVERIFY(bench.journal.end(open, {utf8("done"), {}}).has_value());
    const auto local = bench.open();
    const auto servos = local->log().servos().value();
    QVERIFY(local->log().setLabel(servos.front().number, utf8("左膝 'L'")).has_value());
    const auto snapshots = local->log().snapshots().value();
    QVERIFY(local->log()
                .setSnapshotNote(snapshots.front().number, utf8("label"), utf8("note"))
                .has_value());
    const auto runs = local->runs().value();
    QVERIFY(local->setNote(runs.front().number, utf8("bearing changed")).has_value());
    QVERIFY(local->setLabel(runs.front().number, 5, utf8("knee")).has_value());
    QVERIFY(local->setReference(runs.front().number, 5, true).has_value());
    history_example::write(bench.journal, 6, 10);
    QVERIFY(send(bench) > 0);
    const auto copy = browse();
    QCOMPARE(everything(*copy), everything(*local));
    QVERIFY(copy->reference(utf8("STS3215")).value().has_value());
}

void TestHistoryServer::deletionsAreCopiedToo()
{
    Bench bench;
    history_example::fill(bench);
    QVERIFY(send(bench) > 0);
    const auto local = bench.open();
    const auto remove = [&] {
        QVERIFY(local->remove(local->runs().value().front().number).has_value());
        const auto log = local->log();
        QVERIFY(log.removeSnapshot(log.snapshots().value().front().number).has_value());
        QVERIFY(log.removeRecording(log.recordings().value().front().number).has_value());
    };
    remove();
    QCOMPARE(send(bench), std::int64_t(3));
    QCOMPARE(everything(*browse()), everything(*local));
    QCOMPARE(asked(utf8("SELECT count(*) FROM servodesk.run_texts")), utf8("0"));
}

void TestHistoryServer::sendingAgainChangesNothing()
{
    Bench bench;
    history_example::fill(bench);
    QVERIFY(send(bench) > 0);
    const QStringList before = everything(*browse());
    const QString numbers = asked(utf8("SELECT sum(number) FROM servodesk.writes"));
    QCOMPARE(send(bench), std::int64_t(0));
    asked(utf8("UPDATE servodesk.progress SET revision = 0"));
    QVERIFY(send(bench) > 0);
    QCOMPARE(everything(*browse()), before);
    QCOMPARE(asked(utf8("SELECT sum(number) FROM servodesk.writes")), numbers);
}

void TestHistoryServer::filtersMatchTheLocalHistory_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("label");
    QTest::addColumn<QString>("key");
    QTest::addColumn<bool>("trouble");
    QTest::addColumn<bool>("early");
    QTest::newRow("all") << -1 << ""
                         << ""
                         << "" << false << false;
    QTest::newRow("id") << 2 << ""
                        << ""
                        << "" << false << false;
    QTest::newRow("nobody's id") << 200 << ""
                                 << ""
                                 << "" << false << false;
    QTest::newRow("model, whatever the case") << -1 << "sts3215"
                                              << ""
                                              << "" << false << false;
    QTest::newRow("label") << -1 << ""
                           << "Knie ß"
                           << "" << false << false;
    QTest::newRow("key") << -1 << ""
                         << ""
                         << "max_angle" << false << false;
    QTest::newRow("alarm") << -1 << ""
                           << ""
                           << "voltage" << false << false;
    QTest::newRow("trouble") << -1 << ""
                             << ""
                             << "" << true << false;
    QTest::newRow("trouble of one") << 2 << "STS3215"
                                    << ""
                                    << "max_angle" << true << false;
    QTest::newRow("time") << -1 << ""
                          << ""
                          << "" << false << true;
}

void TestHistoryServer::filtersMatchTheLocalHistory()
{
    QFETCH(int, id);
    QFETCH(QString, model);
    QFETCH(QString, label);
    QFETCH(QString, key);
    QFETCH(bool, trouble);
    QFETCH(bool, early);
    Bench bench;
    history_example::fill(bench);
    const auto local = bench.open();
    const auto first = local->log().of(history_example::servo(1)).value();
    QVERIFY(local->log().setLabel(first->number, utf8("Knie ß")).has_value());
    QVERIFY(send(bench) > 0);
    const auto copy = browse();

    history::HistoryFilter filter;
    history::RunFilter runs;
    if (id >= 0)
        runs.id = filter.id = id;
    runs.model = filter.model = model;
    filter.label = label;
    runs.text = label;
    filter.key = key;
    filter.onlyProblems = trouble;
    if (early)
        runs.until = filter.until = QDateTime({2026, 5, 2}, {9, 0, 1}, Qt::UTC);
    QCOMPARE(history_example::servos(*copy, filter), history_example::servos(*local, filter));
    QCOMPARE(history_example::writes(*copy, filter), history_example::writes(*local, filter));
    QCOMPARE(copy->log().countWrites(filter).value(), local->log().countWrites(filter).value());
    QCOMPARE(history_example::snapshots(*copy, filter), history_example::snapshots(*local, filter));
    QCOMPARE(history_example::alarms(*copy, filter), history_example::alarms(*local, filter));
    QCOMPARE(history_example::recordings(*copy, filter),
             history_example::recordings(*local, filter));
    QCOMPARE(history_example::runs(*copy, runs), history_example::runs(*local, runs));
    filter.reason = history::SnapshotReason::Manual;
    QCOMPARE(history_example::snapshots(*copy, filter), history_example::snapshots(*local, filter));
    for (const char* words : {"O'NEILL", "knee", "100%", "sts_215", "TTY", "磨损", "\\"}) {
        runs.text = utf8(words);
        QCOMPARE(history_example::runs(*copy, runs), history_example::runs(*local, runs));
    }
}

void TestHistoryServer::pagesAreTheSame()
{
    Bench bench;
    for (int i = 0; i < 12; ++i)
        history_example::write(bench.journal, 1 + i % 2, i);
    QVERIFY(send(bench) > 0);
    const auto copy = browse();
    history::HistoryFilter filter;
    filter.limit = 5;
    QStringList seen;
    for (;;) {
        const auto page = copy->log().writes(filter).value();
        if (page.empty())
            break;
        seen += history_example::writes(*copy, filter);
        filter.after = history::PageCursor{page.back().at, page.back().number};
    }
    QCOMPARE(seen, history_example::writes(*bench.open()));
}

void TestHistoryServer::benchesAreDistinguished()
{
    Bench one;
    Bench two;
    history_example::fill(one);
    history_example::fill(two);
    history_example::write(two.journal, 9, 1);
    QVERIFY(send(one, "Werkbank A") > 0);
    QVERIFY(send(two, "bench B") > 0);
    const auto copy = browse();
    const HistoryServer& server = serverOf(*copy);
    const auto benches = server.benches().value();
    QCOMPARE(benches.size(), std::size_t(2));
    QCOMPARE(benches[0].name, utf8("bench B"));
    QCOMPARE(benches[1].name, utf8("Werkbank A"));
    QCOMPARE(benches[0].writes, benches[1].writes + 2);
    QVERIFY(benches[0].sent.secsTo(QDateTime::currentDateTimeUtc()) < 3600);

    const qsizetype all = history_example::writes(*copy).size();
    QVERIFY(server.selectBench(benches[1].number).has_value());
    QCOMPARE(everything(*copy), everything(*one.open()));
    QVERIFY(server.selectBench(benches[0].number).has_value());
    QCOMPARE(everything(*copy), everything(*two.open()));
    QVERIFY(server.selectBench(std::nullopt).has_value());
    QCOMPARE(history_example::writes(*copy).size(), all);
    QCOMPARE(all, history_example::writes(*one.open()).size() +
                      history_example::writes(*two.open()).size());

    history::HistoryFilter nine;
    nine.id = 9;
    const std::int64_t number = copy->log().writes(nine).value().front().number;
    QCOMPARE(server.benchNames(utf8("writes"), {number}).value().value(number), utf8("bench B"));

    QCOMPARE(send(two, "Bench B, by the window"), std::int64_t(0)); // a new name alone
    QCOMPARE(server.benchNames(utf8("writes"), {number}).value().value(number),
             utf8("Bench B, by the window"));
}

void TestHistoryServer::benchesStartingTogether()
{
    constexpr int many = 5;
    std::vector<std::unique_ptr<Bench>> benches;
    for (int i = 0; i < many; ++i) {
        benches.push_back(std::make_unique<Bench>());
        history_example::fill(*benches.back());
    }
    std::vector<std::thread> threads;
    std::atomic<int> good{0};
    for (int i = 0; i < many; ++i)
        threads.emplace_back([&, i] {
            HistoryUploader sending(benches[std::size_t(i)]->path, address(), QString::number(i));
            good += sending.send().has_value() ? 1 : 0;
        });
    for (std::thread& thread : threads)
        thread.join();
    QCOMPARE(good.load(), many);
    const auto copy = browse();
    QCOMPARE(int(serverOf(*copy).benches().value().size()), many);
    QCOMPARE(history_example::writes(*copy).size(),
             many * history_example::writes(*benches[0]->open()).size());
}

void TestHistoryServer::twoProgramsOfOneBench()
{
    Bench bench;
    history_example::fill(bench);
    for (int i = 0; i < 300; ++i)
        history_example::write(bench.journal, 1, i);
    std::vector<std::thread> threads;
    std::atomic<int> good{0};
    for (int i = 0; i < 3; ++i)
        threads.emplace_back([&] {
            HistoryUploader sending(bench.path, address(), utf8("Bench"));
            good += sending.send().has_value() ? 1 : 0;
        });
    for (std::thread& thread : threads)
        thread.join();
    QCOMPARE(good.load(), 3);
    QCOMPARE(everything(*browse()), everything(*bench.open()));
}

void TestHistoryServer::aRestoredBackup()
{
    Bench bench;
    history_example::fill(bench);
    bench.open(); // closing the last connection leaves one file
    const QString backup = bench.folder.filePath(utf8("backup"));
    {
        const auto history = bench.open();
        QVERIFY(history->file().run(utf8("VACUUM INTO ?"), {backup}).has_value());
    }
    for (int i = 0; i < 10; ++i)
        history_example::write(bench.journal, 1, 1000 + i);
    QVERIFY(send(bench) > 0);
    Bench restored;
    QVERIFY(QFile::remove(bench.path));
    for (const char* rest : {"-wal", "-shm"})
        QFile::remove(bench.path + utf8(rest));
    QVERIFY(QFile::copy(backup, bench.path));
    history::HistoryJournal journal(bench.path, utf8("ServoDesk"));
    const QString later = history_example::write(journal, 4, 4711);
    QVERIFY(send(bench) > 0);
    QCOMPARE(asked(utf8("SELECT count(*) FROM servodesk.intents WHERE uuid = '%1'").arg(later)),
             utf8("1"));
    // What the file has forgotten the server still knows.
    QCOMPARE(asked(utf8("SELECT count(*) FROM servodesk.writes WHERE new BETWEEN 1000 AND 1009 "
                        "AND \"key\" = 'min_angle'")),
             utf8("10"));
}

void TestHistoryServer::aCopiedFileHidesNothing()
{
    Bench bench;
    history_example::fill(bench);
    Bench twin;
    {
        const auto history = bench.open();
        QVERIFY(history->file().run(utf8("VACUUM INTO ?"), {twin.path}).has_value());
    }
    const QString first = history_example::write(bench.journal, 1, 1);
    QVERIFY(send(bench) > 0);
    const QString second = history_example::write(twin.journal, 1, 2);
    QVERIFY(send(twin) > 0);
    for (const QString& uuid : {first, second})
        QCOMPARE(asked(utf8("SELECT count(*) FROM servodesk.intents WHERE uuid = '%1'").arg(uuid)),
                 utf8("1"));
}

void TestHistoryServer::killedInTheMiddle()
{
    Bench bench;
    history_example::fill(bench);
    {
        const auto history = bench.open();
        const history::HistoryChanges changes(history->file());
        const auto rows = changes.after(0).value();
        auto server = history::connectHistoryServer(address(), HistoryServer::Purpose::Send);
        QVERIFY(server.has_value());
        history::HistoryServerWriter copy(
            **server, {changes.bench().value(), utf8("here"), utf8("Bench"), utf8("test")});
        QCOMPARE(copy.registerBench().value(), std::int64_t(0));
        const auto done = (*server)->transaction([&]() -> base::Result<void> {
            const auto added =
                (*server)->run(utf8("INSERT INTO servos (uuid, bench) SELECT 'half', "
                                    "number FROM benches"));
            m_pg.kill();
            const auto next = copy.apply(rows, 0, rows.back().revision);
            return next ? base::Result<void>() : tl::unexpected(next.error());
        });
        QVERIFY(!done);
        QCOMPARE(kindOf(done.error()), utf8("away"));
    }
    HistoryUploader sending(bench.path, address(), utf8("Bench"));
    const auto refused = sending.send();
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::LinkLost);
    QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
    QVERIFY(sending.send().has_value());
    QCOMPARE(everything(*browse()), everything(*bench.open()));

    history_example::write(bench.journal, 1, 5);
    QVERIFY(sending.send().has_value()); // on a connection that is kept …
    m_pg.stop();
    QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
    history_example::write(bench.journal, 1, 6);
    QVERIFY(sending.send().has_value()); // … and cut behind its back
    QCOMPARE(everything(*browse()), everything(*bench.open()));
}

void TestHistoryServer::anyTextSurvives()
{
    Bench bench;
    history_example::write(bench.journal, 1, 1);
    const auto local = bench.open();
    const std::int64_t servo = local->log().servos().value().front().number;
    QVERIFY(send(bench) > 0);
    for (const char* words : {"'; DROP SCHEMA servodesk CASCADE; --", "a\\b\\'c", "?", "$1 %1",
                              "\"quoted\"", "🦾 磨损", "two\nlines\ttab"}) {
        QVERIFY(local->log().setLabel(servo, utf8(words)).has_value());
        QCOMPARE(send(bench, words), std::int64_t(1));
        const auto copy = browse();
        QCOMPARE(copy->log().servos().value().front().label, utf8(words));
        QCOMPARE(serverOf(*copy).benches().value().front().name, utf8(words));
        history::HistoryFilter filter;
        filter.label = utf8(words);
        QCOMPARE(history_example::writes(*copy, filter).size(), qsizetype(2));
    }
}

void TestHistoryServer::copiesAreReadOnly()
{
    Bench bench;
    history_example::fill(bench);
    QVERIFY(send(bench) > 0);
    const auto copy = browse();
    const auto servo = copy->log().servos().value().front();
    const auto done = copy->log().setLabel(servo.number, utf8("mine"));
    QVERIFY(!done);
    QCOMPARE(kindOf(done.error()), utf8("rights"));
    QVERIFY(!copy->remove(copy->runs().value().front().number));
    QCOMPARE(everything(*copy), everything(*bench.open()));
}

void TestHistoryServer::errorsAreReported_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("kind");
    const QString port = QString::number(m_pg.port());
    QTest::newRow("wrong password")
        << m_pg.address(utf8("postgres"), utf8("postgres"), utf8("secret99")) << "password";
    QTest::newRow("a password in it")
        << "host=127.0.0.1 port=" + port + " user=postgres password=secret99 dbname=postgres"
        << "secret";
    QTest::newRow("no password") << "postgresql://postgres@127.0.0.1:" + port +
                                        "/postgres?passfile=/nowhere"
                                 << "password";
    QTest::newRow("unknown user") << m_pg.address(utf8("postgres"), utf8("nobody"),
                                                  utf8("secret99"))
                                  << "password";
    QTest::newRow("no such database") << m_pg.address(utf8("no such shop")) << "database";
    QTest::newRow("nobody there") << "host=127.0.0.1 port=1 user=postgres"
                                  << "away";
    QTest::newRow("no such host") << "host=no.such.host.invalid"
                                  << "away";
    QTest::newRow("encryption") << m_pg.address(utf8("postgres")) + " sslmode=require"
                                << "tls";
    QTest::newRow("an option nobody knows") << m_pg.address(utf8("postgres")) + " colour=red"
                                            << "parameter";
    QTest::newRow("an option with nonsense") << m_pg.address(utf8("postgres")) + " sslmode=perhaps"
                                             << "string";
    QTest::newRow("no words") << "secret99"
                              << "string";
    QTest::newRow("an open quote") << "host=127.0.0.1 password='secret99"
                                   << "string";
    QTest::newRow("another scheme") << "mysql://root:secret99@host/db"
                                    << "string";
}

void TestHistoryServer::errorsAreReported()
{
    QFETCH(QString, address);
    QFETCH(QString, kind);
    Bench bench;
    history_example::fill(bench);
    HistoryUploader sending(bench.path, address, utf8("Bench"));
    const auto sent = sending.send();
    QVERIFY(!sent);
    QCOMPARE(kindOf(sent.error()), kind);
    const text::Description words = text::describe(sent.error());
    const QString all = words.message + words.cause + words.remedy + sent.error().detail;
    QVERIFY2(!all.contains(utf8("secret99")), qPrintable(all));
    QVERIFY(words.message.contains(utf8("server")) || kind == utf8("string") ||
            kind == utf8("secret") || kind == utf8("parameter"));
}

void TestHistoryServer::aNewerSchemaIsNotChanged()
{
    Bench bench;
    history_example::fill(bench);
    QVERIFY(send(bench) > 0);
    asked(utf8("UPDATE servodesk.about SET version = 99"));
    history_example::write(bench.journal, 1, 1);
    HistoryUploader sending(bench.path, address(), utf8("Bench"));
    const auto sent = sending.send();
    QVERIFY(!sent);
    QCOMPARE(kindOf(sent.error()), utf8("newer"));
    QCOMPARE(sent.error().code, ErrorCode::FileFormat);
    const auto seen = history::connectHistoryServer(address(), HistoryServer::Purpose::Browse);
    QVERIFY(!seen);
    QCOMPARE(kindOf(seen.error()), utf8("newer"));
    asked(utf8("UPDATE servodesk.about SET version = 1"));
    QVERIFY(sending.send().has_value());
    QCOMPARE(everything(*browse()), everything(*bench.open()));
}

void TestHistoryServer::anotherEncodingIsRefused()
{
    m_pg.query(utf8("postgres"),
               utf8("CREATE DATABASE latin ENCODING 'LATIN1' TEMPLATE template0"));
    Bench bench;
    history_example::fill(bench);
    HistoryUploader sending(bench.path, m_pg.address(utf8("latin")), utf8("Bench"));
    const auto sent = sending.send();
    QVERIFY(!sent);
    QCOMPARE(kindOf(sent.error()), utf8("encoding"));
}

void TestHistoryServer::missingPermissionsAreReported()
{
    Bench bench;
    history_example::fill(bench);
    asked(utf8("CREATE ROLE reader LOGIN PASSWORD 'reads it'"));
    const QString reader = m_pg.address(m_database, utf8("reader"), utf8("reads it"));
    HistoryUploader sending(bench.path, reader, utf8("Bench"));
    const auto none = sending.send();
    QVERIFY(!none);
    QCOMPARE(kindOf(none.error()), utf8("rights"));

    // Who was given the right to read can browse, and no more.
    QVERIFY(send(bench) > 0);
    asked(utf8("GRANT USAGE ON SCHEMA servodesk, servodesk_bench TO reader; "
               "GRANT SELECT ON ALL TABLES IN SCHEMA servodesk, servodesk_bench TO reader"));
    auto server = history::connectHistoryServer(reader, HistoryServer::Purpose::Browse);
    QVERIFY(server.has_value());
    const std::int64_t number = (*server)->benches().value().front().number;
    QVERIFY((*server)->selectBench(number).has_value());
    const History copy(std::move(*server));
    QCOMPARE(everything(copy), everything(*bench.open()));
    const auto still = sending.send();
    QVERIFY(!still);
    QCOMPARE(kindOf(still.error()), utf8("rights"));
}

void TestHistoryServer::emptyServer()
{
    const auto server = history::connectHistoryServer(address(), HistoryServer::Purpose::Browse);
    QVERIFY(!server);
    QCOMPARE(kindOf(server.error()), utf8("empty"));
    // A bench that has kept nothing yet has nothing to send, and is no trouble.
    Bench bench;
    HistoryUploader sending(bench.path, address(), utf8("Bench"));
    QCOMPARE(sending.send().value().sent, std::int64_t(0));
    HistoryUploader unreachable(Bench().path, utf8("host=127.0.0.1 port=1 user=u dbname=d"),
                                utf8("Bench"));
    const auto away = unreachable.send();
    QVERIFY(!away);
    QCOMPARE(kindOf(away.error()), utf8("away"));
}

SERVODESK_GUILESS_TEST(TestHistoryServer)
#include "tst_history_server.moc"
