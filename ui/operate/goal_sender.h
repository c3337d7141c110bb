// SPDX-License-Identifier: GPL-3.0-or-later
// Sends goals from the controls to the servos: drags of slider and dial as they go, typed goals by
// Enter or Set, steps by their buttons. Asks before a goal turns torque on. Values in the servo's
// own units. Owned by the control panel; main thread, never waits.
#pragma once

#include "session/motion/motion_controller.h"
#include "session/servos/servo_registry.h"
#include "ui/common/selection.h"

#include <QTimer>

namespace ui {
class ControlFields;
class ControlGoal;
class ControlMessages;
class ControlSend;
class MoveResult;
class TorqueConfirmation;

class GoalSender final : public QObject {
    Q_OBJECT

public:
    struct Controls {
        ControlGoal& goal;
        ControlFields& fields;
        ControlSend& send;
        ControlMessages& messages;
        MoveResult& result;
        TorqueConfirmation& torque;
    };
    GoalSender(const session::ServoRegistry& registry, const Selection& selection,
               session::MotionController& motion, const Controls& controls, QObject* parent);

    /// As dragging the slider there; a short rest ends the drag.
    void dragDialTo(std::int64_t raw);

Q_SIGNALS:
    void controlsChanged(); ///< the controls show an older state than the servos have

private:
    void dragTo(std::int64_t raw, bool dragged);
    void endDrag();
    void sendTypedGoal();
    void confirmAndSend(std::int64_t raw);
    void send(std::int64_t raw, bool dragged);
    void onMoveSent(const session::MoveRequest& request);
    const catalog::Register* goalRegister(const session::ServoEntry* entry) const;
    const session::ServoEntry* entry() const;

    const session::ServoRegistry& m_registry;
    const Selection& m_selection;
    session::MotionController& m_motion;
    Controls m_controls;
    bool m_isDragging = false;
    QTimer m_dialDragTimer;
};
} // namespace ui
