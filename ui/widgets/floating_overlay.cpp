// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/floating_overlay.h"

#include <QEvent>
#include <QWidget>

#include <algorithm>

namespace ui {
namespace {
constexpr int margin = 6;
constexpr int maxWidth = 560;
constexpr int maxPercent = 50; ///< of the area: controls that move servos are in its left half
constexpr int minWidth = 340;  ///< if available: narrower text has too many lines
} // namespace

FloatingOverlay::FloatingOverlay(QWidget* floating, QWidget* area, Corner corner)
    : QObject(floating)
    , m_floating(*floating)
    , m_area(*area)
    , m_corner(corner)
{
    const bool shown = floating->isVisibleTo(floating->parentWidget());
    floating->setParent(area);
    floating->setVisible(shown);
    floating->installEventFilter(this);
    area->installEventFilter(this);
    reposition();
}

bool FloatingOverlay::eventFilter(QObject* watched, QEvent* event)
{
    const bool resized = watched == &m_area && event->type() == QEvent::Resize;
    const bool changed = watched == &m_floating &&
                         (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show);
    if (resized || changed)
        reposition();
    return false;
}

void FloatingOverlay::reposition()
{
    const int room = m_area.width() - 2 * margin;
    const int share =
        m_corner == Corner::TopLeft ? room : std::max(room * maxPercent / 100, minWidth);
    const int width = std::min({room, share, maxWidth});
    const int height = m_floating.hasHeightForWidth() ? m_floating.heightForWidth(width)
                                                      : m_floating.sizeHint().height();
    const QPoint corner = m_corner == Corner::TopLeft ? QPoint(margin, margin)
                                                      : QPoint(m_area.width() - margin - width,
                                                               m_area.height() - margin - height);
    m_floating.setGeometry(QRect(corner, QSize(width, height)));
    m_floating.raise();
}
} // namespace ui
