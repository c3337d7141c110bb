// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the servos that were chosen: goals, torque, modes, the torque limit. Beside Workbench, on
// the main thread, never waits. While a goal is on its way to the wire the next one waits here, and
// a newer one takes its place: a drag never queues up. Nothing is sent that was not asked for; what
// is out of the limits is refused with the reason (failed). After an emergency stop everything but
// torque is refused until torque is switched on again; Workbench sees to that.
#pragma once

#include "device/motion/mode.h"
#include "device/motion/motion.h"
#include "device/motion/move_limits.h"
#include "session/workbench.h"

namespace session {
/// As device::MoveCommand, for each of the chosen servos; a field a servo's family or mode has not
/// is not given. Text as typed: "2048", "90deg", "30rpm", "20%".
struct MoveRequest {
    QString goal;
    std::optional<QString> speed{};
    std::optional<QString> acceleration{};
    std::optional<QString> time{};    ///< ms
    std::optional<QString> current{}; ///< HLS: the current limit of a move
    device::MoveMethod how = device::MoveMethod::Write;
    /// One of many while a control is dragged. The settings are read with the first and then once
    /// a second; after a failure the rest of the drag is not sent. See endDrag().
    bool dragged = false;
};

class MotionController final : public QObject {
    Q_OBJECT

public:
    explicit MotionController(Workbench& workbench, QObject* parent = nullptr);

    /// The first is the one whose limits and mode the page shows. Forgets a goal that waits here.
    void setServos(const std::vector<ServoRef>& servos);
    const std::vector<ServoRef>& servos() const { return m_servos; }

    /// Several servos go by sync write or by held writes; by plain writes one after the other.
    /// Async only leaves the goals in the servos: execute() starts them. False: the rest of a drag
    /// that has failed, and not taken.
    bool move(const MoveRequest& request);
    void endDrag();
    /// Step mode: the last step once more.
    void repeatStep();
    bool canRepeatStep() const { return m_lastStep.has_value(); }
    /// Starts all goals of ours that wait in servos, chosen now or not.
    void startHeldMoves();
    int heldCount() const { return static_cast<int>(m_held.size()); }
    /// Steps of relative moves since the port was opened or step mode was entered here.
    std::int64_t totalSteps(ServoRef ref) const;

    void setTorque(device::Torque torque);
    void halt(); ///< ends the motion, torque stays on
    void switchMode(const QString& mode);
    /// What switchMode would do to the first servo, worked out from reads only; modePreviewed
    /// follows, or failed.
    void previewMode(const QString& mode);
    /// The RAM register, or where there is none the EPROM row until power-off (SCS).
    void setTorqueLimit(std::int64_t raw);

    /// One of the chosen servos was stopped in an emergency, and torque not switched on since.
    bool isStopped() const;
    bool isBusy() const { return m_running > 0; } ///< something is on its way

Q_SIGNALS:
    void changed(); ///< servos, held(), busy(), totalSteps()
    void moveSent(
        const session::MoveRequest& request); ///< its goals have arrived, or wait in the servos
    void modePreviewed(const device::ModePlan& plan);
    void modeSwitched();
    void failed(const base::Error& error);
    void noticesReported(const device::Notices& notices);

private:
    struct PendingMove;

    void handleEvent(const Event& event);
    void removeMissing();
    void send(const MoveRequest& request);
    void markMove(ServoRef ref, const device::MovePlan& plan, bool dragged = false);
    void noteHeld(const std::vector<ServoRef>& servos, const std::vector<device::MovePlan>& plans);
    void sendNext();
    void moveEnded(const PendingMove& sending, const TaskCompletion& end);
    void perform(const std::vector<ServoRef>& servos, Task task,
                 std::function<void(const TaskCompletion&)> done);
    void reportCompletion(const TaskCompletion& end);

    Workbench& m_workbench;
    std::vector<ServoRef> m_servos;
    std::optional<MoveRequest> m_next;
    std::optional<MoveRequest> m_lastStep;
    bool m_sending = false; ///< a goal is on its way
    int m_running = 0;

    bool m_dragging = false;
    bool m_dragFailed = false;
    device::Notices m_dragNotices; ///< shown in this drag

    std::map<ServoRef, device::MovePlan> m_held; ///< their servo pointers are null
    std::map<ServoRef, std::int64_t> m_totalSteps;
};
} // namespace session
