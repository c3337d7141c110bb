// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of sweep tests that an earlier version stored: in the history, in JSON files; and which
// runs can be a reference.
#include "history/history.h"
#include "history/history_file.h"
#include "results/sweep_json.h"
#include "results/sweep_verdict.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/results/sweep_example.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using history::History;
using results::Grade;
using results::SweepEnd;
using results::SweepRun;
using support::utf8;
using namespace std::chrono_literals;

namespace {
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

private Q_SLOTS:
    void init();

    void theEndDecides_data();
    void theEndDecides();
    void aFileOfAnEarlierVersionIsReevaluated();
    void listsUseTheEndOnly();
    void anUnfinishedRunIsNoReference();
};

void TestStoredVerdict::init()
{
    QTest::failOnWarning(QRegularExpression(utf8(".*")));
    m_dir = std::make_unique<QTemporaryDir>();
    m_path = m_dir->filePath(utf8("history.sqlite"));
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
        {{utf8("communication_errors"), QString(), {}, 0.0}, 7.0, Grade::Fail});
    results::assignVerdicts(run);
    const bool finished = SweepEnd(end) == SweepEnd::Finished;
    QCOMPARE(int(run.servos[0].verdict), finished ? int(Grade::Fail) : verdict);
    run.servos[0].lines.push_back({{utf8("overshoot"), utf8("%"), {}, 5.0}, 9.0, Grade::Fail});
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

/// Of a run that is too long to be read again for it, or that an older program adds afterwards.
void TestStoredVerdict::listsUseTheEndOnly()
{
    const auto number = open()->add(runEndingWith(SweepEnd::Stopped)).value();
    const auto history = open();
    QVERIFY(history->file().run(utf8("UPDATE run_servos SET verdict = 'pass'")));
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
    QCOMPARE(refused.error().detail, utf8("unfinished-reference"));
    QVERIFY(!history->run(stopped).value().servos[0].reference);
    QVERIFY(history->setReference(good, 5, true));
    QVERIFY(history->reference(utf8("STS3215")).value()->isUsable());
    // One that stands in the database all the same.
    QVERIFY(history->file().run(utf8("UPDATE run_servos SET reference = (run = ?)"),
                                {qint64(stopped)}));
    QVERIFY(!history->reference(utf8("STS3215")).value()->isUsable());
    QVERIFY(history->setReference(stopped, 5, false)); // the mark can be taken away
    QVERIFY(!history->reference(utf8("STS3215")).value());
    // A servo that failed is none either.
    QVERIFY(history->file().run(utf8("UPDATE run_servos SET verdict = 'fail' WHERE run = ?"),
                                {qint64(good)}));
    const auto failed = history->setReference(good, 5, true);
    QVERIFY(!failed);
    QCOMPARE(failed.error().detail, utf8("failed-reference"));
}

SERVODESK_GUILESS_TEST(TestStoredVerdict)
#include "tst_stored_verdict.moc"
