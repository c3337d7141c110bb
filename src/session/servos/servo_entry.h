// SPDX-License-Identifier: GPL-3.0-or-later
// One servo in the list of the window: what is known of it, how old that is, and what became of the
// writes to each of its registers. A value kept by Workbench; main thread. Times are
// workbench-clock instants (Workbench::now).
#pragma once

#include "base/journal.h"
#include "device/motion/turn_count.h"
#include "device/writer.h"
#include "session/polling/alarm_latch.h"
#include "session/polling/link_monitor.h"

#include <map>
#include <set>

namespace session {
/// Names a servo as long as the program runs: it stays when ID or rate change, and is never given
/// to another one. 0: none.
using ServoRef = int;

/// The latest write of one register.
struct RegisterWriteState {
    int pending = 0; ///< writes asked for and not ended yet
    std::int64_t requested = 0;
    std::optional<device::WriteOutcome> outcome; ///< of the latest that ended
    std::optional<base::Error> error;
    base::Duration at{};
};

struct ServoEntry {
    ServoRef ref = 0;
    /// Its image is what was really read. profile is null when it answered and could not be
    /// identified.
    device::Servo servo;
    bool duplicateSuspected = false; ///< two servos may share this ID
    bool lateReplySeen = false;
    base::Duration lastSeen{};
    bool silent = false;  ///< did not answer when it was last asked
    bool garbled = false; ///< silent, but something unreadable came in its place
    /// Silent, and something has answered since: not taken for this servo until it is identified.
    bool answeredAgain = false;
    base::Duration statusAt{}; ///< of the regular reading that brought servo.status
    LinkMonitor linkMonitor;   ///< by regular readings
    AlarmLatch alarms;         ///< until acknowledged
    device::TurnCounter turns;
    /// By an emergency stop: nothing may move it until torque is switched on again.
    bool stopped = false;
    base::Duration stoppedAt{};
    bool movedByProgram = false; ///< moved or energised by this program, and not halted since
    base::Duration movedAt{};    ///< the latest time

    bool isReadingTable = false;  ///< its table is being read
    bool hasFullTable = false;    ///< the whole table has been read at least once
    std::set<QString> unreadable; ///< keys whose latest reading failed: their numbers are not shown
    std::optional<base::Error> readError; ///< of the latest reading, if it failed
    device::Image firstImage;             ///< what was read first in this session, for "changed"

    std::map<QString, RegisterWriteState> writes; ///< by register key
    QString snapshotPath; ///< table saved before the first write of this session; empty: not yet
    bool lockOpenedByUs = false;             ///< the journal has an intent of ours that opened it
    std::vector<base::JournalEntry> history; ///< this servo's journal, oldest first

    /// Nullopt: not read, or no such flag.
    std::optional<bool> isLockOpen() const;
    /// The number the table may show: read, and the latest reading did not fail.
    std::optional<std::int64_t> displayedRaw(const catalog::Register& reg) const;
    /// As read first in this session; nullopt: never.
    std::optional<std::int64_t> firstRaw(const catalog::Register& reg) const;
    bool writing() const; ///< any write not ended yet
};
} // namespace session
