// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/servo_card.h"

#include "session/polling/max_reading_age.h"
#include "ui/widgets/feedback.h"
#include "ui/widgets/rate_text.h"
#include "ui/widgets/servo_row.h"

#include <QPainter>

#include <algorithm>

namespace ui {
using catalog::Role;

namespace {
constexpr int side = 8;
constexpr int barHeight = 4;
constexpr int light = 8;

const QString separator = QStringLiteral(" · ");

std::optional<double> share(std::optional<double> at, double low, double high)
{
    if (!at || high <= low)
        return std::nullopt;
    return std::clamp((*at - low) / (high - low), 0.0, 1.0);
}
} // namespace

CardState cardState(const session::ServoEntry& entry, bool fresh, base::Duration now)
{
    const device::Servo& servo = entry.servo;
    const ServoRow row = servoRow(entry, std::nullopt, now);
    CardState view;
    view.title = QStringLiteral("%1 · %2").arg(servo.id).arg(row.model);
    const bool old = now - entry.lastSeen > session::maxReadingAge;
    view.state = old ? row.alarm + QStringLiteral(" · ") + row.lastSeen : row.alarm;
    view.tone = !fresh && row.alarmTone == Tone::Good ? Tone::Quiet : row.alarmTone;
    view.isStale = !fresh;
    if (!servo.profile)
        return view;
    const DialState dial = dialState(entry, fresh);
    const double low = double(dial.minGoal.value_or(0));
    const double high = double(dial.maxGoal.value_or(std::int64_t(dial.stepsPerTurn)));
    view.position = share(dial.position, low, high);
    view.goal = share(dial.goal, low, high);
    QStringList numbers{dial.value};
    for (const Quantity measure : {Quantity::Voltage, Quantity::Temperature, Quantity::Load}) {
        const GaugeState gauge = gaugeState(entry, measure);
        if (gauge.value)
            numbers << withUnit(*gauge.value, {}, gauge.scale.decimals) + QLatin1Char(' ') +
                           gauge.scale.unit;
    }
    view.numbers = numbers;
    view.toolTip = view.title + QStringLiteral(" · ") + view.state + QLatin1Char('\n') +
                   numbers.join(separator);
    return view;
}

ServoCard::ServoCard(QWidget* parent)
    : QAbstractButton(parent)
{
    constexpr int fewest = 21;
    setMinimumWidth(fontMetrics().averageCharWidth() * fewest);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
}

void ServoCard::show(const CardState& view, bool selected)
{
    if (view == m_view && selected == m_selected)
        return;
    m_view = view;
    m_selected = selected;
    setAccessibleName(view.title);
    setAccessibleDescription(view.state + QStringLiteral(", ") + view.numbers.join(separator));
    setToolTip(view.toolTip);
    update();
}

QSize ServoCard::sizeHint() const
{
    constexpr int letters = 32;
    return {fontMetrics().averageCharWidth() * letters, fontMetrics().height() * 2 + 26};
}

void ServoCard::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool marked = m_selected || hasFocus();
    painter.setPen(QPen(marked ? tone(Tone::Accent, palette()) : palette().color(QPalette::Mid),
                        hasFocus() ? 2 : 1));
    painter.setBrush(palette().color(m_selected ? QPalette::AlternateBase : QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 5, 5);
    const int line = fontMetrics().height();
    const QRect room = rect().adjusted(side, 5, -side, -5);
    const int stateWidth =
        std::min(fontMetrics().horizontalAdvance(m_view.state), room.width() / 2);
    const QRect state(room.right() - stateWidth, room.top(), stateWidth + 1, line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone(m_view.tone, palette()));
    painter.drawEllipse(
        QRectF(state.left() - light - 4, room.top() + (line - light) / 2.0, light, light));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(state, Qt::AlignVCenter | Qt::AlignRight,
                     fontMetrics().elidedText(m_view.state, Qt::ElideRight, stateWidth + 1));
    const int titleWidth = state.left() - light - 8 - room.left();
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.drawText(QRect(room.left(), room.top(), titleWidth, line), Qt::AlignVCenter,
                     QFontMetrics(bold).elidedText(m_view.title, Qt::ElideRight, titleWidth));
    painter.setFont(font());
    paintBar(painter, QRectF(room.left(), room.top() + line + 5, room.width(), barHeight));
    painter.setPen(tone(Tone::Quiet, palette()));
    painter.drawText(QRect(room.left(), room.bottom() - line, room.width(), line), Qt::AlignVCenter,
                     numbersText(room.width()));
}

/// As many as fit whole; the tooltip has all of them.
QString ServoCard::numbersText(int width) const
{
    QStringList shown = m_view.numbers;
    while (shown.size() > 1 && fontMetrics().horizontalAdvance(shown.join(separator)) > width)
        shown.removeLast();
    return fontMetrics().elidedText(shown.join(separator), Qt::ElideRight, width);
}

void ServoCard::paintBar(QPainter& painter, const QRectF& bar) const
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRoundedRect(bar, 2, 2);
    if (m_view.goal) {
        painter.setBrush(tone(Tone::Warn, palette()));
        painter.drawRect(
            QRectF(bar.left() + *m_view.goal * bar.width() - 1, bar.top() - 3, 2, barHeight + 6));
    }
    if (m_view.position) {
        painter.setBrush(tone(m_view.isStale ? Tone::Quiet : Tone::Accent, palette()));
        painter.drawEllipse(QPointF(bar.left() + *m_view.position * bar.width(), bar.center().y()),
                            4.5, 4.5);
    }
}
} // namespace ui
