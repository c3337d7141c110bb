// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace jobs {
using results::SweepLeg;
using results::SweepMetric;

namespace {
using Legs = std::vector<SweepLeg>;
using Values = std::vector<double>;

constexpr double targetResolution = 10;   ///< targets that differ by less are one
constexpr double minApproachDistance = 1; ///< a shorter one comes from neither side

enum class Aggregate : std::uint8_t { Mean, Highest, Lowest, Largest };

double mean(const Values& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// std::min and std::max drop a NaN that is not their first argument; here it must be kept.
double findExtreme(const Values& values, const std::function<bool(double, double)>& before)
{
    double best = values.front();
    for (const double value : values) {
        if (std::isnan(value))
            return value;
        if (before(value, best))
            best = value;
    }
    return best;
}

void fill(SweepMetric& metric, const Values& values, Aggregate aggregate)
{
    metric.count = values.size();
    if (values.empty())
        return;
    metric.mean = mean(values);
    metric.min = findExtreme(values, std::less<>());
    metric.max = findExtreme(values, std::greater<>());
    switch (aggregate) {
    case Aggregate::Mean:
        metric.value = metric.mean;
        break;
    case Aggregate::Highest:
        metric.value = metric.max;
        break;
    case Aggregate::Lowest:
        metric.value = metric.min;
        break;
    case Aggregate::Largest:
        metric.value = std::max(std::abs(*metric.min), std::abs(*metric.max));
    }
}

double asNumber(double value)
{
    return value;
}

double asNumber(base::Duration span)
{
    return double(span.count()) / 1000; // ms
}

template <typename T>
Values collect(const Legs& legs, std::optional<T> SweepLeg::*member)
{
    Values values;
    for (const SweepLeg& leg : legs) {
        if (const auto& value = leg.*member)
            values.push_back(asNumber(*value));
    }
    return values;
}

/// Places of rest at one target, beside it: by the side the servo came from.
struct Approaches {
    Values below;
    Values above;
};

std::map<std::int64_t, Approaches> approaches(const Legs& legs)
{
    std::map<std::int64_t, Approaches> targets;
    for (const SweepLeg& leg : legs) {
        const double way = leg.target - leg.start;
        if (!leg.steadyError || !(std::abs(way) >= minApproachDistance))
            continue;
        Approaches& target = targets[std::llround(leg.target * targetResolution)];
        (way > 0 ? target.below : target.above).push_back(*leg.steadyError);
    }
    return targets;
}

Values hysteresis(const Legs& legs)
{
    Values values;
    for (const auto& [target, sides] : approaches(legs)) {
        if (!sides.below.empty() && !sides.above.empty())
            values.push_back(std::abs(mean(sides.above) - mean(sides.below)));
    }
    return values;
}

double sigma(const Values& values)
{
    const double middle = mean(values);
    double sum = 0;
    for (const double value : values)
        sum += (value - middle) * (value - middle);
    return std::sqrt(sum / double(values.size() - 1));
}

double range(const Values& values)
{
    return findExtreme(values, std::greater<>()) - findExtreme(values, std::less<>());
}

Values repeatability(const Legs& legs, double (*spread)(const Values&))
{
    Values values;
    for (const auto& [target, sides] : approaches(legs)) {
        Values sideSpreads;
        for (const Values* side : {&sides.below, &sides.above}) {
            if (side->size() >= 2)
                sideSpreads.push_back(spread(*side));
        }
        if (!sideSpreads.empty())
            values.push_back(findExtreme(sideSpreads, std::greater<>()));
    }
    return values;
}

Values temperatureRises(const Legs& legs, std::optional<double> startCelsius)
{
    if (!startCelsius)
        return {};
    Values values = collect(legs, &SweepLeg::temperatureMax);
    for (double& value : values)
        value -= *startCelsius;
    return values;
}

/// Among the legs for which it is known.
template <typename Known, typename Counted>
void countLegs(SweepMetric& metric, const Legs& legs, Known known, Counted counted)
{
    metric.count = std::uint64_t(std::count_if(legs.begin(), legs.end(), known));
    if (metric.count > 0)
        metric.value = double(std::count_if(legs.begin(), legs.end(), [&](const SweepLeg& leg) {
            return known(leg) && counted(leg);
        }));
}

using MetricFiller = std::function<void(SweepMetric&)>;

struct Run {
    const Legs& legs;
    const results::SweepErrors& errors;
    std::optional<double> startCelsius;
    ReferencePath path;
};

bool isSampledEnough(const SweepLeg& leg)
{
    return 2 * leg.samples >= results::minReadingsPerPeriod;
}

/// Of a sine in legs with enough readings only.
Values relativeErrors(const Run& run)
{
    Values values;
    if (!run.path.scale)
        return values;
    for (const SweepLeg& leg : run.legs) {
        if (leg.followingError && (!run.path.isSine || isSampledEnough(leg)))
            values.push_back(*leg.followingError / *run.path.scale * 100);
    }
    return values;
}

Values phaseLags(const Run& run)
{
    Values values;
    for (const SweepLeg& leg : run.legs) {
        if (leg.phaseLag && isSampledEnough(leg))
            values.push_back(*leg.phaseLag);
    }
    return values;
}

/// A leg is half a period.
Values readingsPerPeriod(const Run& run)
{
    Values values;
    for (const SweepLeg& leg : run.legs) {
        if (run.path.isSine)
            values.push_back(2.0 * leg.samples);
    }
    return values;
}

void addFollowing(std::map<QString, MetricFiller>& fillers, const Run& run)
{
    const auto of = [&](const char* key, Values (*values)(const Run&), Aggregate aggregate) {
        fillers[QString::fromLatin1(key)] = [run, values, aggregate](SweepMetric& metric) {
            fill(metric, values(run), aggregate);
        };
    };
    of("following_error_relative", relativeErrors, Aggregate::Highest);
    of("phase_lag", phaseLags, Aggregate::Largest);
    of("readings_per_period", readingsPerPeriod, Aggregate::Lowest);
}

void addFigures(std::map<QString, MetricFiller>& fillers, const Run& run)
{
    const auto of = [&](const char* key, auto member, Aggregate aggregate) {
        fillers[QString::fromLatin1(key)] = [run, member, aggregate](SweepMetric& metric) {
            fill(metric, collect(run.legs, member), aggregate);
        };
    };
    of("time_to_target", &SweepLeg::timeToTarget, Aggregate::Mean);
    of("settling", &SweepLeg::settling, Aggregate::Highest);
    of("overshoot", &SweepLeg::overshoot, Aggregate::Highest);
    of("steady_error", &SweepLeg::steadyError, Aggregate::Largest);
    of("following_error", &SweepLeg::followingError, Aggregate::Highest);
    of("mean_speed", &SweepLeg::meanSpeed, Aggregate::Mean);
    of("top_speed", &SweepLeg::topSpeed, Aggregate::Mean);
    of("current_peak", &SweepLeg::currentPeak, Aggregate::Highest);
    of("current_mean", &SweepLeg::currentMean, Aggregate::Highest);
    of("load_peak", &SweepLeg::loadPeak, Aggregate::Highest);
    of("load_mean", &SweepLeg::loadMean, Aggregate::Highest);
    of("voltage_min", &SweepLeg::voltageMin, Aggregate::Lowest);
    of("temperature_max", &SweepLeg::temperatureMax, Aggregate::Highest);
}

void addTargets(std::map<QString, MetricFiller>& fillers, const Run& run)
{
    const auto of = [&](const char* key, auto values) {
        fillers[QString::fromLatin1(key)] = [values](SweepMetric& metric) {
            fill(metric, values(), Aggregate::Highest);
        };
    };
    of("hysteresis", [run] { return hysteresis(run.legs); });
    of("repeatability_sigma", [run] { return repeatability(run.legs, sigma); });
    of("repeatability_range", [run] { return repeatability(run.legs, range); });
    of("temperature_rise", [run] { return temperatureRises(run.legs, run.startCelsius); });
}

void addNumbers(std::map<QString, MetricFiller>& fillers, const Run& run)
{
    const auto of = [&](const char* key, auto known, auto counted) {
        fillers[QString::fromLatin1(key)] = [run, known, counted](SweepMetric& metric) {
            countLegs(metric, run.legs, known, counted);
        };
    };
    of(
        "moving_flag_errors", [](const SweepLeg& leg) { return leg.flagWrong.has_value(); },
        [](const SweepLeg& leg) { return *leg.flagWrong; });
    of(
        "missed_targets",
        [tolerance = run.path.tolerance](const SweepLeg& leg) {
            return results::provesArrival(leg, tolerance);
        },
        [](const SweepLeg& leg) { return leg.missed; });
    of(
        "alarms", [](const SweepLeg& leg) { return leg.samples > 0; },
        [](const SweepLeg& leg) { return leg.alarms != 0; });
    fillers[QStringLiteral("communication_errors")] = [run](SweepMetric& metric) {
        const results::SweepErrors& errors = run.errors;
        metric.count = errors.asked;
        if (errors.asked > 0)
            metric.value =
                double(errors.timeouts + errors.badChecksums + errors.foreign + errors.late);
    };
}
} // namespace

std::vector<SweepMetric> sweepMetrics(const Legs& legs, const results::SweepErrors& errors,
                                      std::optional<double> startCelsius, const ReferencePath& path)
{
    std::map<QString, MetricFiller> fillers;
    const Run run{legs, errors, startCelsius, path};
    addFigures(fillers, run);
    addFollowing(fillers, run);
    addTargets(fillers, run);
    addNumbers(fillers, run);
    std::vector<SweepMetric> metrics;
    for (const results::SweepMetricKind& kind : results::sweepMetricKinds()) {
        SweepMetric metric{kind.key, kind.unit};
        if (const auto found = fillers.find(kind.key); found != fillers.end())
            found->second(metric);
        metrics.push_back(metric);
    }
    return metrics;
}

ReferencePath referencePath(const results::SweepSpec& spec, const results::SweepAxis& axis)
{
    return {results::followingScale(spec.shape, axis), spec.shape == results::SweepShape::Sine,
            axis.tolerance};
}
} // namespace jobs
