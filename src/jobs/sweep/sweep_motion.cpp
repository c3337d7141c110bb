// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_motion.h"

#include "device/motion/move_limits.h"
#include "device/transactions.h"
#include "jobs/link_reconnect.h"
#include "jobs/sweep/sweep_axis.h"

#include <algorithm>

namespace jobs {
using results::SweepEnd;

namespace {
/// One packet where all of them can share it, else one by one.
device::MoveMethod moveMethodFor(const std::vector<device::Servo>& servos)
{
    const bool together =
        servos.size() > 1 && std::all_of(servos.begin(), servos.end(), [](const auto& servo) {
            return device::supports(servo, device::MoveMethod::Sync);
        });
    return together ? device::MoveMethod::Sync : device::MoveMethod::Write;
}
} // namespace

base::Result<void> sendSweepGoals(const device::Context& context,
                                  std::vector<device::Servo>& servos,
                                  const results::SweepSpec& spec, std::vector<double>& targets)
{
    std::vector<device::MovePlan> plans;
    std::vector<int> ids;
    for (std::size_t i = 0; i < servos.size(); ++i) {
        auto plan = device::planMove(context, makeSweepMove(servos[i], spec, targets[i]));
        if (!plan)
            return tl::unexpected(plan.error());
        plans.push_back(std::move(*plan));
        ids.push_back(servos[i].id);
    }
    // Within a hold it is not asked again who they are: that was done when the test began. Polling
    // rests as long as it is held, so not while the moves are planned.
    const device::Owned owned = device::own(context, ids);
    return device::sendMoves(owned.context, plans, moveMethodFor(servos));
}

namespace {
/// A goal may have reached it before it was known as another one.
base::Result<void> releaseReplacedServo(const device::Context& context, device::Servo& servo)
{
    const catalog::Register* torque = servo.profile->byRole(catalog::Role::TorqueSwitch);
    if (torque == nullptr)
        return {};
    const auto isOff = [&] { return device::readRegister(context, servo, *torque) == 0; };
    if (isOff())
        return {};
    const auto sent = device::setTorque(context, servo, device::Torque::Off);
    return isOff() ? base::Result<void>{} : sent;
}

/// The servos that are not proved to be stopped. All get the stop before the first is checked.
std::vector<UnreleasedTorque> applyEndStates(const device::Context& context,
                                             std::vector<device::Servo>& servos,
                                             const results::SweepRun& run,
                                             const std::vector<ServoEndState>& endStates)
{
    std::vector<UnreleasedTorque> unconfirmed;
    const auto addUnconfirmed = [&](const device::Servo& servo, const base::Result<void>& off) {
        if (!off)
            unconfirmed.push_back({servo.id, false, off.error()});
    };
    const auto release = [&](device::Servo& servo) {
        addUnconfirmed(servo, device::setTorque(context, servo, device::Torque::Off));
    };
    std::vector<device::Servo*> others;
    for (std::size_t i = 0; i < servos.size(); ++i) {
        if (endStates[i] == ServoEndState::TorqueOff)
            release(servos[i]);
        else if (endStates[i] == ServoEndState::Untouched)
            addUnconfirmed(servos[i], releaseReplacedServo(context, servos[i]));
        else
            others.push_back(&servos[i]);
    }
    if (run.end != SweepEnd::Finished) {
        const auto halted = device::haltAll(context, others);
        for (std::size_t i = 0; i < others.size(); ++i) {
            if (!halted[i] && !run.spec.releaseAtEnd)
                unconfirmed.push_back({others[i]->id, true, halted[i].error()});
        }
    }
    if (run.spec.releaseAtEnd) {
        for (device::Servo* servo : others)
            release(*servo);
    }
    return unconfirmed;
}
} // namespace

void leaveServosSafe(const device::Context& context, std::vector<device::Servo>& servos,
                     const results::SweepRun& run, const std::vector<ServoEndState>& endStates,
                     const SweepCallbacks& callbacks)
{
    if (run.end == SweepEnd::Emergency)
        return;
    // The user's stop ends the test, not the steps that make its end safe.
    const base::StopToken neverStop;
    const device::Context last{context.bus,     context.catalog,  context.journal, neverStop,
                               context.notices, context.priority, context.hold,    context.epoch};
    std::vector<UnreleasedTorque> unconfirmed;
    do {
        waitForReconnection(context.bus);
        unconfirmed = applyEndStates(last, servos, run, endStates);
    } while (context.bus.isReconnecting()); // pulled in the middle of it
    for (const UnreleasedTorque& one : unconfirmed) {
        if (callbacks.onUnreleasedTorque)
            callbacks.onUnreleasedTorque(one);
    }
}
} // namespace jobs
