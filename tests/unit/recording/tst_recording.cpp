// SPDX-License-Identifier: GPL-3.0-or-later
// The text of recordings: read back it is what was recorded, to the last bit; cut off or edited by
// hand it never says what was not measured.
#include "recording/recording.h"
#include "recording/recording_text.h"
#include "support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

#include <bit>
#include <clocale>
#include <cmath>
#include <random>

using base::Duration;
using base::ErrorCode;
using recording::Mark;
using recording::MarkKind;
using recording::RecordingFormat;
using recording::RecordingHeader;
using recording::RecordingRow;
using recording::SamplePoint;
using recording::SampleStore;
using recording::TimeSpan;

namespace {
const double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr TimeSpan always{Duration(-1'000'000'000'000), Duration(1'000'000'000'000)};

/// Two servos with one ID, and their channels mixed.
RecordingHeader demoHead()
{
    const auto channel = [](int servo, int id, const char* name, const char* protocol,
                            const char* key, const char* unit) {
        return recording::RecordingChannel{servo,
                                           id,
                                           QString::fromUtf8(name),
                                           QString::fromUtf8(protocol),
                                           QString::fromUtf8(key),
                                           QString::fromUtf8(unit)};
    };
    RecordingHeader head;
    head.started = QDateTime(QDate(2026, 11, 21), QTime(22, 19, 57, 123), Qt::UTC);
    head.program = QStringLiteral("ServoDesk 0.1.0");
    head.port = QStringLiteral("/dev/tty, \"one\"");
    head.baud = 1000000;
    head.simulated = true;
    head.channels = {channel(7, 1, "STS3215", "feetech", "present_position", "deg"),
                     channel(9, 1, "LX-16A", "lx", "position", "°"),
                     channel(7, 1, "STS3215", "feetech", "present_temperature", "°C"),
                     channel(9, 1, "LX-16A", "lx", "odd,\"key\"\\", ""),
                     channel(7, 1, "STS3215", "feetech", "error", "deg")};
    return head;
}

std::string textOf(RecordingFormat format, const std::vector<RecordingRow>& rows,
                   const std::vector<Mark>& marks = {})
{
    const recording::RecordingFormatter text(format, demoHead());
    std::string out = text.head();
    for (const RecordingRow& row : rows)
        text.row(row.at, row, out);
    for (const Mark& mark : marks)
        text.mark(mark.at, mark, out);
    return out;
}

std::vector<RecordingRow> demoRows()
{
    return {{Duration(0), 7, {90, 31, 0.5}},
            {Duration(1200), 9, {-12.5, 4}},
            {Duration(5000), 7, {nothing, 31, -0.25}},
            {Duration(6200), 9, {nothing, nothing}},
            {Duration(11200), 9, {3, nothing}}};
}

const std::vector<Mark> demoMarks{
    {Duration(3), MarkKind::Write, 1, QStringLiteral("position_p 32 → 40, \"quoted\"")},
    {Duration(4), MarkKind::Note, -1, QStringLiteral("two\nlines\\n \r")},
    {Duration(5), MarkKind::LinkError, 1, QString()}};

bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The same rows by plain means: samples of each channel, and those with a gap before.
struct Expected {
    std::vector<std::vector<SamplePoint>> points;
    std::vector<std::vector<Duration>> gapsBefore;

    explicit Expected(const std::vector<RecordingRow>& rows)
    {
        const auto head = demoHead();
        points.resize(head.channels.size());
        gapsBefore.resize(head.channels.size());
        std::vector<bool> gap(head.channels.size());
        for (const RecordingRow& row : rows) {
            std::size_t i = 0;
            const bool answered = std::any_of(row.values.begin(), row.values.end(),
                                              [](double value) { return !std::isnan(value); });
            for (std::size_t c = 0; c < head.channels.size(); ++c) {
                if (head.channels[c].servo != row.servo)
                    continue;
                const double value = row.values[i++];
                if (!answered)
                    gap[c] = true;
                if (std::isnan(value))
                    continue;
                points[c].push_back({row.at, value});
                if (gap[c])
                    gapsBefore[c].push_back(row.at);
                gap[c] = false;
            }
        }
    }
};

void verifySamples(const SampleStore& store, const std::vector<int>& ids, const Expected& expected)
{
    QCOMPARE(ids.size(), expected.points.size());
    for (std::size_t c = 0; c < ids.size(); ++c) {
        const auto points = store.points(ids[c], always);
        QCOMPARE(points.size(), expected.points[c].size());
        std::vector<Duration> gaps;
        for (std::size_t i = 0; i < points.size(); ++i) {
            QCOMPARE(points[i].at, expected.points[c][i].at);
            QVERIFY(same(points[i].value, expected.points[c][i].value));
            if (i > 0 && points[i].at > points[i - 1].at + Duration(1) &&
                !store.at(ids[c], points[i].at - Duration(1)))
                gaps.push_back(points[i].at);
        }
        QCOMPARE(gaps, expected.gapsBefore[c]);
    }
}
} // namespace

class TestRecording : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    base::StopToken m_stop;

    QString put(const QString& name, const std::string& text)
    {
        const QString path = m_folder->filePath(name);
        QFile::remove(path); // overwriting would wait for the disk each time
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) ||
            file.write(text.data(), qint64(text.size())) != qint64(text.size()))
            qFatal("no room for a test");
        return path;
    }

    base::Result<recording::LoadedRecording> load(const std::string& text, SampleStore& store)
    {
        return recording::loadRecording(put(QStringLiteral("run"), text), store, m_stop);
    }

    static void formats()
    {
        QTest::addColumn<RecordingFormat>("format");
        QTest::newRow("CSV") << RecordingFormat::Csv;
        QTest::newRow("JSON lines") << RecordingFormat::JsonLines;
    }

private Q_SLOTS:
    void initTestCase() { m_folder = std::make_unique<QTemporaryDir>(); }
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theExactText()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        std::setlocale(LC_ALL, "");
        const std::string csv = textOf(RecordingFormat::Csv, demoRows(), demoMarks);
        const std::string json = textOf(RecordingFormat::JsonLines, demoRows(), demoMarks);
        QLocale::setDefault(QLocale::c());
        QCOMPARE(
            QByteArray::fromStdString(csv),
            QByteArray("# ServoDesk recording 1\n"
                       "# started 2026-11-21T22:19:57.123Z\n"
                       "# program ServoDesk 0.1.0\n"
                       "# port /dev/tty, \"one\"\n"
                       "# baud 1000000\n"
                       "# simulated yes\n"
                       "# servo 1 7 1 feetech STS3215\n"
                       "# servo 1' 9 1 lx LX-16A\n"
                       "time_us,servo,1.present_position[deg],1'.position[°],"
                       "1.present_temperature[°C],\"1'.odd,\"\"key\"\"\\\\[]\",1.error[deg],marks\n"
                       "0,1,90,,31,,0.5,\n"
                       "1200,1',,-12.5,,4,,\n"
                       "5000,1,,,31,,-0.25,\n"
                       "6200,1',,,,,,\n"
                       "11200,1',,3,,,,\n"
                       "3,,,,,,,\"write 1 position_p 32 → 40, \"\"quoted\"\"\"\n"
                       "4,,,,,,,note - two\\nlines\\\\n \\r\n"
                       "5,,,,,,,link-error 1 \n"));
        const QList<QByteArray> lines = QByteArray::fromStdString(json).split('\n');
        QCOMPARE(lines.size(), 10);
        QCOMPARE(lines[1], QByteArray("{\"t\":0,\"s\":7,\"v\":[90,31,0.5]}"));
        QCOMPARE(lines[4], QByteArray("{\"t\":6200,\"s\":9,\"v\":[null,null]}"));
    }

    void roundTrips_data() { formats(); }
    void roundTrips()
    {
        QFETCH(RecordingFormat, format);
        std::mt19937_64 random(17);
        std::vector<RecordingRow> rows;
        Duration at{};
        for (int i = 0; i < 30000; ++i) {
            at += Duration(std::int64_t(random() % 5000) + 2);
            const bool first = random() % 2 == 0;
            RecordingRow row{at, first ? 7 : 9, {}};
            const bool silent = random() % 50 == 0;
            for (int c = 0; c < (first ? 3 : 2); ++c) {
                double value = std::bit_cast<double>(random()); // any number there is
                if (random() % 2 == 0)
                    value = double(random() % 4096) * 360 / 4096;
                row.values.push_back(silent || !std::isfinite(value) || random() % 20 == 0 ? nothing
                                                                                           : value);
            }
            rows.push_back(row);
        }
        SampleStore store;
        store.open(); // somebody else's
        double progress = 0;
        const auto path = put(QStringLiteral("run"), textOf(format, rows, demoMarks));
        const auto loaded = recording::loadRecording(path, store, m_stop, [&](double share) {
            QVERIFY(share >= progress);
            progress = share;
        });
        QVERIFY(loaded);
        QCOMPARE(progress, 1.0);
        QCOMPARE(loaded->ids.front(), 1);
        QCOMPARE(loaded->head.channels, demoHead().channels);
        QCOMPARE(loaded->head.started, demoHead().started);
        QCOMPARE(loaded->head.program, demoHead().program);
        QCOMPARE(loaded->head.port, demoHead().port);
        QCOMPARE(loaded->head.baud, 1000000);
        QVERIFY(loaded->head.simulated);
        QCOMPARE(loaded->marks, demoMarks);
        QCOMPARE(loaded->report.rows, rows.size());
        QCOMPARE(loaded->report.badLines, 0U);
        QVERIFY(!loaded->report.isTruncated);
        QCOMPARE(loaded->report.span, (TimeSpan{rows.front().at, rows.back().at}));
        verifySamples(store, loaded->ids, Expected(rows));
    }

    // At every byte: what is whole is read, what is not is said, and nothing is made up.
    void truncatedAnywhere_data() { formats(); }
    void truncatedAnywhere()
    {
        QFETCH(RecordingFormat, format);
        const auto rows = demoRows();
        const std::string text = textOf(format, rows, demoMarks);
        const std::size_t headSize = textOf(format, {}).size();
        for (std::size_t size = 0; size <= text.size(); ++size) {
            SampleStore store;
            const auto loaded = load(text.substr(0, size), store);
            QCOMPARE(loaded.has_value(), size >= headSize);
            if (!loaded) {
                QCOMPARE(loaded.error().code, ErrorCode::FileFormat);
                QVERIFY(!store.span());
                continue;
            }
            const std::string whole = text.substr(headSize, size - headSize);
            const auto lines = std::size_t(std::count(whole.begin(), whole.end(), '\n'));
            QCOMPARE(loaded->report.isTruncated, !whole.empty() && whole.back() != '\n');
            QCOMPARE(loaded->report.badLines, 0U);
            QCOMPARE(loaded->report.rows, std::min(lines, rows.size()));
            QCOMPARE(loaded->marks.size(), lines - loaded->report.rows);
            verifySamples(store, loaded->ids,
                          Expected({rows.begin(), rows.begin() + qint64(loaded->report.rows)}));
            if (QTest::currentTestFailed())
                return;
        }
    }

    void aLineEditedByHand_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("bad");
        const auto row = [](const char* name, const char* line, int rows, int bad) {
            QTest::newRow(name) << QByteArray(line) << rows << bad;
        };
        // The demo head has 5 channels: 8 cells.
        row("good", "20000,1,1,,2,,3,", 1, 0);
        row("blanks", " 20000 , 1 , 1 ,, 2,, 3 ,", 1, 0);
        row("quoted", "\"20000\",\"1\",\"1\",,2,,3,", 1, 0);
        row("commas too many", "20000,1,1,,2,,3,,,,", 1, 0);
        row("value too many", "20000,1,1,,2,,3,,5", 0, 1);
        row("too short", "20000,1,1,,2", 0, 1);
        row("word", "20000,1,one,,2,,3,", 0, 1);
        row("number with a tail", "20000,1,1x,,2,,3,", 0, 1);
        row("not a number", "20000,1,nan,,2,,3,", 0, 1);
        row("infinite", "20000,1,inf,,2,,3,", 0, 1);
        row("too large", "20000,1,1e999,,2,,3,", 0, 1);
        row("hexadecimal", "20000,1,0x10,,2,,3,", 0, 1);
        row("time is no number", "soon,1,1,,2,,3,", 0, 1);
        row("no time", ",1,1,,2,,3,", 0, 1);
        row("time with a fraction", "20000.5,1,1,,2,,3,", 0, 1);
        row("time of a spreadsheet", "2.00E+04,1,1,,2,,3,", 0, 1);
        row("time out of this world", "9223372036854775807,1,1,,2,,3,", 0, 1);
        row("time too long for a number", "92233720368547758070000,1,1,,2,,3,", 0, 1);
        row("time gone back", "4999,1,1,,2,,3,", 0, 1);
        row("unknown servo", "20000,5,1,,2,,3,", 0, 1);
        row("values of nobody", "20000,,1,,2,,3,", 0, 1);
        row("values of another servo", "20000,1,1,7,2,,3,", 0, 1);
        row("nothing", "", 0, 0);
        row("nothing but commas", "20000,,,,,,,", 0, 0);
        row("remark", "# seen at noon", 0, 0);
        row("unknown mark", "20000,,,,,,,hello 1 there", 0, 1);
        row("mark of nobody", "20000,,,,,,,note", 0, 1);
        row("semicolons", "20000;1;1;;2;;3;", 0, 1);
        row("open quote", "20000,1,\"1,,2,,3,", 0, 1);
    }
    void aLineEditedByHand()
    {
        QFETCH(QByteArray, line);
        const std::string text =
            textOf(RecordingFormat::Csv, demoRows()) + line.toStdString() + "\n";
        SampleStore store;
        const auto loaded = load(text, store);
        QVERIFY(loaded);
        QTEST(int(loaded->report.rows) - 5, "rows");
        QTEST(int(loaded->report.badLines), "bad");
        QCOMPARE(store.points(loaded->ids[1], always).size(), 2U);
    }

    void aJsonLineEditedByHand_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("bad");
        const auto row = [](const char* name, const char* line, int rows, int bad) {
            QTest::newRow(name) << QByteArray(line) << rows << bad;
        };
        row("good", R"({"t":20000,"s":7,"v":[1,2,null]})", 1, 0);
        row("blanks", R"(  { "t" : 20000, "v": [1, 2, null], "s":7 } )", 1, 0);
        row("more fields", R"({"t":20000,"s":7,"v":[1,2,3],"why":"me"})", 1, 0);
        row("too few values", R"({"t":20000,"s":7,"v":[1,2]})", 0, 1);
        row("too many values", R"({"t":20000,"s":7,"v":[1,2,3,4]})", 0, 1);
        row("text", R"({"t":20000,"s":7,"v":[1,2,"3"]})", 0, 1);
        row("no values", R"({"t":20000,"s":7})", 0, 1);
        row("unknown servo", R"({"t":20000,"s":8,"v":[1,2,3]})", 0, 1);
        row("no time", R"({"s":7,"v":[1,2,3]})", 0, 1);
        row("time with a fraction", R"({"t":2.5,"s":7,"v":[1,2,3]})", 0, 1);
        row("time out of this world", R"({"t":9223372036854775807,"s":7,"v":[1,2,3]})", 0, 1);
        row("time gone back", R"({"t":10,"s":7,"v":[1,2,3]})", 0, 1);
        row("infinite", R"({"t":20000,"s":7,"v":[1,2,inf]})", 0, 1);
        row("not a number", R"({"t":20000,"s":7,"v":[1,2,nan]})", 0, 1);
        row("too large", R"({"t":20000,"s":7,"v":[1,2,1e999]})", 0, 1);
        row("tail", R"({"t":20000,"s":7,"v":[1,2,3]}})", 0, 1);
        row("list", "[1,2]", 0, 1);
        row("words", "hello", 0, 1);
        row("nothing", "", 0, 0);
        row("unknown mark", R"({"t":20000,"mark":"hello","id":1,"text":""})", 0, 1);
    }
    void aJsonLineEditedByHand()
    {
        QFETCH(QByteArray, line);
        const std::string text =
            textOf(RecordingFormat::JsonLines, demoRows()) + line.toStdString() + "\n";
        SampleStore store;
        const auto loaded = load(text, store);
        QVERIFY(loaded);
        QTEST(int(loaded->report.rows) - 5, "rows");
        QTEST(int(loaded->report.badLines), "bad");
    }

    // As a spreadsheet program writes it: BOM, CRLF, '#' lines padded, a column moved and one
    // added.
    void savedByASpreadsheetProgram()
    {
        const std::string text = "\xEF\xBB\xBF# ServoDesk recording 1,,,,\r\n"
                                 "# started 2026-11-21T22:19:57.123Z,,,,\r\n"
                                 "\"# port one, two\",,,,\r\n"
                                 "# baud 500000,,,,\r\n"
                                 ",,,,\r\n"
                                 "# servo 3 2 3 feetech STS 3215,,,,\r\n"
                                 "servo,3.load[%],my remark,time_us,3.speed[rpm]\r\n"
                                 "3,5,\"good, very\",100,7\r\n"
                                 "3,,,200,8\r\n";
        SampleStore store;
        const auto loaded = load(text, store);
        QVERIFY(loaded);
        QCOMPARE(loaded->head.port, QStringLiteral("one, two"));
        QCOMPARE(loaded->head.baud, 500000);
        QCOMPARE(loaded->head.channels.size(), 2U);
        QCOMPARE(loaded->head.channels[1].servoName, QStringLiteral("STS 3215"));
        QCOMPARE(loaded->head.channels[1].servoId, 3);
        QCOMPARE(loaded->head.channels[1].key, QStringLiteral("speed"));
        QCOMPARE(loaded->report.rows, 2U);
        QCOMPARE(loaded->report.badLines, 0U);
        QCOMPARE(store.points(loaded->ids[0], always),
                 (std::vector<SamplePoint>{{Duration(100), 5}}));
        QCOMPARE(store.points(loaded->ids[1], always),
                 (std::vector<SamplePoint>{{Duration(100), 7}, {Duration(200), 8}}));
    }

    void anUnusableHeader_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("detail");
        const QByteArray title = "# ServoDesk recording 1\n";
        const QByteArray servo = title + "# servo 1 0 1 feetech STS3215\n";
        const auto row = [](const char* name, const QByteArray& text, const char* detail) {
            QTest::newRow(name) << text << QByteArray(detail);
        };
        row("empty", "", "line 1: the file is empty");
        row("other CSV", "time,a,b\n1,2,3\n", "line 1: no recording");
        row("CSV of watch", "time_us,id,present_position[deg]\n0,1,2\n", "line 1: no recording");
        row("picture", QByteArray("\x89PNG\r\n\x1a\n\0\0\0", 11), "line 1: no recording");
        row("newer", "# ServoDesk recording 2\ntime_us,servo,1.a[]\n", "line 1: format version 2");
        row("version", "# ServoDesk recording one\n", "line 1: no recording");
        row("no columns", servo, "line 3: the file ends within its head");
        row("semicolons", servo + "time_us;servo;1.a[deg];marks\n", "line 3: the columns are not");
        row("no time", servo + "servo,1.a[deg],marks\n", "line 3: no column \"time_us\"");
        row("no servo", servo + "time_us,1.a[deg],marks\n", "line 3: no column \"servo\"");
        row("no channel", servo + "time_us,servo,marks\n", "line 3: no column of a servo");
        row("servo not named", title + "time_us,servo,1.a[deg],marks\n",
            "line 2: no column of a servo");
        row("endless line", "# ServoDesk recording 1" + QByteArray(3 << 20, ' ') + "\n",
            "line 1: no recording");
        row("JSON", "{}\n", "line 1: no recording");
        row("broken JSON", "{\"format\":\n", "line 1:");
        const QByteArray json = "{\"format\":\"servodesk-recording\",\"version\":";
        row("JSON newer", json + "2}\n", "line 1: format version 2");
        row("JSON no channels",
            json + "1,\"started\":\"\",\"program\":\"\",\"port\":\"\",\"baud\":1,"
                   "\"simulated\":false,\"channels\":[]}\n",
            "line 1: channels: none");
        row("JSON wrong kind",
            json + "1,\"started\":\"\",\"program\":\"\",\"port\":\"\",\"baud\":\"fast\","
                   "\"simulated\":false,\"channels\":[]}\n",
            "line 1: baud");
    }
    void anUnusableHeader()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, detail);
        SampleStore store;
        const auto loaded = load(text.toStdString(), store);
        QVERIFY(!loaded);
        QCOMPARE(loaded.error().code, ErrorCode::FileFormat);
        QVERIFY2(loaded.error().detail.contains(QString::fromUtf8(detail)),
                 qPrintable(loaded.error().detail));
        QVERIFY(loaded.error().detail.contains(m_folder->path()));
        QVERIFY(!store.span());
    }

    void aVeryLongLineIsInvalid()
    {
        SampleStore store;
        const auto loaded = load(textOf(RecordingFormat::Csv, demoRows()) +
                                     std::string(5 << 20, '1') + "\n20000,1,1,,2,,3,\n",
                                 store);
        QVERIFY(loaded);
        QCOMPARE(loaded->report.badLines, 1U);
        QCOMPARE(loaded->report.rows, 6U);
    }

    // Bytes changed, put in and taken out anywhere: never a crash, and what is loaded is in order.
    void edited_data() { formats(); }
    void edited()
    {
        QFETCH(RecordingFormat, format);
        const std::string text = textOf(format, demoRows(), demoMarks);
        std::mt19937 random(23);
        const std::string likely = ",;\"#\n\r.-+e{}[]:019n \\\0\xFF";
        for (int round = 0; round < 3000; ++round) {
            std::string broken = text;
            for (unsigned edits = random() % 4 + 1; edits > 0; --edits) {
                const std::size_t at = random() % broken.size();
                const char byte =
                    random() % 4 == 0 ? char(random()) : likely[random() % likely.size()];
                switch (random() % 4) {
                case 0:
                    broken[at] = byte;
                    break;
                case 1:
                    broken.insert(at, 1, byte);
                    break;
                case 2:
                    broken.erase(at, random() % 5);
                    break;
                default:
                    broken.insert(at, broken.substr(random() % broken.size(), random() % 40));
                }
            }
            SampleStore store;
            const auto loaded = load(broken, store);
            if (!loaded) {
                QCOMPARE(loaded.error().code, ErrorCode::FileFormat);
                QVERIFY(!store.span());
                continue;
            }
            QCOMPARE(loaded->ids.size(), loaded->head.channels.size());
            QCOMPARE(store.outOfOrder(), 0U);
            const auto lines = std::count(broken.begin(), broken.end(), '\n');
            QVERIFY(qint64(loaded->report.rows + loaded->report.badLines) <= lines);
        }
    }

    void noise()
    {
        std::mt19937 random(29);
        for (int round = 0; round < 500; ++round) {
            std::string bytes = round % 2 == 0 ? textOf(RecordingFormat::Csv, {})
                                               : textOf(RecordingFormat::JsonLines, {});
            if (round % 5 == 0)
                bytes.clear();
            for (unsigned i = random() % 3000; i > 0; --i)
                bytes += char(random());
            SampleStore store;
            const auto loaded = load(bytes, store);
            QVERIFY(!store.span());
            QVERIFY(loaded || loaded.error().code == ErrorCode::FileFormat);
        }
    }

    void nonRecordingFiles()
    {
        SampleStore store;
        const auto code = [&](const QString& path) {
            const auto loaded = recording::loadRecording(path, store, m_stop);
            return loaded ? ErrorCode::Stopped : loaded.error().code;
        };
        QCOMPARE(code(m_folder->filePath(QStringLiteral("no.csv"))), ErrorCode::FileMissing);
        QCOMPARE(code(m_folder->path()), ErrorCode::FileUnreadable);
        QCOMPARE(code(QStringLiteral("/dev/zero")), ErrorCode::FileUnreadable);
        QCOMPARE(code(QString()), ErrorCode::FileMissing);
    }

    void stopped()
    {
        std::vector<RecordingRow> rows;
        for (int i = 0; i < 200'000; ++i)
            rows.push_back({Duration(i), 7, {1, 2, 3}});
        SampleStore store;
        base::StopToken stop;
        int calls = 0;
        const auto path = put(QStringLiteral("run"), textOf(RecordingFormat::Csv, rows));
        const auto loaded = recording::loadRecording(path, store, stop, [&](double) {
            ++calls;
            stop.request();
        });
        QVERIFY(!loaded);
        QCOMPARE(loaded.error().code, ErrorCode::Stopped);
        QCOMPARE(calls, 1);
        QVERIFY(!store.span());
        QCOMPARE(store.bytes(), 0U);
    }

    void theFormatByFileName()
    {
        QCOMPARE(recording::recordingFormatOf(QStringLiteral("a.csv")), RecordingFormat::Csv);
        QCOMPARE(recording::recordingFormatOf(QStringLiteral("a.JSONL")),
                 RecordingFormat::JsonLines);
        QCOMPARE(recording::recordingFormatOf(QStringLiteral("jsonl")), RecordingFormat::Csv);
    }
};

SERVODESK_GUILESS_TEST(TestRecording)
#include "tst_recording.moc"
