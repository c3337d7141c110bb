// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/journal_import.h"
#include "session/desk_work.h"
#include "session/snapshot/safety_snapshot.h"

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
                                           const jobs::RecoveryOptions& options)
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
        auto recovered = jobs::recover(context, action, options);
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

/// Journals of earlier versions name no map.
bool isOfKind(const device::Servo& servo, const base::ServoIdentity& identity)
{
    if (!servo.profile)
        return false;
    base::ServoIdentity known = servo.identity();
    known.map = identity.map.isEmpty() ? QString() : known.map;
    return known.isSameKind(identity);
}
} // namespace

void Desk::findOpenIntents(bool anyPort)
{
    recoverIntents(jobs::RecoveryAction::Preview, {}, anyPort);
}

void Desk::recoverIntent(const QString& uuid, jobs::RecoveryAction action)
{
    recoverIntents(action, uuid, true); // this one was chosen, wherever it was begun
}

void Desk::recoverIntents(jobs::RecoveryAction action, const QString& uuid, bool anyPort)
{
    const auto intentReport = std::make_shared<IntentReport>();
    const auto saved = std::make_shared<std::vector<SavedTable>>();
    const auto work = std::make_shared<Work>();
    work->task.name = QStringLiteral("recover");
    work->task.quiet = action == jobs::RecoveryAction::Preview;
    const auto ports = anyPort ? jobs::IntentPorts::IncludingMissing : jobs::IntentPorts::This;
    work->task.work = [action, uuid, ports, intentReport, saved](TaskContext& task) {
        return detectOrRecover(task.device, action, {ports, uuid, saveTablesInto(*saved)})
            .map([&intentReport](IntentReport&& made) { *intentReport = std::move(made); });
    };
    work->onMerged = [this, intentReport, saved, resolves = action != jobs::RecoveryAction::Preview,
                      task = work->task.name](Work& ended) {
        for (const SavedTable& table : *saved) {
            const ServoRef ref = findServo(table.protocol, table.id);
            if (ServoEntry* known = entry(ref))
                known->snapshotPath = table.path;
            emitEvent({.kind = Event::Kind::TableSaved, .servo = ref, .path = table.path});
        }
        if (ended.error)
            emitEvent({.kind = Event::Kind::Failed,
                       .task = resolves ? task : QString(),
                       .error = ended.error});
        for (const base::Error& journal : record::importUnreadableJournals())
            emitEvent({.kind = Event::Kind::Failed, .error = journal});
        if (ended.error) { // what is open is not known: not the same as nothing
            m_intentsChecked = m_intentsChecked && resolves;
            return;
        }
        for (const jobs::RecoveryResult& one : intentReport->found) {
            if (resolves && one.error)
                ended.error = one.error; // what was asked for has not been done
            mergeRecoveredUndo(one);
            updateRecovered(one);
        }
        Q_EMIT openIntentsFound(intentReport->found, intentReport->elsewhere);
    };
    enqueue(work);
}

/// In the list: the servo that a look has found. Its row still stands where the interrupted change
/// of ID or rate began, unless a search has met the servo where it is now.
ServoRef Desk::findEntry(const jobs::OpenIntent& found) const
{
    const base::ServoIdentity& identity = found.intent.servo;
    const auto at = [&](int id, int baud) {
        const auto row = std::find_if(m_order.begin(), m_order.end(), [&](ServoRef ref) {
            const device::Servo& known = m_servos.at(ref).servo;
            return known.id == id && known.baud == baud && isOfKind(known, identity);
        });
        return row != m_order.end() ? *row : 0;
    };
    const ServoRef now = at(found.foundId, found.foundBaud);
    return now != 0 ? now : at(identity.id, canSetBaud() ? identity.baud : found.foundBaud);
}

/// Settling an ID or a rate leads the servo away from where the list has it, or the interrupted
/// change had done so already. One servo has one row: where it was, it has been asked in vain.
void Desk::updateRecovered(const jobs::RecoveryResult& one)
{
    const base::ServoIdentity& identity = one.before.intent.servo;
    const ServoRef ref = findEntry(one.before);
    ServoEntry* known = entry(ref);
    if (!one.done || known == nullptr)
        return;
    device::Servo moved = known->servo;
    moved.id = one.report && one.report->id >= 0 ? one.report->id : one.before.foundId;
    moved.baud = one.before.foundBaud;
    if (one.report && moved.profile)
        moved.baud = rateAfter(*moved.profile, *one.report).value_or(moved.baud);
    // It was identified, written to and read back where it is.
    known->silent = known->garbled = known->answeredAgain = false;
    known->lastSeen = now();
    merge(*known, moved, now());
    removeFormerEntry(identity, ref);
    changed(*known);
    readTable(ref);
    loadHistory(ref);
}

/// The row at the place a servo has left, if the list has another one of it.
void Desk::removeFormerEntry(const base::ServoIdentity& left, ServoRef now)
{
    const auto row = std::find_if(m_order.begin(), m_order.end(), [&](ServoRef ref) {
        const ServoEntry& known = m_servos.at(ref);
        const bool there =
            known.servo.id == left.id && (!canSetBaud() || known.servo.baud == left.baud);
        return ref != now && there && known.silent && isOfKind(known.servo, left);
    });
    if (row != m_order.end())
        remove(*row);
}

/// What the interrupted write had changed in this session could be undone by itself, and would
/// leave a mixture behind. Once it is finished Undo takes back all of it; once it is undone
/// nothing.
void Desk::mergeRecoveredUndo(const jobs::RecoveryResult& one)
{
    const base::Intent& intent = one.before.intent;
    const bool snapshot =
        intent.kind == base::IntentKind::Restore && jobs::restoresSnapshot(intent);
    const ServoRef ref = findEntry(one.before);
    const ServoEntry* known = servo(ref);
    if (!one.done || known == nullptr || !known->servo.profile ||
        !(snapshot || intent.kind == base::IntentKind::Write))
        return;
    UndoStep whole{ref, {}, {}, intent.temporary};
    for (const base::JournalItem& item : intent.items) {
        const catalog::Register* reg = known->servo.profile->find(item.key);
        const bool settled = reg != nullptr && jobs::isRecoveredBy(one, known->servo, *reg);
        if (!settled || item.oldRaw == item.newRaw)
            continue;
        whole.oldItems.push_back({item.key, item.oldRaw});
        whole.newItems.push_back({item.key, item.newRaw});
    }
    const auto isIn = [](const std::vector<device::WriteItem>& all, const device::WriteItem& item) {
        return std::any_of(all.begin(), all.end(), [&](const device::WriteItem& each) {
            return each.key == item.key && each.raw == item.raw;
        });
    };
    std::erase_if(m_undo, [&](const UndoStep& step) {
        const auto covered = [&](const auto& items, const auto& by) {
            return std::all_of(items.begin(), items.end(),
                               [&](const device::WriteItem& item) { return isIn(by, item); });
        };
        return step.servo == ref && covered(step.oldItems, whole.oldItems) &&
               covered(step.newItems, whole.newItems);
    });
    if (one.action == jobs::RecoveryAction::Finish && !whole.oldItems.empty()) {
        m_undo.push_back(whole);
        m_redo.clear();
    }
    Q_EMIT undoChanged();
}

/// Behind whatever is running, which may be what began it.
void Desk::discardIntent(const QString& uuid)
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
            emitEvent({.kind = Event::Kind::Failed, .error = ended.error});
        else
            findOpenIntents();
    };
    enqueue(work);
}
} // namespace session
