// SPDX-License-Identifier: GPL-3.0-or-later
// The head of the control panel, which never scrolls away: which servos are controlled, torque,
// mode, and one line for what an emergency stop leaves until torque is turned on again. For one
// servo its height never changes, because controls below it would move. Owned by the control panel;
// main thread.
#pragma once

#include "ui/common/commands.h"

#include <QWidget>

class QLabel;

namespace ui {
class ControlMode;
class ControlTorque;

class ControlHeader final : public QWidget {
    Q_OBJECT

public:
    ControlHeader(Commands& commands, QWidget* parent);

    ControlTorque* torque() const { return m_torque; }
    ControlMode* mode() const { return m_mode; }
    /// nullptr: no servo is selected. `others`: servos that are controlled together with it.
    void showServo(const session::ServoEntry* entry, std::size_t others);
    /// `stopped`: an emergency stop forbids movement.
    void showStopped(const session::ServoEntry* entry, bool stopped);

private:
    QLabel* m_title;
    ControlTorque* m_torque;
    ControlMode* m_mode;
    QLabel* m_stopped;
};
} // namespace ui
