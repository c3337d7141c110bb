// SPDX-License-Identifier: GPL-3.0-or-later
// Before the port closes: servos that this program has set in motion and that would go on without
// it, EPROM locks it has left open, and what its journal still holds.
#include "device/motion.h"
#include "device/write_access.h"
#include "device/writer.h"
#include "jobs/motion_check.h"
#include "session/desk_work.h"
#include "session/reading_age.h"

#include <algorithm>

namespace session {
using jobs::Motion;

namespace {
MovingServo asMoving(ServoRef ref, Motion motion)
{
    return {ref, motion == Motion::Endless};
}

/// A servo that is stopped before the port closes, on the job thread.
struct Halting {
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
constexpr auto journalAnswers = std::chrono::seconds(3);
/// Its flag may not be up yet when the goal has just been sent.
constexpr base::Duration flagRises = std::chrono::milliseconds(200);
/// An LX servo, which has no flag, takes so long at most.
constexpr base::Duration longestMove = std::chrono::seconds(30);

bool mayMove(const ServoEntry& known, base::Duration now)
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
        readSince(catalog::Role::TorqueSwitch, known.drivenAt))
        return false;
    if (jobs::lastKnownMotion(servo) != Motion::Rest || jobs::isJammed(servo, true))
        return true;
    if (servo.profile->byRole(catalog::Role::Moving) == nullptr)
        return now - known.drivenAt < longestMove;
    return !readSince(catalog::Role::Moving, known.drivenAt + flagRises);
}

/// By another program, or by this one before it was started anew. What ends by itself counts only
/// while it is seen.
bool seenMoving(const ServoEntry& known, base::Duration now)
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
        jobs::turns(servo))
        return true;
    return isCurrent(catalog::Role::PresentPosition) &&
           (motion != Motion::Rest || jobs::isJammed(servo, false));
}
} // namespace

/// Servos that this program has moved or energised, and not halted since; a lasting test ends its
/// own ones.
std::vector<ServoRef> Desk::driven() const
{
    std::vector<ServoRef> refs;
    const std::vector<ServoRef> tested = testing() ? m_running->refs() : std::vector<ServoRef>{};
    for (const ServoRef ref : m_order) {
        const bool ended = std::find(tested.begin(), tested.end(), ref) != tested.end();
        if (m_servos.at(ref).driven && !ended)
            refs.push_back(ref);
    }
    return refs;
}

bool Desk::driving() const
{
    const auto moves = [](const std::shared_ptr<Work>& work) {
        return work && work->task.effect == Effect::Moves;
    };
    if (testing() || moves(m_running) || std::any_of(m_queue.begin(), m_queue.end(), moves))
        return true;
    return std::any_of(m_servos.begin(), m_servos.end(), [this](const auto& item) {
        const ServoEntry& known = item.second;
        return known.driven ? mayMove(known, now()) : seenMoving(known, now());
    });
}

/// What was halted holds where it is, also where its goal register still has the old goal (LX).
/// Halts before the port closes come in two halves and are followed by leave().
void Desk::noteDriven(const Work& ended)
{
    const bool halted =
        ended.task.name == QLatin1StringView("halt") && !ended.finishes && !ended.error;
    if (ended.task.effect == Effect::None && !halted)
        return;
    for (const ServoRef ref : ended.refs()) {
        if (ServoEntry* known = entry(ref)) {
            known->driven = !halted;
            known->drivenAt = now();
        }
    }
}

std::vector<ServoRef> Desk::unlocked() const
{
    std::vector<ServoRef> refs;
    for (const ServoRef ref : m_order) {
        const ServoEntry& known = m_servos.at(ref);
        if (known.lockOpenedByUs && known.lockOpen().value_or(true))
            refs.push_back(ref);
    }
    return refs;
}

bool Desk::isWorkedOn(int id) const
{
    const auto concerns = [this, id](const std::shared_ptr<Work>& work) {
        if (!work || (work->task.quiet && !work->task.lasting))
            return false;
        if (work->ref == 0) // whoever is on the bus
            return true;
        const std::vector<ServoRef> refs = work->refs();
        return std::any_of(refs.begin(), refs.end(), [this, id](ServoRef ref) {
            const ServoEntry* known = servo(ref);
            return known != nullptr && known->servo.id == id;
        });
    };
    return concerns(m_running) || std::any_of(m_queue.begin(), m_queue.end(), concerns);
}

/// The journal may have to wait for a slow disk, or for a port that is being closed.
void Desk::findUnfinished()
{
    const auto found = std::make_shared<std::optional<UnfinishedWrites>>(UnfinishedWrites{});
    const auto tell = [this, found] {
        if (const auto once = std::exchange(*found, std::nullopt))
            Q_EMIT unfinishedFound(*once);
    };
    if (m_opening || m_portName.isEmpty()) {
        m_inbox.post(tell);
        return;
    }
    QTimer::singleShot(journalAnswers, this, tell);
    m_openThread->start([this, found, tell] {
        auto open = m_session.journal().open();
        m_inbox.post([this, found, tell, open = std::move(open)] {
            if (open && *found)
                takeUnfinished(*open, **found);
            tell();
        });
    });
}

namespace {
/// What the list says of the lock is older than the write.
bool lockReadBefore(const ServoEntry& known, const QDateTime& write, base::Duration now)
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
void Desk::takeUnfinished(const std::vector<base::Intent>& open, UnfinishedWrites& found)
{
    const bool lasting = m_running && m_running->task.lasting;
    for (const base::Intent& intent : open) {
        const base::ServoIdentity& who = intent.servo;
        const bool ended = lasting ? intent.temporary : isWorkedOn(who.id);
        if (who.port != m_portName || intent.underWayElsewhere || ended)
            continue;
        if (std::find(found.ids.begin(), found.ids.end(), who.id) == found.ids.end())
            found.ids.push_back(who.id);
        if (!intent.lockOpened)
            continue;
        ServoEntry* known = entry(find(who.protocol, who.id));
        const bool listed =
            known != nullptr && known->servo.profile && known->servo.identity().sameKind(who);
        if (listed)
            known->lockOpenedByUs = true;
        const QString ids = possibleIds(intent);
        const bool said = listed && (known->lockOpen().value_or(true) ||
                                     !lockReadBefore(*known, intent.at, now()));
        if (!said && !found.openElsewhere.contains(ids))
            found.openElsewhere << ids;
    }
    found.unlocked = unlocked();
}

/// One that cannot be read now is judged by what it said last.
void Desk::findMotion()
{
    const auto found = std::make_shared<std::vector<MovingServo>>();
    const auto tell = [this, found] { Q_EMIT motionFound(*found); };
    const std::vector<ServoRef> asked =
        m_state == LinkState::Open ? driven() : std::vector<ServoRef>{};
    const bool readable = !testing() && !m_search;
    for (const ServoRef ref : asked) {
        const Motion known = jobs::lastKnownMotion(m_servos.at(ref).servo);
        if (!readable && known != Motion::Rest)
            found->push_back(asMoving(ref, known));
    }
    if (asked.empty() || !readable) {
        m_inbox.post(tell);
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
        work->merged = [this, ref, motion, open, found, tell](Work&) {
            const ServoEntry* known = servo(ref);
            const Motion last =
                known != nullptr ? jobs::lastKnownMotion(known->servo) : Motion::Rest;
            if (const Motion now = motion->value_or(last); now != Motion::Rest)
                found->push_back(asMoving(ref, now));
            if (--*open == 0)
                tell();
        };
        enqueue(work);
    }
}

void Desk::makeSafe()
{
    const bool open = m_state == LinkState::Open;
    const auto halted =
        open && m_leaving->how != AtClose::LeaveMoving ? driven() : std::vector<ServoRef>{};
    const auto locked =
        open && m_leaving->lock != LockAtClose::LeaveOpen ? unlocked() : std::vector<ServoRef>{};
    if (halted.empty() && locked.empty()) {
        closeNow();
        return;
    }
    dropQueue(base::ErrorCode::Stopped, true);
    stopSearch();
    stopTest(); // hours may be left of it
    m_leaving->open = halted.size() + locked.size();
    haltDriven(halted);
    closeLocks(locked);
    Q_EMIT taskChanged();
    goOn();
}

/// Reads anew, since what moved a moment ago may rest and the other way round. All are commanded
/// before the first one is watched.
void Desk::haltDriven(const std::vector<ServoRef>& all)
{
    const auto queue = [this](ServoRef ref, auto&& work, auto&& merged) {
        const auto halting = std::make_shared<Work>();
        halting->ref = ref;
        halting->finishes = true;
        halting->task.name = QStringLiteral("halt");
        halting->task.quiet = true;
        halting->epoch = m_connection->bus().emergencies();
        halting->task.work = work;
        halting->merged = merged;
        m_queue.push_back(halting);
    };
    std::map<ServoRef, std::shared_ptr<Halting>> begun;
    for (const ServoRef ref : all) {
        const auto halting = begun.emplace(ref, std::make_shared<Halting>()).first->second;
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

void Desk::halted(ServoRef ref, bool moved, const std::optional<base::Error>& error)
{
    if (!m_leaving)
        return;
    // An emergency stop in between has taken its torque off.
    const bool stopped = error && error->code == base::ErrorCode::Preempted;
    if (moved && !stopped)
        (error ? m_leaving->moving : m_leaving->halted).push_back(ref);
    madeSafe();
}

/// One that another servo may have taken the place of is left alone.
void Desk::closeLocks(const std::vector<ServoRef>& all)
{
    for (const ServoRef ref : all) {
        const auto work = std::make_shared<Work>();
        work->ref = ref;
        work->finishes = true;
        work->task.name = QStringLiteral("lock");
        work->task.quiet = true;
        work->epoch = m_connection->bus().emergencies();
        work->task.work = [](TaskContext& task) -> base::Result<void> {
            const auto may = device::beginWriting(task.device, task.servo, QStringLiteral("lock"));
            if (!may)
                return may;
            if (device::closeLock(task.device, task.servo) == device::LockState::Closed)
                return {};
            return base::fail(base::ErrorCode::LockOpen, QStringLiteral("lock"), {}, task.servo.id);
        };
        work->merged = [this, ref](Work& ended) {
            if (!m_leaving)
                return;
            (ended.error ? m_leaving->unlocked : m_leaving->locked).push_back(ref);
            madeSafe();
        };
        m_queue.push_back(work);
    }
}

void Desk::madeSafe()
{
    if (--m_leaving->open == 0)
        m_inbox.post([this] { leave(); }); // not from within the end of its own work
}

/// After what moved has been stopped and what was unlocked has been locked, as far as possible.
void Desk::leave()
{
    if (!m_leaving)
        return;
    const bool moves = m_leaving->how == AtClose::StopOrStay && !m_leaving->moving.empty();
    const bool unlocked =
        m_leaving->lock == LockAtClose::CloseOrStay && !m_leaving->unlocked.empty();
    if ((moves || unlocked) && m_state == LinkState::Open) {
        const Leaving left = *std::exchange(m_leaving, std::nullopt);
        m_closing = false;
        m_nextRequest.reset();
        tell({.kind = Event::Kind::NotLeft, .moving = left.moving, .unlocked = left.unlocked});
        Q_EMIT stayedOpen();
        return;
    }
    closeNow();
}
} // namespace session
