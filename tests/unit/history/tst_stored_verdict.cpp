// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of sweep tests that an earlier version stored: in the history, in JSON files; and which
// runs can be a reference.
#include "history/history.h"
#include "history/history_file.h"
#include "results/sweep_json.h"
#include "results/sweep_verdict.h"
#include "support/test_main.h"
#include "unit/results/sweep_example.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using history::History;
using results::Grade;
using results::SweepEnd;
using results::SweepRun;
using namespace std::chrono_literals;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

/// One servo, all of whose lines passed, and how the run ended.
SweepRun runEndingWith(SweepEnd end, int endedBy = -1)
{
    SweepRun run = sweep_example::run();
    run.servos.resize(1);
    for (results::VerdictLine& line : run.servos[0].lines)
        line.grade = Grade::Pass;
    run.end = end;
    run.endedBy = endedBy;
    results::assignVerdicts(run);
    return run;
}
} // namespace

class TestStoredVerdict : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_dir;
    QString m_path;
    std::unique_ptr<History> open() { return History::open(m_path, 1s).value(); }
    /// What the earlier version had in its lists.
    void storeAsEarlierVersion(std::int64_t run, const char* verdict);

private Q_SLOTS:
    void init();

    void theEndDecides_data();
    void theEndDecides();
    void aFileOfAnEarlierVersionIsReevaluated();
    void aHistoryOfAnEarlierVersionIsReevaluated();
    void aLongSineIsStillRead();
    void listsUseTheEndOnly();
    void anUnfinishedRunIsNoReference();
};

void TestStoredVerdict::init()
{
    QTest::failOnWarning(QRegularExpression(text(".*")));
    m_dir = std::make_unique<QTemporaryDir>();
    m_path = m_dir->filePath(text("history.sqlite"));
}

void TestStoredVerdict::storeAsEarlierVersion(std::int64_t run, const char* verdict)
{
    const auto file = history::HistoryFile::open(m_path, 1s).value();
    QVERIFY(file->run(text("DELETE FROM about WHERE name = 'sweep-verdicts'")));
    QVERIFY(file->run(text("UPDATE run_servos SET verdict = ? WHERE run = ?"),
                      {text(verdict), qint64(run)}));
}

void TestStoredVerdict::theEndDecides_data()
{
    QTest::addColumn<int>("end");
    QTest::addColumn<int>("endedBy");
    QTest::addColumn<int>("verdict");
    const auto row = [](const char* name, SweepEnd end, int endedBy, Grade verdict) {
        QTest::newRow(name) << int(end) << endedBy << int(verdict);
    };
    row("finished", SweepEnd::Finished, -1, Grade::Pass);
    row("stopped", SweepEnd::Stopped, -1, Grade::NotMeasured);
    row("emergency", SweepEnd::Emergency, -1, Grade::NotMeasured);
    row("link lost", SweepEnd::LinkLost, -1, Grade::NotMeasured);
    row("link lost by it", SweepEnd::LinkLost, 5, Grade::NotMeasured);
    row("refused", SweepEnd::Refused, 5, Grade::NotMeasured);
    row("torque lost", SweepEnd::TorqueLost, 5, Grade::NotMeasured);
    row("exchanged", SweepEnd::ServoReplaced, 5, Grade::NotMeasured);
    row("its alarm", SweepEnd::Alarm, 5, Grade::Fail);
    row("another's alarm", SweepEnd::Alarm, 6, Grade::NotMeasured);
    row("its stall", SweepEnd::Stall, 5, Grade::Fail);
    row("another's stall", SweepEnd::Stall, 6, Grade::NotMeasured);
    row("its failure", SweepEnd::Failure, 5, Grade::Fail);
    row("another's failure", SweepEnd::Failure, 6, Grade::NotMeasured);
}

void TestStoredVerdict::theEndDecides()
{
    QFETCH(int, end);
    QFETCH(int, endedBy);
    QFETCH(int, verdict);
    SweepRun run = runEndingWith(SweepEnd(end), endedBy);
    QCOMPARE(int(run.servos[0].verdict), verdict);
    // What it failed by itself before stays failed; errors on the wire are nobody's.
    run.servos[0].lines.push_back(
        {{text("communication_errors"), QString(), {}, 0.0}, 7.0, Grade::Fail});
    results::assignVerdicts(run);
    const bool finished = SweepEnd(end) == SweepEnd::Finished;
    QCOMPARE(int(run.servos[0].verdict), finished ? int(Grade::Fail) : verdict);
    run.servos[0].lines.push_back({{text("overshoot"), text("%"), {}, 5.0}, 9.0, Grade::Fail});
    results::assignVerdicts(run);
    QCOMPARE(run.servos[0].verdict, Grade::Fail);
}

void TestStoredVerdict::aFileOfAnEarlierVersionIsReevaluated()
{
    QByteArray before = results::encodeSweepRun(runEndingWith(SweepEnd::Stopped));
    before.replace("\"verdict\": \"not-measured\"", "\"verdict\": \"pass\"");
    before.replace("      \"no_verdict\": \"ended\",\n", "");
    QVERIFY(before.contains("\"verdict\": \"pass\""));
    const auto read = results::decodeSweepRun(before);
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QCOMPARE(read->servos[0].verdict, Grade::NotMeasured);
    QCOMPARE(read->verdict(), Grade::NotMeasured);
    // A sine that nobody had looked at.
    SweepRun sine = runEndingWith(SweepEnd::Finished);
    sine.spec.shape = results::SweepShape::Sine;
    before = results::encodeSweepRun(sine);
    QVERIFY(before.contains("\"verdict\": \"pass\""));
    QCOMPARE(results::decodeSweepRun(before)->verdict(), Grade::NotMeasured);
}

void TestStoredVerdict::aHistoryOfAnEarlierVersionIsReevaluated()
{
    SweepRun stalled = sweep_example::run(); // of two servos one is to blame
    for (results::VerdictLine& line : stalled.servos[1].lines)
        line.grade = Grade::Pass;
    SweepRun sine = runEndingWith(SweepEnd::Finished);
    sine.spec.shape = results::SweepShape::Sine;
    std::vector<std::int64_t> numbers;
    for (const SweepRun& run :
         {runEndingWith(SweepEnd::Stopped), stalled, sine, runEndingWith(SweepEnd::Finished)})
        numbers.push_back(open()->add(run).value());
    for (const std::int64_t number : numbers)
        storeAsEarlierVersion(number, "pass");
    const auto history = open();
    const auto verdict = [&](std::size_t run, std::size_t servo = 0) {
        return history->run(numbers[run]).value().servos.at(servo).verdict;
    };
    QCOMPARE(verdict(0), Grade::NotMeasured);
    QCOMPARE(verdict(1, 0), Grade::NotMeasured);
    QCOMPARE(verdict(1, 1), Grade::Fail);
    QCOMPARE(verdict(2), Grade::NotMeasured);
    QCOMPARE(history->run(numbers[2]).value().verdict, Grade::NotMeasured);
    QCOMPARE(verdict(3), Grade::Pass);
    // And its copies get the same rows.
    const auto rows =
        history->file().run(text("SELECT verdict FROM run_servos ORDER BY run, place")).value();
    QStringList stored;
    for (const QVariantList& row : rows.rows)
        stored << row.front().toString();
    QCOMPARE(stored, QStringList({text("not-measured"), text("not-measured"), text("fail"),
                                  text("not-measured"), text("pass")}));
}

/// A night's sine fills several pieces; that of a stairs path is not read for its verdict.
void TestStoredVerdict::aLongSineIsStillRead()
{
    constexpr std::size_t night = 20'000; // legs
    SweepRun sine = runEndingWith(SweepEnd::Finished);
    sine.spec.shape = results::SweepShape::Sine;
    sine.servos[0].legs.resize(night);
    const auto number = open()->add(sine).value();
    {
        const auto history = open();
        const auto pieces = history->file().run(
            text("SELECT COUNT(*) FROM run_texts WHERE run = ?"), {qint64(number)});
        QVERIFY(pieces->rows.front().front().toInt() > 1);
    }
    storeAsEarlierVersion(number, "pass");
    QCOMPARE(open()->run(number).value().servos[0].verdict, Grade::NotMeasured);
}

/// Of a run that is too long to be read again for it, or that an older program adds afterwards.
void TestStoredVerdict::listsUseTheEndOnly()
{
    const auto number = open()->add(runEndingWith(SweepEnd::Stopped)).value();
    const auto history = open();
    QVERIFY(history->file().run(text("UPDATE run_servos SET verdict = 'pass'")));
    QCOMPARE(history->run(number).value().servos[0].verdict, Grade::NotMeasured);
    QCOMPARE(history->runs().value()[0].servos[0].verdict, Grade::NotMeasured);
}

void TestStoredVerdict::anUnfinishedRunIsNoReference()
{
    const auto history = open();
    const auto stopped = history->add(runEndingWith(SweepEnd::Stopped)).value();
    const auto good = history->add(runEndingWith(SweepEnd::Finished)).value();
    const auto refused = history->setReference(stopped, 5, true);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, base::ErrorCode::Refused);
    QCOMPARE(refused.error().detail, text("unfinished-reference"));
    QVERIFY(!history->run(stopped).value().servos[0].reference);
    QVERIFY(history->setReference(good, 5, true));
    QVERIFY(history->reference(text("STS3215")).value()->isUsable());
    // One that an earlier version had marked.
    QVERIFY(history->file().run(text("UPDATE run_servos SET reference = (run = ?)"),
                                {qint64(stopped)}));
    QVERIFY(!history->reference(text("STS3215")).value()->isUsable());
    QVERIFY(history->setReference(stopped, 5, false)); // the mark can be taken away
    QVERIFY(!history->reference(text("STS3215")).value());
    // A servo that failed is none either.
    QVERIFY(history->file().run(text("UPDATE run_servos SET verdict = 'fail' WHERE run = ?"),
                                {qint64(good)}));
    const auto failed = history->setReference(good, 5, true);
    QVERIFY(!failed);
    QCOMPARE(failed.error().detail, text("failed-reference"));
}

SERVODESK_GUILESS_TEST(TestStoredVerdict)
#include "tst_stored_verdict.moc"
