// SPDX-License-Identifier: GPL-3.0-or-later
// Before the port closes: servos that this program has set in motion and that would go on without
// it, EPROM locks that a write has left open, and what the journal still holds. Also answers
// whether anything may be moving. Owned by the workbench; main thread; never waits.
#pragma once

#include "base/journal.h"
#include "session/tasks/work.h"

#include <QObject>
#include <QStringList>

namespace session {
class Workbench;

/// A servo that goes on without the program.
struct MovingServo {
    ServoRef servo = 0;
    bool endless = false; ///< speed, PWM or current: it does not stop on its own
};

/// What happens to servos that this program has set in motion when the port closes.
enum class MotionOnClose : std::uint8_t {
    Stop,           ///< as far as they reply; the port closes in any case
    StopOrKeepOpen, ///< where one could not be stopped the port stays open: portKeptOpen()
    LeaveMoving,    ///< the user has chosen so
};

/// What happens to an EPROM lock that a write of this program has left open.
enum class LockOnClose : std::uint8_t {
    Close,           ///< as far as the servo replies; the port closes in any case
    CloseOrKeepOpen, ///< where one stays open the port does: portKeptOpen()
    LeaveOpen,       ///< the user has chosen so
};

/// What the journal still holds of the servos on this port, beside the work in progress.
struct OpenWrites {
    std::vector<int> ids{};           ///< of the servos
    std::vector<ServoRef> unlocked{}; ///< those whose EPROM lock is open since
    /// Of servos that the list does not show since, the IDs they may have ("1 / 21"): a write has
    /// opened the EPROM lock, and it has not been confirmed as closed.
    QStringList unlockedElsewhere{};
};

class CloseSequence final : public QObject {
    Q_OBJECT

public:
    explicit CloseSequence(Workbench& bench);

    /// Ends searches and polls, finishes the writes asked for, drops other tasks that wait. The
    /// list stays, grayed by the state.
    void disconnectFrom(MotionOnClose moving = MotionOnClose::Stop,
                        LockOnClose lock = LockOnClose::Close);
    /// Like disconnectFrom(), for closing the window: closed() follows, once.
    void closeForExit(MotionOnClose moving = MotionOnClose::Stop,
                      LockOnClose lock = LockOnClose::Close);
    /// Reads the journal; openWritesFound follows, after a few seconds in any case.
    void findOpenWrites();
    /// Reads which of the servos that were moved or energized from here still turn; motionDetected
    /// follows. Writes nothing.
    void detectMotion();
    /// A test runs, or a servo is seen to move or to be jammed, or may move as it was commanded.
    bool isMotionPossible() const;

    /// For the services of the workbench.
    bool isPending() const { return m_pendingClose.has_value(); }
    void markMoved(const Work& ended);
    void finishClosing(); ///< the port is closed

Q_SIGNALS:
    void closed();
    void motionDetected(const std::vector<session::MovingServo>& moving);
    void openWritesFound(const session::OpenWrites& found);
    void portKeptOpen(); ///< after MotionOnClose::StopOrKeepOpen or LockOnClose::CloseOrKeepOpen;
                         ///< see CloseCanceled

private:
    struct PendingClose {
        MotionOnClose how = MotionOnClose::Stop;
        LockOnClose lock = LockOnClose::Close;
        std::size_t open = 0; ///< tasks that have not ended
        std::vector<ServoRef> halted{};
        std::vector<ServoRef> moving{};
        std::vector<ServoRef> locked{};
        std::vector<ServoRef> unlocked{};
    };
    std::vector<ServoRef> servosMovedByProgram() const;
    std::vector<ServoRef> unlocked() const;
    bool hasTaskFor(int id) const;
    void collectOpenWrites(const std::vector<base::Intent>& open, OpenWrites& found);
    void prepareClose();
    void haltMoved(const std::vector<ServoRef>& all);
    void halted(ServoRef ref, bool moved, const std::optional<base::Error>& error);
    void closeLocks(const std::vector<ServoRef>& all);
    void closeStepEnded();
    void finishPendingClose();
    void closeNow();
    void tellClosed();

    Workbench& m_bench;
    bool m_closing = false;                     ///< for good: the window closes
    std::optional<PendingClose> m_pendingClose; ///< the port closes when these have been stopped
};
} // namespace session
