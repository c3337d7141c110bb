// SPDX-License-Identifier: GPL-3.0-or-later
// What the trend chart paints and what it does not: gaps, steps, marks, both themes, odd input.
#include "gui/trend_bench.h"

#include <cmath>

using namespace std::chrono_literals;
using base::Duration;

class TrendPaintTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin)"))); }
    void gapIsNotPainted();
    void stepsStayLevel();
    void curveIsWhereItsValueIs();
    void movingPictureIsAsAFreshOne();
    void hastyPictureLosesNothing();
    void finePictureFollows();
    void themeRepaints();
    void nothingToShow();
    void constantSignal();
    void oddNumbers();
    void clockJump();
    void marksAreSeen();
    void languageChange();
};

void TrendPaintTest::gapIsNotPainted()
{
    gui::TrendBench bench;
    bench.fill(0, 4s, [](double) { return 5.0; });
    bench.store.gap(bench.ids[0]);
    bench.fillFrom(0, 6s, 10s, [](double) { return 5.0; });
    bench.chart.show({0s, 10s});
    bench.settle();
    QVERIFY(bench.paintedIn({0.05, 0, 0.3, 1}, 0));
    QVERIFY(!bench.paintedIn({0.42, 0, 0.16, 1}, 0));
    QVERIFY(bench.paintedIn({0.65, 0, 0.3, 1}, 0));
}

void TrendPaintTest::stepsStayLevel()
{
    gui::TrendBench bench;
    bench.channels[0].steps = true;
    bench.chart.setChannels(bench.channels);
    bench.put(0, 0s, 0);
    bench.put(0, 5s, 100);
    bench.put(0, 10s, 100);
    bench.chart.show({0s, 10s});
    bench.settle();
    QVERIFY(!bench.paintedIn({0.1, 0.3, 0.35, 0.4}, 0)); // a slanted line would cross here
    QVERIFY(bench.paintedIn({0.48, 0.3, 0.04, 0.4}, 0)); // the step
    bench.channels[0].steps = false;
    bench.chart.setChannels(bench.channels);
    bench.settle();
    QVERIFY(bench.paintedIn({0.1, 0.3, 0.35, 0.4}, 0));
}

void TrendPaintTest::curveIsWhereItsValueIs()
{
    gui::TrendBench bench;
    bench.fill(0, 10s, [](double t) { return t < 5 ? 0.0 : 100.0; });
    bench.chart.show({0s, 10s});
    bench.settle();
    // 0 … 100 is a round range, shown with 2.5 % above and below.
    const double margin = 0.025 / 1.05;
    QVERIFY(bench.paintedIn({0.1, margin - 0.012, 0.3, 0.024}, 0));
    QVERIFY(bench.paintedIn({0.6, 1 - margin - 0.012, 0.3, 0.024}, 0));
    QVERIFY(!bench.paintedIn({0.1, 0.1, 0.3, 0.8}, 0));
    bench.chart.setChannelScale(0, -1, 100);
    bench.settle();
    QVERIFY(bench.paintedIn({0.6, margin - 0.012, 0.3, 0.024}, 0));
    QCOMPARE(bench.chart.channels()[0].scale, -1.0);
}

/// Following shifts the picture and paints what is new; that must not be seen.
void TrendPaintTest::movingPictureIsAsAFreshOne()
{
    const auto wave = [](double t) { return std::sin(t * 2) * 50 + std::sin(t * 41) * 3; };
    const auto steps = [](double t) { return std::floor(t) * 3; };
    gui::TrendBench moving;
    gui::TrendBench fresh;
    for (gui::TrendBench* bench : {&moving, &fresh}) {
        bench->fill(0, 20s, wave);
        bench->fill(1, 20s, steps);
    }
    moving.chart.advance(20s);
    moving.settle();
    Duration now = 20s;
    for (int i = 0; i < 12; ++i) {
        now += Duration(33000 + i * 700);
        moving.fill(0, now, wave);
        moving.fill(1, now, steps);
        moving.chart.advance(now);
        moving.settle();
    }
    fresh.fill(0, now, wave);
    fresh.fill(1, now, steps);
    fresh.chart.advance(now);
    fresh.settle();
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
void TrendPaintTest::hastyPictureLosesNothing()
{
    gui::TrendBench bench;
    for (int i = 0; i < 60000; ++i) {
        if (i == 20000)
            bench.store.gap(bench.ids[0]);
        if (i < 20000 || i > 24000)
            bench.put(0, i * 10ms, i == 37001 ? 100 : std::abs(std::sin(i * 0.01)));
    }
    bench.chart.show({0s, 600s});
    for (const int turn : {120, -120, 240, -360}) {
        bench.settle();
        QVERIFY(!bench.plot->picture().coarse());
        bench.wheel({0.5, 0.5}, turn);
        QTRY_VERIFY(bench.plot->picture().coarse());
        const record::TimeSpan shown = bench.chart.shown();
        const auto share = [&](Duration at) {
            return double((at - shown.from).count()) / double((shown.to - shown.from).count());
        };
        const double spike = share(370010ms);
        QVERIFY(bench.paintedIn({spike - 0.005, 0.9, 0.01, 0.09}, 0)); // its tip
        QVERIFY(bench.paintedIn({spike - 0.005, 0.3, 0.01, 0.4}, 0));  // and the way there
        QVERIFY(!bench.paintedIn({spike + 0.01, 0.3, 0.2, 0.69}, 0));
        QVERIFY(!bench.paintedIn({share(203s), 0, share(237s) - share(203s), 1}, 0));
        QVERIFY(bench.paintedIn({share(195s), 0, share(199s) - share(195s), 0.2}, 0));
    }
}

void TrendPaintTest::finePictureFollows()
{
    const auto wave = [](double t) { return std::sin(t) * 50 + std::sin(t * 41) * 3; };
    gui::TrendBench zoomed;
    gui::TrendBench fresh;
    for (gui::TrendBench* bench : {&zoomed, &fresh})
        bench->fill(0, 300s, wave);
    zoomed.chart.show({0s, 300s});
    zoomed.settle();
    for (int i = 0; i < 5; ++i)
        zoomed.wheel({0.4, 0.5}, 120);
    QTRY_VERIFY(zoomed.plot->picture().coarse());
    fresh.chart.show(zoomed.chart.shown());
    fresh.settle();
    QVERIFY(zoomed.picture() != fresh.picture());
    QTRY_VERIFY(!zoomed.plot->picture().coarse()); // by itself, once the wheel rests
    QCOMPARE(zoomed.picture(), fresh.picture());
}

void TrendPaintTest::themeRepaints()
{
    gui::TrendBench bench;
    bench.fill(0, 10s, [](double t) { return t; });
    bench.chart.advance(10s);
    bench.settle();
    const QColor light = bench.picture().pixelColor(bench.at({0.03, 0.93}));
    QVERIFY(light.lightness() > 200);
    QPalette dark = bench.chart.palette();
    dark.setColor(QPalette::Window, QColor(0x26, 0x29, 0x2f));
    dark.setColor(QPalette::Base, QColor(0x2d, 0x31, 0x38));
    dark.setColor(QPalette::Text, QColor(0xe6, 0xe8, 0xec));
    bench.chart.setPalette(dark);
    bench.settle();
    QCOMPARE(bench.picture().pixelColor(bench.at({0.03, 0.93})), QColor(0x2d, 0x31, 0x38));
    QVERIFY(bench.paintedIn({0, 0, 1, 1}, 0)); // in the dark twin of its colour
}

void TrendPaintTest::nothingToShow()
{
    ui::TrendChart chart;
    chart.resize(700, 400);
    chart.show();
    QVERIFY(QTest::qWaitForWindowExposed(&chart));
    chart.advance(5s);
    chart.fit();
    chart.zoomBack();
    chart.setCursorsShown(true);
    QVERIFY(chart.cursorReadings().empty());
    auto* const plot = chart.findChild<QWidget*>(QStringLiteral("trendPlot"));
    for (const int key :
         {Qt::Key_Home, Qt::Key_End, Qt::Key_Left, Qt::Key_Plus, Qt::Key_1, Qt::Key_F})
        QTest::keyClick(plot, Qt::Key(key));
    QVERIFY(!chart.grab().isNull());
    gui::TrendBench bench; // channels without a sample
    bench.chart.advance(5s);
    bench.chart.fit();
    bench.settle();
    QVERIFY(!bench.paintedIn({0, 0, 1, 1}, 0));
    bench.chart.setStore(nullptr);
    bench.settle();
    QVERIFY(bench.chart.cursorReadings().empty());
    bench.chart.resize(30, 20); // no room for a plot
    bench.settle();
}

void TrendPaintTest::constantSignal()
{
    gui::TrendBench bench;
    bench.fill(0, 10s, [](double t) { return 7.4 + 0.01 * std::sin(t * 99); });
    bench.chart.advance(10s);
    bench.settle();
    QVERIFY(bench.paintedIn({0.2, 0.15, 0.6, 0.7}, 0)); // away from the edges
    QVERIFY(!bench.paintedIn({0.2, 0, 0.6, 0.15}, 0));
    QVERIFY(!bench.paintedIn({0.2, 0.85, 0.6, 0.15}, 0));
}

void TrendPaintTest::oddNumbers()
{
    gui::TrendBench bench;
    for (int i = 0; i < 100; ++i) {
        const double odd[] = {1, qQNaN(), qInf(), -qInf(), 2};
        bench.store.append(bench.ids[0], i * 100ms, odd[i % 5]);
        bench.store.append(bench.ids[1], i * 100ms, i % 2 ? 1e300 : -1e300);
    }
    bench.chart.advance(10s);
    bench.chart.setCursors(1s, 9s);
    bench.settle();
    bench.chart.fit();
    bench.settle();
    bench.chart.setChannelScale(1, 1e300, 0);
    bench.settle();
    QVERIFY(!bench.picture().isNull());
}

void TrendPaintTest::clockJump()
{
    gui::TrendBench bench;
    bench.fill(0, 5s, [](double) { return 1.0; });
    bench.store.gap(bench.ids[0]);
    bench.fillFrom(0, 9h, 9h + 5s, [](double) { return 2.0; });
    bench.chart.advance(5s);
    bench.settle();
    bench.chart.advance(9h + 5s);
    bench.settle();
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{9h - 5s, 9h + 5s}));
    QVERIFY(!bench.paintedIn({0.02, 0, 0.45, 1}, 0));
    QVERIFY(bench.paintedIn({0.55, 0, 0.4, 1}, 0));
    bench.chart.fit();
    bench.settle();
    QVERIFY(bench.chart.width() > 9h);
    bench.chart.advance(1s); // and back: another clock
    bench.chart.setFollowing(true);
    bench.settle();
    QCOMPARE(bench.chart.shown().to, Duration(1s));
}

void TrendPaintTest::marksAreSeen()
{
    gui::TrendBench bench;
    bench.chart.show({0s, 10s});
    bench.settle();
    const QImage without = bench.picture();
    std::vector<record::Mark> marks{{5s, record::MarkKind::Fault, 1, QStringLiteral("overload")}};
    bench.chart.setMarks(&marks);
    bench.settle();
    const QImage with = bench.picture();
    const QPoint on = bench.at({0.5, 0.5});
    int changed = 0;
    for (int x = on.x() - 2; x <= on.x() + 2; ++x)
        changed += with.pixel(x, on.y()) != without.pixel(x, on.y()) ? 1 : 0;
    QCOMPARE(changed, 1);
    marks.clear();
    for (int i = 0; i < 20000; ++i) // dense ones are merged
        marks.push_back({i * 500us, record::MarkKind::Write, 1, QStringLiteral("w")});
    bench.chart.setMarks(nullptr);
    bench.chart.setMarks(&marks);
    bench.settle();
    int lines = 0;
    const int y = bench.at({0.5, 0.5}).y();
    for (int x = int(bench.area().left()); x < int(bench.area().right()); ++x)
        lines += bench.picture().pixel(x, y) != without.pixel(x, y) ? 1 : 0;
    QVERIFY(lines > 10 && lines < int(bench.area().width()) / 15);
}

void TrendPaintTest::languageChange()
{
    gui::TrendBench bench;
    bench.plot->setAccessibleName({});
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&bench.chart, &change);
    QVERIFY(!bench.plot->accessibleName().isEmpty());
    QVERIFY(!bench.plot->toolTip().isEmpty());
}

QTEST_MAIN(TrendPaintTest)
#include "tst_trend_chart_paint.moc"
