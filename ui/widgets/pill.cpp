// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/pill.h"

#include <QPainter>

namespace ui {
namespace {
constexpr int side = 10;
constexpr int lightSize = 10;
constexpr int gap = 6;
constexpr int above = 5;
} // namespace

Pill::Pill(QWidget* parent, bool filled)
    : QWidget(parent)
    , m_filled(filled)
{
    setSizePolicy(filled ? QSizePolicy::Fixed : QSizePolicy::Maximum, QSizePolicy::Fixed);
}

void Pill::setState(Tone light, const QString& words, const QString& brief, const QString& more)
{
    m_light = light;
    const bool sameRoom = words.size() == m_words.size();
    m_words = words;
    m_brief = brief.isEmpty() ? words : brief;
    setToolTip(more.isEmpty() ? words : words + QLatin1Char('\n') + more);
    setAccessibleName(words);
    if (!sameRoom)
        updateGeometry();
    update();
}

int Pill::widthFor(const QString& text) const
{
    return fontMetrics().horizontalAdvance(text) + 2 * side + (m_filled ? 0 : lightSize + gap);
}

QSize Pill::sizeHint() const
{
    return {widthFor(m_words), fontMetrics().height() + 2 * above};
}

QSize Pill::minimumSizeHint() const
{
    return {widthFor(m_filled ? m_words : m_brief), sizeHint().height()};
}

void Pill::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = tone(m_light, palette());
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(m_filled ? colour : palette().color(QPalette::Mid));
    painter.setBrush(m_filled ? QBrush(colour) : QBrush(palette().color(QPalette::Base)));
    painter.drawRoundedRect(frame, frame.height() / 2, frame.height() / 2);
    QRect room = rect().adjusted(side, 0, -side, 0);
    if (!m_filled) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(
            QRectF(room.left(), (height() - lightSize) / 2.0, lightSize, lightSize));
        room.setLeft(room.left() + lightSize + gap);
    }
    const bool fits = fontMetrics().horizontalAdvance(m_words) <= room.width();
    painter.setPen(palette().color(m_filled ? QPalette::Base : QPalette::WindowText));
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                     fits ? m_words
                          : fontMetrics().elidedText(m_brief, Qt::ElideRight, room.width()));
}
} // namespace ui
