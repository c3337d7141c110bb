// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tasks/task_queue.h"

#include "device/alarms.h"
#include "session/snapshot/safety_snapshot.h"
#include "session/workbench.h"

#include <algorithm>

namespace session {
namespace {
/// What restarts the servo or moves its zero.
bool resetsTurns(const QString& task)
{
    return task == QLatin1StringView("reboot") || task == QLatin1StringView("center") ||
           task == QLatin1StringView("restore-defaults") ||
           task == QLatin1StringView("update-firmware");
}

/// What may be read during a test; see Task::isLongRunning.
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

TaskQueue::TaskQueue(Workbench& bench)
    : m_bench(bench)
{}

void TaskQueue::requestStop()
{
    if (m_running)
        m_running->stop.request();
}

bool TaskQueue::any(const std::function<bool(const Work&)>& matches) const
{
    return (m_running && matches(*m_running)) ||
           std::any_of(m_queue.begin(), m_queue.end(),
                       [&](const std::shared_ptr<Work>& work) { return matches(*work); });
}

void TaskQueue::enqueueClosing(std::shared_ptr<Work> work)
{
    work->completesBeforeClose = true;
    work->epoch = m_bench.link().connection()->bus().emergencyCount();
    m_queue.push_back(std::move(work));
}

bool TaskQueue::isBusy() const
{
    return m_running || !m_queue.empty();
}

bool TaskQueue::isTesting() const
{
    return m_running && m_running->task.isLongRunning;
}

std::optional<bool> TaskQueue::testHoldsTorque() const
{
    return isTesting() ? m_running->task.holdsTorqueAfterwards : std::nullopt;
}

QString TaskQueue::runningName() const
{
    return m_running ? m_running->task.name : QString();
}

void TaskQueue::stop()
{
    if (m_running)
        m_running->stop.request();
    clearQueue(base::ErrorCode::Stopped);
}

void TaskQueue::stopTest()
{
    if (isTesting())
        m_running->stop.request();
}

void TaskQueue::perform(ServoRef ref, Task task)
{
    const auto work = std::make_shared<Work>();
    work->ref = ref;
    work->task = std::move(task);
    enqueue(work);
}

void TaskQueue::enqueue(std::shared_ptr<Work> work)
{
    const bool open = m_bench.link().state() == LinkState::Open;
    const bool servoGone = work->ref != 0 && m_bench.registry().servo(work->ref) == nullptr;
    if (!open || servoGone) {
        cancelWork(*work, {open ? base::ErrorCode::NoReply : base::ErrorCode::LinkLost});
        return;
    }
    if (m_bench.closing().isPending() && !work->readOnly) {
        cancelWork(*work, {base::ErrorCode::Stopped});
        return;
    }
    if (const auto refusal = m_bench.emergencyStop().refusal(*work)) {
        cancelWork(*work, *refusal);
        return;
    }
    // Behind one that waits for its turn it would come hours later, unexpectedly.
    const bool test =
        isTesting() || std::any_of(m_queue.begin(), m_queue.end(),
                                   [](const auto& one) { return one->task.isLongRunning; });
    if (test && !work->readOnly) {
        cancelWork(*work, {base::ErrorCode::Held, {}, QStringLiteral("test")});
        return;
    }
    work->epoch = m_bench.link().connection()->bus().emergencyCount();
    m_queue.push_back(std::move(work));
    Q_EMIT taskChanged();
    m_bench.scheduleNext();
}

/// Beside a search only what reads, and only at the rate the search uses.
bool TaskQueue::canRun(const Work& work) const
{
    const SearchService& search = m_bench.search();
    if (!search.isSearching())
        return true;
    const ServoEntry* known = m_bench.registry().servo(work.ref);
    return search.isStarted() && search.keepsBaud() && work.readOnly && known != nullptr &&
           (!m_bench.link().canSetBaud() || known->servo.baud == m_bench.link().baud());
}

void TaskQueue::startNext()
{
    const bool usable =
        m_bench.link().state() == LinkState::Open || m_bench.link().state() == LinkState::Closing;
    if (m_running || m_queue.empty() || !usable || !m_bench.link().connection() ||
        !canRun(*m_queue.front()))
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
    m_running->startedAt = m_bench.now();
    if (m_running->task.effect != Effect::None) {
        for (const ServoRef ref : m_running->refs())
            m_bench.registry().entry(ref)->movedByProgram = true;
    }
    if (m_running->task.isLongRunning)
        m_bench.emitEvent(
            {.kind = Event::Kind::Started, .servo = m_running->ref, .task = m_running->task.name});
    const bool elsewhere =
        m_running->ref == 0 ||
        (m_bench.link().canSetBaud() && m_running->own.servo.baud != m_bench.link().baud());
    m_running->changesRate = m_running->changesRate || elsewhere;
    m_bench.polling().limitRate(m_running->task.isLongRunning ? testPollPeriod : base::Duration{});
    m_bench.polling().updatePolling();
    m_bench.taskThread().start([this, work = m_running] {
        runWork(*work);
        m_bench.mainQueue().post([this, work] { workEnded(work); });
    });
    Q_EMIT taskChanged();
}

/// Why the work cannot begin; nothing if its servos are there, as copies.
std::optional<base::Error> TaskQueue::copyServos(Work& work) const
{
    if (work.ref == 0)
        return std::nullopt;
    std::vector<Work::Part> parts;
    for (const ServoRef ref : work.refs()) {
        const ServoEntry* known = m_bench.registry().servo(ref);
        if (known == nullptr)
            return base::Error{base::ErrorCode::NoReply};
        if (!parts.empty() && known->servo.baud != parts.front().servo.baud &&
            m_bench.link().canSetBaud())
            return base::Error{base::ErrorCode::NotSupported, {}, QStringLiteral("other-rates")};
        parts.push_back({ref, known->servo, !known->snapshotPath.isEmpty()});
    }
    work.own = std::move(parts.front());
    work.others.assign(std::make_move_iterator(parts.begin() + 1),
                       std::make_move_iterator(parts.end()));
    return std::nullopt;
}

/// On the task thread: the rate of its servos, and their tables saved.
base::Result<void> TaskQueue::prepare(const device::Context& context, Work& work)
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
void TaskQueue::runWork(Work& work)
{
    const std::uint64_t intentCount = m_bench.session().journal().intentCount();
    tryWork(work);
    m_bench.session().journal().release(); // one piece of work at a time writes
    if (!work.error || m_bench.session().journal().intentCount() != intentCount)
        return;
    removeUnused(work.own.savedPath);
    for (Work::Part& other : work.others)
        removeUnused(other.savedPath);
}

/// On the task thread.
void TaskQueue::tryWork(Work& work)
{
    device::Context context = m_bench.link().connection()->context(work.stop, work.notices);
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
    const auto report = [this, &context, left = jobs::TimeLeft()](jobs::Progress progress) mutable {
        progress.remaining = left.estimate(progress, context.bus.clock().now());
        m_bench.mainQueue().post([this, progress] { Q_EMIT taskProgress(progress); });
    };
    TaskContext task{context, work.own.servo, work.stop, report};
    for (Work::Part& other : work.others)
        task.otherServos.push_back(&other.servo);
    if (const auto done = work.task.work(task); !done)
        work.error = done.error();
}

void TaskQueue::workEnded(const std::shared_ptr<Work>& work)
{
    m_running.reset();
    m_bench.polling().limitRate({});
    if (work->ref != 0)
        partEnded(*work, work->own);
    for (const Work::Part& other : work->others)
        partEnded(*work, other);
    m_bench.emergencyStop().release(*work);
    if (work->task.changesPortBaud)
        m_bench.emergencyStop().baudRestored();
    m_bench.closing().markMoved(*work);
    if (work->onMerged)
        work->onMerged(*work);
    m_bench.presence().suspectReplacement(*work);
    const bool onlyMoves =
        work->task.effect == Effect::Moves && !work->task.savesTable && !work->task.isLongRunning;
    for (const ServoRef ref : work->refs()) {
        if (const ServoEntry* known = m_bench.registry().servo(ref))
            m_bench.registry().changed(*known);
        if (!work->readOnly && !onlyMoves)
            m_bench.writes().loadHistory(ref);
    }
    if (work->task.isLongRunning) {
        m_bench.emitEvent({.kind = Event::Kind::Finished,
                           .servo = work->ref,
                           .task = work->task.name,
                           .error = work->error});
    }
    if (!work->task.quiet) {
        m_bench.emitEvent({.kind = Event::Kind::Task,
                           .servo = work->ref,
                           .task = work->task.name,
                           .error = work->error,
                           .notices = work->notices});
    }
    if (work->task.done && work->task.guard)
        work->task.done({work->error, work->notices});
    m_bench.presence().identifyReturned();
    Q_EMIT taskChanged();
    m_bench.scheduleNext();
}

std::vector<ServoRef> Work::refs() const
{
    std::vector<ServoRef> all;
    if (ref != 0)
        all.push_back(ref);
    all.insert(all.end(), task.otherServos.begin(), task.otherServos.end());
    return all;
}

void TaskQueue::partEnded(const Work& work, const Work::Part& part)
{
    ServoEntry* known = m_bench.registry().entry(part.ref);
    if (known == nullptr)
        return;
    const bool blamed = work.error && (work.error->id == part.servo.id ||
                                       (work.error->id < 0 && part.ref == work.ref));
    const bool garbage = work.error && work.error->code == base::ErrorCode::Garbled;
    const auto heard = latestReadAt(part.servo);
    if (heard)
        known->lastSeen = std::max(known->lastSeen, *heard);
    if (blamed && (work.error->code == base::ErrorCode::NoReply || garbage)) {
        known->silent = true;
        known->garbled = garbage;
    } else if ((!work.error && work.task.otherServos.empty()) ||
               (heard && *heard >= work.startedAt)) {
        known->answeredAgain = known->silent;
    }
    if (!part.savedPath.isEmpty()) {
        known->snapshotPath = part.savedPath;
        m_bench.emitEvent(
            {.kind = Event::Kind::TableSaved, .servo = part.ref, .path = part.savedPath});
    }
    if (resetsTurns(work.task.name))
        known->turns.reset();
    if (work.task.changesFirmware && !work.error)
        known->servo.profile = part.servo.profile;
    m_bench.registry().merge(*known, part.servo, work.startedAt);
}

/// It never ran: said at once, but not from within the call that asked for it.
void TaskQueue::cancelWork(Work& work, base::Error why)
{
    why.operation = work.task.name;
    work.error = std::move(why);
    const ServoEntry* known = m_bench.registry().servo(work.ref);
    if (known != nullptr && work.error->id < 0)
        work.error->id = known->servo.id;
    m_bench.mainQueue().post([this, merged = work.onMerged, done = work.task.done,
                              guard = work.task.guard, error = work.error, ref = work.ref] {
        Work ended;
        ended.ref = ref;
        ended.error = error;
        if (merged)
            merged(ended);
        if (done && guard)
            done({error, {}});
    });
}

void TaskQueue::clearQueue(base::ErrorCode why, bool finishWrites)
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
} // namespace session
