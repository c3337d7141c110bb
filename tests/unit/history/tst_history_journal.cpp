// SPDX-License-Identifier: GPL-3.0-or-later
// The journal in the history database keeps its word: what begin() said is on disk is there after a
// crash and a full disk, and while others write; where it cannot be, no write begins.
#include "history/history.h"
#include "history/history_file.h"
#include "history/history_journal.h"
#include "support/file_size_limit.h"
#include "support/test_main.h"
#include "unit/history/intent_example.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <cstdio>
#include <future>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using base::ErrorCode;
using base::Intent;
using history::HistoryJournal;
using intent_example::exampleIntent;
using intent_example::exampleServo;
using namespace std::chrono_literals;

namespace {
const QString program = QStringLiteral("servodesk test");

void overwrite(const QString& path, const QByteArray& content)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

/// Where several write without a pause, on a busy disk.
constexpr auto longTimeout = 60s;

// The other program: begins intents and prints the uuid of each that is on disk.
int appendIntents(const QString& path, int count)
{
    HistoryJournal journal(path, program, longTimeout);
    for (int i = 0; i < count; ++i) {
        const auto uuid = journal.begin(exampleIntent(i % 254));
        if (!uuid)
            return 1;
        std::puts(qPrintable(*uuid));
        std::fflush(stdout);
        if (i % 2 == 0 && !journal.end(*uuid, {QStringLiteral("done"), {}}))
            return 1;
    }
    return 0;
}

/// Until it is killed.
int beginIntentAndWait(const QString& path)
{
    HistoryJournal journal(path, program, 5s);
    const auto uuid = journal.begin(exampleIntent());
    if (!uuid)
        return 1;
    std::puts(qPrintable(*uuid));
    std::fflush(stdout);
    std::this_thread::sleep_for(10min);
    return 0;
}

/// Without root's rights. Prints the error.
int verifyRefused(const QString& path)
{
    constexpr uid_t nobodyUid = 65534;
    if (::geteuid() == 0 && ::setuid(nobodyUid) != 0)
        return 2;
    const auto begun = HistoryJournal(path, program).begin(exampleIntent());
    if (begun)
        return 1;
    std::puts(
        qPrintable(base::errorName(begun.error().code) + QLatin1Char(' ') + begun.error().detail));
    return 0;
}

QSet<QString> uuidsIn(const HistoryJournal& journal)
{
    QSet<QString> uuids;
    const auto entries = journal.entries();
    for (const base::JournalEntry& entry : entries.value())
        uuids.insert(entry.intent.uuid);
    return uuids;
}
} // namespace

class TestHistoryJournal : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_path = m_folder->filePath(QStringLiteral("history.sqlite"));
    }

    void readingCreatesNoFile()
    {
        const HistoryJournal journal(m_path, program);
        QVERIFY(journal.entries().value().empty());
        QVERIFY(journal.open().value().empty());
        QVERIFY(journal.entriesFor(exampleServo(), 10).value().empty());
        QVERIFY(!journal.servoValues(exampleServo(), QStringLiteral("limits")).value());
        QVERIFY(!QFile::exists(m_path));
    }

    /// Until it ends it, or its job is over, or it is gone itself.
    void intentsInProgressBelongToTheirProgram()
    {
        const HistoryJournal viewer(m_path, program);
        const auto isUnderWay = [&] { return viewer.open()->front().isActiveElsewhere; };
        auto owner = std::make_unique<HistoryJournal>(m_path, program);
        const QString first = owner->begin(exampleIntent()).value();
        QVERIFY(isUnderWay());
        QVERIFY(isUnderWay()); // looking changes nothing
        QVERIFY(!owner->open()->front().isActiveElsewhere);
        owner->release();
        QVERIFY(!isUnderWay());
        QVERIFY(owner->end(first, {QStringLiteral("done"), {}}));
        const QString second = owner->begin(exampleIntent()).value();
        QVERIFY(isUnderWay());
        QVERIFY(owner->end(second, {QStringLiteral("done"), {}}));
        QVERIFY(owner->begin(exampleIntent()));
        owner.reset();
        QVERIFY(!isUnderWay());
        const QDir locks(m_folder->filePath(QStringLiteral("running")));
        QVERIFY(locks.exists() && locks.isEmpty());
    }

    /// Not even a program that is killed keeps it.
    void aKilledProgramHasNothingInProgress()
    {
        QProcess other;
        other.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("tst_history_journal"), QStringLiteral("hold"), m_path});
        QVERIFY(other.waitForStarted());
        QTRY_VERIFY(other.canReadLine());
        const HistoryJournal viewer(m_path, program);
        QVERIFY(viewer.open()->front().isActiveElsewhere);
        other.kill();
        QVERIFY(other.waitForFinished());
        QVERIFY(!viewer.open()->front().isActiveElsewhere);
        QVERIFY(QDir(m_folder->filePath(QStringLiteral("running"))).isEmpty());
    }

    void everyProtocolSurvivesReopening()
    {
        for (const base::Protocol protocol : base::allProtocols) {
            Intent intent = exampleIntent();
            intent.servo.protocol = protocol;
            intent.servo.modelMajor = -1; // an LX servo says nothing of itself
            QVERIFY(HistoryJournal(m_path, program).begin(intent));
            intent_example::compareIntents(HistoryJournal(m_path, program).open()->back(), intent);
        }
    }

    void intentsSurviveReopening_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<bool>("temporary");
        for (const auto kind :
             {base::IntentKind::Write, base::IntentKind::SetId, base::IntentKind::SetBaud,
              base::IntentKind::Mode, base::IntentKind::Calibrate, base::IntentKind::Restore,
              base::IntentKind::Identify, base::IntentKind::Trial}) {
            QTest::addRow("kind %d kept", int(kind)) << int(kind) << false;
            QTest::addRow("kind %d temporary", int(kind)) << int(kind) << true;
        }
    }
    void intentsSurviveReopening()
    {
        QFETCH(const int, kind);
        QFETCH(const bool, temporary);
        Intent intent = exampleIntent(253);
        intent.kind = base::IntentKind(kind);
        intent.temporary = temporary;
        intent.lockOpened = !temporary;
        intent.servo.port = QStringLiteral("/dev/serial/by-id/usb \"左\" 1");
        const QString uuid = HistoryJournal(m_path, program).begin(intent).value();

        const HistoryJournal reopened(m_path, program);
        const auto open = reopened.open().value();
        QCOMPARE(open.size(), 1U);
        QCOMPARE(open[0].uuid, uuid);
        QVERIFY(open[0].at.isValid());
        QCOMPARE(open[0].at.timeSpec(), Qt::UTC);
        intent_example::compareIntents(open[0], intent);
    }

    void anEndedIntentIsNotOpen()
    {
        HistoryJournal journal(m_path, program);
        const QString first = journal.begin(exampleIntent(1)).value();
        const QString second = journal.begin(exampleIntent(2)).value();
        QVERIFY(first != second);
        QVERIFY(journal.end(first, {QStringLiteral("done"), QStringLiteral("all kept")}));

        const auto entries = HistoryJournal(m_path, program).entries().value();
        QCOMPARE(entries.size(), 2U);
        QCOMPARE(entries[0].intent.uuid, first);
        QCOMPARE(entries[0].end.value().outcome, QStringLiteral("done"));
        QCOMPARE(entries[0].end.value().detail, QStringLiteral("all kept"));
        QVERIFY(!entries[1].end);
        QCOMPARE(journal.open().value().size(), 1U);
    }

    void eachRegisterHasItsOutcome()
    {
        HistoryJournal journal(m_path, program);
        const QString uuid = journal.begin(exampleIntent(1)).value();
        QVERIFY(journal.end(
            uuid, {QStringLiteral("failed"),
                   {},
                   {{QStringLiteral("position_offset"), -2046, QStringLiteral("mismatch")},
                    {QStringLiteral("min_angle"), 100, QStringLiteral("kept")}}}));
        const auto history = history::History::open(m_path).value()->log().writes().value();
        QCOMPARE(history.size(), std::size_t(2));
        for (const history::HistoryWrite& write : history) {
            const bool offset = write.key == QLatin1String("position_offset");
            QCOMPARE(write.outcome, offset ? QStringLiteral("mismatch") : QStringLiteral("kept"));
            QCOMPARE(write.readBack.value(), offset ? -2046 : 100);
            QCOMPARE(write.oldRaw, offset ? 2047 : -12);
            QCOMPARE(write.newRaw, offset ? -2047 : 100);
            QCOMPARE(write.isGood(), !offset);
            QCOMPARE(write.port, QStringLiteral("/dev/ttyUSB0"));
            QCOMPARE(write.baud, 1000000);
            QCOMPARE(write.program, program);
            QCOMPARE(write.intentUuid, uuid);
        }
        const auto entry = journal.entries().value().at(0);
        QCOMPARE(entry.end.value().items.size(), std::size_t(2));
    }

    void theLatestEndCounts()
    {
        HistoryJournal journal(m_path, program);
        const QString uuid = journal.begin(exampleIntent()).value();
        QVERIFY(journal.end(uuid, {QStringLiteral("failed"), {}}));
        QVERIFY(journal.end(uuid, {QStringLiteral("undone"), {}}));
        QCOMPARE(journal.entries().value().at(0).end.value().outcome, QStringLiteral("undone"));
    }

    void anEndWithoutAStartIsAnError()
    {
        HistoryJournal journal(m_path, program);
        QVERIFY(journal.begin(exampleIntent()));
        const auto ended = journal.end(QStringLiteral("nobody"), {QStringLiteral("done"), {}});
        QVERIFY(!ended);
        QCOMPARE(int(ended.error().code), int(ErrorCode::BadArgument));
    }

    void entriesOfAServo()
    {
        HistoryJournal journal(m_path, program);
        for (int n = 0; n < 5; ++n) {
            Intent intent = exampleIntent(1);
            intent.items[0].newRaw = n;
            journal.begin(intent).value();
        }
        journal.begin(exampleIntent(2)).value();
        Intent comes = exampleIntent(7);
        comes.kind = base::IntentKind::SetId;
        comes.items = {{QStringLiteral("id"), 5, 7, 1}};
        journal.begin(comes).value();
        Intent goesElsewhere = comes;
        goesElsewhere.items[0].newRaw = 8;
        journal.begin(goesElsewhere).value();

        const auto all = journal.entriesFor(exampleServo(1), 100).value();
        QCOMPARE(all.size(), std::size_t(6));
        QCOMPARE(all.front().intent.items[0].newRaw, 0);
        QCOMPARE(int(all.back().intent.kind), int(base::IntentKind::SetId));
        const auto latest = journal.entriesFor(exampleServo(1), 3).value();
        QCOMPARE(latest.size(), std::size_t(3));
        QCOMPARE(latest.front().intent.items[0].newRaw, 3);
        QVERIFY(journal.entriesFor(exampleServo(3), 100).value().empty());
    }

    void storedValuesBelongToTypeAndId()
    {
        const QString limits = QStringLiteral("limits");
        HistoryJournal journal(m_path, program);
        QVERIFY(journal.saveServoValues(exampleServo(), limits, {100, 4000}));
        const std::int64_t large = 9007199254740993; // more than a double can hold
        QVERIFY(journal.saveServoValues(exampleServo(), limits, {-5, large}));

        base::ServoIdentity moved = exampleServo();
        moved.port = QStringLiteral("/dev/ttyUSB7");
        moved.baud = 500000;
        base::ServoIdentity otherFirmware = exampleServo();
        otherFirmware.firmwareMinor = 11;
        base::ServoIdentity otherModel = exampleServo();
        otherModel.modelMinor = 4;
        base::ServoIdentity otherMap = exampleServo();
        otherMap.map = QStringLiteral("scs");

        const HistoryJournal reopened(m_path, program);
        const std::vector<std::int64_t> latest{-5, large};
        QCOMPARE(reopened.servoValues(exampleServo(), limits).value(), latest);
        QCOMPARE(reopened.servoValues(moved, limits).value(), latest);
        QVERIFY(!reopened.servoValues(exampleServo(2), limits).value());
        QVERIFY(!reopened.servoValues(otherFirmware, limits).value());
        QVERIFY(!reopened.servoValues(otherModel, limits).value());
        QVERIFY(!reopened.servoValues(otherMap, limits).value());
        QVERIFY(!reopened.servoValues(exampleServo(), QStringLiteral("speed")).value());
    }

    void missingFoldersAreCreated()
    {
        m_path = m_folder->filePath(QStringLiteral("a/b c/history.sqlite"));
        QVERIFY(HistoryJournal(m_path, program).begin(exampleIntent()));
        QCOMPARE(HistoryJournal(m_path, program).open().value().size(), 1U);
    }

    void entriesOfAnotherProgramAreSeen()
    {
        HistoryJournal here(m_path, program);
        HistoryJournal there(m_path, program);
        const QString first = here.begin(exampleIntent(1)).value();
        QCOMPARE(there.open().value().size(), 1U);
        QVERIFY(there.end(first, {QStringLiteral("done"), {}}));
        there.begin(exampleIntent(2)).value();
        const auto entries = here.entries().value();
        QCOMPARE(entries.size(), 2U);
        QVERIFY(entries[0].end);
    }

    /// What is written after the file was moved away must not vanish with it.
    void aReplacedFileIsReread()
    {
        HistoryJournal journal(m_path, program);
        journal.begin(exampleIntent(1)).value();
        const QString other = m_folder->filePath(QStringLiteral("other"));
        {
            HistoryJournal restored(other, program);
            for (int id = 10; id < 15; ++id)
                restored.begin(exampleIntent(id)).value();
        }
        QVERIFY(QFile::remove(m_path));
        for (const char* side : {"-wal", "-shm"})
            (void)QFile::remove(m_path + QLatin1String(side));
        QVERIFY(QFile::rename(other, m_path));
        QCOMPARE(journal.entries().value().size(), 5U);
        QVERIFY(journal.begin(exampleIntent(99)));
        QCOMPARE(HistoryJournal(m_path, program).entries().value().size(), 6U);
    }

    void threadsLoseNothing()
    {
        constexpr int threads = 4;
        constexpr int each = 25;
        std::vector<std::thread> writers;
        std::atomic<int> failures{0};
        HistoryJournal shared(m_path, program, longTimeout);
        for (int i = 0; i < threads; ++i) {
            writers.emplace_back([this, &failures, &shared, i] {
                HistoryJournal own(m_path, program, longTimeout);
                HistoryJournal& journal = i % 2 == 0 ? own : shared;
                for (int n = 0; n < each; ++n) {
                    const auto uuid = journal.begin(exampleIntent(n));
                    if (!uuid || !journal.end(*uuid, {QStringLiteral("done"), {}}))
                        ++failures;
                }
            });
        }
        for (std::thread& writer : writers)
            writer.join();
        QCOMPARE(failures, 0);
        const HistoryJournal journal(m_path, program);
        QCOMPARE(journal.entries().value().size(), std::size_t(threads * each));
        QVERIFY(journal.open().value().empty());
    }

    void programsLoseNothing()
    {
        constexpr int each = 40;
        std::vector<std::unique_ptr<QProcess>> programs;
        for (int i = 0; i < 3; ++i) {
            programs.push_back(std::make_unique<QProcess>());
            programs.back()->start(QCoreApplication::applicationFilePath(),
                                   {QStringLiteral("tst_history_journal"), QStringLiteral("append"),
                                    m_path, QString::number(each)});
        }
        QSet<QString> confirmedUuids;
        for (const auto& one : programs) {
            QVERIFY(one->waitForFinished());
            QCOMPARE(one->exitCode(), 0);
            for (const QByteArray& line : one->readAllStandardOutput().trimmed().split('\n'))
                confirmedUuids.insert(QString::fromLatin1(line));
        }
        const HistoryJournal journal(m_path, program);
        QCOMPARE(uuidsIn(journal), confirmedUuids);
        QCOMPARE(confirmedUuids.size(), qsizetype(programs.size()) * each);
        QCOMPARE(journal.open().value().size(), std::size_t(programs.size()) * each / 2);
    }

    void confirmedEntriesSurviveAKill()
    {
        for (int round = 0; round < 5; ++round) {
            QProcess other;
            other.start(QCoreApplication::applicationFilePath(),
                        {QStringLiteral("tst_history_journal"), QStringLiteral("append"), m_path,
                         QStringLiteral("1000000")});
            QByteArray printed;
            while (printed.count('\n') < 5 + round) {
                QVERIFY(other.waitForReadyRead());
                printed += other.readAllStandardOutput();
            }
            other.kill();
            QVERIFY(other.waitForFinished());
            printed += other.readAllStandardOutput();

            HistoryJournal journal(m_path, program);
            const QSet<QString> found = uuidsIn(journal);
            for (const QByteArray& line : printed.left(printed.lastIndexOf('\n')).split('\n'))
                QVERIFY2(found.contains(QString::fromLatin1(line)), line.constData());
            const auto all = journal.entries().value();
            for (const base::JournalEntry& entry : all)
                QCOMPARE(entry.intent.items.size(), std::size_t(2)); // whole or not at all
            QVERIFY(journal.begin(exampleIntent()));
        }
    }

    /// No room for another page: the write does not begin, and what was there stays.
    void aFullDiskRefusesTheWrite()
    {
        HistoryJournal journal(m_path, program);
        const QString first = journal.begin(exampleIntent(1)).value();
        {
            const FileSizeLimit limit(QFileInfo(m_path + QStringLiteral("-wal")).size());
            for (int n = 0; n < 20; ++n) {
                const auto begun = journal.begin(exampleIntent(2));
                QVERIFY(!begun);
                QVERIFY(begun.error().detail.contains(m_path));
                QCOMPARE(journal.entries().value().size(), 1U);
            }
        }
        QVERIFY(journal.begin(exampleIntent(2)));
        QVERIFY(journal.end(first, {QStringLiteral("done"), {}}));
        QCOMPARE(journal.open().value().size(), 1U);
    }

    void otherFilesAreNeverReplaced_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"folder", "pipe", "text", "newer", "damaged"})
            QTest::newRow(kind) << QString::fromLatin1(kind);
    }
    void otherFilesAreNeverReplaced()
    {
        QFETCH(const QString, kind);
        if (kind == QLatin1String("folder")) {
            QVERIFY(QDir().mkpath(m_path));
        } else if (kind == QLatin1String("pipe")) {
            QCOMPARE(::mkfifo(QFile::encodeName(m_path).constData(), 0600), 0);
        } else if (kind == QLatin1String("text")) {
            overwrite(m_path, QByteArray(5000, 'x'));
        } else {
            {
                HistoryJournal journal(m_path, program);
                for (int i = 0; i < 200; ++i)
                    journal.begin(exampleIntent(i)).value();
            }
            if (kind == QLatin1String("newer")) {
                const auto file = history::HistoryFile::open(m_path, 5s).value();
                QVERIFY(file->run(QStringLiteral("PRAGMA user_version = 99")));
            } else {
                QFile file(m_path);
                QVERIFY(file.open(QIODevice::ReadWrite));
                file.seek(4096);
                file.write(QByteArray(int(file.size()) - 4096, '\x5a'));
            }
        }
        const auto sizeBefore = QFileInfo(m_path).size();
        HistoryJournal journal(m_path, program);
        const auto begun = journal.begin(exampleIntent());
        QVERIFY(!begun);
        QVERIFY(begun.error().detail.contains(m_path));
        const bool format = kind == QLatin1String("text") || kind == QLatin1String("newer") ||
                            kind == QLatin1String("damaged");
        QCOMPARE(int(begun.error().code),
                 int(format ? ErrorCode::FileFormat : ErrorCode::FileUnwritable));
        QVERIFY(!journal.open());
        QVERIFY(!journal.servoValues(exampleServo(), QStringLiteral("limits")));
        QCOMPARE(QFileInfo(m_path).size(), sizeBefore);
        QVERIFY(QFileInfo::exists(m_path));
    }

    void aReadOnlyFileRefusesTheWrite()
    {
        {
            HistoryJournal journal(m_path, program);
            journal.begin(exampleIntent(1)).value();
        }
        QVERIFY(QFile::setPermissions(m_path, QFile::ReadOwner | QFile::ReadOther));
        QVERIFY(QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::ExeOwner |
                                                            QFile::ReadOther | QFile::ExeOther));
        QProcess other; // as nobody in particular, since to root no file is read-only
        other.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("tst_history_journal"), QStringLiteral("refuse"), m_path});
        QVERIFY(other.waitForFinished());
        QVERIFY(QFile::setPermissions(m_folder->path(),
                                      QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        const QString said = QString::fromUtf8(other.readAllStandardOutput());
        QVERIFY2(said.startsWith(base::errorName(ErrorCode::FileUnwritable)), qPrintable(said));
        QVERIFY2(said.contains(m_path), qPrintable(said));
        QCOMPARE(HistoryJournal(m_path, program).open().value().size(), 1U);
    }

    /// Somebody who holds the database for ever costs patience, not the program.
    void aLockedDatabaseRefusesTheWrite()
    {
        HistoryJournal(m_path, program).begin(exampleIntent(1)).value();
        const auto other = history::HistoryFile::open(m_path, 5s).value();
        HistoryJournal journal(m_path, program, 50ms);
        (void)other->transaction([&]() -> base::Result<void> {
            const auto begun = journal.begin(exampleIntent(2));
            [&] { QVERIFY(!begun); }();
            [&] { QCOMPARE(journal.open().value().size(), 1U); }(); // reading goes on
            return {};
        });
        QVERIFY(journal.begin(exampleIntent(3)));
    }

    /// What was written to a servo is recorded once the other program has finished.
    void theEndWaitsLongerThanTheStart()
    {
        HistoryJournal journal(m_path, program, 50ms);
        const auto uuid = journal.begin(exampleIntent(1)).value();
        std::promise<void> locked;
        std::thread other([&] {
            const auto file = history::HistoryFile::open(m_path, 5s).value();
            (void)file->transaction([&]() -> base::Result<void> {
                const auto refused = journal.begin(exampleIntent(2));
                [&] { QVERIFY(!refused); }();
                locked.set_value();
                std::this_thread::sleep_for(400ms); // many times the patience of a beginning
                return {};
            });
        });
        locked.get_future().wait();
        const auto ended = journal.end(uuid, {QStringLiteral("done"), {}});
        other.join();
        QVERIFY2(ended, ended ? "" : qPrintable(ended.error().detail));
        QVERIFY(journal.open().value().empty());
    }

    void anInvalidPathIsReported()
    {
        overwrite(m_path, "a file, not a folder");
        HistoryJournal journal(m_path + QStringLiteral("/below/history.sqlite"), program);
        const auto begun = journal.begin(exampleIntent());
        QVERIFY(!begun);
        QCOMPARE(int(begun.error().code), int(ErrorCode::FileUnwritable));
        QVERIFY(begun.error().detail.contains(m_path));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

static int runTestHistoryJournal(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments[1] == QLatin1String("append"))
        return appendIntents(arguments[2], arguments[3].toInt());
    if (arguments.size() == 3 && arguments[1] == QLatin1String("hold"))
        return beginIntentAndWait(arguments[2]);
    if (arguments.size() == 3 && arguments[1] == QLatin1String("refuse"))
        return verifyRefused(arguments[2]);
    TestHistoryJournal test;
    return QTest::qExec(&test, argc, argv);
}
SERVODESK_TEST_RUN(runTestHistoryJournal)

#include "tst_history_journal.moc"
