// SPDX-License-Identifier: GPL-3.0-or-later
// The report page: well-formed, with every figure of the run, text from users escaped, both
// languages complete, nothing to be fetched; long runs are shortened and charts decimated without
// losing the extremes.
#include "report/sweep_html.h"
#include "report/sweep_text.h"
#include "results/sweep_verdict.h"
#include "support/test_main.h"
#include "unit/results/sweep_example.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include <cmath>

namespace {
using report::ChartSample;
using report::SweepSeries;
using sweep_example::written;

std::vector<SweepSeries> exampleSeries(int readings = 900)
{
    SweepSeries series;
    series.servo = 5;
    for (int i = 0; i < readings; ++i)
        series.samples.push_back(
            {i * 0.01, 2000 + 1000 * std::sin(i * 0.02), i < 450 ? 3051. : 1000.});
    series.samples[300].position = std::numeric_limits<double>::quiet_NaN();
    return {series};
}

/// The page as seen in one language: its style sheet hides elements of the class of the other one.
/// Also the error in its XML, and the names of its elements.
struct PageFacts {
    QString text;
    QString error;
    QSet<QString> elements;
    QStringList fetched; ///< what an attribute would load
    int charts = 0;
};

PageFacts read(const QByteArray& page, const QString& hiddenClass = {})
{
    PageFacts seen;
    QXmlStreamReader xml(page);
    int hidden = 0;
    int depth = 0;
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        if (token == QXmlStreamReader::StartElement) {
            ++depth;
            const QString name = xml.name().toString();
            seen.elements.insert(name);
            seen.charts += name == QStringLiteral("svg") ? 1 : 0;
            const bool hides = (!hiddenClass.isEmpty() &&
                                xml.attributes().value(QStringLiteral("class")) == hiddenClass) ||
                               name == QStringLiteral("style");
            if (hidden == 0 && hides)
                hidden = depth;
            for (const QXmlStreamAttribute& attribute : xml.attributes()) {
                const bool loads =
                    QStringList{QStringLiteral("src"), QStringLiteral("href")}.contains(
                        attribute.name().toString());
                if (loads && !attribute.value().startsWith(QStringLiteral("data:")))
                    seen.fetched.append(attribute.value().toString());
                if (attribute.name().startsWith(QStringLiteral("on")))
                    seen.fetched.append(attribute.name().toString());
            }
        } else if (token == QXmlStreamReader::EndElement) {
            if (hidden == 0)
                seen.text += u' ';
            hidden = hidden == depth ? 0 : hidden;
            --depth;
        } else if (token == QXmlStreamReader::Characters && hidden == 0) {
            seen.text += xml.text();
        }
    }
    seen.error = xml.hasError()
                     ? xml.errorString() + QStringLiteral(" in line %1").arg(xml.lineNumber())
                     : QString();
    return seen;
}

bool containsChinese(const QString& text)
{
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    return text.contains(han);
}
} // namespace

class TestSweepHtml : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void thePageIsSelfContained()
    {
        for (const bool chinese : {false, true}) {
            const QByteArray page =
                report::sweepHtml(sweep_example::run(), exampleSeries(), chinese);
            const PageFacts seen = read(page);
            QVERIFY2(seen.error.isEmpty(), qPrintable(seen.error));
            QCOMPARE(seen.fetched, QStringList());
            QVERIFY(!seen.elements.contains(QStringLiteral("script")));
            QVERIFY(!seen.elements.contains(QStringLiteral("img")));
            QCOMPARE(page.count("url("), page.count("url(data:font/"));
            QVERIFY(!page.contains("@import"));
            QCOMPARE(seen.charts, 2); // servo 6 has no measurements
            const QByteArray open = chinese ? "lang-zh" : "lang-en";
            QVERIFY(page.contains("id=\"" + open + "\" checked=\"checked\""));
            QCOMPARE(page.count("checked=\"checked\""), 1);
        }
    }

    void everyMetricIsPresent()
    {
        const results::SweepRun run = sweep_example::run();
        const QString text =
            read(report::sweepHtml(run, exampleSeries(), false), QStringLiteral("zh")).text;
        const auto has = [&](const QString& what) {
            const bool found = text.contains(what);
            if (!found)
                qInfo() << "missing" << what;
            return found;
        };
        for (const results::SweepMetric& metric : run.servos[0].metrics) {
            QVERIFY(has(report::metricLabel(metric.key).en));
            for (const auto& value : {metric.value, metric.mean, metric.min, metric.max})
                QVERIFY(has(written(*value)));
            QVERIFY(has(QString::number(metric.count)));
        }
        for (const results::SweepLeg& leg : run.servos[0].legs) {
            for (const results::LegFigure& figure : results::legFigures) {
                const QString key = QString::fromLatin1(figure.key);
                const bool shown =
                    !QStringList{QStringLiteral("overshoot_steps"), QStringLiteral("top_speed"),
                                 QStringLiteral("current_mean"), QStringLiteral("load_mean")}
                         .contains(key);
                const double value = *(leg.*figure.member);
                QVERIFY(!shown ||
                        has(key == QLatin1String("reached") ? QString::number(value, 'f', 1)
                                                            : written(value)));
            }
            QVERIFY(has(written(*results::inMs(leg.timeToTarget))));
            QVERIFY(has(written(*results::inMs(leg.settling))));
        }
        for (const char* fact : {"✘ Fail",
                                 "⚠ Warn",
                                 "SIMULATED",
                                 "STS3215",
                                 "SCS15",
                                 "3.10",
                                 "2026-03-09 09:00:01 UTC",
                                 "/dev/ttyUSB0, 1000000 baud",
                                 "601.2 s",
                                 "398.8 /s",
                                 "ServoDesk 0.1.0",
                                 "stalled before reaching its goal",
                                 "Ended by servo",
                                 "ID 6",
                                 "1000 … 268.1deg",
                                 "100 … 900",
                                 "middle of the range from both directions",
                                 "30rpm",
                                 "60 s",
                                 "torque off",
                                 "the first failure",
                                 "above 8 step",
                                 "9.75 step",
                                 "> 16",
                                 "above 0 moves",
                                 "4096 steps a turn, built in",
                                 "gear backlash beyond the encoder",
                                 "not measured",
                                 "min_angle",
                                 "512",
                                 "12345",
                                 "21",
                                 "32",
                                 "43",
                                 "54",
                                 "2.5",
                                 "moving flag error",
                                 "temperature, overload",
                                 "goal missed"})
            QVERIFY(has(QString::fromUtf8(fact)));
    }

    void bothLanguagesAreComplete()
    {
        // Texts of users would count as the other language.
        results::SweepRun run = sweep_example::run();
        run.spec.note = QStringLiteral("-");
        const QByteArray page = report::sweepHtml(run, exampleSeries(), false);
        const QString english = read(page, QStringLiteral("zh")).text;
        const QString body = english.mid(english.indexOf(QStringLiteral("Sweep test report"), 20));
        QVERIFY(!containsChinese(QString(body).remove(QStringLiteral("中文"))));
        const QString chinese = read(page, QStringLiteral("en")).text;
        for (const char* fact :
             {"扫描测试报告", "✘ 不合格", "模拟", "不包含编码器之后的齿轮间隙", "高于 8 步",
              "每圈 4096 步（内置）", "未测量", "过温、过载", "双向到达行程范围中间", "卸力"})
            QVERIFY2(chinese.contains(QString::fromUtf8(fact)), fact);
        // Every span of one language has its neighbor in the other.
        static const QRegularExpression spans(
            QStringLiteral("<(t?span) class=\"en\" lang=\"en\">([^<]*)</\\1>"
                           "<\\1 class=\"zh\" lang=\"zh\">([^<]*)</\\1>"));
        const QString markup = QString::fromUtf8(page);
        int pairs = 0;
        for (auto it = spans.globalMatch(markup); it.hasNext(); ++pairs) {
            const auto match = it.next();
            QVERIFY(!match.captured(2).isEmpty() && !match.captured(3).isEmpty());
            QVERIFY2(containsChinese(match.captured(3)), qPrintable(match.captured(3)));
        }
        QVERIFY(pairs > 150);
        QCOMPARE(markup.count(QStringLiteral("class=\"en\"")), pairs);
        QCOMPARE(markup.count(QStringLiteral("class=\"zh\"")), pairs);
    }

    void registersHaveTheirNames()
    {
        results::SweepRun run = sweep_example::run();
        snapshot::Snapshot& table = run.servos[0].parameters;
        table.servo.map = QStringLiteral("sts-sms");
        table.servo.model = QStringLiteral("STS (9.99)"); // the map has the names, not the model
        table.registers[0].key = QStringLiteral("position_p");
        table.registers[0].area = catalog::Area::Feedback;
        table.registers[0].unit = QStringLiteral("degC");
        table.servo.protocol = QStringLiteral("feetech");
        const QByteArray page = report::sweepHtml(run, exampleSeries(), false);
        const QString english = read(page, QStringLiteral("zh")).text;
        const QString chinese = read(page, QStringLiteral("en")).text;
        QVERIFY(english.contains(QStringLiteral("Position loop P")));
        QVERIFY(english.contains(QStringLiteral("feedback")));
        QVERIFY(english.contains(QStringLiteral("Feetech")));
        QVERIFY(chinese.contains(QStringLiteral("飞特")));
        QVERIFY(english.contains(QStringLiteral("°C")) &&
                !english.contains(QStringLiteral("degC")));
        QVERIFY(chinese.contains(QStringLiteral("P 比例系数")));
        QVERIFY(!english.contains(QStringLiteral("position_p")));
        QVERIFY(!english.contains(QStringLiteral("FEEDBACK")));
        table.servo.map = QStringLiteral("lx");
        table.registers[0].key = QStringLiteral("angle_limit_max");
        QVERIFY(!report::sweepHtml(run, exampleSeries(), false).contains("angle_limit_max"));
        table.registers[0].key = QStringLiteral("my_register"); // of a map of the user's own
        QVERIFY(report::sweepHtml(run, exampleSeries(), false).contains("my_register"));
    }

    /// In every column of a table, whether or not their unit has the same text in both languages.
    void numbersAreRightAligned()
    {
        const QString page =
            QString::fromUtf8(report::sweepHtml(sweep_example::run(), exampleSeries(), false));
        // Tables of names and values have no column of numbers.
        static const QRegularExpression left(
            QStringLiteral("(?<!</th>)<td>(<(?!/td)[^>]*>)*-?\\d[^<]*"));
        const auto match = left.match(page);
        QVERIFY2(!match.hasMatch(), qPrintable(match.captured()));
        QVERIFY(page.contains(QStringLiteral("<td class=\"n\" align=\"right\">&gt; 16<")));
    }

    void userTextIsEscaped()
    {
        results::SweepRun run = sweep_example::run();
        const QString hostileText = QStringLiteral("<b onclick=\"x\">&'%1%2</b>");
        run.spec.shape = results::SweepShape::Points;
        run.spec.points = {{hostileText, {}}};
        run.spec.speed = run.spec.acceleration = run.spec.time = hostileText;
        run.spec.operatorName = hostileText + QChar(1) + QChar(0xd800) + QChar(0xffff);
        run.port = run.program = hostileText;
        run.servos[0].parameters.servo = {5,           hostileText, hostileText,
                                          hostileText, hostileText, hostileText};
        run.servos[0].parameters.registers[0].key = hostileText;
        run.servos[0].parameters.registers[0].unit = hostileText;
        run.servos[0].limits.name = hostileText;
        run.servos[0].lines[0].limit.metric = run.servos[0].lines[0].limit.unit = hostileText;
        run.servos[0].metrics[0].key = run.servos[0].metrics[0].unit = hostileText;
        const QByteArray page = report::sweepHtml(run, exampleSeries(), false);
        const PageFacts seen = read(page, QStringLiteral("zh"));
        QVERIFY2(seen.error.isEmpty(), qPrintable(seen.error));
        QVERIFY(!page.contains("<b ") && !page.contains("<script") && !page.contains("<img"));
        QVERIFY(seen.text.count(hostileText) >= 16);
        QVERIFY(seen.text.contains(sweep_example::hostileNote));
        QVERIFY(seen.text.contains(sweep_example::hostileLabel));
    }

    /// A value that fails is not shown as equal to its limit.
    void roundingHidesNoVerdict()
    {
        results::SweepRun run = sweep_example::run();
        results::VerdictLine& line = run.servos[0].lines[0];
        line.grade = results::Grade::Fail;
        line.value = 1000.4;
        line.limit.fail = 1000;
        const QString page =
            read(report::sweepHtml(run, exampleSeries(), false), QStringLiteral("zh")).text;
        QCOMPARE(page.count(QStringLiteral("1000.4 ")), 3); // summary, servo, table
        QCOMPARE(report::figure(1000.4, {1000., std::nullopt}), QStringLiteral("1000.4"));
        QCOMPARE(report::figure(12.54, {12.52, 20.}), QStringLiteral("12.54"));
        QCOMPARE(report::figure(12.54, {8., 16.}), QStringLiteral("12.5"));
        QCOMPARE(report::figure(8., {8., 16.}), QStringLiteral("8"));
        QCOMPARE(report::figure(0.0553), QStringLiteral("0.06"));
        QCOMPARE(report::figure(158.6), QStringLiteral("158.6"));
        QCOMPARE(report::figure(1391.2), QStringLiteral("1391"));
        QCOMPARE(report::figure(-0.001), QStringLiteral("0"));
    }

    void aCorrectFlagIsNoRemark()
    {
        results::SweepRun run = sweep_example::run();
        run.servos.pop_back();
        run.servos[0].metrics.clear();
        for (const std::optional<bool> flag : {std::optional<bool>(), std::optional<bool>(false)}) {
            run.servos[0].legs[0].flagWrong = flag;
            QVERIFY(!report::sweepHtml(run, {}, false).contains("moving flag error"));
        }
        run.servos[0].legs[0].flagWrong = true;
        QVERIFY(report::sweepHtml(run, {}, false).contains("moving flag error"));
    }

    void everyEndHasText()
    {
        using results::SweepEnd;
        QSet<QString> english;
        for (int end = 0; !results::sweepEndName(SweepEnd(end)).isEmpty(); ++end) {
            const catalog::Text words = report::endText(SweepEnd(end));
            QVERIFY(!words.en.isEmpty() && containsChinese(words.zh));
            QVERIFY2(!english.contains(words.en), qPrintable(words.en));
            english.insert(words.en);
        }
        QVERIFY(english.size() >= 8);
        for (const results::SweepMetricKind& kind : results::sweepMetricKinds())
            QVERIFY2(containsChinese(report::metricLabel(kind.key).zh), qPrintable(kind.key));
    }

    void builtInLimitsAreNamedInBothLanguages()
    {
        for (const char* series : {"STS", "SCS", "LX", "?"}) {
            const results::SweepLimits limits =
                results::builtInSweepLimits({}, QString::fromLatin1(series));
            const catalog::Text name = report::limitsName(limits.name);
            QCOMPARE(name.en, limits.name);
            QVERIFY2(containsChinese(name.zh), series);
        }
        QCOMPARE(report::limitsName(QStringLiteral("shop")).zh, QStringLiteral("shop"));
        QCOMPARE(report::limitsName(QStringLiteral("STS3215, custom")).zh,
                 QStringLiteral("STS3215（自定）"));
    }

    void longRunsAreShortened()
    {
        results::SweepRun run = sweep_example::run(1000);
        run.servos[0].legs[500].steadyError = -444.44; // leg 501
        run.servos[0].legs[600].missed = true;
        const QByteArray page = report::sweepHtml(run, exampleSeries(), false);
        const QString text = read(page, QStringLiteral("zh")).text;
        QVERIFY(text.contains(QStringLiteral("1000 moves in total")));
        QVERIFY(text.contains(QStringLiteral("-444.4")));
        QVERIFY(page.size() < 400000);
        const auto shown = report::legsToShow(run.servos[0].legs);
        QCOMPARE(shown.size(), std::size_t(120));
        const auto numbers = [&](std::size_t i) { return shown[i]->number; };
        QCOMPARE(numbers(0), 1);
        QCOMPARE(numbers(49), 50);
        QCOMPARE(numbers(70), 951);
        QCOMPARE(numbers(119), 1000);
        int worst = 0;
        for (std::size_t i = 50; i < 70; ++i)
            worst += numbers(i) == 501 || numbers(i) == 601 ? 1 : 0;
        QCOMPARE(worst, 2);
        QVERIFY(std::is_sorted(shown.begin(), shown.end(),
                               [](auto* a, auto* b) { return a->number < b->number; }));
        QCOMPARE(report::legsToShow(sweep_example::run(200).servos[0].legs).size(),
                 std::size_t(200));
        QVERIFY(!report::sweepHtml(sweep_example::run(200), {}, false).contains("Of 200 legs"));
    }

    void decimatedLinesKeepTheirExtremes()
    {
        std::vector<ChartSample> samples;
        for (int i = 0; i < 100000; ++i)
            samples.push_back({i * 0.001, std::sin(i * 0.01), 0});
        samples[77777].position = 40;
        samples[33333].position = -30;
        const auto kept = report::decimated(samples, 2000);
        QVERIFY(kept.size() <= 2000);
        const auto has = [&](double value) {
            return std::any_of(kept.begin(), kept.end(),
                               [&](const ChartSample& one) { return one.position == value; });
        };
        QVERIFY(has(40) && has(-30));
        QVERIFY(
            std::is_sorted(kept.begin(), kept.end(), [](auto& a, auto& b) { return a.t < b.t; }));
        QCOMPARE(report::decimated(exampleSeries()[0].samples, 2000).size(), std::size_t(900));
        const QString chart =
            report::positionChart(report::HtmlWriter(report::ReportLanguage::English), samples);
        QVERIFY(chart.size() < 100000);
    }

    /// Even if all figures are within their limits.
    void aStoppedRunNeverPasses()
    {
        results::SweepRun run = sweep_example::run();
        run.servos.resize(1);
        for (results::VerdictLine& line : run.servos[0].lines)
            line.grade = results::Grade::Pass;
        run.end = results::SweepEnd::Stopped;
        results::assignVerdicts(run);
        const PageFacts seen = read(report::sweepHtml(run, {}, false));
        QVERIFY(seen.text.contains(QStringLiteral("– No verdict")));
        QVERIFY(seen.text.contains(QStringLiteral("✔ OK")));
        QVERIFY(!seen.text.contains(QStringLiteral("✔ Pass")));
    }

    void nearlyEmptyRuns()
    {
        results::SweepRun run;
        const PageFacts noViewer = read(report::sweepHtml(run, {}, false), QStringLiteral("zh"));
        QVERIFY2(noViewer.error.isEmpty(), qPrintable(noViewer.error));
        QVERIFY(noViewer.text.contains(QStringLiteral("– No verdict")));
        run = sweep_example::run(1);
        run.servos[0].legs[0].steadyError = 0;
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const std::vector<ChartSample>& samples : {std::vector<ChartSample>{},
                                                        {{0, 5, 5}},
                                                        {{0, nan, nan}, {1, nan, nan}},
                                                        {{0, 1e9, 1e9}, {0, 1e9, 1e9}}}) {
            const QByteArray page = report::sweepHtml(run, {{5, samples}}, false);
            QVERIFY(read(page).error.isEmpty());
            QVERIFY(!page.contains("nan") && !page.contains("inf\""));
        }
        run.servos[0].legs[0].steadyError = 1e7; // far beyond any scale
        QVERIFY(read(report::sweepHtml(run, {}, false)).error.isEmpty());
    }

    void saveErrorsAreReported()
    {
        const QTemporaryDir dir;
        const QString path = dir.filePath(QStringLiteral("report.html"));
        const results::SweepRun run = sweep_example::run();
        QVERIFY(report::saveSweepHtml(run, exampleSeries(), true, path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), report::sweepHtml(run, exampleSeries(), true));
        QCOMPARE(report::saveSweepHtml(run, {}, true, path + QStringLiteral("/x")).error().code,
                 base::ErrorCode::FileUnwritable);
    }
};

SERVODESK_GUILESS_TEST(TestSweepHtml)
#include "tst_sweep_html.moc"
