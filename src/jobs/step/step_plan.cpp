// SPDX-License-Identifier: GPL-3.0-or-later
// From what the user asked for to a sweep between two places.
#include "device/motion/move_limits.h"
#include "device/motion/turn_count.h"
#include "device/write_meaning.h"
#include "jobs/motion_check.h"
#include "jobs/step/step_response.h"
#include "jobs/sweep/sweep_axis.h"
#include "jobs/sweep/sweep_path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace jobs {
using base::Duration;
using base::ErrorCode;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
const QString stepPlanOperation = QStringLiteral("step");

/// Readings of every response are kept.
constexpr int maxRepeats = 50;
constexpr Duration maxHold = 10s;

constexpr Duration minHold = 500ms;
constexpr Duration stepSettleTime = 400ms; ///< to evaluate swings and rest

/// Where no speed is known: half a turn a second, which slow servos do, and a start.
constexpr double assumedTurnsPerSecond = 0.5;
constexpr Duration assumedStartTime = 300ms;
constexpr Duration holdStep = 100ms;

constexpr double minStepTolerance = 3;
constexpr double shortStepTolerance = 0.1; ///< of short steps, where the usual one is too wide

constexpr std::array loopRoles{Role::PositionP,  Role::PositionD,   Role::PositionI,
                               Role::SpeedP,     Role::SpeedI,      Role::StartupForce,
                               Role::CwDeadZone, Role::CcwDeadZone, Role::IntegralLimit};

class StepPlanner {
public:
    StepPlanner(const device::Context& context, device::Servo& servo, const results::StepSpec& spec)
        : m_context(context)
        , m_servo(servo)
        , m_spec(spec)
    {}

    base::Result<StepPlan> plan();

private:
    tl::unexpected<base::Error> refuse(ErrorCode code, const QString& detail) const
    {
        const catalog::Register* goal = m_servo.profile->byRole(Role::GoalPosition);
        return tl::unexpected(base::Error{code, stepPlanOperation, detail, m_servo.id,
                                          goal != nullptr ? goal->key : QString()});
    }
    base::Result<std::int64_t> goalRaw(const QString& text) const;
    base::Result<std::int64_t> currentGoalRaw();
    base::Result<void> planPositions();
    base::Result<std::int64_t> startWithRoom(std::int64_t size);
    void planSpeeds();
    base::Result<void> planHold();

    const device::Context& m_context;
    device::Servo& m_servo;
    const results::StepSpec& m_spec;
    StepPlan m_plan;
};

/// In the units of the goal register.
base::Result<std::int64_t> StepPlanner::goalRaw(const QString& text) const
{
    const catalog::Register& goal = *m_servo.profile->byRole(Role::GoalPosition);
    const auto raw = catalog::parseValue(text, goal, m_servo.meaning(goal));
    if (raw)
        return *raw;
    base::Error error = raw.error();
    error.operation = stepPlanOperation;
    error.id = m_servo.id;
    error.registerKey = goal.key;
    return tl::unexpected(error);
}

/// Where it stands, as a goal.
base::Result<std::int64_t> StepPlanner::currentGoalRaw()
{
    if (const auto fresh = device::readRoles(m_context, m_servo, {Role::PresentPosition}); !fresh)
        return tl::unexpected(fresh.error());
    const auto present = m_servo.raw(Role::PresentPosition);
    const bool turns = device::goalKind(m_servo) == device::GoalKind::Turns;
    if (!present || (turns && !device::turnBasis(m_servo).countsTurns))
        return refuse(ErrorCode::TurnsUnknown, QStringLiteral("from"));
    const catalog::Register& goal = *m_servo.profile->byRole(Role::GoalPosition);
    const double factor =
        goal.scaleBy.isEmpty()
            ? 1.0
            : double(std::max<std::int64_t>(1, m_servo.raw(goal.scaleBy).value_or(1)));
    return std::llround(double(*present) / factor);
}

/// Where it stands, or as near to that as leaves room for the step.
base::Result<std::int64_t> StepPlanner::startWithRoom(std::int64_t size)
{
    const auto present = currentGoalRaw();
    if (!present)
        return present;
    const auto range = device::goalRange(m_servo);
    if (!range)
        return *present;
    if (std::abs(size) > range->max - range->min) {
        return refuse(ErrorCode::OutOfRange,
                      QStringLiteral("%1 … %2").arg(range->min).arg(range->max));
    }
    return std::clamp(*present, range->min - std::min<std::int64_t>(0, size),
                      range->max - std::max<std::int64_t>(0, size));
}

base::Result<void> StepPlanner::planPositions()
{
    const auto size = goalRaw(m_spec.size);
    if (!size)
        return tl::unexpected(size.error());
    if (*size == 0)
        return refuse(ErrorCode::BadArgument, QStringLiteral("no-size"));
    const auto from = m_spec.from.isEmpty() ? startWithRoom(*size) : goalRaw(m_spec.from);
    if (!from)
        return tl::unexpected(from.error());
    m_plan.sweep.range = {QString::number(*from), QString::number(*from + *size)};
    return {};
}

/// As fast as possible unless the user sets a limit: a slower step hides the control loop.
void StepPlanner::planSpeeds()
{
    const device::MoveFieldSet fields = device::moveFields(m_servo);
    m_plan.sweep.speed = m_spec.speed;
    m_plan.sweep.acceleration = m_spec.acceleration;
    if (m_spec.acceleration.isEmpty() && fields.acceleration)
        m_plan.sweep.acceleration = QStringLiteral("0");
    if (!m_spec.speed.isEmpty() || !fields.speed)
        return;
    const auto maxSpeed = device::maxGoalSpeed(m_servo);
    if (maxSpeed)
        m_plan.sweep.speed = QString::number(*maxSpeed);
    else if (device::zeroSpeed(m_servo) == device::ZeroSpeed::Fastest)
        m_plan.sweep.speed = QStringLiteral("0");
}

base::Result<void> StepPlanner::planHold()
{
    const double way = std::abs(m_plan.to - m_plan.from);
    const double turns = way / jobs::stepsPerTurn(m_servo);
    const Duration needed = m_plan.travel.value_or(
        assumedStartTime + Duration(std::llround(turns / assumedTurnsPerSecond * 1e6)));
    if (m_spec.hold < Duration::zero() || m_spec.hold > maxHold)
        return refuse(ErrorCode::BadArgument, QStringLiteral("no-hold"));
    const Duration proposed = std::max(minHold, 2 * needed + stepSettleTime);
    m_plan.hold = m_spec.hold > Duration::zero()
                      ? m_spec.hold
                      : std::min(maxHold, (proposed + holdStep - 1us) / holdStep * holdStep);
    m_plan.isHoldTooShort = way > 0 && m_plan.travel && m_plan.hold < *m_plan.travel + minHold / 2;
    m_plan.sweep.pause = m_plan.hold;
    return {};
}

base::Result<StepPlan> StepPlanner::plan()
{
    if (const auto fresh = device::readSettings(m_context, m_servo); !fresh)
        return tl::unexpected(fresh.error());
    const QString fastest = QStringLiteral("max_speed_limit");
    if (m_servo.profile->find(fastest) != nullptr) {
        if (const auto known = device::readKeys(m_context, m_servo, {fastest}); !known)
            return tl::unexpected(known.error());
    }
    if (!isInPositionMode(m_servo))
        return tl::unexpected(notInPositionMode(stepPlanOperation, m_servo));
    if (m_spec.repeats < 1 || m_spec.repeats > maxRepeats)
        return refuse(ErrorCode::BadArgument, QStringLiteral("no-repeats"));
    if (const auto planned = planPositions(); !planned)
        return tl::unexpected(planned.error());
    planSpeeds();
    m_plan.sweep.cycles = m_spec.repeats;
    m_plan.sweep.pause = minHold; // until it is known
    auto axis = sweepAxis(m_context, m_servo, m_plan.sweep, m_plan.limits);
    if (!axis)
        return tl::unexpected(axis.error());
    m_plan.from = axis->from;
    m_plan.to = axis->to;
    const double way = std::abs(axis->to - axis->from);
    m_plan.limits.tolerance = std::clamp(shortStepTolerance * way, minStepTolerance,
                                         std::max(minStepTolerance, axis->tolerance));
    m_plan.travel = travelTime(way, *axis);
    if (const auto held = planHold(); !held)
        return tl::unexpected(held.error());
    m_plan.sweep.operatorName = m_spec.operatorName;
    m_plan.sweep.note = m_spec.note;
    return m_plan;
}
} // namespace

base::Result<StepPlan> planStep(const device::Context& context, device::Servo& servo,
                                const results::StepSpec& spec)
{
    return StepPlanner(context, servo, spec).plan();
}

std::vector<const catalog::Register*> loopRegisters(const catalog::Profile& profile)
{
    std::vector<const catalog::Register*> found;
    for (const Role role : loopRoles) {
        const catalog::Register* reg = profile.byRole(role);
        // Factory rows take a consent that a trial does not ask for.
        if (reg != nullptr && reg->writable() && !device::alwaysNeedsConsent(*reg))
            found.push_back(reg);
    }
    return found;
}
} // namespace jobs
