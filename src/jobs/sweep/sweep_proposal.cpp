// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_proposal.h"

#include "device/motion/move_limits.h"
#include "jobs/sweep/sweep_path.h"
#include "results/sweep_verdict.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jobs {
using base::Duration;
using results::SweepShape;

namespace {
constexpr double margin = 0.02;      ///< of the range, at either end
constexpr double travelMargin = 1.2; ///< load and supply make a servo slower than its settings
constexpr Duration settleTime = std::chrono::milliseconds(300);
constexpr Duration roundTo = std::chrono::milliseconds(100);
constexpr int maxLegs = 2000; ///< of a cycle that are estimated

Duration roundedUp(double us)
{
    return roundTo * std::llround(std::ceil(us / double(roundTo.count())));
}

/// Of a cycle, and the first one of the next.
std::vector<double> legDistances(const results::SweepSpec& spec, const results::SweepAxis& axis)
{
    const SweepPath path(spec, axis);
    double before = path.first();
    std::vector<double> distances;
    const int legs = std::min(maxLegs, path.legsPerCycle() + 1);
    for (int number = 1; number <= legs; ++number) {
        const double target = path.leg(number).target;
        distances.push_back(std::abs(target - before));
        before = target;
    }
    return distances;
}

double longestLeg(const results::SweepSpec& spec, const results::SweepAxis& axis)
{
    if (spec.shape == SweepShape::Random)
        return std::abs(axis.to - axis.from);
    const auto distances = legDistances(spec, axis);
    return *std::max_element(distances.begin(), distances.end());
}

/// 0: most moves are as long as that.
double minMove(const results::SweepSpec& spec, const results::SweepAxis& axis)
{
    if (spec.shape == SweepShape::Sine)
        return 0;
    const double minDistance = results::minPlannedTolerances * axis.tolerance;
    const auto distances = legDistances(spec, axis);
    const auto enough = std::count_if(distances.begin(), distances.end(),
                                      [=](double way) { return way >= minDistance; });
    return 2 * std::size_t(enough) > distances.size() ? 0 : minDistance;
}

/// A sine is fastest in its middle.
void estimateSine(const results::SweepSpec& spec, SweepEstimate& estimate)
{
    const results::SweepAxis& axis = estimate.axis;
    if (!axis.speed)
        return;
    const double way = std::numbers::pi * std::abs(axis.to - axis.from);
    estimate.tooShort = results::isSineTooFast(spec, axis);
    estimate.proposedDelay = roundedUp(way / *axis.speed * 1e6 * travelMargin);
}

bool delayTooShort(const results::SweepSpec& spec, Duration travel)
{
    const auto shorter = [travel](Duration pause) { return pause < travel; };
    if (spec.shape != SweepShape::Points)
        return shorter(spec.pause);
    return std::any_of(spec.points.begin(), spec.points.end(),
                       [&](const results::SweepPoint& point) {
                           return shorter(point.pause.value_or(spec.pause));
                       });
}
} // namespace

base::Result<SweepEstimate> estimateSweep(const device::Context& context, device::Servo& servo,
                                          const results::SweepSpec& spec,
                                          const results::SweepLimits& limits)
{
    const auto axis = sweepAxis(context, servo, spec, limits);
    if (!axis)
        return tl::unexpected(axis.error());
    SweepEstimate estimate{*axis};
    estimate.minMove = minMove(spec, *axis);
    estimate.travel = travelTime(longestLeg(spec, *axis), *axis);
    if (spec.shape == SweepShape::Sine) {
        estimateSine(spec, estimate);
    } else if (estimate.travel) {
        estimate.tooShort =
            spec.pace == results::SweepPace::Delay && delayTooShort(spec, *estimate.travel);
        estimate.proposedDelay =
            roundedUp(double(estimate.travel->count()) * travelMargin + double(settleTime.count()));
    }
    return estimate;
}

std::optional<results::SweepRange> proposedRange(const device::Servo& servo)
{
    const auto kind = servo.profile ? device::goalKind(servo) : std::nullopt;
    const auto text = [](double raw) { return QString::number(std::llround(raw)); };
    if (kind == device::GoalKind::Turns) {
        const catalog::Register* position = servo.profile->byRole(catalog::Role::PresentPosition);
        const auto now = position != nullptr ? servo.raw(*position) : std::nullopt;
        if (!now)
            return std::nullopt;
        const double quarter = stepsPerTurn(servo) / 4;
        return results::SweepRange{text(double(*now) - quarter), text(double(*now) + quarter)};
    }
    const auto span = device::goalSliderRange(servo);
    if (kind != device::GoalKind::Position || !span || span->max <= span->min)
        return std::nullopt;
    const double room = double(span->max - span->min) * margin;
    return results::SweepRange{text(double(span->min) + room), text(double(span->max) - room)};
}
} // namespace jobs
