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
/// An editor inside a table: one of its parents is the viewport of a view.
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

/// `asked`: the widget that received the key.
bool menuOrDialog(const QWidget& target)
{
    return QApplication::activePopupWidget() != nullptr ||
           QApplication::activeModalWidget() != nullptr ||
           qobject_cast<QDialog*>(target.window()) != nullptr;
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
    // Windows get each event first and pass it on; only events for a widget count.
    if (!watched->isWidgetType())
        return false;
    switch (event->type()) {
    case QEvent::KeyPress:
        return filterKey(*static_cast<QKeyEvent*>(event), *static_cast<QWidget*>(watched));
    case QEvent::KeyRelease:
        m_forwarded = nullptr; // the next press may have this one's address
        return false;
    case QEvent::MouseButtonPress:
        m_canceled = false;
        return false;
    default:
        return false;
    }
}

bool StopKey::filterKey(const QKeyEvent& event, const QWidget& target)
{
    if (event.key() != Qt::Key_Escape) {
        if (event.key() != Qt::Key_Shift)
            m_canceled = false;
        return false;
    }
    if (&event == m_forwarded) // the same press, at the next parent
        return false;
    if (event.isAutoRepeat())
        return true;
    const bool always = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool editing = inCellEditor(QApplication::focusWidget());
    const bool cancels = !always && !m_canceled && (editing || menuOrDialog(target));
    const bool stops = !cancels || (!editing && m_driving());
    m_canceled = !stops;
    if (cancels)
        forwardKey(event);
    if (stops)
        Q_EMIT pressed();
    return !cancels;
}

/// The event reaches each parent in turn; its address may be reused after it has been handled.
void StopKey::forwardKey(const QKeyEvent& event)
{
    m_forwarded = &event;
    QMetaObject::invokeMethod(
        this, [this] { m_forwarded = nullptr; }, Qt::QueuedConnection);
}
} // namespace ui
