// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/writes/recovery_service.h"

#include "session/snapshot/safety_snapshot.h"
#include "session/workbench.h"

#include <algorithm>

namespace session {
namespace {
/// What a look has brought.
struct IntentReport {
    std::vector<jobs::RecoveryResult> found{};
    std::vector<base::Intent> elsewhere{};
};

/// Where the journal has no open intent to look at no servo is asked.
base::Result<IntentReport> detectOrRecover(const device::Context& context,
                                           jobs::RecoveryAction action,
                                           const jobs::RecoveryOptions& options,
                                           const jobs::ProgressFn& progress)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    IntentReport intentReport;
    const QString here = context.bus.portName();
    intentReport.elsewhere = jobs::startedOnOtherPorts(*open, here, options.ports);
    const bool own = std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
        return intent.servo.port == here;
    });
    if (own || jobs::startedOnOtherPorts(*open, here).size() > intentReport.elsewhere.size()) {
        auto recovered = jobs::recover(context, action, options, progress);
        if (!recovered)
            return tl::unexpected(recovered.error());
        intentReport.found = std::move(*recovered);
    }
    return intentReport;
}

/// A table that was saved before an intent was settled.
struct SavedTable {
    base::Protocol protocol;
    int id;
    QString path;
};

jobs::BeforeWrite saveTablesInto(std::vector<SavedTable>& saved)
{
    return [&saved](const device::Context& context, device::Servo& servo) -> base::Result<void> {
        const auto path = saveSafetySnapshot(context, servo);
        if (!path)
            return tl::unexpected(path.error());
        saved.push_back({servo.protocol, servo.id, *path});
        return {};
    };
}

/// The rate a report says was written.
std::optional<int> rateAfter(const catalog::Profile& profile, const device::WriteReport& report)
{
    const catalog::Register* reg = profile.byRole(catalog::Role::BaudRate);
    for (const device::WriteResult& result : report.writes) {
        if (reg == nullptr || result.key != reg->key ||
            result.outcome != device::WriteOutcome::Kept)
            continue;
        for (const catalog::NamedValue& value : reg->values) {
            if (value.value == result.newRaw)
                return value.key.toInt();
        }
    }
    return std::nullopt;
}

/// An intent of a servo whose model was unknown names no map.
bool isOfKind(const device::Servo& servo, const base::ServoIdentity& identity)
{
    if (!servo.profile)
        return false;
    base::ServoIdentity known = servo.identity();
    known.map = identity.map.isEmpty() ? QString() : known.map;
    return known.isSameKind(identity);
}
} // namespace

RecoveryService::RecoveryService(Workbench& bench)
    : m_bench(bench)
{}

void RecoveryService::checkOnce(bool anyPort)
{
    if (!std::exchange(m_checked, true))
        findOpenIntents(anyPort);
}

void RecoveryService::findOpenIntents(bool anyPort)
{
    recoverIntents(jobs::RecoveryAction::Preview, {}, anyPort);
}

void RecoveryService::recoverIntent(const QString& uuid, jobs::RecoveryAction action)
{
    recoverIntents(action, uuid, true); // this one was chosen, wherever it was begun
}

void RecoveryService::recoverIntents(jobs::RecoveryAction action, const QString& uuid, bool anyPort)
{
    const auto intentReport = std::make_shared<IntentReport>();
    const auto saved = std::make_shared<std::vector<SavedTable>>();
    const auto work = std::make_shared<Work>();
    work->task.name = QStringLiteral("recover");
    work->task.quiet = action == jobs::RecoveryAction::Preview;
    const auto ports = anyPort ? jobs::IntentPorts::IncludingMissing : jobs::IntentPorts::This;
    work->task.work = [action, uuid, ports, intentReport, saved](TaskContext& task) {
        return detectOrRecover(task.device, action, {ports, uuid, saveTablesInto(*saved)},
                               task.progress)
            .map([&intentReport](IntentReport&& made) { *intentReport = std::move(made); });
    };
    work->onMerged = [this, intentReport, saved, resolves = action != jobs::RecoveryAction::Preview,
                      task = work->task.name](Work& ended) {
        for (const SavedTable& table : *saved) {
            const ServoRef ref = m_bench.registry().findServo(table.protocol, table.id);
            if (ServoEntry* known = m_bench.registry().entry(ref))
                known->snapshotPath = table.path;
            m_bench.emitEvent({.kind = Event::Kind::TableSaved, .servo = ref, .path = table.path});
        }
        if (ended.error)
            m_bench.emitEvent({.kind = Event::Kind::Failed,
                               .task = resolves ? task : QString(),
                               .error = ended.error});
        if (ended.error) { // what is open is not known: not the same as nothing
            m_checked = m_checked && resolves;
            return;
        }
        for (const jobs::RecoveryResult& one : intentReport->found) {
            if (resolves && one.error)
                ended.error = one.error; // what was asked for has not been done
            m_bench.writes().mergeRecoveredUndo(one, findEntry(one.before));
            updateRecovered(one);
        }
        Q_EMIT openIntentsFound(intentReport->found, intentReport->elsewhere);
    };
    m_bench.tasks().enqueue(work);
}

/// In the list: the servo that a look has found. Its row still stands where the interrupted change
/// of ID or rate began, unless a search has met the servo where it is now.
ServoRef RecoveryService::findEntry(const jobs::OpenIntent& found) const
{
    const base::ServoIdentity& identity = found.intent.servo;
    const auto at = [&](int id, int baud) {
        const auto row = std::find_if(
            m_bench.registry().order().begin(), m_bench.registry().order().end(),
            [&](ServoRef ref) {
                const device::Servo& known = m_bench.registry().entries().at(ref).servo;
                return known.id == id && known.baud == baud && isOfKind(known, identity);
            });
        return row != m_bench.registry().order().end() ? *row : 0;
    };
    const ServoRef now = at(found.foundId, found.foundBaud);
    return now != 0
               ? now
               : at(identity.id, m_bench.link().canSetBaud() ? identity.baud : found.foundBaud);
}

/// Settling an ID or a rate leads the servo away from where the list has it, or the interrupted
/// change had done so already. One servo has one row: where it was, it has been asked in vain.
void RecoveryService::updateRecovered(const jobs::RecoveryResult& one)
{
    const base::ServoIdentity& identity = one.before.intent.servo;
    const ServoRef ref = findEntry(one.before);
    ServoEntry* known = m_bench.registry().entry(ref);
    if (!one.done || known == nullptr)
        return;
    device::Servo moved = known->servo;
    moved.id = one.report && one.report->id >= 0 ? one.report->id : one.before.foundId;
    moved.baud = one.before.foundBaud;
    if (one.report && moved.profile)
        moved.baud = rateAfter(*moved.profile, *one.report).value_or(moved.baud);
    // It was identified, written to and read back where it is.
    known->silent = known->garbled = known->answeredAgain = false;
    known->lastSeen = m_bench.now();
    m_bench.registry().merge(*known, moved, m_bench.now());
    removeFormerEntry(identity, ref);
    m_bench.registry().changed(*known);
    m_bench.writes().readTable(ref);
    m_bench.writes().loadHistory(ref);
}

/// The row at the place a servo has left, if the list has another one of it.
void RecoveryService::removeFormerEntry(const base::ServoIdentity& left, ServoRef now)
{
    const auto row = std::find_if(
        m_bench.registry().order().begin(), m_bench.registry().order().end(), [&](ServoRef ref) {
            const ServoEntry& known = m_bench.registry().entries().at(ref);
            const bool there = known.servo.id == left.id &&
                               (!m_bench.link().canSetBaud() || known.servo.baud == left.baud);
            return ref != now && there && known.silent && isOfKind(known.servo, left);
        });
    if (row != m_bench.registry().order().end())
        m_bench.registry().remove(*row);
}

/// After the running task, which may have started it.
void RecoveryService::discardIntent(const QString& uuid)
{
    const auto work = std::make_shared<Work>();
    work->task.name = QStringLiteral("recover");
    work->task.quiet = true;
    work->task.work = [uuid](TaskContext& task) -> base::Result<void> {
        const auto open = task.device.journal.open();
        if (!open)
            return tl::unexpected(open.error());
        const auto own = std::find_if(open->begin(), open->end(), [&](const base::Intent& intent) {
            return intent.uuid == uuid;
        });
        return own != open->end() ? jobs::forget(task.device.journal, *own) : base::Result<void>();
    };
    work->onMerged = [this](Work& ended) {
        if (ended.error)
            m_bench.emitEvent({.kind = Event::Kind::Failed, .error = ended.error});
        else
            findOpenIntents();
    };
    m_bench.tasks().enqueue(work);
}
} // namespace session
