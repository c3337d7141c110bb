// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/mode.h"

#include "device/consent.h"
#include "device/motion/motion.h"
#include "device/motion/saved_speed.h"
#include "device/transactions.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;

QString savedLimitsName()
{
    return QStringLiteral("limits");
}

std::optional<ModeChange> modeChange(const Servo& servo, const RegisterValues& items)
{
    const catalog::Mode* from = servo.mode();
    const catalog::Mode* to =
        modeFor(*servo.profile, valueAfter(servo, items, Role::OperatingMode),
                valueAfter(servo, items, Role::MinAngle), valueAfter(servo, items, Role::MaxAngle));
    if (to == nullptr || to == from)
        return std::nullopt;
    return ModeChange{from, to};
}

bool sharesFrameWithMode(const catalog::Profile& profile, Role command)
{
    const catalog::Register* mode = profile.byRole(Role::OperatingMode);
    const catalog::Register* reg = profile.byRole(command);
    return mode != nullptr && reg != nullptr && mode->block && mode->block == reg->block;
}

base::Result<void> addZeroCommand(const Servo& servo, RegisterValues& items)
{
    const std::size_t given = items.size();
    for (const catalog::Mode& mode : servo.profile->modes) {
        if (!sharesFrameWithMode(*servo.profile, mode.command))
            continue;
        const catalog::Register* reg = servo.profile->byRole(mode.command);
        const auto same =
            std::find_if(items.begin(), items.end(),
                         [reg](const RegisterValue& item) { return item.reg == reg; });
        if (same == items.end())
            items.push_back({reg, 0});
        else if (same->raw != 0) {
            return tl::unexpected(base::Error{ErrorCode::NotSupported, QStringLiteral("write"),
                                              QStringLiteral("mode-first"), servo.id, reg->key});
        }
    }
    if (items.size() == given)
        return {};
    std::sort(items.begin(), items.end(), [](const RegisterValue& a, const RegisterValue& b) {
        return a.reg->writeOffset < b.reg->writeOffset;
    });
    return {};
}

base::Result<void> saveLimits(const Context& context, const Servo& servo,
                              const RegisterValues& items)
{
    if (!removesAngleLimits(servo, items))
        return {};
    const std::int64_t min = servo.raw(Role::MinAngle).value_or(0);
    const std::int64_t max = servo.raw(Role::MaxAngle).value_or(0);
    const auto kept =
        context.journal.saveServoValues(servo.identity(), savedLimitsName(), {min, max});
    if (kept)
        context.note(NoticeCode::LimitsSaved, servo.id, {}, min, max);
    return kept;
}

base::Result<void> savePositionSpeed(const Context& context, const Servo& servo,
                                     const ModeChange& change)
{
    const auto speed = servo.raw(Role::GoalSpeed);
    const bool positionBefore =
        change.from != nullptr && change.from->command == Role::GoalPosition;
    if (positionBefore && change.to->command == Role::GoalSpeed && speed &&
        !sharesFrameWithMode(*servo.profile, Role::GoalSpeed))
        return context.journal.saveServoValues(servo.identity(), savedSpeedName(), {*speed});
    return {};
}

base::Result<void> torqueOff(const Context& context, Servo& servo)
{
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    if (torque == nullptr)
        return {};
    const auto present = readRegister(context, servo, *torque);
    if (!present) {
        writeUnverified(context, servo, *torque, 0, present.error());
        return tl::unexpected(present.error());
    }
    if (*present == 0)
        return {};
    auto torqueResult = writeVerified(context, servo, *torque, 0);
    if (!torqueResult) {
        torqueResult.error().operation = QStringLiteral("torque-off");
        return torqueResult;
    }
    context.note(NoticeCode::TorqueSwitchedOff, servo.id);
    return {};
}

namespace {
base::Result<void> zeroCommand(const Context& context, Servo& servo, Role command)
{
    const catalog::Register* reg = servo.profile->byRole(command);
    if (reg == nullptr)
        return {};
    const auto present = readRegister(context, servo, *reg);
    if (!present)
        return tl::unexpected(present.error());
    if (*present == 0)
        return {};
    const auto zeroed = writeVerified(context, servo, *reg, 0);
    if (zeroed)
        context.note(NoticeCode::CommandZeroed, servo.id, reg->key);
    return zeroed;
}
} // namespace

namespace {
/// The register that limits the current in most modes is the command of others (HLS 44). Back in a
/// mode that has it as the limit, it gets the value the servo itself would start with.
base::Result<void> restoreCurrent(const Context& context, Servo& servo)
{
    const catalog::Register* limit = servo.profile->byRole(Role::GoalCurrent);
    const auto start = servo.raw(Role::ProtectionCurrent);
    if (limit == nullptr || !start)
        return {};
    const auto restored = writeVerified(context, servo, *limit, *start);
    if (restored)
        context.note(NoticeCode::CurrentRestored, servo.id, limit->key, *start);
    return restored;
}
} // namespace

namespace {
Role commandBefore(const ModeChange& change)
{
    return change.from != nullptr ? change.from->command : Role::None;
}

/// The command whose present value must not act in the new mode; None: there is none.
Role commandToZero(const ModeChange& change)
{
    const Role after = change.to->command;
    const Role before = commandBefore(change);
    if (after != Role::GoalPosition)
        return after;
    const bool harmless =
        before == Role::GoalPosition || before == Role::GoalSpeed || before == Role::GoalCurrent;
    return harmless ? Role::None : before;
}
} // namespace

Role commandZeroedBySwitch(const Servo& servo, const ModeChange& change)
{
    for (const catalog::Mode& mode : servo.profile->modes) {
        if (sharesFrameWithMode(*servo.profile, mode.command))
            return mode.command;
    }
    return commandToZero(change);
}

std::vector<WriteItem> extraWritesOfSwitch(const Servo& servo, const std::vector<WriteItem>& items)
{
    RegisterValues values;
    for (const WriteItem& item : items) {
        if (const catalog::Register* reg = servo.profile->find(item.key))
            values.push_back({reg, item.raw});
    }
    const auto change = modeChange(servo, values);
    if (!change)
        return {};
    std::vector<WriteItem> writes;
    const catalog::Register* limit = servo.profile->byRole(Role::GoalCurrent);
    const auto start = valueAfter(servo, values, Role::ProtectionCurrent);
    if (commandBefore(*change) == Role::GoalCurrent && change->to->command != Role::GoalCurrent &&
        limit != nullptr && start && servo.raw(*limit) != *start)
        writes.push_back({limit->key, *start});
    const catalog::Register* command = servo.profile->byRole(commandZeroedBySwitch(servo, *change));
    if (command != nullptr && servo.raw(*command) != 0)
        writes.push_back({command->key, 0});
    return writes;
}

base::Result<void> finishModeSwitch(const Context& context, Servo& servo, const ModeChange& change)
{
    const Role after = change.to->command;
    const Role before = commandBefore(change);
    base::Result<void> done;
    if (before == Role::GoalCurrent && after != Role::GoalCurrent)
        done = restoreCurrent(context, servo);
    if (!done)
        return done;
    if (const Role command = commandToZero(change); command != Role::None)
        done = zeroCommand(context, servo, command);
    // The speed may have been zeroed several modes ago.
    if (done && after == Role::GoalPosition && before != Role::GoalPosition)
        done = restoreSpeed(context, servo, before);
    if (!done)
        return done;
    // Writing a command may have turned torque on.
    return torqueOff(context, servo);
}

void noteZeroCurrentLimit(const Context& context, const Servo& servo)
{
    const catalog::Register* limit = servo.profile->byRole(Role::GoalCurrent);
    const catalog::Mode* mode = servo.mode();
    if (limit != nullptr && mode != nullptr && mode->command != Role::GoalCurrent &&
        servo.raw(*limit) == 0)
        context.note(NoticeCode::CurrentLimitZero, servo.id, limit->key);
}

base::Result<void> torqueOffAndZero(const Context& context, Servo& servo)
{
    if (const auto torqueResult = torqueOff(context, servo); !torqueResult)
        return torqueResult;
    if (const auto fresh = readSettings(context, servo); !fresh)
        return fresh;
    const catalog::Mode* mode = servo.mode();
    if (mode == nullptr)
        return {};
    // An interrupted switch back may have left the limit at the other mode's standstill.
    if (mode->command != Role::GoalCurrent && servo.raw(Role::GoalCurrent) == 0) {
        if (const auto allowed = restoreCurrent(context, servo); !allowed)
            return allowed;
    }
    if (mode->command == Role::GoalPosition)
        return torqueOff(context, servo);
    if (const auto zeroed = zeroCommand(context, servo, mode->command); !zeroed)
        return zeroed;
    return torqueOff(context, servo);
}
} // namespace device
