// SPDX-License-Identifier: GPL-3.0-or-later
// Words inside a round face: wrapped at the chord that is free at their height, and in a smaller
// font where they do not fit. Pure; the GUI thread, because of the fonts.
#pragma once

#include <QFont>
#include <QRectF>
#include <QString>

namespace ui {
struct CircleText {
    QFont font;
    QRectF rect; ///< draw with Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap
};
/// From `top` downwards.
CircleText fitIntoCircle(const QString& words, const QFont& font, const QRectF& circle, double top);
} // namespace ui
