// SPDX-License-Identifier: GPL-3.0-or-later
// A task on its way through the queue: made on the main thread, filled on the task thread, looked
// at again on the main thread when it has ended. Internal to the services of the workbench.
#pragma once

#include "session/tasks/task.h"

namespace session {
struct Work {
    ServoRef ref = 0; ///< 0: concerns the whole bus
    Task task;
    bool readOnly = false;             ///< may run beside a search at the same baud rate
    bool changesRate = false;          ///< to another baud rate or ID: nothing is polled meanwhile
    bool completesBeforeClose = false; ///< a write: it is done before the port closes
    std::function<void(Work&)> onMerged; ///< main thread, after the servo has been merged

    /// A servo it concerns: copied when the work starts, merged when it has ended.
    struct Part {
        ServoRef ref = 0;
        device::Servo servo;
        bool tableSaved = false;
        QString savedPath{}; ///< the table was saved there
    };
    Part own;
    std::vector<Part> others; ///< as task.otherServos
    base::StopToken stop;
    base::Duration startedAt{};
    std::uint64_t epoch = 0; ///< emergency stops before it was asked for

    device::Notices notices;
    std::optional<base::Error> error;

    /// All that is copied: none, when it concerns the whole bus.
    std::vector<ServoRef> refs() const;
};
} // namespace session
