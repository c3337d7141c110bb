// SPDX-License-Identifier: GPL-3.0-or-later
// The torque switch of the selected servo: shows its state as read, and requests on, off, damping
// and centering; the latter two only if the family has them. Owned by the control panel; main
// thread.
#pragma once

#include "device/motion/motion.h"
#include "ui/common/commands.h"

#include <QWidget>

class QMenu;
class QToolButton;

namespace ui {
class ControlTorque final : public QWidget {
    Q_OBJECT

public:
    ControlTorque(Commands& commands, QWidget* parent);

    void showServo(const session::ServoEntry* entry, bool usable);
    void retranslate();

Q_SIGNALS:
    void requested(device::Torque torque);

protected:
    void changeEvent(QEvent* event) override;

private:
    static QString torqueStateText(std::optional<std::int64_t> state);
    void fillMenu();
    void reserveWidth();
    void showState();

    Commands& m_commands;
    QToolButton* m_switch;
    QToolButton* m_more;
    QMenu* m_menu;
    std::optional<std::int64_t> m_state; ///< as read
    bool m_damping = false;
    bool m_centering = false;
};
} // namespace ui
