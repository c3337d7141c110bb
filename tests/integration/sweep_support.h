// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep test with the built-in limits of its servos, and a figure of its result. The test's
// thread.
#pragma once

#include "jobs/sweep/sweep.h"

namespace sweep_support {
inline base::Result<results::SweepRun> run(const device::Context& context,
                                           std::vector<device::Servo>& servos,
                                           const results::SweepSpec& spec,
                                           const jobs::SweepCallbacks& watch = {})
{
    jobs::SweepRequest order;
    order.spec = spec;
    for (const device::Servo& servo : servos)
        order.limits.push_back(
            results::builtInSweepLimits(servo.profile->modelName, servo.profile->series));
    return jobs::sweep(context, servos, order, watch);
}

inline std::optional<double> metric(const results::SweepServo& servo, const char* key)
{
    for (const results::SweepMetric& one : servo.metrics) {
        if (one.key == QLatin1String(key))
            return one.value;
    }
    return std::nullopt;
}
} // namespace sweep_support
