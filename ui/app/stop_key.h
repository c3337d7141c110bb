// SPDX-License-Identifier: GPL-3.0-or-later
// Esc turns torque off from anywhere in the program. It is one event filter of the application,
// because a shortcut does not fire while a cell editor, menu or dialog is open. The first Esc in a
// cell editor, a menu or a dialog cancels that; the next one always stops, and so does Shift+Esc.
// While servos are driven, the first one in a menu or a dialog stops as well. In other fields, such
// as those of the motion panel, the first one stops. Main thread.
#pragma once

#include <QObject>

#include <functional>

class QKeyEvent;
class QWidget;

namespace ui {
class StopKey final : public QObject {
    Q_OBJECT

public:
    /// Listens to the whole application as long as it lives. `driving`: servos may move on the
    /// program's command, or are jammed.
    explicit StopKey(std::function<bool()> driving, QObject* parent = nullptr);

Q_SIGNALS:
    void pressed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool filterKey(const QKeyEvent& event, const QWidget& target);
    void forwardKey(const QKeyEvent& event);

    std::function<bool()> m_driving;
    bool m_canceled = false;           ///< the latest Esc was left to an editor, menu or dialog
    const void* m_forwarded = nullptr; ///< an event on its way up through parents
};
} // namespace ui
