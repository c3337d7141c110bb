// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/step_strip.h"

#include "text/language.h"
#include "ui/common/theme.h"

#include <QPainter>

namespace ui {
namespace {
constexpr int dot = 14;
constexpr int dotGap = 4;   ///< to the text below
constexpr int stepGap = 12; ///< between texts
} // namespace

StepStrip::StepStrip(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StepStrip::setSteps(const QStringList& steps)
{
    m_steps = steps;
    describe();
    updateGeometry();
    update();
}

void StepStrip::setCurrent(int step)
{
    if (step == m_current)
        return;
    m_current = step;
    describe();
    update();
}

void StepStrip::describe()
{
    setAccessibleName(m_current < 0 ? text::joinItems(m_steps)
                                    : tr("Step %1 of %2: %3")
                                          .arg(m_current + 1)
                                          .arg(m_steps.size())
                                          .arg(m_steps.value(m_current)));
    setToolTip(accessibleName());
}

QSize StepStrip::sizeHint() const
{
    int widest = 0;
    for (const QString& step : m_steps)
        widest = std::max(widest, fontMetrics().horizontalAdvance(step));
    return {(widest + stepGap) * static_cast<int>(m_steps.size()),
            dot + dotGap + fontMetrics().height()};
}

QSize StepStrip::minimumSizeHint() const
{
    return {4 * dot * static_cast<int>(m_steps.size()), sizeHint().height()};
}

void StepStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double share = m_steps.isEmpty() ? 0 : double(width()) / double(m_steps.size());
    const QColor line = palette().color(QPalette::Mid);
    for (int i = 0; i < m_steps.size(); ++i) {
        const QPointF middle(share * (i + 0.5), dot / 2.0);
        const bool done = i < m_current;
        const bool now = i == m_current;
        const QColor color = done  ? tone(Tone::Good, palette())
                             : now ? tone(Tone::Accent, palette())
                                   : tone(Tone::Quiet, palette());
        if (i > 0) {
            painter.setPen(QPen(i <= m_current ? tone(Tone::Good, palette()) : line, 1.5));
            painter.drawLine(middle - QPointF(share - dot, 0), middle - QPointF(dot, 0));
        }
        painter.setPen(QPen(done || now ? color : line, 1.5));
        painter.setBrush(now ? QBrush(color) : QBrush(Qt::NoBrush));
        if (done)
            painter.drawPolyline(QPolygonF{middle + QPointF(-5, 0), middle + QPointF(-1.5, 4),
                                           middle + QPointF(5, -4)});
        else
            painter.drawEllipse(middle, dot / 2.0 - 1, dot / 2.0 - 1);
        QFont font = this->font();
        font.setBold(now);
        painter.setFont(font);
        painter.setPen(now ? palette().color(QPalette::WindowText) : color);
        const QRectF box(share * i, dot + dotGap, share, fontMetrics().height());
        painter.drawText(box, Qt::AlignCenter,
                         QFontMetrics(font).elidedText(m_steps[i], Qt::ElideRight, int(share) - 4));
    }
}
} // namespace ui
