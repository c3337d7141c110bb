// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/position_dial.h"

#include "ui/common/palette.h"
#include "ui/common/theme.h"
#include "ui/widgets/circle_text.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr double fullCircle = 360;
constexpr double textRadius = 0.66; ///< of the face: texts inside, the needle outside
constexpr double pi = 3.14159265358979323846;
constexpr int tickStep = 10; ///< degrees
constexpr int longTickInterval = 30;
constexpr double knob = 7;
constexpr int wheelStep = 10; ///< raw steps a notch
constexpr int pageStep = 100;

double turnedBy(double from, double to)
{
    return std::remainder(to - from, fullCircle);
}
} // namespace

PositionDial::PositionDial(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setFocusPolicy(Qt::StrongFocus);
}

void PositionDial::show(const DialState& view)
{
    if (view == m_view)
        return;
    m_view = view;
    if (!view.isGoalMovable)
        m_drag.reset();
    setCursor(view.isGoalMovable ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setAccessibleDescription(
        QStringList{view.value, view.subtitle, view.turnsText}.join(QLatin1Char(' ')));
    update();
}

QSize PositionDial::sizeHint() const
{
    return {240, 216};
}

QSize PositionDial::minimumSizeHint() const
{
    return {126, 110};
}

/// The middle of the range is at the top: 2048 of 4096, 512 of 1024, 500 of 1000.
double PositionDial::angleOf(double raw) const
{
    const double angle = raw / std::max(m_view.stepsPerTurn, 1.0) * m_view.rangeDegrees;
    return angle - m_view.rangeDegrees / 2;
}

QRectF PositionDial::face() const
{
    const double room = std::min(width(), height()) - 30.0;
    return {(width() - room) / 2, (height() - room) / 2, room, room};
}

QPointF PositionDial::pointAt(double raw, double radius) const
{
    const double angle = angleOf(raw) / 180 * pi;
    return face().center() + QPointF(std::sin(angle), -std::cos(angle)) * radius;
}

void PositionDial::requestGoal(double raw)
{
    if (!m_view.isGoalMovable)
        return;
    if (m_view.minGoal)
        raw = std::max(raw, double(*m_view.minGoal));
    if (m_view.maxGoal)
        raw = std::min(raw, double(*m_view.maxGoal));
    m_drag = raw;
    update();
    Q_EMIT goalRequested(std::llround(raw));
}

/// A step by wheel or key: the next one counts from here, also before the servo has been read
/// again.
void PositionDial::nudgeTo(double raw)
{
    requestGoal(raw);
    if (m_drag)
        m_view.goal = m_drag;
    m_drag.reset();
}

/// The knob follows the pointer by the shorter way, so that it also goes round over several turns.
void PositionDial::dragTo(const QPointF& rect)
{
    const QPointF from = rect - face().center();
    if (std::hypot(from.x(), from.y()) < knob)
        return;
    const double pointed = std::atan2(from.x(), -from.y()) / pi * 180;
    const double now = m_drag.value_or(m_view.goal.value_or(m_view.position.value_or(0)));
    const double by = turnedBy(angleOf(now), pointed);
    requestGoal(now + by / m_view.rangeDegrees * m_view.stepsPerTurn);
}

void PositionDial::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_view.isGoalMovable)
        return;
    m_drag.reset();
    dragTo(event->position());
}

void PositionDial::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton) && m_drag)
        dragTo(event->position());
}

void PositionDial::mouseReleaseEvent(QMouseEvent*)
{
    m_drag.reset();
    update();
}

/// Only with the focus: a wheel that passes over the page moves nothing.
void PositionDial::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus() || !m_view.isGoalMovable || !m_view.goal) {
        event->ignore();
        return;
    }
    constexpr double notch = 120;
    const bool fine = event->modifiers().testFlag(Qt::ControlModifier);
    m_wheel += event->angleDelta().y() / notch * (fine ? 1 : wheelStep);
    const double whole = std::trunc(m_wheel);
    m_wheel -= whole;
    if (whole != 0)
        nudgeTo(*m_view.goal + whole);
    event->accept();
}

void PositionDial::keyPressEvent(QKeyEvent* event)
{
    const double now = m_view.goal.value_or(m_view.position.value_or(0));
    const auto to = [this](double raw) { nudgeTo(raw); };
    switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Right:
        return to(now + 1);
    case Qt::Key_Down:
    case Qt::Key_Left:
        return to(now - 1);
    case Qt::Key_PageUp:
        return to(now + pageStep);
    case Qt::Key_PageDown:
        return to(now - pageStep);
    case Qt::Key_Home:
        return to(double(m_view.minGoal.value_or(std::llround(now))));
    case Qt::Key_End:
        return to(double(m_view.maxGoal.value_or(std::llround(now))));
    default:
        QWidget::keyPressEvent(event);
    }
}

void PositionDial::paintFace(QPainter& painter) const
{
    const QRectF round = face();
    painter.setPen(QPen(palette().color(QPalette::Mid), 2));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawEllipse(round);
    if (!m_view.minGoal || !m_view.maxGoal)
        return;
    const double from = angleOf(double(*m_view.minGoal));
    const double span = std::min(angleOf(double(*m_view.maxGoal)) - from, fullCircle);
    QColor allowed = tone(Tone::Accent, palette());
    allowed.setAlpha(isDark(palette()) ? 48 : 34);
    QPainterPath sector(round.center());
    sector.arcTo(round, 90 - from, -span);
    sector.closeSubpath();
    painter.fillPath(sector, allowed);
    if (span >= fullCircle - 1)
        return;
    painter.setPen(QPen(tone(Tone::Accent, palette()), 1.5));
    for (const auto limit : {*m_view.minGoal, *m_view.maxGoal}) {
        const double radius = round.width() / 2;
        painter.drawLine(pointAt(double(limit), radius * 0.8), pointAt(double(limit), radius + 5));
    }
}

void PositionDial::paintTicks(QPainter& painter) const
{
    const double radius = face().width() / 2;
    painter.setPen(QPen(tone(Tone::Quiet, palette()), 1));
    for (int degrees = 0; degrees < int(fullCircle); degrees += tickStep) {
        const double angle = degrees / 180.0 * pi;
        const QPointF way(std::sin(angle), -std::cos(angle));
        const double length = degrees % longTickInterval == 0 ? 11 : 6;
        painter.drawLine(face().center() + way * (radius + 3),
                         face().center() + way * (radius + 3 + length));
    }
}

void PositionDial::paintNeedle(QPainter& painter) const
{
    const double radius = face().width() / 2;
    if (m_view.position) {
        const QColor needle = m_view.isStale
                                  ? tone(Tone::Quiet, palette())
                                  : trendColor(positionColor, palette().color(QPalette::Window));
        painter.setPen(QPen(needle, 4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(pointAt(*m_view.position, radius * textRadius),
                         pointAt(*m_view.position, radius * 0.94));
    }
    const auto goal = m_drag ? m_drag : m_view.goal;
    if (!goal)
        return;
    painter.setPen(QPen(palette().color(QPalette::Base), 2));
    painter.setBrush(trendColor(goalColor, palette().color(QPalette::Window)));
    painter.drawEllipse(pointAt(*goal, radius), knob, knob);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(pointAt(*goal, radius), knob + 4, knob + 4);
    }
}

void PositionDial::paintTexts(QPainter& painter) const
{
    const QRectF round = face();
    QFont big = font();
    big.setPointSizeF(font().pointSizeF() * 1.9);
    big.setBold(true);
    const double rim = round.width() / 2 * (1 - textRadius);
    const QRectF inner = round.adjusted(rim, rim, -rim, -rim);
    // A long value, or a small dial.
    if (const double width = QFontMetricsF(big).horizontalAdvance(m_view.value);
        width > inner.width())
        big.setPointSizeF(big.pointSizeF() * inner.width() / width);
    const int bigLine = QFontMetrics(big).height();
    const double middle = round.center().y() - bigLine * 0.25;
    painter.setPen(m_view.isStale ? tone(Tone::Quiet, palette())
                                  : palette().color(QPalette::WindowText));
    painter.setFont(big);
    painter.drawText(QRectF(round.left(), middle - bigLine / 2.0, round.width(), bigLine),
                     Qt::AlignCenter, m_view.value);
    painter.setPen(tone(Tone::Quiet, palette()));
    double top = middle + bigLine / 2.0;
    for (const QString& words : {m_view.subtitle, m_view.turnsText}) {
        if (words.isEmpty())
            continue;
        const CircleText fitted = fitIntoCircle(words, font(), inner, top);
        painter.setFont(fitted.font);
        painter.drawText(fitted.rect, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, words);
        top = fitted.rect.bottom();
    }
}

void PositionDial::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFace(painter);
    paintTicks(painter);
    paintTexts(painter);
    paintNeedle(painter);
}
} // namespace ui
