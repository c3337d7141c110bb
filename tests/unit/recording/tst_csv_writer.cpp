// SPDX-License-Identifier: GPL-3.0-or-later
// The CSV of `watch`: its exact text, whatever the locale; nothing lost by a crash, a full disk
// said at once.
#include "recording/csv_writer.h"
#include "support/file_size_limit.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QTemporaryDir>
#include <QtTest>

#include <clocale>
#include <limits>

using base::Duration;
using base::ErrorCode;
using recording::CsvWriter;
using support::contentOf;

namespace {
using Row = std::vector<std::optional<double>>;

const std::vector<recording::CsvColumn> columns{
    {QStringLiteral("present_position"), QStringLiteral("deg")},
    {QStringLiteral("present_temperature"), QStringLiteral("°C")},
    {QStringLiteral("moving"), QString()},
};
const QByteArray header = "time_us,id,present_position[deg],present_temperature[°C],moving[]\n";
} // namespace

class TestCsvWriter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("run.csv"));
    }

    void timeStartsAtTheFirstReading()
    {
        const auto writer = CsvWriter::create(m_path, columns).value();
        QVERIFY(writer->write(Duration(5000000), 1, Row{90.0, 31.0, 0.0}));
        QVERIFY(writer->write(Duration(5000000), 2, Row{-179.912109375, 30.0, 1.0}));
        QVERIFY(writer->write(Duration(3605020001), 1, Row{0.087890625, 31.0, 0.0}));
        QCOMPARE(writer->rows(), 3U);
        QCOMPARE(contentOf(m_path), header + "0,1,90,31,0\n"
                                             "0,2,-179.912109375,30,1\n"
                                             "3600020001,1,0.087890625,31,0\n");
    }

    void unmeasuredIsEmpty()
    {
        const auto writer = CsvWriter::create(m_path, columns).value();
        const double notANumber = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(writer->write(Duration(1), 3, Row{std::nullopt, 0.0, std::nullopt}));
        QVERIFY(writer->write(Duration(2), 3, Row{1.5, notANumber, 1.0}));
        QCOMPARE(contentOf(m_path), header + "0,3,,0,\n1,3,1.5,,1\n");
    }

    void numbersDoNotFollowTheLocale()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        std::setlocale(LC_NUMERIC, "");
        const auto writer = CsvWriter::create(m_path, columns).value();
        QVERIFY(writer->write(Duration(0), 1, Row{1234567.25, 3 * 0.1, 1.0}));
        QLocale::setDefault(QLocale::c());
        QCOMPARE(contentOf(m_path), header + "0,1,1234567.25,0.3,1\n");
    }

    void namesWithSeparatorsAreQuoted()
    {
        const auto writer =
            CsvWriter::create(m_path, {{QStringLiteral("a,b"), QStringLiteral("\"")}}).value();
        QCOMPARE(contentOf(m_path), QByteArray("time_us,id,\"a,b[\"\"]\"\n"));
    }

    void anOldFileIsReplaced()
    {
        {
            const auto writer = CsvWriter::create(m_path, columns).value();
            QVERIFY(writer->write(Duration(0), 1, Row{1.0, 2.0, 3.0}));
        }
        QVERIFY(CsvWriter::create(m_path, columns));
        QCOMPARE(contentOf(m_path), header);
    }

    void everyRowIsWrittenAtOnce()
    {
        const auto writer = CsvWriter::create(m_path, columns).value();
        QByteArray expected = header;
        QCOMPARE(contentOf(m_path), expected);
        for (int i = 0; i < 10; ++i) {
            QVERIFY(writer->write(Duration(i), 1, Row{1.0, 2.0, 0.0}));
            expected += QByteArray::number(i) + ",1,1,2,0\n";
            QCOMPARE(contentOf(m_path), expected);
        }
    }

    // Cut off at every length of the row: reported at once, and the file ends with a whole line.
    void aFullDiskIsReportedAtTheRow()
    {
        const auto writer = CsvWriter::create(m_path, columns).value();
        QVERIFY(writer->write(Duration(0), 1, Row{1.0, 2.0, 0.0}));
        const QByteArray before = contentOf(m_path);
        const QByteArray row = "1,1,12.5,2,0\n";
        for (qint64 room = 0; room < row.size(); ++room) {
            const FileSizeLimit limit(before.size() + room);
            const auto written = writer->write(Duration(1), 1, Row{12.5, 2.0, 0.0});
            QVERIFY(!written);
            QVERIFY(written.error().detail.contains(m_path));
            QCOMPARE(contentOf(m_path), before);
        }
        QCOMPARE(writer->rows(), 1U);
        QVERIFY(writer->write(Duration(1), 1, Row{12.5, 2.0, 0.0}));
        QCOMPARE(contentOf(m_path), before + row);
    }

    void aFullDiskIsReportedAtTheHeader()
    {
        const auto writer = CsvWriter::create(QStringLiteral("/dev/full"), columns);
        QVERIFY(!writer);
        QCOMPARE(int(writer.error().code), int(ErrorCode::DiskFull));
        QVERIFY(writer.error().detail.contains(QStringLiteral("/dev/full")));
    }

    void anInvalidPathIsReported_data()
    {
        QTest::addColumn<QString>("below");
        QTest::newRow("folder") << QStringLiteral("/");
        QTest::newRow("missing folder") << QStringLiteral("/no/run.csv");
        QTest::newRow("no name") << QString();
    }
    void anInvalidPathIsReported()
    {
        QFETCH(const QString, below);
        const QString path = below.isEmpty() ? below : m_folder->path() + below;
        const auto writer = CsvWriter::create(path, columns);
        QVERIFY(!writer);
        QCOMPARE(int(writer.error().code), int(ErrorCode::FileUnwritable));
        QVERIFY(writer.error().detail.contains(path));
        QVERIFY(!writer.error().detail.isEmpty());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

SERVODESK_GUILESS_TEST(TestCsvWriter)
#include "tst_csv_writer.moc"
