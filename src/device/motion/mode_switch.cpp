// SPDX-License-Identifier: GPL-3.0-or-later
// A mode switch as a whole: planned once, for the preview and for the switch itself.
#include "device/motion/mode.h"
#include "device/motion/motion.h"
#include "device/temporary_values.h"
#include "device/transactions.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
/// The source of the angle limits of the new mode.
enum class Limits : std::uint8_t { Unchanged, Zero, Remembered, Factory };

struct SwitchPlan {
    const catalog::Mode* target = nullptr;
    std::vector<WriteItem> items; ///< both limits in one write, then the mode
    Limits limits = Limits::Unchanged;
};

base::Result<void> addLimits(const Context& context, const Servo& servo, SwitchPlan& change)
{
    const catalog::Mode& target = *change.target;
    const catalog::Register* min = servo.profile->byRole(Role::MinAngle);
    const catalog::Register* max = servo.profile->byRole(Role::MaxAngle);
    if (min == nullptr || max == nullptr)
        return {};
    const bool zeroNow = servo.raw(*min) == 0 && servo.raw(*max) == 0;
    if (target.limitsZero && !zeroNow) {
        change.items = {{min->key, 0}, {max->key, 0}};
        change.limits = Limits::Zero;
    }
    if (target.limitsZero || !zeroNow || target.command != Role::GoalPosition)
        return {};
    const auto kept = context.journal.servoValues(servo.identity(), savedLimitsName());
    if (!kept)
        return tl::unexpected(kept.error());
    const bool known = kept->has_value() && (*kept)->size() == 2;
    const std::int64_t low = known ? (**kept)[0] : min->defaultRaw.value_or(0);
    const std::int64_t high =
        known ? (**kept)[1] : max->defaultRaw.value_or(servo.profile->stepsPerTurn - 1);
    change.items = {{min->key, low}, {max->key, high}};
    change.limits = known ? Limits::Remembered : Limits::Factory;
    return {};
}

/// The servo is in the mode, but perhaps until power-off only: the registers that select the mode
/// are written once more.
base::Result<void> addTemporary(const Context& context, const Servo& servo, SwitchPlan& change)
{
    const auto temporary = temporaryValues(context.journal, servo);
    if (!temporary)
        return tl::unexpected(temporary.error());
    const auto mustRewrite = [&](const catalog::Register* reg) {
        return reg != nullptr && mayBeTemporary(*temporary, reg->key, servo.raw(*reg));
    };
    const catalog::Register* min = servo.profile->byRole(Role::MinAngle);
    const catalog::Register* max = servo.profile->byRole(Role::MaxAngle);
    if (change.target->limitsZero && (mustRewrite(min) || mustRewrite(max)) && change.items.empty())
        change.items = {{min->key, 0}, {max->key, 0}};
    const catalog::Register* mode = servo.profile->byRole(Role::OperatingMode);
    if (change.target->operatingMode && mustRewrite(mode))
        change.items.push_back({mode->key, *change.target->operatingMode});
    return {};
}

/// Reads the settings, writes nothing. No items: the servo is in that mode, and keeps it.
base::Result<SwitchPlan> planSwitch(const Context& context, Servo& servo, const QString& modeKey)
{
    SwitchPlan change;
    change.target = servo.profile->mode(modeKey);
    if (change.target == nullptr) {
        QStringList known;
        for (const catalog::Mode& mode : servo.profile->modes)
            known.append(mode.key);
        return tl::unexpected(base::Error{ErrorCode::NotSupported, QStringLiteral("mode"),
                                          known.join(QStringLiteral(", ")), servo.id});
    }
    if (const auto done = readSettings(context, servo); !done)
        return tl::unexpected(done.error());
    if (const auto done = addLimits(context, servo, change); !done)
        return tl::unexpected(done.error());
    const catalog::Register* mode = servo.profile->byRole(Role::OperatingMode);
    const auto& number = change.target->operatingMode;
    if (mode != nullptr && number && servo.raw(*mode) != *number) {
        change.items.push_back({mode->key, *number});
        return change;
    }
    if (const auto done = addTemporary(context, servo, change); !done)
        return tl::unexpected(done.error());
    return change;
}
} // namespace

base::Result<WriteReport> switchMode(const Context& context, Servo& servo, const QString& modeKey)
{
    const auto change = planSwitch(context, servo, modeKey);
    if (!change)
        return tl::unexpected(change.error());
    if (change->items.empty()) {
        context.note(NoticeCode::AlreadySet, servo.id, modeKey);
        WriteReport nothing;
        nothing.id = servo.id;
        return nothing;
    }
    if (change->limits == Limits::Remembered || change->limits == Limits::Factory) {
        context.note(change->limits == Limits::Remembered ? NoticeCode::LimitsRestored
                                                          : NoticeCode::LimitsSetToDefault,
                     servo.id, {}, change->items[0].raw, change->items[1].raw);
    }
    // The request for the mode is the consent: this procedure removes the danger of register 33.
    WriteOptions options;
    options.consent = Consent::byTask();
    options.kind = base::IntentKind::Mode;
    auto report = write(context, servo, change->items, options);
    // Without a reading of the torque switch, torque off is not proven.
    const bool settled = report && std::none_of(report->writes.begin(), report->writes.end(),
                                                [](const auto& one) { return one.error; });
    if (settled && servo.raw(Role::TorqueSwitch) == 0)
        context.note(NoticeCode::TorqueStaysOff, servo.id);
    return report;
}

base::Result<ModePlan> planMode(const Context& context, Servo& servo, const QString& modeKey)
{
    const auto change = planSwitch(context, servo, modeKey);
    if (!change)
        return tl::unexpected(change.error());
    ModePlan plan;
    plan.from = servo.mode() != nullptr ? servo.mode()->key : QString();
    plan.to = modeKey;
    plan.limitsRestored = change->limits == Limits::Remembered;
    plan.limitsSetToDefault = change->limits == Limits::Factory;
    plan.limitsSaved = change->limits == Limits::Zero;
    for (const WriteItem& item : change->items)
        plan.writes.push_back({item.key, servo.raw(item.key), item.raw});
    if (change->items.empty())
        return plan;
    plan.torqueGoesOff = servo.raw(Role::TorqueSwitch).value_or(0) != 0;
    const Role command = commandZeroedBySwitch(servo, {servo.mode(), change->target});
    if (const catalog::Register* reg = servo.profile->byRole(command))
        plan.zeroed = reg->key;
    return plan;
}
} // namespace device
