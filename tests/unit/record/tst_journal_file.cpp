// SPDX-License-Identifier: GPL-3.0-or-later
// The journal keeps its word: what begin() said is on disk is there after a crash, a torn line, a
// full disk, and while others write.
#include "record/journal_file.h"
#include "unit/record/file_size_limit.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <cstdio>
#include <sys/stat.h>
#include <thread>

using base::ErrorCode;
using base::Intent;
using record::JournalFile;

namespace {
base::ServoIdentity someServo(int id = 1)
{
    return {id, 9, 3, 3, 10, QStringLiteral("sts-sms"), QStringLiteral("/dev/ttyUSB0"), 1000000};
}

Intent someIntent(int id = 1)
{
    Intent intent;
    intent.lockOpened = true;
    intent.servo = someServo(id);
    intent.items = {{QStringLiteral("min_angle"), 9, -12, 100},
                    {QStringLiteral("position_offset"), 31, 2047, -2047}};
    return intent;
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void overwrite(const QString& path, const QByteArray& content)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

void verifySame(const Intent& found, const Intent& written)
{
    QCOMPARE(int(found.kind), int(written.kind));
    QCOMPARE(found.temporary, written.temporary);
    QCOMPARE(found.lockOpened, written.lockOpened);
    QCOMPARE(found.servo.id, written.servo.id);
    QVERIFY(found.servo.sameKind(written.servo));
    QCOMPARE(found.servo.port, written.servo.port);
    QCOMPARE(found.servo.baud, written.servo.baud);
    QCOMPARE(found.servo.protocol, written.servo.protocol);
    QCOMPARE(found.items.size(), written.items.size());
    for (std::size_t i = 0; i < found.items.size(); ++i) {
        QCOMPARE(found.items[i].key, written.items[i].key);
        QCOMPARE(found.items[i].address, written.items[i].address);
        QCOMPARE(found.items[i].oldRaw, written.items[i].oldRaw);
        QCOMPARE(found.items[i].newRaw, written.items[i].newRaw);
    }
}

// The other program: appends intents and prints the uuid of each that is on disk.
int appendIntents(const QString& path, int count)
{
    JournalFile journal(path);
    for (int i = 0; i < count; ++i) {
        const auto uuid = journal.begin(someIntent(i % 254));
        if (!uuid)
            return 1;
        std::puts(qPrintable(*uuid));
        std::fflush(stdout);
    }
    return 0;
}

QSet<QString> uuidsIn(const JournalFile& journal)
{
    QSet<QString> uuids;
    const auto entries = journal.entries();
    for (const base::JournalEntry& entry : entries.value())
        uuids.insert(entry.intent.uuid);
    return uuids;
}
} // namespace

class TestJournalFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_path = m_folder->filePath(QStringLiteral("journal.jsonl"));
    }

    void anUnusedJournalIsEmptyAndMakesNoFile()
    {
        const JournalFile journal(m_path);
        QVERIFY(journal.entries().value().empty());
        QVERIFY(!journal.kept(someServo(), QStringLiteral("limits")).value());
        QVERIFY(!QFile::exists(m_path));
    }

    void everyLanguageSurvivesReopening()
    {
        for (const base::Protocol protocol : base::allProtocols) {
            Intent intent = someIntent();
            intent.servo.protocol = protocol;
            intent.servo.modelMajor = -1; // an LX servo says nothing of itself
            QVERIFY(JournalFile(m_path).begin(intent));
            verifySame(JournalFile(m_path).open()->back(), intent);
        }
    }

    /// Journals from before there was more than one language are read for ever.
    void withoutALanguageItIsFeetech()
    {
        QVERIFY(JournalFile(m_path).begin(someIntent()));
        const QByteArray line = contentOf(m_path);
        const QByteArray named(",\"protocol\":\"feetech\"");
        QVERIFY(line.contains(named));
        overwrite(m_path, QByteArray(line).replace(named, ""));
        const auto open = JournalFile(m_path).open();
        QCOMPARE(open->size(), std::size_t(1));
        QCOMPARE(open->front().servo.protocol, base::Protocol::Feetech);
        // A language nobody knows makes the line unreadable rather than somebody else's.
        overwrite(m_path, QByteArray(line).replace("feetech", "morse"));
        QCOMPARE(JournalFile(m_path).open()->size(), std::size_t(0));
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
        Intent intent = someIntent(253);
        intent.kind = base::IntentKind(kind);
        intent.temporary = temporary;
        intent.lockOpened = !temporary;
        intent.servo.port = QStringLiteral("/dev/serial/by-id/usb \"左\" 1");
        const QString uuid = JournalFile(m_path).begin(intent).value();

        const JournalFile reopened(m_path);
        const auto open = reopened.open().value();
        QCOMPARE(open.size(), 1U);
        QCOMPARE(open[0].uuid, uuid);
        QVERIFY(open[0].at.isValid());
        QCOMPARE(open[0].at.timeSpec(), Qt::UTC);
        verifySame(open[0], intent);
        QVERIFY(reopened.warnings().empty());
    }

    void anEndedIntentIsNotOpen()
    {
        JournalFile journal(m_path);
        const QString first = journal.begin(someIntent(1)).value();
        const QString second = journal.begin(someIntent(2)).value();
        QVERIFY(first != second);
        QVERIFY(journal.end(first, {QStringLiteral("done"), QStringLiteral("all kept")}));

        const auto entries = JournalFile(m_path).entries().value();
        QCOMPARE(entries.size(), 2U);
        QCOMPARE(entries[0].intent.uuid, first);
        QCOMPARE(entries[0].end.value().outcome, QStringLiteral("done"));
        QCOMPARE(entries[0].end.value().detail, QStringLiteral("all kept"));
        QVERIFY(!entries[1].end);
        QCOMPARE(journal.open().value().size(), 1U);
    }

    void theLatestEndCounts()
    {
        JournalFile journal(m_path);
        const QString uuid = journal.begin(someIntent()).value();
        QVERIFY(journal.end(uuid, {QStringLiteral("failed"), {}}));
        QVERIFY(journal.end(uuid, {QStringLiteral("undone"), {}}));
        QCOMPARE(journal.entries().value().at(0).end.value().outcome, QStringLiteral("undone"));
    }

    void keptFactsBelongToKindAndId()
    {
        const QString limits = QStringLiteral("limits");
        JournalFile journal(m_path);
        QVERIFY(journal.keep(someServo(), limits, {100, 4000}));
        QVERIFY(journal.keep(someServo(), limits, {-5, 3000}));

        base::ServoIdentity moved = someServo();
        moved.port = QStringLiteral("/dev/ttyUSB7");
        moved.baud = 500000;
        base::ServoIdentity otherFirmware = someServo();
        otherFirmware.firmwareMinor = 11;
        base::ServoIdentity otherModel = someServo();
        otherModel.modelMinor = 4;
        base::ServoIdentity otherMap = someServo();
        otherMap.map = QStringLiteral("scs");

        const JournalFile reopened(m_path);
        const std::vector<std::int64_t> latest{-5, 3000};
        QCOMPARE(reopened.kept(someServo(), limits).value(), latest);
        QCOMPARE(reopened.kept(moved, limits).value(), latest);
        QVERIFY(!reopened.kept(someServo(2), limits).value());
        QVERIFY(!reopened.kept(otherFirmware, limits).value());
        QVERIFY(!reopened.kept(otherModel, limits).value());
        QVERIFY(!reopened.kept(otherMap, limits).value());
        QVERIFY(!reopened.kept(someServo(), QStringLiteral("speed")).value());
    }

    void missingFoldersAreMade()
    {
        m_path = m_folder->filePath(QStringLiteral("a/b c/journal.jsonl"));
        QVERIFY(JournalFile(m_path).begin(someIntent()));
        QCOMPARE(JournalFile(m_path).open().value().size(), 1U);
    }

    // A power cut may leave any part of the last line. The lines before it count, the next one
    // starts on a line of its own.
    void aTornLastLineCostsItselfOnly()
    {
        {
            JournalFile journal(m_path);
            QVERIFY(
                journal.end(journal.begin(someIntent(1)).value(), {QStringLiteral("done"), {}}));
        }
        const QByteArray whole = contentOf(m_path);
        QVERIFY(JournalFile(m_path).begin(someIntent(2)));
        const QByteArray longer = contentOf(m_path);

        for (auto length = whole.size() + 1; length < longer.size(); ++length) {
            overwrite(m_path, longer.left(length));
            JournalFile journal(m_path);
            QCOMPARE(journal.entries().value().size(), 1U);
            QCOMPARE(journal.warnings().size(), 1U);
            QCOMPARE(journal.warnings()[0].line, 3);

            const QString next = journal.begin(someIntent(3)).value();
            const auto open = journal.open().value();
            QVERIFY(!open.empty());
            QCOMPARE(open.back().uuid, next);
            // Only the line feed was missing: then the line is good once it has one.
            const bool onlyLineFeedMissing = length == longer.size() - 1;
            QCOMPARE(open.size(), onlyLineFeedMissing ? 2U : 1U);
            QCOMPARE(journal.warnings().size(), onlyLineFeedMissing ? 0U : 1U);
            QVERIFY(contentOf(m_path).startsWith(longer.left(length) + '\n'));
        }
    }

    void uselessLinesAreNamed_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("complaint");
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
        QTest::newRow("text") << QByteArray("hello") << QStringLiteral("line 1");
        QTest::newRow("zero bytes") << QByteArray(300, '\0') << QStringLiteral("line 1");
        QTest::newRow("not UTF-8")
            << QByteArray("{\"v\":1,\"type\":\"\xff\"}") << QStringLiteral("line 1");
        QTest::newRow("half a line") << head << QStringLiteral("line 1");
        QTest::newRow("list") << QByteArray("[1,2]") << QStringLiteral("expected an object");
        QTest::newRow("nested beyond sense") << QByteArray(5000, '[') << QStringLiteral("line 1");
        QTest::newRow("newer version")
            << QByteArray(R"({"v":2,"type":"begin"})") << QStringLiteral("version 2");
        QTest::newRow("no version") << QByteArray(R"({"type":"end"})") << QStringLiteral("v:");
        QTest::newRow("unknown type") << head + R"("type":"maybe"})" << QStringLiteral("maybe");
        QTest::newRow("no uuid") << begin("\"\"", "\"write\"", "[]") << QStringLiteral("uuid");
        QTest::newRow("uuid a number") << begin("7", "\"write\"", "[]") << QStringLiteral("uuid");
        QTest::newRow("unknown kind")
            << begin("\"u\"", "\"dance\"", "[]") << QStringLiteral("dance");
        QTest::newRow("items no list")
            << begin("\"u\"", "\"write\"", "{}") << QStringLiteral("items: expected a list");
        QTest::newRow("item no object")
            << begin("\"u\"", "\"write\"", "[" + item + ",5]") << QStringLiteral("items[1]");
        QTest::newRow("fraction")
            << begin("\"u\"", "\"write\"",
                     QByteArray("[" + item + "]").replace("\"old\":0", "\"old\":0.5"))
            << QStringLiteral("items[0].old: expected a whole number");
        QTest::newRow("huge number")
            << begin("\"u\"", "\"write\"",
                     QByteArray("[" + item + "]").replace("\"new\":1", "\"new\":1e300"))
            << QStringLiteral("items[0].new");
        QTest::newRow("address beyond int")
            << begin(
                   "\"u\"", "\"write\"",
                   QByteArray("[" + item + "]").replace("\"address\":9", "\"address\":99999999999"))
            << QStringLiteral("items[0].address");
        QTest::newRow("end of nothing")
            << head + R"("type":"end","uuid":"nobody","outcome":"done","detail":""})"
            << QStringLiteral("not there");
        QTest::newRow("values no list")
            << head + R"("type":"keep",)" + servo + R"(,"name":"limits","values":1})"
            << QStringLiteral("values: expected a list");
    }
    void uselessLinesAreNamed()
    {
        QFETCH(const QByteArray, line);
        QFETCH(const QString, complaint);
        JournalFile(m_path).begin(someIntent(1)).value();
        const QByteArray first = contentOf(m_path);
        overwrite(m_path, first + line + '\n');
        JournalFile journal(m_path);
        const QString last = journal.begin(someIntent(2)).value();

        const auto entries = journal.entries().value();
        QCOMPARE(entries.size(), 2U);
        QCOMPARE(entries[1].intent.uuid, last);
        const auto warnings = journal.warnings();
        QCOMPARE(warnings.size(), 1U);
        QCOMPARE(warnings[0].line, 2);
        QVERIFY2(warnings[0].detail.contains(complaint), qPrintable(warnings[0].detail));
    }

    void unknownFieldsDoNotMatter()
    {
        JournalFile(m_path).begin(someIntent(1)).value();
        overwrite(m_path, contentOf(m_path).replace("\"v\":1", "\"mood\":[1],\"v\":1"));
        const JournalFile journal(m_path);
        QCOMPARE(journal.open().value().size(), 1U);
        QVERIFY(journal.warnings().empty());
    }

    void whatAnotherProgramAppendsIsSeen()
    {
        JournalFile here(m_path);
        JournalFile there(m_path);
        const QString first = here.begin(someIntent(1)).value();
        QCOMPARE(there.open().value().size(), 1U);
        QVERIFY(there.end(first, {QStringLiteral("done"), {}}));
        there.begin(someIntent(2)).value();
        const auto entries = here.entries().value();
        QCOMPARE(entries.size(), 2U);
        QVERIFY(entries[0].end);
    }

    void aReplacedFileIsReadAnew()
    {
        JournalFile journal(m_path);
        journal.begin(someIntent(1)).value();
        QCOMPARE(journal.entries().value().size(), 1U);
        const QString other = m_folder->filePath(QStringLiteral("other"));
        JournalFile restored(other);
        for (int id = 10; id < 15; ++id)
            restored.begin(someIntent(id)).value();
        QVERIFY(QFile::remove(m_path));
        QVERIFY(QFile::rename(other, m_path));
        const auto entries = journal.entries().value();
        QCOMPARE(entries.size(), 5U);
        QCOMPARE(entries[0].intent.servo.id, 10);
    }

    void threadsAppendWholeLines()
    {
        constexpr int threads = 4;
        constexpr int each = 25;
        std::vector<std::thread> writers;
        std::atomic<int> failures{0};
        JournalFile shared(m_path);
        for (int i = 0; i < threads; ++i) {
            writers.emplace_back([this, &failures, &shared, i] {
                JournalFile own(m_path);
                JournalFile& journal = i % 2 == 0 ? own : shared;
                for (int n = 0; n < each; ++n) {
                    const auto uuid = journal.begin(someIntent(n));
                    if (!uuid || !journal.end(*uuid, {QStringLiteral("done"), {}}))
                        ++failures;
                }
            });
        }
        for (std::thread& writer : writers)
            writer.join();
        QCOMPARE(failures, 0);
        const JournalFile journal(m_path);
        QCOMPARE(journal.entries().value().size(), std::size_t(threads * each));
        QVERIFY(journal.open().value().empty());
        QVERIFY(journal.warnings().empty());
    }

    void programsAppendWholeLines()
    {
        constexpr int each = 40;
        std::vector<std::unique_ptr<QProcess>> programs;
        for (int i = 0; i < 3; ++i) {
            programs.push_back(std::make_unique<QProcess>());
            programs.back()->start(QCoreApplication::applicationFilePath(),
                                   {QStringLiteral("append"), m_path, QString::number(each)});
        }
        QSet<QString> promised;
        for (const auto& program : programs) {
            QVERIFY(program->waitForFinished());
            QCOMPARE(program->exitCode(), 0);
            for (const QByteArray& line : program->readAllStandardOutput().trimmed().split('\n'))
                promised.insert(QString::fromLatin1(line));
        }
        const JournalFile journal(m_path);
        QCOMPARE(uuidsIn(journal), promised);
        QCOMPARE(promised.size(), qsizetype(programs.size()) * each);
        QVERIFY(journal.warnings().empty());
    }

    void whatWasPromisedSurvivesBeingKilled()
    {
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(),
                      {QStringLiteral("append"), m_path, QStringLiteral("1000000")});
        QByteArray printed;
        while (printed.count('\n') < 20) {
            QVERIFY(program.waitForReadyRead());
            printed += program.readAllStandardOutput();
        }
        program.kill();
        QVERIFY(program.waitForFinished());
        printed += program.readAllStandardOutput();

        JournalFile journal(m_path);
        const QSet<QString> found = uuidsIn(journal);
        for (const QByteArray& line : printed.left(printed.lastIndexOf('\n')).split('\n'))
            QVERIFY2(found.contains(QString::fromLatin1(line)), line.constData());
        QVERIFY(journal.begin(someIntent()));
    }

    // Cut off at every length of the line: DiskFull, and not a byte of it stays.
    void aFullDiskIsReportedAndLeavesNothing()
    {
        JournalFile journal(m_path);
        journal.begin(someIntent(1)).value();
        const QByteArray before = contentOf(m_path);
        for (qint64 room = 0; room < 50; ++room) {
            const FileSizeLimit limit(before.size() + room);
            const auto begun = journal.begin(someIntent(2));
            QVERIFY(!begun);
            QCOMPARE(int(begun.error().code), int(ErrorCode::DiskFull));
            QVERIFY(begun.error().detail.contains(m_path));
            QCOMPARE(contentOf(m_path), before);
        }
        QVERIFY(journal.begin(someIntent(2)));
        QCOMPARE(journal.open().value().size(), 2U);
        QVERIFY(journal.warnings().empty());
    }

    void whatCannotBeReadIsNeverReplaced_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::newRow("folder") << QStringLiteral("folder");
        QTest::newRow("pipe") << QStringLiteral("pipe");
    }
    void whatCannotBeReadIsNeverReplaced()
    {
        QFETCH(const QString, kind);
        if (kind == QLatin1String("folder"))
            QVERIFY(QDir().mkpath(m_path));
        else
            QCOMPARE(::mkfifo(QFile::encodeName(m_path).constData(), 0600), 0);
        JournalFile journal(m_path);
        const auto entries = journal.entries();
        QVERIFY(!entries);
        QCOMPARE(int(entries.error().code), int(ErrorCode::FileUnreadable));
        QVERIFY(entries.error().detail.contains(m_path));
        QVERIFY(!journal.kept(someServo(), QStringLiteral("limits")));
        const auto begun = journal.begin(someIntent());
        QVERIFY(!begun);
        QVERIFY(begun.error().detail.contains(m_path));
        QVERIFY(QFileInfo::exists(m_path));
        QVERIFY(!QFileInfo(m_path).isFile());
    }

    void anImpossiblePlaceIsNamed()
    {
        overwrite(m_path, "a file, not a folder");
        JournalFile journal(m_path + QStringLiteral("/below/journal.jsonl"));
        const auto begun = journal.begin(someIntent());
        QVERIFY(!begun);
        QCOMPARE(int(begun.error().code), int(ErrorCode::FileUnwritable));
        QVERIFY(begun.error().detail.contains(journal.path()));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

int main(int argc, char* argv[])
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments[1] == QLatin1String("append"))
        return appendIntents(arguments[2], arguments[3].toInt());
    TestJournalFile test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_journal_file.moc"
