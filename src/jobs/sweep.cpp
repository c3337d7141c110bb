// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep.h"

#include "jobs/snapshot.h"
#include "jobs/sweep_axis.h"
#include "jobs/sweep_runner.h"

namespace jobs {
using base::Duration;
using base::ErrorCode;

namespace {
base::Result<record::SweepRun> prepare(const device::Context& context,
                                       std::vector<device::Servo>& servos, const SweepOrder& order)
{
    record::SweepRun run;
    run.program = order.program;
    run.at = QDateTime::currentDateTimeUtc();
    run.port = context.bus.portName();
    run.baud = context.bus.hasBaud() ? context.bus.baud() : 0;
    run.simulated = order.simulated;
    run.spec = order.spec;
    for (std::size_t i = 0; i < servos.size(); ++i) {
        record::SweepServo servo;
        servo.limits = order.limits.at(i);
        const auto axis = sweepAxis(context, servos[i], order.spec, servo.limits);
        if (!axis)
            return tl::unexpected(axis.error());
        servo.axis = *axis;
        run.servos.push_back(std::move(servo));
    }
    for (std::size_t i = 0; i < servos.size(); ++i) {
        auto table = takeSnapshot(context, servos[i], order.program);
        if (!table)
            return tl::unexpected(table.error());
        run.servos[i].parameters = std::move(*table);
    }
    return run;
}
} // namespace

base::Result<record::SweepRun> sweep(const device::Context& context,
                                     std::vector<device::Servo>& servos, const SweepOrder& order,
                                     const SweepWatch& watch)
{
    if (servos.empty() || order.limits.size() != servos.size())
        return base::fail(ErrorCode::BadArgument, QStringLiteral("sweep"),
                          QStringLiteral("no servo"));
    auto run = prepare(context, servos, order);
    if (!run)
        return tl::unexpected(run.error());
    if (const auto refusal = watch.onBegin ? watch.onBegin(*run) : std::nullopt)
        return tl::unexpected(*refusal);
    return SweepRunner(context, servos, std::move(*run), watch).run();
}
} // namespace jobs
