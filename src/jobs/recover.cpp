// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/recover.h"

#include "jobs/recover_look.h"
#include "jobs/recover_settle.h"

namespace jobs {
using base::ErrorCode;
using base::IntentKind;

namespace {
/// Of a snapshot's rows each is known by itself; of others the whole is.
std::vector<base::ItemEnd> itemEnds(const base::Intent& intent, const Recovered& recovered,
                                    const QString& word)
{
    if (!isSnapshotRestore(intent) || !recovered.report)
        return {};
    std::vector<base::ItemEnd> ends = recovered.report->itemEnds();
    for (base::ItemEnd& end : ends)
        end.outcome = word == QLatin1String("undone") ? word : end.outcome;
    return ends;
}

/// A restore leaves torque off, also one that is ended later.
void noteTorque(const device::Context& context, const Recovered& one)
{
    if (one.torqueIsOff)
        context.note(device::NoticeCode::TorqueStaysOff, one.before.foundId);
}
} // namespace

base::Result<Recovered> recoverOne(const device::Context& context, const base::Intent& intent,
                                   RecoverAction action, const BeforeWrite& beforeWrite)
{
    Recovered recovered;
    device::Servo servo;
    const auto before = look(context, intent, servo);
    if (!before)
        return tl::unexpected(before.error());
    recovered.before = *before;
    if (action == RecoverAction::Look)
        return recovered;
    if (before->finding == Finding::NoAnswer || before->finding == Finding::OtherServo) {
        recovered.error = base::Error{
            before->finding == Finding::NoAnswer ? ErrorCode::NoAnswer : ErrorCode::IdentityDiffers,
            QStringLiteral("recover"),
            {},
            intent.servo.id};
        return recovered;
    }
    if (beforeWrite) {
        if (const auto ready = beforeWrite(context, servo); !ready) {
            recovered.error = ready.error();
            return recovered;
        }
    }
    Settled settled = settle(context, intent, servo, action);
    recovered.report = std::move(settled.report);
    recovered.torqueIsOff = settled.torqueIsOff;
    if (!settled.result) {
        recovered.error = settled.result.error();
        return recovered;
    }
    if (before->lockOpen.value_or(false))
        context.note(device::NoticeCode::LockClosed, servo.id);
    const QString word = action == RecoverAction::Finish && intent.kind != IntentKind::Trial
                             ? QStringLiteral("done")
                             : QStringLiteral("undone");
    if (const auto ended =
            context.journal.end(intent.uuid, {word, {}, itemEnds(intent, recovered, word)});
        !ended)
        return tl::unexpected(ended.error());
    recovered.done = true;
    return recovered;
}

base::Result<std::vector<Recovered>> recover(const device::Context& outer, RecoverAction action,
                                             const RecoverOptions& options)
{
    const auto open = outer.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    std::vector<Recovered> all;
    const int baudBefore = context.bus.baud();
    for (const base::Intent& intent : *open) {
        if (!options.anyPort && intent.servo.port != context.bus.portName())
            continue;
        if (!options.uuid.isEmpty() && intent.uuid != options.uuid)
            continue;
        if (context.stop.requested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("recover"));
        auto one = recoverOne(context, intent, action, options.beforeWrite);
        if (context.bus.hasBaud()) // also after an error: whoever comes next counts on it
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
