// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/recover.h"

#include "device/motion.h"
#include "device/persistence.h"
#include "device/talk.h"
#include "jobs/change.h"
#include "jobs/recover_look.h"

#include <map>

namespace jobs {
using base::ErrorCode;
using base::IntentKind;

namespace {
struct Outcome {
    base::Result<void> result;
    std::optional<device::WriteReport> report;
};

/// The values the action asks for, split into those still to be written and those already there.
struct Todo {
    std::vector<device::WriteItem> write;
    std::vector<device::WriteItem> reassert;
};

Todo todo(const base::Intent& intent, const device::Servo& servo, RecoverAction action)
{
    Todo items;
    for (const base::JournalItem& item : intent.items) {
        const catalog::Register* reg = servo.profile->find(item.key);
        const auto present = reg != nullptr ? servo.raw(*reg) : std::nullopt;
        if (!present || !concernsRecovery(intent, *reg) || !reg->writable())
            continue;
        // What calibration and restore lead to is not known beforehand: finishing takes what is.
        const std::int64_t finished = newValuesKnown(intent) ? item.newRaw : *present;
        const bool forward = action == RecoverAction::Finish && !onlyBack(intent);
        const std::int64_t wanted = forward ? finished : item.oldRaw;
        (present == wanted ? items.reassert : items.write).push_back({item.key, wanted});
    }
    return items;
}

Outcome asOutcome(base::Result<device::WriteReport> written)
{
    if (!written)
        return {tl::unexpected(written.error()), {}};
    if (written->allGood())
        return {{}, *written};
    for (const device::WriteResult& result : written->writes) {
        if (result.error)
            return {tl::unexpected(*result.error), *written};
    }
    return {base::fail(ErrorCode::LockOpen, QStringLiteral("recover"), {}, written->id), *written};
}

Outcome writeItems(const device::Context& context, const base::Intent& intent, device::Servo& servo,
                   const std::vector<device::WriteItem>& items, RecoverAction action)
{
    const int target = items.empty() ? 0 : static_cast<int>(items.front().raw);
    if (items.empty())
        return {};
    if (intent.kind == IntentKind::SetId)
        return asOutcome(changeId(context, servo, target));
    if (intent.kind == IntentKind::SetBaud) {
        const catalog::Register* reg = servo.profile->byRole(catalog::Role::BaudRate);
        for (const catalog::NamedValue& value : reg->values) {
            if (value.value == target)
                return asOutcome(changeBaud(context, servo, value.key.toInt()));
        }
        return {base::fail(ErrorCode::OutOfRange, QStringLiteral("recover"), {}, servo.id), {}};
    }
    device::WriteOptions options;
    options.dangerous = true; // consent was given when the intent was made
    options.temporary = intent.temporary;
    options.asBefore = action == RecoverAction::Undo || onlyBack(intent);
    return asOutcome(device::write(context, servo, items, options));
}

bool changesMode(const base::Intent& intent, const device::Servo& servo)
{
    for (const base::JournalItem& item : intent.items) {
        const catalog::Register* reg = servo.profile->find(item.key);
        if (reg != nullptr &&
            (reg->role == catalog::Role::OperatingMode || reg->role == catalog::Role::MinAngle ||
             reg->role == catalog::Role::MaxAngle))
            return true;
    }
    return false;
}

/// What is kept by means of the lock of this area, written once more with the lock open.
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
        const auto again = device::writeVerified(context, servo, registerOf(item), item->raw);
        if (!again)
            return again;
    }
    const device::LockState lock = eprom->close();
    if (lock == device::LockState::Closed && eprom->stayedOpen())
        return {};
    return base::fail(ErrorCode::LockOpen, QStringLiteral("recover"), {}, servo.id);
}

base::Result<void> reassertSaved(const device::Context& context, device::Servo& servo,
                                 const catalog::Register& reg, std::int64_t raw)
{
    if (const auto again = device::writeVerified(context, servo, reg, raw); !again)
        return again;
    const auto saved = device::save(context, servo, reg);
    if (saved)
        context.note(device::NoticeCode::SavedPerSheet, servo.id, reg.key);
    return saved;
}

/// A value that reads right may stand in RAM only, if the servo restarted in the middle of the
/// write. Written once more, with the lock open or saved, it is certainly kept.
base::Result<void> reassert(const device::Context& context, const base::Intent& intent,
                            device::Servo& servo, const std::vector<device::WriteItem>& items)
{
    if (intent.temporary)
        return {};
    std::map<catalog::Area, std::vector<const device::WriteItem*>> locked;
    for (const device::WriteItem& item : items) {
        const catalog::Register& reg = *servo.profile->find(item.key);
        const device::Keeping keeping = device::keepingOf(reg);
        if (keeping == device::Keeping::Lock)
            locked[reg.area].push_back(&item);
        else if (keeping != device::Keeping::Save)
            continue;
        else if (const auto saved = reassertSaved(context, servo, reg, item.raw); !saved)
            return saved;
    }
    for (const auto& [area, those] : locked) {
        if (const auto again = reassertLocked(context, servo, those); !again)
            return again;
    }
    return {};
}

/// Brings the registers to the wanted side, then the lock, and proves both.
Outcome settle(const device::Context& context, const base::Intent& intent, device::Servo& servo,
               RecoverAction action)
{
    const Todo items = todo(intent, servo, action);
    Outcome outcome = writeItems(context, intent, servo, items.write, action);
    if (outcome.result)
        outcome.result = reassert(context, intent, servo, items.reassert);
    if (outcome.result && changesMode(intent, servo))
        outcome.result = device::quieten(context, servo);
    const device::LockState lock = device::closeLock(context, servo);
    if (outcome.result && lock != device::LockState::Closed && lock != device::LockState::None) {
        outcome.result = tl::unexpected(
            base::Error{ErrorCode::LockOpen, QStringLiteral("recover"), {}, servo.id});
    }
    return outcome;
}

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
            if (ready.error().code == ErrorCode::LinkLost)
                return tl::unexpected(ready.error());
            recovered.error = ready.error();
            return recovered;
        }
    }
    Outcome outcome = settle(context, intent, servo, action);
    recovered.report = std::move(outcome.report);
    if (!outcome.result) {
        if (outcome.result.error().code == ErrorCode::LinkLost)
            return tl::unexpected(outcome.result.error());
        recovered.error = outcome.result.error();
        return recovered;
    }
    if (before->lockOpen.value_or(false))
        context.note(device::NoticeCode::LockClosed, servo.id);
    const QString word = action == RecoverAction::Finish && intent.kind != IntentKind::Trial
                             ? QStringLiteral("done")
                             : QStringLiteral("undone");
    if (const auto ended = context.journal.end(intent.uuid, {word, QString()}); !ended)
        return tl::unexpected(ended.error());
    recovered.done = true;
    return recovered;
}
} // namespace

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
        all.push_back(std::move(*one));
    }
    return all;
}
} // namespace jobs
