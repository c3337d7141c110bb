// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/writer.h"

#include "base/enum_names.h"
#include "device/write_access.h"
#include "device/write_executor.h"
#include "device/write_meaning.h"

#include <algorithm>

namespace device {
using base::ErrorCode;

namespace {
constexpr base::EnumName<WriteOutcome> outcomeNames[]{
    {WriteOutcome::Kept, "kept"},         {WriteOutcome::Temporary, "temporary"},
    {WriteOutcome::Mismatch, "mismatch"}, {WriteOutcome::Refused, "refused"},
    {WriteOutcome::NotSent, "not-sent"},  {WriteOutcome::NoReply, "no-answer"},
    {WriteOutcome::Unknown, "unknown"},
};
} // namespace

QString outcomeName(WriteOutcome outcome)
{
    return base::nameOf(outcomeNames, outcome);
}

WriteOutcome outcomeBeforeSending(const base::Error& why)
{
    return why.code == ErrorCode::Refused ? WriteOutcome::Refused : WriteOutcome::NotSent;
}

bool WriteReport::isSuccessful() const
{
    const bool written = std::all_of(writes.begin(), writes.end(), [](const WriteResult& result) {
        return !result.error &&
               (result.outcome == WriteOutcome::Kept || result.outcome == WriteOutcome::Temporary);
    });
    return written && lock != LockState::Open && lock != LockState::Unknown;
}

std::vector<base::ItemResult> WriteReport::itemResults() const
{
    std::vector<base::ItemResult> ends;
    for (const WriteResult& result : writes)
        ends.push_back({result.key, result.readBack, outcomeName(result.outcome)});
    return ends;
}

namespace {
base::Intent intentFor(const Servo& servo, const RegisterValues& items, const WriteOptions& options,
                       bool unlocks)
{
    base::Intent intent;
    intent.kind = options.kind;
    intent.temporary = options.temporary;
    intent.lockOpened = unlocks;
    intent.servo = servo.identity();
    for (const RegisterValue& item : items) {
        intent.items.push_back(
            {item.reg->key, item.reg->address, servo.raw(*item.reg).value_or(0), item.raw});
    }
    // A restore without a difference is one whose values the servo itself chose (0x06).
    const bool differs =
        std::any_of(intent.items.begin(), intent.items.end(),
                    [](const base::JournalItem& item) { return item.oldRaw != item.newRaw; });
    if (intent.kind == base::IntentKind::Restore && !differs)
        intent.kind = base::IntentKind::Write;
    return intent;
}
} // namespace

namespace {
/// Reads the old value of everything that will change, and the registers that decide its meaning. A
/// register that cannot be read cannot be proven, and is not written here.
base::Result<void> readBefore(const Context& context, Servo& servo, const RegisterValues& items)
{
    if (const auto fresh = readSettings(context, servo); !fresh)
        return fresh;
    std::vector<const catalog::Register*> unread;
    for (const RegisterValue& item : items) {
        if (!servo.raw(*item.reg))
            unread.push_back(item.reg);
    }
    return read(context, servo, unread);
}

void noteZeroCurrentLimitAfter(const Context& context, const Servo& servo,
                               const RegisterValues& items)
{
    const bool concerned = std::any_of(items.begin(), items.end(), [](const RegisterValue& item) {
        return item.reg->role == catalog::Role::GoalCurrent;
    });
    if (concerned)
        noteZeroCurrentLimit(context, servo);
}

/// Many servos turn torque on with a goal; a user who writes a goal by hand is told so.
void noteEnergized(const Context& context, Servo& servo, const RegisterValues& items,
                   bool torqueWasOff)
{
    const catalog::Register* torque = servo.profile->byRole(catalog::Role::TorqueSwitch);
    const bool motion = std::any_of(items.begin(), items.end(), [](const RegisterValue& item) {
        return classify(*item.reg, item.raw).isMotion();
    });
    if (torque == nullptr || !motion || !torqueWasOff)
        return;
    const auto now = readRegister(context, servo, *torque);
    if (now && *now == 1)
        context.note(NoticeCode::TorqueSwitchedOn, servo.id);
}
} // namespace

base::Result<WriteReport> write(const Context& outer, Servo& servo,
                                const std::vector<WriteItem>& items, const WriteOptions& options)
{
    auto checked = checkItems(servo, items, options);
    if (!checked)
        return tl::unexpected(checked.error());
    const Owned owned = own(outer, {servo.id});
    const Context& context = owned.context;
    if (const auto may = beginWriting(owned, servo, QStringLiteral("write")); !may)
        return tl::unexpected(may.error());
    if (const auto fresh = readBefore(context, servo, *checked); !fresh)
        return tl::unexpected(fresh.error());
    if (const auto valid = checkValues(context, servo, *checked, options.allowPreviousValues);
        !valid)
        return tl::unexpected(valid.error());
    if (const auto allowed = requireConsent(servo, *checked, options.consent); !allowed)
        return tl::unexpected(allowed.error());
    const auto change = modeChange(servo, *checked);
    if (change) {
        if (const auto quiet = addZeroCommand(servo, *checked); !quiet)
            return tl::unexpected(quiet.error());
        if (const auto kept = savePositionSpeed(context, servo, *change); !kept)
            return tl::unexpected(kept.error());
    }
    if (const auto kept = saveLimits(context, servo, *checked); !kept)
        return tl::unexpected(kept.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, QStringLiteral("write"), {}, servo.id);

    WriteExecutor run(context, servo, *checked, options);
    run.setModeChange(change);
    const bool unlocks = run.concernsLock() && !options.temporary;
    const auto uuid = context.journal.begin(intentFor(servo, *checked, options, unlocks));
    if (!uuid)
        return tl::unexpected(uuid.error());
    const bool torqueWasOff = servo.raw(catalog::Role::TorqueSwitch) == 0;
    WriteReport report = run.run();
    noteEnergized(context, servo, *checked, torqueWasOff);
    noteZeroCurrentLimitAfter(context, servo, *checked);
    if (!run.finished()) {
        report.openIntent = *uuid;
        return report;
    }
    const QString outcome =
        report.isSuccessful() ? QStringLiteral("done") : QStringLiteral("failed");
    if (!context.record(*uuid, servo.id, {outcome, {}, report.itemResults()}))
        report.openIntent = *uuid;
    return report;
}
} // namespace device
