// SPDX-License-Identifier: GPL-3.0-or-later
// From what the user asked for to a sweep between two places.
#include "device/move_limits.h"
#include "device/turn_count.h"
#include "jobs/step_response.h"
#include "jobs/sweep_axis.h"
#include "jobs/sweep_path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace jobs {
using base::Duration;
using base::ErrorCode;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
const QString operation = QStringLiteral("step");

/// Readings of every response are kept.
constexpr int mostRepeats = 50;
constexpr Duration longestHold = 10s;

constexpr Duration leastHold = 500ms;
constexpr Duration calmAfter = 400ms; ///< what swings and rest are judged by

/// Where no speed is known: half a turn a second, which slow servos do, and a start.
constexpr double slowTurns = 0.5;
constexpr Duration slowStart = 300ms;
constexpr Duration holdUnit = 100ms;

constexpr double leastTolerance = 3;
constexpr double toleranceOfStep = 0.1; ///< of short steps, where the usual one is too wide

constexpr std::array loopRoles{Role::PositionP,  Role::PositionD,   Role::PositionI,
                               Role::SpeedP,     Role::SpeedI,      Role::StartupForce,
                               Role::CwDeadZone, Role::CcwDeadZone, Role::IntegralLimit};

class Planner {
public:
    Planner(const device::Context& context, device::Servo& servo, const record::StepSpec& spec)
        : m_context(context)
        , m_servo(servo)
        , m_spec(spec)
    {}

    base::Result<StepPlan> plan();

private:
    tl::unexpected<base::Error> refuse(ErrorCode code, const QString& detail) const
    {
        const catalog::Register* goal = m_servo.profile->byRole(Role::GoalPosition);
        return tl::unexpected(base::Error{code, operation, detail, m_servo.id,
                                          goal != nullptr ? goal->key : QString()});
    }
    base::Result<std::int64_t> goalRaw(const QString& text) const;
    base::Result<std::int64_t> here();
    base::Result<void> takePlaces();
    base::Result<std::int64_t> placeWithRoom(std::int64_t size);
    void takeRates();
    base::Result<void> takeHold();

    const device::Context& m_context;
    device::Servo& m_servo;
    const record::StepSpec& m_spec;
    StepPlan m_plan;
};

/// In the units of the goal register.
base::Result<std::int64_t> Planner::goalRaw(const QString& text) const
{
    const catalog::Register& goal = *m_servo.profile->byRole(Role::GoalPosition);
    const auto raw = catalog::parseValue(text, goal, m_servo.meaning(goal));
    if (raw)
        return *raw;
    base::Error error = raw.error();
    error.operation = operation;
    error.id = m_servo.id;
    error.registerKey = goal.key;
    return tl::unexpected(error);
}

/// Where it stands, as a goal.
base::Result<std::int64_t> Planner::here()
{
    if (const auto fresh = device::readRoles(m_context, m_servo, {Role::PresentPosition}); !fresh)
        return tl::unexpected(fresh.error());
    const auto present = m_servo.raw(Role::PresentPosition);
    const bool turns = device::goalKind(m_servo) == device::GoalKind::Turns;
    if (!present || (turns && !device::turnBasis(m_servo).countsItself))
        return refuse(ErrorCode::TurnsUnknown, QStringLiteral("from"));
    const catalog::Register& goal = *m_servo.profile->byRole(Role::GoalPosition);
    const double factor =
        goal.scaleBy.isEmpty()
            ? 1.0
            : double(std::max<std::int64_t>(1, m_servo.raw(goal.scaleBy).value_or(1)));
    return std::llround(double(*present) / factor);
}

/// Where it stands, or as near to that as leaves room for the step.
base::Result<std::int64_t> Planner::placeWithRoom(std::int64_t size)
{
    const auto present = here();
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

base::Result<void> Planner::takePlaces()
{
    const auto size = goalRaw(m_spec.size);
    if (!size)
        return tl::unexpected(size.error());
    if (*size == 0)
        return refuse(ErrorCode::BadArgument, QStringLiteral("no-size"));
    const auto from = m_spec.from.isEmpty() ? placeWithRoom(*size) : goalRaw(m_spec.from);
    if (!from)
        return tl::unexpected(from.error());
    m_plan.sweep.range = {QString::number(*from), QString::number(*from + *size)};
    return {};
}

/// As fast as it may, unless somebody wants it otherwise: what slows a step down hides its loop.
void Planner::takeRates()
{
    const device::MoveFieldSet fields = device::moveFields(m_servo);
    m_plan.sweep.speed = m_spec.speed;
    m_plan.sweep.acceleration = m_spec.acceleration;
    if (m_spec.acceleration.isEmpty() && fields.acceleration)
        m_plan.sweep.acceleration = QStringLiteral("0");
    if (!m_spec.speed.isEmpty() || !fields.speed)
        return;
    const auto most = device::topSpeed(m_servo);
    if (most)
        m_plan.sweep.speed = QString::number(*most);
    else if (device::zeroSpeed(m_servo) == device::ZeroSpeed::Fastest)
        m_plan.sweep.speed = QStringLiteral("0");
}

base::Result<void> Planner::takeHold()
{
    const double way = std::abs(m_plan.to - m_plan.from);
    const double turns = way / jobs::stepsPerTurn(m_servo);
    const Duration needed =
        m_plan.travel.value_or(slowStart + Duration(std::llround(turns / slowTurns * 1e6)));
    if (m_spec.hold < Duration::zero() || m_spec.hold > longestHold)
        return refuse(ErrorCode::BadArgument, QStringLiteral("no-hold"));
    const Duration proposed = std::max(leastHold, 2 * needed + calmAfter);
    m_plan.hold = m_spec.hold > Duration::zero()
                      ? m_spec.hold
                      : std::min(longestHold, (proposed + holdUnit - 1us) / holdUnit * holdUnit);
    m_plan.holdShort = way > 0 && m_plan.travel && m_plan.hold < *m_plan.travel + leastHold / 2;
    m_plan.sweep.pause = m_plan.hold;
    return {};
}

base::Result<StepPlan> Planner::plan()
{
    if (const auto fresh = device::readSettings(m_context, m_servo); !fresh)
        return tl::unexpected(fresh.error());
    const QString fastest = QStringLiteral("max_speed_limit");
    if (m_servo.profile->find(fastest) != nullptr) {
        if (const auto known = device::readKeys(m_context, m_servo, {fastest}); !known)
            return tl::unexpected(known.error());
    }
    const auto kind = device::goalKind(m_servo);
    if (kind != device::GoalKind::Position && kind != device::GoalKind::Turns) {
        const catalog::Mode* mode = m_servo.mode();
        return tl::unexpected(base::Error{ErrorCode::NotSupported, operation,
                                          QStringLiteral("not-position"), m_servo.id,
                                          mode != nullptr ? mode->key : QString()});
    }
    if (m_spec.repeats < 1 || m_spec.repeats > mostRepeats)
        return refuse(ErrorCode::BadArgument, QStringLiteral("no-repeats"));
    if (const auto placed = takePlaces(); !placed)
        return tl::unexpected(placed.error());
    takeRates();
    m_plan.sweep.cycles = m_spec.repeats;
    m_plan.sweep.pause = leastHold; // until it is known
    auto axis = sweepAxis(m_context, m_servo, m_plan.sweep, m_plan.limits);
    if (!axis)
        return tl::unexpected(axis.error());
    m_plan.from = axis->from;
    m_plan.to = axis->to;
    const double way = std::abs(axis->to - axis->from);
    m_plan.limits.tolerance = std::clamp(toleranceOfStep * way, leastTolerance,
                                         std::max(leastTolerance, axis->tolerance));
    m_plan.travel = travelTime(way, *axis);
    if (const auto held = takeHold(); !held)
        return tl::unexpected(held.error());
    m_plan.sweep.operatorName = m_spec.operatorName;
    m_plan.sweep.note = m_spec.note;
    return m_plan;
}
} // namespace

base::Result<StepPlan> planStep(const device::Context& context, device::Servo& servo,
                                const record::StepSpec& spec)
{
    return Planner(context, servo, spec).plan();
}

std::vector<const catalog::Register*> stepRegisters(const catalog::Profile& profile)
{
    std::vector<const catalog::Register*> found;
    for (const Role role : loopRoles) {
        const catalog::Register* reg = profile.byRole(role);
        // Factory rows take a consent that a trial does not ask for.
        if (reg != nullptr && reg->writable() && !reg->dangerous)
            found.push_back(reg);
    }
    return found;
}
} // namespace jobs
