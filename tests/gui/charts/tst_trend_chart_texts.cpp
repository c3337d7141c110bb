// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the trend chart, overlaid and in lanes: none lies on another, none is cut, and each line
// of the grid has its label, whatever the size of chart and font, the channels and the marks.
#include "gui/recorded_painting.h"
#include "gui/trend_chart_fixture.h"
#include "support/test_main.h"

#include <QPainter>

#include <cmath>

using namespace std::chrono_literals;
using base::Duration;

namespace {
struct Channel {
    const char* name;
    const char* unit;
    double middle;
    double swing;
};

/// At rest, in motion, of one sign, far from zero; two servos on one axis.
const std::vector<std::vector<Channel>> servos{
    {{"Goal", "°", 180, 0}, {"Position", "°", 180, 0.1}, {"Speed", "rpm", 0, 0}},
    {{"ID 1 · Position", "°", 200, 150},
     {"ID 22 · Position", "°", 90, 20},
     {"Speed", "rpm", 0, 40},
     {"Current", "mA", 900, 950},
     {"Voltage", "V", 12.1, 0.05}},
    {{"目标位置", "°", 2048, 1900},
     {"当前温度", "°C", 41, 1},
     {"负载", "%", -60, 20},
     {"原始值", "", 1e6, 1e6}}};
} // namespace

class TestTrendChartTexts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin)"))); }
    void nothingOverlaps_data();
    void nothingOverlaps();
    void aMarkAtTheRightEdgeShowsAllOfItsText();

private:
    void show(const std::vector<Channel>& channels);
    void check(const char* when);

    std::unique_ptr<gui::TrendChartFixture> m_fixture;
    std::vector<recording::Mark> m_marks;
};

void TestTrendChartTexts::nothingOverlaps_data()
{
    QTest::addColumn<bool>("lanes");
    QTest::addColumn<int>("percent");
    for (const bool lanes : {false, true}) {
        for (const int percent : {100, 150, 200})
            QTest::addRow("%s at %d %%", lanes ? "lanes" : "overlaid", percent) << lanes << percent;
    }
}

void TestTrendChartTexts::show(const std::vector<Channel>& channels)
{
    const auto& old = m_fixture->chart.channels();
    const bool known = !old.empty() && old.front().name == QString::fromUtf8(channels[0].name);
    if (known)
        return;
    std::vector<ui::TrendChannel> shown;
    for (const Channel& channel : channels) {
        ui::TrendChannel one = m_fixture->channels.front();
        one.id = m_fixture->store.open();
        one.name = one.key = QString::fromUtf8(channel.name);
        one.unit = QString::fromUtf8(channel.unit);
        for (Duration at{}; at <= 10s; at += 20ms)
            m_fixture->store.append(
                one.id, at, channel.middle + channel.swing * std::sin(double(at.count()) / 1e6));
        shown.push_back(one);
    }
    m_fixture->chart.setChannels(shown);
}

void TestTrendChartTexts::check(const char* when)
{
    m_fixture->waitForFrames();
    m_fixture->waitForFrames(); // room for texts that have become longer
    QWidget* const viewport = m_fixture->plot->viewport();
    gui::RecordedPainting painting(viewport->size());
    QPainter painter(&painting);
    m_fixture->plot->render(&painter, QRectF(viewport->rect()), viewport->rect());
    painter.end();
    const QString at = QStringLiteral("%1, %2 × %3: ")
                           .arg(QLatin1String(when))
                           .arg(viewport->width())
                           .arg(viewport->height());
    const auto& texts = painting.texts();
    QVERIFY2(texts.size() > 5, qPrintable(at));
    const QRectF room = QRectF(viewport->rect()).adjusted(-1, -1, 1, 1);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        QVERIFY2(room.contains(texts[i].ink),
                 qPrintable(at + texts[i].text + QLatin1String(" is cut")));
        for (std::size_t k = 0; k < i; ++k) {
            if (texts[i].text != texts[k].text || texts[i].ink != texts[k].ink)
                QVERIFY2(
                    !texts[i].ink.intersects(texts[k].ink),
                    qPrintable(at + texts[i].text + QLatin1String(" lies on ") + texts[k].text));
        }
    }
    const QRectF plot = m_fixture->area();
    const auto& axes = m_fixture->plot->picture().axes();
    const auto isEdgeOfLane = [&](const QLineF& line) {
        return axes.hasLanes() &&
               std::any_of(axes.valueAxes().begin(), axes.valueAxes().end(), [&](const auto& axis) {
                   const double y = line.y1() - 0.5;
                   return axis.used && (y == axis.area.top() || y == axis.area.bottom());
               });
    };
    int checked = 0;
    for (const QLineF& line : painting.lines()) {
        if (line.y1() != line.y2() || line.length() < plot.width() - 1 || isEdgeOfLane(line))
            continue;
        ++checked;
        const bool labeled =
            std::any_of(texts.begin(), texts.end(), [&](const gui::PaintedText& text) {
                const bool beside =
                    text.ink.right() < plot.left() || text.ink.left() > plot.right();
                const double reach = text.ink.height() / 2 + 1.5; // in lanes, at their edges
                return beside && std::abs(text.ink.center().y() - line.y1()) <= reach;
            });
        QVERIFY2(labeled, qPrintable(at + QStringLiteral("line at %1").arg(line.y1())));
    }
    QVERIFY2(checked > 1, qPrintable(at));
}

void TestTrendChartTexts::nothingOverlaps()
{
    QFETCH(const bool, lanes);
    QFETCH(const int, percent);
    m_fixture = std::make_unique<gui::TrendChartFixture>();
    ui::TrendChart& chart = m_fixture->chart;
    QFont font = chart.font();
    font.setPixelSize(13 * percent / 100);
    chart.setFont(font);
    chart.setLanes(lanes);
    m_marks.clear();
    for (const int ms : {0, 150, 1000, 1100, 4000, 4200, 9000, 9800, 9990})
        m_marks.push_back(
            {ms * 1ms, recording::MarkKind::Write, 1, QStringLiteral("ID 1 · P gain 32 → 40")});
    chart.setMarks(&m_marks);
    chart.show({0s, 10s});
    for (const auto& servo : servos) { // as when another servo is selected
        show(servo);
        for (const QSize size : {QSize(1200, 700), QSize(600, 460), QSize(900, 360)}) {
            chart.resize(size * percent / 100);
            check(servo.front().name);
            if (QTest::currentTestFailed())
                return;
        }
    }
    chart.setFixedHeight(chart.height() - 60); // a banner appears above it
    check("banner");
    chart.show({0s, 300ms});
    check("other time");
    m_fixture.reset();
}

/// The newest one, as a rule: its text goes to the left of it.
void TestTrendChartTexts::aMarkAtTheRightEdgeShowsAllOfItsText()
{
    m_fixture = std::make_unique<gui::TrendChartFixture>();
    const QString text = QStringLiteral("ID 6 · Voltage out of range");
    m_marks = {{1s, recording::MarkKind::Write, 1, QStringLiteral("ID 1 · P gain 32 → 40")},
               {9995ms, recording::MarkKind::Fault, 6, text}};
    m_fixture->chart.setMarks(&m_marks);
    m_fixture->chart.resize(900, 460);
    m_fixture->chart.show({0s, 10s});
    show(servos.front());
    check("mark at the right edge");
    QWidget* const viewport = m_fixture->plot->viewport();
    gui::RecordedPainting painting(viewport->size());
    QPainter painter(&painting);
    m_fixture->plot->render(&painter, QRectF(viewport->rect()), viewport->rect());
    painter.end();
    QVERIFY(std::any_of(painting.texts().begin(), painting.texts().end(),
                        [&](const gui::PaintedText& one) { return one.text == text; }));
    // All of its flag, which stays within the plot, shows what it means.
    const ui::TrendOverlay& overlay = m_fixture->plot->picture().overlay();
    const QRectF plot = m_fixture->area();
    for (const double aside : {1.0, overlay.flagSize() - 1})
        QCOMPARE(overlay.marksAt({plot.right() - aside, plot.top() - 2}), text);
    m_fixture.reset();
}

SERVODESK_TEST(TestTrendChartTexts)
#include "tst_trend_chart_texts.moc"
