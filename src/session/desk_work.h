// SPDX-License-Identifier: GPL-3.0-or-later
// What Desk hands to its job threads. Internal to Desk: made on the main thread, filled on the job
// thread, looked at again on the main thread when the job has ended.
#pragma once

#include "session/desk.h"

namespace session {
/// False when something else answers there now than what is in the list. One that could not be
/// identified this time or last is taken for the same.
bool isSameKind(const device::Servo& a, const device::Servo& b);

/// One emergency stop being checked, servo by servo.
struct Desk::StopVerification {
    StopResult result;
    std::vector<ServoRef> unread; ///< no verdict yet
    std::size_t openCount = 0;
    bool superseded = false; ///< by another stop
};

struct Desk::Work {
    ServoRef ref = 0; ///< 0: concerns the whole bus
    Task task;
    bool readOnly = false;             ///< may run beside a search at the same rate
    bool changesRate = false;          ///< to another rate or ID: nobody is polled meanwhile
    bool completesBeforeClose = false; ///< a write: begun or not, it is done before the port closes
    std::function<void(Work&)> onMerged; ///< main thread, after the servo has been merged

    /// A servo it concerns: copied when the work starts, merged when it has ended.
    struct Part {
        ServoRef ref = 0;
        device::Servo servo;
        bool tableSaved = false;
        QString savedPath{}; ///< the table was saved there
    };
    Part own;
    std::vector<Part> others; ///< as task.others
    /// All that is copied: none, when it concerns the whole bus.
    std::vector<ServoRef> refs() const;
    void partEnded(Desk& desk, const Part& part) const; ///< main thread
    base::StopToken stop;
    base::Duration startedAt{};
    std::uint64_t epoch = 0; ///< emergency stops before it was asked for

    device::Notices notices;
    std::optional<base::Error> error;
};

struct Desk::Search {
    jobs::ScanSpec spec;
    QString port{};
    bool started = false;
    base::Duration startedAt{};
    std::set<ServoRef> knownFound{}; ///< known before and found again
    bool keepsBaud = false;          ///< at the port's rate: other work can go on beside it
    base::StopToken stop;
    device::Notices notices;
};
} // namespace session
