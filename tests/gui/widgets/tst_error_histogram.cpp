// SPDX-License-Identifier: GPL-3.0-or-later
// The histogram of steady errors: counts every leg once, around 0, at any size; has its numbers as
// text; is visible in both themes; and shows when nothing is measured.
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/common/theme.h"
#include "ui/widgets/error_histogram.h"

#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>

#include <numeric>
#include <random>

using ui::ErrorHistogram;
using ui::Tone;

namespace {
QString q(const char* text)
{
    return QString::fromUtf8(text);
}

std::uint64_t sum(const std::vector<ErrorHistogram::Bar>& bars)
{
    return std::accumulate(bars.begin(), bars.end(), std::uint64_t(0),
                           [](std::uint64_t all, const auto& bar) { return all + bar.count; });
}

/// As a good servo does: many near 0, the same ones every time.
std::vector<double> normalDistribution(int legs)
{
    std::mt19937 dice(7); // NOLINT: a test must be repeatable
    std::binomial_distribution<int> steps(10, 0.5);
    std::vector<double> errors;
    for (int i = 0; i < legs; ++i)
        errors.push_back(steps(dice) - 5);
    return errors;
}

int countPixels(const QImage& image, const QColor& color)
{
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            found += image.pixelColor(x, y).rgb() == color.rgb() ? 1 : 0;
    }
    return found;
}

QImage picture(ErrorHistogram& chart)
{
    return chart.grab().toImage().convertToFormat(QImage::Format_RGB32);
}
} // namespace

class TestErrorHistogram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        text::installTranslator(q("en"));
    }
    void cleanup() { text::installTranslator(q("en")); }

    void everyLegIsCountedOnce_data();
    void everyLegIsCountedOnce();
    void wholeStepsHaveTheirOwnBars();
    void itGrowsWithNewLegs();
    void nanValuesAreIgnored();
    void accessibleTextHasTheNumbers();
    void tooltipExplainsABar();
    void emptyHistogramShowsAMessage();
    void limitsAreDrawnWhenInRange();
    void isVisibleInBothThemes();
};

void TestErrorHistogram::everyLegIsCountedOnce_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("usual") << QSize(320, 180);
    QTest::newRow("small") << QSize(90, 60);
    QTest::newRow("wide") << QSize(1400, 500);
    QTest::newRow("no room at all") << QSize(4, 4);
}

void TestErrorHistogram::everyLegIsCountedOnce()
{
    QFETCH(QSize, size);
    ErrorHistogram chart;
    chart.resize(size);
    chart.setLimits(8, 16);
    chart.addErrors(normalDistribution(500));
    chart.addErrors(3.4);
    chart.addErrors(-1200);
    const auto bars = chart.bars();
    QCOMPARE(sum(bars), std::uint64_t(502));
    for (std::size_t i = 1; i < bars.size(); ++i)
        QVERIFY(bars[i].from >= bars[i - 1].to - 1e-9);
    QVERIFY(!picture(chart).isNull());
}

void TestErrorHistogram::wholeStepsHaveTheirOwnBars()
{
    ErrorHistogram chart;
    chart.resize(320, 180);
    chart.addErrors(std::vector<double>{-2, -1, -1, 0, 0, 0, 1, 5});
    const auto bars = chart.bars();
    QCOMPARE(bars.size(), std::size_t(5));
    QCOMPARE(bars[2].count, std::uint64_t(3));
    QCOMPARE(bars[2].from, -bars[2].to); // around 0
    QVERIFY(bars[2].to <= 0.5);
}

void TestErrorHistogram::itGrowsWithNewLegs()
{
    ErrorHistogram chart;
    chart.resize(320, 180);
    chart.addErrors(normalDistribution(100));
    const double narrow = chart.bars().front().to - chart.bars().front().from;
    chart.addErrors(400);
    const double wide = chart.bars().front().to - chart.bars().front().from;
    QVERIFY(wide > 10 * narrow);
    QVERIFY(chart.bars().size() < 60);
    chart.clear();
    QCOMPARE(chart.count(), std::uint64_t(0));
    QVERIFY(chart.bars().empty());
}

void TestErrorHistogram::nanValuesAreIgnored()
{
    ErrorHistogram chart;
    chart.addErrors(std::nan(""));
    chart.addErrors(std::numeric_limits<double>::infinity());
    QCOMPARE(chart.count(), std::uint64_t(0));
    chart.addErrors(std::numeric_limits<double>::max());
    QCOMPARE(sum(chart.bars()), std::uint64_t(1));
}

void TestErrorHistogram::accessibleTextHasTheNumbers()
{
    ErrorHistogram chart;
    chart.setLimits(8, 16);
    chart.addErrors(std::vector<double>{-9, 0, 1, 20});
    QCOMPARE(chart.accessibleName(), q("Steady-state error"));
    const QString words = chart.accessibleDescription();
    for (const char* part : {"Moves: 4.", "Error: −9 to +20 step", "mean +3 step",
                             "warning limit of 8 step: 2.", "the limit of 16 step: 1."})
        QVERIFY2(words.contains(q(part)), qPrintable(words));
    text::installTranslator(q("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&chart, &change);
    QVERIFY2(chart.accessibleDescription().contains(q("步")),
             qPrintable(chart.accessibleDescription()));
}

void TestErrorHistogram::tooltipExplainsABar()
{
    ErrorHistogram chart;
    chart.resize(320, 180);
    chart.setAttribute(Qt::WA_DontShowOnScreen);
    chart.show();
    chart.addErrors(std::vector<double>{-4, 0, 0, 0, 4});
    const auto ask = [&](const QPoint& place) {
        QHelpEvent help(QEvent::ToolTip, place, chart.mapToGlobal(place));
        QCoreApplication::sendEvent(&chart, &help);
        return QToolTip::text();
    };
    const QString middle = ask(chart.rect().center());
    QVERIFY2(middle.contains(q("3 of 5 moves (60.0 %)")), qPrintable(middle));
    const QString textOutsideBars = ask({1, 90});
    QVERIFY2(textOutsideBars.contains(q("Moves: 5.")), qPrintable(textOutsideBars));
    QToolTip::hideText();
}

void TestErrorHistogram::emptyHistogramShowsAMessage()
{
    ErrorHistogram chart;
    chart.resize(320, 180);
    QVERIFY(chart.accessibleDescription().contains(q("No steady-state error")));
    const QImage image = picture(chart);
    QVERIFY(countPixels(image, ui::tone(Tone::Accent, chart.palette())) == 0);
    bool written = false;
    for (int x = 0; x < image.width(); ++x)
        written = written || image.pixel(x, 90) != image.pixel(0, 0);
    QVERIFY(written);
}

void TestErrorHistogram::limitsAreDrawnWhenInRange()
{
    ErrorHistogram chart;
    chart.resize(320, 180);
    chart.addErrors(std::vector<double>{-4, 0, 4});
    const QImage without = picture(chart);
    chart.setLimits(8, 5000);
    const QImage with = picture(chart);
    QVERIFY(with != without);
    // A distant limit does not squeeze the errors into one line.
    QCOMPARE(chart.bars().size(), std::size_t(3));
    chart.setLimits(5000, {});
    QCOMPARE(picture(chart), without);
}

void TestErrorHistogram::isVisibleInBothThemes()
{
    ui::ThemeSwitch theme;
    QRgb before = 0;
    for (const auto wish : {session::Theme::Light, session::Theme::Dark}) {
        theme.apply(wish);
        ErrorHistogram chart;
        chart.resize(320, 180);
        chart.addErrors(normalDistribution(300));
        const QImage image = picture(chart);
        const QColor bar = ui::tone(Tone::Accent, chart.palette());
        QVERIFY(countPixels(image, bar) > 2000);
        QVERIFY(bar.rgb() != before);
        before = bar.rgb();
        // At the end the frame must still be free: nothing is cut off.
        QVERIFY(countPixels(image.copy(0, 0, 2, 180), bar) == 0);
        QVERIFY(countPixels(image.copy(318, 0, 2, 180), bar) == 0);
    }
}

SERVODESK_TEST(TestErrorHistogram)
#include "tst_error_histogram.moc"
