// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep_meter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace jobs {
using record::SweepLeg;
using record::SweepMetric;

namespace {
using Legs = std::vector<SweepLeg>;
using Values = std::vector<double>;

constexpr double tenths = 10;  ///< targets that differ by less are one
constexpr double leastWay = 1; ///< a shorter one comes from neither side

enum class Judged : std::uint8_t { Mean, Highest, Lowest, Largest };

double mean(const Values& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// min and max drop a NaN that is not their first argument; nobody may lose one here.
double extreme(const Values& values, const std::function<bool(double, double)>& before)
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

void fill(SweepMetric& metric, const Values& values, Judged judged)
{
    metric.count = values.size();
    if (values.empty())
        return;
    metric.mean = mean(values);
    metric.min = extreme(values, std::less<>());
    metric.max = extreme(values, std::greater<>());
    switch (judged) {
    case Judged::Mean:
        metric.value = metric.mean;
        break;
    case Judged::Highest:
        metric.value = metric.max;
        break;
    case Judged::Lowest:
        metric.value = metric.min;
        break;
    case Judged::Largest:
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
Values every(const Legs& legs, std::optional<T> SweepLeg::*member)
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
        if (!leg.steadyError || !(std::abs(way) >= leastWay))
            continue;
        Approaches& target = targets[std::llround(leg.target * tenths)];
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
    return extreme(values, std::greater<>()) - extreme(values, std::less<>());
}

Values repeatability(const Legs& legs, double (*spread)(const Values&))
{
    Values values;
    for (const auto& [target, sides] : approaches(legs)) {
        Values both;
        for (const Values* side : {&sides.below, &sides.above}) {
            if (side->size() >= 2)
                both.push_back(spread(*side));
        }
        if (!both.empty())
            values.push_back(extreme(both, std::greater<>()));
    }
    return values;
}

Values rises(const Legs& legs, std::optional<double> startCelsius)
{
    if (!startCelsius)
        return {};
    Values values = every(legs, &SweepLeg::temperatureMax);
    for (double& value : values)
        value -= *startCelsius;
    return values;
}

/// Among the legs of which it can be said at all.
template <typename Known, typename Counted>
void countLegs(SweepMetric& metric, const Legs& legs, Known known, Counted counted)
{
    metric.count = std::uint64_t(std::count_if(legs.begin(), legs.end(), known));
    if (metric.count > 0)
        metric.value = double(std::count_if(legs.begin(), legs.end(), [&](const SweepLeg& leg) {
            return known(leg) && counted(leg);
        }));
}

using Fill = std::function<void(SweepMetric&)>;

struct Run {
    const Legs& legs;
    const record::SweepErrors& errors;
    std::optional<double> startCelsius;
    FollowedPath path;
};

bool seenOften(const SweepLeg& leg)
{
    return 2 * leg.samples >= record::minReadingsPerPeriod;
}

/// Of a sine in legs with enough readings only.
Values relativeErrors(const Run& run)
{
    Values values;
    if (!run.path.scale)
        return values;
    for (const SweepLeg& leg : run.legs) {
        if (leg.followingError && (!run.path.isSine || seenOften(leg)))
            values.push_back(*leg.followingError / *run.path.scale * 100);
    }
    return values;
}

Values phaseLags(const Run& run)
{
    Values values;
    for (const SweepLeg& leg : run.legs) {
        if (leg.phaseLag && seenOften(leg))
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

void addFollowing(std::map<QString, Fill>& fills, const Run& run)
{
    const auto of = [&](const char* key, Values (*values)(const Run&), Judged judged) {
        fills[QString::fromLatin1(key)] = [run, values, judged](SweepMetric& metric) {
            fill(metric, values(run), judged);
        };
    };
    of("following_error_relative", relativeErrors, Judged::Highest);
    of("phase_lag", phaseLags, Judged::Largest);
    of("readings_per_period", readingsPerPeriod, Judged::Lowest);
}

void addFigures(std::map<QString, Fill>& fills, const Run& run)
{
    const auto of = [&](const char* key, auto member, Judged judged) {
        fills[QString::fromLatin1(key)] = [run, member, judged](SweepMetric& metric) {
            fill(metric, every(run.legs, member), judged);
        };
    };
    of("time_to_target", &SweepLeg::timeToTarget, Judged::Mean);
    of("settling", &SweepLeg::settling, Judged::Highest);
    of("overshoot", &SweepLeg::overshoot, Judged::Highest);
    of("steady_error", &SweepLeg::steadyError, Judged::Largest);
    of("following_error", &SweepLeg::followingError, Judged::Highest);
    of("mean_speed", &SweepLeg::meanSpeed, Judged::Mean);
    of("top_speed", &SweepLeg::topSpeed, Judged::Mean);
    of("current_peak", &SweepLeg::currentPeak, Judged::Highest);
    of("current_mean", &SweepLeg::currentMean, Judged::Highest);
    of("load_peak", &SweepLeg::loadPeak, Judged::Highest);
    of("load_mean", &SweepLeg::loadMean, Judged::Highest);
    of("voltage_min", &SweepLeg::voltageMin, Judged::Lowest);
    of("temperature_max", &SweepLeg::temperatureMax, Judged::Highest);
}

void addTargets(std::map<QString, Fill>& fills, const Run& run)
{
    const auto of = [&](const char* key, auto values) {
        fills[QString::fromLatin1(key)] = [values](SweepMetric& metric) {
            fill(metric, values(), Judged::Highest);
        };
    };
    of("hysteresis", [run] { return hysteresis(run.legs); });
    of("repeatability_sigma", [run] { return repeatability(run.legs, sigma); });
    of("repeatability_range", [run] { return repeatability(run.legs, range); });
    of("temperature_rise", [run] { return rises(run.legs, run.startCelsius); });
}

void addNumbers(std::map<QString, Fill>& fills, const Run& run)
{
    const auto of = [&](const char* key, auto known, auto counted) {
        fills[QString::fromLatin1(key)] = [run, known, counted](SweepMetric& metric) {
            countLegs(metric, run.legs, known, counted);
        };
    };
    of(
        "moving_flag_errors", [](const SweepLeg& leg) { return leg.flagWrong.has_value(); },
        [](const SweepLeg& leg) { return *leg.flagWrong; });
    of(
        "missed_targets",
        [tolerance = run.path.tolerance](const SweepLeg& leg) {
            return record::provesArrival(leg, tolerance);
        },
        [](const SweepLeg& leg) { return leg.missed; });
    of(
        "alarms", [](const SweepLeg& leg) { return leg.samples > 0; },
        [](const SweepLeg& leg) { return leg.alarms != 0; });
    fills[QStringLiteral("communication_errors")] = [run](SweepMetric& metric) {
        const record::SweepErrors& errors = run.errors;
        metric.count = errors.asked;
        if (errors.asked > 0)
            metric.value =
                double(errors.timeOuts + errors.badChecks + errors.foreign + errors.late);
    };
}
} // namespace

std::vector<SweepMetric> sweepMetrics(const Legs& legs, const record::SweepErrors& errors,
                                      std::optional<double> startCelsius, const FollowedPath& path)
{
    std::map<QString, Fill> fills;
    const Run run{legs, errors, startCelsius, path};
    addFigures(fills, run);
    addFollowing(fills, run);
    addTargets(fills, run);
    addNumbers(fills, run);
    std::vector<SweepMetric> metrics;
    for (const record::SweepMetricKind& kind : record::sweepMetricKinds()) {
        SweepMetric metric{kind.key, kind.unit};
        if (const auto found = fills.find(kind.key); found != fills.end())
            found->second(metric);
        metrics.push_back(metric);
    }
    return metrics;
}

FollowedPath followedPath(const record::SweepSpec& spec, const record::SweepAxis& axis)
{
    return {record::followingScale(spec.shape, axis), spec.shape == record::SweepShape::Sine,
            axis.tolerance};
}
} // namespace jobs
