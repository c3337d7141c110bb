// SPDX-License-Identifier: GPL-3.0-or-later
// The trend chart with mouse, wheel and keys: what it shows, and what it reads between its cursors.
#include "gui/trend_chart_fixture.h"
#include "support/test_main.h"

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

class TestTrendChart : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin)"))); }
    void followsTheNewest();
    void pauseFreezesThePicture();
    void boxGivesItsTimesAndValues();
    void flatBoxLeavesTheValues();
    void backRestoresEachView();
    void doubleClickShowsEverything();
    void wheelZoomsAroundTheMouse();
    void wheelWhileFollowingKeepsTheRightEdge();
    void shiftWheelZoomsValues();
    void stepsBetweenTwoFramesAddUp();
    void dragPans();
    void aClickThatShakesPansNothing();
    void draggingDownLeavesTheScale();
    void anotherButtonDoesNotEndADrag();
    void shiftDragPansValues();
    void offScaleIsSaidAndFitted();
    void valuesBeforeAxisFromDoNotWidenTheAxis();
    void keysMatchTheMouse();
    void cursorsAreDraggedAndNudged();
    void arrowsStepACursorBySamples();
    void arrowsCrossGapsAndLeaveTheView();
    void nothingIsReadOutsideTheData();
    void readoutsMatchPlainArithmetic();
    void legendAndDigitKeysHideChannels();
    void overviewMovesTheView();
    void pinchZooms();
};

void TestTrendChart::followsTheNewest()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 20s, [](double t) { return t; });
    fixture.chart.setWidth(5s);
    fixture.chart.advance(20s);
    QVERIFY(fixture.chart.isFollowing());
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{15s, 20s}));
    fixture.fill(0, 21s, [](double t) { return t; });
    fixture.chart.advance(21s);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{16s, 21s}));
    QCOMPARE(fixture.chart.width(), Duration(5s));
}

void TestTrendChart::pauseFreezesThePicture()
{
    gui::TrendChartFixture fixture;
    const auto wave = [](double t) { return std::sin(t * 3); };
    fixture.fill(0, 10s, wave);
    fixture.chart.advance(10s);
    fixture.waitForFrames();
    QTest::keyClick(fixture.plot, Qt::Key_Space);
    QVERIFY(!fixture.chart.isFollowing());
    const recording::TimeSpan shown = fixture.chart.shown();
    fixture.waitForFrames();
    const QImage before = fixture.picture();
    for (int i = 1; i < 40; ++i) {
        fixture.fill(0, 10s + i * 33ms, wave);
        fixture.chart.advance(10s + i * 33ms);
        QCoreApplication::processEvents();
    }
    QCOMPARE(fixture.store.latest(fixture.ids[0])->at / 1s, Duration(11s) / 1s);
    QCOMPARE(fixture.chart.shown(), shown);
    QVERIFY(fixture.picture() == before);
    QTest::keyClick(fixture.plot, Qt::Key_Space);
    QVERIFY(fixture.chart.isFollowing());
    QVERIFY(fixture.chart.shown().to > shown.to);
}

void TestTrendChart::boxGivesItsTimesAndValues()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 100s});
    fixture.waitForFrames();
    const QRectF area = fixture.area();
    fixture.drag(Qt::LeftButton, Qt::ControlModifier, {0.25, 0.25}, {0.75, 0.5});
    const double pixel = 100.0 / area.width();
    QVERIFY(!fixture.chart.isFollowing());
    QVERIFY(std::abs(seconds(fixture.chart.shown().from) - 25) <= 1.5 * pixel);
    QVERIFY(std::abs(seconds(fixture.chart.shown().to) - 75) <= 1.5 * pixel);
    fixture.waitForFrames();
    // Of the values the lower middle was taken: at 0.375 of the new width the curve (37.5 + …)
    // stands where the old picture had it, so the middle of what is shown is on the plot.
    QVERIFY(fixture.paintedIn({0.05, 0, 0.4, 1}, 0));
    QVERIFY(!fixture.paintedIn({0.7, 0, 0.28, 1}, 0));
}

void TestTrendChart::flatBoxLeavesTheValues()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 100s});
    fixture.waitForFrames();
    fixture.drag(Qt::LeftButton, Qt::ControlModifier, {0.4, 0.5}, {0.6, 0.5});
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0, 0, 0.1, 1}, 0)); // the axis fits what is in view
    QVERIFY(fixture.paintedIn({0.9, 0, 0.1, 1}, 0));
    const recording::TimeSpan shown = fixture.chart.shown();
    QVERIFY(shown.from > 38s && shown.from < 42s && shown.to > 58s && shown.to < 62s);
}

void TestTrendChart::backRestoresEachView()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.advance(100s);
    fixture.waitForFrames();
    fixture.drag(Qt::LeftButton, Qt::ControlModifier, {0.2, 0.2}, {0.4, 0.8});
    const recording::TimeSpan first = fixture.chart.shown();
    fixture.drag(Qt::LeftButton, Qt::ControlModifier, {0.2, 0.2}, {0.4, 0.8});
    QVERIFY(!(fixture.chart.shown() == first));
    fixture.chart.zoomBack();
    QCOMPARE(fixture.chart.shown(), first);
    fixture.chart.zoomBack();
    QVERIFY(fixture.chart.isFollowing());
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{90s, 100s}));
    fixture.chart.zoomBack(); // nothing before that
    QVERIFY(fixture.chart.isFollowing());
}

void TestTrendChart::doubleClickShowsEverything()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({40s, 45s});
    fixture.waitForFrames();
    fixture.wheel({0.5, 0.5}, 240, Qt::ShiftModifier);
    QTest::mouseDClick(fixture.plot->viewport(), Qt::LeftButton, Qt::NoModifier,
                       fixture.at({0.5, 0.5}));
    QVERIFY(fixture.chart.shown().from <= 0s && fixture.chart.shown().to >= 100s);
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0.03, 0, 0.1, 0.1}, 0)); // both ends of the curve
    QVERIFY(fixture.paintedIn({0.9, 0.85, 0.1, 0.15}, 0));
}

void TestTrendChart::wheelZoomsAroundTheMouse()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 100s});
    fixture.waitForFrames();
    fixture.wheel({0.25, 0.5}, 120);
    const recording::TimeSpan shown = fixture.chart.shown();
    QVERIFY(std::abs(seconds(shown.to - shown.from) - 80) < 0.01);
    const double under = seconds(shown.from) + 0.25 * seconds(shown.to - shown.from);
    QVERIFY(std::abs(under - 25) < 0.3);
    fixture.wheel({0.25, 0.5}, -120);
    QVERIFY(std::abs(seconds(fixture.chart.width()) - 100) < 0.01);
}

void TestTrendChart::wheelWhileFollowingKeepsTheRightEdge()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.advance(100s);
    fixture.waitForFrames();
    fixture.wheel({0.25, 0.5}, 120);
    QVERIFY(fixture.chart.isFollowing());
    QCOMPARE(fixture.chart.shown().to, Duration(100s));
    QCOMPARE(fixture.chart.width(), Duration(8s));
}

void TestTrendChart::shiftWheelZoomsValues()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 100s});
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0.9, 0, 0.1, 1}, 0));
    for (int i = 0; i < 4; ++i)
        fixture.wheel({0.5, 0.1}, 120, Qt::ShiftModifier);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 100s}));
    fixture.waitForFrames();
    QVERIFY(!fixture.paintedIn({0.9, 0, 0.1, 1}, 0)); // its end has left the plot at the top
    QVERIFY(fixture.paintedIn({0.05, 0, 0.1, 1}, 0));
    fixture.chart.zoomToFit();
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0.9, 0, 0.1, 1}, 0));
}

/// The wheel turns faster than frames are painted.
void TestTrendChart::stepsBetweenTwoFramesAddUp()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t; });
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    const ui::AutoRange& axis = fixture.plot->picture().axes().axisOf({}).range;
    const double before = axis.range().size();
    fixture.wheel({0.5, 0.5}, 120, Qt::ShiftModifier);
    const double once = axis.range().size();
    QVERIFY(once < before * 0.9);
    for (int i = 0; i < 3; ++i)
        fixture.wheel({0.5, 0.5}, 120, Qt::ShiftModifier);
    QVERIFY(std::abs(axis.range().size() / before - std::pow(once / before, 4)) < 1e-6);
}

void TestTrendChart::dragPans()
{
    for (const bool middle : {false, true}) {
        gui::TrendChartFixture fixture;
        fixture.fill(0, 100s, [](double t) { return t; });
        fixture.chart.show({40s, 60s});
        fixture.waitForFrames();
        fixture.drag(middle ? Qt::MiddleButton : Qt::LeftButton, Qt::NoModifier, {0.2, 0.5},
                     {0.7, 0.5});
        QVERIFY(std::abs(seconds(fixture.chart.shown().from) - 30) < 0.2);
        QVERIFY(std::abs(seconds(fixture.chart.width()) - 20) < 0.001);
    }
}

void TestTrendChart::aClickThatShakesPansNothing()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.advance(100s);
    fixture.waitForFrames();
    QWidget* const viewport = fixture.plot->viewport();
    const QPoint place = fixture.at({0.5, 0.5});
    QTest::mousePress(viewport, Qt::LeftButton, {}, place);
    gui::TrendChartFixture::moveTo(viewport, place + QPoint(2, 1), Qt::LeftButton);
    QTest::mouseRelease(viewport, Qt::LeftButton, {}, place + QPoint(2, 1));
    QVERIFY(fixture.chart.isFollowing());
    QTest::mousePress(viewport, Qt::LeftButton, {}, place);
    gui::TrendChartFixture::moveTo(viewport, place + QPoint(80, 0), Qt::LeftButton);
    gui::TrendChartFixture::moveTo(viewport, place + QPoint(1, 0), Qt::LeftButton);
    QTest::mouseRelease(viewport, Qt::LeftButton, {}, place + QPoint(1, 0));
    QVERIFY(!fixture.chart.isFollowing()); // there and back is a drag
    QVERIFY(std::abs(seconds(fixture.chart.shown().to) - 100) < 0.1);
}

/// And a way back is kept.
void TestTrendChart::draggingDownLeavesTheScale()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({40s, 60s});
    fixture.waitForFrames();
    fixture.drag(Qt::LeftButton, Qt::NoModifier, {0.5, 0.7}, {0.5, 0.2});
    QVERIFY(!fixture.plot->picture().axes().axisOf({}).range.isFixed());
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{40s, 60s}));
    fixture.drag(Qt::LeftButton, Qt::NoModifier, {0.2, 0.5}, {0.7, 0.5});
    QVERIFY(fixture.chart.shown().from < 31s);
    fixture.chart.zoomBack();
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{40s, 60s}));
}

void TestTrendChart::anotherButtonDoesNotEndADrag()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 100s});
    fixture.waitForFrames();
    QWidget* const viewport = fixture.plot->viewport();
    QTest::mousePress(viewport, Qt::LeftButton, Qt::ControlModifier, fixture.at({0.2, 0.5}));
    gui::TrendChartFixture::moveTo(viewport, fixture.at({0.4, 0.5}), Qt::LeftButton,
                                   Qt::ControlModifier);
    QTest::mousePress(viewport, Qt::RightButton, {}, fixture.at({0.4, 0.5}));
    QTest::mouseRelease(viewport, Qt::RightButton, {}, fixture.at({0.4, 0.5}));
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 100s}));
    QTest::mouseRelease(viewport, Qt::LeftButton, Qt::ControlModifier, fixture.at({0.4, 0.5}));
    QVERIFY(fixture.chart.width() < 22s); // the box
}

void TestTrendChart::shiftDragPansValues()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t; });
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    const ui::TrendAxes::ValueAxis& axis = fixture.plot->picture().axes().axisOf({});
    const ui::AxisRange before = axis.shown;
    fixture.drag(Qt::LeftButton, Qt::ShiftModifier, {0.2, 0.2}, {0.6, 0.7});
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 10s}));
    QVERIFY(std::abs(axis.shown.low - (before.low - 0.5 * before.size())) < 0.05);
    QVERIFY(std::abs(axis.shown.size() - before.size()) < 1e-6);
}

/// Only where the user has set the scale; a click on the chip lets it follow the curve again.
void TestTrendChart::offScaleIsSaidAndFitted()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t; });
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    const ui::OffScaleChips& chips = fixture.plot->picture().offScaleChips();
    const auto chip = [&]() -> std::optional<QPoint> {
        for (double y = 1; y > 0; y -= 0.01) {
            const QPoint place = fixture.at({0.95, y});
            if (chips.unitAt(fixture.plot->mapToScene(place)))
                return place;
        }
        return {};
    };
    QVERIFY(!chip());
    fixture.drag(Qt::LeftButton, Qt::ShiftModifier, {0.2, 0.2}, {0.2, 0.6}); // up by 0.4
    fixture.waitForFrames();
    QVERIFY(chip());
    QVERIFY(chip()->y() < fixture.at({0, 0.5}).y()); // at the top, where the curve left
    fixture.drag(Qt::LeftButton, Qt::ShiftModifier, {0.2, 0.9}, {0.2, 0.2});
    fixture.waitForFrames();
    QVERIFY(chip());
    QVERIFY(chip()->y() > fixture.at({0, 0.5}).y());
    QTest::mouseClick(fixture.plot->viewport(), Qt::LeftButton, {}, *chip());
    fixture.waitForFrames();
    QVERIFY(!chip());
    QVERIFY(!fixture.plot->picture().axes().axisOf({}).range.isFixed());
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 10s}));
}

void TestTrendChart::valuesBeforeAxisFromDoNotWidenTheAxis()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return 1000 + t; });
    fixture.fill(1, 10s, [](double t) { return t < 5 ? 0 : 1500; });
    const auto shown = [&](Duration axisFrom, const recording::TimeSpan& view) {
        fixture.channels[1].axisFrom = axisFrom;
        fixture.chart.setChannels(fixture.channels);
        fixture.chart.show(view);
        fixture.waitForFrames();
        return fixture.plot->picture().axes().axisOf({}).shown;
    };
    QVERIFY(shown(Duration::min(), {0s, 10s}).low <= 0);
    const ui::AxisRange later = shown(5s, {0s, 9s});
    QVERIFY(later.low > 900 && later.high >= 1500);
    const ui::AxisRange never = shown(Duration::max(), {0s, 10s});
    QVERIFY(never.low > 900 && never.high < 1200);
    fixture.channels[0].visible = false; // alone on its axis, it is shown as it is
    QVERIFY(shown(Duration::max(), {0s, 9s}).low <= 0);
}

void TestTrendChart::keysMatchTheMouse()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.advance(100s);
    fixture.chart.setFocus(Qt::TabFocusReason);
    QTRY_COMPARE(QApplication::focusWidget(), fixture.plot);
    QTest::keyClick(fixture.plot, Qt::Key_Left);
    QVERIFY(!fixture.chart.isFollowing());
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{89s, 99s}));
    QTest::keyClick(fixture.plot, Qt::Key_Right);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{90s, 100s}));
    QTest::keyClick(fixture.plot, Qt::Key_PageUp);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{80s, 90s}));
    QTest::keyClick(fixture.plot, Qt::Key_Plus);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{81s, 89s}));
    QTest::keyClick(fixture.plot, Qt::Key_Minus);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{80s, 90s}));
    QTest::keyClick(fixture.plot, Qt::Key_Home);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 10s}));
    QTest::keyClick(fixture.plot, Qt::Key_End);
    QVERIFY(fixture.chart.isFollowing());
    QTest::keyClick(fixture.plot, Qt::Key_F);
    QVERIFY(fixture.chart.shown().from <= 0s && fixture.chart.shown().to >= 99s);
    QTest::keyClick(fixture.plot, Qt::Key_Backspace);
    QVERIFY(fixture.chart.isFollowing());
    QTest::keyClick(fixture.plot, Qt::Key_C);
    QVERIFY(fixture.chart.areCursorsVisible());
    QTest::keyClick(fixture.plot, Qt::Key_C);
    QVERIFY(!fixture.chart.areCursorsVisible());
}

void TestTrendChart::cursorsAreDraggedAndNudged()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 100s});
    fixture.chart.setCursors(20s, 80s);
    fixture.waitForFrames();
    QSignalSpy changed(&fixture.chart, &ui::TrendChart::cursorsChanged);
    fixture.drag(Qt::LeftButton, Qt::NoModifier, {0.2, 0.5}, {0.4, 0.5});
    QVERIFY(changed.count() > 0);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 100s})); // no box
    const double pixel = 100.0 / fixture.area().width();
    QVERIFY(std::abs(seconds(fixture.chart.cursors()->from) - 40) < 1.5 * pixel);
    QCOMPARE(fixture.chart.cursors()->to, Duration(80s));
    fixture.chart.setCursors(20s, 80s);
    QTest::keyClick(fixture.plot, Qt::Key_BracketRight);
    QVERIFY(std::abs(seconds(fixture.chart.cursors()->from) - 20 - pixel) < 1e-3);
    QTest::keyClick(fixture.plot, Qt::Key_BraceLeft, Qt::ShiftModifier);
    QVERIFY(std::abs(seconds(fixture.chart.cursors()->to) - 80 + pixel) < 1e-3);
    QTest::keyClick(fixture.plot, Qt::Key_BracketLeft, Qt::ControlModifier);
    QVERIFY(std::abs(seconds(fixture.chart.cursors()->from) - 20 + 9 * pixel) < 1e-3);
}

/// Channels are measured at different instants; the cursor stops at each of them.
void TestTrendChart::arrowsStepACursorBySamples()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t; }); // every 10 ms
    for (const Duration at : {5003ms, 5004ms, 9s + 5ms})
        fixture.put(1, at, 1);
    fixture.chart.show({0s, 10s});
    fixture.chart.setCursors(5s, 8s);
    fixture.waitForFrames();
    for (const Duration expected : {5003ms, 5004ms, 5010ms, 5020ms}) {
        QTest::keyClick(fixture.plot, Qt::Key_Right);
        QCOMPARE(fixture.chart.cursors()->from, expected);
    }
    for (const Duration expected : {5010ms, 5004ms, 5003ms, 5000ms, 4990ms}) {
        QTest::keyClick(fixture.plot, Qt::Key_Left);
        QCOMPARE(fixture.chart.cursors()->from, expected);
    }
    QTest::keyClick(fixture.plot, Qt::Key_BracketRight, Qt::ShiftModifier); // now B is the one
    const Duration b = fixture.chart.cursors()->to;
    QTest::keyClick(fixture.plot, Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(fixture.chart.cursors()->to > b + 90ms && fixture.chart.cursors()->to <= b + 100ms);
    QCOMPARE(fixture.chart.cursors()->from, Duration(4990ms));
    fixture.chart.setCursors(1s, 10s);
    QTest::keyClick(fixture.plot, Qt::Key_Right); // nothing is after the last sample
    QCOMPARE(fixture.chart.cursors()->to, Duration(10s));
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 10s}));
    fixture.chart.setCursorsShown(false);
    QTest::keyClick(fixture.plot, Qt::Key_Right);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{1s, 11s})); // without cursors: pans
}

void TestTrendChart::arrowsCrossGapsAndLeaveTheView()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 2s, [](double t) { return t; });
    fixture.store.gap(fixture.ids[0]);
    fixture.fillFrom(0, 60s, 62s, [](double t) { return t; });
    fixture.chart.show({0s, 70s});
    fixture.chart.setCursors(2s, 65s);
    QTest::keyClick(fixture.plot, Qt::Key_Right);
    QCOMPARE(fixture.chart.cursors()->from, Duration(60s));
    QTest::keyClick(fixture.plot, Qt::Key_Left);
    QCOMPARE(fixture.chart.cursors()->from, Duration(2s));
    fixture.chart.show({30s, 34s}); // neither cursor is in view
    QTest::keyClick(fixture.plot, Qt::Key_Right);
    QCOMPARE(fixture.chart.cursors()->from, Duration(60s));
    const recording::TimeSpan shown = fixture.chart.shown();
    QVERIFY(shown.from < 60s && shown.to > 60s);
    QCOMPARE(fixture.chart.width(), Duration(4s));
}

void TestTrendChart::nothingIsReadOutsideTheData()
{
    gui::TrendChartFixture fixture;
    fixture.fillFrom(0, 2s, 4s, [](double t) { return t; });
    fixture.chart.show({0s, 10s});
    for (const auto& [a, b] : {std::pair(1s, 3s), std::pair(3s, 5s)}) {
        fixture.chart.setCursors(a, b);
        const ui::CursorReading reading = fixture.chart.cursorReadings().front();
        QCOMPARE(reading.a.has_value(), a == 3s);
        QCOMPARE(reading.b.has_value(), b == 3s);
    }
}

void TestTrendChart::readoutsMatchPlainArithmetic()
{
    gui::TrendChartFixture fixture;
    const auto value = [](double t) { return 3 * t + std::sin(t * 7); };
    fixture.fill(0, 60s, value);
    fixture.chart.show({0s, 60s});
    fixture.chart.setCursors(41003ms, 12s); // B before A
    double sum = 0, squares = 0, tt = 0, ty = 0, tSum = 0;
    double min = 1e9, max = -1e9;
    int n = 0;
    for (const recording::SamplePoint& p : fixture.sent[0]) {
        if (p.at < 12s || p.at > 41003ms)
            continue;
        const double t = seconds(p.at);
        ++n;
        sum += p.value;
        tSum += t;
        min = std::min(min, p.value);
        max = std::max(max, p.value);
    }
    for (const recording::SamplePoint& p : fixture.sent[0]) {
        if (p.at < 12s || p.at > 41003ms)
            continue;
        const double t = seconds(p.at) - tSum / n;
        squares += (p.value - sum / n) * (p.value - sum / n);
        tt += t * t;
        ty += t * (p.value - sum / n);
    }
    const auto readings = fixture.chart.cursorReadings();
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

void TestTrendChart::legendAndDigitKeysHideChannels()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t; });
    fixture.fill(1, 10s, [](double t) { return 10 - t; });
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    QSignalSpy changed(&fixture.chart, &ui::TrendChart::channelsChanged);
    QLegendMarker* const marker = fixture.plot->chart()->legend()->markers().front();
    QVERIFY(!fixture.plot->chart()->legend()->childItems().isEmpty());
    const QRectF legend = fixture.plot->chart()->legend()->geometry();
    QTest::mouseClick(fixture.plot->viewport(), Qt::LeftButton, {},
                      fixture.plot->mapFromScene(legend.left() + 30, legend.top() + 12));
    QCOMPARE(changed.count(), 1);
    QVERIFY(!fixture.chart.channels()[0].visible);
    fixture.waitForFrames();
    QVERIFY(!fixture.paintedIn({0, 0, 1, 1}, 0));
    QVERIFY(fixture.paintedIn({0, 0, 1, 1}, 1));
    QVERIFY(marker->isVisible()); // to bring it back
    QTest::keyClick(fixture.plot, Qt::Key_2);
    QVERIFY(!fixture.chart.channels()[1].visible);
    QTest::keyClick(fixture.plot, Qt::Key_1);
    fixture.waitForFrames();
    QVERIFY(fixture.paintedIn({0, 0, 1, 1}, 0));
    QVERIFY(!fixture.paintedIn({0, 0, 1, 1}, 1));
}

void TestTrendChart::overviewMovesTheView()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 20s});
    fixture.waitForFrames();
    auto* const strip = fixture.chart.findChild<QWidget*>(QStringLiteral("trendOverview"));
    const auto at = [&](double share) { return QPoint(int(share * strip->width()), 20); };
    const auto drag = [&](double from, double to) {
        QTest::mousePress(strip, Qt::LeftButton, {}, at(from));
        gui::TrendChartFixture::moveTo(strip, at(to), Qt::LeftButton);
        QTest::mouseRelease(strip, Qt::LeftButton, {}, at(to));
        fixture.waitForFrames();
    };
    drag(0.1, 0.5);
    QVERIFY(std::abs(seconds(fixture.chart.shown().from) - 40) < 0.5);
    QVERIFY(std::abs(seconds(fixture.chart.width()) - 20) < 0.01);
    drag(0.6, 0.8); // the right edge
    QVERIFY(std::abs(seconds(fixture.chart.shown().from) - 40) < 0.5);
    QVERIFY(std::abs(seconds(fixture.chart.shown().to) - 80) < 0.7);
    QTest::mouseClick(strip, Qt::LeftButton, {}, at(0.2)); // beside the handle
    QVERIFY(std::abs(seconds(fixture.chart.shown().from) - 0) < 0.7);
    fixture.chart.zoomBack();
    QVERIFY(std::abs(seconds(fixture.chart.shown().from) - 40) < 0.5);
}

/// Two fingers that part: closer, and the box of the first one is forgotten.
void TestTrendChart::pinchZooms()
{
    gui::TrendChartFixture fixture;
    fixture.fill(0, 100s, [](double t) { return t; });
    fixture.chart.show({0s, 100s});
    fixture.waitForFrames();
    const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
    QWidget* const view = fixture.plot->viewport();
    const auto left = [&](double by) { return fixture.at({0.45 - by, 0.5}); };
    const auto right = [&](double by) { return fixture.at({0.55 + by, 0.5}); };
    QTest::touchEvent(view, screen.get()).press(0, left(0), view).press(1, right(0), view);
    for (double by = 0.02; by < 0.21; by += 0.02)
        QTest::touchEvent(view, screen.get()).move(0, left(by), view).move(1, right(by), view);
    QTest::touchEvent(view, screen.get()).release(0, left(0.2), view).release(1, right(0.2), view);
    QVERIFY(fixture.chart.width() < 60s);
    QVERIFY(fixture.chart.shown().from < 50s && fixture.chart.shown().to > 50s);
}

SERVODESK_TEST(TestTrendChart)
#include "tst_trend_chart.moc"
