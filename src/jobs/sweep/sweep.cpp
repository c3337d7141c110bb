// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep.h"

#include "device/write_access.h"
#include "jobs/restore/take_snapshot.h"
#include "jobs/sweep/sweep_axis.h"
#include "jobs/sweep/sweep_runner.h"
#include "jobs/temporary_settings.h"

namespace jobs {
using base::Duration;
using base::ErrorCode;

namespace {
using Modes = std::vector<std::unique_ptr<TemporarySettings>>;

/// The servo, and what the test means for it. `modes` receives what must be restored.
base::Result<results::SweepServo> prepare(const device::Context& context, device::Servo& servo,
                                          const SweepRequest& request, std::size_t place,
                                          Modes& modes)
{
    results::SweepServo prepared;
    prepared.limits = results::withNameOfItsOwn(
        request.limits.at(place), servo.profile ? servo.profile->modelName : QString());
    auto axis = sweepAxis(context, servo, request.spec, prepared.limits);
    const bool otherMode = !axis && axis.error().reason == base::Reason::NotInPositionMode;
    if (!axis && !(otherMode && request.switchMode))
        return tl::unexpected(axis.error());
    // The table as the servo keeps it, not as the test has set it.
    auto table = takeSnapshot(context, servo, request.program);
    if (!table)
        return tl::unexpected(table.error());
    prepared.parameters = std::move(*table);
    if (!axis) {
        auto mode = TemporarySettings::positionMode(context, servo);
        if (!mode)
            return tl::unexpected(mode.error());
        modes.push_back(std::move(*mode));
        axis = sweepAxis(context, servo, request.spec, prepared.limits);
    }
    if (!axis)
        return tl::unexpected(axis.error());
    prepared.axis = *axis;
    return prepared;
}

base::Result<results::SweepRun> prepare(const device::Context& context,
                                        std::vector<device::Servo>& servos,
                                        const SweepRequest& request, Modes& modes)
{
    results::SweepRun run;
    run.program = request.program;
    run.at = QDateTime::currentDateTimeUtc();
    run.port = context.bus.portName();
    run.baud = context.bus.canSetBaud() ? context.bus.baud() : 0;
    run.simulated = request.simulated;
    run.spec = request.spec;
    for (std::size_t i = 0; i < servos.size(); ++i) {
        auto servo = prepare(context, servos[i], request, i, modes);
        if (!servo)
            return tl::unexpected(servo.error());
        run.servos.push_back(std::move(*servo));
    }
    return run;
}

/// No goal may follow an emergency stop, not even one between two legs.
device::Context withEmergencyEpoch(const device::Context& outer)
{
    return {outer.bus,     outer.catalog,
            outer.journal, outer.stop,
            outer.notices, outer.priority,
            outer.hold,    outer.epoch.value_or(outer.bus.emergencyCount())};
}
} // namespace

base::Result<results::SweepRun> sweep(const device::Context& outer,
                                      std::vector<device::Servo>& servos,
                                      const SweepRequest& request, const SweepCallbacks& callbacks)
{
    const device::Context context = withEmergencyEpoch(outer);
    if (servos.empty() || request.limits.size() != servos.size())
        return base::fail(ErrorCode::BadArgument, QStringLiteral("sweep"),
                          QStringLiteral("no servo"));
    for (const device::Servo& servo : servos) {
        const auto may = device::beginWriting(context, servo, QStringLiteral("sweep"));
        if (!may)
            return tl::unexpected(may.error());
    }
    Modes modes; // go back when this ends, however it does
    auto run = prepare(context, servos, request, modes);
    if (!run)
        return tl::unexpected(run.error());
    if (const auto refusal = callbacks.onBegin ? callbacks.onBegin(*run) : std::nullopt)
        return tl::unexpected(*refusal);
    return SweepRunner(context, servos, std::move(*run), callbacks).run();
}
} // namespace jobs
