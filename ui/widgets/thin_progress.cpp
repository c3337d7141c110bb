// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/thin_progress.h"

#include <QPainter>

namespace ui {
namespace {
constexpr int thickness = 6;
} // namespace

ThinProgress::ThinProgress(QWidget* parent)
    : QProgressBar(parent)
{
    setTextVisible(false);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize ThinProgress::sizeHint() const
{
    return {80, thickness};
}

QSize ThinProgress::minimumSizeHint() const
{
    return {20, thickness};
}

void ThinProgress::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    const QRectF whole(rect());
    painter.drawRoundedRect(whole, thickness / 2.0, thickness / 2.0);
    const int steps = maximum() - minimum();
    if (steps <= 0 || value() <= minimum())
        return;
    QRectF done = whole;
    done.setWidth(qMax(double(thickness), whole.width() * (value() - minimum()) / steps));
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.drawRoundedRect(done, thickness / 2.0, thickness / 2.0);
}
} // namespace ui
