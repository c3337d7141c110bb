// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_recovery.h"

#include "device/persistence.h"
#include "device/reader.h"

#include <algorithm>

namespace jobs {
namespace {
base::Result<void> recoverByUuid(const device::Context& context, const QString& uuid)
{
    const auto seen = recover(context, RecoveryAction::Preview, {IntentPorts::This, uuid, {}});
    if (!seen)
        return tl::unexpected(seen.error());
    if (seen->empty())
        return {};
    const Finding finding = seen->front().before.finding;
    if (finding == Finding::NoReply || finding == Finding::OtherServo ||
        finding == Finding::Unreadable)
        return {};
    const auto done =
        recover(context, finding == Finding::AllOld ? RecoveryAction::Undo : RecoveryAction::Finish,
                {IntentPorts::This, uuid, {}});
    if (!done)
        return tl::unexpected(done.error());
    if (!done->empty() && done->front().error)
        return tl::unexpected(*done->front().error);
    return {};
}

bool isSameKind(const base::ServoIdentity& one, const snapshot::SnapshotServo& other)
{
    catalog::Identity identity;
    identity.firmwareMajor = one.firmwareMajor;
    identity.firmwareMinor = one.firmwareMinor;
    identity.modelMajor = one.modelMajor;
    identity.modelMinor = one.modelMinor;
    identity.protocol = one.protocol;
    return other.protocol == base::protocolName(one.protocol) &&
           other.modelId == identity.modelId() && other.firmware == identity.firmware();
}

bool setsId(const base::Intent& intent, int id)
{
    return intent.kind == base::IntentKind::SetId && !intent.items.empty() &&
           intent.items.front().newRaw == id;
}

/// Both times are of this computer. Later, another servo of the kind may have got another ID.
bool isForServo(const device::Context& context, const base::Intent& intent,
                const results::PendingCommission& pending)
{
    if (intent.servo.port != context.bus.portName() || intent.at < pending.at ||
        !isSameKind(intent.servo, pending.servo))
        return false;
    if (intent.servo.id == pending.newId || setsId(intent, pending.newId))
        return true;
    return intent.servo.id == pending.servo.id && intent.kind != base::IntentKind::SetId;
}

bool opensLock(const device::Context& context, const base::Intent& intent,
               const results::PendingCommission& pending)
{
    return intent.lockOpened && isForServo(context, intent, pending);
}

bool wasInitiallyLocked(const device::Servo& servo, const results::PendingCommission& pending)
{
    const auto table = snapshot::loadSnapshot(pending.snapshot);
    const catalog::Register* lock = servo.profile->byRole(catalog::Role::Lock);
    const auto* then = table && lock != nullptr ? table->find(lock->key) : nullptr;
    return then != nullptr && then->raw && !device::isLockOpen(*then->raw);
}
} // namespace

base::Result<void> recoverOpenIntents(const device::Context& context,
                                      const results::PendingCommission& pending)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    for (const base::Intent& intent : *open) {
        if (!isForServo(context, intent, pending))
            continue;
        if (const auto recovered = recoverByUuid(context, intent.uuid); !recovered)
            return recovered;
    }
    return {};
}

bool hasOpenIntent(const device::Context& context, const results::PendingCommission& pending)
{
    const auto open = context.journal.open();
    return open && std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
               return isForServo(context, intent, pending);
           });
}

void updateLockStates(const device::Context& context, std::vector<results::PendingCommission>& all)
{
    if (all.empty())
        return;
    const auto open = context.journal.open();
    if (!open)
        return; // the last known states stay
    for (results::PendingCommission& one : all)
        one.lockOpen = std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
            return opensLock(context, intent, one);
        });
}

bool hasLeftLockOpen(const device::Context& context, device::Servo& servo,
                     const results::PendingCommission& pending)
{
    const auto open = context.journal.open();
    const bool ours =
        open && std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
            return opensLock(context, intent, pending) &&
                   (intent.servo.id == servo.id || setsId(intent, servo.id));
        });
    if (!ours || !wasInitiallyLocked(servo, pending) ||
        !device::readRoles(context, servo, {catalog::Role::Lock}))
        return false;
    const auto lock = servo.raw(catalog::Role::Lock);
    return lock && device::isLockOpen(*lock);
}
} // namespace jobs
