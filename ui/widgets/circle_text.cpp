// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/circle_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr double smallest = 0.5; ///< of the given font
constexpr double step = 0.05;

double chordAt(const QRectF& circle, double y)
{
    const double radius = circle.width() / 2;
    const double away = std::min(std::abs(y - circle.center().y()), radius);
    return 2 * std::sqrt(radius * radius - away * away);
}
} // namespace

CircleText fitIntoCircle(const QString& text, const QFont& font, const QRectF& circle, double top)
{
    CircleText fitted{font, {}};
    constexpr int flags = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;
    constexpr int maxLines = 3;
    for (double scale = 1; scale >= smallest; scale -= step) {
        fitted.font.setPointSizeF(font.pointSizeF() * scale);
        const QFontMetricsF metrics(fitted.font);
        for (int lines = 1; lines <= maxLines; ++lines) {
            const double height = lines * metrics.lineSpacing();
            const double width = chordAt(circle, top + height);
            fitted.rect = {circle.center().x() - width / 2, top, width, height};
            const QRectF needed = metrics.boundingRect(fitted.rect, flags, text);
            if (needed.width() <= width && needed.height() <= height + 1)
                return fitted;
        }
    }
    return fitted;
}
} // namespace ui
