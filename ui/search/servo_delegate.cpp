// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/servo_delegate.h"

#include "ui/search/servo_list_model.h"

#include <QApplication>
#include <QPainter>

namespace ui {
namespace {
constexpr int side = 8;
constexpr int above = 5;
constexpr int lightSize = 9;
constexpr int gap = 5;
constexpr double smallScale = 0.88;

QFont smallFont(const QFont& font)
{
    QFont small = font;
    if (font.pointSizeF() > 0)
        small.setPointSizeF(font.pointSizeF() * smallScale);
    return small;
}

/// Space for three digits, whatever the ID, so that the names are in one column.
int idWidth(const QFont& font)
{
    return QFontMetrics(font).horizontalAdvance(QStringLiteral("000")) + gap;
}

class Pen {
public:
    Pen(QPainter& painter, const QPalette& palette, QRect room, bool grey)
        : m_painter(painter)
        , m_palette(palette)
        , m_room(room)
        , m_gray(grey)
    {}

    QColor color(Tone shade) const { return tone(m_gray ? Tone::Quiet : shade, m_palette); }
    QColor plain() const
    {
        return m_gray ? tone(Tone::Quiet, m_palette) : m_palette.color(QPalette::Text);
    }

    void font(const QFont& font) { m_painter.setFont(font); }

    /// What is left of `room` at the left of it.
    int right(int y, int height, const QString& text, const QColor& color, bool light)
    {
        const QFontMetrics metrics = m_painter.fontMetrics();
        const int maxWidth = m_room.width() / 2;
        const QString shown = metrics.elidedText(text, Qt::ElideRight, maxWidth);
        const int width = metrics.horizontalAdvance(shown);
        const int x = m_room.right() - width;
        m_painter.setPen(color);
        m_painter.drawText(QRect(x, y, width + 1, height), Qt::AlignVCenter | Qt::AlignLeft, shown);
        if (!light)
            return x - gap;
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(color);
        m_painter.drawEllipse(
            QRectF(x - gap - lightSize, y + (height - lightSize) / 2.0, lightSize, lightSize));
        return x - 2 * gap - lightSize;
    }

    void left(int x, int end, int y, int height, const QString& text, const QColor& color)
    {
        const QFontMetrics metrics = m_painter.fontMetrics();
        m_painter.setPen(color);
        m_painter.drawText(QRect(x, y, end - x, height), Qt::AlignVCenter | Qt::AlignLeft,
                           metrics.elidedText(text, Qt::ElideRight, end - x));
    }

private:
    QPainter& m_painter;
    const QPalette& m_palette;
    QRect m_room;
    bool m_gray;
};
} // namespace

void ServoDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const
{
    const auto row = index.data(ServoListModel::RowRole).value<ServoRow>();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (selected) { // a tint, so that the colors of the states keep their meaning
        QColor tint = option.palette.color(QPalette::Highlight);
        tint.setAlphaF(0.18F);
        painter->fillRect(option.rect, tint);
        painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())),
                          option.palette.color(QPalette::Highlight));
    }
    painter->setPen(option.palette.color(QPalette::Mid));
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());

    paintRow(*painter, option, row);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        QStyleOptionFocusRect focus;
        focus.QStyleOption::operator=(option);
        focus.rect = option.rect.adjusted(1, 1, -1, -2);
        QApplication::style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, painter);
    }
    painter->restore();
}

void ServoDelegate::paintRow(QPainter& painter, const QStyleOptionViewItem& option,
                             const ServoRow& row) const
{
    const QRect room = option.rect.adjusted(side, above, -side, -above);
    Pen pen(painter, option.palette, room, m_dimmed || row.isSilent);
    const QFont small = smallFont(option.font);
    const int high = QFontMetrics(option.font).height();
    const int low = QFontMetrics(small).height();
    const int text = room.left() + idWidth(option.font);
    int y = room.top();
    pen.font(option.font);
    int end = pen.right(y, high, row.alarm, pen.color(row.alarmTone), true);
    pen.left(room.left(), text, y, high, QString::number(row.id), pen.plain());
    pen.left(text, end, y, high, row.model, pen.plain());
    y += high;
    pen.font(small);
    end = pen.right(y, low, row.lastSeen, pen.color(Tone::Quiet), false);
    pen.left(text, end, y, low, row.details(), pen.color(Tone::Quiet));
    for (const ServoRemark& remark : row.remarks) {
        y += low;
        const QString sign =
            remark.tone == Tone::Accent ? QStringLiteral("↑ ") : QStringLiteral("⚠ ");
        pen.left(text, room.right(), y, low, sign + remark.text, pen.color(remark.tone));
    }
}

QSize ServoDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const auto row = index.data(ServoListModel::RowRole).value<ServoRow>();
    const int low = QFontMetrics(smallFont(option.font)).height();
    const int lines = 1 + int(row.remarks.size());
    return {200, QFontMetrics(option.font).height() + lines * low + 2 * above};
}
} // namespace ui
