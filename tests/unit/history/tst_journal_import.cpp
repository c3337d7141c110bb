// SPDX-License-Identifier: GPL-3.0-or-later
// What the file journal of earlier versions held is in the history afterwards, once: whoever starts
// first, whatever crashes, and though an old program writes on. The file is renamed, never deleted.
#include "history/history.h"
#include "history/history_journal.h"
#include "history/journal_import.h"
#include "support/file_size_limit.h"
#include "support/test_main.h"
#include "unit/history/intent_example.h"
#include "unit/history/legacy_journal.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <sys/stat.h>

using base::ErrorCode;
using base::Intent;
using history::HistoryJournal;
using intent_example::exampleIntent;
using intent_example::exampleServo;
using support::LegacyJournal;
using namespace std::chrono_literals;

namespace {
const QString program = QStringLiteral("servodesk test");
const QString limits = QStringLiteral("limits");

/// Waits for the others however slow the machine is.
int openAll(const QString& path)
{
    const HistoryJournal journal(path, program, 20s);
    return journal.entries() ? 0 : 1;
}
} // namespace

class TestJournalImport : public QObject {
    Q_OBJECT

private:
    QStringList files(const char* pattern) const
    {
        return QDir(m_folder->path()).entryList({QString::fromLatin1(pattern)}, QDir::AllEntries);
    }
    std::vector<base::JournalEntry> entries() const
    {
        return HistoryJournal(m_path, program).entries().value();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QString m_old;

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_path = m_folder->filePath(QStringLiteral("history.sqlite"));
        m_old = m_folder->filePath(QStringLiteral("journal.jsonl"));
    }

    void everythingIsImportedOnce()
    {
        LegacyJournal old(m_old);
        const QString done = old.begin(exampleIntent(1));
        old.end(done, QStringLiteral("done"), QStringLiteral("all kept"));
        const QString open = old.begin(exampleIntent(2));
        old.keep(exampleServo(), limits, {100, 4000});
        old.keep(exampleServo(), limits, {-5, 3000});
        QFile file(m_old);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();

        for (int start = 0; start < 3; ++start) {
            const HistoryJournal journal(m_path, program);
            const auto all = journal.entries().value();
            QCOMPARE(all.size(), std::size_t(2));
            QCOMPARE(all[0].intent.uuid, done);
            intent_example::compareIntents(all[0].intent, exampleIntent(1));
            QCOMPARE(all[0].end.value().outcome, QStringLiteral("done"));
            QCOMPARE(all[0].end.value().detail, QStringLiteral("all kept"));
            QCOMPARE(all[1].intent.uuid, open);
            QCOMPARE(journal.open().value().size(), std::size_t(1));
            const std::vector<std::int64_t> latest{-5, 3000};
            QCOMPARE(journal.servoValues(exampleServo(), limits).value(), latest);
        }
        QVERIFY(!QFile::exists(m_old));
        QCOMPARE(files("journal.jsonl*"), QStringList{QStringLiteral("journal.jsonl.taken-1")});
        QFile renamedFile(m_old + QStringLiteral(".taken-1"));
        QVERIFY(renamedFile.open(QIODevice::ReadOnly));
        QCOMPARE(renamedFile.readAll(), before);
    }

    /// The outcome of each register is not known then; that of the whole is.
    void oldWritesAreListed()
    {
        LegacyJournal old(m_old);
        old.end(old.begin(exampleIntent(1)), QStringLiteral("done"));
        old.end(old.begin(exampleIntent(1)), QStringLiteral("failed"));
        const auto history = history::History::open(m_path).value();
        const auto writes = history->log().writes().value();
        QCOMPARE(writes.size(), std::size_t(4));
        QCOMPARE(writes[0].outcome, QStringLiteral("failed"));
        QCOMPARE(writes[3].outcome, QStringLiteral("done"));
        history::HistoryFilter trouble;
        trouble.onlyProblems = true;
        QCOMPARE(history->log().writes(trouble).value().size(), std::size_t(2));
    }

    void anOldProgramKeepsWriting()
    {
        LegacyJournal old(m_old);
        const QString first = old.begin(exampleIntent(1));
        QCOMPARE(entries().size(), std::size_t(1));
        // To a new file, as it opens one for each line; its intent is known already.
        old.end(first, QStringLiteral("undone"));
        old.begin(exampleIntent(2));
        const auto all = entries();
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0].end.value().outcome, QStringLiteral("undone"));
        QVERIFY(!all[1].end);
        QCOMPARE(files("journal.jsonl*").size(), qsizetype(2));
    }

    /// Who had opened the file before it was renamed still appends to it.
    void entriesInARenamedFileAreImportedToo()
    {
        LegacyJournal(m_old).begin(exampleIntent(1));
        QCOMPARE(entries().size(), std::size_t(1));
        LegacyJournal(m_old + QStringLiteral(".taken-1")).begin(exampleIntent(2));
        QCOMPARE(entries().size(), std::size_t(2));
        QCOMPARE(entries().size(), std::size_t(2));
    }

    /// What this program has settled meanwhile is not unsettled by an older line.
    void theLaterEntryWins()
    {
        LegacyJournal old(m_old);
        const QString uuid = old.begin(exampleIntent(1));
        old.end(uuid, QStringLiteral("failed"));
        old.keep(exampleServo(), limits, {1, 2});
        QFile file(m_old);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        const qint64 then = QDateTime::currentMSecsSinceEpoch();
        QTRY_VERIFY(QDateTime::currentMSecsSinceEpoch() > then);
        {
            HistoryJournal journal(m_path, program);
            QVERIFY(journal.end(uuid, {QStringLiteral("undone"), {}}));
            QVERIFY(journal.saveServoValues(exampleServo(), limits, {3, 4}));
        }
        // The same lines once more, from a copy that is another file to the program.
        QFile copy(m_old);
        QVERIFY(copy.open(QIODevice::WriteOnly));
        copy.write("\n" + text);
        copy.close();
        const HistoryJournal journal(m_path, program);
        QCOMPARE(journal.entries().value().size(), std::size_t(1));
        QCOMPARE(journal.entries().value()[0].end.value().outcome, QStringLiteral("undone"));
        const std::vector<std::int64_t> latest{3, 4};
        QCOMPARE(journal.servoValues(exampleServo(), limits).value(), latest);
    }

    void concurrentProgramsImportOnce()
    {
        LegacyJournal old(m_old);
        for (int i = 0; i < 200; ++i)
            old.end(old.begin(exampleIntent(i)), QStringLiteral("done"));
        std::vector<std::unique_ptr<QProcess>> programs;
        for (int i = 0; i < 4; ++i) {
            programs.push_back(std::make_unique<QProcess>());
            programs.back()->start(
                QCoreApplication::applicationFilePath(),
                {QStringLiteral("tst_journal_import"), QStringLiteral("open"), m_path});
        }
        for (const auto& one : programs) {
            QVERIFY(one->waitForFinished());
            QCOMPARE(one->exitCode(), 0);
        }
        QCOMPARE(entries().size(), std::size_t(200));
        QCOMPARE(files("journal.jsonl*").size(), qsizetype(1));
        const auto history = history::History::open(m_path).value();
        QCOMPARE(history->log().countWrites().value(), 400);
    }

    /// Killed somewhere on the way, again and again: nothing half, and in the end all of it.
    void aKillDuringImportChangesNothing()
    {
        LegacyJournal old(m_old);
        for (int i = 0; i < 300; ++i)
            old.begin(exampleIntent(i));
        for (int round = 0; round < 12; ++round) {
            QProcess other;
            other.start(QCoreApplication::applicationFilePath(),
                        {QStringLiteral("tst_journal_import"), QStringLiteral("open"), m_path});
            QVERIFY(other.waitForStarted());
            (void)other.waitForFinished(round * 7); // sooner or later
            other.kill();
            (void)other.waitForFinished();
            const bool stillThere = QFile::exists(m_old);
            QCOMPARE(files("journal.jsonl*").size(), qsizetype(1));
            if (!stillThere)
                break;
        }
        QCOMPARE(entries().size(), std::size_t(300));
        QCOMPARE(files("journal.jsonl*").size(), qsizetype(1));
    }

    void aFullDiskLeavesTheOldFile()
    {
        LegacyJournal old(m_old);
        for (int i = 0; i < 100; ++i)
            old.begin(exampleIntent(i));
        (void)history::HistoryFile::open(m_path, 5s).value();
        {
            const FileSizeLimit limit(8192);
            HistoryJournal journal(m_path, program);
            QVERIFY(!journal.begin(exampleIntent()));
            QVERIFY(!journal.open());
        }
        QVERIFY(QFile::exists(m_old));
        QCOMPARE(entries().size(), std::size_t(100));
        QVERIFY(!QFile::exists(m_old));
    }

    void aTornLastLineIsNotLost()
    {
        LegacyJournal old(m_old);
        old.begin(exampleIntent(1));
        QFile file(m_old);
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QByteArray line = file.readAll();
        file.write(line.left(50)); // the power went
        file.close();
        QCOMPARE(entries().size(), std::size_t(1));
        QFile renamedFile(m_old + QStringLiteral(".taken-1"));
        QVERIFY(renamedFile.open(QIODevice::ReadOnly));
        QCOMPARE(renamedFile.readAll(), line + line.left(50));
    }

    void uselessLinesAreCounted_data()
    {
        QTest::addColumn<QByteArray>("line");
        const QByteArray servo =
            R"("servo":{"id":1,"model_major":9,"model_minor":3,"firmware_major":3,)"
            R"("firmware_minor":10,"map":"sts","port":"p","baud":1000000})";
        const QByteArray head = R"({"v":1,"at":"2025-01-31T12:00:00.000Z",)";
        const auto begin = [&](const QByteArray& uuid, const QByteArray& kind,
                               const QByteArray& items) {
            return head + R"("type":"begin","uuid":)" + uuid + R"(,"kind":)" + kind +
                   R"(,"temporary":false,"lock_opened":true,)" + servo + R"(,"items":)" + items +
                   "}";
        };
        const QByteArray item = R"({"key":"min_angle","address":9,"old":0,"new":1})";
        QTest::newRow("text") << QByteArray("hello");
        QTest::newRow("zero bytes") << QByteArray(300, '\0');
        QTest::newRow("not UTF-8") << QByteArray("{\"v\":1,\"type\":\"\xff\"}");
        QTest::newRow("half a line") << head;
        QTest::newRow("list") << QByteArray("[1,2]");
        QTest::newRow("nested beyond sense") << QByteArray(5000, '[');
        QTest::newRow("newer version") << QByteArray(R"({"v":2,"type":"begin"})");
        QTest::newRow("no version") << QByteArray(R"({"type":"end"})");
        QTest::newRow("unknown type") << head + R"("type":"maybe"})";
        QTest::newRow("no uuid") << begin("\"\"", "\"write\"", "[]");
        QTest::newRow("uuid a number") << begin("7", "\"write\"", "[]");
        QTest::newRow("unknown kind") << begin("\"u\"", "\"dance\"", "[]");
        QTest::newRow("items no list") << begin("\"u\"", "\"write\"", "{}");
        QTest::newRow("item no object") << begin("\"u\"", "\"write\"", "[" + item + ",5]");
        QTest::newRow("fraction") << begin(
            "\"u\"", "\"write\"", QByteArray("[" + item + "]").replace("\"old\":0", "\"old\":0.5"));
        QTest::newRow("huge number")
            << begin("\"u\"", "\"write\"",
                     QByteArray("[" + item + "]").replace("\"new\":1", "\"new\":1e300"));
        QTest::newRow("address beyond int") << begin(
            "\"u\"", "\"write\"",
            QByteArray("[" + item + "]").replace("\"address\":9", "\"address\":99999999999"));
        QTest::newRow("end of nothing")
            << head + R"("type":"end","uuid":"nobody","outcome":"done","detail":""})";
        QTest::newRow("values no list")
            << head + R"("type":"keep",)" + servo + R"(,"name":"limits","values":1})";
    }
    void uselessLinesAreCounted()
    {
        QFETCH(const QByteArray, line);
        LegacyJournal old(m_old);
        old.begin(exampleIntent(1));
        old.append(line);
        old.begin(exampleIntent(2));
        {
            const auto file = history::HistoryFile::open(m_path, 5s).value();
            const auto taken = history::importJournal(*file).value();
            QCOMPARE(taken.lines, 3);
            QCOMPARE(taken.unreadable, 1);
        }
        QCOMPARE(entries().size(), std::size_t(2));
    }

    /// Journals from before there was more than one language are read for ever; a language nobody
    /// knows makes the line unreadable rather than somebody else's.
    void withoutAProtocolItIsFeetech()
    {
        LegacyJournal(m_old).begin(exampleIntent());
        QFile file(m_old);
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QByteArray line = file.readAll();
        file.resize(0);
        file.seek(0);
        file.write(QByteArray(line).replace(",\"protocol\":\"feetech\"", ""));
        file.write(QByteArray(line).replace("feetech", "morse"));
        file.write(QByteArray(line)
                       .replace("\"v\":1", "\"mood\":[1],\"v\":1")
                       .replace("uuid\":\"", "uuid\":\"x"));
        file.close();
        const auto all = entries();
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0].intent.servo.protocol, base::Protocol::Feetech);
    }

    /// It may hold a change that was interrupted: as long as nobody can look, nothing is written.
    void anUnreadableJournalRefusesTheWrite_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::newRow("folder") << QStringLiteral("folder");
        QTest::newRow("pipe") << QStringLiteral("pipe");
    }
    void anUnreadableJournalRefusesTheWrite()
    {
        QFETCH(const QString, kind);
        if (kind == QLatin1String("folder"))
            QVERIFY(QDir().mkpath(m_old));
        else
            QCOMPARE(::mkfifo(QFile::encodeName(m_old).constData(), 0600), 0);
        HistoryJournal journal(m_path, program);
        const auto begun = journal.begin(exampleIntent());
        QVERIFY(!begun);
        QCOMPARE(int(begun.error().code), int(ErrorCode::FileUnreadable));
        QVERIFY(begun.error().detail.contains(m_old));
        QVERIFY(!journal.open());
        QVERIFY(QFileInfo::exists(m_old));
        QVERIFY(history::History::open(m_path)); // test runs are kept all the same
    }
};

static int run(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 3 && arguments[1] == QLatin1String("open"))
        return openAll(arguments[2]);
    TestJournalImport test;
    return QTest::qExec(&test, argc, argv);
}
SERVODESK_TEST_RUN(run)

#include "tst_journal_import.moc"
