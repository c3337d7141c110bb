// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tasks/close_sequence.h"

#include "device/motion/motion.h"
#include "device/write_access.h"
#include "device/writer.h"
#include "jobs/motion_check.h"
#include "session/polling/max_reading_age.h"
#include "session/workbench.h"

#include <algorithm>

namespace session {
using jobs::Motion;

namespace {
MovingServo toMovingServo(ServoRef ref, Motion motion)
{
    return {ref, motion == Motion::Endless};
}

/// A servo that is stopped before the port closes, on the job thread.
struct HaltState {
    bool moved = false;
    catalog::ProfilePtr profile; ///< of the command
    device::HaltCommand command;
    std::optional<base::Error> error;

    void begin(TaskContext& task)
    {
        const Motion known = jobs::lastKnownMotion(task.servo);
        const auto now = jobs::readMotion(task.device, task.servo);
        moved = now.value_or(known) != Motion::Rest;
        if (!moved)
            return;
        profile = task.servo.profile;
        const auto commanded =
            now ? device::commandHalt(task.device, task.servo) : tl::unexpected(now.error());
        if (commanded)
            command = *commanded;
        else
            error = commanded.error();
    }
    base::Result<void> end(TaskContext& task) const
    {
        if (error)
            return tl::unexpected(*error);
        return moved ? device::confirmHalt(task.device, task.servo, command) : base::Result<void>{};
    }
};

/// For a question that must not wait.
constexpr auto journalTimeout = std::chrono::seconds(3);
/// Its flag may not be up yet when the goal has just been sent.
constexpr base::Duration movingFlagDelay = std::chrono::milliseconds(200);
/// The longest time that an LX servo, which has no flag, takes.
constexpr base::Duration maxMoveDuration = std::chrono::seconds(30);

bool canBeMoving(const ServoEntry& known, base::Duration now)
{
    const device::Servo& servo = known.servo;
    if (!servo.profile)
        return false;
    const auto readSince = [&](catalog::Role role, base::Duration instant) {
        const catalog::Register* reg = servo.profile->byRole(role);
        const auto at = reg != nullptr ? servo.image.readAt(reg->offset) : std::nullopt;
        return at && *at >= instant;
    };
    if (servo.raw(catalog::Role::TorqueSwitch) == 0 &&
        readSince(catalog::Role::TorqueSwitch, known.movedAt))
        return false;
    if (jobs::lastKnownMotion(servo) != Motion::Rest || jobs::isJammed(servo, true))
        return true;
    if (servo.profile->byRole(catalog::Role::Moving) == nullptr)
        return now - known.movedAt < maxMoveDuration;
    return !readSince(catalog::Role::Moving, known.movedAt + movingFlagDelay);
}

/// By another program, or by this one before it was started anew. What ends by itself counts only
/// while it is seen.
bool isSeenMoving(const ServoEntry& known, base::Duration now)
{
    const device::Servo& servo = known.servo;
    if (!servo.profile)
        return false;
    const Motion motion = jobs::lastKnownMotion(servo);
    if (motion == Motion::Endless)
        return true;
    const auto isCurrent = [&](catalog::Role role) {
        const catalog::Register* reg = servo.profile->byRole(role);
        const auto at = reg != nullptr ? servo.image.readAt(reg->offset) : std::nullopt;
        return at && now - *at <= maxReadingAge;
    };
    // Of a servo that is not chosen only the feedback is read.
    if (!isCurrent(catalog::Role::TorqueSwitch) && isCurrent(catalog::Role::Moving) &&
        jobs::isTurning(servo))
        return true;
    return isCurrent(catalog::Role::PresentPosition) &&
           (motion != Motion::Rest || jobs::isJammed(servo, false));
}
} // namespace

CloseSequence::CloseSequence(Workbench& bench)
    : m_bench(bench)
{}

/// Not from within the call that asked for it: a window being closed cannot be closed.
void CloseSequence::tellClosed()
{
    QMetaObject::invokeMethod(this, &CloseSequence::closed, Qt::QueuedConnection);
}

void CloseSequence::disconnectFrom(MotionOnClose moving, LockOnClose lock)
{
    if (m_bench.link().state() == LinkState::Off && !m_bench.link().connection()) {
        m_bench.link().dropNextRequest();
        return;
    }
    if (m_pendingClose) { // asked for again while servos are being stopped
        if (moving == MotionOnClose::LeaveMoving)
            closeNow();
        return;
    }
    m_pendingClose = PendingClose{moving, lock};
    prepareClose();
}

void CloseSequence::closeNow()
{
    if (m_bench.link().state() == LinkState::Lost && !m_bench.link().connection() &&
        !m_bench.link().isOpening()) {
        m_pendingClose.reset();
        m_bench.link().setState(LinkState::Off);
        if (m_closing)
            tellClosed();
        return;
    }
    m_bench.tasks().clearQueue(base::ErrorCode::Stopped, true);
    m_bench.search().stop();
    m_bench.tasks().stopTest(); // hours may be left of it
    m_bench.link().setState(LinkState::Closing);
    m_bench.scheduleNext();
}

void CloseSequence::closeForExit(MotionOnClose moving, LockOnClose lock)
{
    m_closing = true;
    m_bench.link().dropNextRequest();
    const bool idle = m_bench.link().state() == LinkState::Off && !m_bench.link().connection() &&
                      !m_bench.link().isOpening();
    disconnectFrom(moving, lock);
    if (idle)
        tellClosed();
}

void CloseSequence::finishClosing()
{
    const PendingClose left = std::exchange(m_pendingClose, std::nullopt).value_or(PendingClose{});
    m_bench.link().setState(LinkState::Off);
    m_bench.emitEvent({.kind = Event::Kind::Disconnected,
                       .task = m_bench.link().lastRequest().name,
                       .halted = left.halted,
                       .moving = left.moving,
                       .locked = left.locked,
                       .unlocked = left.unlocked});
    if (m_closing) {
        tellClosed();
    } else {
        m_bench.link().connectToNext();
    }
}

/// Servos that this program has moved or energised, and not halted since; a lasting test ends its
/// own ones.
std::vector<ServoRef> CloseSequence::servosMovedByProgram() const
{
    std::vector<ServoRef> refs;
    const std::vector<ServoRef> tested =
        m_bench.tasks().isTesting() ? m_bench.tasks().running()->refs() : std::vector<ServoRef>{};
    for (const ServoRef ref : m_bench.registry().order()) {
        const bool ended = std::find(tested.begin(), tested.end(), ref) != tested.end();
        if (m_bench.registry().entries().at(ref).movedByProgram && !ended)
            refs.push_back(ref);
    }
    return refs;
}

bool CloseSequence::isMotionPossible() const
{
    const auto moves = [](const Work& work) { return work.task.effect == Effect::Moves; };
    if (m_bench.tasks().isTesting() || m_bench.tasks().any(moves))
        return true;
    return std::any_of(m_bench.registry().entries().begin(), m_bench.registry().entries().end(),
                       [this](const auto& item) {
                           const ServoEntry& known = item.second;
                           return known.movedByProgram ? canBeMoving(known, m_bench.now())
                                                       : isSeenMoving(known, m_bench.now());
                       });
}

/// What was halted holds where it is, also where its goal register still has the old goal (LX).
/// Halts before the port closes come in two halves and are followed by leave().
void CloseSequence::markMoved(const Work& ended)
{
    const bool halted =
        ended.task.name == QLatin1StringView("halt") && !ended.completesBeforeClose && !ended.error;
    if (ended.task.effect == Effect::None && !halted)
        return;
    for (const ServoRef ref : ended.refs()) {
        if (ServoEntry* known = m_bench.registry().entry(ref)) {
            known->movedByProgram = !halted;
            known->movedAt = m_bench.now();
        }
    }
}

std::vector<ServoRef> CloseSequence::unlocked() const
{
    std::vector<ServoRef> refs;
    for (const ServoRef ref : m_bench.registry().order()) {
        const ServoEntry& known = m_bench.registry().entries().at(ref);
        if (known.lockOpenedByUs && known.isLockOpen().value_or(true))
            refs.push_back(ref);
    }
    return refs;
}

bool CloseSequence::hasTaskFor(int id) const
{
    return m_bench.tasks().any([this, id](const Work& work) {
        if (work.task.quiet && !work.task.isLongRunning)
            return false;
        if (work.ref == 0) // all servos on the bus
            return true;
        const std::vector<ServoRef> refs = work.refs();
        return std::any_of(refs.begin(), refs.end(), [this, id](ServoRef ref) {
            const ServoEntry* known = m_bench.registry().servo(ref);
            return known != nullptr && known->servo.id == id;
        });
    });
}

/// The journal may have to wait for a slow disk, or for a port that is being closed.
void CloseSequence::findOpenWrites()
{
    const auto found = std::make_shared<std::optional<OpenWrites>>(OpenWrites{});
    const auto answer = [this, found] {
        if (const auto once = std::exchange(*found, std::nullopt))
            Q_EMIT openWritesFound(*once);
    };
    if (m_bench.link().isOpening() || m_bench.link().portName().isEmpty()) {
        m_bench.mainQueue().post(answer);
        return;
    }
    QTimer::singleShot(journalTimeout, this, answer);
    m_bench.backgroundThread().start([this, found, answer] {
        auto open = m_bench.session().journal().open();
        m_bench.mainQueue().post([this, found, answer, open = std::move(open)] {
            if (open && *found)
                collectOpenWrites(*open, **found);
            answer();
        });
    });
}

namespace {
/// What the list says of the lock is older than the write.
bool wasLockReadBefore(const ServoEntry& known, const QDateTime& write, base::Duration now)
{
    const catalog::Register* lock = known.servo.profile->byRole(catalog::Role::Lock);
    const auto at = lock != nullptr ? known.servo.image.readAt(lock->offset) : std::nullopt;
    if (!at)
        return false;
    const auto age = std::chrono::duration_cast<std::chrono::milliseconds>(now - *at);
    return QDateTime::currentDateTimeUtc().addMSecs(-age.count()) < write;
}

/// "1 / 21" while its ID is changed.
QString possibleIds(const base::Intent& intent)
{
    const QString id = QString::number(intent.servo.id);
    if (intent.kind != base::IntentKind::SetId || intent.items.empty())
        return id;
    return QStringLiteral("%1 / %2").arg(id).arg(intent.items.front().newRaw);
}
} // namespace

/// A write that is going on is ended before the port closes, and what a test has set goes back;
/// what a commissioning line has left in a servo that went away stays open.
void CloseSequence::collectOpenWrites(const std::vector<base::Intent>& open, OpenWrites& found)
{
    const bool lasting = m_bench.tasks().running() && m_bench.tasks().running()->task.isLongRunning;
    for (const base::Intent& intent : open) {
        const base::ServoIdentity& identity = intent.servo;
        const bool ended = lasting ? intent.temporary : hasTaskFor(identity.id);
        if (identity.port != m_bench.link().portName() || intent.isActiveElsewhere || ended)
            continue;
        if (std::find(found.ids.begin(), found.ids.end(), identity.id) == found.ids.end())
            found.ids.push_back(identity.id);
        if (!intent.lockOpened)
            continue;
        ServoEntry* known =
            m_bench.registry().entry(m_bench.registry().findServo(identity.protocol, identity.id));
        const bool listed = known != nullptr && known->servo.profile &&
                            known->servo.identity().isSameKind(identity);
        if (listed)
            known->lockOpenedByUs = true;
        const QString ids = possibleIds(intent);
        const bool listedAsOpen = listed && (known->isLockOpen().value_or(true) ||
                                             !wasLockReadBefore(*known, intent.at, m_bench.now()));
        if (!listedAsOpen && !found.unlockedElsewhere.contains(ids))
            found.unlockedElsewhere << ids;
    }
    found.unlocked = unlocked();
}

/// One that cannot be read now is judged by what it said last.
void CloseSequence::detectMotion()
{
    const auto found = std::make_shared<std::vector<MovingServo>>();
    const auto answer = [this, found] { Q_EMIT motionDetected(*found); };
    const std::vector<ServoRef> asked = m_bench.link().state() == LinkState::Open
                                            ? servosMovedByProgram()
                                            : std::vector<ServoRef>{};
    const bool readable = !m_bench.tasks().isTesting() && !m_bench.search().isSearching();
    for (const ServoRef ref : asked) {
        const Motion known = jobs::lastKnownMotion(m_bench.registry().entries().at(ref).servo);
        if (!readable && known != Motion::Rest)
            found->push_back(toMovingServo(ref, known));
    }
    if (asked.empty() || !readable) {
        m_bench.mainQueue().post(answer);
        return;
    }
    const auto open = std::make_shared<std::size_t>(asked.size());
    for (const ServoRef ref : asked) {
        const auto work = std::make_shared<Work>();
        work->ref = ref;
        work->readOnly = true;
        work->task.name = QStringLiteral("motion");
        work->task.quiet = true;
        const auto motion = std::make_shared<std::optional<Motion>>();
        work->task.work = [motion](TaskContext& task) -> base::Result<void> {
            const auto read = jobs::readMotion(task.device, task.servo);
            if (!read)
                return tl::unexpected(read.error());
            *motion = *read;
            return {};
        };
        work->onMerged = [this, ref, motion, open, found, answer](Work&) {
            const ServoEntry* known = m_bench.registry().servo(ref);
            const Motion last =
                known != nullptr ? jobs::lastKnownMotion(known->servo) : Motion::Rest;
            if (const Motion now = motion->value_or(last); now != Motion::Rest)
                found->push_back(toMovingServo(ref, now));
            if (--*open == 0)
                answer();
        };
        m_bench.tasks().enqueue(work);
    }
}

void CloseSequence::prepareClose()
{
    const bool open = m_bench.link().state() == LinkState::Open;
    const auto halted = open && m_pendingClose->how != MotionOnClose::LeaveMoving
                            ? servosMovedByProgram()
                            : std::vector<ServoRef>{};
    const auto locked = open && m_pendingClose->lock != LockOnClose::LeaveOpen
                            ? unlocked()
                            : std::vector<ServoRef>{};
    if (halted.empty() && locked.empty()) {
        closeNow();
        return;
    }
    m_bench.tasks().clearQueue(base::ErrorCode::Stopped, true);
    m_bench.search().stop();
    m_bench.tasks().stopTest(); // hours may be left of it
    m_pendingClose->open = halted.size() + locked.size();
    haltMoved(halted);
    closeLocks(locked);
    Q_EMIT m_bench.tasks().taskChanged();
    m_bench.scheduleNext();
}

/// Reads anew, since what moved a moment ago may rest and the other way round. All are commanded
/// before the first one is watched.
void CloseSequence::haltMoved(const std::vector<ServoRef>& all)
{
    const auto queue = [this](ServoRef ref, auto&& work, auto&& merged) {
        const auto halting = std::make_shared<Work>();
        halting->ref = ref;
        halting->task.name = QStringLiteral("halt");
        halting->task.quiet = true;
        halting->task.work = work;
        halting->onMerged = merged;
        m_bench.tasks().enqueueClosing(halting);
    };
    std::map<ServoRef, std::shared_ptr<HaltState>> begun;
    for (const ServoRef ref : all) {
        const auto halting = begun.emplace(ref, std::make_shared<HaltState>()).first->second;
        const auto command = [halting](TaskContext& task) -> base::Result<void> {
            halting->begin(task);
            return {};
        };
        queue(ref, command, nullptr);
    }
    for (const ServoRef ref : all) {
        const auto halting = begun.at(ref);
        const auto confirm = [halting](TaskContext& task) { return halting->end(task); };
        queue(ref, confirm,
              [this, ref, halting](Work& ended) { halted(ref, halting->moved, ended.error); });
    }
}

void CloseSequence::halted(ServoRef ref, bool moved, const std::optional<base::Error>& error)
{
    if (!m_pendingClose)
        return;
    // An emergency stop in between has taken its torque off.
    const bool stopped = error && error->code == base::ErrorCode::Preempted;
    if (moved && !stopped)
        (error ? m_pendingClose->moving : m_pendingClose->halted).push_back(ref);
    closeStepEnded();
}

/// One that another servo may have taken the place of is left alone.
void CloseSequence::closeLocks(const std::vector<ServoRef>& all)
{
    for (const ServoRef ref : all) {
        const auto work = std::make_shared<Work>();
        work->ref = ref;
        work->task.name = QStringLiteral("lock");
        work->task.quiet = true;
        work->task.work = [](TaskContext& task) -> base::Result<void> {
            const auto may = device::beginWriting(task.device, task.servo, QStringLiteral("lock"));
            if (!may)
                return may;
            if (device::closeLock(task.device, task.servo) == device::LockState::Closed)
                return {};
            return base::fail(base::ErrorCode::LockOpen, QStringLiteral("lock"), {}, task.servo.id);
        };
        work->onMerged = [this, ref](Work& ended) {
            if (!m_pendingClose)
                return;
            (ended.error ? m_pendingClose->unlocked : m_pendingClose->locked).push_back(ref);
            closeStepEnded();
        };
        m_bench.tasks().enqueueClosing(work);
    }
}

void CloseSequence::closeStepEnded()
{
    if (--m_pendingClose->open == 0)
        m_bench.mainQueue().post(
            [this] { finishPendingClose(); }); // not from within the end of its own work
}

/// After what moved has been stopped and what was unlocked has been locked, as far as possible.
void CloseSequence::finishPendingClose()
{
    if (!m_pendingClose)
        return;
    const bool moves =
        m_pendingClose->how == MotionOnClose::StopOrKeepOpen && !m_pendingClose->moving.empty();
    const bool unlocked =
        m_pendingClose->lock == LockOnClose::CloseOrKeepOpen && !m_pendingClose->unlocked.empty();
    if ((moves || unlocked) && m_bench.link().state() == LinkState::Open) {
        const PendingClose left = *std::exchange(m_pendingClose, std::nullopt);
        m_closing = false;
        m_bench.link().dropNextRequest();
        m_bench.emitEvent(
            {.kind = Event::Kind::CloseCanceled, .moving = left.moving, .unlocked = left.unlocked});
        Q_EMIT portKeptOpen();
        return;
    }
    closeNow();
}
} // namespace session
