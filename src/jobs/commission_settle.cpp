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

bool sameKind(const base::ServoIdentity& one, const record::SnapshotServo& other)
{
    catalog::Identity who;
    who.firmwareMajor = one.firmwareMajor;
    who.firmwareMinor = one.firmwareMinor;
    who.modelMajor = one.modelMajor;
    who.modelMinor = one.modelMinor;
    who.protocol = one.protocol;
    return other.protocol == base::protocolName(one.protocol) && other.modelId == who.modelId() &&
           other.firmware == who.firmware();
}

bool givesId(const base::Intent& intent, int id)
{
    return intent.kind == base::IntentKind::SetId && !intent.items.empty() &&
           intent.items.front().newRaw == id;
}

/// Both times are of this computer. Another servo of the kind may have come since, for another ID.
bool concerns(const device::Context& context, const base::Intent& intent,
              const record::CommissionPending& begun)
{
    if (intent.servo.port != context.bus.portName() || intent.at < begun.at ||
        !sameKind(intent.servo, begun.servo))
        return false;
    if (intent.servo.id == begun.newId || givesId(intent, begun.newId))
        return true;
    return intent.servo.id == begun.servo.id && intent.kind != base::IntentKind::SetId;
}

bool opensLock(const device::Context& context, const base::Intent& intent,
               const record::CommissionPending& begun)
{
    return intent.lockOpened && concerns(context, intent, begun);
}

bool cameLocked(const device::Servo& servo, const record::CommissionPending& begun)
{
    const auto table = record::loadSnapshot(begun.snapshot);
    const catalog::Register* lock = servo.profile->byRole(catalog::Role::Lock);
    const auto* then = table && lock != nullptr ? table->find(lock->key) : nullptr;
    return then != nullptr && then->raw && !device::isOpen(*then->raw);
}
} // namespace

base::Result<void> settleIntents(const device::Context& context,
                                 const record::CommissionPending& begun)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    for (const base::Intent& intent : *open) {
        if (!concerns(context, intent, begun))
            continue;
        if (const auto settled = settleOne(context, intent.uuid); !settled)
            return settled;
    }
    return {};
}

bool owesChange(const device::Context& context, const record::CommissionPending& begun)
{
    const auto open = context.journal.open();
    return open && std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
               return concerns(context, intent, begun);
           });
}

void updateLocks(const device::Context& context, std::vector<record::CommissionPending>& all)
{
    if (all.empty())
        return;
    const auto open = context.journal.open();
    if (!open)
        return; // as it was known last
    for (record::CommissionPending& one : all)
        one.lockOpen = std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
            return opensLock(context, intent, one);
        });
}

bool leftOpen(const device::Context& context, device::Servo& servo,
              const record::CommissionPending& begun)
{
    const auto open = context.journal.open();
    const bool ours =
        open && std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
            return opensLock(context, intent, begun) &&
                   (intent.servo.id == servo.id || givesId(intent, servo.id));
        });
    if (!ours || !cameLocked(servo, begun) ||
        !device::readRoles(context, servo, {catalog::Role::Lock}))
        return false;
    const auto lock = servo.raw(catalog::Role::Lock);
    return lock && device::isOpen(*lock);
}
} // namespace jobs
