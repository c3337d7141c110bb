// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/writes/restore_service.h"

#include "session/snapshot/restore_request.h"
#include "session/snapshot/safety_snapshot.h"
#include "session/workbench.h"

#include <set>

namespace session {
namespace {
std::vector<device::WriteItem> itemsOf(const jobs::RestorePlan& plan)
{
    std::vector<device::WriteItem> items;
    for (const jobs::RestoreWrite& write : jobs::plannedWrites(plan))
        items.push_back({write.key, write.to});
    return items;
}

/// What was rolled back is as it was: nothing to show, nothing to undo.
device::WriteReport reportOf(const jobs::RestoreOutcome& outcome)
{
    device::WriteReport report;
    report.id = outcome.newId;
    report.lock = outcome.lock;
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        if (!row.rolledBack)
            report.writes.push_back(row.write);
    }
    return report;
}

/// Everything is as it was, because of this.
std::optional<base::Error> rolledBackBy(const jobs::RestoreOutcome& outcome)
{
    if (outcome.verdict != jobs::RestoreVerdict::RolledBack)
        return std::nullopt;
    base::Error error{base::ErrorCode::Mismatch, QStringLiteral("restore"), {}, outcome.newId};
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        if (row.write.outcome == device::WriteOutcome::Kept ||
            row.write.outcome == device::WriteOutcome::NotSent)
            continue;
        error.registerKey = row.write.key;
        return row.write.error.value_or(error);
    }
    return error;
}

bool changesAddress(const jobs::RestorePlan& plan)
{
    const auto writes = jobs::plannedWrites(plan);
    return std::any_of(writes.begin(), writes.end(), [](const jobs::RestoreWrite& write) {
        return write.stage == jobs::RestoreStage::Id || write.stage == jobs::RestoreStage::Baud;
    });
}
} // namespace

RestoreService::RestoreService(Workbench& bench)
    : m_bench(bench)
{}

void RestoreService::restore(ServoRef ref, const RestoreRequest& request)
{
    ServoEntry* known = m_bench.registry().entry(ref);
    const WriteRequest writes{itemsOf(request.plan), false, request.consent};
    if (known != nullptr)
        m_bench.writes().markWritesPending(*known, writes);
    const auto outcome = std::make_shared<std::optional<jobs::RestoreOutcome>>();
    const auto work = std::make_shared<Work>();
    work->ref = ref;
    work->task.name = QStringLiteral("restore");
    work->task.savesTable = !writes.items.empty();
    work->task.quiet = true;
    work->changesRate = changesAddress(request.plan);
    work->completesBeforeClose = true;
    work->task.work = [plan = request.plan, consent = request.consent, how = request.onFailure,
                       outcome](TaskContext& task) -> base::Result<void> {
        auto restored =
            jobs::restore(task.device, task.servo, plan, {consent, how, {}}, task.progress);
        if (!restored)
            return tl::unexpected(restored.error());
        *outcome = std::move(*restored);
        return {};
    };
    work->onMerged = [this, writes, outcome, guard = request.guard,
                      done = request.done](Work& ended) {
        if (!writes.items.empty())
            writesEnded(ended, writes, *outcome);
        if (done && guard)
            done({ended.error, *outcome});
    };
    m_bench.tasks().enqueue(work);
}

void RestoreService::writesEnded(const Work& ended, const WriteRequest& writes,
                                 const std::optional<jobs::RestoreOutcome>& outcome)
{
    Work told;
    told.ref = ended.ref;
    told.notices = ended.notices;
    told.error = ended.error;
    if (outcome && !told.error)
        told.error = rolledBackBy(*outcome);
    const auto report = outcome && !told.error ? std::optional(reportOf(*outcome)) : std::nullopt;
    m_bench.writes().writeEnded(told, writes, WriteService::WriteKind::New, report);
}

/// Filled on the job's thread, looked at on the main thread as it grows and when it has ended.
struct RestoreService::PendingApply {
    ApplyRequest request;
    std::set<int> saved;                    ///< IDs whose table this session has saved
    std::map<int, QString> savedPaths;      ///< now
    std::vector<jobs::ApplyResult> applied; ///< main thread
};

/// On the job's thread.
base::Result<void> RestoreService::runApply(const std::shared_ptr<PendingApply>& apply,
                                            TaskContext& task)
{
    jobs::ApplyOptions options = apply->request.options;
    options.restore.beforeWrite = [apply](const device::Context& context,
                                          device::Servo& servo) -> base::Result<void> {
        if (apply->saved.count(servo.id) > 0)
            return {};
        return saveSafetySnapshot(context, servo).map([&](const QString& path) {
            apply->savedPaths[servo.id] = path;
        });
    };
    const auto onServo = [this, apply](const jobs::ApplyResult& one) {
        m_bench.mainQueue().post([this, apply, one] { takeApplied(*apply, one); });
    };
    const ApplyRequest& request = apply->request;
    if (request.bundle) // each servo is reported by onServo
        (void)jobs::restoreBundle(task.device, *request.bundle, options, task.progress, onServo);
    else
        (void)jobs::applyToServos(task.device, request.ids, request.snapshot, options,
                                  task.progress, onServo);
    return {};
}

void RestoreService::apply(ApplyRequest request)
{
    const auto apply = std::make_shared<PendingApply>();
    for (const auto& [ref, one] : m_bench.registry().entries()) {
        if (!one.snapshotPath.isEmpty() && one.servo.baud == m_bench.link().baud())
            apply->saved.insert(one.servo.id);
    }
    apply->request = std::move(request);
    const auto work = std::make_shared<Work>();
    work->task.name = QStringLiteral("restore");
    work->task.quiet = true;
    work->completesBeforeClose = true;
    work->task.work = [this, apply](TaskContext& task) { return runApply(apply, task); };
    work->onMerged = [this, apply](Work& ended) {
        for (const auto& [id, path] : apply->savedPaths)
            tableSaved(id, path);
        if (ended.error)
            m_bench.emitEvent({.kind = Event::Kind::Failed, .error = ended.error});
        if (apply->request.done && apply->request.guard)
            apply->request.done({ended.error, std::move(apply->applied)});
    };
    m_bench.tasks().enqueue(work);
}

void RestoreService::tableSaved(int id, const QString& path)
{
    for (const ServoRef ref : std::vector(m_bench.registry().order())) {
        ServoEntry* one = m_bench.registry().entry(ref);
        if (one == nullptr || one->servo.id != id || one->servo.baud != m_bench.link().baud())
            continue;
        one->snapshotPath = path;
        m_bench.emitEvent({.kind = Event::Kind::TableSaved, .servo = ref, .path = path});
    }
}

/// One servo is done: what was read and written of it goes into the list.
void RestoreService::takeApplied(PendingApply& apply, const jobs::ApplyResult& one)
{
    apply.applied.push_back(one);
    if (apply.request.onServo && apply.request.guard)
        apply.request.onServo(one);
    if (!one.servo || apply.request.options.dryRun)
        return;
    const ServoRef ref = m_bench.registry().findServo(one.servo->protocol, one.id);
    ServoEntry* known = m_bench.registry().entry(ref);
    if (known == nullptr || known->servo.baud != one.servo->baud)
        return;
    m_bench.registry().merge(*known, *one.servo, m_bench.now());
    reportApplied(ref, one);
}

void RestoreService::reportApplied(ServoRef ref, const jobs::ApplyResult& one)
{
    ServoEntry* known = m_bench.registry().entry(ref);
    if (known == nullptr || !one.outcome || one.outcome->rows.empty())
        return;
    const WriteRequest writes{itemsOf(one.plan)};
    Work ended;
    ended.ref = ref;
    m_bench.writes().markWritesPending(*known, writes);
    writesEnded(ended, writes, one.outcome);
}
} // namespace session
