// SPDX-License-Identifier: GPL-3.0-or-later
// What Desk hands to its job threads. Internal to Desk: made on the main thread, filled on the job
// thread, looked at again on the main thread when the job has ended.
#pragma once

#include "session/desk.h"

namespace session {
struct Desk::Work {
    ServoRef ref = 0; ///< 0: concerns the whole bus
    Task task;
    bool readOnly = false;             ///< may run beside a search at the same rate
    bool finishes = false;             ///< a write: begun or not, it is done before the port closes
    std::function<void(Work&)> merged; ///< main thread, after the servo has been merged

    device::Servo servo; ///< a copy, made when the work starts
    bool tableSaved = false;
    base::Stop stop;
    base::Duration startedAt{};

    device::Notices notices;
    QString savedPath; ///< the table was saved there
    std::optional<base::Error> error;
};

struct Desk::Search {
    jobs::ScanSpec spec;
    bool started = false;
    base::Duration startedAt{};
    std::set<ServoRef> met{}; ///< known before and found again
    bool staysHere = false;   ///< at the port's rate: other work can go on beside it
    base::Stop stop;
    device::Notices notices;
};
} // namespace session
