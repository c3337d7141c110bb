// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_view.h"

#include <QChart>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QNativeGestureEvent>

#include <cmath>
#include <utility>

namespace ui {
namespace {
constexpr double minBoxSize = 6; ///< pixels; less was a click
constexpr double flatBox = 14;   ///< lower than this means time only
constexpr double notch = 0.8;    ///< of the wheel: what is left of the stretch
constexpr double wheelUnit = 120;
constexpr double minDrag = 4; ///< pixels
constexpr double smallPan = 0.1;
constexpr double closer = 0.8;
constexpr double farNudge = 10; ///< pixels
constexpr int manySamples = 10;
} // namespace

TrendView::TrendView(const TrendState& state, QWidget* parent)
    : QChartView(parent)
    , m_scene(new TrendScene(chart(), state, this))
{
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    setContextMenuPolicy(Qt::NoContextMenu); // that of the chart around it
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setViewportUpdateMode(QGraphicsView::BoundingRectViewportUpdate);
    setOptimizationFlags(DontSavePainterState | DontAdjustForAntialiasing);
    setRubberBand(NoRubberBand);
    viewport()->setAutoFillBackground(false); // the background brush fills it
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_AcceptTouchEvents);
    viewport()->grabGesture(Qt::PinchGesture);
}

QPointF TrendView::fraction(const QPointF& scene) const
{
    const QRectF& plot = m_scene->plot();
    if (plot.isEmpty())
        return {};
    return {(scene.x() - plot.left()) / plot.width(), (plot.bottom() - scene.y()) / plot.height()};
}

void TrendView::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    Q_EMIT resized();
}

/// What is begun here: cursors and the edges of lanes are moved, else the view; with Shift its
/// values, with Ctrl a box.
TrendView::DragMode TrendView::dragModeFor(const QMouseEvent& event, const QPointF& position)
{
    if (event.button() == Qt::MiddleButton)
        return DragMode::Pan;
    if (event.button() != Qt::LeftButton)
        return DragMode::Nothing;
    if (const std::optional<Cursor> cursor = m_scene->overlay().cursorAt(position))
        return *cursor == Cursor::A ? DragMode::CursorA : DragMode::CursorB;
    if (TrendAxes::ValueAxis* const lane = m_scene->axes().laneLabelAt(position)) {
        m_draggedLane = lane->range.unit();
        return DragMode::Lane;
    }
    if (TrendAxes::ValueAxis* const lane = m_scene->axes().laneEdgeAt(position)) {
        m_draggedLane = lane->range.unit();
        return DragMode::LaneEdge;
    }
    if (event.modifiers().testFlag(Qt::ControlModifier))
        return DragMode::Box;
    return event.modifiers().testFlag(Qt::ShiftModifier) ? DragMode::PanValues : DragMode::Pan;
}

void TrendView::mousePressEvent(QMouseEvent* event)
{
    const QPointF position = mapToScene(event->position().toPoint());
    const double flags = m_scene->overlay().flagSize();
    const bool onLabel = m_scene->axes().laneLabelAt(position) != nullptr;
    if (!onLabel && !m_scene->plot().adjusted(0, -flags, 0, 0).contains(position)) {
        QChartView::mousePressEvent(event); // the legend
        return;
    }
    event->accept();
    if (m_dragMode != DragMode::Nothing)
        return; // another button, while the first one is held
    m_pressed = m_last = position;
    m_dragButton = event->button();
    const std::optional<QString> offScale = m_scene->offScaleChips().unitAt(position);
    if (offScale && event->button() == Qt::LeftButton) {
        Q_EMIT valuesFitRequested(*offScale);
        return;
    }
    m_dragMode = dragModeFor(*event, position);
    m_hasMoved = false;
    if (m_dragMode == DragMode::Pan || m_dragMode == DragMode::PanValues ||
        m_dragMode == DragMode::Lane)
        viewport()->setCursor(Qt::ClosedHandCursor);
}

void TrendView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF position = mapToScene(event->position().toPoint());
    const QRectF& plot = m_scene->plot();
    const double up = (m_last.y() - position.y()) / plot.height();
    if (m_dragMode != DragMode::Nothing && !m_hasMoved) {
        if ((position - m_pressed).manhattanLength() < minDrag)
            return; // a click whose mouse shook
        m_hasMoved = true;
        if (m_dragMode == DragMode::Pan || m_dragMode == DragMode::PanValues)
            Q_EMIT panStarted();
    }
    switch (m_dragMode) {
    case DragMode::Nothing:
        hover(position);
        QChartView::mouseMoveEvent(event);
        return;
    case DragMode::Box:
        m_scene->overlay().setBox(boxTo(position));
        break;
    case DragMode::Pan:
        Q_EMIT panned((position.x() - m_last.x()) / plot.width(), up);
        break;
    case DragMode::PanValues: {
        const TrendAxes::ValueAxis* const lane = m_scene->axes().laneAt(m_pressed);
        const QString unit = lane != nullptr ? lane->range.unit() : QString();
        Q_EMIT valuesPanned(lane != nullptr ? &unit : nullptr, up);
        break;
    }
    case DragMode::CursorA:
    case DragMode::CursorB:
        Q_EMIT cursorMoved(m_dragMode == DragMode::CursorA ? Cursor::A : Cursor::B,
                           fraction(position).x());
        break;
    case DragMode::LaneEdge:
        Q_EMIT laneEdgeMoved(m_draggedLane, position.y());
        break;
    case DragMode::Lane:
        Q_EMIT laneMoved(m_draggedLane, position.y());
        break;
    }
    m_last = position;
    event->accept();
}

void TrendView::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_dragMode != DragMode::Nothing && event->button() != m_dragButton) {
        event->accept();
        return;
    }
    const DragMode held = std::exchange(m_dragMode, DragMode::Nothing);
    if (held == DragMode::Nothing) {
        QChartView::mouseReleaseEvent(event);
        return;
    }
    event->accept();
    viewport()->unsetCursor();
    if (m_hasMoved && (held == DragMode::Pan || held == DragMode::PanValues))
        Q_EMIT panEnded();
    if (m_hasMoved && (held == DragMode::LaneEdge || held == DragMode::Lane))
        Q_EMIT laneReleased();
    if (held != DragMode::Box)
        return;
    m_scene->overlay().setBox({});
    const QRectF box = boxTo(mapToScene(event->position().toPoint()));
    const QPointF low = fraction(box.bottomLeft());
    const QPointF high = fraction(box.topRight());
    if (!box.isEmpty())
        Q_EMIT boxDrawn(QRectF(low, high));
}

void TrendView::mouseDoubleClickEvent(QMouseEvent* event)
{
    const QPointF position = mapToScene(event->position().toPoint());
    const bool onControl = m_scene->offScaleChips().unitAt(position) ||
                           m_scene->overlay().cursorAt(position) ||
                           m_scene->axes().laneEdgeAt(position) != nullptr;
    if (m_scene->plot().contains(position) && event->button() == Qt::LeftButton && !onControl &&
        m_dragMode == DragMode::Nothing) {
        event->accept();
        Q_EMIT fitRequested();
    } else {
        mousePressEvent(event);
    }
}

/// From where the button went down; a flat one as high as the plot. Empty: nothing was drawn.
QRectF TrendView::boxTo(const QPointF& scene) const
{
    const QRectF& plot = m_scene->plot();
    const auto inside = [&](const QPointF& p) {
        return QPointF(std::clamp(p.x(), plot.left(), plot.right()),
                       std::clamp(p.y(), plot.top(), plot.bottom()));
    };
    QRectF box = QRectF(inside(m_pressed), inside(scene)).normalized();
    if (box.width() < minBoxSize)
        return {};
    if (box.height() < flatBox) {
        box.setTop(plot.top());
        box.setBottom(plot.bottom());
    }
    return box;
}

void TrendView::hover(const QPointF& scene)
{
    const std::optional<Cursor> cursor = m_scene->overlay().cursorAt(scene);
    m_scene->overlay().setActive(cursor);
    if (cursor)
        viewport()->setCursor(Qt::SplitHCursor);
    else if (m_scene->offScaleChips().unitAt(scene))
        viewport()->setCursor(Qt::PointingHandCursor);
    else if (m_scene->axes().laneLabelAt(scene) != nullptr)
        viewport()->setCursor(Qt::OpenHandCursor);
    else if (m_scene->axes().laneEdgeAt(scene) != nullptr)
        viewport()->setCursor(Qt::SplitVCursor);
    else if (m_scene->plot().contains(scene))
        viewport()->setCursor(Qt::CrossCursor);
    else
        viewport()->unsetCursor();
}

void TrendView::wheelEvent(QWheelEvent* event)
{
    event->accept();
    const QPointF scene = mapToScene(event->position().toPoint());
    const QPointF position = fraction(scene);
    QPoint turn = event->angleDelta();
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->modifiers().testFlag(Qt::AltModifier) || (shift && turn.y() == 0))
        turn = {0, turn.x() + turn.y()}; // some systems turn the wheel sideways with these
    const double factor = std::pow(notch, turn.y() / wheelUnit);
    const TrendAxes::ValueAxis* axis = m_scene->axes().axisAt(scene);
    if (shift && axis == nullptr)
        axis = m_scene->axes().laneAt(scene);
    if (shift || axis != nullptr) {
        const double place = axis != nullptr && axis->area.height() > 0
                                 ? (axis->area.bottom() - scene.y()) / axis->area.height()
                                 : position.y();
        const QString unit = axis != nullptr ? axis->range.unit() : QString();
        if (turn.y() != 0)
            Q_EMIT valuesZoomed(axis != nullptr ? &unit : nullptr, factor, place);
        return;
    }
    if (std::abs(turn.x()) > std::abs(turn.y())) {
        Q_EMIT panned(turn.x() / wheelUnit / 10, 0);
        Q_EMIT panEnded();
    } else if (turn.y() != 0) {
        Q_EMIT zoomed(factor, std::clamp(position.x(), 0.0, 1.0));
    }
}

bool TrendView::viewportEvent(QEvent* event)
{
    switch (event->type()) {
    case QEvent::Gesture:
        return pinched(static_cast<QGestureEvent*>(event));
    case QEvent::NativeGesture: {
        const auto* const native = static_cast<QNativeGestureEvent*>(event);
        if (native->gestureType() != Qt::ZoomNativeGesture || native->value() <= -1)
            break;
        Q_EMIT zoomed(1 / (1 + native->value()),
                      fraction(mapToScene(native->position().toPoint())).x());
        return true;
    }
    case QEvent::ToolTip: {
        const auto* const help = static_cast<QHelpEvent*>(event);
        Q_EMIT toolTipRequested(mapToScene(help->pos()), help->globalPos());
        return true;
    }
    case QEvent::Leave:
        m_scene->overlay().setActive({});
        break;
    default:
        break;
    }
    return QChartView::viewportEvent(event);
}

bool TrendView::pinched(QGestureEvent* event)
{
    auto* const pinch = static_cast<QPinchGesture*>(event->gesture(Qt::PinchGesture));
    if (pinch == nullptr)
        return false;
    event->accept(pinch);
    // The finger that came first is taken for the mouse.
    const DragMode dragMode = std::exchange(m_dragMode, DragMode::Nothing);
    if (m_hasMoved && (dragMode == DragMode::Lane || dragMode == DragMode::LaneEdge))
        Q_EMIT laneReleased();
    m_scene->overlay().setBox({});
    const QPointF center = viewport()->mapFromGlobal(pinch->centerPoint());
    if (pinch->changeFlags().testFlag(QPinchGesture::ScaleFactorChanged) &&
        pinch->scaleFactor() > 0)
        Q_EMIT zoomed(1 / pinch->scaleFactor(), fraction(mapToScene(center.toPoint())).x());
    if (pinch->changeFlags().testFlag(QPinchGesture::CenterPointChanged)) {
        const double by = pinch->centerPoint().x() - pinch->lastCenterPoint().x();
        if (std::abs(by) >= 1 && !m_scene->plot().isEmpty())
            Q_EMIT panned(by / m_scene->plot().width(), 0);
    }
    if (pinch->state() == Qt::GestureFinished)
        Q_EMIT panEnded();
    return true;
}

void TrendView::focusInEvent(QFocusEvent* event)
{
    // Only after keyboard focus; keyPressEvent() shows it too.
    const Qt::FocusReason why = event->reason();
    m_scene->overlay().setFocused(why == Qt::TabFocusReason || why == Qt::BacktabFocusReason ||
                                  why == Qt::ShortcutFocusReason);
    QChartView::focusInEvent(event);
}

void TrendView::focusOutEvent(QFocusEvent* event)
{
    m_scene->overlay().setFocused(false);
    QChartView::focusOutEvent(event);
}
/// The keys do all that the mouse does.
void TrendView::keyPressEvent(QKeyEvent* event)
{
    const Qt::KeyboardModifiers with = event->modifiers() & ~Qt::KeypadModifier;
    m_scene->overlay().setFocused(true);
    if (cursorKey(event->key(), event->text(), with) || moveKey(event->key(), with) ||
        zoomKey(event->key(), with) ||
        ((with & ~Qt::ShiftModifier) == Qt::NoModifier && plainKey(event->key())))
        event->accept();
    else
        event->ignore(); // the window's shortcuts and Esc
}

/// [ and ] move A, with Shift B; Alt and the arrows do the same on keyboards without brackets.
bool TrendView::cursorKey(int key, const QString& text, Qt::KeyboardModifiers with)
{
    const bool shift = with.testFlag(Qt::ShiftModifier);
    const bool far = with.testFlag(Qt::ControlModifier);
    double step = 0;
    Cursor which = shift ? Cursor::B : Cursor::A;
    if (key == Qt::Key_BracketLeft || key == Qt::Key_BraceLeft)
        step = -1;
    else if (key == Qt::Key_BracketRight || key == Qt::Key_BraceRight)
        step = 1;
    else if (with.testFlag(Qt::AltModifier) && (key == Qt::Key_Left || key == Qt::Key_Right))
        step = key == Qt::Key_Left ? -1 : 1;
    if (step == 0)
        return false;
    if (text == QLatin1String("{") || text == QLatin1String("}"))
        which = Cursor::B;
    Q_EMIT cursorNudged(which, step * (far ? farNudge : 1));
    return true;
}

bool TrendView::moveKey(int key, Qt::KeyboardModifiers with)
{
    if (with.testFlag(Qt::AltModifier) || with.testFlag(Qt::ControlModifier))
        return false;
    const bool shift = with.testFlag(Qt::ShiftModifier);
    if (m_scene->hasCursors() && (key == Qt::Key_Left || key == Qt::Key_Right)) {
        Q_EMIT cursorStepped((key == Qt::Key_Left ? -1 : 1) * (shift ? manySamples : 1));
        return true;
    }
    const double by = shift ? 5 * smallPan : smallPan;
    switch (key) {
    case Qt::Key_Left:
        Q_EMIT panned(by, 0);
        break;
    case Qt::Key_Right:
        Q_EMIT panned(-by, 0);
        break;
    case Qt::Key_Up:
        Q_EMIT valuesPanned(nullptr, -by);
        break;
    case Qt::Key_Down:
        Q_EMIT valuesPanned(nullptr, by);
        break;
    case Qt::Key_PageUp:
        Q_EMIT panned(1, 0);
        break;
    case Qt::Key_PageDown:
        Q_EMIT panned(-1, 0);
        break;
    default:
        return false;
    }
    Q_EMIT panEnded();
    return true;
}

/// With Shift the values; + and = share a key on many keyboards, so both count.
bool TrendView::zoomKey(int key, Qt::KeyboardModifiers with)
{
    if (with.testFlag(Qt::AltModifier) || with.testFlag(Qt::ControlModifier))
        return false;
    switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        Q_EMIT zoomed(closer, 0.5);
        return true;
    case Qt::Key_Minus:
        Q_EMIT zoomed(1 / closer, 0.5);
        return true;
    case Qt::Key_Asterisk:
    case Qt::Key_Y:
        Q_EMIT valuesZoomed(nullptr, with.testFlag(Qt::ShiftModifier) ? 1 / closer : closer, 0.5);
        return true;
    default:
        return false;
    }
}

bool TrendView::plainKey(int key)
{
    switch (key) {
    case Qt::Key_Home:
        Q_EMIT endRequested(false);
        return true;
    case Qt::Key_End:
        Q_EMIT endRequested(true);
        return true;
    case Qt::Key_Space:
        Q_EMIT pauseRequested();
        return true;
    case Qt::Key_Backspace:
        Q_EMIT backRequested();
        return true;
    case Qt::Key_F:
        Q_EMIT fitRequested();
        return true;
    case Qt::Key_C:
        Q_EMIT cursorsRequested();
        return true;
    default:
        break;
    }
    if (key < Qt::Key_1 || key > Qt::Key_9)
        return false;
    Q_EMIT channelToggleRequested(key - Qt::Key_1);
    return true;
}
} // namespace ui
