// SPDX-License-Identifier: GPL-3.0-or-later
// The bench behind the window: one port, the servos on it, and every task done to them. Owns the
// connection, the job threads and the list of servos; lives on the main thread and never waits:
// each call returns at once, what comes of it arrives as a signal or in the callback, on the main
// thread. Jobs see copies of a servo; what they read is merged into the list by time of reading.
// Nothing is written to a servo that was not asked for by write(), perform() or emergencyStop().
#pragma once

#include "jobs/recover/recover.h"
#include "jobs/scan/scan.h"
#include "session/event.h"
#include "session/job_thread.h"
#include "session/main_thread_queue.h"
#include "session/polling/polling_service.h"
#include "session/session.h"
#include "session/task.h"

#include <QObject>
#include <QTimer>

#include <deque>

namespace jobs {
struct StopCheckResult;
struct ApplyResult;
} // namespace jobs

namespace session {
struct ApplyRequest;
struct RestoreRequest;

/// A servo that goes on without the program.
struct MovingServo {
    ServoRef servo = 0;
    bool endless = false; ///< speed, PWM or current: it does not stop by itself
};

/// What becomes of servos that this program has set in motion when the port closes.
enum class MotionOnClose : std::uint8_t {
    Stop,           ///< as far as they answer; the port closes in any case
    StopOrKeepOpen, ///< where one could not be stopped the port stays open: stayedOpen()
    LeaveMoving,    ///< the user has said so
};

/// What becomes of an EPROM lock that a write of this program has left open.
enum class LockOnClose : std::uint8_t {
    Close,           ///< as far as the servo answers; the port closes in any case
    CloseOrKeepOpen, ///< where one stays open the port does: stayedOpen()
    LeaveOpen,       ///< the user has said so
};

/// What the journal still holds of the servos on this port, beside the work that is under way.
struct OpenWrites {
    std::vector<int> ids{};           ///< of the servos
    std::vector<ServoRef> unlocked{}; ///< those whose EPROM lock is open since
    /// Of servos that the list does not show since, the IDs they may have ("1 / 21"): a write has
    /// opened the EPROM lock, and it has not been proven closed.
    QStringList unlockedElsewhere{};
};

class Desk final : public QObject {
    Q_OBJECT

public:
    explicit Desk(Session& session, QObject* parent = nullptr);
    ~Desk() override; ///< waits for the running job; see close()

    // --- the port ---
    LinkState state() const { return m_state; }
    const PortRequest& lastRequest() const { return m_request; }
    bool isSimulated() const;
    int baud() const; ///< the port's present rate; 0 without port
    bool canSetBaud() const;
    bus::Statistics statistics() const;
    base::Duration now() const; ///< the clock of all times here
    const catalog::Catalog& catalog() const { return m_session.catalog(); }
    Session& session() { return m_session; }
    Connection* connection() const { return m_connection.get(); } ///< null while not open
    bool hasOpenedPort() const { return !m_portName.isEmpty(); }  ///< one was open before, or is

    /// Closes what is open first. linkChanged follows; a failure arrives as connectFailed.
    void connectTo(const PortRequest& request);
    /// Ends searches and polls, finishes the writes asked for, drops other tasks that wait. The
    /// list stays, grayed by the state.
    void disconnectFrom(MotionOnClose moving = MotionOnClose::Stop,
                        LockOnClose lock = LockOnClose::Close);
    /// Like disconnectFrom(), for closing the window: closed() follows, once.
    void closeForExit(MotionOnClose moving = MotionOnClose::Stop,
                      LockOnClose lock = LockOnClose::Close);
    /// Reads the journal; openWritesFound follows, after a few seconds in any case.
    void findOpenWrites();
    /// Reads which of the servos that were moved or energised from here still turn; motionDetected
    /// follows. Writes nothing.
    void detectMotion();
    void powerCycle(); ///< simulated servos only

    // --- search ---
    /// Queued behind running tasks where it needs other rates. Servos appear as they are found;
    /// those in the searched range that did not answer, also when asked again, leave the list at
    /// the end, and the event names them.
    void search(const jobs::ScanSpec& spec);
    /// The next searches also say whether this ID is absent at the port's rate.
    void setExpectedId(std::optional<int> id) { m_expectedId = id; }
    void stopSearch();
    bool isSearching() const { return m_search != nullptr; }
    /// Of a search that finds nothing.
    base::Duration searchEstimate(const jobs::ScanSpec& spec) const;
    const std::optional<jobs::ScanReport>& lastSearch() const { return m_lastSearch; }
    const jobs::ScanSpec& lastSearchSpec() const { return m_lastSpec; }
    /// Those that were seen to have the port open at its end: "minicom (1234)".
    const QString& otherPrograms() const { return m_otherPrograms; }

    // --- servos ---
    const std::vector<ServoRef>& servos() const { return m_order; }
    const ServoEntry* servo(ServoRef ref) const;               ///< null: gone
    ServoRef findServo(base::Protocol protocol, int id) const; ///< 0: not in the list

    /// Reads the whole table. Writes nothing.
    void readTable(ServoRef ref);
    void write(ServoRef ref, const WriteRequest& request);
    void perform(ServoRef ref, Task task);
    /// As its plan says, in one transaction; told like a write, and Undo takes it back. The bench
    /// of session/restore_order.h.
    void restore(ServoRef ref, const RestoreRequest& request);
    /// One after the other, at the port's rate.
    void apply(ApplyRequest request);
    bool isBusy() const; ///< a task runs or waits
    std::optional<bool>
    testHoldsTorque() const; ///< Task::holdsTorqueAfterwards of the one that runs
    bool isTesting() const;  ///< a lasting task runs; see Task::isLongRunning
    void stopTask();         ///< the running task; those that wait are dropped
    void stopTest();         ///< the running one, if it is a lasting one; nothing else
    /// A test runs, or a servo is seen to move or to be jammed, or may move as it was commanded.
    bool isMotionPossible() const;

    /// Regular reading of what `user` ("memory", "operate", "record") wants to see, of servos that
    /// answer at the port's rate. Replaces this user's wish before; no parts: ends it.
    void subscribe(const QString& user, const Subscription& wish);
    PollRate pollRate(ServoRef ref) const { return m_polling.rate(ref); }
    Communication communication(ServoRef ref) const;

    void acknowledgeAlarms(ServoRef ref);
    /// A goal was sent: shown in charts and recordings.
    void markMove(ServoRef ref, const QString& text, bool dragged = false);

    const UndoStep* undoStep() const;
    const UndoStep* redoStep() const;
    void undo();
    /// `dangerous`: the user's consent, asked for anew; without it a dangerous row is refused.
    void redo(bool dangerous = false);

    /// Reads this servo's writes from the journal; servoChanged follows.
    void loadHistory(ServoRef ref);

    /// Torque off for the whole bus, ahead of everything. Never waits. Then reads every torque
    /// switch back and makes harmless what waits in servos (StopVerified). Whatever moves a servo
    /// is refused until torque has been switched on for it again.
    void emergencyStop();

    // --- interrupted writes of earlier sessions ---
    /// Looks (reads only) and answers with openIntents; asked by itself after the first search.
    /// `anyPort`: also for servos whose change was begun on a port that is gone.
    void findOpenIntents(bool anyPort = false);
    void recoverIntent(const QString& uuid, jobs::RecoveryAction action);
    void discardIntent(const QString& uuid);

Q_SIGNALS:
    void linkChanged();
    void connectFailed(const base::Error& error);
    void closed();
    void motionDetected(const std::vector<session::MovingServo>& moving);
    void openWritesFound(const session::OpenWrites& found);
    void portKeptOpen(); ///< after MotionOnClose::StopOrKeepOpen or LockOnClose::CloseOrKeepOpen;
                         ///< see CloseCanceled

    void searchChanged(); ///< started or ended
    void searchProgress(const jobs::Progress& progress);

    void servoAdded(session::ServoRef ref);
    void servoChanged(session::ServoRef ref); ///< anything but the numbers of its table
    void servoRemoved(session::ServoRef ref);
    void servosCleared();
    void orderChanged();                      ///< the same servos, sorted anew
    void tableChanged(session::ServoRef ref); ///< numbers or their states
    /// About 30 times a second, in time order. Those that were not answered too.
    void readingsReceived(const std::vector<session::Reading>& batch);
    void markAdded(const record::Mark& mark);

    void taskChanged(); ///< busy() may have changed
    void taskProgress(const jobs::Progress& progress);
    void undoChanged();
    void eventOccurred(const session::Event& event);
    /// Also when empty; after a look that failed there is only the Event. `elsewhere`: open as
    /// well, but begun on other ports, and not looked at.
    void openIntentsFound(const std::vector<jobs::RecoveryResult>& found,
                          const std::vector<base::Intent>& elsewhere);

private:
    struct Work;   ///< one task on its way
    struct Search; ///< the running scan

    // link (desk.cpp)
    void setState(LinkState state);
    void portOpened(base::Result<std::unique_ptr<Connection>> result);
    void checkLink();
    void scheduleNext();
    void finishClosing();
    void clearServos();

    // who answers (desk_presence.cpp)
    struct ReplyCounters { ///< of one ID
        std::uint64_t ok = 0;
        std::uint64_t missed = 0; ///< when it last answered, or was last not counted
    };
    void updatePresence();
    void identifyReturned();
    void reidentify(ServoRef ref);
    void reidentified(ServoRef ref, const base::Result<device::Servo>& now);
    void replace(ServoRef ref, const jobs::FoundServo& now);
    void suspectReplacement(const Work& ended);

    // closing while servos move (desk_leave.cpp)
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
    void markMoved(const Work& ended);
    void collectOpenWrites(const std::vector<base::Intent>& open, OpenWrites& found);
    void prepareClose();
    void haltMoved(const std::vector<ServoRef>& all);
    void halted(ServoRef ref, bool moved, const std::optional<base::Error>& error);
    void closeLocks(const std::vector<ServoRef>& all);
    void closeStepEnded();
    void finishPendingClose();
    void closeNow();
    void emitEvent(Event event);

    // search (desk_search.cpp)
    void startSearch();
    void runSearch(Search& search);
    ServoRef add(const jobs::FoundServo& one);
    void insertServo(ServoEntry added);
    bool sortsBefore(ServoRef a, ServoRef b) const;
    void remove(ServoRef ref);
    void servoFound(const jobs::FoundServo& one);
    void updateFound(ServoEntry& known, const jobs::FoundServo& one);
    void searchEnded(const base::Result<jobs::ScanReport>& result, const QString& otherPrograms);
    void removeSilent(const jobs::ScanReport& report);
    std::vector<jobs::ExpectedServo> expectedServos() const;
    std::vector<int> missingServos(const jobs::ScanReport& report) const;

    // tasks (desk_tasks.cpp, desk_read.cpp)
    void enqueue(std::shared_ptr<Work> work);
    bool canRun(const Work& work) const;
    void startNext();
    std::optional<base::Error> copyServos(Work& work) const;
    base::Result<void> prepare(const device::Context& context, Work& work);
    void runWork(Work& work);
    void tryWork(Work& work);
    void workEnded(const std::shared_ptr<Work>& work);
    void clearQueue(base::ErrorCode why, bool finishWrites = false);
    void cancelWork(Work& work, base::Error why);
    ServoEntry* entry(ServoRef ref);
    void merge(ServoEntry& into, const device::Servo& from, base::Duration since);
    void sortOrder();
    void changed(const ServoEntry& entry);
    void tableRead(const Work& ended);

    // writes (desk_writes.cpp)
    enum class WriteKind : std::uint8_t { New, Undo, Redo };
    /// `expected`: of a way back, what its registers must still hold.
    void enqueueWrite(ServoRef ref, const WriteRequest& request, WriteKind kind,
                      const std::vector<device::WriteItem>& expected = {});
    void markWritesPending(ServoEntry& known, const WriteRequest& request);
    void writeEnded(const Work& ended, const WriteRequest& request, WriteKind kind,
                    const std::optional<device::WriteReport>& report);
    void markWrites(const ServoEntry& about, const Work& ended, const WriteRequest& request,
                    const std::optional<device::WriteReport>& report);
    void recordUndo(const Work& ended, const WriteRequest& request, WriteKind kind,
                    const std::optional<device::WriteReport>& report);

    // snapshots (desk_restore.cpp)
    struct PendingApply;
    base::Result<void> runApply(const std::shared_ptr<PendingApply>& apply, TaskContext& task);
    void takeApplied(PendingApply& apply, const jobs::ApplyResult& one);
    void tableSaved(int id, const QString& path);

    // interrupted writes (desk_intents.cpp)
    void recoverIntents(jobs::RecoveryAction action, const QString& uuid, bool anyPort);
    ServoRef findEntry(const jobs::OpenIntent& found) const;
    void removeFormerEntry(const base::ServoIdentity& left, ServoRef now);
    void updateRecovered(const jobs::RecoveryResult& one);
    void mergeRecoveredUndo(const jobs::RecoveryResult& one);

    // feed (desk_feed.cpp)
    bool canPoll() const;
    std::vector<const ServoEntry*> pollableServos() const;
    void updatePolling();
    void collectReadings();
    void markAlarms(ServoEntry& entry);
    void mark(record::MarkKind kind, const ServoEntry* about, const QString& text);

    // emergency stop (desk_stop.cpp)
    struct StopVerification;
    void verifyStop();
    void verifyStop(ServoRef ref, const std::shared_ptr<StopVerification>& check);
    void addVerdict(ServoRef ref, StopVerification& check, const jobs::StopCheckResult& verdict,
                    const std::optional<base::Error>& error);
    void reportUnconfirmed();
    /// Names the servos that are held.
    std::optional<base::Error> stopRefusal(const Work& work) const;
    void releaseAfterStop(const Work& ended);
    void storeHere(ServoRef ref);

    Session& m_session;
    MainThreadQueue m_mainQueue;
    LinkState m_state = LinkState::Off;
    PortRequest m_request;
    std::optional<PortRequest> m_nextRequest; ///< connect when the present one is closed
    bool m_opening = false; ///< the opening of a port has not ended, wanted or not
    bool m_closing = false;
    std::optional<PendingClose> m_pendingClose; ///< the port closes when these have been stopped
    bool m_stopNotSent = false;                 ///< an emergency stop found no port
    std::weak_ptr<StopVerification> m_stopVerification; ///< of the latest emergency stop
    QTimer m_stopUnconfirmed;                           ///< when that has taken too long
    QString m_portName; ///< as the journal has it; of the latest port
    std::unique_ptr<Connection> m_connection;
    QTimer m_linkTimer;
    std::map<int, ReplyCounters> m_replyCounters; ///< by ID, when the bus was looked at last

    std::map<ServoRef, ServoEntry> m_servos;
    std::vector<ServoRef> m_order; ///< as shown: by ID, then protocol and rate
    ServoRef m_lastRef = 0;

    std::unique_ptr<Search> m_search;
    std::optional<jobs::ScanSpec> m_nextSearch; ///< begins when the present one has stopped
    std::optional<jobs::ScanReport> m_lastSearch;
    jobs::ScanSpec m_lastSpec;
    QString m_otherPrograms;
    std::optional<int> m_expectedId;
    std::set<ServoRef> m_identifying; ///< on the search thread
    bool m_checkAfterSearch = false;  ///< of an emergency stop
    bool m_intentsChecked = false;

    std::deque<std::shared_ptr<Work>> m_queue;
    std::shared_ptr<Work> m_running;

    std::vector<UndoStep> m_undo;
    std::vector<UndoStep> m_redo;
    std::optional<UndoStep> m_pendingStep; ///< the step an undo or redo is writing now

    PollingService m_polling;
    QTimer m_pollTimer;

    // Last: their jobs use everything above, so they end first.
    std::unique_ptr<JobThread> m_openThread;
    std::unique_ptr<JobThread> m_searchThread;
    std::unique_ptr<JobThread> m_taskThread;
};
} // namespace session
