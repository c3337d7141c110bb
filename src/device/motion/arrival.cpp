// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/motion.h"
#include "device/transactions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
constexpr base::Duration readInterval = std::chrono::milliseconds(20);
/// The moving flag of a servo that has just got its goal may not be up yet.
constexpr base::Duration minWaitTime = std::chrono::milliseconds(100);
constexpr int minQuietReadings = 3;
/// The flag stays down when the new goal equals the old one, and a slow goal may run ahead of the
/// shaft until friction gives way. Far from its goal a servo counts as at rest after this time
/// without motion.
constexpr int minStuckReadings = 50;
/// Friction leaves 2–8 steps without I (error-diagnosis row 14) and a heavy arm sags further; more
/// than this share of the family's stepsPerTurn (64 of 4096, 15 of 1000) means that something is in
/// the way.
constexpr std::int64_t toleranceFraction = 64;

struct Waiting {
    MovePlan* plan = nullptr;
    int quiet = 0; ///< readings in a row without motion
    std::optional<std::int64_t> position{};
};

base::Result<void> pollServo(const Context& context, Waiting& waiting,
                             const std::function<void(const MoveProgress&)>& onSample)
{
    Servo& servo = *waiting.plan->servo;
    const auto done =
        readRoles(context, servo, {Role::PresentPosition, Role::Moving, Role::Status});
    if (!done)
        return done;
    const bool hasFlag = servo.profile->byRole(Role::Moving) != nullptr;
    const bool flag = servo.raw(Role::Moving).value_or(0) != 0;
    const auto position = servo.raw(Role::PresentPosition);
    // The last step of the encoder flickers.
    const bool moved = position && waiting.position && std::abs(*position - *waiting.position) > 1;
    if (moved || !waiting.position)
        waiting.position = position;
    waiting.quiet = flag || moved ? 0 : waiting.quiet + 1;
    if (onSample) {
        onSample({servo.id, servo.physical(Role::PresentPosition), hasFlag ? flag : moved,
                  servo.status});
    }
    return {};
}

/// Without a flag, a slow move may rest between two readings as long as its own time runs.
bool isTravelTimeLeft(const Waiting& waiting, base::Duration elapsed)
{
    const MovePlan& plan = *waiting.plan;
    const bool hasFlag = plan.servo->profile->byRole(Role::Moving) != nullptr;
    return !hasFlag && elapsed < plan.travelTime;
}

/// Ending the wait does not end the motion, which is noted.
base::Result<void> stopError(const Context& context, const std::vector<Waiting>& waiting,
                             base::Duration elapsed)
{
    for (const Waiting& one : waiting) {
        if (one.quiet == 0 || isTravelTimeLeft(one, elapsed))
            context.note(NoticeCode::StillMoving, one.plan->servo->id);
    }
    return base::fail(ErrorCode::Stopped, QStringLiteral("arrive"));
}

base::Result<void> checkArrived(const MovePlan& plan)
{
    const auto missed = goalDeviation(*plan.servo, plan.goalRaw, plan.relative);
    if (!missed)
        return {};
    return tl::unexpected(base::Error{ErrorCode::Refused, QStringLiteral("arrive"),
                                      QString::number(*missed), plan.servo->id});
}

/// The motion of the servos is not known any more; none of them is stopped.
base::Result<void> lostError(const Context& context, const std::vector<Waiting>& waiting,
                             base::Duration elapsed, base::Error why)
{
    constexpr std::int64_t unconfirmed = 1;
    for (const Waiting& one : waiting) {
        const bool isAtRest = !isTravelTimeLeft(one, elapsed) && one.quiet >= minQuietReadings;
        // An emergency stop has taken its torque off.
        if (why.code != ErrorCode::Preempted && !(isAtRest && checkArrived(*one.plan)))
            context.note(NoticeCode::StillMoving, one.plan->servo->id, {}, unconfirmed);
    }
    return tl::unexpected(std::move(why));
}
} // namespace

std::optional<std::int64_t> goalDeviation(const Servo& servo, std::int64_t goalRaw, bool relative)
{
    const auto present = servo.raw(Role::PresentPosition);
    const catalog::Mode* mode = servo.mode();
    if (!present || mode == nullptr)
        return std::nullopt;
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    std::int64_t rest = *present;
    if (!relative) {
        rest = *present - goalRaw * factor;
        // Several turns away the feedback may show one turn only.
        if (mode->limitsZero)
            rest = std::llround(
                std::remainder(static_cast<double>(rest), servo.profile->stepsPerTurn));
    }
    if (std::abs(rest) <= servo.profile->stepsPerTurn / toleranceFraction * factor)
        return std::nullopt;
    return rest;
}

base::Result<void> waitForArrival(const Context& context, std::vector<MovePlan>& plans,
                                  base::Duration limit,
                                  const std::function<void(const MoveProgress&)>& onSample)
{
    base::Clock& clock = context.bus.clock();
    const base::Duration start = clock.now();
    std::vector<Waiting> waiting;
    for (MovePlan& plan : plans)
        waiting.push_back({&plan, 0});
    for (;;) {
        for (Waiting& one : waiting) {
            if (const auto seen = pollServo(context, one, onSample); !seen)
                return lostError(context, waiting, clock.now() - start, seen.error());
        }
        const base::Duration elapsed = clock.now() - start;
        const bool quiet = std::all_of(waiting.begin(), waiting.end(), [&](const Waiting& one) {
            return !isTravelTimeLeft(one, elapsed) &&
                   one.quiet >= (checkArrived(*one.plan) ? minQuietReadings : minStuckReadings);
        });
        if (quiet && elapsed >= minWaitTime)
            break;
        if (elapsed > limit)
            return base::fail(ErrorCode::Refused, QStringLiteral("arrive"), QStringLiteral("time"));
        if (!context.bus.pauseUntil(clock.now() + readInterval, &context.stop))
            return stopError(context, waiting, elapsed);
    }
    for (const MovePlan& plan : plans) {
        addAlarmNotices(context, *plan.servo);
        if (const auto arrived = checkArrived(plan); !arrived)
            return arrived;
    }
    return {};
}
} // namespace device
