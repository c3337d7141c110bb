// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/off_scale_chips.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <utility>

namespace ui {
namespace {
constexpr double chipPadding = 6;
constexpr double chipSpace = 4; ///< between chips, and to the edge

/// "mA off scale ↑ · Fit"
QString chipText(const OffScale& axis)
{
    const QString arrow = axis.above && axis.below ? QStringLiteral("↕")
                          : axis.above             ? QStringLiteral("↑")
                                                   : QStringLiteral("↓");
    return QCoreApplication::translate("Trend", "%1 off scale %2 · Fit")
        .arg(axis.unit, arrow)
        .trimmed();
}
} // namespace

OffScaleChips::OffScaleChips(QGraphicsItem* parent)
    : QGraphicsItem(parent)
{
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(21);
}

void OffScaleChips::setColors(const TrendColors& colors)
{
    m_colors = colors;
    update();
}

void OffScaleChips::setFont(const QFont& font)
{
    m_font = font;
    update();
}

void OffScaleChips::setOffScale(std::vector<OffScale> axes)
{
    if (axes == m_axes)
        return;
    prepareGeometryChange();
    m_axes = std::move(axes);
    update();
}

/// In the corners at the right, below or above each other where axes share the plot.
std::vector<OffScaleChips::Chip> OffScaleChips::chips() const
{
    const QFontMetricsF metrics(m_font);
    const double height = metrics.height() + chipPadding;
    std::vector<Chip> all;
    for (const OffScale& axis : m_axes) {
        Chip chip{chipText(axis), axis.unit, {}};
        const double width = metrics.horizontalAdvance(chip.text) + 2 * chipPadding;
        const double left = axis.area.right() - width - chipSpace;
        const double top =
            axis.above ? axis.area.top() + chipSpace : axis.area.bottom() - height - chipSpace;
        chip.place = QRectF(left, top, width, height);
        for (const Chip& other : all) {
            if (other.place.intersects(chip.place))
                chip.place.moveTop(axis.above ? other.place.bottom() + chipSpace
                                              : other.place.top() - height - chipSpace);
        }
        all.push_back(std::move(chip));
    }
    return all;
}

std::optional<QString> OffScaleChips::unitAt(const QPointF& position) const
{
    for (const Chip& chip : chips()) {
        if (chip.place.contains(position))
            return chip.unit;
    }
    return {};
}

QRectF OffScaleChips::boundingRect() const
{
    QRectF all;
    for (const OffScale& axis : m_axes)
        all |= axis.area;
    return all;
}

void OffScaleChips::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    painter->setFont(m_font);
    for (const Chip& chip : chips()) {
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(m_colors.warn, 1));
        painter->setBrush(m_colors.background);
        painter->drawRoundedRect(chip.place, chip.place.height() / 2, chip.place.height() / 2);
        painter->setRenderHint(QPainter::Antialiasing, false);
        painter->setPen(m_colors.warn);
        painter->drawText(chip.place, Qt::AlignCenter, chip.text);
    }
}
} // namespace ui
