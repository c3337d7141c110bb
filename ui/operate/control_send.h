// SPDX-License-Identifier: GPL-3.0-or-later
// The row that sends goals: write, sync or async, the button that starts goals waiting in servos,
// and Set. Offers only what the servo supports. It sends nothing itself. Owned by the control
// panel; main thread.
#pragma once

#include "device/motion/motion.h"
#include "session/servos/servo_entry.h"

#include <QWidget>

class QPushButton;

namespace ui {
class SegmentedControl;

class ControlSend final : public QWidget {
    Q_OBJECT

public:
    explicit ControlSend(QWidget* parent);

    device::MoveMethod method() const;
    bool canSend() const;
    /// Other servos are controlled now: the next showServo() chooses the method for them.
    void resetMethod() { m_methodChosen = false; }
    struct State {
        bool severalServos = false;
        bool canMove = false; ///< the port is open and no emergency stop is in force
        int waitingGoals = 0; ///< in servos, until Execute
    };
    /// The entry has a profile.
    void showServo(const session::ServoEntry& entry, const State& state);
    void retranslate();

Q_SIGNALS:
    void sendRequested();
    void executeRequested();

private:
    void chooseMethod(const device::Servo& servo, bool severalServos);

    SegmentedControl* m_method;
    QPushButton* m_execute;
    QPushButton* m_set;
    bool m_methodChosen = false;
};
} // namespace ui
