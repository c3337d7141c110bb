// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission_settle.h"

#include "device/persistence.h"
#include "device/reader.h"

#include <algorithm>

namespace jobs {
namespace {
base::Result<void> settleOne(const device::Context& context, const QString& uuid)
{
    const auto seen = recover(context, RecoverAction::Look, {IntentPorts::This, uuid, {}});
    if (!seen)
        return tl::unexpected(seen.error());
    if (seen->empty())
        return {};
    const Finding finding = seen->front().before.finding;
    if (finding == Finding::NoAnswer || finding == Finding::OtherServo ||
        finding == Finding::Unreadable)
        return {};
    const auto done =
        recover(context, finding == Finding::AllOld ? RecoverAction::Undo : RecoverAction::Finish,
                {IntentPorts::This, uuid, {}});
    if (!done)
        return tl::unexpected(done.error());
    if (!done->empty() && done->front().error)
        return tl::unexpected(*done->front().error);
    return {};
}

/// Both times are of this computer; the batch's is cut to seconds.
bool concerns(const device::Context& context, const base::Intent& intent,
              const device::Servo& servo, const QDateTime& since)
{
    return intent.servo.port == context.bus.portName() && intent.at >= since &&
           intent.servo.sameKind(servo.identity());
}

bool cameLocked(const device::Servo& servo, const record::CommissionPending& begun)
{
    const auto table = record::loadSnapshot(begun.snapshot);
    const catalog::Register* lock = servo.profile->byRole(catalog::Role::Lock);
    const auto* then = table && lock != nullptr ? table->find(lock->key) : nullptr;
    return then != nullptr && then->raw && !device::isOpen(*then->raw);
}
} // namespace

base::Result<void> settleIntents(const device::Context& context, device::Servo& servo,
                                 const QDateTime& since)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    for (const base::Intent& intent : *open) {
        if (!concerns(context, intent, servo, since))
            continue;
        if (const auto settled = settleOne(context, intent.uuid); !settled)
            return settled;
    }
    return {};
}

bool owesChange(const device::Context& context, const device::Servo& servo, const QDateTime& since)
{
    const auto open = context.journal.open();
    return open && std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
               return concerns(context, intent, servo, since);
           });
}

bool leftOpen(const device::Context& context, device::Servo& servo,
              const record::CommissionPending& begun)
{
    const auto open = context.journal.open();
    const bool ours =
        open && std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
            return intent.lockOpened && intent.servo.id == servo.id &&
                   concerns(context, intent, servo, begun.at);
        });
    if (!ours || !cameLocked(servo, begun) ||
        !device::readRoles(context, servo, {catalog::Role::Lock}))
        return false;
    const auto lock = servo.raw(catalog::Role::Lock);
    return lock && device::isOpen(*lock);
}
} // namespace jobs
