// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/change/clear_alarm.h"

#include "device/motion/motion.h"
#include "device/write_access.h"
#include "jobs/change/change_steps.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
const QString clearAlarmOperation = QStringLiteral("clear-alarm");
constexpr base::Duration moveTimeout = 2s;
constexpr base::Duration clearTimeout = 1s;
constexpr base::Duration pollInterval = 50ms;

bool movesForward(const AlarmPlan& plan)
{
    return plan.to.value_or(0) > plan.from.value_or(0);
}

base::Result<void> checkConsent(const device::Servo& servo, const AlarmPlan& now,
                                const std::optional<AlarmPlan>& approved)
{
    const auto refuse = [&](const QString& detail) {
        return base::fail(ErrorCode::NeedsConsent, clearAlarmOperation, detail, servo.id);
    };
    if (!now.needsConsent())
        return {};
    if (!approved || !approved->needsConsent())
        return refuse(now.next == ClearMethod::BackOff ? QStringLiteral("release-moves")
                                                       : QStringLiteral("release-energises"));
    const bool otherWay =
        now.next == ClearMethod::BackOff && movesForward(now) != movesForward(*approved);
    if (approved->next != now.next || otherWay)
        return refuse(QStringLiteral("alarm-changed"));
    return {};
}

base::Result<void> backOffFromStall(const device::Context& context, device::Servo& servo,
                                    const AlarmPlan& plan)
{
    device::MoveCommand order;
    order.servo = &servo;
    order.goal = QString::number(*plan.to);
    auto move = device::planMove(context, order);
    if (!move)
        return tl::unexpected(move.error());
    std::vector<device::MovePlan> moves{*move};
    if (const auto sent = device::sendMoves(context, moves, device::MoveMethod::Write); !sent)
        return sent;
    // Arrival does not matter: the bit of the alarm decides afterwards.
    const auto arrived = device::waitForArrival(context, moves, moveTimeout, {});
    if (!arrived && (arrived.error().code == ErrorCode::LinkLost ||
                     arrived.error().code == ErrorCode::Preempted))
        return arrived;
    return {};
}

/// Its present position, or standstill, as a new command. A tripped servo has released its shaft.
base::Result<void> setNewGoal(const device::Context& context, device::Servo& servo,
                              const AlarmPlan& plan)
{
    return plan.torqueOff ? device::setTorque(context, servo, device::Torque::On)
                          : device::halt(context, servo);
}

/// A reset gives the motor its full force again, so the goal is set to the present position first.
base::Result<void> resetFaults(const device::Context& context, device::Servo& servo,
                               const AlarmPlan& plan)
{
    if (!plan.torqueOff) {
        if (const auto held = device::halt(context, servo); !held)
            return held;
    }
    device::WriteOptions options;
    options.consent = device::Consent::byTask();
    const catalog::Register& reset = *servo.profile->byRole(Role::FaultReset);
    const auto report = device::write(context, servo, {{reset.key, plan.faultResetBits}}, options);
    if (!report)
        return tl::unexpected(report.error());
    for (const device::WriteResult& result : report->writes) {
        if (result.error)
            return tl::unexpected(*result.error);
    }
    return {};
}

base::Result<void> execute(const device::Context& context, device::Servo& servo,
                           const AlarmPlan& plan)
{
    switch (plan.next) {
    case ClearMethod::BackOff:
        return backOffFromStall(context, servo, plan);
    case ClearMethod::NewGoal:
        return setNewGoal(context, servo, plan);
    case ClearMethod::FaultReset:
        return resetFaults(context, servo, plan);
    default:
        return {};
    }
}

/// Moves note the cause of an alarm, as it was before this alarm was released.
void dropStaleNotices(device::Notices& notices, std::size_t since)
{
    const auto stale = [](const device::Notice& notice) {
        using device::NoticeCode;
        return notice.code == NoticeCode::OverloadActive ||
               notice.code == NoticeCode::OvercurrentActive ||
               notice.code == NoticeCode::VoltageAlarmActive ||
               notice.code == NoticeCode::TemperatureAlarmActive ||
               notice.code == NoticeCode::SensorAlarmActive;
    };
    notices.erase(
        std::remove_if(notices.begin() + static_cast<std::ptrdiff_t>(since), notices.end(), stale),
        notices.end());
}

bool needsAction(const AlarmPlan& plan)
{
    return plan.next == ClearMethod::BackOff || plan.next == ClearMethod::NewGoal ||
           plan.next == ClearMethod::FaultReset;
}

/// The bit may clear a moment after its cause.
base::Result<AlarmPlan> waitUntilCleared(const device::Context& context, device::Servo& servo,
                                         const AlarmPlan& before)
{
    base::Clock& clock = context.bus.clock();
    const base::Duration end = clock.now() + clearTimeout;
    for (;;) {
        auto after = planClearAlarm(context, servo);
        const bool same = after && after->next == before.next;
        if (!same || clock.now() >= end || context.stop.isRequested())
            return after;
        clock.sleepFor(pollInterval);
    }
}
} // namespace

base::Result<AlarmReport> clearAlarm(const device::Context& outer, device::Servo& servo,
                                     const std::optional<AlarmPlan>& approved)
{
    if (const auto writable = device::requireWritable(servo, clearAlarmOperation); !writable)
        return tl::unexpected(writable.error());
    const device::Owned owned = device::own(outer, {servo.id});
    const device::Context& context = owned.context;
    const auto now = planClearAlarm(context, servo);
    if (!now)
        return tl::unexpected(now.error());
    if (now->refused)
        return tl::unexpected(*now->refused);
    AlarmReport report{*now, *now, false};
    if (!needsAction(*now))
        return report;
    if (const auto allowed = checkConsent(servo, *now, approved); !allowed)
        return tl::unexpected(allowed.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, clearAlarmOperation, {}, servo.id);
    if (const auto may = device::beginWriting(context, servo, clearAlarmOperation); !may)
        return tl::unexpected(may.error());
    const std::size_t noticesBefore = context.notices.size();
    if (const auto done = execute(context, servo, *now); !done)
        return tl::unexpected(done.error());
    // Remaining alarms are in the report.
    dropStaleNotices(context.notices, noticesBefore);
    report.isExecuted = true;
    const auto after = waitUntilCleared(context, servo, *now);
    if (!after)
        return tl::unexpected(after.error());
    report.after = *after;
    return report;
}
} // namespace jobs
