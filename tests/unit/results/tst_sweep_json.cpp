// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep tests as files: what was written comes back as it was, anybody's JSON reader finds verdict,
// legs and metrics, the CSV says the same, what is wrong with a file is named; and when a run
// counts as passed.
#include "files/csv_line_parser.h"
#include "results/sweep_csv.h"
#include "results/sweep_json.h"
#include "support/file_size_limit.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/results/sweep_example.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using base::ErrorCode;
using results::Grade;
using results::SweepEnd;
using results::SweepRun;
using support::contentOf;

namespace {
QJsonObject parsed(const SweepRun& run)
{
    return QJsonDocument::fromJson(results::encodeSweepRun(run)).object();
}

QJsonArray listOf(const QJsonObject& object, const char* key)
{
    return object[QLatin1String(key)].toArray();
}

QByteArray legsText(const SweepRun& run)
{
    const QTemporaryDir dir;
    const QString path = dir.filePath(QStringLiteral("legs.csv"));
    return results::saveSweepLegs(run, path) ? contentOf(path) : QByteArray();
}

/// The lines of a CSV as cells by name of their column, without its unit.
std::vector<std::map<std::string, std::string>> csvRows(const QByteArray& text)
{
    std::vector<std::map<std::string, std::string>> rows;
    std::vector<std::string> names;
    files::CsvLineParser cells;
    for (const QByteArray& line : text.trimmed().split('\n')) {
        const std::string_view view(line.constData(), std::size_t(line.size()));
        const auto& found = cells.split(view);
        const std::vector<std::string> values(found.begin(), found.end());
        if (names.empty()) {
            names = values;
            for (std::string& name : names)
                name = name.substr(0, name.find('['));
            continue;
        }
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < values.size() && i < names.size(); ++i)
            row[names[i]] = values[i];
    }
    return rows;
}
} // namespace

class TestSweepJson : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void runsRoundTrip()
    {
        const SweepRun run = sweep_example::run();
        const QByteArray text = results::encodeSweepRun(run);
        const auto read = results::decodeSweepRun(text);
        QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
        QVERIFY(*read == run);
        QCOMPARE(results::encodeSweepRun(*read), text);
    }

    void anEmptyRunRoundTrips()
    {
        SweepRun run;
        run.at = QDateTime({2026, 1, 1}, {0, 0}, Qt::UTC);
        run.endedBy = -1;
        const auto read = results::decodeSweepRun(results::encodeSweepRun(run));
        QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
        QVERIFY(*read == run);
        run.servos = {sweep_example::servo(1, "STS3215")};
        run.servos[0].limits = {};
        QVERIFY(results::decodeSweepRun(results::encodeSweepRun(run)).value() == run);
    }

    void saveAndLoadRoundTrip()
    {
        const QTemporaryDir dir;
        const QString path = dir.filePath(QStringLiteral("run.json"));
        const SweepRun run = sweep_example::run(1500); // more than one piece
        QVERIFY(results::saveSweepRun(run, path));
        QCOMPARE(contentOf(path), results::encodeSweepRun(run));
        QVERIFY(results::loadSweepRun(path).value() == run);
    }

    void jsonHasVerdictLegsAndMetrics()
    {
        const SweepRun run = sweep_example::run();
        const QJsonObject json = parsed(run);
        QCOMPARE(json[QStringLiteral("format")].toString(), QStringLiteral("servodesk-sweep"));
        QCOMPARE(json[QStringLiteral("version")].toInt(), 1);
        QCOMPARE(json[QStringLiteral("verdict")].toString(), QStringLiteral("fail"));
        const QJsonArray legs = listOf(json, "legs");
        QCOMPARE(legs.size(), 8);
        const QJsonObject first = legs[0].toObject();
        QCOMPARE(first[QStringLiteral("servo")].toInt(), 5);
        QCOMPARE(first[QStringLiteral("target")].toDouble(), 3051.0);
        QCOMPARE(first[QStringLiteral("reached")].toDouble(), 3047.75);
        QCOMPARE(first[QStringLiteral("time_ms")].toDouble(), 412.352);
        QCOMPARE(first[QStringLiteral("overshoot")].toDouble(), 1.5625);
        QCOMPARE(first[QStringLiteral("settling_ms")].toDouble(), 30.007);
        QCOMPARE(first[QStringLiteral("steady_error")].toDouble(), -3.25);
        const QJsonObject missed = legs[6].toObject();
        QCOMPARE(missed[QStringLiteral("servo")].toInt(), 6);
        QVERIFY(missed[QStringLiteral("time_ms")].isNull());
        QVERIFY(missed[QStringLiteral("overshoot")].isNull());
        QVERIFY(missed[QStringLiteral("missed")].toBool());
        const QJsonArray metrics = listOf(json, "metrics");
        QCOMPARE(metrics.size(), qsizetype(2 * results::sweepMetricKinds().size()));
        const QJsonObject overshoot = metrics[2].toObject();
        QCOMPARE(overshoot[QStringLiteral("metric")].toString(), QStringLiteral("overshoot"));
        QCOMPARE(overshoot[QStringLiteral("unit")].toString(), QStringLiteral("%"));
        QCOMPARE(overshoot[QStringLiteral("value")].toDouble(), 8.0625);
        QCOMPARE(overshoot[QStringLiteral("count")].toInt(), 602);
        QVERIFY(metrics.last().toObject()[QStringLiteral("value")].isNull());
        const QJsonObject servo = listOf(json, "servos")[1].toObject();
        QCOMPARE(servo[QStringLiteral("verdict")].toString(), QStringLiteral("fail"));
        QCOMPARE(listOf(servo, "lines")[0].toObject()[QStringLiteral("grade")].toString(),
                 QStringLiteral("fail"));
    }

    void nanMeansNotMeasured()
    {
        SweepRun run = sweep_example::run();
        run.servos[0].legs[0].overshoot = std::numeric_limits<double>::quiet_NaN();
        const auto read = results::decodeSweepRun(results::encodeSweepRun(run));
        QVERIFY(!read->servos[0].legs[0].overshoot);
        QVERIFY(!legsText(run).isEmpty());
        QCOMPARE(legsText(run), legsText(*read));
    }

    void csvMatchesJson_data()
    {
        QTest::addColumn<int>("legCount");
        QTest::newRow("few legs") << 6;
        QTest::newRow("more than one piece") << 1500;
    }

    void csvMatchesJson()
    {
        QFETCH(int, legCount);
        const SweepRun run = sweep_example::run(legCount);
        const QByteArray text = legsText(run);
        QVERIFY(text.startsWith("servo,leg,cycle,at[ms],span[ms],start[step],target[step],"
                                "time[ms],settling[ms],reached[step],overshoot[%],"));
        const auto rows = csvRows(text);
        const QJsonArray legs = listOf(parsed(run), "legs");
        QCOMPARE(qsizetype(rows.size()), legs.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const QJsonObject leg = legs[qsizetype(i)].toObject();
            QCOMPARE(qsizetype(rows[i].size()), leg.size());
            for (const auto& [name, value] : rows[i]) {
                QString key = QString::fromStdString(name);
                if (!leg.contains(key))
                    key += QStringLiteral("_ms");
                QVERIFY2(leg.contains(key), qPrintable(key));
                const QJsonValue expected = leg[key];
                QCOMPARE(value.empty(), expected.isNull());
                if (!value.empty())
                    QCOMPARE(QString::fromStdString(value).toDouble(),
                             expected.isBool() ? double(expected.toBool()) : expected.toDouble());
            }
        }
        const auto& missed = rows[std::size_t(legCount)];
        QCOMPARE(missed.at("missed"), std::string("1"));
        QCOMPARE(missed.at("alarms"), std::string("36"));
    }

    void mistakesAreReported_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("detail");
        const auto row = [](const char* name, const char* from, const char* to,
                            const char* detail) {
            QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QString::fromUtf8(detail);
        };
        row("another file", "servodesk-sweep", "servodesk-swoop", "format: not a sweep test");
        row("newer", "\"version\": 1,\n  \"verdict\"", "\"version\": 2,\n  \"verdict\"",
            "version: format 2");
        row("no JSON", "\"gaps\": [", "\"gaps\": (", "line 14: ");
        row("end", "\"end\": \"stall\"", "\"end\": \"stale\"", "end: unknown word \"stale\"");
        row("time", "2026-03-09T09", "yesterday", "time: expected a time");
        row("shape", "both-sides", "no-sides", "test.shape: unknown word");
        row("seed", "4294967295", "4294967296", "test.seed: number too large");
        row("gap", "\"at_ms\": 12000", "\"at_ms\": null", "gaps[0].at_ms: expected a number");
        row("span", "\"at_ms\": 12000", "\"at_ms\": 1e30", "gaps[0].at_ms: number too large");
        row("parameters", "\"map\": \"sts-sms\"", "\"map\": \"\"",
            "servos[0].parameters.servo.map: must not be empty");
        row("limits", "\"fail\": 16}", "\"fail\": 7}", "servos[0].limits.lines[1].warn: ");
        row("grade", "\"grade\": \"warn\"", "\"grade\": \"good\"",
            "servos[0].lines[1].grade: unknown word");
        row("count", "\"time_outs\": 21", "\"time_outs\": -1", "servos[0].errors.time_outs: must");
        row("other ID", "\"id\": 6,\n", "\"id\": 7,\n", "servos[1].id: is not the one");
        row("point", "\"points\": [1, 2.5]", "\"points\": [1, true]",
            "servos[0].axis.points[1]: expected a number");
        row("row of nobody", "{\"servo\": 6, \"leg\": 2", "{\"servo\": 9, \"leg\": 2",
            "legs[7].servo: there is no servo 9");
        row("target", "\"target\": 900.5", "\"target\": null", "legs[6].target: expected a number");
        row("alarms", "\"alarms\": 36", "\"alarms\": 256", "legs[6].alarms: expected 0 to 255");
    }
    void mistakesAreReported()
    {
        QFETCH(const QByteArray, from);
        QFETCH(const QByteArray, to);
        QFETCH(const QString, detail);
        QByteArray text = results::encodeSweepRun(sweep_example::run());
        QVERIFY(text.contains(from));
        const auto run = results::decodeSweepRun(text.replace(from, to));
        QVERIFY(!run);
        QCOMPARE(run.error().code, ErrorCode::FileFormat);
        QVERIFY2(run.error().detail.startsWith(detail), qPrintable(run.error().detail));
    }

    /// Cut anywhere, it is refused and nothing else happens.
    void aTruncatedFileIsRefused()
    {
        const QByteArray text = results::encodeSweepRun(sweep_example::run()).trimmed();
        for (qsizetype size = 0; size < text.size(); size += 97)
            QCOMPARE(results::decodeSweepRun(text.left(size)).error().code, ErrorCode::FileFormat);
    }

    void unreadableAndUnwritableFiles()
    {
        const QTemporaryDir dir;
        const QString path = dir.filePath(QStringLiteral("run.json"));
        QCOMPARE(results::loadSweepRun(path).error().code, ErrorCode::FileMissing);
        QVERIFY(results::saveSweepRun(sweep_example::run(1), path));
        const QByteArray before = contentOf(path);
        {
            const FileSizeLimit limit(100000);
            QVERIFY(!results::saveSweepRun(sweep_example::run(1500), path));
        }
        QCOMPARE(contentOf(path), before);
        const QString full = QStringLiteral("/dev/full");
        QCOMPARE(results::saveSweepRun(sweep_example::run(1500), full).error().code,
                 ErrorCode::DiskFull);
        QCOMPARE(results::saveSweepLegs(sweep_example::run(), full).error().code,
                 ErrorCode::DiskFull);
        const QString inside = path + QStringLiteral("/x.json");
        QCOMPARE(results::saveSweepRun(sweep_example::run(), inside).error().code,
                 ErrorCode::FileUnwritable);
        QCOMPARE(results::saveSweepLegs(sweep_example::run(), inside).error().code,
                 ErrorCode::FileUnwritable);
    }

    void theWorstServoDecides_data()
    {
        QTest::addColumn<int>("end");
        QTest::addColumn<QList<int>>("servos");
        QTest::addColumn<int>("verdict");
        const auto row = [](const char* name, SweepEnd end, std::vector<Grade> servos,
                            Grade verdict) {
            QList<int> grades;
            for (const Grade grade : servos)
                grades.append(int(grade));
            QTest::newRow(name) << int(end) << grades << int(verdict);
        };
        using enum Grade;
        row("good", SweepEnd::Finished, {Pass, Pass}, Pass);
        row("warned", SweepEnd::Finished, {Warn, Pass}, Warn);
        row("one failed", SweepEnd::Finished, {Pass, Fail, Warn}, Fail);
        row("one without a verdict", SweepEnd::Finished, {Warn, NotMeasured, Pass}, NotMeasured);
        row("a failure stands", SweepEnd::Finished, {NotMeasured, Fail}, Fail);
        row("nobody", SweepEnd::Finished, {}, NotMeasured);
        row("stopped by the user", SweepEnd::Stopped, {Pass}, NotMeasured);
        row("stopped, failed before", SweepEnd::Stopped, {Fail}, Fail);
        row("stop key", SweepEnd::Emergency, {Warn}, NotMeasured);
        row("unplugged", SweepEnd::LinkLost, {Pass}, NotMeasured);
        row("alarm", SweepEnd::Alarm, {Pass, Pass}, Fail);
        row("stall", SweepEnd::Stall, {NotMeasured}, Fail);
        row("First failure", SweepEnd::Failure, {Pass}, Fail);
    }
    void theWorstServoDecides()
    {
        QFETCH(const int, end);
        QFETCH(const QList<int>, servos);
        SweepRun run;
        run.end = SweepEnd(end);
        for (const int grade : servos) {
            run.servos.emplace_back();
            run.servos.back().verdict = Grade(grade);
        }
        QTEST(int(run.verdict()), "verdict");
    }
};

SERVODESK_GUILESS_TEST(TestSweepJson)
#include "tst_sweep_json.moc"
