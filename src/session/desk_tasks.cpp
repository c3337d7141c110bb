// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/alarms.h"
#include "session/desk_work.h"
#include "session/snapshot/safety_snapshot.h"

#include <algorithm>

namespace session {
namespace {
/// What restarts the servo or moves its zero.
bool resetsTurns(const QString& task)
{
    return task == QLatin1StringView("reboot") || task == QLatin1StringView("center") ||
           task == QLatin1StringView("restore-defaults");
}

/// What everybody beside a test may read; see Task::isLongRunning.
constexpr base::Duration testPollPeriod = std::chrono::seconds(1);

/// When the newest of its values was read.
std::optional<base::Duration> latestReadAt(const device::Servo& servo)
{
    std::optional<base::Duration> newest;
    if (!servo.profile)
        return newest;
    for (const catalog::Register& reg : servo.profile->registers) {
        const auto at = servo.image.readAt(reg.offset);
        if (at && (!newest || *at > *newest))
            newest = at;
    }
    return newest;
}
} // namespace

bool Desk::isBusy() const
{
    return m_running || !m_queue.empty();
}

bool Desk::isTesting() const
{
    return m_running && m_running->task.isLongRunning;
}

std::optional<bool> Desk::testHoldsTorque() const
{
    return isTesting() ? m_running->task.holdsTorqueAfterwards : std::nullopt;
}

void Desk::stopTask()
{
    if (m_running)
        m_running->stop.request();
    clearQueue(base::ErrorCode::Stopped);
}

void Desk::stopTest()
{
    if (isTesting())
        m_running->stop.request();
}

void Desk::perform(ServoRef ref, Task task)
{
    const auto work = std::make_shared<Work>();
    work->ref = ref;
    work->task = std::move(task);
    enqueue(work);
}

void Desk::enqueue(std::shared_ptr<Work> work)
{
    const bool open = m_state == LinkState::Open;
    const bool servoGone = work->ref != 0 && servo(work->ref) == nullptr;
    if (!open || servoGone) {
        cancelWork(*work, {open ? base::ErrorCode::NoReply : base::ErrorCode::LinkLost});
        return;
    }
    if (m_pendingClose && !work->readOnly) {
        cancelWork(*work, {base::ErrorCode::Stopped});
        return;
    }
    if (const auto refusal = stopRefusal(*work)) {
        cancelWork(*work, *refusal);
        return;
    }
    // Behind one that waits for its turn it would come hours later, when nobody thinks of it.
    const bool test =
        isTesting() || std::any_of(m_queue.begin(), m_queue.end(),
                                   [](const auto& one) { return one->task.isLongRunning; });
    if (test && !work->readOnly) {
        cancelWork(*work, {base::ErrorCode::Held, {}, QStringLiteral("test")});
        return;
    }
    work->epoch = m_connection->bus().emergencyCount();
    m_queue.push_back(std::move(work));
    Q_EMIT taskChanged();
    scheduleNext();
}

/// Beside a search only what reads, and only at the rate the search uses.
bool Desk::canRun(const Work& work) const
{
    if (!m_search)
        return true;
    const ServoEntry* known = servo(work.ref);
    return m_search->started && m_search->keepsBaud && work.readOnly && known != nullptr &&
           (!canSetBaud() || known->servo.baud == baud());
}

void Desk::startNext()
{
    const bool usable = m_state == LinkState::Open || m_state == LinkState::Closing;
    if (m_running || m_queue.empty() || !usable || !m_connection || !canRun(*m_queue.front()))
        return;
    m_running = m_queue.front();
    m_queue.pop_front();
    if (const auto why = copyServos(*m_running)) {
        const auto orphan = std::exchange(m_running, nullptr);
        cancelWork(*orphan, *why);
        Q_EMIT taskChanged();
        startNext();
        return;
    }
    m_running->startedAt = now();
    if (m_running->task.effect != Effect::None) {
        for (const ServoRef ref : m_running->refs())
            m_servos.at(ref).movedByProgram = true;
    }
    if (m_running->task.isLongRunning)
        emitEvent(
            {.kind = Event::Kind::Started, .servo = m_running->ref, .task = m_running->task.name});
    const bool elsewhere =
        m_running->ref == 0 || (canSetBaud() && m_running->own.servo.baud != baud());
    m_running->changesRate = m_running->changesRate || elsewhere;
    m_polling.limitRate(m_running->task.isLongRunning ? testPollPeriod : base::Duration{});
    updatePolling();
    m_taskThread->start([this, work = m_running] {
        runWork(*work);
        m_mainQueue.post([this, work] { workEnded(work); });
    });
    Q_EMIT taskChanged();
}

/// Why the work cannot begin; nothing if its servos are there, as copies.
std::optional<base::Error> Desk::copyServos(Work& work) const
{
    if (work.ref == 0)
        return std::nullopt;
    std::vector<Work::Part> parts;
    for (const ServoRef ref : work.refs()) {
        const ServoEntry* known = servo(ref);
        if (known == nullptr)
            return base::Error{base::ErrorCode::NoReply};
        if (!parts.empty() && known->servo.baud != parts.front().servo.baud && canSetBaud())
            return base::Error{base::ErrorCode::NotSupported, {}, QStringLiteral("other-rates")};
        parts.push_back({ref, known->servo, !known->snapshotPath.isEmpty()});
    }
    work.own = std::move(parts.front());
    work.others.assign(std::make_move_iterator(parts.begin() + 1),
                       std::make_move_iterator(parts.end()));
    return std::nullopt;
}

/// On the task thread: the rate of its servos, and their tables saved.
base::Result<void> Desk::prepare(const device::Context& context, Work& work)
{
    bus::Bus& bus = context.bus;
    if (work.ref != 0 && bus.canSetBaud() && bus.baud() != work.own.servo.baud) {
        if (const auto set = bus.setBaud(work.own.servo.baud); !set)
            return set;
    }
    if (!work.task.savesTable)
        return {};
    const auto save = [&](Work::Part& part) -> base::Result<void> {
        if (part.tableSaved)
            return {};
        return saveSafetySnapshot(context, part.servo).map([&](const QString& path) {
            part.savedPath = path;
        });
    };
    auto saved = save(work.own);
    for (std::size_t i = 0; saved && i < work.others.size(); ++i)
        saved = save(work.others[i]);
    return saved;
}

namespace {
/// A table saved before a write that was refused has nothing to be compared with.
void removeUnused(QString& savedPath)
{
    if (savedPath.isEmpty())
        return;
    removeSafetySnapshot(savedPath);
    savedPath.clear();
}
} // namespace

/// On the task thread.
void Desk::runWork(Work& work)
{
    const std::uint64_t intentCount = m_session.journal().intentCount();
    tryWork(work);
    m_session.journal().release(); // one piece of work at a time writes
    if (!work.error || m_session.journal().intentCount() != intentCount)
        return;
    removeUnused(work.own.savedPath);
    for (Work::Part& other : work.others)
        removeUnused(other.savedPath);
}

/// On the task thread.
void Desk::tryWork(Work& work)
{
    device::Context context = m_connection->context(work.stop, work.notices);
    context.priority = bus::Priority::Interactive;
    context.epoch = work.epoch;
    if (const auto ready = prepare(context, work); !ready) {
        work.error = ready.error();
        return;
    }
    if (work.stop.isRequested()) {
        work.error = base::Error{base::ErrorCode::Stopped, work.task.name, {}, work.own.servo.id};
        return;
    }
    TaskContext task{context, work.own.servo, work.stop, [this](const jobs::Progress& progress) {
                         m_mainQueue.post([this, progress] { Q_EMIT taskProgress(progress); });
                     }};
    for (Work::Part& other : work.others)
        task.otherServos.push_back(&other.servo);
    if (const auto done = work.task.work(task); !done)
        work.error = done.error();
}

void Desk::workEnded(const std::shared_ptr<Work>& work)
{
    m_running.reset();
    m_polling.limitRate({});
    if (work->ref != 0)
        work->partEnded(*this, work->own);
    for (const Work::Part& other : work->others)
        work->partEnded(*this, other);
    releaseAfterStop(*work);
    markMoved(*work);
    if (work->onMerged)
        work->onMerged(*work);
    suspectReplacement(*work);
    const bool onlyMoves =
        work->task.effect == Effect::Moves && !work->task.savesTable && !work->task.isLongRunning;
    for (const ServoRef ref : work->refs()) {
        if (const ServoEntry* known = servo(ref))
            changed(*known);
        if (!work->readOnly && !onlyMoves)
            loadHistory(ref);
    }
    if (work->task.isLongRunning) {
        emitEvent({.kind = Event::Kind::Finished,
                   .servo = work->ref,
                   .task = work->task.name,
                   .error = work->error});
    }
    if (!work->task.quiet) {
        emitEvent({.kind = Event::Kind::Task,
                   .servo = work->ref,
                   .task = work->task.name,
                   .error = work->error,
                   .notices = work->notices});
    }
    if (work->task.done && work->task.guard)
        work->task.done({work->error, work->notices});
    identifyReturned();
    Q_EMIT taskChanged();
    scheduleNext();
}

std::vector<ServoRef> Desk::Work::refs() const
{
    std::vector<ServoRef> all;
    if (ref != 0)
        all.push_back(ref);
    all.insert(all.end(), task.otherServos.begin(), task.otherServos.end());
    return all;
}

void Desk::Work::partEnded(Desk& desk, const Part& part) const
{
    ServoEntry* known = desk.entry(part.ref);
    if (known == nullptr)
        return;
    const bool blamed = error && (error->id == part.servo.id || (error->id < 0 && part.ref == ref));
    const bool garbage = error && error->code == base::ErrorCode::Garbled;
    const auto heard = latestReadAt(part.servo);
    if (heard)
        known->lastSeen = std::max(known->lastSeen, *heard);
    if (blamed && (error->code == base::ErrorCode::NoReply || garbage)) {
        known->silent = true;
        known->garbled = garbage;
    } else if ((!error && task.otherServos.empty()) || (heard && *heard >= startedAt)) {
        known->answeredAgain = known->silent;
    }
    if (!part.savedPath.isEmpty()) {
        known->snapshotPath = part.savedPath;
        desk.emitEvent(
            {.kind = Event::Kind::TableSaved, .servo = part.ref, .path = part.savedPath});
    }
    if (resetsTurns(task.name))
        known->turns.reset();
    desk.merge(*known, part.servo, startedAt);
}

/// It never ran: said at once, but not from within the call that asked for it.
void Desk::cancelWork(Work& work, base::Error why)
{
    why.operation = work.task.name;
    work.error = std::move(why);
    const ServoEntry* known = servo(work.ref);
    if (known != nullptr && work.error->id < 0)
        work.error->id = known->servo.id;
    m_mainQueue.post([this, merged = work.onMerged, done = work.task.done, guard = work.task.guard,
                      error = work.error, ref = work.ref] {
        Work ended;
        ended.ref = ref;
        ended.error = error;
        if (merged)
            merged(ended);
        if (done && guard)
            done({error, {}});
    });
}

void Desk::clearQueue(base::ErrorCode why, bool finishWrites)
{
    std::deque<std::shared_ptr<Work>> waiting;
    waiting.swap(m_queue);
    for (const auto& work : waiting) {
        if (finishWrites && work->completesBeforeClose)
            m_queue.push_back(work);
        else
            cancelWork(*work, {why});
    }
    Q_EMIT taskChanged();
}

/// What the job has read, and beside it what live reading has brought since the job began.
void Desk::merge(ServoEntry& into, const device::Servo& from, base::Duration since)
{
    if (!isSameKind(into.servo, from)) { // what was read is another servo's
        into.silent = into.answeredAgain = true;
        return;
    }
    device::Image image = from.image;
    image.mergeNewer(into.servo.image, since);
    const bool moved = into.servo.id != from.id || into.servo.baud != from.baud;
    const std::uint8_t read = into.servo.status;
    into.servo = from;
    if (into.statusAt >= since) // read beside the job: newer than what the job found at its start
        into.servo.status = read;
    into.servo.image = std::move(image);
    into.firstImage.mergeMissing(into.servo.image);
    if (into.servo.profile)
        into.turns.on(device::turnBasis(into.servo));
    markAlarms(into);
    if (m_connection && moved)
        m_connection->addStopTarget(into.servo);
    if (moved) {
        const ServoEntry* entered = &into;
        sortOrder();
        Q_EMIT servoChanged(entered->ref);
    }
}

void Desk::sortOrder()
{
    std::sort(m_order.begin(), m_order.end(),
              [this](ServoRef a, ServoRef b) { return sortsBefore(a, b); });
    Q_EMIT orderChanged();
}

void Desk::changed(const ServoEntry& entry)
{
    const ServoRef ref = entry.ref; // who hears of it may change the list
    Q_EMIT servoChanged(ref);
    Q_EMIT tableChanged(ref);
}
} // namespace session
