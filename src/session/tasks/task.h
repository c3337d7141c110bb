// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of the bench: tasks with servos, writes of registers. Values made on the main
// thread; Task::work runs on the job thread.
#pragma once

#include "device/context.h"
#include "device/writer.h"
#include "jobs/job.h"
#include "session/servos/servo_entry.h"

#include <QPointer>

namespace session {
/// What a task gets on the job thread. `servo` is a copy; what is in it afterwards is merged into
/// the list, and the servo is followed when its ID or rate have changed.
struct TaskContext {
    const device::Context& device;
    device::Servo& servo;
    const base::StopToken& stop;
    jobs::ProgressFn progress; ///< may be called; arrives as Workbench::taskProgress
    std::vector<device::Servo*> otherServos{}; ///< copies too, as Task::others; all are merged
};

struct TaskCompletion {
    std::optional<base::Error> error; ///< the task's own, or Stopped/LinkLost when it never ran
    device::Notices notices;
};

/// What a task may do to a shaft. After an emergency stop Moves is refused until an EnablesTorque
/// has succeeded for each servo it concerns.
enum class Effect : std::uint8_t {
    None,
    Moves,         ///< goals, actions, motion registers
    EnablesTorque, ///< the user switches torque on
};

struct Task {
    QString name;            ///< technical: "center"; goes into the Event
    bool savesTable = false; ///< the table is saved first if this session has not yet
    Effect effect = Effect::None;
    /// Servos the task owns beside its own, all at the same rate; one that is gone ends the task
    /// with NoReply before the first byte.
    std::vector<ServoRef> otherServos{};
    /// What replies in the end with another firmware is still this servo.
    bool changesFirmware = false;
    /// The port is at another rate for a while, which is put back in the end.
    bool changesPortBaud = false;
    bool quiet = false; ///< no Event unless it failed
    /// A test of minutes or hours. While it runs the wire is its own: others are read once a
    /// second, tables when it has ended, and what writes or searches is refused (Held, "test").
    bool isLongRunning = false;
    /// A test that moves its servos: they hold afterwards, or have no torque, also when it is
    /// stopped. None: it leaves torque as it is.
    std::optional<bool> holdsTorqueAfterwards{};
    std::function<base::Result<void>(TaskContext&)> work; ///< job thread
    QPointer<QObject> guard;                              ///< `done` is dropped when it is gone
    std::function<void(const TaskCompletion&)> done{};    ///< main thread
};

struct WriteRequest {
    std::vector<device::WriteItem> items; ///< ID and rate included: those servos are followed
    bool temporary = false;
    device::Consent consent{};
};

/// What undo() would do.
struct UndoStep {
    ServoRef servo = 0;
    std::vector<device::WriteItem> oldItems;
    std::vector<device::WriteItem> newItems;
    bool temporary = false;
};
} // namespace session
