// SPDX-License-Identifier: GPL-3.0-or-later
// The report as PDF, read by another program (poppler): the figures of the HTML page in both
// languages, a summary and at most two pages a servo, charts as drawings, embedded fonts, nothing
// cut off at the right. Only Chinese fonts are installed, which Qt would then use for everything.
#include "report/sweep_pdf.h"
#include "report/sweep_text.h"
#include "support/font_config.h"
#include "support/program_output.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "unit/results/sweep_example.h"

#include <QGuiApplication>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace {
using support::outputOf;
using sweep_example::written;

std::vector<report::SweepSeries> sineSeries()
{
    report::SweepSeries series;
    series.servo = 5;
    for (int i = 0; i < 900; ++i)
        series.samples.push_back({i * 0.01, 2000 + 1000 * std::sin(i * 0.02), 2000});
    return {series};
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
        QVERIFY(report::saveSweepPdf(run, sineSeries(), false, m_path));
        const QString text = textOf();
        for (const results::SweepMetric& metric : run.servos[0].metrics) {
            for (const auto& value : {metric.value, metric.mean, metric.min, metric.max})
                QVERIFY2(text.contains(written(*value)), qPrintable(metric.key));
        }
        for (const results::SweepLeg& leg : run.servos[0].legs) {
            for (const auto& value : {leg.overshoot, leg.steadyError, leg.followingError})
                QVERIFY2(text.contains(written(*value)), qPrintable(written(*value)));
        }
        for (const char* fact :
             {"Fail", "SIMULATED", "STS3215", "2026-03-09 09:00:01 UTC", "above 8 step",
              "not measured", "<script>alert('note')</script>", "O'Neill <b>&amp;</b>"})
            QVERIFY2(text.contains(QString::fromUtf8(fact)), fact);
    }

    void isTranslatedToChinese()
    {
        QVERIFY(report::saveSweepPdf(sweep_example::run(), sineSeries(), true, m_path));
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
        QVERIFY(report::saveSweepPdf(sweep_example::run(), sineSeries(), false, m_path));
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

    /// As drawings, sharp at any size.
    void containsCharts()
    {
        QVERIFY(report::saveSweepPdf(sweep_example::run(20), sineSeries(), false, m_path));
        QCOMPARE(outputOf(QStringLiteral("pdfimages"), {QStringLiteral("-list"), m_path})
                     .split(QLatin1Char('\n'), Qt::SkipEmptyParts)
                     .size(),
                 2); // its heading
        const QString picture = m_folder.filePath(QStringLiteral("page"));
        (void)outputOf(QStringLiteral("pdftoppm"), {QStringLiteral("-png"), QStringLiteral("-r"),
                                                    QStringLiteral("50"), m_path, picture});
        for (const char* page : {"-2.png", "-3.png"}) { // position, errors
            const QImage image(picture + QLatin1String(page));
            QVERIFY(!image.isNull());
            int blue = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    const QColor color = image.pixelColor(x, y);
                    blue += color.blue() > color.red() + 100 ? 1 : 0;
                }
            }
            QVERIFY2(blue > 100, page);
        }
    }

    /// What one hands over: page 1 for all, then two pages a servo at most, upright.
    void aServoTakesTwoPages_data()
    {
        QTest::addColumn<int>("servos");
        QTest::addColumn<int>("legs");
        QTest::addColumn<int>("pages");
        QTest::newRow("short test") << 3 << 6 << 4;
        QTest::newRow("long test") << 3 << 1000 << 7;
    }
    void aServoTakesTwoPages()
    {
        QFETCH(const int, servos);
        QFETCH(const int, legs);
        QFETCH(const int, pages);
        results::SweepRun run = sweep_example::run(legs);
        run.spec.note.clear();
        run.servos.resize(1);
        for (int i = 1; i < servos; ++i)
            run.servos.push_back(run.servos.front());
        QVERIFY(report::saveSweepPdf(run, sineSeries(), false, m_path));
        const QString facts = outputOf(QStringLiteral("pdfinfo"), {m_path});
        static const QRegularExpression count(QStringLiteral("Pages: +(\\d+)"));
        QCOMPARE(count.match(facts).captured(1).toInt(), pages);
        QVERIFY2(facts.contains(QLatin1String("595 x 842 pts (A4)")), qPrintable(facts));
        const QString text = textOf();
        QVERIFY2(text.contains(QRegularExpression(QStringLiteral("%1 ?/ ?%1").arg(pages))),
                 qPrintable(text.right(500)));
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
        QVERIFY(report::saveSweepPdf(run, sineSeries(), false, m_path));
        const QString boxes = outputOf(QStringLiteral("pdftotext"),
                                       {QStringLiteral("-bbox"), m_path, QStringLiteral("-")});
        static const QRegularExpression word(
            QStringLiteral("yMin=\"([0-9.]+)\" xMax=\"([0-9.]+)\" yMax=\"([0-9.]+)\""));
        constexpr double paper = 595; // A4 upright, in points
        int words = 0;
        for (auto it = word.globalMatch(boxes); it.hasNext(); ++words) {
            const auto match = it.next();
            QVERIFY(match.captured(2).toDouble() < paper - 10);
            QVERIFY(match.captured(3).toDouble() - match.captured(1).toDouble() > 5);
        }
        for (const char* whole : {">-28669.3<", ">-28672.25<", ">10300<", ">29100.00<", ">77.7<"})
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

static int runTestSweepPdf(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    return support::runWithFonts<QGuiApplication, TestSweepPdf>(argc, argv, CJK_FONTS);
}
SERVODESK_TEST_RUN(runTestSweepPdf)
#include "tst_sweep_pdf.moc"
