// SPDX-License-Identifier: GPL-3.0-or-later
// The outputs of the trend chart: image files, presets, copied readings; and its rules for colors,
// ticks and ranges.
#include "gui/trend_chart_fixture.h"
#include "support/test_main.h"
#include "ui/charts/auto_range.h"
#include "ui/charts/axis_ticks.h"
#include "ui/charts/trend_export.h"
#include "ui/trends/cursor_table.h"
#include "ui/trends/trend_preset.h"
#include "ui/trends/trend_settings.h"

#include <QClipboard>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <cmath>
#include <csignal>
#include <sys/resource.h>

using namespace std::chrono_literals;

namespace {
QString q(const char* text)
{
    return QString::fromUtf8(text);
}
} // namespace

class TestTrendChartFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(q("^(?!This plugin)"))); }
    void savesImages();
    void imageExportFailsWithAMessage();
    void fullDiskKeepsTheOldImage();
    void tableHasALineForEachInstant();
    void lanesAreRemembered();
    void presets();
    void brokenPresets();
    void cursorTable();
    void colorsAreDistinct();
    void everyQuantityHasItsColor();
    void timeTexts_data();
    void timeTexts();
    void rangesFitTheData_data();
    void rangesFitTheData();
    void curvesAtRestLieApart();
    void zerosCanBeLeveled();
    void axisDoesNotJitter();
};

void TestTrendChartFiles::savesImages()
{
    const QTemporaryDir folder;
    gui::TrendChartFixture fixture;
    fixture.fill(0, 10s, [](double t) { return t; });
    fixture.chart.show({0s, 10s});
    fixture.waitForFrames();
    QString trouble;
    const QString png = folder.filePath(q("a.png"));
    QVERIFY2(fixture.chart.savePng(png, {900, 500}, &trouble), qPrintable(trouble));
    const QImage image(png);
    QCOMPARE(image.size(), QSize(900, 500));
    QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
    const QRgb blue = ui::trendColor(0, Qt::white).rgb();
    int painted = 0;
    for (int y = 60; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            painted += gui::TrendChartFixture::near(image.pixel(x, y), blue) ? 1 : 0;
    }
    QVERIFY(painted > 500);

    const QString svg = folder.filePath(q("a.svg"));
    QVERIFY2(fixture.chart.saveSvg(svg, {900, 500}, &trouble), qPrintable(trouble));
    QFile file(svg);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString texts;
    int lines = 0;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isCharacters())
            texts += xml.text();
        lines += xml.isStartElement() && xml.name() == q("polyline") ? 1 : 0;
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY(texts.contains(q("Alpha")) && texts.contains(q("Beta")));
    QVERIFY(texts.contains(q("10 s")));
    QVERIFY(lines >= 1);
}

void TestTrendChartFiles::imageExportFailsWithAMessage()
{
    gui::TrendChartFixture fixture;
    QString trouble;
    QVERIFY(!fixture.chart.savePng(q("/nonexistent-folder/a.png"), {400, 300}, &trouble));
    QVERIFY(trouble.contains(q("/nonexistent-folder/a.png")));
    trouble.clear();
    QVERIFY(!fixture.chart.saveSvg(q("/nonexistent-folder/a.svg"), {400, 300}, &trouble));
    QVERIFY(!trouble.isEmpty());
    trouble.clear();
    QVERIFY(!fixture.chart.saveSvg(QString(), {400, 300}, &trouble));
    QVERIFY(!trouble.isEmpty());
}

/// As a full disk has it, without one: no file may grow beyond a few bytes.
void TestTrendChartFiles::fullDiskKeepsTheOldImage()
{
    const QTemporaryDir folder;
    gui::TrendChartFixture fixture;
    const QString path = folder.filePath(q("a.svg"));
    QString trouble;
    QVERIFY(fixture.chart.saveSvg(path, {400, 300}, &trouble));
    const qint64 size = QFileInfo(path).size();
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const bool saved = fixture.chart.saveSvg(path, {400, 300}, &trouble);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    QVERIFY(!saved);
    QVERIFY(trouble.contains(path));
    QCOMPARE(QFileInfo(path).size(), size);
}

/// Read back by hand: names with units, a cell only where the channel was measured, values as they
/// were read, whatever their scale in the chart.
void TestTrendChartFiles::tableHasALineForEachInstant()
{
    gui::TrendChartFixture fixture;
    fixture.channels[0].name = q("ID 1 · 位置, now");
    fixture.channels[0].unit = q("°");
    fixture.setScale(0, -3, 7);
    fixture.put(0, 900ms, 1);
    fixture.put(0, 1s, 12.5);
    fixture.put(1, 1s, -3);
    fixture.put(1, 1500ms, 4);
    fixture.put(0, 2s, 13);
    fixture.put(0, 4s, 99);
    fixture.chart.setOrigin(500ms);
    fixture.chart.show({950ms, 3s});
    const QString table = QString::fromUtf8(ui::trendCsv(fixture.chart.shownTable()));
    QCOMPARE(table, q("\uFEFFtime_s,\"ID 1 · 位置, now [°]\",Beta\n"
                      "0.500000,12.5,-3\n"
                      "1.000000,,4\n"
                      "1.500000,13,\n"));
    fixture.chart.setChannelVisible(0, false);
    QCOMPARE(QString::fromUtf8(ui::trendCsv(fixture.chart.shownTable())),
             q("\uFEFFtime_s,Beta\n0.500000,-3\n1.000000,4\n"));
}

void TestTrendChartFiles::lanesAreRemembered()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(q("s.ini"));
    const ui::LaneLayout layout{{{q("°"), 2.25}, {q("rpm"), 0.5}, {q(";"), 1.0}, {{}, 3.0}},
                                {q("rpm"), q("°"), {}, q(";")}};
    {
        session::Settings settings(file);
        ui::TrendSettings trend(settings);
        QVERIFY(!trend.hasLanes());
        QCOMPARE(trend.laneLayout(), ui::LaneLayout{});
        trend.setLanes(true);
        trend.setLaneLayout(layout);
    }
    session::Settings settings(file);
    const ui::TrendSettings trend(settings);
    QVERIFY(trend.hasLanes());
    QCOMPARE(trend.laneLayout(), layout);
    settings.setPageValue(q("trend/lane_heights"), QStringList{q("rpm;-1"), q("x"), q("V;nan")});
    QVERIFY(trend.laneLayout().heights.isEmpty());
}

void TestTrendChartFiles::presets()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(q("s.ini"));
    const ui::TrendPreset preset{
        42s, {{q("1/a"), true, Qt::blue, 1, 0}, {q("1/b"), false, Qt::red, -2.5, 100}}};
    {
        session::Settings settings(file);
        QVERIFY(ui::presetNames(settings).isEmpty());
        QVERIFY(ui::savePreset(settings, q("  夹持 grip "), preset));
        QVERIFY(ui::savePreset(settings, q("Alone"), {5s, {{q("1/b"), true, QColor(), 1, 0}}}));
        QVERIFY(!ui::savePreset(settings, q("  "), preset));
    }
    session::Settings settings(file);
    QCOMPARE(ui::presetNames(settings), QStringList({q("Alone"), q("夹持 grip")}));
    QVERIFY(ui::loadPreset(settings, q("夹持 grip")) == preset);
    QVERIFY(!ui::loadPreset(settings, q("other")));
    // A color by its place stays so.
    QVERIFY(!ui::loadPreset(settings, q("Alone"))->channels.front().color.isValid());
    ui::deletePreset(settings, q("Alone"));
    QCOMPARE(ui::presetNames(settings), QStringList({q("夹持 grip")}));
}

void TestTrendChartFiles::brokenPresets()
{
    const QTemporaryDir folder;
    session::Settings settings(folder.filePath(q("s.ini")));
    settings.setPageValue(q("trend/presets"), q("{\"a\":{\"width_us\":-5,\"channels\":[{\"key\":7},"
                                                "{\"key\":\"1/a\",\"scale\":0}]},\"b\":3"));
    QVERIFY(ui::presetNames(settings).isEmpty());
    settings.setPageValue(q("trend/presets"), q("{\"a\":{\"width_us\":-5,\"channels\":[{\"key\":7},"
                                                "{\"key\":\"1/a\",\"scale\":0}]},\"b\":3}"));
    const auto preset = ui::loadPreset(settings, q("a"));
    QVERIFY(preset);
    QCOMPARE(preset->width, base::Duration(10s));
    QCOMPARE(preset->channels.size(), std::size_t(1));
    QCOMPARE(preset->channels[0].scale, 1.0);
    QVERIFY(!ui::loadPreset(settings, q("b")));
}

void TestTrendChartFiles::cursorTable()
{
    gui::TrendChartFixture fixture;
    ui::CursorTable table(&fixture.chart);
    auto* const cells = table.findChild<QTableWidget*>(q("cursorTable"));
    QCOMPARE(cells->rowCount(), 0);
    fixture.fill(0, 10s, [](double t) { return 2 * t; });
    fixture.chart.show({0s, 10s});
    fixture.chart.setCursors(2s, 6s);
    QCOMPARE(cells->rowCount(), 2);
    QCOMPARE(cells->item(0, 0)->text(), q("Alpha"));
    QCOMPARE(cells->item(0, 1)->text().toDouble(), 4.0);
    QCOMPARE(cells->item(0, 2)->text().toDouble(), 12.0);
    QCOMPARE(cells->item(0, 3)->text().toDouble(), 8.0);
    QCOMPARE(cells->item(0, 4)->text().toDouble(), 2.0);
    QCOMPARE(cells->item(0, 5)->text().toDouble(), 8.0);
    QCOMPARE(cells->item(0, 6)->text().toDouble(), 4.0);
    QCOMPARE(cells->item(0, 7)->text().toDouble(), 12.0);
    QCOMPARE(cells->item(0, 9)->text(), q("401"));
    QCOMPARE(cells->item(1, 1)->text(), q("–")); // no sample
    table.copy();
    const QString copied = QGuiApplication::clipboard()->text();
    QVERIFY(copied.contains(q("4.000 s")));
    QVERIFY(copied.contains(q("Alpha\t")));
    fixture.chart.setChannelVisible(0, false);
    QCOMPARE(cells->rowCount(), 1);
    fixture.chart.setCursorsShown(false);
    QCOMPARE(cells->rowCount(), 0);
}

void TestTrendChartFiles::colorsAreDistinct()
{
    for (const QColor& ground : {QColor(Qt::white), QColor(0x2d, 0x31, 0x38)}) {
        for (int i = 0; i < ui::trendColorCount; ++i) {
            const QColor color = ui::trendColor(i, ground);
            QVERIFY2(ui::contrast(color, ground) >= 3.0, qPrintable(color.name()));
            for (int k = 0; k < i; ++k)
                QVERIFY(color != ui::trendColor(k, ground));
        }
        for (const QColor& wanted : {QColor(Qt::yellow), QColor(0, 0, 60), QColor(Qt::white),
                                     QColor(Qt::black), QColor(0x30, 0x34, 0x38), QColor()})
            QVERIFY(ui::contrast(ui::trendColorOn(wanted, ground), ground) >= 3.0);
    }
    const QColor light = ui::trendColor(2, Qt::white);
    const QColor dark = ui::trendColor(2, QColor(0x2d, 0x31, 0x38));
    QCOMPARE(ui::trendColorOn(light, QColor(0x2d, 0x31, 0x38)), dark);
    QCOMPARE(ui::trendColorOn(dark, Qt::white), light);
    QCOMPARE(ui::contrast(Qt::white, Qt::black), 21.0);
}

/// In live charts and recordings, of every family.
void TestTrendChartFiles::everyQuantityHasItsColor()
{
    const auto colorsOf = [](const QStringList& keys) { return ui::trendColors(keys, Qt::white); };
    const auto live = colorsOf({q("@goal"), q("@position"), q("@speed"), q("@current")});
    const auto recorded = colorsOf(
        {q("present_current"), q("present_speed"), q("present_position"), q("goal_position")});
    QVERIFY(std::equal(live.begin(), live.end(), recorded.rbegin()));
    QCOMPARE(live[0], ui::trendColor(ui::goalColor, Qt::white));
    QCOMPARE(live[1], ui::trendColor(ui::positionColor, Qt::white));
    QCOMPARE(colorsOf({q("vin"), q("temperature")}),
             colorsOf({q("present_voltage"), q("present_temperature")}));
    // What has no color of its own takes none of those in use.
    const auto several = colorsOf({q("position_p"), q("@position"), q("@position"), q("moving")});
    QCOMPARE(several[1], live[1]);
    for (std::size_t i = 0; i < several.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            QVERIFY(several[i] != several[k]);
    }
}

void TestTrendChartFiles::timeTexts_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<double>("at");
    QTest::addColumn<QString>("text");
    QTest::newRow("following") << -10.0 << 0.0 << -4.0 << q("-4 s");
    QTest::newRow("now") << -10.0 << 0.0 << 0.0 << q("0 s");
    QTest::newRow("short") << -0.5 << 0.0 << -0.25 << q("-250 ms");
    QTest::newRow("parts of a second") << 0.0 << 4.0 << 1.5 << q("1.5 s");
    QTest::newRow("minutes") << 0.0 << 600.0 << 60.0 << q("1:00");
    QTest::newRow("back in minutes") << -600.0 << 0.0 << -120.0 << q("-2:00");
    QTest::newRow("hours") << 0.0 << 7200.0 << 3600.0 << q("1:00:00");
    QTest::newRow("close, late") << 3600.0 << 3600.05 << 3600.01 << q("1:00:00.010");
}

void TestTrendChartFiles::timeTexts()
{
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(double, at);
    const ui::AxisRange range{low, high};
    const double step = ui::timeStep(range.size(), 10);
    QFETCH(QString, text);
    QCOMPARE(ui::timeText(at, range, step), text);
    const auto places = ui::ticks(range, step);
    QVERIFY(places.size() >= 4 && places.size() <= 11);
}

void TestTrendChartFiles::rangesFitTheData_data()
{
    QTest::addColumn<double>("min");
    QTest::addColumn<double>("max");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("low"); ///< at least and at most so far
    QTest::addColumn<double>("high");
    QTest::newRow("sweep in steps") << 82.0 << 4013.0 << q("step") << 0.0 << 4300.0;
    QTest::newRow("one turn") << 0.0 << 360.0 << q("°") << 0.0 << 380.0;
    QTest::newRow("both ways") << -133.0 << 134.0 << q("rpm") << -150.0 << 150.0;
    QTest::newRow("only negative") << -90.0 << -10.0 << q("%") << -95.0 << 0.0;
    QTest::newRow("position at rest") << 180.0 << 180.1 << q("°") << 176.8 << 181.9;
    QTest::newRow("current at rest") << -6.5 << 13.0 << q("mA") << -200.0 << 200.0;
    QTest::newRow("no speed") << 0.0 << 0.7 << q("rpm") << -10.0 << 10.0;
    QTest::newRow("load at rest") << 0.0 << 0.3 << q("%") << 0.0 << 5.0;
    QTest::newRow("voltage") << 7.4 << 7.5 << q("V") << 7.04 << 7.56;
    QTest::newRow("voltage ripple") << 7.2 << 7.6 << q("V") << 7.1 << 7.63;
    QTest::newRow("small motion") << 178.0 << 182.0 << q("°") << 177.0 << 182.3;
    QTest::newRow("warm-up") << 30.0 << 34.0 << q("°C") << 29.7 << 35.0;
    QTest::newRow("temperature") << 31.0 << 31.0 << q("°C") << 29.5 << 34.5;
    QTest::newRow("huge") << -1e12 << 3e12 << QString() << -1.3e12 << 3.3e12;
    QTest::newRow("far away") << 1e9 << 1e9 + 1 << QString() << 1e9 - 2 << 1e9 + 3;
}

void TestTrendChartFiles::rangesFitTheData()
{
    QFETCH(double, min);
    QFETCH(double, max);
    QFETCH(QString, unit);
    QFETCH(double, low);
    QFETCH(double, high);
    const ui::AxisRange range = ui::paddedRange(min, max, unit);
    const QByteArray found =
        QStringLiteral("%1 … %2").arg(range.low, 0, 'g', 12).arg(range.high, 0, 'g', 12).toUtf8();
    QVERIFY2(range.low <= min && range.high >= max, found);
    const double slack = 1e-9 * std::max(std::abs(low), std::abs(high));
    QVERIFY2(range.low >= low - slack && range.high <= high + slack, found);
}

/// One over the other, only the last one painted would be seen.
void TestTrendChartFiles::curvesAtRestLieApart()
{
    const std::pair<double, QString> atRest[] = {
        {120, q("°")}, {7.4, q("V")}, {25, q("°C")}, {0, q("%")}, {0, q("rpm")}};
    std::vector<double> heights;
    for (const auto& [value, unit] : atRest) {
        const ui::AxisRange range = ui::paddedRange(value, value, unit);
        heights.push_back((value - range.low) / range.size());
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i)
        QVERIFY2(heights[i] - heights[i - 1] > 0.1, QByteArray::number(heights[i]));
}

void TestTrendChartFiles::zerosCanBeLeveled()
{
    const ui::AxisRange current = ui::stretchedRange({-500, 1500}, 0.5);
    QCOMPARE(current, (ui::AxisRange{-1500, 1500}));
    const ui::AxisRange speed = ui::stretchedRange({-40, 40}, 0.25);
    QCOMPARE(speed, (ui::AxisRange{-40, 120}));
    const ui::AxisRange fits = ui::stretchedRange({-10, 30}, 0.25);
    QCOMPARE(fits, (ui::AxisRange{-10, 30}));
}

void TestTrendChartFiles::axisDoesNotJitter()
{
    ui::AutoRange axis(q("°"));
    axis.update(0, 300, 0s);
    const ui::AxisRange first = axis.range();
    axis.update(20, 250, 1s);
    QCOMPARE(axis.range().high, first.high);
    axis.update(0, 700, 2s); // grows at once
    QVERIFY(axis.range().high > 700);
    const ui::AxisRange samplesAdded = axis.range();
    axis.update(0, 100, 3s);
    axis.update(0, 100, 4s);
    QCOMPARE(axis.range().high, samplesAdded.high);
    axis.update(0, 600, 4500ms);
    axis.update(0, 100, 6s); // needed again in between: the patience starts anew
    QCOMPARE(axis.range().high, samplesAdded.high);
    axis.update(0, 100, 9s);
    QVERIFY(axis.range().high < samplesAdded.high);
    axis.setFixed({1, 2});
    axis.update(-1000, 1000, 10s);
    QCOMPARE(axis.range().high, 2.0);
    axis.update(qQNaN(), 1, 11s);
    axis.setAutomatic();
    axis.update(0, 10, 12s);
    QVERIFY(axis.range().high >= 10 && axis.range().high < 20);
}

SERVODESK_TEST(TestTrendChartFiles)
#include "tst_trend_chart_files.moc"
