// SPDX-License-Identifier: GPL-3.0-or-later
// The history behind the window: answers come to the main thread, in order; what was to be kept is
// kept even if the program ends at once; whoever has gone is told nothing.
#include "history/history_change_detector.h"
#include "results/sweep_json.h"
#include "session/history/history_service.h"
#include "support/history_example.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using session::HistoryService;
using session::SharedRun;
using support::utf8;

namespace {
SharedRun example(int day = 0)
{
    auto run = std::make_shared<results::SweepRun>(sweep_example::finishedRun());
    run->at = run->at.addDays(day);
    return run;
}

/// What was handed to its thread before is done.
bool isDone(HistoryService& historyService, QObject* receiver)
{
    bool done = false;
    historyService.runInOrder([]() -> base::Result<void> { return {}; }, receiver,
                              [&](const base::Result<void>&) { done = true; });
    return support::waitFor([&] { return done; });
}
} // namespace

class TestHistoryService : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_dir;
    QString m_path;

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(utf8(".*")));
        m_dir = std::make_unique<QTemporaryDir>();
        m_path = m_dir->filePath(utf8("history.sqlite"));
    }

    void savedRunsAreListedAndLoaded();
    void shutdownLosesNothing();
    void deletedReceiversAreNotNotified();
    void changesAreSignaled();
    void aRunIsComparedWithItsReference();
    void anUnusableHistoryIsReportedWithTheRunsPath();
    void backgroundWorkRepliesToo();
    void aViewerIsNotifiedOfOtherWriters();
    void aReplacedFileIsDetected();
    void theDetectorSignalsOncePerChange();
};

void TestHistoryService::savedRunsAreListedAndLoaded()
{
    HistoryService historyService(m_path);
    QSignalSpy kept(&historyService, &HistoryService::runSaved);
    QSignalSpy changed(&historyService, &HistoryService::changed);
    historyService.saveRun(example(), {utf8("/tmp/x.html")});
    historyService.saveRun(example(1));
    std::vector<history::TestRun> runs;
    QThread* where = nullptr;
    historyService.list({}, this, [&](const base::Result<std::vector<history::TestRun>>& answer) {
        runs = answer.value();
        where = QThread::currentThread();
    });
    QVERIFY(kept.isEmpty()); // nothing waits, so nothing is there yet
    QTRY_COMPARE(runs.size(), std::size_t(2));
    QCOMPARE(where, thread());
    QCOMPARE(kept.size(), 2);
    QCOMPARE(changed.size(), 2);
    QCOMPARE(kept[0][0].toLongLong(), 1);
    QCOMPARE(runs[1].files, QStringList(utf8("/tmp/x.html")));
    SharedRun loaded;
    historyService.load(1, this,
                        [&](const base::Result<SharedRun>& answer) { loaded = answer.value(); });
    QTRY_VERIFY(loaded);
    QVERIFY(*loaded == *example());
    std::optional<base::Error> error;
    historyService.load(99, this,
                        [&](const base::Result<SharedRun>& answer) { error = answer.error(); });
    QTRY_VERIFY(error);
}

void TestHistoryService::shutdownLosesNothing()
{
    constexpr int many = 12;
    {
        HistoryService historyService(m_path);
        for (int i = 0; i < many; ++i)
            historyService.saveRun(example(i));
    }
    const auto history = history::History::open(m_path).value();
    QCOMPARE(history->runs().value().size(), std::size_t(many));
}

void TestHistoryService::deletedReceiversAreNotNotified()
{
    HistoryService historyService(m_path);
    bool signaled = false;
    auto gone = std::make_unique<QObject>();
    historyService.list({}, gone.get(), [&](const auto&) { signaled = true; });
    gone.reset();
    bool after = false;
    historyService.list({}, this, [&](const auto&) { after = true; });
    QTRY_VERIFY(after);
    QVERIFY(!signaled);
}

void TestHistoryService::changesAreSignaled()
{
    HistoryService historyService(m_path);
    QSignalSpy changed(&historyService, &HistoryService::changed);
    QSignalSpy failed(&historyService, &HistoryService::failed);
    historyService.saveRun(example());
    historyService.setLabel(1, 5, utf8("left"));
    historyService.setNote(1, utf8("new"));
    historyService.setReference(1, 5, true);
    QTRY_COMPARE(changed.size(), 4);
    std::vector<history::TestRun> runs;
    const auto take = [&](const base::Result<std::vector<history::TestRun>>& answer) {
        runs = answer.value();
    };
    historyService.list({}, this, take);
    QTRY_COMPARE(runs.size(), std::size_t(1));
    QCOMPARE(runs[0].servos[0].label, utf8("left"));
    QCOMPARE(runs[0].note, utf8("new"));
    QVERIFY(runs[0].servos[0].reference);
    historyService.remove({1});
    QTRY_COMPARE(changed.size(), 5);
    QVERIFY(failed.isEmpty());
    historyService.remove({1});
    QTRY_COMPARE(failed.size(), 1);
    QCOMPARE(changed.size(), 5);
}

void TestHistoryService::aRunIsComparedWithItsReference()
{
    HistoryService historyService(m_path);
    historyService.saveRun(example());
    std::optional<std::vector<session::ReferenceResult>> results;
    const auto take = [&](const base::Result<std::vector<session::ReferenceResult>>& answer) {
        results = answer.value();
    };
    historyService.compareWithReference(example(1), this, take);
    QTRY_VERIFY(results);
    QVERIFY(results->empty()); // there is none
    results.reset();
    historyService.setReference(1, 5, true);
    auto worse = std::make_shared<results::SweepRun>(*example(1));
    worse->servos[0].metrics[4].value = *worse->servos[0].metrics[4].value + 5;
    historyService.compareWithReference(worse, this, take);
    QTRY_VERIFY(results);
    QCOMPARE(results->size(), std::size_t(1)); // of the two servos one model has a reference
    QCOMPARE(results->front().servo, 5);
    QCOMPARE(results->front().run.number, 1);
    QCOMPARE(results->front().comparison.figures[4].difference.value(), 5.0);
    QVERIFY(results->front().comparison.figures[4].better == results::Better::A);
    results.reset();
    historyService.compareWithReference(example(), this, take); // the reference itself
    QTRY_VERIFY(results);
    QVERIFY(results->empty());
}

void TestHistoryService::anUnusableHistoryIsReportedWithTheRunsPath()
{
    QVERIFY(QDir().mkpath(m_path));
    HistoryService historyService(m_path);
    QSignalSpy failed(&historyService, &HistoryService::runSaveFailed);
    historyService.saveRun(example());
    QTRY_COMPARE(failed.size(), 1);
    QCOMPARE(failed[0][0].value<base::Error>().code, base::ErrorCode::FileUnwritable);
    QVERIFY(results::loadSweepRun(failed[0][1].toString()).value() == *example());
}

void TestHistoryService::backgroundWorkRepliesToo()
{
    HistoryService historyService(m_path);
    std::optional<base::ErrorCode> code;
    bool fine = false;
    historyService.runInOrder(
        []() -> base::Result<void> { return base::fail(base::ErrorCode::DiskFull); }, this,
        [&](const base::Result<void>& done) { code = done.error().code; });
    historyService.runInOrder([]() -> base::Result<void> { return {}; }, this,
                              [&](const base::Result<void>& done) { fine = bool(done); });
    QTRY_VERIFY(fine);
    QCOMPARE(code, base::ErrorCode::DiskFull);
}

void TestHistoryService::aViewerIsNotifiedOfOtherWriters()
{
    HistoryService historyService(m_path);
    QSignalSpy changed(&historyService, &HistoryService::changed);
    auto viewer = std::make_unique<QObject>();
    historyService.setWatched(viewer.get(), true); // there is no history yet
    QVERIFY(isDone(historyService, this));         // it begins to watch on its thread
    history::HistoryJournal other(m_path, utf8("servodesk-cli"));
    history_example::write(other, 1, 1);
    QTRY_VERIFY(!changed.isEmpty());
    // What comes from now on is told each time.
    for (int i = 0; i < 3; ++i) {
        changed.clear();
        history_example::write(other, 1, i);
        QTRY_VERIFY(!changed.isEmpty());
    }
    viewer.reset(); // one that went without a word is none
    historyService.setWatched(this, true);
    QVERIFY(isDone(historyService, this));
    changed.clear();
    history_example::write(other, 1, 9);
    QTRY_VERIFY(!changed.isEmpty());
    historyService.setWatched(this, false);
}

void TestHistoryService::aReplacedFileIsDetected()
{
    {
        history::HistoryJournal old(m_path, utf8("servodesk-cli"));
        history_example::write(old, 1, 1);
    }
    HistoryService historyService(m_path);
    QSignalSpy changed(&historyService, &HistoryService::changed);
    historyService.setWatched(this, true);
    QVERIFY(isDone(historyService, this));
    {
        history::HistoryJournal other(m_path, utf8("servodesk-cli"));
        history_example::write(other, 1, 2);
    }
    QTRY_VERIFY(!changed.isEmpty());
    const history_example::Bench another;
    QVERIFY(another.open());
    changed.clear();
    for (const char* part : {"", "-wal", "-shm"})
        QFile::remove(m_path + utf8(part));
    QVERIFY(QFile::copy(another.path, m_path));
    QTRY_VERIFY(!changed.isEmpty());
    historyService.setWatched(this, false);
}

void TestHistoryService::theDetectorSignalsOncePerChange()
{
    history::HistoryChangeDetector detector(m_path);
    QVERIFY(!detector.hasChanged());
    QVERIFY(!QFile::exists(m_path)); // asking makes no file
    history::HistoryJournal other(m_path, utf8("servodesk-cli"));
    history_example::write(other, 1, 1);
    QVERIFY(detector.hasChanged());
    QVERIFY(!detector.hasChanged());
    history_example::write(other, 1, 2);
    QVERIFY(detector.hasChanged());
    detector.close();
    history_example::write(other, 1, 3);
    QVERIFY(!detector.hasChanged()); // a beginning tells nothing
}

SERVODESK_GUILESS_TEST(TestHistoryService)
#include "tst_history_service.moc"
