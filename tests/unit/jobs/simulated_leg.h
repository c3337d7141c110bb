// SPDX-License-Identifier: GPL-3.0-or-later
// A motion that is known exactly, read as a servo's encoder would be: whole steps, noise, lost
// readings, at any rate. Seconds and steps; for the tests of LegMeter.
#pragma once

#include "jobs/sweep/leg_meter.h"

#include <QByteArray>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace simulated_leg {
using Motion = std::function<double(double seconds)>;

inline base::Duration fromSeconds(double seconds)
{
    return base::Duration(std::llround(seconds * 1e6));
}

inline double seconds(std::optional<base::Duration> span)
{
    return span ? double(span->count()) / 1e6 : -1;
}

/// The step response of a spring with a mass: overshoots by `share` of the way.
inline Motion secondOrder(double start, double target, double frequency, double share)
{
    const double l = std::log(share);
    const double damping = -l / std::hypot(std::numbers::pi, l);
    const double fast = 2 * std::numbers::pi * frequency;
    const double ringing = fast * std::sqrt(1 - damping * damping);
    return [=](double t) {
        const double rest = std::exp(-damping * fast * t) *
                            (std::cos(ringing * t) +
                             damping / std::sqrt(1 - damping * damping) * std::sin(ringing * t));
        return t <= 0 ? start : start + (target - start) * (1 - rest);
    };
}

/// Comes near ever more slowly.
inline Motion exponentialApproach(double start, double target, double constant)
{
    return [=](double t) {
        return t <= 0 ? start : target - (target - start) * std::exp(-t / constant);
    };
}

/// Speeds up, goes, brakes.
inline Motion trapezoid(double start, double target, double speed, double acceleration)
{
    const double way = std::abs(target - start);
    const double top = std::min(speed, std::sqrt(way * acceleration));
    const double ramp = top / acceleration;
    const double whole = way / top + ramp;
    return [=](double t) {
        t = std::clamp(t, 0.0, whole);
        const double up = std::min(t, ramp);
        const double down = std::max(0.0, t - (whole - ramp));
        const double gone = top * t - acceleration * (ramp * ramp - (ramp - up) * (ramp - up)) / 2 -
                            acceleration * down * down / 2;
        return start + std::copysign(gone, target - start);
    };
}

inline Motion later(Motion motion, double by)
{
    return [motion, by](double t) { return motion(t - by); };
}

inline Motion plus(Motion motion, Motion other)
{
    return [motion, other](double t) { return motion(t) + other(t); };
}

struct Reading {
    double rate = 300;
    double noise = 1; ///< steps, either way
    double lost = 0;  ///< share
    double delay = 0; ///< the position is as old as this
    unsigned seed = 1;
};

/// Readings from just after the goal till `until`, uneven by a tenth of their distance.
template <typename Take>
void read(const Motion& motion, double until, const Reading& how, Take take)
{
    std::mt19937 random(how.seed);
    const auto uniform = [&] { return double(random()) / 4294967296.0; };
    for (int i = 1;; ++i) {
        const double at = (i + 0.1 * (uniform() - 0.5)) / how.rate;
        if (at > until)
            return;
        jobs::SweepSample sample;
        sample.at = fromSeconds(at);
        sample.answered = uniform() >= how.lost;
        const double noise = how.noise * (2 * uniform() - 1);
        if (sample.answered)
            sample.position = std::round(motion(at - how.delay) + noise);
        take(sample);
    }
}

inline results::SweepAxis axis(double tolerance = 12)
{
    results::SweepAxis one;
    one.tolerance = tolerance;
    return one;
}

inline jobs::LegMeter meter(const results::SweepAxis& on, double start, double target)
{
    return {on, 1, 1, base::Duration(0), start, target};
}

inline results::SweepLeg measure(const results::SweepAxis& on, double start, double target,
                                 const Motion& motion, double until, const Reading& how = {})
{
    jobs::LegMeter one = meter(on, start, target);
    read(motion, until, how, [&](const jobs::SweepSample& sample) { one.add(sample); });
    return one.finish(fromSeconds(until), base::Duration(0));
}

/// What a stop watch with endless patience would say; by a grid of 20 µs.
struct Truth {
    double arrival = -1;
    double settling = -1;
};

inline Truth groundTruth(const Motion& motion, double target, double tolerance, double until)
{
    Truth truth;
    double settled = 0;
    for (double t = 0; t < until; t += 2e-5) {
        const bool within = std::abs(motion(t) - target) <= tolerance;
        if (within && truth.arrival < 0)
            truth.arrival = t;
        if (!within)
            settled = t;
    }
    truth.settling = std::max(0.0, settled - truth.arrival);
    return truth;
}

inline bool near(std::optional<double> value, double truth, double by)
{
    return value && std::abs(*value - truth) <= by;
}

inline QByteArray mismatchText(std::optional<double> value, double truth)
{
    return (value ? QByteArray::number(*value) : QByteArray("nothing")) + " instead of " +
           QByteArray::number(truth);
}
} // namespace simulated_leg

#define VERIFY_NEAR(value, truth, by)                                                              \
    QVERIFY2(simulated_leg::near(value, truth, by),                                                \
             simulated_leg::mismatchText(value, truth).constData())
