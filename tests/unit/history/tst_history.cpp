// SPDX-License-Identifier: GPL-3.0-or-later
// The history database: what was put in comes back, is found, marked and removed; two at a time
// lose nothing; whatever is wrong with the file, the run is not lost and the error says why.
#include "history/history.h"
#include "history/history_file.h"
#include "results/sweep_json.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/results/sweep_example.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <thread>

using base::ErrorCode;
using history::History;
using history::RunFilter;
using results::Grade;
using results::SweepRun;
using support::utf8;
using namespace std::chrono_literals;

namespace {
/// `daysLater`: than the example.
SweepRun runOf(const char* model, int id, int daysLater = 0)
{
    SweepRun run = sweep_example::finishedRun();
    run.spec.note.clear();
    run.servos.resize(1);
    run.servos[0].parameters.servo.model = utf8(model);
    run.servos[0].parameters.servo.id = id;
    run.at = run.at.addDays(daysLater);
    return run;
}

std::vector<std::int64_t> numbers(const History& history, const RunFilter& filter)
{
    std::vector<std::int64_t> found;
    const auto runs = history.runs(filter).value();
    for (const history::TestRun& run : runs)
        found.push_back(run.number);
    return found;
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

/// The one file beside the history.
SweepRun restTolerance(const QTemporaryDir& dir, const QString& path)
{
    [&] { QCOMPARE(QFileInfo(path).absolutePath(), QDir(dir.path()).absolutePath()); }();
    const auto run = results::loadSweepRun(path);
    return run ? *run : SweepRun();
}
} // namespace

class TestHistory : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<History> open()
    {
        auto history = History::open(m_path);
        return history ? std::move(*history) : nullptr;
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    QString m_path;

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(utf8(".*")));
        m_dir = std::make_unique<QTemporaryDir>();
        m_path = m_dir->filePath(utf8("sub/folder/history.sqlite"));
    }

    void runsRoundTrip();
    void aLongRunIsStoredInChunks();
    void runsAreFound();
    void labelsAndNotesBelongToTheRun();
    void oneReferenceAModel();
    void removedRunsAreGoneAndNumbersAreNotReused();
    void missingRunsAreReported();
    void twoWritersLoseNothing();
    void aFileOfANewerVersionIsNotChanged();
    void noDatabase_data();
    void noDatabase();
    void aDamagedDatabaseIsAnError();
    void aDatabaseWithOtherTablesIsAnError();
    void aDamagedRunIsAnError();
    void aLockedDatabaseDelaysButKeepsTheRun();
    void anInvalidFolder();
    void closedConnectionsLeaveNothing();
};

void TestHistory::runsRoundTrip()
{
    const SweepRun run = sweep_example::run();
    std::int64_t number = 0;
    {
        const auto history = open();
        QVERIFY(history);
        number = history->add(run, {utf8("/tmp/r.html"), utf8("/tmp/r.readings.csv")}).value();
    }
    const auto history = open();
    const history::TestRun head = history->run(number).value();
    QCOMPARE(head.number, number);
    QCOMPARE(head.kind, utf8("sweep"));
    QCOMPARE(head.at, run.at);
    QCOMPARE(head.program, run.program);
    QCOMPARE(head.port, run.port);
    QVERIFY(head.simulated);
    QCOMPARE(head.verdict, Grade::Fail);
    QCOMPARE(head.end, utf8("stall"));
    QCOMPARE(head.operatorName, sweep_example::hostileOperator);
    QCOMPARE(head.note, sweep_example::hostileNote);
    QCOMPARE(head.length, run.length);
    QCOMPARE(head.files, QStringList({utf8("/tmp/r.html"), utf8("/tmp/r.readings.csv")}));
    QCOMPARE(head.servos.size(), std::size_t(2));
    const history::TestServo first{5,
                                   utf8("STS3215"),
                                   utf8("sts-sms"),
                                   utf8("3.10"),
                                   Grade::NotMeasured,
                                   sweep_example::hostileLabel,
                                   false};
    QVERIFY(head.servos[0] == first);
    QCOMPARE(head.servos[1].verdict, Grade::Fail);
    QVERIFY(history->sweep(number).value() == run);
    QCOMPARE(history->text(number).value(), results::encodeSweepRun(run));
}

void TestHistory::aLongRunIsStoredInChunks()
{
    const SweepRun run = sweep_example::run(10000); // some MB of text
    const auto history = open();
    const std::int64_t number = history->add(run).value();
    QVERIFY(results::encodeSweepRun(run).size() > 3000000);
    QVERIFY(history->sweep(number).value() == run);
}

void TestHistory::runsAreFound()
{
    const auto history = open();
    SweepRun labeled = runOf("SCS15", 2, 2);
    labeled.servos[0].parameters.label = utf8("左膝 100%_x");
    labeled.spec.operatorName = utf8("Anna");
    const auto first = history->add(runOf("STS3215", 1, 1)).value();
    const auto second = history->add(labeled).value();
    const auto early = history->add(runOf("STS3215", 2, -1)).value();
    using Numbers = std::vector<std::int64_t>;
    QVERIFY(numbers(*history, {}) == (Numbers{second, first, early})); // newest first
    QVERIFY(numbers(*history, {.model = utf8("sts3215")}) == (Numbers{first, early}));
    QVERIFY(numbers(*history, {.id = 2}) == (Numbers{second, early}));
    QVERIFY(numbers(*history, {.model = utf8("STS3215"), .id = 2}) == Numbers{early});
    QVERIFY(numbers(*history, {.text = utf8("左膝")}) == Numbers{second});
    QVERIFY(numbers(*history, {.text = utf8("0%_X")}) == Numbers{second});
    QVERIFY(numbers(*history, {.text = utf8("0x_x")}).empty()); // no wildcards of SQL
    QVERIFY(numbers(*history, {.text = utf8("anna")}) == Numbers{second});
    QVERIFY(numbers(*history, {.text = utf8("'; DROP TABLE runs; --")}).empty());
    QVERIFY(numbers(*history, {.kind = utf8("step")}).empty());
    QVERIFY(numbers(*history, {.limit = 1}) == Numbers{second});
}

void TestHistory::labelsAndNotesBelongToTheRun()
{
    const auto history = open();
    const auto number = history->add(sweep_example::run()).value();
    QVERIFY(history->setLabel(number, 6, utf8("right \"knee\"")));
    QVERIFY(history->setNote(number, utf8("after repair")));
    const history::TestRun head = history->run(number).value();
    QCOMPARE(head.servos[0].label, sweep_example::hostileLabel);
    QCOMPARE(head.servos[1].label, utf8("right \"knee\""));
    QCOMPARE(head.note, utf8("after repair"));
    const SweepRun run = history->sweep(number).value(); // a report made of it says so too
    QCOMPARE(run.servos[1].parameters.label, utf8("right \"knee\""));
    QCOMPARE(run.spec.note, utf8("after repair"));
}

void TestHistory::oneReferenceAModel()
{
    const auto history = open();
    const auto a = history->add(runOf("STS3215", 1)).value();
    const auto b = history->add(runOf("STS3215", 7)).value();
    const auto other = history->add(runOf("SCS15", 1)).value();
    QVERIFY(!history->reference(utf8("STS3215")).value());
    QVERIFY(history->setReference(a, 1, true));
    QVERIFY(history->setReference(other, 1, true));
    QVERIFY(history->setReference(b, 7, true));
    const auto found = history->reference(utf8("STS3215")).value();
    QVERIFY(found);
    QCOMPARE(found->run.number, b);
    QCOMPARE(found->servo.id, 7);
    QVERIFY(!history->run(a).value().servos[0].reference);
    QCOMPARE(history->reference(utf8("SCS15")).value()->run.number, other);
    QVERIFY(history->setReference(b, 7, false));
    QVERIFY(!history->reference(utf8("STS3215")).value());
}

void TestHistory::removedRunsAreGoneAndNumbersAreNotReused()
{
    const auto history = open();
    const auto number = history->add(sweep_example::run(), {utf8("/tmp/x.csv")}).value();
    QVERIFY(history->remove(number));
    QVERIFY(!history->sweep(number));
    QVERIFY(history->runs().value().empty());
    QVERIFY(history->add(sweep_example::run()).value() > number);
    const auto file = history::HistoryFile::open(m_path, 1s).value();
    for (const char* table : {"run_servos", "run_texts", "run_files"}) {
        const auto answer =
            file->run(utf8("SELECT count(*) FROM %1 WHERE run = ?").arg(utf8(table)),
                      {qint64(number)})
                .value();
        QCOMPARE(answer.rows[0][0].toInt(), 0);
    }
}

void TestHistory::missingRunsAreReported()
{
    const auto history = open();
    const auto code = [](const auto& result) { return result.error().code; };
    QCOMPARE(code(history->run(77)), ErrorCode::BadArgument);
    QCOMPARE(code(history->sweep(77)), ErrorCode::BadArgument);
    QCOMPARE(code(history->text(77)), ErrorCode::BadArgument);
    QCOMPARE(code(history->remove(77)), ErrorCode::BadArgument);
    QCOMPARE(code(history->setNote(77, {})), ErrorCode::BadArgument);
    const auto number = history->add(runOf("STS3215", 1)).value();
    QVERIFY(history->setReference(number, 1, true));
    const auto none = history->setReference(number, 9, true); // no such servo in the run
    QCOMPARE(code(none), ErrorCode::BadArgument);
    QVERIFY(none.error().detail.contains(QString::number(number)));
    QVERIFY(history->reference(utf8("STS3215")).value()); // nothing of it was done
}

/// Each thread with a connection of its own, as two programs have.
void TestHistory::twoWritersLoseNothing()
{
    constexpr int each = 40;
    QVERIFY(open());
    QFile::remove(m_path); // both make it anew
    std::atomic<int> failures = 0;
    std::atomic<int> reads = 0;
    const auto work = [&](int id) {
        auto history = History::open(m_path, 60s);
        for (int i = 0; i < each && history; ++i) {
            const auto number = (*history)->add(runOf("STS3215", id, i));
            failures += !number || !(*history)->setLabel(*number, id, utf8("x"));
            reads +=
                (*history)->runs({.id = id}).value_or(std::vector<history::TestRun>()).size() ==
                std::size_t(i + 1);
        }
        failures += !history;
    };
    std::thread one(work, 1);
    std::thread two(work, 2);
    one.join();
    two.join();
    QCOMPARE(failures.load(), 0);
    QCOMPARE(reads.load(), 2 * each);
    const auto history = open();
    QCOMPARE(history->runs({.text = utf8("x")}).value().size(), std::size_t(2 * each));
    const auto mode =
        history::HistoryFile::open(m_path, 1s).value()->run(utf8("PRAGMA journal_mode")).value();
    QCOMPARE(mode.rows[0][0].toString(), utf8("wal"));
}

void TestHistory::aFileOfANewerVersionIsNotChanged()
{
    open()->add(sweep_example::run()).value();
    history::HistoryFile::open(m_path, 1s).value()->run(utf8("PRAGMA user_version = 4711")).value();
    const auto history = History::open(m_path);
    QVERIFY(!history);
    QCOMPARE(history.error().code, ErrorCode::FileFormat);
    QVERIFY2(history.error().detail.contains(utf8("newer version")),
             qPrintable(history.error().detail));
    QVERIFY(history.error().detail.startsWith(m_path));
    const auto kept = history::saveRun(m_path, sweep_example::run());
    QCOMPARE(kept.number, 0);
    QVERIFY(results::loadSweepRun(kept.file).value() == sweep_example::run());
}

void TestHistory::noDatabase_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("text") << QByteArray(5000, 'x');
    QTest::newRow("noise") << QByteArray::fromHex("53514c697465").repeated(900);
    QTest::newRow("zeros") << QByteArray(100000, '\0');
}

void TestHistory::noDatabase()
{
    QFETCH(QByteArray, bytes);
    m_path = m_dir->filePath(utf8("history.sqlite"));
    write(m_path, bytes);
    const auto kept = history::saveRun(m_path, sweep_example::run());
    QCOMPARE(kept.number, 0);
    QVERIFY(kept.trouble);
    QCOMPARE(kept.trouble->code, ErrorCode::FileFormat);
    QVERIFY(restTolerance(*m_dir, kept.file) == sweep_example::run());
    // The same again takes no name that is taken.
    const auto again = history::saveRun(m_path, sweep_example::run());
    QVERIFY(again.file != kept.file);
    QVERIFY(QFile::exists(kept.file) && QFile::exists(again.file));
    QFile file(m_path); // for whoever can mend it
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), bytes);
}

/// Every page but the first is overwritten, the schema's own among them.
void TestHistory::aDamagedDatabaseIsAnError()
{
    open()->add(sweep_example::run()).value();
    QFile file(m_path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    const qint64 first = 4096;
    QVERIFY(file.size() > 2 * first);
    file.seek(first);
    file.write(QByteArray(int(file.size() - first), '\x5a'));
    file.close();
    QCOMPARE(History::open(m_path).error().code, ErrorCode::FileFormat);
    const auto kept = history::saveRun(m_path, sweep_example::run());
    QCOMPARE(kept.trouble->code, ErrorCode::FileFormat);
    QVERIFY(results::loadSweepRun(kept.file).value() == sweep_example::run());
}

/// Not "read-only": no right to write would mend it.
void TestHistory::aDatabaseWithOtherTablesIsAnError()
{
    const auto history = open();
    history::HistoryFile::open(m_path, 1s)
        .value()
        ->run(utf8("ALTER TABLE runs RENAME COLUMN operator TO somebody"))
        .value();
    const auto runs = history->runs({});
    QVERIFY(!runs);
    QCOMPARE(runs.error().code, ErrorCode::FileFormat);
}

/// The pages of the runs' texts, which come last: the list is whole, the run cannot be read.
void TestHistory::aDamagedRunIsAnError()
{
    const auto number = open()->add(sweep_example::run(10000)).value();
    QFile file(m_path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    const qint64 last = 4 * 4096;
    file.seek(file.size() - last);
    file.write(QByteArray(int(last), '\x5a'));
    file.close();
    const auto history = open();
    QVERIFY(history);
    QCOMPARE(history->runs().value().size(), std::size_t(1));
    QCOMPARE(history->sweep(number).error().code, ErrorCode::FileFormat);
}

void TestHistory::aLockedDatabaseDelaysButKeepsTheRun()
{
    const auto before = open()->add(sweep_example::run()).value();
    const auto holder = history::HistoryFile::open(m_path, 1s).value();
    holder->run(utf8("BEGIN EXCLUSIVE")).value();
    const auto kept = history::saveRun(m_path, sweep_example::run(), {}, 50ms);
    QCOMPARE(kept.number, 0);
    QCOMPARE(kept.trouble->code, ErrorCode::FileUnwritable);
    QVERIFY2(kept.trouble->detail.contains(utf8("locked")), qPrintable(kept.trouble->detail));
    QVERIFY(results::loadSweepRun(kept.file).value() == sweep_example::run());
    QVERIFY(open()->sweep(before)); // reading goes on meanwhile
    holder->run(utf8("COMMIT")).value();
    QVERIFY(history::saveRun(m_path, sweep_example::run(), {}, 50ms).number > before);
}

void TestHistory::anInvalidFolder()
{
    write(m_dir->filePath(utf8("file")), "x");
    m_path = m_dir->filePath(utf8("file/history.sqlite"));
    const auto kept = history::saveRun(m_path, sweep_example::run());
    QCOMPARE(kept.trouble->code, ErrorCode::FileUnwritable);
    QVERIFY(kept.file.isEmpty()); // it says that there is none
    // A folder in the place of the file.
    m_path = m_dir->filePath(utf8("history.sqlite"));
    QVERIFY(QDir().mkpath(m_path));
    const auto beside = history::saveRun(m_path, sweep_example::run());
    QCOMPARE(beside.trouble->code, ErrorCode::FileUnwritable);
    QVERIFY(restTolerance(*m_dir, beside.file) == sweep_example::run());
}

void TestHistory::closedConnectionsLeaveNothing()
{
    {
        const auto one = open();
        const auto two = open();
        one->add(sweep_example::run()).value();
        QVERIFY(!History::open(m_dir->path()));
    }
    QVERIFY(!QFile::exists(m_path + utf8("-wal"))); // all of it is in the file
}

SERVODESK_GUILESS_TEST(TestHistory)
#include "tst_history.moc"
