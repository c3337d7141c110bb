// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/recover/recover.h"

#include "device/write_access.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover_apply.h"
#include "jobs/recover/recover_preview.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace jobs {
using base::ErrorCode;
using base::IntentKind;

namespace {
/// For a snapshot the result of each row is known; for others the result of the whole. Rows that
/// finishing had to write have an intent of their own, with its time; here only the values found
/// before are known.
std::vector<base::ItemResult> itemResults(const base::Intent& intent, const device::Servo& servo,
                                          const AppliedRecovery& applied, const QString& word)
{
    const bool undone = word == QLatin1String("undone");
    const QString unknown = device::outcomeName(device::WriteOutcome::Unknown);
    std::vector<base::ItemResult> ends;
    if (isSnapshotRestore(intent) && applied.report)
        ends = applied.report->itemResults();
    for (base::ItemResult& end : ends)
        end.outcome = undone ? word : end.outcome;
    for (const QString& key : applied.skippedKeys)
        ends.push_back({key, servo.raw(key), unknown});
    if (undone)
        return ends;
    for (const device::WriteItem& item : applied.writtenNow) {
        const auto known = std::find_if(ends.begin(), ends.end(),
                                        [&](const auto& end) { return end.key == item.key; });
        if (known != ends.end())
            ends.erase(known);
        ends.push_back({item.key, item.raw, unknown});
    }
    return ends;
}

bool isRestoreOfSameServo(const base::Intent& a, const base::Intent& b)
{
    return a.servo.id == b.servo.id && a.servo.port == b.servo.port &&
           a.servo.isSameKind(b.servo) && isSnapshotRestore(a) && isSnapshotRestore(b);
}

/// The rollback of a failed restore: it writes the values that the restore had found.
bool isRevertOf(const base::Intent& later, const base::Intent& restore)
{
    const auto found = [&](const base::JournalItem& item) {
        return std::any_of(restore.items.begin(), restore.items.end(), [&](const auto& before) {
            return before.key == item.key && before.oldRaw == item.newRaw;
        });
    };
    return isRestoreOfSameServo(later, restore) &&
           std::all_of(later.items.begin(), later.items.end(), found);
}

struct RecoveryTask {
    base::Intent intent;
    RecoveryAction action = RecoveryAction::Preview;
};

/// Oldest first, and undone starting with the latest. A restore whose rollback had started was
/// abandoned then, together with every attempt to finish it: it ends with the old values for any
/// requested action.
std::vector<RecoveryTask> recoveryTasks(const std::vector<base::Intent>& open,
                                        RecoveryAction action)
{
    std::vector<RecoveryTask> tasks;
    for (const base::Intent& intent : open)
        tasks.push_back({intent, action});
    if (action == RecoveryAction::Preview)
        return tasks;
    const auto place = [](std::size_t at) { return static_cast<std::ptrdiff_t>(at); };
    for (std::size_t back = open.size(); back-- > 0;) {
        std::size_t first = 0;
        while (first < back && !isRevertOf(open[back], open[first]))
            ++first;
        if (first == back)
            continue;
        for (std::size_t i = first; i < back; ++i) {
            if (isRestoreOfSameServo(open[i], open[back]))
                tasks[i].action = RecoveryAction::Undo;
        }
        tasks[back].action = RecoveryAction::Finish;
        if (action == RecoveryAction::Finish)
            std::reverse(tasks.begin() + place(first), tasks.begin() + place(back + 1));
        back = first;
    }
    if (action == RecoveryAction::Undo)
        std::reverse(tasks.begin(), tasks.end());
    return tasks;
}

/// A restore leaves torque off, also if it is finished later.
void noteTorque(const device::Context& context, const RecoveryResult& one)
{
    if (one.torqueIsOff)
        context.note(device::NoticeCode::TorqueStaysOff, one.before.foundId);
}
} // namespace

namespace {
/// A servo that was not found cannot be recovered.
std::optional<base::Error> lookupError(const OpenIntent& open)
{
    const QString operation = QStringLiteral("recover");
    switch (open.finding) {
    case Finding::NoReply:
        return base::Error{ErrorCode::NoReply, operation, {}, open.intent.servo.id};
    case Finding::OtherServo:
        return base::Error{ErrorCode::IdentityMismatch, operation, {}, open.intent.servo.id};
    case Finding::Unreadable:
        return open.unreadable;
    default:
        return std::nullopt;
    }
}

base::Error inProgressError(const base::Intent& intent)
{
    return {ErrorCode::Held, QStringLiteral("recover"), QStringLiteral("other-program"),
            intent.servo.id};
}

RecoveryResult skippedResult(const base::Intent& intent, RecoveryAction action)
{
    RecoveryResult recovered;
    recovered.action = action;
    recovered.before.intent = intent;
    recovered.before.finding = Finding::UnderWay;
    if (action != RecoveryAction::Preview)
        recovered.error = inProgressError(intent);
    return recovered;
}

/// Registers that a later write has replaced do not belong to this change any more.
base::Intent withoutOverwritten(const OpenIntent& open)
{
    base::Intent rest = open.intent;
    std::erase_if(rest.items,
                  [&](const base::JournalItem& item) { return open.replaced.contains(item.key); });
    return rest;
}

/// Restoring its defaults may have changed ID and rate. After the rows are restored, ID and rate
/// follow by their own safe procedures.
base::Result<void> revertLocation(const device::Context& context, const base::Intent& intent,
                                  device::Servo& servo)
{
    const auto toResult = [](const base::Result<device::WriteReport>& report) {
        if (!report)
            return base::Result<void>(tl::unexpected(report.error()));
        return report->isSuccessful()
                   ? base::Result<void>()
                   : base::fail(ErrorCode::LockOpen, QStringLiteral("recover"), {}, report->id);
    };
    if (servo.id != intent.servo.id) {
        if (const auto moved = toResult(changeId(context, servo, intent.servo.id)); !moved)
            return moved;
    }
    if (!context.bus.canSetBaud() || intent.servo.baud <= 0 || servo.baud == intent.servo.baud)
        return {};
    return toResult(changeBaud(context, servo, intent.servo.baud));
}

/// Restores ID and rate, which are no plain rows.
base::Intent withoutIdentity(base::Intent intent, const device::Servo& servo)
{
    std::erase_if(intent.items, [&](const base::JournalItem& item) {
        const catalog::Register* reg = servo.profile->find(item.key);
        return reg != nullptr && reg->identity;
    });
    return intent;
}

base::Result<void> prepareWrite(const device::Context& context, device::Servo& servo,
                                const BeforeWrite& beforeWrite)
{
    const auto may = device::beginWriting(context, servo, QStringLiteral("recover"));
    return may && beforeWrite ? beforeWrite(context, servo) : may;
}

/// The journal's outcome of a recovered change.
QString endOutcome(const RecoveryResult& recovered)
{
    if (recovered.isAllSkipped)
        return QStringLiteral("abandoned");
    const bool finished =
        recovered.action == RecoveryAction::Finish && !isRevertOnly(recovered.before.intent);
    return finished ? QStringLiteral("done") : QStringLiteral("undone");
}

void endRecovery(const device::Context& context, const device::Servo& servo,
                 const AppliedRecovery& applied, RecoveryResult& recovered)
{
    const base::Intent& intent = recovered.before.intent;
    if (recovered.before.lockOpen.value_or(false))
        context.note(device::NoticeCode::LockClosed, servo.id);
    recovered.skippedKeys = applied.skippedKeys;
    recovered.isAllSkipped = applied.isNothingToDo && !applied.skippedKeys.isEmpty();
    const QString word = endOutcome(recovered);
    context.record(intent.uuid, servo.id, {word, {}, itemResults(intent, servo, applied, word)});
    recovered.done = true;
}
} // namespace

base::Result<RecoveryResult> recoverIntent(const device::Context& context,
                                           const base::Intent& intent, RecoveryAction action,
                                           const BeforeWrite& beforeWrite)
{
    if (intent.isActiveElsewhere)
        return skippedResult(intent, action);
    RecoveryResult recovered;
    recovered.action = action;
    device::Servo servo;
    const auto before = previewIntent(context, intent, servo);
    if (!before)
        return tl::unexpected(before.error());
    recovered.before = *before;
    if (action == RecoveryAction::Preview)
        return recovered;
    if (const auto refusal = lookupError(*before)) {
        recovered.error = refusal;
        return recovered;
    }
    if (const auto ready = prepareWrite(context, servo, beforeWrite); !ready) {
        recovered.error = ready.error();
        return recovered;
    }
    base::Intent rest = withoutOverwritten(*before);
    const bool moved = intent.kind == IntentKind::Restore && !hasKnownNewValues(intent) &&
                       (servo.id != intent.servo.id || servo.baud != intent.servo.baud);
    if (moved)
        rest = withoutIdentity(std::move(rest), servo);
    AppliedRecovery applied = applyRecovery(context, rest, servo, action);
    applied.skippedKeys = before->replaced + applied.skippedKeys;
    if (applied.result && moved && action == RecoveryAction::Undo)
        applied.result = revertLocation(context, intent, servo);
    recovered.report = applied.report;
    recovered.torqueIsOff = applied.torqueIsOff;
    if (!applied.result) {
        recovered.error = applied.result.error();
        return recovered;
    }
    endRecovery(context, servo, applied, recovered);
    return recovered;
}

bool isRecoveredBy(const RecoveryResult& recovered, const device::Servo& servo,
                   const catalog::Register& reg)
{
    return !recovered.skippedKeys.contains(reg.key) &&
           isRecoverable(recovered.before.intent, servo, reg);
}

namespace {
bool isSelected(const base::Intent& intent, const QString& port, IntentPorts ports)
{
    if (intent.servo.port == port)
        return true;
    base::ServoIdentity currentIdentity;
    currentIdentity.port = port;
    if (ports == IntentPorts::This || intent.servo.isSimulated() != currentIdentity.isSimulated())
        return false;
    return ports == IntentPorts::Any || !isPortPresent(intent);
}
} // namespace

std::vector<base::Intent> startedOnOtherPorts(const std::vector<base::Intent>& open,
                                              const QString& port, IntentPorts ports)
{
    std::vector<base::Intent> otherPortIntents;
    std::copy_if(open.begin(), open.end(), std::back_inserter(otherPortIntents),
                 [&](const auto& intent) {
                     return !intent.servo.isSimulated() && !isSelected(intent, port, ports);
                 });
    return otherPortIntents;
}

bool isPortPresent(const base::Intent& intent)
{
    const QString& port = intent.servo.port;
    return QDir::isAbsolutePath(port) && QFileInfo::exists(port);
}

base::Result<void> forget(base::Journal& journal, const base::Intent& intent)
{
    if (intent.isActiveElsewhere)
        return tl::unexpected(inProgressError(intent));
    return journal.end(intent.uuid, {QStringLiteral("abandoned"), {}});
}

base::Result<std::vector<RecoveryResult>> recover(const device::Context& outer,
                                                  RecoveryAction action,
                                                  const RecoveryOptions& options,
                                                  const ProgressFn& progress)
{
    const auto open = outer.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    const QString port = context.bus.portName();
    std::vector<base::Intent> requestedIntents;
    std::copy_if(open->begin(), open->end(), std::back_inserter(requestedIntents),
                 [&](const auto& intent) {
                     return isSelected(intent, port, options.ports) &&
                            (options.uuid.isEmpty() || intent.uuid == options.uuid);
                 });
    std::vector<RecoveryResult> all;
    const int baudBefore = context.bus.baud();
    const auto tasks = recoveryTasks(requestedIntents, action);
    for (const RecoveryTask& task : tasks) {
        if (progress)
            progress({double(all.size()) / double(tasks.size())});
        if (context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("recover"));
        auto one = recoverIntent(context, task.intent, task.action, options.beforeWrite);
        if (context.bus.canSetBaud()) // also after an error: the next task expects it
            (void)context.bus.setBaud(baudBefore);
        if (!one)
            return tl::unexpected(one.error());
        if (one->error && one->error->code == ErrorCode::LinkLost)
            return tl::unexpected(*one->error);
        noteTorque(context, *one);
        all.push_back(std::move(*one));
    }
    return all;
}
} // namespace jobs
