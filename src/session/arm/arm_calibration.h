// SPDX-License-Identifier: GPL-3.0-or-later
// The calibration of a robot arm for the window: the arm's joints with their servos of the list,
// the ranges while they are moved by hand, what is written to the servos, and the move test. Owned
// by the workbench; main thread, never waits. Nothing is written before write(), writeFile() or
// prepare().
#pragma once

#include "jobs/arm/arm.h"
#include "jobs/arm/calibration.h"
#include "jobs/arm/lerobot_check.h"
#include "jobs/arm/move_test.h"
#include "jobs/restore/restore_many.h"
#include "session/workbench.h"

#include <atomic>
#include <mutex>

namespace session {
struct ArmJoint {
    jobs::Joint joint;
    ServoRef servo = 0;                              ///< 0: not in the list
    std::optional<jobs::JointCalibration> held{};    ///< what the servo holds; none: not read
    jobs::JointRange range{};                        ///< of the latest recording
    std::optional<jobs::JointCalibration> planned{}; ///< what write() would write
    std::optional<jobs::MoveTestReport> test{};      ///< of the latest move test
};

/// Rows of joints(); empty: all of them.
using JointRows = std::vector<std::size_t>;

class ArmCalibration final : public QObject {
    Q_OBJECT

public:
    enum class Step : std::uint8_t {
        Idle,
        Recording, ///< torque is off, and the joints are moved
        Recorded,  ///< the plan is there; nothing has been written
        Writing,
        Testing, ///< one joint after the other moves to its limits
    };

    explicit ArmCalibration(Workbench& workbench);

    const jobs::Arm& arm() const { return m_arm; }
    /// Forgets what was recorded. Does nothing while isBusy().
    void setArm(jobs::Arm arm);
    const std::vector<ArmJoint>& joints() const { return m_joints; }
    Step step() const { return m_step; }
    bool isBusy() const { return m_step != Step::Idle && m_step != Step::Recorded; }
    /// Each of these joints has its servo, and nothing else is running.
    bool canStart(const JointRows& rows = {}) const;
    JointRows plannedRows() const; ///< what write() would write
    bool canPrepare() const; ///< prepare() would change something, and nothing else is running
    JointRows movable(const JointRows& rows) const; ///< wheels left out
    /// With their servos of the list, as they were read.
    std::vector<jobs::JointServo> jointServos() const;
    /// Reads what servos hold that have not been read yet, once each, and writes nothing.
    void readUnread();

    void startRecording(const JointRows& rows = {}); ///< turns torque off: the arm drops
    /// `isMiddleShown`: the pose now becomes the middle; else that of each range.
    void finishRecording(bool isMiddleShown);
    void cancel(); ///< the recording, the move test, or what was recorded
    /// What is planned, to every joint that has a plan.
    void write();
    /// A calibration from a file, by the names of the joints. failed() if a servo cannot hold it;
    /// then nothing is written.
    void writeFile(const std::vector<jobs::LerobotJoint>& file);
    void prepare(); ///< writes jobs::lerobotSettings() to every joint that is there
    /// Moves them, see jobs/arm/move_test.h; an error, an alarm or lost torque ends the test.
    void startMoveTest(int torquePercent, const JointRows& rows = {});
    /// As LeRobot's file has them: what was read from the servos.
    std::vector<jobs::LerobotJoint> heldAsFile() const;

Q_SIGNALS:
    void changed(); ///< joints() or step()
    void written(const std::vector<jobs::ApplyResult>& results);
    void tested(bool isComplete); ///< the move test has ended, or was stopped: ArmJoint::test
    /// Also where nothing follows from a range although it was recorded.
    void failed(const base::Error& error);

private:
    struct Live;
    void matchServos();
    void updateHeld();
    void drain();
    void recordingEnded(const TaskCompletion& end);
    void testEnded(const TaskCompletion& end);
    void forgetPlan();
    std::vector<snapshot::Snapshot> lerobotTemplates() const;
    void writeTemplates(std::vector<snapshot::Snapshot> templates);
    std::vector<ServoRef> servosOf(const std::vector<snapshot::Snapshot>& templates) const;
    void startLive(Step step, const JointRows& rows, Task task);
    bool perform(Task task, std::vector<ServoRef> servos);
    std::vector<ServoRef> servosAt(const JointRows& rows) const;
    bool isFree() const; ///< nothing else is running

    Workbench& m_workbench;
    jobs::Arm m_arm;
    std::vector<ArmJoint> m_joints;
    Step m_step = Step::Idle;
    bool m_isMiddleShown = false;
    JointRows m_moving;                     ///< the rows that are recorded or tested
    std::vector<snapshot::Snapshot> m_plan; ///< for the servos that were recorded
    std::vector<ServoRef> m_asked;          ///< for what they hold, by readUnread()
    std::shared_ptr<Live> m_live;           ///< shared with the recording or the test
    QTimer m_drainTimer;
};
} // namespace session
