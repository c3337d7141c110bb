// SPDX-License-Identifier: GPL-3.0-or-later
// The report as PDF, read by another program (poppler): the figures of the HTML page in both
// languages, charts as images, embedded fonts, nothing cut off at the right. Only Chinese fonts are
// installed, which Qt would then use for everything.
#include "report/sweep_pdf.h"
#include "report/sweep_text.h"
#include "support/font_config.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "unit/results/sweep_example.h"

#include <QGuiApplication>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace {
std::vector<report::SweepSeries> exampleSeries()
{
    report::SweepSeries series;
    series.servo = 5;
    for (int i = 0; i < 900; ++i)
        series.samples.push_back({i * 0.01, 2000 + 1000 * std::sin(i * 0.02), 2000});
    return {series};
}

QString outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished() || process.exitCode() != 0)
        return QStringLiteral("failed: ") + QString::fromUtf8(process.readAllStandardError());
    return QString::fromUtf8(process.readAllStandardOutput());
}

QString written(double value)
{
    QString text = QString::number(value, 'f', 2);
    static const QRegularExpression zeros(QStringLiteral("\\.?0+$"));
    return text.remove(zeros);
}
} // namespace

class TestSweepPdf : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_path = m_folder.filePath(QStringLiteral("report.pdf"));
    }

    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void hasTheSameMetrics()
    {
        const results::SweepRun run = sweep_example::run();
        QVERIFY(report::saveSweepPdf(run, exampleSeries(), false, m_path));
        const QString text = textOf();
        for (const results::SweepMetric& metric : run.servos[0].metrics) {
            for (const auto& value : {metric.value, metric.mean, metric.min, metric.max})
                QVERIFY2(text.contains(written(*value)), qPrintable(metric.key));
        }
        for (const results::SweepLeg& leg : run.servos[0].legs) {
            for (const auto& value : {leg.reached, leg.overshoot, leg.steadyError, leg.meanSpeed})
                QVERIFY2(text.contains(written(*value)), qPrintable(written(*value)));
        }
        for (const char* fact : {"Fail", "SIMULATED", "STS3215", "2026-03-09 09:00:01 UTC",
                                 "above 8 step", "not measured", "min_angle", "12345",
                                 "<script>alert('note')</script>", "O'Neill <b>&amp;</b>"})
            QVERIFY2(text.contains(QString::fromUtf8(fact)), fact);
    }

    void isTranslatedToChinese()
    {
        QVERIFY(report::saveSweepPdf(sweep_example::run(), exampleSeries(), true, m_path));
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().startsWith("%PDF-"));
        const QString text = textOf();
        QVERIFY(!text.contains(QStringLiteral("Verdict")));
        QVERIFY(!text.contains(QStringLiteral("English")));
    }

    /// A reader needs none of them. Only the Chinese font depends on the machine; the example
    /// contains a Chinese word.
    void fontsAreEmbedded()
    {
        QVERIFY(report::saveSweepPdf(sweep_example::run(), exampleSeries(), false, m_path));
        const QStringList fonts = outputOf(QStringLiteral("pdffonts"), {m_path})
                                      .split(QLatin1Char('\n'), Qt::SkipEmptyParts)
                                      .mid(2);
        QVERIFY(fonts.size() >= 2);
        static const QRegularExpression own(
            QStringLiteral("^(NotoSans-(Regular|Bold)|ServoDeskSymbols|NotoSansCJKsc-Regular) .* "
                           "yes (yes|no) +yes"));
        for (const QString& font : fonts)
            QVERIFY2(font.contains(own), qPrintable(font));
        for (const char* text : {"NotoSans-Regular", "NotoSans-Bold"})
            QVERIFY2(!fonts.filter(QLatin1String(text)).isEmpty(), text);
    }

    void containsCharts()
    {
        QVERIFY(report::saveSweepPdf(sweep_example::run(), exampleSeries(), false, m_path));
        const QString images =
            outputOf(QStringLiteral("pdfimages"), {QStringLiteral("-list"), m_path});
        const QString size =
            QStringLiteral("%1\\s+%2\\s").arg(2 * report::chartWidth).arg(2 * report::chartHeight);
        QVERIFY2(images.count(QRegularExpression(size)) == 2, qPrintable(images));
    }

    /// Every word is complete, inside the page, and large enough to read.
    void nothingIsCutOff()
    {
        results::SweepRun run = sweep_example::run(300);
        for (results::SweepLeg& leg : run.servos[0].legs) {
            leg.number += 10000; // as wide as after a night
            leg.at += std::chrono::hours(8);
            leg.start = leg.target = -28672.25;
            leg.reached = -28669.33;
            leg.missed = true;
            leg.flagWrong = true;
            leg.alarms = 0x25;
        }
        QVERIFY(report::saveSweepPdf(run, exampleSeries(), false, m_path));
        const QString boxes = outputOf(QStringLiteral("pdftotext"),
                                       {QStringLiteral("-bbox"), m_path, QStringLiteral("-")});
        static const QRegularExpression word(
            QStringLiteral("yMin=\"([0-9.]+)\" xMax=\"([0-9.]+)\" yMax=\"([0-9.]+)\""));
        constexpr double paper = 842; // A4 landscape, in points
        int words = 0;
        for (auto it = word.globalMatch(boxes); it.hasNext(); ++words) {
            const auto match = it.next();
            QVERIFY(match.captured(2).toDouble() < paper - 10);
            QVERIFY(match.captured(3).toDouble() - match.captured(1).toDouble() > 5);
        }
        for (const char* whole : {">-28669.33<", ">-28672.25<", ">10300<", ">29100<", ">2345.68<"})
            QVERIFY2(boxes.contains(QString::fromLatin1(whole)), whole);
        QVERIFY(words > 300);
    }

    void saveErrorsAreReported()
    {
        const auto saved = report::saveSweepPdf(sweep_example::run(), {}, false,
                                                m_folder.filePath(QStringLiteral("none/x.pdf")));
        QCOMPARE(saved.error().code, base::ErrorCode::FileUnwritable);
    }

private:
    /// With single blanks, because lines are broken at the edge of the page.
    QString textOf() const
    {
        return outputOf(QStringLiteral("pdftotext"),
                        {QStringLiteral("-layout"), m_path, QStringLiteral("-")})
            .simplified();
    }

    QTemporaryDir m_folder;
    QString m_path;
};

static int run(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QTemporaryDir place;
    qputenv("FONTCONFIG_FILE", support::fontConfigWith(place, CJK_FONTS));
    const QGuiApplication application(argc, argv);
    TestSweepPdf test;
    return QTest::qExec(&test, argc, argv);
}
SERVODESK_TEST_RUN(run)
#include "tst_sweep_pdf.moc"
