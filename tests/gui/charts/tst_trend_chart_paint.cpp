// SPDX-License-Identifier: GPL-3.0-or-later
// What the trend chart paints and what it does not: gaps, steps, marks, both themes, unusual input.
#include "gui/trend_chart_fixture.h"
#include "support/test_main.h"

#include <QRandomGenerator>
#include <QScreen>

#include <cmath>
#include <utility>

using namespace std::chrono_literals;
using base::Duration;

class TestTrendChartPaint : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin)"))); }
    void gapIsNotPainted();
    void stepsStayLevel();
    void goalsAreDashed();
    void linesOfTheGridMeetTheirLabels();
    void curveIsWhereItsValueIs();
    void scrolledImageMatchesAFreshOne();
    void quickRenderLosesNothing();
    void fullRenderFollows();
    void themeRepaints();
    void nothingToShow();
    void constantSignal();
    void oddNumbers();
    void clockJump();
    void marksAreVisible();
    void languageChange();
    void onlyWhatChangedIsPaintedAgain();
};

void TestTrendChartPaint::gapIsNotPainted()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 4s, [](double) { return 5.0; });
    fixture.store.gap(fixture.ids[0]);
    fixture.fillFrom(0, 6s, 10s, [](double) { return 5.0; });
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0.05, 0, 0.3, 1}, 0));
    QVERIFY(!fixture.paintedIn({0.42, 0, 0.16, 1}, 0));
    QVERIFY(fixture.paintedIn({0.65, 0, 0.3, 1}, 0));
}

void TestTrendChartPaint::stepsStayLevel()
{
    gui::TrendChartFixture fixture;
    fixture.channels[0].steps = true;
    fixture.chart.setChannels(fixture.channels);
    fixture.put(0, 0s, 0);
    fixture.put(0, 5s, 100);
    fixture.put(0, 10s, 100);
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    QVERIFY(!fixture.paintedIn({0.1, 0.3, 0.35, 0.4}, 0)); // a slanted line would cross here
    QVERIFY(fixture.paintedIn({0.48, 0.3, 0.04, 0.4}, 0)); // the step
    fixture.channels[0].steps = false;
    fixture.chart.setChannels(fixture.channels);
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0.1, 0.3, 0.35, 0.4}, 0));
}

/// Level parts have gaps, and a jump has none.
void TestTrendChartPaint::goalsAreDashed()
{
    gui::TrendChartFixture fixture;
    fixture.channels[0].steps = fixture.channels[0].dashed = true;
    fixture.chart.setChannels(fixture.channels);
    for (const auto& [at, value] : {std::pair(0s, 0), std::pair(5s, 100), std::pair(10s, 100)})
        fixture.put(0, at, value);
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    int painted = 0;
    constexpr int parts = 100;
    for (int i = 0; i < parts; ++i)
        painted += fixture.paintedIn({0.1 + 0.3 * i / parts, 0, 0.001, 0.1}, 0) ? 1 : 0;
    QVERIFY2(painted > parts / 4 && painted < parts * 9 / 10, qPrintable(QString::number(painted)));
    for (const double height : {0.2, 0.4, 0.6, 0.8})
        QVERIFY(fixture.paintedIn({0.48, height, 0.04, 0.01}, 0));
}

namespace {
bool isBackground(const QImage& image, int x, int y)
{
    return gui::TrendChartFixture::near(image.pixel(x, y), image.pixel(1, image.height() - 2));
}

/// The rows in which a line goes across the whole plot.
std::vector<int> linesAcross(const QImage& image, const QRect& plot)
{
    std::vector<int> rows;
    for (int y = plot.top() + 1; y < plot.bottom(); ++y) {
        int painted = 0;
        for (int x = plot.left() + 3; x < plot.right() - 3; ++x)
            painted += image.pixel(x, y) != image.pixel(1, image.height() - 2) ? 1 : 0;
        if (painted > plot.width() - 10)
            rows.push_back(y);
    }
    return rows;
}

/// The middles of the texts left of the plot.
std::vector<int> labelsBeside(const QImage& image, const QRect& plot)
{
    std::vector<int> middles;
    int from = -1;
    for (int y = plot.top() - 4; y < plot.bottom() + 8; ++y) {
        bool text = false;
        for (int x = 1; x < plot.left() - 2 && !text; ++x)
            text = !isBackground(image, x, y);
        if (text && from < 0)
            from = y;
        if (!text && from >= 0)
            middles.push_back((std::exchange(from, -1) + y - 1) / 2);
    }
    return middles;
}
} // namespace

void TestTrendChartPaint::linesOfTheGridMeetTheirLabels()
{
    gui::TrendChartFixture fixture;
    fixture.chart.setChannelVisible(1, false);
    fixture.fill(0, 10s, [](double t) { return t < 5 ? 82.0 : 4013.0; });
    fixture.chart.zoomToFit();
    fixture.waitForFrames();
    fixture.chart.show({12s, 20s}); // beside the curve, which would hide lines
    for (const QSize size : {QSize(800, 500), QSize(640, 300), QSize(1200, 900)}) {
        fixture.chart.resize(size);
        fixture.waitForFrames();
        const QImage image = fixture.picture();
        const QRect plot(fixture.at({0, 1}), fixture.at({1, 0}));
        const std::vector<int> lines = linesAcross(image, plot);
        const std::vector<int> labels = labelsBeside(image, plot);
        QVERIFY2(lines.size() >= 2, qPrintable(QString::number(lines.size())));
        QVERIFY(labels.size() >= lines.size());
        for (const int line : lines)
            QVERIFY(std::any_of(labels.begin(), labels.end(),
                                [line](int label) { return std::abs(label - line) <= 2; }));
    }
}

void TestTrendChartPaint::curveIsWhereItsValueIs()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t < 5 ? 0.0 : 100.0; });
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    // Shown from 0, since nothing is below it, to 5 % above the highest value.
    const double top = 100.0 / 105;
    QVERIFY(fixture.paintedIn({0.1, 0, 0.3, 0.012}, 0));
    QVERIFY(fixture.paintedIn({0.6, top - 0.012, 0.3, 0.024}, 0));
    QVERIFY(!fixture.paintedIn({0.1, 0.1, 0.3, 0.8}, 0));
    fixture.setScale(0, -1, 100);
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0.6, 0, 0.3, 0.012}, 0));
    QCOMPARE(fixture.chart.channels()[0].scale, -1.0);
}

/// Following shifts the image and paints only the new part; that must not be visible.
void TestTrendChartPaint::scrolledImageMatchesAFreshOne()
{
    const auto wave = [](double t) { return std::sin(t * 2) * 50 + std::sin(t * 41) * 3; };
    const auto steps = [](double t) { return std::floor(t) * 3; };
    gui::TrendChartFixture moving;
    gui::TrendChartFixture fresh;
    for (gui::TrendChartFixture* fixture : {&moving, &fresh}) {
        fixture->channels[1].steps = fixture->channels[1].dashed = true;
        fixture->chart.setChannels(fixture->channels);
        fixture->fill(0, 20s, wave);
        fixture->fill(1, 20s, steps);
    }
    moving.chart.advance(20s);
    moving.waitForFrames();
    Duration now = 20s;
    for (int i = 0; i < 12; ++i) {
        now += Duration(33000 + i * 700);
        moving.fill(0, now, wave);
        moving.fill(1, now, steps);
        moving.chart.advance(now);
        moving.waitForFrames();
    }
    fresh.fill(0, now, wave);
    fresh.fill(1, now, steps);
    fresh.chart.advance(now);
    fresh.waitForFrames();
    const QImage a = moving.picture();
    const QImage b = fresh.picture();
    QCOMPARE(a.size(), b.size());
    int different = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x)
            different += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
    QVERIFY2(different < a.width() / 2, qPrintable(QString::number(different)));
}

/// While the wheel turns curves are coarse; a single sample far out and a gap are seen all the
/// same.
void TestTrendChartPaint::quickRenderLosesNothing()
{
    gui::TrendChartFixture fixture;
    for (int i = 0; i < 60000; ++i) {
        if (i == 20000)
            fixture.store.gap(fixture.ids[0]);
        if (i < 20000 || i > 24000)
            fixture.put(0, i * 10ms, i == 37001 ? 100 : std::abs(std::sin(i * 0.01)));
    }
    fixture.chart.show({0s, 600s});
    for (const int turn : {120, -120, 240, -360}) {
        fixture.waitForFrames();
        QVERIFY(!fixture.plot->picture().isCoarse());
        fixture.wheel({0.5, 0.5}, turn);
        QTRY_VERIFY(fixture.plot->picture().isCoarse());
        const recording::TimeSpan shown = fixture.chart.shown();
        const auto share = [&](Duration at) {
            return double((at - shown.from).count()) / double((shown.to - shown.from).count());
        };
        const double spike = share(370010ms);
        QVERIFY(fixture.paintedIn({spike - 0.005, 0.9, 0.01, 0.09}, 0)); // its tip
        QVERIFY(fixture.paintedIn({spike - 0.005, 0.3, 0.01, 0.4}, 0));  // and the way there
        QVERIFY(!fixture.paintedIn({spike + 0.01, 0.3, 0.2, 0.69}, 0));
        QVERIFY(!fixture.paintedIn({share(203s), 0, share(237s) - share(203s), 1}, 0));
        QVERIFY(fixture.paintedIn({share(195s), 0, share(199s) - share(195s), 0.2}, 0));
    }
}

void TestTrendChartPaint::fullRenderFollows()
{
    const auto wave = [](double t) { return std::sin(t) * 50 + std::sin(t * 41) * 3; };
    gui::TrendChartFixture zoomed;
    gui::TrendChartFixture fresh;
    for (gui::TrendChartFixture* fixture : {&zoomed, &fresh})
        fixture->fill(0, 300s, wave);
    zoomed.chart.show({0s, 300s});
    zoomed.waitForFrames();
    for (int i = 0; i < 5; ++i)
        zoomed.wheel({0.4, 0.5}, 120);
    QTRY_VERIFY(zoomed.plot->picture().isCoarse());
    fresh.chart.show(zoomed.chart.shown());
    fresh.waitForFrames();
    QVERIFY(zoomed.picture() != fresh.picture());
    QTRY_VERIFY(!zoomed.plot->picture().isCoarse()); // by itself, once the wheel rests
    QCOMPARE(zoomed.picture(), fresh.picture());
}

void TestTrendChartPaint::themeRepaints()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t; });
    fixture.chart.advance(10s);
    fixture.waitForFrames();
    const QColor light = fixture.picture().pixelColor(fixture.at({0.03, 0.93}));
    QVERIFY(light.lightness() > 200);
    QPalette dark = fixture.chart.palette();
    dark.setColor(QPalette::Window, QColor(0x26, 0x29, 0x2f));
    dark.setColor(QPalette::Base, QColor(0x2d, 0x31, 0x38));
    dark.setColor(QPalette::Text, QColor(0xe6, 0xe8, 0xec));
    fixture.chart.setPalette(dark);
    fixture.waitForFrames();
    QCOMPARE(fixture.picture().pixelColor(fixture.at({0.03, 0.93})), QColor(0x2d, 0x31, 0x38));
    QVERIFY(fixture.paintedIn({0, 0, 1, 1}, 0)); // in the dark twin of its color
}

void TestTrendChartPaint::nothingToShow()
{
    ui::TrendChart chart;
    chart.resize(700, 400);
    chart.show();
    QVERIFY(QTest::qWaitForWindowExposed(&chart));
    chart.advance(5s);
    chart.zoomToFit();
    chart.zoomBack();
    chart.setCursorsShown(true);
    QVERIFY(chart.cursorReadings().empty());
    auto* const plot = chart.findChild<QWidget*>(QStringLiteral("trendPlot"));
    for (const int key :
         {Qt::Key_Home, Qt::Key_End, Qt::Key_Left, Qt::Key_Plus, Qt::Key_1, Qt::Key_F})
        QTest::keyClick(plot, Qt::Key(key));
    QVERIFY(!chart.grab().isNull());
    gui::TrendChartFixture fixture; // channels without a sample
    fixture.chart.advance(5s);
    fixture.chart.zoomToFit();
    fixture.waitForFrames();
    QVERIFY(!fixture.paintedIn({0, 0, 1, 1}, 0));
    fixture.chart.setStore(nullptr);
    fixture.waitForFrames();
    QVERIFY(fixture.chart.cursorReadings().empty());
    fixture.chart.resize(30, 20); // no room for a plot
    fixture.waitForFrames();
}

void TestTrendChartPaint::constantSignal()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return 7.4 + 0.01 * std::sin(t * 99); });
    fixture.chart.advance(10s);
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0.2, 0.15, 0.6, 0.7}, 0)); // away from the edges
    QVERIFY(!fixture.paintedIn({0.2, 0, 0.6, 0.15}, 0));
    QVERIFY(!fixture.paintedIn({0.2, 0.85, 0.6, 0.15}, 0));
}

void TestTrendChartPaint::oddNumbers()
{
    gui::TrendChartFixture fixture;
    for (int i = 0; i < 100; ++i) {
        const double odd[] = {1, qQNaN(), qInf(), -qInf(), 2};
        fixture.store.append(fixture.ids[0], i * 100ms, odd[i % 5]);
        fixture.store.append(fixture.ids[1], i * 100ms, i % 2 ? 1e300 : -1e300);
    }
    fixture.chart.advance(10s);
    fixture.chart.setCursors(1s, 9s);
    fixture.waitForFrames();
    fixture.chart.zoomToFit();
    fixture.waitForFrames();
    fixture.setScale(1, 1e300, 0);
    fixture.waitForFrames();
    QVERIFY(!fixture.picture().isNull());
}

void TestTrendChartPaint::clockJump()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 5s, [](double) { return 1.0; });
    fixture.store.gap(fixture.ids[0]);
    fixture.fillFrom(0, 9h, 9h + 5s, [](double) { return 2.0; });
    fixture.chart.advance(5s);
    fixture.waitForFrames();
    fixture.chart.advance(9h + 5s);
    fixture.waitForFrames();
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{9h - 5s, 9h + 5s}));
    QVERIFY(!fixture.paintedIn({0.02, 0, 0.45, 1}, 0));
    QVERIFY(fixture.paintedIn({0.55, 0, 0.4, 1}, 0));
    fixture.chart.zoomToFit();
    fixture.waitForFrames();
    QVERIFY(fixture.chart.width() > 9h);
    fixture.chart.advance(1s); // and back: another clock
    fixture.chart.setFollowing(true);
    fixture.waitForFrames();
    QCOMPARE(fixture.chart.shown().to, Duration(1s));
}

void TestTrendChartPaint::marksAreVisible()
{
    gui::TrendChartFixture fixture;
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    const QImage without = fixture.picture();
    std::vector<recording::Mark> marks{
        {5s, recording::MarkKind::Fault, 1, QStringLiteral("overload")}};
    fixture.chart.setMarks(&marks);
    fixture.waitForFrames();
    const QImage with = fixture.picture();
    const QPoint on = fixture.at({0.5, 0.5});
    int changed = 0;
    for (int x = on.x() - 2; x <= on.x() + 2; ++x)
        changed += with.pixel(x, on.y()) != without.pixel(x, on.y()) ? 1 : 0;
    QCOMPARE(changed, 1);
    marks.clear();
    for (int i = 0; i < 20000; ++i) // dense ones are merged
        marks.push_back({i * 500us, recording::MarkKind::Write, 1, QStringLiteral("w")});
    fixture.chart.setMarks(nullptr);
    fixture.chart.setMarks(&marks);
    fixture.waitForFrames();
    int lines = 0;
    const int y = fixture.at({0.5, 0.5}).y();
    for (int x = int(fixture.area().left()); x < int(fixture.area().right()); ++x)
        lines += fixture.picture().pixel(x, y) != without.pixel(x, y) ? 1 : 0;
    QVERIFY(lines > 10 && lines < int(fixture.area().width()) / 15);
}

void TestTrendChartPaint::languageChange()
{
    gui::TrendChartFixture fixture;
    fixture.plot->setAccessibleName({});
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&fixture.chart, &change);
    QVERIFY(!fixture.plot->accessibleName().isEmpty());
    QVERIFY(!fixture.plot->toolTip().isEmpty());
}

/// What is on the screen after many small changes is what painting all of it gives.
void TestTrendChartPaint::onlyWhatChangedIsPaintedAgain()
{
    gui::TrendChartFixture fixture;
    ui::TrendChart& chart = fixture.chart;
    const auto wave = [](double seconds) { return 100 * std::sin(seconds) * seconds; };
    std::vector<recording::Mark> marks;
    std::vector<ui::TrendChannel> channels = fixture.channels;
    channels[1].unit = QStringLiteral("mA");
    chart.setChannels(channels);
    chart.setMarks(&marks);
    QRandomGenerator random(20261129);
    Duration now{};
    const auto advance = [&] { // most of the time
        now += std::chrono::milliseconds(random.bounded(1, 400));
        fixture.fill(0, now, wave);
        fixture.fill(1, now, [&](double seconds) { return -3 * wave(seconds + 1); });
        chart.advance(now);
    };
    const std::vector<std::function<void()>> changes{
        advance,
        advance,
        advance,
        [&] { chart.setFollowing(true); },
        [&] {
            fixture.drag(Qt::LeftButton, Qt::NoModifier, {0.5, 0.5}, {0.6, 0.4});
        },
        [&] {
            fixture.drag(Qt::LeftButton, Qt::ShiftModifier, {0.5, 0.5}, {0.5, 0.6});
        },
        [&] {
            fixture.wheel({0.3, 0.5}, random.bounded(2) == 0 ? 120 : -120);
        },
        [&] {
            marks.push_back({now, recording::MarkKind::Write, 1, QStringLiteral("P gain 32")});
            chart.setMarks(&marks);
        },
        [&] { chart.setCursors(now - 1s * random.bounded(9), now - 1s * random.bounded(9)); },
        [&] { chart.setCursorsShown(!chart.areCursorsVisible()); },
        [&] { chart.setLanes(!chart.hasLanes()); },
        [&] { chart.setChannelVisible(random.bounded(2), random.bounded(3) > 0); },
        [&] { chart.resize(random.bounded(500, 800), random.bounded(300, 500)); },
        [&] { chart.zoomToFit(); },
        [&] { QTest::keyClick(fixture.plot, Qt::Key_Left); },
        [&] { chart.setWidth(1s * random.bounded(1, 20)); },
    };
    for (int step = 0; step < 400; ++step) {
        const int change = random.bounded(int(changes.size()));
        changes[std::size_t(change)]();
        fixture.waitForFrames();
        const QImage shown = chart.screen()->grabWindow(chart.winId()).toImage();
        const QImage whole = chart.grab().toImage();
        QCOMPARE(shown.size(), whole.size());
        QVERIFY2(shown.convertToFormat(QImage::Format_RGB32) ==
                     whole.convertToFormat(QImage::Format_RGB32),
                 qPrintable(QStringLiteral("step %1, change %2").arg(step).arg(change)));
    }
}

SERVODESK_TEST(TestTrendChartPaint)
#include "tst_trend_chart_paint.moc"
