// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/recover/recover_apply.h"

#include "device/motion/motion.h"
#include "device/persistence.h"
#include "device/transactions.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover_preview.h"

#include <algorithm>
#include <map>

namespace jobs {
using base::ErrorCode;
using base::IntentKind;
using device::WriteOutcome;
using device::WriteResult;

namespace {
/// The values of the action: those still to be written, those already set, and those that recovery
/// does not write.
struct RecoveryItems {
    std::vector<device::WriteItem> write;
    std::vector<device::WriteItem> reassert;
    QStringList left;
};

/// In the order of the journal, which is that of the writes.
RecoveryItems planItems(const base::Intent& intent, const device::Servo& servo,
                        RecoveryAction action)
{
    RecoveryItems items;
    for (const base::JournalItem& item : intent.items) {
        const catalog::Register* reg = servo.profile->find(item.key);
        const auto present = reg != nullptr ? servo.raw(*reg) : std::nullopt;
        if (reg != nullptr && isZeroedByModeSwitch(intent, servo, *reg))
            continue;
        if (!present) {
            items.left << item.key;
            continue;
        }
        // The results of calibration and restore are not known beforehand: finishing accepts the
        // present values.
        const std::int64_t finished = hasKnownNewValues(intent) ? item.newRaw : *present;
        const bool forward = action == RecoveryAction::Finish && !isRevertOnly(intent);
        const std::int64_t wanted = forward ? finished : item.oldRaw;
        if (present == wanted)
            items.reassert.push_back({item.key, wanted});
        else if (isRecoverable(intent, servo, *reg))
            items.write.push_back({item.key, wanted});
        else
            items.left << item.key;
    }
    return items;
}

AppliedRecovery toAppliedRecovery(base::Result<device::WriteReport> written)
{
    if (!written)
        return {tl::unexpected(written.error()), {}};
    if (written->isSuccessful())
        return {{}, *written};
    for (const device::WriteResult& result : written->writes) {
        if (result.error)
            return {tl::unexpected(*result.error), *written};
    }
    return {base::fail(ErrorCode::LockOpen, QStringLiteral("recover"), {}, written->id), *written};
}

/// Finishing a rollback: this servo once had each of these values.
bool wasHeldBefore(const device::Context& context, const base::Intent& intent,
                   const std::vector<device::WriteItem>& items)
{
    const auto entries = context.journal.entriesFor(intent.servo, maxJournalEntries);
    if (!entries)
        return false;
    const auto found = [&](const device::WriteItem& wanted) {
        for (const base::JournalEntry& entry : *entries) {
            if (entry.intent.servo.port != intent.servo.port)
                continue;
            for (const base::JournalItem& item : entry.intent.items) {
                if (item.key == wanted.key && item.oldRaw == wanted.raw)
                    return true;
            }
        }
        return false;
    };
    return std::all_of(items.begin(), items.end(), found);
}

AppliedRecovery writeItems(const device::Context& context, const base::Intent& intent,
                           device::Servo& servo, const std::vector<device::WriteItem>& items,
                           RecoveryAction action)
{
    const int target = items.empty() ? 0 : static_cast<int>(items.front().raw);
    if (items.empty())
        return {};
    if (intent.kind == IntentKind::SetId)
        return toAppliedRecovery(changeId(context, servo, target));
    if (intent.kind == IntentKind::SetBaud) {
        const catalog::Register* reg = servo.profile->byRole(catalog::Role::BaudRate);
        for (const catalog::NamedValue& value : reg->values) {
            if (value.value == target)
                return toAppliedRecovery(changeBaud(context, servo, value.key.toInt()));
        }
        return {base::fail(ErrorCode::OutOfRange, QStringLiteral("recover"), {}, servo.id), {}};
    }
    device::WriteOptions options;
    options.consent = device::Consent::ofEarlierChange();
    options.temporary = intent.temporary;
    options.allowPreviousValues = action == RecoveryAction::Undo || isRevertOnly(intent) ||
                                  wasHeldBefore(context, intent, items);
    if (isSnapshotRestore(intent)) {
        options.kind = IntentKind::Restore;
        options.torqueOff = true;
        options.keepOrder = action == RecoveryAction::Finish;
        options.stopOnFailure = action == RecoveryAction::Finish;
    }
    return toAppliedRecovery(device::write(context, servo, items, options));
}

/// Values that need the open lock of this area, written once more with the lock open.
base::Result<void> reassertLocked(const device::Context& context, device::Servo& servo,
                                  const std::vector<const device::WriteItem*>& items)
{
    if (items.empty())
        return {};
    const auto registerOf = [&servo](const device::WriteItem* item) -> const catalog::Register& {
        return *servo.profile->find(item->key);
    };
    auto eprom = device::UnlockedEprom::open(context, servo, registerOf(items.front()));
    if (!eprom)
        return tl::unexpected(eprom.error());
    for (const device::WriteItem* item : items) {
        const auto rewritten = device::writeVerified(context, servo, registerOf(item), item->raw);
        if (!rewritten)
            return rewritten;
    }
    const device::LockState lock = eprom->close();
    if (lock == device::LockState::Closed && eprom->stayedOpen())
        return {};
    return base::fail(ErrorCode::LockOpen, QStringLiteral("recover"), {}, servo.id);
}

base::Result<void> reassertSaved(const device::Context& context, device::Servo& servo,
                                 const catalog::Register& reg, std::int64_t raw)
{
    if (const auto rewritten = device::writeVerified(context, servo, reg, raw); !rewritten)
        return rewritten;
    const auto saved = device::save(context, servo, reg);
    if (saved)
        context.note(device::NoticeCode::SaveUnverified, servo.id, reg.key);
    return saved;
}

/// A value that reads right may be in RAM only, if the servo restarted in the middle of the write.
/// Written once more, with the lock open or saved, it is certainly kept.
base::Result<void> reassert(const device::Context& context, const base::Intent& intent,
                            device::Servo& servo, const std::vector<device::WriteItem>& items)
{
    if (intent.temporary)
        return {};
    std::map<catalog::Area, std::vector<const device::WriteItem*>> locked;
    for (const device::WriteItem& item : items) {
        const catalog::Register& reg = *servo.profile->find(item.key);
        const device::Retention keeping = device::retentionOf(reg);
        if (keeping == device::Retention::Lock)
            locked[reg.area].push_back(&item);
        else if (keeping != device::Retention::Save)
            continue;
        else if (const auto saved = reassertSaved(context, servo, reg, item.raw); !saved)
            return saved;
    }
    for (const auto& [area, those] : locked) {
        if (const auto rewritten = reassertLocked(context, servo, those); !rewritten)
            return rewritten;
    }
    return {};
}

WriteOutcome outcomeOf(const catalog::Register& reg)
{
    const device::Retention keeping = device::retentionOf(reg);
    const bool isPersistent =
        keeping != device::Retention::Never && keeping != device::Retention::NotStated;
    return isPersistent ? WriteOutcome::Kept : WriteOutcome::Temporary;
}

/// Rows that had the requested value already. `why`: the value was not proven to be kept.
WriteResult unchangedResult(const device::Servo& servo, const base::JournalItem& item,
                            std::int64_t wanted, const std::optional<base::Error>& why)
{
    const std::int64_t other = wanted == item.newRaw ? item.oldRaw : item.newRaw;
    WriteResult result{item.key, item.address, other, wanted, wanted, WriteOutcome::Unknown, why};
    if (!why)
        result.outcome = outcomeOf(*servo.profile->find(item.key));
    return result;
}

/// Every row of a snapshot's restore in the order of its intent.
device::WriteReport fullReport(const base::Intent& intent, const device::Servo& servo,
                               const RecoveryItems& items, const AppliedRecovery& applied)
{
    device::WriteReport combinedReport;
    combinedReport.id = servo.id;
    if (applied.report)
        combinedReport.openIntent = applied.report->openIntent;
    const auto why = applied.result ? std::nullopt : std::optional(applied.result.error());
    for (const base::JournalItem& item : intent.items) {
        const auto named = [&item](const auto& one) { return one.key == item.key; };
        const auto& unchanged = items.reassert;
        if (const auto found = std::find_if(unchanged.begin(), unchanged.end(), named);
            found != unchanged.end())
            combinedReport.writes.push_back(unchangedResult(servo, item, found->raw, why));
        if (!applied.report)
            continue;
        const auto& written = applied.report->writes;
        const auto found = std::find_if(written.begin(), written.end(), named);
        if (found != written.end())
            combinedReport.writes.push_back(*found);
    }
    const bool isReported =
        std::any_of(combinedReport.writes.begin(), combinedReport.writes.end(),
                    [](const WriteResult& one) { return one.error.has_value(); });
    if (why && !isReported && !combinedReport.writes.empty())
        combinedReport.writes.back().error =
            why; // of the whole: setting commands to rest, or the lock
    return combinedReport;
}

/// device::write turns it off itself.
base::Result<void> torqueOff(const device::Context& context, device::Servo& servo,
                             const RecoveryItems& items)
{
    const bool has = servo.profile->byRole(catalog::Role::TorqueSwitch) != nullptr;
    if (!has || !items.write.empty() || items.reassert.empty())
        return {};
    return device::setTorque(context, servo, device::Torque::Off);
}

/// Everything but the lock.
AppliedRecovery recoverRows(const device::Context& context, const base::Intent& intent,
                            device::Servo& servo, const RecoveryItems& items, RecoveryAction action)
{
    if (isSnapshotRestore(intent)) {
        if (const auto off = torqueOff(context, servo, items); !off)
            return {off};
    }
    std::vector<device::WriteItem> found;
    for (const device::WriteItem& item : items.write)
        found.push_back({item.key, *servo.raw(item.key)});
    AppliedRecovery applied = writeItems(context, intent, servo, items.write, action);
    applied.writtenNow = std::move(found);
    if (applied.result)
        applied.result = reassert(context, intent, servo, items.reassert);
    if (applied.result && changesMode(intent, servo))
        applied.result = device::torqueOffAndZero(context, servo);
    return applied;
}
} // namespace

AppliedRecovery applyRecovery(const device::Context& context, const base::Intent& intent,
                              device::Servo& servo, RecoveryAction action)
{
    const RecoveryItems items = planItems(intent, servo, action);
    AppliedRecovery applied = recoverRows(context, intent, servo, items, action);
    applied.skippedKeys = items.left;
    applied.isNothingToDo = items.write.empty() && items.reassert.empty();
    const device::LockState lock = device::closeLock(context, servo);
    if (applied.result && lock != device::LockState::Closed && lock != device::LockState::None) {
        applied.result = tl::unexpected(
            base::Error{ErrorCode::LockOpen, QStringLiteral("recover"), {}, servo.id});
    }
    const bool refused = !applied.result && !applied.report && !items.write.empty();
    if (!isSnapshotRestore(intent) || refused)
        return applied;
    applied.report = fullReport(intent, servo, items, applied);
    applied.report->lock = lock;
    applied.torqueIsOff = servo.raw(catalog::Role::TorqueSwitch) == 0;
    return applied;
}
} // namespace jobs
