// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/lane_labels.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr double labelGap = 6;       ///< between lane and text
constexpr double labelWidthStep = 8; ///< the lanes do not resize for one more digit
constexpr double pairSpace = 0.3;    ///< of a line, between two channels

QFont bold(QFont font)
{
    font.setBold(true);
    return font;
}
} // namespace

LaneLabels::LaneLabels(QGraphicsItem* parent)
    : QGraphicsItem(parent)
{
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(5);
}

void LaneLabels::setColors(const TrendColors& colors)
{
    m_colors = colors;
    update();
}

void LaneLabels::setFont(const QFont& font)
{
    prepareGeometryChange();
    m_font = font;
    measure();
    update();
}

void LaneLabels::setLabels(std::vector<LaneLabel> labels)
{
    if (labels == m_labels)
        return;
    prepareGeometryChange();
    m_labels = std::move(labels);
    measure();
    update();
}

/// Asked for several times a frame, so measured once.
void LaneLabels::measure()
{
    m_width = 0;
    if (m_labels.empty())
        return;
    const QFontMetricsF metrics(bold(m_font));
    double widest = metrics.horizontalAdvance(QStringLiteral("-0000.0 mA"));
    for (const LaneLabel& label : m_labels)
        widest = std::max({widest, metrics.horizontalAdvance(label.name),
                           metrics.horizontalAdvance(label.value)});
    m_width = std::ceil((widest + 2 * labelGap) / labelWidthStep) * labelWidthStep;
}

QRectF LaneLabels::boundingRect() const
{
    QRectF all;
    for (const LaneLabel& label : m_labels)
        all |= label.lane;
    return {all.right(), all.top(), width(), all.height()};
}

void LaneLabels::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    for (std::size_t first = 0; first < m_labels.size();) {
        std::size_t end = first;
        while (end < m_labels.size() && m_labels[end].lane == m_labels[first].lane)
            ++end;
        paintLane(painter, first, end);
        first = end;
    }
}

void LaneLabels::paintLane(QPainter* painter, std::size_t first, std::size_t end) const
{
    const QFontMetricsF metrics(m_font);
    const QRectF& lane = m_labels[first].lane;
    const double line = metrics.height();
    const auto count = double(end - first);
    const bool names = (count * (2 + pairSpace) - pairSpace) * line <= lane.height() + 1;
    const double rows = names ? 2 + pairSpace : 1;
    for (std::size_t i = first; i < end; ++i) {
        const LaneLabel& label = m_labels[i];
        double baseline = lane.top() + double(i - first) * rows * line + metrics.ascent();
        if (baseline > lane.bottom() && i > first)
            return;
        const double left = lane.right() + labelGap;
        painter->setFont(bold(m_font));
        painter->setPen(label.color);
        if (names) {
            painter->drawText(QPointF(left, baseline), label.name);
            painter->setFont(m_font);
            painter->setPen(m_colors.text);
            baseline += line;
        }
        painter->drawText(QPointF(left, baseline), label.value);
    }
}
} // namespace ui
