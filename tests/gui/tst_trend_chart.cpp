// SPDX-License-Identifier: GPL-3.0-or-later
// The trend chart under mouse, wheel and keys: what it shows, what it reads between its cursors.
#include "gui/trend_bench.h"

#include <QChart>
#include <QLegendMarker>
#include <QSignalSpy>

#include <cmath>

using namespace std::chrono_literals;
using base::Duration;

namespace {
double seconds(Duration span)
{
    return double(span.count()) / 1e6;
}
} // namespace

class TrendChartTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin)"))); }
    void followsTheNewest();
    void pauseFreezesThePicture();
    void boxGivesItsTimesAndValues();
    void flatBoxLeavesTheValues();
    void doubleClickIsTheWayBack();
    void wheelZoomsAroundTheMouse();
    void wheelWhileFollowingKeepsNow();
    void shiftWheelZoomsValues();
    void ctrlDragPans();
    void keysDoWhatTheMouseDoes();
    void cursorsAreDraggedAndNudged();
    void readingsAreThoseOfPlainArithmetic();
    void legendAndDigitsHide();
    void overviewMovesTheView();
    void pinchZooms();
};

void TrendChartTest::followsTheNewest()
{
    gui::TrendBench bench;
    bench.fill(0, 20s, [](double t) { return t; });
    bench.chart.setWidth(5s);
    bench.chart.advance(20s);
    QVERIFY(bench.chart.following());
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{15s, 20s}));
    bench.fill(0, 21s, [](double t) { return t; });
    bench.chart.advance(21s);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{16s, 21s}));
    QCOMPARE(bench.chart.width(), Duration(5s));
}

void TrendChartTest::pauseFreezesThePicture()
{
    gui::TrendBench bench;
    const auto wave = [](double t) { return std::sin(t * 3); };
    bench.fill(0, 10s, wave);
    bench.chart.advance(10s);
    bench.settle();
    QTest::keyClick(bench.plot, Qt::Key_Space);
    QVERIFY(!bench.chart.following());
    const record::TimeSpan shown = bench.chart.shown();
    bench.settle();
    const QImage before = bench.picture();
    for (int i = 1; i < 40; ++i) {
        bench.fill(0, 10s + i * 33ms, wave);
        bench.chart.advance(10s + i * 33ms);
        QCoreApplication::processEvents();
    }
    QCOMPARE(bench.store.latest(bench.ids[0])->at / 1s, Duration(11s) / 1s);
    QCOMPARE(bench.chart.shown(), shown);
    QVERIFY(bench.picture() == before);
    QTest::keyClick(bench.plot, Qt::Key_Space);
    QVERIFY(bench.chart.following());
    QVERIFY(bench.chart.shown().to > shown.to);
}

void TrendChartTest::boxGivesItsTimesAndValues()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.show({0s, 100s});
    bench.settle();
    const QRectF area = bench.area();
    bench.drag(Qt::LeftButton, Qt::NoModifier, {0.25, 0.25}, {0.75, 0.5});
    const double pixel = 100.0 / area.width();
    QVERIFY(!bench.chart.following());
    QVERIFY(std::abs(seconds(bench.chart.shown().from) - 25) <= 1.5 * pixel);
    QVERIFY(std::abs(seconds(bench.chart.shown().to) - 75) <= 1.5 * pixel);
    bench.settle();
    // Of the values the lower middle was taken: at 0.375 of the new width the curve (37.5 + …)
    // stands where the old picture had it, so the middle of what is shown is on the plot.
    QVERIFY(bench.paintedIn({0.05, 0, 0.4, 1}, 0));
    QVERIFY(!bench.paintedIn({0.7, 0, 0.28, 1}, 0));
}

void TrendChartTest::flatBoxLeavesTheValues()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.show({0s, 100s});
    bench.settle();
    bench.drag(Qt::LeftButton, Qt::NoModifier, {0.4, 0.5}, {0.6, 0.5});
    bench.settle();
    QVERIFY(bench.paintedIn({0, 0, 0.1, 1}, 0)); // the axis fits what is in view
    QVERIFY(bench.paintedIn({0.9, 0, 0.1, 1}, 0));
    const record::TimeSpan shown = bench.chart.shown();
    QVERIFY(shown.from > 38s && shown.from < 42s && shown.to > 58s && shown.to < 62s);
}

void TrendChartTest::doubleClickIsTheWayBack()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.advance(100s);
    bench.settle();
    bench.drag(Qt::LeftButton, Qt::NoModifier, {0.2, 0.2}, {0.4, 0.8});
    const record::TimeSpan first = bench.chart.shown();
    bench.drag(Qt::LeftButton, Qt::NoModifier, {0.2, 0.2}, {0.4, 0.8});
    QVERIFY(!(bench.chart.shown() == first));
    QTest::mouseDClick(bench.plot->viewport(), Qt::LeftButton, Qt::NoModifier,
                       bench.at({0.5, 0.5}));
    QCOMPARE(bench.chart.shown(), first);
    bench.chart.zoomBack();
    QVERIFY(bench.chart.following());
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{90s, 100s}));
    bench.chart.zoomBack(); // nothing before that
    QVERIFY(bench.chart.following());
}

void TrendChartTest::wheelZoomsAroundTheMouse()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.show({0s, 100s});
    bench.settle();
    bench.wheel({0.25, 0.5}, 120);
    const record::TimeSpan shown = bench.chart.shown();
    QVERIFY(std::abs(seconds(shown.to - shown.from) - 80) < 0.01);
    const double under = seconds(shown.from) + 0.25 * seconds(shown.to - shown.from);
    QVERIFY(std::abs(under - 25) < 0.3);
    bench.wheel({0.25, 0.5}, -120);
    QVERIFY(std::abs(seconds(bench.chart.width()) - 100) < 0.01);
}

void TrendChartTest::wheelWhileFollowingKeepsNow()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.advance(100s);
    bench.settle();
    bench.wheel({0.25, 0.5}, 120);
    QVERIFY(bench.chart.following());
    QCOMPARE(bench.chart.shown().to, Duration(100s));
    QCOMPARE(bench.chart.width(), Duration(8s));
}

void TrendChartTest::shiftWheelZoomsValues()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.show({0s, 100s});
    bench.settle();
    QVERIFY(bench.paintedIn({0.9, 0, 0.1, 1}, 0));
    for (int i = 0; i < 4; ++i)
        bench.wheel({0.5, 0.1}, 120, Qt::ShiftModifier);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{0s, 100s}));
    bench.settle();
    QVERIFY(!bench.paintedIn({0.9, 0, 0.1, 1}, 0)); // its end has left the plot at the top
    QVERIFY(bench.paintedIn({0.05, 0, 0.1, 1}, 0));
    bench.chart.fit();
    bench.settle();
    QVERIFY(bench.paintedIn({0.9, 0, 0.1, 1}, 0));
}

void TrendChartTest::ctrlDragPans()
{
    for (const bool middle : {false, true}) {
        gui::TrendBench bench;
        bench.fill(0, 100s, [](double t) { return t; });
        bench.chart.show({40s, 60s});
        bench.settle();
        bench.drag(middle ? Qt::MiddleButton : Qt::LeftButton,
                   middle ? Qt::NoModifier : Qt::ControlModifier, {0.2, 0.5}, {0.7, 0.5});
        QVERIFY(std::abs(seconds(bench.chart.shown().from) - 30) < 0.2);
        QVERIFY(std::abs(seconds(bench.chart.width()) - 20) < 0.001);
    }
}

void TrendChartTest::keysDoWhatTheMouseDoes()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.advance(100s);
    bench.chart.setFocus(Qt::TabFocusReason);
    QTRY_COMPARE(QApplication::focusWidget(), bench.plot);
    QTest::keyClick(bench.plot, Qt::Key_Left);
    QVERIFY(!bench.chart.following());
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{89s, 99s}));
    QTest::keyClick(bench.plot, Qt::Key_Right);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{90s, 100s}));
    QTest::keyClick(bench.plot, Qt::Key_PageUp);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{80s, 90s}));
    QTest::keyClick(bench.plot, Qt::Key_Plus);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{81s, 89s}));
    QTest::keyClick(bench.plot, Qt::Key_Minus);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{80s, 90s}));
    QTest::keyClick(bench.plot, Qt::Key_Home);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{0s, 10s}));
    QTest::keyClick(bench.plot, Qt::Key_End);
    QVERIFY(bench.chart.following());
    QTest::keyClick(bench.plot, Qt::Key_F);
    QVERIFY(bench.chart.shown().from <= 0s && bench.chart.shown().to >= 99s);
    QTest::keyClick(bench.plot, Qt::Key_Backspace);
    QVERIFY(bench.chart.following());
    QTest::keyClick(bench.plot, Qt::Key_C);
    QVERIFY(bench.chart.cursorsShown());
    QTest::keyClick(bench.plot, Qt::Key_C);
    QVERIFY(!bench.chart.cursorsShown());
}

void TrendChartTest::cursorsAreDraggedAndNudged()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.show({0s, 100s});
    bench.chart.setCursors(20s, 80s);
    bench.settle();
    QSignalSpy changed(&bench.chart, &ui::TrendChart::cursorsChanged);
    bench.drag(Qt::LeftButton, Qt::NoModifier, {0.2, 0.5}, {0.4, 0.5});
    QVERIFY(changed.count() > 0);
    QCOMPARE(bench.chart.shown(), (record::TimeSpan{0s, 100s})); // no box
    const double pixel = 100.0 / bench.area().width();
    QVERIFY(std::abs(seconds(bench.chart.cursors()->from) - 40) < 1.5 * pixel);
    QCOMPARE(bench.chart.cursors()->to, Duration(80s));
    bench.chart.setCursors(20s, 80s);
    QTest::keyClick(bench.plot, Qt::Key_BracketRight);
    QVERIFY(std::abs(seconds(bench.chart.cursors()->from) - 20 - pixel) < 1e-3);
    QTest::keyClick(bench.plot, Qt::Key_BraceLeft, Qt::ShiftModifier);
    QVERIFY(std::abs(seconds(bench.chart.cursors()->to) - 80 + pixel) < 1e-3);
    QTest::keyClick(bench.plot, Qt::Key_BracketLeft, Qt::ControlModifier);
    QVERIFY(std::abs(seconds(bench.chart.cursors()->from) - 20 + 9 * pixel) < 1e-3);
}

void TrendChartTest::readingsAreThoseOfPlainArithmetic()
{
    gui::TrendBench bench;
    const auto value = [](double t) { return 3 * t + std::sin(t * 7); };
    bench.fill(0, 60s, value);
    bench.chart.show({0s, 60s});
    bench.chart.setCursors(41003ms, 12s); // B before A
    double sum = 0, squares = 0, tt = 0, ty = 0, tSum = 0;
    double min = 1e9, max = -1e9;
    int n = 0;
    for (const record::SamplePoint& p : bench.sent[0]) {
        if (p.at < 12s || p.at > 41003ms)
            continue;
        const double t = seconds(p.at);
        ++n;
        sum += p.value;
        tSum += t;
        min = std::min(min, p.value);
        max = std::max(max, p.value);
    }
    for (const record::SamplePoint& p : bench.sent[0]) {
        if (p.at < 12s || p.at > 41003ms)
            continue;
        const double t = seconds(p.at) - tSum / n;
        squares += (p.value - sum / n) * (p.value - sum / n);
        tt += t * t;
        ty += t * (p.value - sum / n);
    }
    const auto readings = bench.chart.cursorReadings();
    QCOMPARE(readings.size(), std::size_t(2));
    const ui::CursorReading& r = readings[0];
    QCOMPARE(r.channel, QStringLiteral("1/a"));
    QCOMPARE(*r.a, value(41.0));
    QCOMPARE(*r.b, value(12.0));
    QCOMPARE(r.between.count, std::uint64_t(n));
    QVERIFY(r.between.exact);
    QCOMPARE(r.between.min, min);
    QCOMPARE(r.between.max, max);
    QVERIFY(std::abs(r.between.mean - sum / n) < 1e-9);
    QVERIFY(std::abs(r.between.sigma - std::sqrt(squares / n)) < 1e-8);
    QVERIFY(std::abs(r.between.slope - ty / tt) < 1e-8);
    QVERIFY(!readings[1].a && readings[1].between.count == 0);
}

void TrendChartTest::legendAndDigitsHide()
{
    gui::TrendBench bench;
    bench.fill(0, 10s, [](double t) { return t; });
    bench.fill(1, 10s, [](double t) { return 10 - t; });
    bench.chart.show({0s, 10s});
    bench.settle();
    QSignalSpy changed(&bench.chart, &ui::TrendChart::channelsChanged);
    QLegendMarker* const marker = bench.plot->chart()->legend()->markers().front();
    QVERIFY(!bench.plot->chart()->legend()->childItems().isEmpty());
    const QRectF legend = bench.plot->chart()->legend()->geometry();
    QTest::mouseClick(bench.plot->viewport(), Qt::LeftButton, {},
                      bench.plot->mapFromScene(legend.left() + 30, legend.top() + 12));
    QCOMPARE(changed.count(), 1);
    QVERIFY(!bench.chart.channels()[0].visible);
    bench.settle();
    QVERIFY(!bench.paintedIn({0, 0, 1, 1}, 0));
    QVERIFY(bench.paintedIn({0, 0, 1, 1}, 1));
    QVERIFY(marker->isVisible()); // to bring it back
    QTest::keyClick(bench.plot, Qt::Key_2);
    QVERIFY(!bench.chart.channels()[1].visible);
    QTest::keyClick(bench.plot, Qt::Key_1);
    bench.settle();
    QVERIFY(bench.paintedIn({0, 0, 1, 1}, 0));
    QVERIFY(!bench.paintedIn({0, 0, 1, 1}, 1));
}

void TrendChartTest::overviewMovesTheView()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.show({0s, 20s});
    bench.settle();
    auto* const strip = bench.chart.findChild<QWidget*>(QStringLiteral("trendOverview"));
    const auto at = [&](double share) { return QPoint(int(share * strip->width()), 20); };
    const auto drag = [&](double from, double to) {
        QTest::mousePress(strip, Qt::LeftButton, {}, at(from));
        gui::TrendBench::moveTo(strip, at(to), Qt::LeftButton);
        QTest::mouseRelease(strip, Qt::LeftButton, {}, at(to));
        bench.settle();
    };
    drag(0.1, 0.5);
    QVERIFY(std::abs(seconds(bench.chart.shown().from) - 40) < 0.5);
    QVERIFY(std::abs(seconds(bench.chart.width()) - 20) < 0.01);
    drag(0.6, 0.8); // the right edge
    QVERIFY(std::abs(seconds(bench.chart.shown().from) - 40) < 0.5);
    QVERIFY(std::abs(seconds(bench.chart.shown().to) - 80) < 0.7);
    QTest::mouseClick(strip, Qt::LeftButton, {}, at(0.2)); // beside the handle
    QVERIFY(std::abs(seconds(bench.chart.shown().from) - 0) < 0.7);
    bench.chart.zoomBack();
    QVERIFY(std::abs(seconds(bench.chart.shown().from) - 40) < 0.5);
}

/// Two fingers that part: closer, and the box of the first one is forgotten.
void TrendChartTest::pinchZooms()
{
    gui::TrendBench bench;
    bench.fill(0, 100s, [](double t) { return t; });
    bench.chart.show({0s, 100s});
    bench.settle();
    const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
    QWidget* const view = bench.plot->viewport();
    const auto left = [&](double by) { return bench.at({0.45 - by, 0.5}); };
    const auto right = [&](double by) { return bench.at({0.55 + by, 0.5}); };
    QTest::touchEvent(view, screen.get()).press(0, left(0), view).press(1, right(0), view);
    for (double by = 0.02; by < 0.21; by += 0.02)
        QTest::touchEvent(view, screen.get()).move(0, left(by), view).move(1, right(by), view);
    QTest::touchEvent(view, screen.get()).release(0, left(0.2), view).release(1, right(0.2), view);
    QVERIFY(bench.chart.width() < 60s);
    QVERIFY(bench.chart.shown().from < 50s && bench.chart.shown().to > 50s);
}

QTEST_MAIN(TrendChartTest)
#include "tst_trend_chart.moc"
