// SPDX-License-Identifier: GPL-3.0-or-later
// Recording while rows come in: nothing that was taken is missing, the file is on the disk while it
// grows, and a full disk or a vanished folder ends it with a message and a file of whole lines.
#include "recording/recorder.h"
#include "support/file_size_limit.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QTemporaryDir>
#include <QtTest>

#include <thread>

using base::Duration;
using base::ErrorCode;
using recording::Mark;
using recording::MarkKind;
using recording::Recorder;
using recording::RecorderSpec;
using recording::RecordingFormat;
using recording::RecordingRow;
using recording::SampleStore;
using support::contentOf;

namespace {
constexpr Duration period{5000};
constexpr recording::TimeSpan wholeSpan{Duration(0), std::chrono::hours(1000)};

RecorderSpec specFor(const QString& path)
{
    RecorderSpec spec;
    spec.path = path;
    spec.format = recording::recordingFormatOf(path);
    spec.head.started = QDateTime(QDate(2026, 11, 21), QTime(12, 0), Qt::UTC);
    for (int servo = 0; servo < 2; ++servo) {
        for (const char* key : {"present_position", "present_load"})
            spec.head.channels.push_back({servo, servo + 1, QStringLiteral("STS3215"),
                                          QStringLiteral("feetech"), QString::fromUtf8(key),
                                          QStringLiteral("deg")});
    }
    return spec;
}

RecordingRow rowAt(int i)
{
    return {std::chrono::hours(7) + period * i, i % 2, {i * 0.1, double(-i)}};
}

std::vector<RecordingRow> rows(int from, int to)
{
    std::vector<RecordingRow> some;
    for (int i = from; i < to; ++i)
        some.push_back(rowAt(i));
    return some;
}

/// Offers until it is taken, as a feeder does that may wait.
void feed(Recorder& recorder, std::vector<RecordingRow> some, std::vector<Mark> marks = {})
{
    while (!recorder.tryWrite(some, marks))
        std::this_thread::yield();
}

recording::LoadedRecording loaded(const QString& path, SampleStore& store)
{
    const base::StopToken stop;
    auto found = recording::loadRecording(path, store, stop);
    if (!found)
        qFatal("%s", qPrintable(found.error().detail));
    return *found;
}
} // namespace

class TestRecorder : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;

    void verifyRows(const QString& path, int count)
    {
        SampleStore store;
        const auto recording = loaded(path, store);
        QCOMPARE(recording.report.rows, std::uint64_t(count));
        QCOMPARE(recording.report.badLines, 0U);
        QVERIFY(!recording.report.isTruncated);
        std::vector<std::vector<recording::SamplePoint>> expected(4);
        for (int i = 0; i < count; ++i) {
            const RecordingRow row = rowAt(i);
            for (std::size_t c = 0; c < 2; ++c)
                expected[std::size_t(row.servo) * 2 + c].push_back({period * i, row.values[c]});
        }
        for (std::size_t c = 0; c < 4; ++c)
            QCOMPARE(store.points(recording.ids[c], wholeSpan), expected[c]);
    }

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("run.csv"));
    }

    void recordedRowsAreInTheFile_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("CSV") << QStringLiteral("run.csv");
        QTest::newRow("JSON lines") << QStringLiteral("run.jsonl");
    }
    void recordedRowsAreInTheFile()
    {
        QFETCH(QString, name);
        const QString path = m_folder->filePath(name);
        const auto recorder = Recorder::start(specFor(path)).value();
        QVERIFY(!recorder->status().ended);
        QCOMPARE(recorder->spec().path, path);
        for (int i = 0; i < 30000; i += 100)
            feed(*recorder, rows(i, i + 100));
        recorder->stop();
        QTRY_VERIFY(recorder->status().ended);
        const auto status = recorder->status();
        QVERIFY(!status.error);
        QCOMPARE(status.rows, 30000U);
        QCOMPARE(status.lost, 0U);
        QCOMPARE(status.elapsed, period * 29999);
        QCOMPARE(status.bytes, std::uint64_t(contentOf(path).size()));
        verifyRows(path, 30000);
    }

    void theFileGrowsDuringRecording()
    {
        const auto recorder = Recorder::start(specFor(m_path)).value();
        QVERIFY(contentOf(m_path).contains("time_us,servo,"));
        feed(*recorder, rows(0, 10));
        QTRY_COMPARE(recorder->status().rows, 10U);
        verifyRows(m_path, 10);
        feed(*recorder, rows(10, 11));
        QTRY_COMPARE(recorder->status().rows, 11U);
        verifyRows(m_path, 11);
    }

    void destructionFlushesPendingRows()
    {
        {
            const auto recorder = Recorder::start(specFor(m_path)).value();
            feed(*recorder, rows(0, 60000));
        }
        verifyRows(m_path, 60000);
    }

    void anOldFileIsReplaced()
    {
        for (int i = 0; i < 2; ++i) {
            const auto recorder = Recorder::start(specFor(m_path)).value();
            feed(*recorder, rows(0, 1000 - 900 * i));
        }
        verifyRows(m_path, 100);
    }

    void marksAreAtTheirTime()
    {
        const Mark first{rowAt(3).at - Duration(1), MarkKind::Write, 1, QStringLiteral("a, b")};
        const Mark last{rowAt(9).at + Duration(1), MarkKind::Stop, -1, QString()};
        {
            const auto recorder = Recorder::start(specFor(m_path)).value();
            feed(*recorder, rows(0, 10), {first, last});
        }
        SampleStore store;
        const auto recording = loaded(m_path, store);
        QCOMPARE(recording.marks.size(), 2U);
        QCOMPARE(recording.marks[0].at, period * 3 - Duration(1));
        QCOMPARE(recording.marks[0].text, first.text);
        QCOMPARE(recording.marks[1].kind, MarkKind::Stop);
        QList<QByteArray> lines = contentOf(m_path).trimmed().split('\n');
        while (!lines.front().startsWith("time_us"))
            lines.removeFirst();
        lines.removeFirst();
        std::vector<qint64> times;
        for (const QByteArray& line : lines)
            times.push_back(line.split(',').front().toLongLong());
        QCOMPARE(times.size(), 12U);
        QVERIFY(std::is_sorted(times.begin(), times.end()));
    }

    void endsAtItsLength()
    {
        RecorderSpec spec = specFor(m_path);
        spec.length = std::chrono::seconds(1);
        const auto recorder = Recorder::start(spec).value();
        feed(*recorder, rows(0, 150));
        QTRY_COMPARE(recorder->status().rows, 150U);
        QVERIFY(!recorder->status().ended);
        feed(*recorder, rows(150, 300), {{rowAt(250).at, MarkKind::Note, 1, QString()}});
        QTRY_VERIFY(recorder->status().ended);
        QVERIFY(!recorder->status().error);
        QCOMPARE(recorder->status().rows, 200U); // a second at 200 Hz
        QCOMPARE(recorder->status().lost, 0U);
        feed(*recorder, rows(300, 400)); // is taken, and nobody waits for it
        QCOMPARE(recorder->status().rows, 200U);
        verifyRows(m_path, 200);
    }

    // Also when nobody answers any more.
    void endsAtItsLengthWithoutRows()
    {
        RecorderSpec spec = specFor(m_path);
        spec.length = std::chrono::seconds(1);
        const auto recorder = Recorder::start(spec).value();
        recorder->advanceTo(rowAt(0).at - period); // has not begun
        feed(*recorder, rows(0, 10));
        recorder->advanceTo(rowAt(199).at);
        QTRY_COMPARE(recorder->status().rows, 10U);
        QVERIFY(!recorder->status().ended);
        recorder->advanceTo(rowAt(200).at);
        QTRY_VERIFY(recorder->status().ended);
        QVERIFY(!recorder->status().error);
        verifyRows(m_path, 10);
    }

    // What waits is bounded. Refused means: nothing was taken.
    void aBatchWithoutSpaceIsRefused()
    {
        const auto recorder = Recorder::start(specFor(m_path)).value();
        // Many milliseconds of work, then at once a few rows more: they find no room, unless this
        // thread was kept waiting between the two. (A loop over one size went on past what the
        // store keeps without thinning whenever the disk was faster than the loop.)
        constexpr int many = int(Recorder::maxPending) * 2;
        constexpr int few = 1000;
        std::vector<Mark> marks;
        std::vector<RecordingRow> refused;
        int taken = 0;
        while (refused.empty()) {
            QVERIFY(taken < 3'000'000); // the store keeps that many without thinning
            auto first = rows(taken, taken + many);
            auto second = rows(taken + many, taken + many + few);
            feed(*recorder, std::move(first));
            taken += many;
            if (recorder->tryWrite(second, marks)) {
                QVERIFY(second.empty());
                taken += few;
            }
            refused = std::move(second);
        }
        QCOMPARE(refused.size(), std::size_t(few));
        recorder->lost(refused.size());
        recorder->stop();
        QTRY_VERIFY(recorder->status().ended);
        QCOMPARE(recorder->status().rows, std::uint64_t(taken));
        QCOMPARE(recorder->status().lost, refused.size());
        verifyRows(m_path, taken);
    }

    void aBatchLargerThanTheBufferIsWritten()
    {
        const auto recorder = Recorder::start(specFor(m_path)).value();
        feed(*recorder, rows(0, int(Recorder::maxPending) * 2));
        QTRY_COMPARE(recorder->status().rows, std::uint64_t(Recorder::maxPending * 2));
    }

    void rowsOfUnknownChannelsAreDropped()
    {
        const auto recorder = Recorder::start(specFor(m_path)).value();
        auto some = rows(0, 2);
        some.push_back({rowAt(3).at, 17, {1, 2}});
        feed(*recorder, some);
        recorder->stop();
        QTRY_VERIFY(recorder->status().ended);
        QCOMPARE(recorder->status().rows, 2U);
        QCOMPARE(recorder->status().lost, 1U);
        verifyRows(m_path, 2);
    }

    // Room for one byte more each time: it stops, says so, and the file ends with a whole line.
    void aFullDisk()
    {
        qint64 whole = 0;
        {
            const auto recorder = Recorder::start(specFor(m_path)).value();
            whole = contentOf(m_path).size();
        }
        for (qint64 room = 0; room < 60; ++room) {
            const FileSizeLimit limit(whole + room);
            const auto recorder = Recorder::start(specFor(m_path)).value();
            feed(*recorder, rows(0, 20));
            QTRY_VERIFY(recorder->status().ended);
            const auto status = recorder->status();
            QVERIFY(status.error);
            QCOMPARE(status.error->code, ErrorCode::DiskFull);
            QVERIFY(status.error->detail.contains(m_path));
            QCOMPARE(status.rows + status.lost, 20U);
            const QByteArray content = contentOf(m_path);
            QVERIFY(content.endsWith('\n'));
            QVERIFY(content.size() <= whole + room);
            QCOMPARE(status.bytes, std::uint64_t(content.size()));
            verifyRows(m_path, int(status.rows));
            // As much as found room is there.
            const QByteArray next = QByteArray::number(qint64(status.rows) * period.count());
            QVERIFY(content.size() + next.size() + 4 + 12 > whole + room);
            feed(*recorder, rows(20, 25));
            QCOMPARE(recorder->status().lost, 25 - status.rows);
        }
    }

    void aFullDiskFromTheStart()
    {
        const auto recorder = Recorder::start(specFor(QStringLiteral("/dev/full")));
        QVERIFY(!recorder);
        QCOMPARE(recorder.error().code, ErrorCode::DiskFull);
        const FileSizeLimit limit(10);
        const auto other = Recorder::start(specFor(m_path));
        QVERIFY(!other);
        QCOMPARE(other.error().code, ErrorCode::DiskFull);
        QCOMPARE(contentOf(m_path), QByteArray());
    }

    void anInvalidPath()
    {
        for (const QString& path : {QString(), QStringLiteral("/"), m_folder->path(),
                                    m_folder->filePath(QStringLiteral("no/run.csv"))}) {
            const auto recorder = Recorder::start(specFor(path));
            QVERIFY(!recorder);
            QCOMPARE(recorder.error().code, ErrorCode::FileUnwritable);
        }
        RecorderSpec empty = specFor(m_path);
        empty.head.channels.clear();
        QCOMPARE(Recorder::start(empty).error().code, ErrorCode::BadArgument);
        QVERIFY(!QFile::exists(m_path));
    }

    void theFileIsDeleted_data()
    {
        QTest::addColumn<int>("how");
        QTest::addColumn<QString>("words");
        QTest::newRow("deleted") << 0 << QStringLiteral("deleted or moved away");
        QTest::newRow("moved away") << 1 << QStringLiteral("deleted or moved away");
        QTest::newRow("folder deleted") << 2 << QStringLiteral("folder is gone");
        QTest::newRow("replaced") << 3 << QStringLiteral("another file");
        QTest::newRow("changed") << 4 << QStringLiteral("another program");
    }
    // Without a row coming in, too: whoever watches must not believe that it is being recorded.
    void theFileIsDeleted()
    {
        QFETCH(int, how);
        QFETCH(QString, words);
        const auto recorder = Recorder::start(specFor(m_path)).value();
        feed(*recorder, rows(0, 10));
        QTRY_COMPARE(recorder->status().rows, 10U);
        const QString other = m_folder->filePath(QStringLiteral("other"));
        if (how == 0)
            QVERIFY(QFile::remove(m_path));
        else if (how == 1 || how == 3)
            QVERIFY(QFile::rename(m_path, other));
        else if (how == 2)
            QVERIFY(m_folder->remove());
        if (how >= 3) {
            QFile file(m_path);
            QVERIFY(file.open(QIODevice::Append));
            file.write("hello\n");
        }
        QTRY_VERIFY(recorder->status().ended);
        const auto status = recorder->status();
        QVERIFY(status.error);
        QCOMPARE(status.error->code, ErrorCode::FileUnwritable);
        QVERIFY2(status.error->detail.contains(words), qPrintable(status.error->detail));
        QVERIFY(status.error->detail.contains(m_path));
        if (how == 1 || how == 3)
            verifyRows(other, 10);
    }

    // Rows from one thread, questions from another, and an end in the middle of it.
    void stoppedDuringInput()
    {
        const auto recorder = Recorder::start(specFor(m_path)).value();
        std::uint64_t taken = 0;
        std::thread feeder([&] {
            for (int i = 0; !recorder->status().ended; i += 50) {
                feed(*recorder, rows(i, i + 50));
                taken += 50;
            }
        });
        while (recorder->status().rows < 2000)
            std::this_thread::yield();
        recorder->stop();
        feeder.join();
        const auto status = recorder->status();
        QVERIFY(!status.error);
        QVERIFY(status.rows <= taken);
        QCOMPARE(status.lost, 0U);
        verifyRows(m_path, int(status.rows));
    }
};

SERVODESK_GUILESS_TEST(TestRecorder)
#include "tst_recorder.moc"
