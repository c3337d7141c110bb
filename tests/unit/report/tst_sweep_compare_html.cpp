// SPDX-License-Identifier: GPL-3.0-or-later
// The page that compares two tests: well-formed, self-contained, names what cannot be compared,
// escapes text from users; and the lines about a reference servo.
#include "report/sweep_compare_html.h"
#include "report/sweep_compare_text.h"
#include "report/sweep_text.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/results/sweep_example.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

using results::SweepRun;
using support::utf8;

namespace {
QByteArray pageOf(const SweepRun& a, const SweepRun& b, bool chinese = false)
{
    return report::sweepCompareHtml({utf8("run <12>"), a, a.servos[0]},
                                    {utf8("b.json"), b, b.servos[0]}, chinese);
}

/// All text of the page, or the error in its XML.
QString readPage(const QByteArray& page, int* charts = nullptr)
{
    QXmlStreamReader xml(page);
    QString words;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && charts && xml.name() == utf8("svg"))
            ++*charts;
        if (xml.isStartElement() &&
            (xml.name() == utf8("script") || xml.attributes().hasAttribute(utf8("src"))))
            return utf8("it would load something");
        if (xml.isCharacters())
            words += xml.text().toString() + QLatin1Char(' ');
    }
    return xml.hasError() ? xml.errorString() : words;
}
} // namespace

class TestSweepCompareHtml : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void onePageInTwoLanguages();
    void incomparableIsReported();
    void everyTextIsPresent();
    void theReferenceAsText();
    void saves();
};

void TestSweepCompareHtml::onePageInTwoLanguages()
{
    const SweepRun a = sweep_example::run();
    SweepRun b = a;
    b.servos[0].parameters.registers[0].raw = 600;
    b.servos[0].metrics[2].value = 2.5; // overshoot, 8.0625 before
    int charts = 0;
    const QString words = readPage(pageOf(a, b), &charts);
    QVERIFY2(words.contains(utf8("run <12>")), qPrintable(words));
    QCOMPARE(charts, 2);
    for (const char* part :
         {"Comparison of two sweep tests", "两次扫描测试对比", "8.06", "2.5", "−5.56", "min_angle",
          "600", "512", "Both tests used the same settings."})
        QVERIFY2(words.contains(utf8(part)), part);
    QVERIFY(words.contains(sweep_example::hostileLabel));
    QVERIFY(pageOf(a, b, true).contains("id=\"lang-zh\" checked=\"checked\""));
    QVERIFY(pageOf(a, b, false).contains("id=\"lang-en\" checked=\"checked\""));
}

void TestSweepCompareHtml::incomparableIsReported()
{
    const SweepRun a = sweep_example::run();
    SweepRun b = a;
    b.servos[0].axis.to = 2000;
    b.servos[0].limits.lines.clear();
    b.spec.shape = results::SweepShape::Sine;
    b.end = results::SweepEnd::Alarm;
    const QString words = readPage(pageOf(a, b));
    const report::CompareTexts& own = report::compareTexts();
    for (const report::Text& warning : {own.notComparable, own.someDiffer, own.gradesDiffer}) {
        QVERIFY(words.contains(warning.en));
        QVERIFY(words.contains(warning.zh));
    }
    QVERIFY(words.contains(utf8("1000 … 2000")));
    QVERIFY(words.contains(report::shapeText(results::SweepShape::Sine).zh));
    QVERIFY(words.contains(report::endText(results::SweepEnd::Alarm).en));
}

void TestSweepCompareHtml::everyTextIsPresent()
{
    for (int item = 0; item <= int(results::TestItem::End); ++item) {
        const report::Text words = report::testItemText(results::TestItem(item));
        QVERIFY(!words.en.isEmpty() && !words.zh.isEmpty());
        const report::Text none = report::testValueText(results::TestItem(item), QString());
        QVERIFY(!none.en.isEmpty() && !none.zh.isEmpty());
    }
    const report::Text limits = report::testValueText(
        results::TestItem::Limits, QStringLiteral("4096 steps a turn, built in (2)"));
    QCOMPARE(limits.en, QStringLiteral("4096 steps a turn, built in (2)"));
    QCOMPARE(limits.zh, QStringLiteral("每圈 4096 步（内置）（2）"));
}

void TestSweepCompareHtml::theReferenceAsText()
{
    const SweepRun reference = sweep_example::run();
    SweepRun run = reference;
    const auto set = [](SweepRun& into, const char* key, double value) {
        for (results::SweepMetric& metric : into.servos[0].metrics) {
            if (metric.key == utf8(key))
                metric.value = value;
        }
    };
    SweepRun before = reference;
    set(before, "hysteresis", 4);
    set(run, "hysteresis", 9);
    set(before, "time_to_target", 400);
    set(run, "time_to_target", 300);
    set(before, "overshoot", 5);
    set(run, "overshoot", 5.2); // within the usual variation
    const auto lines = report::referenceLines(
        results::compareSweeps({{}, before, before.servos[0]}, {{}, run, run.servos[0]}));
    QCOMPARE(lines.size(), std::size_t(2));
    QCOMPARE(lines[0].en, utf8("Hysteresis, both directions +5 step (worse)"));
    QCOMPARE(lines[0].zh, utf8("回差（双向） +5 步（更差）"));
    QCOMPARE(lines[1].en, utf8("Time to goal −100 ms (better)"));
}

void TestSweepCompareHtml::saves()
{
    const QTemporaryDir dir;
    const SweepRun run = sweep_example::run();
    const results::SweepSide side{utf8("1"), run, run.servos[0]};
    const QString path = dir.filePath(utf8("c.html"));
    QVERIFY(report::saveSweepCompareHtml(side, side, false, path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), report::sweepCompareHtml(side, side, false));
    QCOMPARE(report::saveSweepCompareHtml(side, side, false, dir.path()).error().code,
             base::ErrorCode::FileUnwritable);
}

SERVODESK_GUILESS_TEST(TestSweepCompareHtml)
#include "tst_sweep_compare_html.moc"
