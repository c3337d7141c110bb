// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/enum_names.h"
#include "device/motion/motion.h"
#include "device/reader.h"
#include "jobs/change/clear_alarm.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using device::NoticeCode;

namespace {
const QString alarmPlanOperation = QStringLiteral("clear-alarm");
/// Phase bit 4: the position feedback counts whole turns.
constexpr std::int64_t fullAngleBit = 1 << 4;
/// The way back from a stall, as a share of a turn: 5°.
constexpr std::int64_t backOffDivisor = 72;

/// Protocol sheet §7: the measured value of each alarm, and how it is released.
struct Rule {
    QLatin1StringView key;
    ClearMethod release;
    Role measured;
    Role min;
    Role max;
};
constexpr std::array rules{
    Rule{QLatin1StringView("overload"), ClearMethod::BackOff, Role::PresentLoad, Role::None,
         Role::None},
    Rule{QLatin1StringView("current"), ClearMethod::NewGoal, Role::PresentCurrent, Role::None,
         Role::ProtectionCurrent},
    Rule{QLatin1StringView("voltage"), ClearMethod::Wait, Role::PresentVoltage, Role::MinVoltage,
         Role::MaxVoltage},
    Rule{QLatin1StringView("temperature"), ClearMethod::Wait, Role::PresentTemperature, Role::None,
         Role::MaxTemperature},
    Rule{QLatin1StringView("sensor"), ClearMethod::PowerCycle, Role::None, Role::None, Role::None},
};

Alarm makeAlarm(const device::Servo& servo, const QString& key)
{
    Alarm alarm{key};
    for (const Rule& rule : rules) {
        if (rule.key != key)
            continue;
        alarm.release = rule.release;
        const auto raw = [&servo](Role role) {
            return role == Role::None ? std::nullopt : servo.raw(role);
        };
        if (rule.measured != Role::None && servo.profile->byRole(rule.measured) != nullptr)
            alarm.measured = servo.profile->byRole(rule.measured)->key;
        alarm.value = raw(rule.measured);
        alarm.min = raw(rule.min);
        alarm.max = raw(rule.max);
    }
    return alarm;
}

std::vector<Alarm> reportedAlarms(const device::Servo& servo)
{
    std::vector<Alarm> alarms;
    const catalog::Register* status = servo.profile->byRole(Role::Status);
    for (int bit = 0; bit < 8; ++bit) {
        if ((servo.status >> bit & 1) == 0)
            continue;
        QString key = QStringLiteral("bit%1").arg(bit);
        if (status != nullptr) {
            const auto named = std::find_if(status->values.begin(), status->values.end(),
                                            [bit](const auto& one) { return one.value == bit; });
            key = named != status->values.end() ? named->key : key;
        }
        alarms.push_back(makeAlarm(servo, key));
    }
    return alarms;
}

std::vector<Alarm> allAlarms(const device::Servo& servo)
{
    std::vector<Alarm> alarms = reportedAlarms(servo);
    for (const device::Notice& notice : device::derivedAlarms(servo)) {
        const bool heat = notice.code == NoticeCode::DerivedTemperature;
        alarms.push_back(
            makeAlarm(servo, heat ? QStringLiteral("temperature") : QStringLiteral("voltage")));
        alarms.back().derived = true;
    }
    return alarms;
}

/// A register with a bit for each fault.
std::int64_t faultResetBits(const device::Servo& servo, const std::vector<Alarm>& alarms)
{
    const catalog::Register* reset = servo.profile->byRole(Role::FaultReset);
    std::int64_t bits = 0;
    if (reset == nullptr)
        return bits;
    for (const catalog::NamedValue& bit : reset->values) {
        const bool raised = std::any_of(alarms.begin(), alarms.end(),
                                        [&](const Alarm& alarm) { return alarm.key == bit.key; });
        if (raised)
            bits |= std::int64_t(1) << bit.value;
    }
    return bits;
}

/// Alarms that keep torque off come before those that a goal releases; a goal away from the stall
/// releases an overcurrent as well.
ClearMethod nextMethod(const std::vector<Alarm>& alarms)
{
    for (const ClearMethod release :
         {ClearMethod::PowerCycle, ClearMethod::Wait, ClearMethod::BackOff, ClearMethod::NewGoal,
          ClearMethod::Unknown}) {
        const bool isPresent = std::any_of(alarms.begin(), alarms.end(), [&](const Alarm& alarm) {
            return alarm.release == release;
        });
        if (isPresent)
            return release;
    }
    return ClearMethod::None;
}

std::int64_t sign(std::int64_t value)
{
    return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

/// Towards larger positions: 1. The goal shows the direction; at the goal, the load does, which is
/// positive where the servo drives towards smaller positions (sheet §6.1).
std::int64_t stallDirection(const device::Servo& servo, std::int64_t goal, std::int64_t present,
                            std::int64_t backOff)
{
    constexpr std::int64_t driving = 50; // 5 %
    const std::int64_t load = servo.raw(Role::PresentLoad).value_or(0);
    if (std::abs(goal - present) > backOff / 8)
        return sign(goal - present);
    return std::abs(load) >= driving ? -sign(load) : 0;
}

tl::unexpected<base::Error> refuse(const device::Servo& servo, const char* why)
{
    return base::fail(ErrorCode::NotSupported, alarmPlanOperation, QString::fromLatin1(why),
                      servo.id);
}

/// The goal a little away from the stall, in steps as the goal register counts them.
base::Result<void> planBackOff(const device::Servo& servo, AlarmPlan& plan)
{
    const catalog::Mode* mode = servo.mode();
    const auto present = servo.raw(Role::PresentPosition);
    const auto goal = servo.raw(Role::GoalPosition);
    if (mode == nullptr || !present || !goal || mode->command != Role::GoalPosition ||
        mode->key == QLatin1StringView("step"))
        return refuse(servo, "release-mode");
    const bool fullAngle = (servo.raw(Role::Phase).value_or(0) & fullAngleBit) != 0;
    if (mode->limitsZero && !fullAngle)
        return base::fail(ErrorCode::TurnsUnknown, alarmPlanOperation, {}, servo.id);
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    const std::int64_t backOff =
        std::max<std::int64_t>(servo.profile->stepsPerTurn / backOffDivisor, 4);
    const std::int64_t stall = stallDirection(servo, *goal * factor, *present, backOff);
    if (stall == 0)
        return refuse(servo, "release-direction");
    std::int64_t target = *present - stall * backOff;
    const auto min = servo.raw(Role::MinAngle);
    const auto max = servo.raw(Role::MaxAngle);
    if (!mode->limitsZero && min && max && *min < *max)
        target = std::clamp(target, *min, *max);
    if (sign(target - *present) != -stall || std::abs(target - *present) > 2 * backOff)
        return refuse(servo, "release-limit");
    plan.from = *present / factor;
    plan.to = target / factor;
    return {};
}

base::Result<void> readAlarmState(const device::Context& context, device::Servo& servo)
{
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return fresh;
    return device::readRoles(context, servo,
                             {Role::Status, Role::PresentPosition, Role::PresentLoad,
                              Role::PresentVoltage, Role::PresentTemperature,
                              Role::PresentCurrent});
}

constexpr base::EnumName<ClearMethod> clearMethodNames[]{
    {ClearMethod::None, "nothing"},     {ClearMethod::BackOff, "turn-back"},
    {ClearMethod::NewGoal, "new-goal"}, {ClearMethod::FaultReset, "fault-reset"},
    {ClearMethod::Wait, "wait"},        {ClearMethod::PowerCycle, "power-cycle"},
    {ClearMethod::Unknown, "unknown"},
};
} // namespace

QString clearMethodName(ClearMethod release)
{
    return base::nameOf(clearMethodNames, release);
}

base::Result<AlarmPlan> planClearAlarm(const device::Context& outer, device::Servo& servo)
{
    if (!servo.profile)
        return base::fail(ErrorCode::UnknownModel, alarmPlanOperation, {}, servo.id);
    const device::Owned owned = device::own(outer, {servo.id});
    if (const auto read = readAlarmState(owned.context, servo); !read)
        return tl::unexpected(read.error());
    AlarmPlan plan;
    plan.alarms = allAlarms(servo);
    plan.next = nextMethod(plan.alarms);
    plan.torqueOff = servo.raw(Role::TorqueSwitch).value_or(0) != 1;
    plan.faultResetBits = faultResetBits(servo, plan.alarms);
    if (plan.faultResetBits != 0) {
        plan.next = ClearMethod::FaultReset;
    } else if (plan.next == ClearMethod::BackOff) {
        if (const auto back = planBackOff(servo, plan); !back)
            plan.refused = back.error();
    } else if (plan.next == ClearMethod::NewGoal) {
        plan.from = plan.to = servo.raw(Role::PresentPosition);
    }
    return plan;
}
} // namespace jobs
