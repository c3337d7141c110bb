// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/press_guard.h"

#include <QMouseEvent>
#include <QToolTip>
#include <QWidget>

namespace ui {
namespace {
const base::Clock*& testClock()
{
    static const base::Clock* clock = nullptr;
    return clock;
}

base::Duration now()
{
    static const base::SystemClock system;
    return testClock() != nullptr ? testClock()->now() : system.now();
}
} // namespace

PressGuard::PressGuard(QWidget* control)
    : QObject(control)
    , m_control(*control)
    , m_movedAt(now())
{
    watchParents();
    checkGeometry();
}

void PressGuard::setClock(const base::Clock* clock)
{
    testClock() = clock;
}

/// Every parent of the control can move it.
void PressGuard::watchParents()
{
    for (const QPointer<QWidget>& widget : m_watched) {
        if (widget)
            widget->removeEventFilter(this);
    }
    m_watched.clear();
    for (QWidget* widget = &m_control; widget != nullptr; widget = widget->parentWidget()) {
        m_watched << widget;
        widget->installEventFilter(this);
        if (widget->isWindow())
            break;
    }
}

void PressGuard::checkGeometry()
{
    const QRect geometry =
        m_control.isVisible() ? QRect(m_control.mapToGlobal(QPoint()), m_control.size()) : QRect();
    if (geometry == m_geometry)
        return;
    m_geometry = geometry;
    m_movedAt = now();
    m_dragCanceled = m_pressed;
}

bool PressGuard::hasJustMoved() const
{
    return now() - m_movedAt < guardTime;
}

bool PressGuard::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ParentChange:
        watchParents();
        checkGeometry();
        return false;
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
        checkGeometry();
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::Wheel:
        return watched == &m_control && filterMouse(*event);
    default:
        return false;
    }
}

bool PressGuard::filterMouse(QEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseMove:
        return m_dragCanceled;
    case QEvent::MouseButtonRelease:
        m_pressed = false;
        m_dragCanceled = false;
        return false;
    case QEvent::Wheel:
        event.ignore(); // what it stands in may still be scrolled
        return hasJustMoved();
    default:
        break;
    }
    if (!hasJustMoved()) {
        m_pressed = true;
        return false;
    }
    m_control.clearFocus(); // a wheel that turns on must not move it either
    explain(static_cast<QMouseEvent&>(event).globalPosition().toPoint());
    event.accept();
    return true;
}

void PressGuard::explain(const QPoint& geometry)
{
    QToolTip::showText(
        geometry, tr("Click ignored: this control had just moved on the screen. Click it again."),
        &m_control);
}
} // namespace ui
