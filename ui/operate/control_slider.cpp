// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_slider.h"

#include "ui/common/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr int knobRadius = 8;
constexpr int trackHeight = 6;
constexpr int trackTop = 14; ///< its middle
constexpr int minSliderWidth = 160;
constexpr int defaultWidth = 320;
constexpr std::int64_t pageStepsPerScale = 20;
constexpr std::int64_t coarseSteps = 10;
constexpr int wheelNotch = 120; ///< of a wheel, as Qt counts
} // namespace

ControlSlider::ControlSlider(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize ControlSlider::sizeHint() const
{
    return {defaultWidth, trackTop + knobRadius + 2 + fontMetrics().height()};
}

QSize ControlSlider::minimumSizeHint() const
{
    return {minSliderWidth, sizeHint().height()};
}

void ControlSlider::setScale(const Scale& scale)
{
    if (scale == m_scale)
        return;
    m_scale = scale;
    update();
}

void ControlSlider::setValue(std::optional<std::int64_t> value)
{
    if (m_dragging || value == m_value)
        return;
    m_value = value;
    update();
}

double ControlSlider::track(std::int64_t value) const
{
    const double span = std::max<double>(1, static_cast<double>(m_scale.high - m_scale.low));
    const double share = static_cast<double>(value - m_scale.low) / span;
    return knobRadius + std::clamp(share, 0.0, 1.0) * (width() - 2 * knobRadius);
}

QPoint ControlSlider::pointOf(std::int64_t value) const
{
    return {static_cast<int>(std::lround(track(value))), trackTop};
}

std::int64_t ControlSlider::valueAt(double x) const
{
    const double share = (x - knobRadius) / std::max(1, width() - 2 * knobRadius);
    const double value =
        static_cast<double>(m_scale.low) + share * static_cast<double>(m_scale.high - m_scale.low);
    return std::clamp<std::int64_t>(std::llround(value), m_scale.min, m_scale.max);
}

std::int64_t ControlSlider::pageStep() const
{
    return std::max<std::int64_t>(1, (m_scale.high - m_scale.low) / pageStepsPerScale);
}

void ControlSlider::setUserValue(std::int64_t value, bool dragged)
{
    if (value == m_value)
        return;
    m_value = value;
    update();
    Q_EMIT moved(value, dragged);
}

/// A value outside the limits (read from the servo) can only move towards them.
void ControlSlider::step(std::int64_t by)
{
    if (m_value && m_scale.min <= m_scale.max)
        setUserValue(std::clamp(*m_value + by, m_scale.min, m_scale.max), false);
}

void ControlSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_scale.min > m_scale.max)
        return;
    m_dragging = true;
    m_clickedAt = mapToGlobal(QPoint());
    m_wheel = 0;
    setUserValue(valueAt(event->position().x()), true);
    update();
}

void ControlSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging)
        setUserValue(valueAt(event->position().x()), true);
}

void ControlSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        endDrag();
}

void ControlSlider::endDrag()
{
    if (!m_dragging)
        return;
    m_dragging = false;
    update();
    Q_EMIT released();
}

void ControlSlider::wheelEvent(QWheelEvent* event)
{
    // A resting pointer gets no event when the page is scrolled, or grows, under it.
    if (m_clickedAt && (mapToGlobal(QPoint()) - *m_clickedAt).manhattanLength() >= height())
        m_clickedAt.reset();
    if (!hasFocus() || !m_clickedAt) {
        event->ignore(); // scrolling the page must not move a servo
        return;
    }
    m_wheel += event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    const int notches = m_wheel / wheelNotch;
    m_wheel %= wheelNotch;
    event->accept();
    if (notches == 0)
        return;
    const bool fine = event->modifiers().testFlag(Qt::ControlModifier);
    const bool wide = event->modifiers().testFlag(Qt::ShiftModifier);
    step(notches * (fine ? 1 : wide ? pageStep() : coarseSteps));
}

void ControlSlider::keyPressEvent(QKeyEvent* event)
{
    const std::int64_t one = event->modifiers().testFlag(Qt::ShiftModifier) ? coarseSteps : 1;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        return step(-one);
    case Qt::Key_Right:
    case Qt::Key_Up:
        return step(one);
    case Qt::Key_PageDown:
        return step(-pageStep());
    case Qt::Key_PageUp:
        return step(pageStep());
    case Qt::Key_Home:
        return step(m_scale.min - m_value.value_or(m_scale.min));
    case Qt::Key_End:
        return step(m_scale.max - m_value.value_or(m_scale.max));
    default:
        QWidget::keyPressEvent(event);
    }
}

void ControlSlider::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    // A disabled control cannot be dragged.
    if (event->type() == QEvent::EnabledChange && !isEnabled())
        endDrag();
    if (event->type() == QEvent::FontChange)
        updateGeometry();
    update();
}

void ControlSlider::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    m_clickedAt.reset();
}

void ControlSlider::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    m_clickedAt.reset();
}

void ControlSlider::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    endDrag();
}

void ControlSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto bar = [&](double from, double to, const QColor& color) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawRoundedRect(QRectF(from, trackTop - trackHeight / 2.0, to - from, trackHeight),
                                trackHeight / 2.0, trackHeight / 2.0);
    };
    const double low = track(m_scale.min);
    const double high = track(m_scale.max);
    QColor accent =
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Highlight);
    bar(knobRadius, width() - knobRadius, palette().color(QPalette::Mid));
    QColor allowed = accent;
    allowed.setAlphaF(0.45F);
    bar(low, high, allowed);
    if (m_scale.centered && m_value)
        bar(std::min(track(0), track(*m_value)), std::max(track(0), track(*m_value)), accent);

    paintScale(painter);
    if (!m_value)
        return;
    const QPointF middle(track(*m_value), trackTop);
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(accent);
    painter.drawEllipse(middle, knobRadius - 0.5, knobRadius - 0.5);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
        painter.drawEllipse(middle, knobRadius - 0.5, knobRadius - 0.5);
    }
}

void ControlSlider::paintScale(QPainter& painter) const
{
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    const int textTop = trackTop + knobRadius + 1;
    const auto under = [&](double x, const QString& text) {
        const int wide = fontMetrics().horizontalAdvance(text);
        const int left = std::clamp(static_cast<int>(x) - wide / 2, 0, std::max(0, width() - wide));
        painter.drawLine(QPointF(x, trackTop + trackHeight), QPointF(x, textTop + 1));
        painter.drawText(QRect(left, textTop, wide, fontMetrics().height()), Qt::AlignCenter, text);
    };
    painter.setOpacity(0.8);
    under(track(m_scale.min), m_scale.minText);
    under(track(m_scale.max), m_scale.maxText);
    if (m_scale.centered)
        under(track(0), QStringLiteral("0"));
    painter.setOpacity(1);
}
} // namespace ui
