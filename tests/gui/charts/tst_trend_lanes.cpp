// SPDX-License-Identifier: GPL-3.0-or-later
// Lanes of the trend chart: where curves, grid and texts are, and the heights the user gives them.
#include "gui/trend_chart_fixture.h"
#include "support/test_main.h"

#include <QSignalSpy>

#include <cmath>

using namespace std::chrono_literals;
using base::Duration;

namespace {
/// Position above speed; the position runs from 0 to 100, the speed is 10, and -10 from 5 s.
struct LanesFixture : gui::TrendChartFixture {
    LanesFixture()
    {
        channels[0].unit = QStringLiteral("°");
        channels[1].unit = QStringLiteral("rpm");
        chart.setChannels(channels);
        fill(0, 10s, [](double t) { return 10 * t; });
        fill(1, 10s, [](double t) { return t < 5 ? 20.0 : -20.0; });
        chart.setLanes(true);
        chart.show({0s, 10s});
        waitForFrames();
    }

    ui::TrendAxes& axes() { return plot->picture().axes(); }
    const QRectF& laneOf(const char* unit) { return axes().axisOf(QString::fromUtf8(unit)).area; }
    /// From the lower left of the plot.
    QRectF sharesOf(const QRectF& lane) const
    {
        const QRectF plotArea = area();
        return {0, (plotArea.bottom() - lane.bottom()) / plotArea.height(), 1,
                lane.height() / plotArea.height()};
    }
    void dragEdge(double by)
    {
        const double middle = (laneOf("°").bottom() + laneOf("rpm").top()) / 2;
        const auto share = [&](double y) { return (area().bottom() - y) / area().height(); };
        drag(Qt::LeftButton, Qt::NoModifier, {0.5, share(middle)}, {0.5, share(middle + by)});
        waitForFrames();
    }
};
} // namespace

class TestTrendLanes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin)"))); }
    void eachQuantityHasItsPart();
    void curvesStayInTheirLanes();
    void overlaidAgain();
    void textsDoNotTouch();
    void valuesAreBesideTheLanes();
    void edgesAreDragged();
    void heightsAreKept();
    void lanesAreReordered();
    void aSingleLaneCannotBeMoved();
    void wheelWithShiftZoomsOneLane();
    void draggingChangesOneLane();
    void hiddenChannelsLeaveNoLane();
    void manyLanesInLittleRoom();
};

void TestTrendLanes::eachQuantityHasItsPart()
{
    LanesFixture fixture;
    const QRectF position = fixture.laneOf("°");
    const QRectF speed = fixture.laneOf("rpm");
    QVERIFY(position.bottom() < speed.top());
    QVERIFY(position.height() > 1.8 * speed.height());
    QVERIFY(fixture.area().contains(position) && fixture.area().contains(speed));
    QCOMPARE(position.left(), speed.left());
    QCOMPARE(position.right(), speed.right());
    QVERIFY(position.height() + speed.height() > 0.9 * fixture.area().height());
}

/// Also where a fixed scale lets them run out.
void TestTrendLanes::curvesStayInTheirLanes()
{
    LanesFixture fixture;
    const QRectF position = fixture.sharesOf(fixture.laneOf("°"));
    const QRectF speed = fixture.sharesOf(fixture.laneOf("rpm"));
    QVERIFY(fixture.paintedIn(position, 0) && fixture.paintedIn(speed, 1));
    QVERIFY(!fixture.paintedIn(speed, 0) && !fixture.paintedIn(position, 1));
    // 10 % into the time the position is at 10 of 0 … 105.
    const double height = position.top() + position.height() * 10 / 105;
    QVERIFY(fixture.paintedIn({0.095, height - 0.02, 0.01, 0.04}, 0));
    fixture.axes().axisOf(QStringLiteral("°")).fix({40, 60});
    fixture.axes().axisOf(QStringLiteral("rpm")).fix({-5, 5});
    fixture.chart.setWidth(9s);
    fixture.waitForFrames();
    const auto left = [](QRectF shares) {
        return QRectF(shares.topLeft(), QSizeF(0.6, shares.height()));
    };
    QVERIFY(!fixture.paintedIn(left(fixture.sharesOf(fixture.laneOf("rpm"))), 0));
    QVERIFY(!fixture.paintedIn(left(fixture.sharesOf(fixture.laneOf("°"))), 1)); // beside the chips
}

void TestTrendLanes::overlaidAgain()
{
    LanesFixture fixture;
    fixture.chart.setLanes(false);
    fixture.waitForFrames();
    QCOMPARE(fixture.laneOf("°"), fixture.area());
    QCOMPARE(fixture.laneOf("rpm"), fixture.area());
    QVERIFY(fixture.paintedIn({0, 0, 1, 0.2}, 0) && fixture.paintedIn({0, 0, 1, 0.2}, 1));
}

/// Of two lanes with labels at their edges.
void TestTrendLanes::textsDoNotTouch()
{
    LanesFixture fixture;
    fixture.axes().axisOf(QStringLiteral("°")).fix({0, 100});
    fixture.axes().axisOf(QStringLiteral("rpm")).fix({-20, 20});
    for (const QSize size : {QSize(800, 500), QSize(500, 260), QSize(1200, 900)}) {
        fixture.chart.resize(size);
        fixture.waitForFrames();
        const QImage image = fixture.picture();
        const double middle = (fixture.laneOf("°").bottom() + fixture.laneOf("rpm").top()) / 2;
        const int row = fixture.plot->mapFromScene(0, middle).y();
        const QRgb background = image.pixel(1, image.height() - 2);
        for (int x = 1; x < fixture.at({0, 0}).x() - 2; ++x)
            QCOMPARE(image.pixel(x, row), background);
    }
}

void TestTrendLanes::valuesAreBesideTheLanes()
{
    LanesFixture fixture;
    const QImage image = fixture.picture();
    const auto colored = [&](const QRectF& lane, int channel) {
        const QRgb wanted =
            ui::trendColorOn(fixture.channels[std::size_t(channel)].color, Qt::white).rgb();
        for (int y = int(lane.top()); y < int(lane.bottom()); ++y) {
            for (int x = int(lane.right()) + 2; x < image.width(); ++x) {
                if (gui::TrendChartFixture::near(image.pixel(x, y), wanted))
                    return true;
            }
        }
        return false;
    };
    QVERIFY(colored(fixture.laneOf("°"), 0) && !colored(fixture.laneOf("°"), 1));
    QVERIFY(colored(fixture.laneOf("rpm"), 1) && !colored(fixture.laneOf("rpm"), 0));
}

void TestTrendLanes::edgesAreDragged()
{
    LanesFixture fixture;
    QSignalSpy changed(&fixture.chart, &ui::TrendChart::laneLayoutChanged);
    const QRectF before = fixture.laneOf("°");
    fixture.dragEdge(-60);
    QCOMPARE(changed.count(), 1);
    QVERIFY(std::abs(fixture.laneOf("°").height() - (before.height() - 60)) < 8);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 10s})); // not panned
    fixture.dragEdge(-2000);                                         // no lane vanishes
    QVERIFY(fixture.laneOf("°").height() >= 20);
    fixture.dragEdge(2000);
    QVERIFY(fixture.laneOf("rpm").height() >= 20);
}

void TestTrendLanes::heightsAreKept()
{
    LanesFixture fixture;
    fixture.dragEdge(-60);
    LanesFixture other;
    other.chart.setLaneLayout(fixture.chart.laneLayout());
    other.waitForFrames();
    QCOMPARE(other.laneOf("°"), fixture.laneOf("°"));
    other.chart.setLaneLayout({{{QStringLiteral("°"), -3}, {QStringLiteral("rpm"), 1e9}}, {}});
    other.waitForFrames(); // of a broken file
    QVERIFY(other.laneOf("°").height() >= 1);
    QVERIFY(other.area().contains(other.laneOf("rpm")));
}

/// By the name and values at its right edge; each lane keeps its height.
void TestTrendLanes::lanesAreReordered()
{
    LanesFixture fixture;
    QSignalSpy changed(&fixture.chart, &ui::TrendChart::laneLayoutChanged);
    const double height = fixture.laneOf("°").height();
    const auto dragLane = [&](const char* from, const char* to) {
        const auto share = [&](double y) {
            return (fixture.area().bottom() - y) / fixture.area().height();
        };
        const QPointF start = fixture.laneOf(from).center();
        const QPointF middle = fixture.laneOf(to).center();
        const double beside = 1 + 12 / fixture.area().width();
        const double beyond = middle.y() < start.y() ? -8 : 8;
        fixture.drag(Qt::LeftButton, Qt::NoModifier, {beside, share(start.y())},
                     {beside, share(middle.y() + beyond)});
        fixture.waitForFrames();
    };
    dragLane("rpm", "°");
    QCOMPARE(changed.count(), 1);
    QVERIFY(fixture.laneOf("rpm").bottom() < fixture.laneOf("°").top());
    QVERIFY(std::abs(fixture.laneOf("°").height() - height) < 8);
    QCOMPARE(fixture.chart.shown(), (recording::TimeSpan{0s, 10s})); // not panned

    LanesFixture other;
    other.chart.setLaneLayout(fixture.chart.laneLayout());
    other.waitForFrames();
    QCOMPARE(other.laneOf("°"), fixture.laneOf("°"));
    dragLane("rpm", "°");
    QVERIFY(fixture.laneOf("°").bottom() < fixture.laneOf("rpm").top());
}

void TestTrendLanes::aSingleLaneCannotBeMoved()
{
    LanesFixture fixture;
    const QPointF beside(fixture.laneOf("°").right() + 12, fixture.laneOf("°").center().y());
    QVERIFY(fixture.axes().laneLabelAt(beside) != nullptr);
    fixture.chart.setChannels({fixture.chart.channels().front()});
    fixture.waitForFrames();
    QVERIFY(fixture.axes().laneLabelAt(beside) == nullptr);
}

void TestTrendLanes::wheelWithShiftZoomsOneLane()
{
    LanesFixture fixture;
    const ui::AxisRange position = fixture.axes().axisOf(QStringLiteral("°")).shown;
    const ui::AxisRange speed = fixture.axes().axisOf(QStringLiteral("rpm")).shown;
    fixture.wheel({0.5, fixture.sharesOf(fixture.laneOf("rpm")).center().y()}, 120,
                  Qt::ShiftModifier);
    QCOMPARE(fixture.axes().axisOf(QStringLiteral("°")).shown, position);
    QVERIFY(fixture.axes().axisOf(QStringLiteral("rpm")).shown.size() < 0.9 * speed.size());
}

/// With Shift its values, with Ctrl a box, which may reach a little into the next lane.
void TestTrendLanes::draggingChangesOneLane()
{
    for (const auto with : {Qt::ShiftModifier, Qt::ControlModifier}) {
        LanesFixture fixture;
        const ui::AxisRange position = fixture.axes().axisOf(QStringLiteral("°")).shown;
        const QRectF speed = fixture.sharesOf(fixture.laneOf("rpm"));
        const double pixel = 1 / fixture.area().height();
        fixture.drag(Qt::LeftButton, with, {0.2, speed.top() + 20 * pixel},
                     {0.6, speed.bottom() + 14 * pixel});
        if (with == Qt::ShiftModifier) // the box shows another time, which the position may fit
            QCOMPARE(fixture.axes().axisOf(QStringLiteral("°")).shown, position);
        QVERIFY(!fixture.axes().axisOf(QStringLiteral("°")).range.isFixed());
        QVERIFY(fixture.axes().axisOf(QStringLiteral("rpm")).range.isFixed());
    }
}

void TestTrendLanes::hiddenChannelsLeaveNoLane()
{
    LanesFixture fixture;
    const double before = fixture.laneOf("°").height();
    fixture.chart.setChannelVisible(1, false);
    fixture.waitForFrames();
    QVERIFY(fixture.laneOf("°").height() > 1.3 * before);
    fixture.chart.setChannelVisible(0, false);
    fixture.waitForFrames();
    fixture.chart.setChannelVisible(1, true);
    fixture.waitForFrames();
    QVERIFY(fixture.laneOf("rpm").height() > 0.95 * fixture.area().height());
}

void TestTrendLanes::manyLanesInLittleRoom()
{
    LanesFixture fixture;
    for (const char* unit : {"mA", "%", "V", "°C", "a", "b", "c"}) {
        ui::TrendChannel channel = fixture.channels[0];
        channel.unit = QString::fromUtf8(unit);
        channel.key = channel.unit;
        fixture.channels.push_back(channel);
    }
    fixture.chart.setChannels(fixture.channels);
    int low = 0;
    for (int height = 500; height > 60; height -= 9) {
        fixture.chart.resize(420, height);
        fixture.waitForFrames();
        const QRectF plot = fixture.area();
        if (plot.isEmpty())
            continue; // no room for a plot at all
        low += plot.height() < 90 ? 1 : 0;
        double bottom = plot.top() - 1;
        for (const char* unit : {"°", "rpm", "mA", "%", "V", "°C", "a", "b", "c"}) {
            QVERIFY2(fixture.laneOf(unit).top() > bottom, unit);
            bottom = fixture.laneOf(unit).bottom();
        }
        QVERIFY(bottom <= plot.bottom());
    }
    QVERIFY(low > 2);
}

SERVODESK_TEST(TestTrendLanes)
#include "tst_trend_lanes.moc"
