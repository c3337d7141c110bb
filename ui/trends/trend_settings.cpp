// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trend_settings.h"

namespace ui {
namespace {
const QString curvesKey = QStringLiteral("trend/curves");
const QString widthKey = QStringLiteral("trend/width_s");
const QString rateKey = QStringLiteral("trend/rate_hz");
const QString memoryKey = QStringLiteral("trend/memory_mb");
const QString lanesKey = QStringLiteral("trend/lanes");
const QString laneOrderKey = QStringLiteral("trend/lane_order");     ///< units
const QString laneHeightsKey = QStringLiteral("trend/lane_heights"); ///< one text each: "°;2.5"
constexpr int defaultWidth = 10;                                     ///< in seconds
constexpr int defaultRate = 50;                                      ///< Hz
constexpr int defaultMemory = 128;                                   ///< MB
constexpr int leastMemory = 16;                                      ///< MB

/// One text a curve: "1/present_position;visible;#rrggbb;scale;offset".
QString toText(const TrendCurve& curve)
{
    return QStringList{curve.id(), curve.visible ? QStringLiteral("1") : QStringLiteral("0"),
                       curve.color.isValid() ? curve.color.name() : QString(),
                       QString::number(curve.scale, 'g', 10),
                       QString::number(curve.offset, 'g', 10)}
        .join(QLatin1Char(';'));
}

TrendCurve fromText(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char(';'));
    TrendCurve curve = TrendCurve::fromId(parts.value(0));
    curve.visible = parts.value(1) != QLatin1String("0");
    curve.color = QColor(parts.value(2));
    const double scale = parts.value(3).toDouble();
    curve.scale = scale != 0 ? scale : 1;
    curve.offset = parts.value(4).toDouble();
    return curve;
}
} // namespace

std::vector<TrendCurve> TrendSettings::curves() const
{
    std::vector<TrendCurve> curves;
    for (const QString& text : m_settings.pageValue(curvesKey, QStringList()).toStringList()) {
        const TrendCurve curve = fromText(text);
        if (!curve.key.isEmpty())
            curves.push_back(curve);
    }
    return curves.empty() ? defaultCurves() : curves;
}

void TrendSettings::setCurves(const std::vector<TrendCurve>& curves)
{
    QStringList texts;
    for (const TrendCurve& curve : curves)
        texts << toText(curve);
    m_settings.setPageValue(curvesKey, curves == defaultCurves() ? QStringList() : texts);
}

base::Duration TrendSettings::width() const
{
    return std::chrono::seconds(std::max(m_settings.pageValue(widthKey, defaultWidth).toInt(), 1));
}

void TrendSettings::setWidth(base::Duration width)
{
    m_settings.setPageValue(widthKey, int(width.count() / 1'000'000));
}

int TrendSettings::rate() const
{
    return m_settings.pageValue(rateKey, defaultRate).toInt();
}

void TrendSettings::setRate(int hz)
{
    m_settings.setPageValue(rateKey, hz);
}

int TrendSettings::memory() const
{
    return std::max(m_settings.pageValue(memoryKey, defaultMemory).toInt(), leastMemory);
}

void TrendSettings::setMemory(int megabytes)
{
    m_settings.setPageValue(memoryKey, megabytes);
}

bool TrendSettings::hasLanes() const
{
    return m_settings.pageValue(lanesKey, false).toBool();
}

void TrendSettings::setLanes(bool on)
{
    m_settings.setPageValue(lanesKey, on);
}

LaneLayout TrendSettings::laneLayout() const
{
    LaneLayout layout;
    layout.order = m_settings.pageValue(laneOrderKey, QStringList()).toStringList();
    for (const QString& text : m_settings.pageValue(laneHeightsKey, QStringList()).toStringList()) {
        const double height = text.section(QLatin1Char(';'), -1).toDouble();
        if (height > 0)
            layout.heights[text.section(QLatin1Char(';'), 0, -2)] = height;
    }
    return layout;
}

void TrendSettings::setLaneLayout(const LaneLayout& layout)
{
    m_settings.setPageValue(laneOrderKey, layout.order);
    QStringList texts;
    for (auto it = layout.heights.begin(); it != layout.heights.end(); ++it)
        texts << it.key() + QLatin1Char(';') + QString::number(*it, 'f', 3);
    m_settings.setPageValue(laneHeightsKey, texts);
}
} // namespace ui
