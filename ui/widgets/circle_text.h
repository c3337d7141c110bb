// SPDX-License-Identifier: GPL-3.0-or-later
// Text inside a circle: wrapped at the chord at its height, and in a smaller font where it does not
// fit. Pure; main thread, because of the fonts.
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
