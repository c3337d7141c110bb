// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/pill.h"

#include <QPainter>

namespace ui {
namespace {
constexpr int side = 10;
constexpr int lightSize = 10;
constexpr int lightGap = 6;
constexpr int above = 5;
} // namespace

Pill::Pill(QWidget* parent, bool filled)
    : QWidget(parent)
    , m_filled(filled)
{
    setSizePolicy(filled ? QSizePolicy::Fixed : QSizePolicy::Maximum, QSizePolicy::Fixed);
}

void Pill::setState(Tone light, const QString& words, const QString& shortText, const QString& more)
{
    m_tone = light;
    const bool sameRoom = words.size() == m_text.size();
    m_text = words;
    m_shortText = shortText.isEmpty() ? words : shortText;
    setToolTip(more.isEmpty() ? words : words + QLatin1Char('\n') + more);
    setAccessibleName(words);
    if (!sameRoom)
        updateGeometry();
    update();
}

int Pill::widthFor(const QString& text) const
{
    return fontMetrics().horizontalAdvance(text) + 2 * side + (m_filled ? 0 : lightSize + lightGap);
}

QSize Pill::sizeHint() const
{
    return {widthFor(m_text), fontMetrics().height() + 2 * above};
}

QSize Pill::minimumSizeHint() const
{
    return {widthFor(m_filled ? m_text : m_shortText), sizeHint().height()};
}

void Pill::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor color = tone(m_tone, palette());
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(m_filled ? color : palette().color(QPalette::Mid));
    painter.setBrush(m_filled ? QBrush(color) : QBrush(palette().color(QPalette::Base)));
    painter.drawRoundedRect(frame, frame.height() / 2, frame.height() / 2);
    QRect room = rect().adjusted(side, 0, -side, 0);
    if (!m_filled) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawEllipse(
            QRectF(room.left(), (height() - lightSize) / 2.0, lightSize, lightSize));
        room.setLeft(room.left() + lightSize + lightGap);
    }
    const bool fits = fontMetrics().horizontalAdvance(m_text) <= room.width();
    painter.setPen(palette().color(m_filled ? QPalette::Base : QPalette::WindowText));
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                     fits ? m_text
                          : fontMetrics().elidedText(m_shortText, Qt::ElideRight, room.width()));
}
} // namespace ui
