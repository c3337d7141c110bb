// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore/restore.h"

#include "device/write_access.h"
#include "jobs/restore/restore_run.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using device::NoticeCode;

namespace {
const QString restoreOperation = QStringLiteral("restore");

base::Result<void> checkPlan(const device::Servo& servo, const RestorePlan& plan,
                             const RestoreOptions& options)
{
    const bool same = plan.id == servo.id && plan.servo.profile && servo.profile &&
                      plan.servo.profile->mapKey == servo.profile->mapKey &&
                      plan.servo.profile->identity == servo.profile->identity;
    if (!same)
        return base::fail(ErrorCode::BadArgument, restoreOperation, QStringLiteral("other servo"),
                          servo.id);
    if (!plan.needsConsent() || options.consent)
        return {};
    base::Error error{ErrorCode::NeedsConsent, restoreOperation, {}, servo.id};
    for (const RestoreRow& row : plan.rows) {
        if (row.selected && row.reasons.testFlag(RestoreReason::NeedsConsent)) {
            error.registerKey = row.key;
            break;
        }
    }
    return tl::unexpected(error);
}

/// Interrupted restores of exactly these values, whose intents are open. Restoring again means to
/// finish them, which recovery does best: it also writes again the values that may be in RAM only.
std::vector<base::Intent> interruptedRestores(const device::Context& context,
                                              const device::Servo& servo, const RestorePlan& plan)
{
    std::vector<base::Intent> broken;
    const auto open = context.journal.open();
    if (!open)
        return broken;
    const base::ServoIdentity identity = servo.identity();
    for (const base::Intent& intent : *open) {
        const bool ours = isSnapshotRestore(intent) && intent.servo.id == identity.id &&
                          intent.servo.port == identity.port && intent.servo.isSameKind(identity);
        const auto wanted = [&](const base::JournalItem& item) {
            const RestoreRow* row = plan.find(item.key);
            return row != nullptr && row->newRaw == item.newRaw &&
                   (row->selected || row->reasons.testFlag(RestoreReason::Same));
        };
        if (ours && !intent.items.empty() &&
            std::all_of(intent.items.begin(), intent.items.end(), wanted))
            broken.push_back(intent);
    }
    return broken;
}
} // namespace

base::Result<RestoreOutcome> restore(const device::Context& outer, device::Servo& servo,
                                     const RestorePlan& given, const RestoreOptions& options,
                                     const ProgressFn& progress)
{
    if (const auto planCheck = checkPlan(servo, given, options); !planCheck)
        return tl::unexpected(planCheck.error());
    RestorePlan plan = given;
    selectTemporary(outer, plan, options.consent);
    RestoreOutcome outcome;
    outcome.oldId = outcome.newId = servo.id;
    outcome.oldBaud = outcome.newBaud = servo.baud;
    const std::vector<RestoreWrite> writes = plannedWrites(plan);
    const auto earlier = interruptedRestores(outer, servo, plan);
    if (writes.empty() && earlier.empty() && !isLockOpen(servo)) {
        if (omittedRows(plan).empty())
            outer.note(NoticeCode::AlreadySet, servo.id);
        return outcome;
    }
    if (const auto may = device::beginWriting(outer, servo, restoreOperation); !may)
        return tl::unexpected(may.error());
    if (options.beforeWrite) {
        if (const auto saved = options.beforeWrite(outer, servo); !saved)
            return tl::unexpected(saved.error());
    }
    // A servo that gets another ID or rate, or has to be found, needs the whole bus.
    const bool own = !earlier.empty() || std::any_of(writes.begin(), writes.end(), needsOwnJob);
    const device::Owned owned =
        device::own(outer, own ? std::vector<int>() : std::vector<int>{servo.id});
    const device::Context& context = owned.context;
    if (progress)
        progress({});
    const std::size_t before = context.notices.size();
    RestoreRunner restorer(context, servo, options, progress, outcome);
    if (const auto done = restorer.run(earlier, writes); !done)
        return tl::unexpected(done.error());
    for (std::size_t i = before; i < context.notices.size(); ++i)
        outcome.torqueSwitchedOff |= context.notices[i].code == NoticeCode::TorqueSwitchedOff;
    outcome.newId = servo.id;
    outcome.newBaud = servo.baud;
    if (progress)
        progress({1.0});
    return outcome;
}

bool isSnapshotRestore(const base::Intent& intent)
{
    return intent.kind == base::IntentKind::Restore &&
           std::any_of(intent.items.begin(), intent.items.end(),
                       [](const base::JournalItem& item) { return item.oldRaw != item.newRaw; });
}
} // namespace jobs
