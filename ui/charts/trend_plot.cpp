// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_plot.h"

#include <QChart>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QNativeGestureEvent>

#include <cmath>
#include <utility>

namespace ui {
namespace {
constexpr double leastBox = 6; ///< pixels; less was a click
constexpr double flatBox = 14; ///< lower than this means time only
constexpr double notch = 0.8;  ///< of the wheel: what is left of the stretch
constexpr double wheelUnit = 120;
} // namespace

TrendPlot::TrendPlot(const TrendState& state, QWidget* parent)
    : QChartView(parent)
    , m_picture(new TrendPicture(chart(), state, this))
{
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate); // all of it changes each time
    setOptimizationFlags(DontSavePainterState | DontAdjustForAntialiasing);
    setRubberBand(NoRubberBand);
    viewport()->setAutoFillBackground(false); // the background brush fills it
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_AcceptTouchEvents);
    viewport()->grabGesture(Qt::PinchGesture);
}

QPointF TrendPlot::share(const QPointF& scene) const
{
    const QRectF& plot = m_picture->plot();
    if (plot.isEmpty())
        return {};
    return {(scene.x() - plot.left()) / plot.width(), (plot.bottom() - scene.y()) / plot.height()};
}

void TrendPlot::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    Q_EMIT resized();
}

void TrendPlot::mousePressEvent(QMouseEvent* event)
{
    const QPointF place = mapToScene(event->position().toPoint());
    if (!m_picture->plot().adjusted(0, -18, 0, 0).contains(place)) {
        QChartView::mousePressEvent(event); // the legend
        return;
    }
    event->accept();
    m_pressed = m_last = place;
    const bool pan =
        event->button() == Qt::MiddleButton ||
        (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ControlModifier));
    const std::optional<Cursor> cursor = m_picture->overlay().cursorAt(place);
    if (pan)
        m_hold = Hold::Pan;
    else if (event->button() != Qt::LeftButton)
        return;
    else if (cursor)
        m_hold = *cursor == Cursor::A ? Hold::CursorA : Hold::CursorB;
    else
        m_hold = Hold::Box;
    if (m_hold == Hold::Pan)
        viewport()->setCursor(Qt::ClosedHandCursor);
}

void TrendPlot::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF place = mapToScene(event->position().toPoint());
    const QRectF& plot = m_picture->plot();
    switch (m_hold) {
    case Hold::Nothing:
        hover(place);
        QChartView::mouseMoveEvent(event);
        return;
    case Hold::Box:
        m_picture->overlay().setBox(boxTo(place));
        break;
    case Hold::Pan:
        Q_EMIT panned((place.x() - m_last.x()) / plot.width(),
                      (m_last.y() - place.y()) / plot.height());
        break;
    case Hold::CursorA:
    case Hold::CursorB:
        Q_EMIT cursorMoved(m_hold == Hold::CursorA ? Cursor::A : Cursor::B, share(place).x());
        break;
    }
    m_last = place;
    event->accept();
}

void TrendPlot::mouseReleaseEvent(QMouseEvent* event)
{
    const Hold held = std::exchange(m_hold, Hold::Nothing);
    if (held == Hold::Nothing) {
        QChartView::mouseReleaseEvent(event);
        return;
    }
    event->accept();
    viewport()->unsetCursor();
    if (held == Hold::Pan)
        Q_EMIT panEnded();
    if (held != Hold::Box)
        return;
    m_picture->overlay().setBox({});
    const QRectF box = boxTo(mapToScene(event->position().toPoint()));
    const QPointF low = share(box.bottomLeft());
    const QPointF high = share(box.topRight());
    if (!box.isEmpty())
        Q_EMIT boxed(QRectF(low, high));
}

void TrendPlot::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (m_picture->plot().contains(mapToScene(event->position().toPoint())) &&
        event->button() == Qt::LeftButton) {
        m_hold = Hold::Nothing;
        event->accept();
        Q_EMIT backWished();
    } else {
        mousePressEvent(event);
    }
}

/// From where the button went down; a flat one as high as the plot. Empty: nothing was drawn.
QRectF TrendPlot::boxTo(const QPointF& scene) const
{
    const QRectF& plot = m_picture->plot();
    const auto inside = [&](const QPointF& p) {
        return QPointF(std::clamp(p.x(), plot.left(), plot.right()),
                       std::clamp(p.y(), plot.top(), plot.bottom()));
    };
    QRectF box = QRectF(inside(m_pressed), inside(scene)).normalized();
    if (box.width() < leastBox)
        return {};
    if (box.height() < flatBox) {
        box.setTop(plot.top());
        box.setBottom(plot.bottom());
    }
    return box;
}

void TrendPlot::hover(const QPointF& scene)
{
    const std::optional<Cursor> cursor = m_picture->overlay().cursorAt(scene);
    m_picture->overlay().setActive(cursor);
    if (cursor)
        viewport()->setCursor(Qt::SplitHCursor);
    else if (m_picture->plot().contains(scene))
        viewport()->setCursor(Qt::CrossCursor);
    else
        viewport()->unsetCursor();
}

void TrendPlot::wheelEvent(QWheelEvent* event)
{
    event->accept();
    const QPointF scene = mapToScene(event->position().toPoint());
    const QPointF place = share(scene);
    QPoint turn = event->angleDelta();
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->modifiers().testFlag(Qt::AltModifier) || (shift && turn.y() == 0))
        turn = {0, turn.x() + turn.y()}; // some systems turn the wheel sideways with these
    const double factor = std::pow(notch, turn.y() / wheelUnit);
    const TrendAxes::ValueAxis* const axis = m_picture->axes().axisAt(scene);
    if (shift || axis != nullptr) {
        const QString unit = axis != nullptr ? axis->range.unit() : QString();
        if (turn.y() != 0)
            Q_EMIT valuesZoomed(axis != nullptr ? &unit : nullptr, factor, place.y());
        return;
    }
    if (std::abs(turn.x()) > std::abs(turn.y())) {
        Q_EMIT panned(turn.x() / wheelUnit / 10, 0);
        Q_EMIT panEnded();
    } else if (turn.y() != 0) {
        Q_EMIT zoomed(factor, std::clamp(place.x(), 0.0, 1.0));
    }
}

bool TrendPlot::viewportEvent(QEvent* event)
{
    switch (event->type()) {
    case QEvent::Gesture:
        return pinched(static_cast<QGestureEvent*>(event));
    case QEvent::NativeGesture: {
        const auto* const native = static_cast<QNativeGestureEvent*>(event);
        if (native->gestureType() != Qt::ZoomNativeGesture || native->value() <= -1)
            break;
        Q_EMIT zoomed(1 / (1 + native->value()),
                      share(mapToScene(native->position().toPoint())).x());
        return true;
    }
    case QEvent::ToolTip: {
        const auto* const help = static_cast<QHelpEvent*>(event);
        Q_EMIT tipWished(mapToScene(help->pos()), help->globalPos());
        return true;
    }
    case QEvent::Leave:
        m_picture->overlay().setActive({});
        break;
    default:
        break;
    }
    return QChartView::viewportEvent(event);
}

bool TrendPlot::pinched(QGestureEvent* event)
{
    auto* const pinch = static_cast<QPinchGesture*>(event->gesture(Qt::PinchGesture));
    if (pinch == nullptr)
        return false;
    event->accept(pinch);
    m_hold = Hold::Nothing; // the finger that came first is taken for the mouse
    m_picture->overlay().setBox({});
    const QPointF centre = viewport()->mapFromGlobal(pinch->centerPoint());
    if (pinch->changeFlags().testFlag(QPinchGesture::ScaleFactorChanged) &&
        pinch->scaleFactor() > 0)
        Q_EMIT zoomed(1 / pinch->scaleFactor(), share(mapToScene(centre.toPoint())).x());
    if (pinch->changeFlags().testFlag(QPinchGesture::CenterPointChanged)) {
        const double by = pinch->centerPoint().x() - pinch->lastCenterPoint().x();
        if (std::abs(by) >= 1 && !m_picture->plot().isEmpty())
            Q_EMIT panned(by / m_picture->plot().width(), 0);
    }
    if (pinch->state() == Qt::GestureFinished)
        Q_EMIT panEnded();
    return true;
}

void TrendPlot::focusInEvent(QFocusEvent* event)
{
    // Only for who came by keyboard; keyPressEvent() shows it too.
    const Qt::FocusReason why = event->reason();
    m_picture->overlay().setFocused(why == Qt::TabFocusReason || why == Qt::BacktabFocusReason ||
                                    why == Qt::ShortcutFocusReason);
    QChartView::focusInEvent(event);
}

void TrendPlot::focusOutEvent(QFocusEvent* event)
{
    m_picture->overlay().setFocused(false);
    QChartView::focusOutEvent(event);
}
} // namespace ui
