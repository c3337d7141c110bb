// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_axis.h"

#include "device/motion/move_limits.h"
#include "jobs/motion_check.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using base::Duration;
using base::ErrorCode;
using catalog::Role;
using results::SweepPace;
using results::SweepShape;

namespace {
const QString sweepAxisOperation = QStringLiteral("sweep");

/// Settings that are this fresh are not read again for a goal: nobody else writes to a servo that
/// is being tested.
constexpr Duration maxSettingsAge = std::chrono::hours(24);

/// Friction leaves up to 8 of 4096 steps without I (error-diagnosis row 14); a little more has
/// arrived.
constexpr double defaultToleranceFraction = 12.0 / 4096;
constexpr double minSettleTolerance = 3;

tl::unexpected<base::Error> refuse(ErrorCode code, const device::Servo& servo, QString detail,
                                   QString key = {})
{
    return tl::unexpected(
        base::Error{code, sweepAxisOperation, std::move(detail), servo.id, std::move(key)});
}

double goalFactor(const device::Servo& servo)
{
    const catalog::Register* goal = servo.profile->byRole(Role::GoalPosition);
    const bool scaled = goal != nullptr && !goal->scaleBy.isEmpty();
    return scaled ? double(std::max<std::int64_t>(1, servo.raw(goal->scaleBy).value_or(1))) : 1.0;
}

class AxisBuilder {
public:
    AxisBuilder(const device::Context& context, device::Servo& servo,
                const results::SweepSpec& spec)
        : m_context(context)
        , m_servo(servo)
        , m_spec(spec)
    {}

    base::Result<results::SweepAxis> make(const results::SweepLimits& limits);

private:
    base::Result<void> requirePositionMode();
    base::Result<void> requireTimes() const;
    base::Result<void> parseRange();
    base::Result<void> parseStep();
    base::Result<void> parsePoints();
    base::Result<void> readSpeeds();
    base::Result<void> checkGoalAllowed(double target);
    base::Result<double> parseSteps(const QString& text, bool way = false) const;
    std::optional<double> parseRate(Role role, const QString& text) const;

    const device::Context& m_context;
    device::Servo& m_servo;
    const results::SweepSpec& m_spec;
    results::SweepAxis m_axis;
};

base::Result<void> AxisBuilder::requirePositionMode()
{
    if (isInPositionMode(m_servo))
        return {};
    return tl::unexpected(notInPositionMode(sweepAxisOperation, m_servo));
}

base::Result<void> AxisBuilder::requireTimes() const
{
    const bool waves = m_spec.shape == SweepShape::Sine;
    if (waves && m_spec.period <= Duration::zero())
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("no-period"));
    if (!waves && m_spec.pace == SweepPace::Delay && m_spec.pause <= Duration::zero())
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("no-pause"));
    if (m_spec.cycles <= 0 && m_spec.length <= Duration::zero())
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("no-end"));
    return {};
}

/// A place; or with `way` a distance, which has no zero of its own.
base::Result<double> AxisBuilder::parseSteps(const QString& text, bool way) const
{
    const catalog::Register& goal = *m_servo.profile->byRole(Role::GoalPosition);
    const auto raw = catalog::parseValue(text, goal, m_servo.meaning(goal));
    if (!raw) {
        base::Error error = raw.error();
        error.operation = sweepAxisOperation;
        error.id = m_servo.id;
        error.registerKey = goal.key;
        return tl::unexpected(error);
    }
    const double found = double(*raw) * goalFactor(m_servo);
    return way ? std::abs(found) : found;
}

/// The answer of the device layer to this goal, without sending anything that moves the servo.
base::Result<void> AxisBuilder::checkGoalAllowed(double target)
{
    const device::MoveCommand order = makeSweepMove(m_servo, m_spec, target);
    const auto plan = device::planMove(m_context, order);
    if (!plan)
        return tl::unexpected(plan.error());
    return {};
}

base::Result<void> AxisBuilder::parseRange()
{
    const auto own = m_spec.ranges.find(m_servo.id);
    const results::SweepRange& range = own != m_spec.ranges.end() ? own->second : m_spec.range;
    const auto from = parseSteps(range.from);
    if (!from)
        return tl::unexpected(from.error());
    const auto to = parseSteps(range.to);
    if (!to)
        return tl::unexpected(to.error());
    if (*from == *to)
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("same-ends"));
    m_axis.from = *from;
    m_axis.to = *to;
    for (const double end : {*from, *to}) {
        if (const auto good = checkGoalAllowed(end); !good)
            return good;
    }
    return {};
}

base::Result<void> AxisBuilder::parseStep()
{
    if (m_spec.step.trimmed().startsWith(u'-'))
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("negative-step"));
    const auto step = parseSteps(m_spec.step, true);
    if (!step)
        return tl::unexpected(step.error());
    if (*step == 0)
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("no-step"));
    if (*step > std::abs(m_axis.to - m_axis.from))
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("step-too-long"));
    m_axis.step = *step;
    return {};
}

base::Result<void> AxisBuilder::parsePoints()
{
    if (m_spec.points.size() < 2)
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("no-points"));
    for (const results::SweepPoint& point : m_spec.points) {
        const auto place = parseSteps(point.target);
        if (!place)
            return tl::unexpected(place.error());
        if (const auto good = checkGoalAllowed(*place); !good)
            return good;
        m_axis.points.push_back(*place);
    }
    const auto [low, high] = std::minmax_element(m_axis.points.begin(), m_axis.points.end());
    if (*low == *high)
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("same-ends"));
    m_axis.from = *low;
    m_axis.to = *high;
    return {};
}

/// In steps/s or steps/s²; none: the servo's own limit is not known, or there is none.
std::optional<double> AxisBuilder::parseRate(Role role, const QString& text) const
{
    const catalog::Register* reg = m_servo.profile->byRole(role);
    if (reg == nullptr)
        return std::nullopt;
    const catalog::ValueFormat meaning = m_servo.meaning(*reg);
    std::optional<std::int64_t> raw = m_servo.raw(*reg);
    if (!text.isEmpty()) {
        const auto typed = catalog::parseValue(text, *reg, meaning);
        raw = typed ? std::optional(*typed) : std::nullopt;
    }
    if (!raw || *raw == 0)
        return std::nullopt;
    return toSteps(std::abs(catalog::toPhysical(*raw, meaning)), meaning.unit, m_axis.stepsPerTurn);
}

/// Whether the fields can be written was found out with the first goal.
base::Result<void> AxisBuilder::readSpeeds()
{
    m_axis.speed = parseRate(Role::GoalSpeed, m_spec.speed);
    m_axis.acceleration = parseRate(Role::Acceleration, m_spec.acceleration);
    const auto fastest = device::maxGoalSpeed(m_servo);
    const catalog::Register* speed = m_servo.profile->byRole(Role::GoalSpeed);
    if (fastest && speed != nullptr) {
        const catalog::ValueFormat meaning = m_servo.meaning(*speed);
        const auto top =
            toSteps(catalog::toPhysical(*fastest, meaning), meaning.unit, m_axis.stepsPerTurn);
        if (top && m_axis.speed)
            m_axis.speed = std::min(*m_axis.speed, *top);
    }
    // By time: as fast as the way of a whole leg asks for.
    bool number = false;
    const double ms = m_spec.time.toDouble(&number);
    if (number && ms > 0) {
        m_axis.speed = std::abs(m_axis.to - m_axis.from) / (ms / 1000);
        m_axis.acceleration.reset();
    }
    return {};
}

base::Result<results::SweepAxis> AxisBuilder::make(const results::SweepLimits& limits)
{
    if (const auto fresh = device::readSettings(m_context, m_servo); !fresh)
        return tl::unexpected(fresh.error());
    // Without a given value it moves with its present speed and acceleration.
    const auto rates = device::readRoles(m_context, m_servo, {Role::GoalSpeed, Role::Acceleration});
    if (!rates)
        return tl::unexpected(rates.error());
    m_axis.stepsPerTurn = stepsPerTurn(m_servo);
    if (const auto mode = requirePositionMode(); !mode)
        return tl::unexpected(mode.error());
    if (const auto times = requireTimes(); !times)
        return tl::unexpected(times.error());
    const bool listed = m_spec.shape == SweepShape::Points;
    if (const auto range = listed ? parsePoints() : parseRange(); !range)
        return tl::unexpected(range.error());
    if (m_spec.shape == SweepShape::Stairs) {
        if (const auto step = parseStep(); !step)
            return tl::unexpected(step.error());
    }
    if (const auto rated = readSpeeds(); !rated)
        return tl::unexpected(rated.error());
    m_axis.tolerance = limits.tolerance.value_or(
        std::max(minSettleTolerance, m_axis.stepsPerTurn * defaultToleranceFraction));
    return m_axis;
}
} // namespace

base::Result<results::SweepAxis> sweepAxis(const device::Context& context, device::Servo& servo,
                                           const results::SweepSpec& spec,
                                           const results::SweepLimits& limits)
{
    return AxisBuilder(context, servo, spec).make(limits);
}

std::optional<double> toSteps(double physical, const QString& unit, double stepsPerTurn)
{
    if (unit == QLatin1StringView("rpm"))
        return physical / 60 * stepsPerTurn;
    if (unit.startsWith(QLatin1StringView("deg")))
        return physical / 360 * stepsPerTurn;
    if (unit.startsWith(QLatin1StringView("step")))
        return physical;
    return std::nullopt;
}

double stepsPerTurn(const device::Servo& servo)
{
    // The unit of positions, if there is one, gives the steps of a turn (LX: 1500 × 0.24°).
    const catalog::Register* position = servo.profile->byRole(Role::PresentPosition);
    if (position != nullptr && position->unit == QLatin1StringView("deg") && position->scale > 0)
        return 360 / position->scale;
    const auto range = servo.profile->angleRangeDeg;
    return range && *range > 0 ? servo.profile->stepsPerTurn * 360.0 / *range
                               : servo.profile->stepsPerTurn;
}

device::MoveCommand makeSweepMove(device::Servo& servo, const results::SweepSpec& spec,
                                  double& target)
{
    const auto raw = std::llround(target / goalFactor(servo));
    target = double(raw) * goalFactor(servo);
    device::MoveCommand order{&servo, QString::number(raw)};
    const auto given = [](const QString& text) {
        return text.isEmpty() ? std::nullopt : std::optional(text);
    };
    order.speed = given(spec.speed);
    order.acceleration = given(spec.acceleration);
    order.time = given(spec.time);
    order.maxSettingsAge = maxSettingsAge;
    return order;
}
} // namespace jobs
