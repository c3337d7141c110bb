// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/joint_range_delegate.h"

#include "ui/arm/arm_model.h"
#include "ui/common/theme.h"

#include <QPainter>

#include <algorithm>

namespace ui {
namespace {
constexpr double trackHeight = 6;
constexpr double dotRadius = 6;
constexpr double sideMargin = 10;
} // namespace

void JointRangeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const
{
    QStyledItemDelegate::paint(painter, option, index); // the ground of the row
    const QVariant data = index.data(jointBarRole);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    const QRectF track(option.rect.left() + sideMargin,
                       option.rect.center().y() - trackHeight / 2 + 0.5,
                       option.rect.width() - 2 * sideMargin, trackHeight);
    const auto draw = [&](double from, double to, const QColor& color) {
        painter->setBrush(color);
        painter->drawRoundedRect(QRectF(track.left() + from * track.width(), track.top(),
                                        (to - from) * track.width(), track.height()),
                                 trackHeight / 2, trackHeight / 2);
    };
    draw(0, 1, option.palette.color(QPalette::Mid));
    if (data.isValid()) {
        const auto bar = data.value<JointBar>();
        const auto inside = [](double fraction) { return std::clamp(fraction, 0.0, 1.0); };
        const QColor color = tone(Tone::Accent, option.palette);
        draw(inside(bar.low), inside(bar.high),
             bar.isRecorded ? color : option.palette.color(QPalette::PlaceholderText));
        if (bar.now) {
            painter->setBrush(color);
            painter->setPen(QPen(option.palette.color(QPalette::Base), 2));
            painter->drawEllipse(
                QPointF(track.left() + inside(*bar.now) * track.width(), track.center().y()),
                dotRadius, dotRadius);
        }
    }
    painter->restore();
}
} // namespace ui
