// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/stop_key.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QWidget>

#include <utility>

namespace ui {
namespace {
/// An editor inside a table: somewhere between it and its window is the viewport of a view.
bool inCellEditor(const QWidget* focus)
{
    for (const QWidget* widget = focus; widget != nullptr && !widget->isWindow();
         widget = widget->parentWidget()) {
        const auto* view = qobject_cast<const QAbstractItemView*>(
            widget->parentWidget() != nullptr ? widget->parentWidget()->parentWidget() : nullptr);
        if (view != nullptr && widget->parentWidget() == view->viewport())
            return true;
    }
    return false;
}

/// `asked`: who got the key.
bool menuOrDialog(const QWidget& asked)
{
    return QApplication::activePopupWidget() != nullptr ||
           QApplication::activeModalWidget() != nullptr ||
           qobject_cast<QDialog*>(asked.window()) != nullptr;
}
} // namespace

StopKey::StopKey(std::function<bool()> driving, QObject* parent)
    : QObject(parent)
    , m_driving(std::move(driving))
{
    qApp->installEventFilter(this);
}

bool StopKey::eventFilter(QObject* watched, QEvent* event)
{
    // Windows see each event first and pass it on; only what reaches a widget counts.
    if (!watched->isWidgetType())
        return false;
    switch (event->type()) {
    case QEvent::KeyPress:
        return filterKey(*static_cast<QKeyEvent*>(event), *static_cast<QWidget*>(watched));
    case QEvent::KeyRelease:
        m_passing = nullptr; // the next press may have this one's address
        return false;
    case QEvent::MouseButtonPress:
        m_cancelled = false;
        return false;
    default:
        return false;
    }
}

bool StopKey::filterKey(const QKeyEvent& event, const QWidget& asked)
{
    if (event.key() != Qt::Key_Escape) {
        if (event.key() != Qt::Key_Shift)
            m_cancelled = false;
        return false;
    }
    if (&event == m_passing) // the same press, at the next parent
        return false;
    if (event.isAutoRepeat())
        return true;
    const bool always = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool editing = inCellEditor(QApplication::focusWidget());
    const bool cancels = !always && !m_cancelled && (editing || menuOrDialog(asked));
    const bool stops = !cancels || (!editing && m_driving());
    m_cancelled = !stops;
    if (cancels)
        passOn(event);
    if (stops)
        Q_EMIT pressed();
    return !cancels;
}

/// It reaches each parent in turn; the address may be another event's once this one has been dealt
/// with.
void StopKey::passOn(const QKeyEvent& event)
{
    m_passing = &event;
    QMetaObject::invokeMethod(
        this, [this] { m_passing = nullptr; }, Qt::QueuedConnection);
}
} // namespace ui
