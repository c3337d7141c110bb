// SPDX-License-Identifier: GPL-3.0-or-later
// What happens at the bench, as data: the window words it and logs it. Values told by
// Workbench; main thread.
#pragma once

#include "base/notice.h"
#include "session/servos/servo_entry.h"

#include <QDateTime>

namespace session {
enum class LinkState : std::uint8_t {
    Off,
    Opening,
    Open,
    Closing, ///< the running write ends first
    Lost,    ///< unplugged; see lastRequest()
};

/// What reading the torque switches back after an emergency stop has shown.
struct StopResult {
    std::vector<ServoRef> off;
    std::vector<ServoRef> stillOn;   ///< after having been told several times
    std::vector<ServoRef> silent;    ///< did not answer
    std::vector<ServoRef> stillHeld; ///< off, but a goal may wait in it for an ACTION
    std::vector<ServoRef> otherBaud; ///< at another rate: the stop has not reached them
    bool isConfirmed() const
    {
        return stillOn.empty() && silent.empty() && stillHeld.empty() && otherBaud.empty();
    }
};

/// Something that happened, as data; the window words it and logs it.
struct Event {
    enum class Kind : std::uint8_t {
        Connected,
        Disconnected,
        LinkLost,
        SearchEnded,     ///< found, elapsed, missing
        Replaced,        ///< `servo` answers where another one was, named by task
        TableSaved,      ///< path: before the first write of the session
        Written,         ///< report; or error: nothing was written
        Task,            ///< task names it; error if it failed
        GoalSent,        ///< a goal was sent; path says which, empty: it follows a control
        Started,         ///< a lasting task, named by task
        Finished,        ///< a lasting task; error if it did not succeed
        Stopped,         ///< emergency stop sent, or owed
        StopNotSent,     ///< there was no port to send it on
        CloseCanceled,   ///< the port stays open: `moving` could not be stopped, `unlocked` not
                         ///< locked
        StopUnconfirmed, ///< `stop.silent`: torque off was sent, and has not been read back yet
        StopVerified,    ///< `stop` says whether torque is off everywhere
        Failed,          ///< anything else that went wrong
    };
    Kind kind = Kind::Failed;
    QDateTime at{};
    ServoRef servo = 0;
    int id = -1;
    QString task{}; ///< technical name: "center"
    QString path{};
    std::optional<base::Error> error{};
    std::optional<device::WriteReport> report{};
    device::Notices notices{};
    bool isUndo = false; ///< the write was an undo
    bool isRedo = false; ///< it was a redo
    int found = 0;       ///< servos
    base::Duration elapsed{};
    /// Expected by a search that has asked there, and silent: IDs.
    std::vector<int> missing{};
    StopResult stop{};
    bool isPending = false;  ///< the stop is sent first when the link is back
    bool isRepeated = false; ///< a stop that was not sent, said again once a port is open
    /// Of Disconnected and CloseCanceled: servos that were stopped before the port closed, and
    /// those that still turned then.
    std::vector<ServoRef> halted{};
    std::vector<ServoRef> moving{};
    /// Likewise: EPROM locks of this program that were closed, and those that stayed open.
    std::vector<ServoRef> locked{};
    std::vector<ServoRef> unlocked{};
};
} // namespace session
