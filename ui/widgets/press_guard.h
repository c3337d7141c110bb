// SPDX-License-Identifier: GPL-3.0-or-later
// Protects a control that moves a servo from a press that was aimed at something else: for half a
// second after the control has moved on the screen, changed its size or appeared, mouse presses and
// the wheel have no effect on it, and a tip at the pointer says so. A drag ends where the control
// moves. Keys are not affected. Owned by the control; main thread.
#pragma once

#include "base/clock.h"

#include <QList>
#include <QObject>
#include <QPointer>
#include <QRect>

class QWidget;

namespace ui {
class PressGuard final : public QObject {
    Q_OBJECT

public:
    static constexpr base::Duration guardTime = std::chrono::milliseconds(500);

    explicit PressGuard(QWidget* control);

    /// The clock of all guards, which must outlive them; null: the system's. For tests.
    static void setClock(const base::Clock* clock);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void watchParents();
    void checkGeometry();
    bool hasJustMoved() const;
    bool filterMouse(QEvent& event);
    void explain(const QPoint& geometry);

    QWidget& m_control;
    QList<QPointer<QWidget>> m_watched; ///< the control and all it stands in
    QRect m_geometry;                   ///< on the screen; null while it is hidden
    base::Duration m_movedAt{};
    bool m_pressed = false;
    bool m_dragCanceled = false; ///< it moved while it was pressed
};
} // namespace ui
