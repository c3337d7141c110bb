// SPDX-License-Identifier: GPL-3.0-or-later
// Limits files: the built-in ones are chosen by model and series and obey their schema's words,
// what was saved comes back, and no slip of a user's file goes unnoticed, because it could pass a
// bad servo.
#include "results/sweep_limits.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "support/text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using base::ErrorCode;
using results::SweepLimit;
using results::SweepLimits;
using support::contentOf;

namespace {
const QString folder = QStringLiteral(SOURCE_DIR "/resources/limits/");

std::optional<SweepLimit> lineOf(const SweepLimits& limits, const QString& metric)
{
    for (const SweepLimit& line : limits.lines) {
        if (line.metric == metric)
            return line;
    }
    return {};
}

SweepLimits example()
{
    SweepLimits limits;
    limits.name = QStringLiteral("STS3215, \"shop\" 车间");
    limits.models = {QStringLiteral("STS3215"), QStringLiteral("STS")};
    limits.tolerance = 12.5;
    limits.lines = {
        {QStringLiteral("overshoot"), QStringLiteral("%"), 2.1, 4.0, false},
        {QStringLiteral("voltage_min"), QStringLiteral("V"), 6.8, 6.5, true},
        {QStringLiteral("temperature_rise"), QStringLiteral("°C"), {}, 30.0, false},
        {QStringLiteral("mean_speed"), QStringLiteral("step/s"), {}, 900.0, true},
        {QStringLiteral("mean_speed"), QStringLiteral("step/s"), {}, 1200.0, false},
    };
    return limits;
}

/// A file with these lines and otherwise nothing wrong.
QByteArray fileWith(const QByteArray& lines, const QByteArray& more = {})
{
    return R"({"format": "servodesk-limits", "version": 1, "name": "mine",)" + more +
           "\n\"lines\": [\n" + lines + "\n]}";
}
} // namespace

class TestSweepLimits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyFamilyHasItsOwnLimits_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("series");
        QTest::addColumn<double>("restWarn");
        QTest::addColumn<double>("restFail");
        const auto row = [](const char* model, const char* series, double warn, double fail) {
            QTest::newRow(series) << QString::fromLatin1(model) << QString::fromLatin1(series)
                                  << warn << fail;
        };
        row("STS3215", "STS", 8, 16);
        row("SM40BLHV", "SMS", 8, 16);
        row("HLS3606", "HLS", 8, 16);
        row("SM30-360M", "SMCL", 8, 16);
        row("", "SMSMB", 8, 16);
        row("SCS15", "SCS", 4, 7);
        row("SCS15-2", "SCS2", 4, 7);
        row("LX-16A", "LX", 4, 7);
    }
    void everyFamilyHasItsOwnLimits()
    {
        QFETCH(const QString, model);
        QFETCH(const QString, series);
        const SweepLimits limits = results::builtInSweepLimits(model, series);
        QVERIFY(limits.models.contains(series));
        QTEST(lineOf(limits, QStringLiteral("steady_error"))->warn.value(), "restWarn");
        QTEST(lineOf(limits, QStringLiteral("steady_error"))->fail.value(), "restFail");
        QCOMPARE(lineOf(limits, QStringLiteral("overshoot"))->warn.value(), 3.0);
        QCOMPARE(lineOf(limits, QStringLiteral("overshoot"))->fail.value(), 5.0);
    }

    void unknownModelsHaveLimitsWithoutSteps()
    {
        const SweepLimits limits =
            results::builtInSweepLimits(QStringLiteral("Nobody's"), QStringLiteral("NEW"));
        QVERIFY(!limits.name.isEmpty());
        QVERIFY(limits.models.isEmpty());
        QCOMPARE(lineOf(limits, QStringLiteral("missed_targets"))->fail.value(), 0.0);
        QCOMPARE(lineOf(limits, QStringLiteral("alarms"))->fail.value(), 0.0);
        for (const SweepLimit& line : limits.lines)
            QVERIFY2(line.unit != QStringLiteral("step"), qPrintable(line.metric));
    }

    void builtInFilesLoadAndAreListed()
    {
        const QStringList names = QDir(folder).entryList({QStringLiteral("*.json")}, QDir::Files);
        const QString listed = QString::fromUtf8(contentOf(folder + QStringLiteral("limits.qrc")));
        for (const QString& name : names) {
            if (name == QStringLiteral("schema.json"))
                continue;
            const auto limits = results::loadSweepLimits(folder + name);
            QVERIFY2(limits, limits ? "" : qPrintable(limits.error().detail));
            QVERIFY2(listed.contains(u'>' + name + u'<'), qPrintable(name));
        }
        QVERIFY(names.size() >= 5);
    }

    /// What a user writes a file by must name what the reader knows.
    void theSchemaKnowsEveryMetric()
    {
        const QJsonObject schema =
            QJsonDocument::fromJson(contentOf(folder + QStringLiteral("schema.json"))).object();
        const QJsonObject members = schema[QStringLiteral("$defs")]
                                        .toObject()[QStringLiteral("line")]
                                        .toObject()[QStringLiteral("properties")]
                                        .toObject();
        const auto words = [&](const char* member) {
            return members[QLatin1String(member)].toObject()[QStringLiteral("enum")].toArray();
        };
        QStringList keys;
        QByteArray lines;
        for (const results::SweepMetricKind& kind : results::sweepMetricKinds()) {
            keys.append(kind.key);
            QVERIFY2(words("unit").contains(kind.unit), qPrintable(kind.unit));
            lines += (lines.isEmpty() ? "" : ",\n") + QByteArray("{\"metric\": \"") +
                     kind.key.toUtf8() + "\", \"unit\": \"" + kind.unit.toUtf8() +
                     "\", \"fail\": 1}";
        }
        QCOMPARE(words("metric").toVariantList(), QJsonArray::fromStringList(keys).toVariantList());
        const auto limits = results::decodeSweepLimits(fileWith(lines));
        QVERIFY2(limits, limits ? "" : qPrintable(limits.error().detail));
        for (std::size_t i = 0; i < limits->lines.size(); ++i)
            QCOMPARE(limits->lines[i].atLeast, results::sweepMetricKinds()[i].atLeast);
    }

    void saveAndLoadRoundTrip()
    {
        const QTemporaryDir dir;
        const QString path = dir.filePath(QStringLiteral("shop.json"));
        QVERIFY(results::saveSweepLimits(example(), path));
        const auto loaded = results::loadSweepLimits(path);
        QVERIFY2(loaded, loaded ? "" : qPrintable(loaded.error().detail));
        QCOMPARE(*loaded, example());
        QCOMPARE(results::encodeSweepLimits(*loaded), contentOf(path));
    }

    void mistakesAreReported_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("detail");
        const auto row = [](const char* name, const QByteArray& text, const char* detail) {
            QTest::newRow(name) << text << QString::fromUtf8(detail);
        };
        const auto line = [](const char* members) { return fileWith(members); };
        const QByteArray good = R"({"metric": "overshoot", "unit": "%", "fail": 5})";
        row("empty", "", "line 1");
        row("comma forgotten", fileWith(good + '\n' + good), "line 4");
        row("another file", R"({"format": "servodesk-snapshot"})", "format: not a file");
        row("newer", R"({"format": "servodesk-limits", "version": 2})", "version: format 2");
        row("no name", R"({"format": "servodesk-limits", "version": 1, "lines": []})", "name:");
        row("no lines", fileWith(""), "lines: without a line every servo would pass");
        row("slip at the top", fileWith(good, R"("tolerence": 4,)"), "tolerence: unknown name");
        row("no tolerance", fileWith(good, R"("tolerance": 0,)"), "tolerance: must be more");
        row("models no list", fileWith(good, R"("models": "STS",)"), "models: expected a list");
        row("models no texts", fileWith(good, R"("models": ["STS", 3],)"), "models[1]: expected");
        row("slip in a line", line(R"({"metric": "overshoot", "unit": "%", "fial": 5})"),
            "lines[0].fial: unknown name");
        row("no such metric", line(R"({"metric": "overshot", "unit": "%", "fail": 5})"),
            "lines[0].metric: there is no metric \"overshot\"");
        row("another unit", line(R"({"metric": "settling", "unit": "s", "fail": 5})"),
            "lines[0].unit: \"settling\" is in \"ms\", not in \"s\"");
        row("text for number", line(R"({"metric": "overshoot", "unit": "%", "fail": "5"})"),
            "lines[0].fail: expected a number");
        row("nothing to hold", line(R"({"metric": "overshoot", "unit": "%"})"),
            "lines[0].fail: \"overshoot\" has neither warn nor fail");
        row("nulls", line(R"({"metric": "alarms", "unit": "", "warn": null, "fail": null})"),
            "lines[0].fail: \"alarms\" has neither");
        row("negative", line(R"({"metric": "overshoot", "unit": "%", "fail": -5})"),
            "lines[0].fail: must not be negative");
        row("crossed", line(R"({"metric": "overshoot", "unit": "%", "warn": 6, "fail": 5})"),
            "lines[0].warn: \"overshoot\" would fail before it warns");
        row("crossed below",
            line(R"({"metric": "voltage_min", "unit": "V", "warn": 5, "fail": 6})"),
            "lines[0].warn: \"voltage_min\" would fail before it warns");
        row("twice", fileWith(good + ",\n" + good),
            "lines[1].metric: \"overshoot\" is there twice");
        row("no object", line("5"), "lines[0]: expected an object");
    }
    void mistakesAreReported()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, detail);
        const auto limits = results::decodeSweepLimits(text);
        QVERIFY(!limits);
        QCOMPARE(limits.error().code, ErrorCode::FileFormat);
        QVERIFY2(limits.error().detail.contains(detail), qPrintable(limits.error().detail));
    }

    void unreadableFiles()
    {
        const QTemporaryDir dir;
        const QString path = dir.filePath(QStringLiteral("a.json"));
        QCOMPARE(results::loadSweepLimits(path).error().code, ErrorCode::FileMissing);
        QCOMPARE(results::loadSweepLimits(dir.path()).error().code, ErrorCode::FileUnreadable);
        QCOMPARE(results::saveSweepLimits(example(), path + QStringLiteral("/b")).error().code,
                 ErrorCode::FileUnwritable);
        QCOMPARE(results::saveSweepLimits(example(), {}).error().code, ErrorCode::FileUnwritable);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(fileWith(R"({"metric": "x", "unit": "", "fail": 1})"));
        file.close();
        const auto bad = results::loadSweepLimits(path);
        QVERIFY(bad.error().detail.startsWith(path + QStringLiteral(": lines[0].metric")));
    }
};

SERVODESK_GUILESS_TEST(TestSweepLimits)
#include "tst_sweep_limits.moc"
