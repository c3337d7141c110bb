// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/saved_speed.h"

#include "device/transactions.h"

namespace device {
using catalog::Role;

QString savedSpeedName()
{
    return QStringLiteral("position-speed");
}

base::Result<std::optional<std::int64_t>> savedSpeed(const base::Journal& journal,
                                                     const Servo& servo)
{
    const auto kept = journal.servoValues(servo.identity(), savedSpeedName());
    if (!kept)
        return tl::unexpected(kept.error());
    if (servo.profile->byRole(Role::GoalSpeed) == nullptr || !kept->has_value() ||
        (*kept)->size() != 1 || sharesFrameWithMode(*servo.profile, Role::GoalSpeed))
        return std::nullopt;
    return (*kept)->front();
}

namespace {
/// Directly after a mode that commands the speed, any other value belongs to that mode as well.
bool isOfAnotherMode(std::optional<std::int64_t> present, std::int64_t remembered, Role before)
{
    return present != remembered && (present.value_or(0) == 0 || before == Role::GoalSpeed);
}
} // namespace

std::optional<WriteItem> restoredSpeed(const Servo& servo, const std::vector<WriteItem>& items,
                                       std::optional<std::int64_t> remembered)
{
    RegisterValues values;
    for (const WriteItem& item : items) {
        if (const catalog::Register* reg = servo.profile->find(item.key))
            values.push_back({reg, item.raw});
    }
    const auto change = modeChange(servo, values);
    const catalog::Register* speed = servo.profile->byRole(Role::GoalSpeed);
    if (!change || !remembered || speed == nullptr || change->to->command != Role::GoalPosition)
        return std::nullopt;
    const Role before = change->from != nullptr ? change->from->command : Role::None;
    if (before == Role::GoalPosition || !isOfAnotherMode(servo.raw(*speed), *remembered, before))
        return std::nullopt;
    return WriteItem{speed->key, *remembered};
}

base::Result<void> restoreSpeed(const Context& context, Servo& servo, Role before)
{
    const auto remembered = savedSpeed(context.journal, servo);
    if (!remembered)
        return tl::unexpected(remembered.error());
    if (!*remembered)
        return {};
    const catalog::Register* reg = servo.profile->byRole(Role::GoalSpeed);
    const auto present = readRegister(context, servo, *reg);
    if (!present)
        return tl::unexpected(present.error());
    if (!isOfAnotherMode(*present, **remembered, before))
        return {};
    const auto restored = writeVerified(context, servo, *reg, **remembered);
    if (restored)
        context.note(NoticeCode::SpeedRestored, servo.id, reg->key, **remembered);
    return restored;
}
} // namespace device
