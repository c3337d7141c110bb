// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step/step_response.h"

#include "device/motion/motion.h"
#include "device/transactions.h"
#include "device/write_access.h"
#include "jobs/link_reconnect.h"
#include "jobs/recover/recover_apply.h"
#include "jobs/step/step_meter.h"
#include "jobs/sweep/sweep_link.h"
#include "jobs/temporary_settings.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Role;

namespace {
std::vector<device::WriteItem> itemsOf(const std::vector<results::StepGain>& gains)
{
    std::vector<device::WriteItem> items;
    for (const results::StepGain& gain : gains)
        items.push_back({gain.key, gain.raw});
    return items;
}

base::Result<void> checkTrial(const device::Servo& servo,
                              const std::vector<results::StepGain>& trial)
{
    const auto known = loopRegisters(*servo.profile);
    for (const results::StepGain& gain : trial) {
        const bool good =
            std::any_of(known.begin(), known.end(),
                        [&](const catalog::Register* reg) { return reg->key == gain.key; });
        if (!good) {
            return tl::unexpected(base::Error{ErrorCode::BadArgument, QStringLiteral("step"),
                                              QStringLiteral("no-gain"), servo.id, gain.key});
        }
    }
    return {};
}

base::Result<std::vector<results::StepGain>> readStepGains(const device::Context& context,
                                                           device::Servo& servo)
{
    const auto registers = loopRegisters(*servo.profile);
    if (const auto known = device::read(context, servo, registers); !known)
        return tl::unexpected(known.error());
    std::vector<results::StepGain> gains;
    for (const catalog::Register* reg : registers) {
        if (const auto raw = servo.raw(*reg))
            gains.push_back({reg->key, *raw});
    }
    return gains;
}

/// The speed and the acceleration a servo had before, which are in its RAM only.
class SpeedSettings {
public:
    /// `speed` false: in the servo's own mode it is no limit, but the command.
    static base::Result<SpeedSettings> of(const device::Context& context, device::Servo& servo,
                                          bool speed)
    {
        SpeedSettings rates;
        std::vector<Role> roles{Role::Acceleration};
        if (speed)
            roles.push_back(Role::GoalSpeed);
        if (const auto known = device::readRoles(context, servo, roles); !known)
            return tl::unexpected(known.error());
        for (const Role role : roles) {
            const catalog::Register* reg = servo.profile->byRole(role);
            // A value that is sent in one frame with a goal or a mode is not a setting (LX).
            if (reg != nullptr && !reg->block && servo.raw(*reg))
                rates.m_before.push_back({reg, *servo.raw(*reg)});
        }
        return rates;
    }

    /// As far as the servo answers; a servo without torque stays without it.
    void revert(const device::Context& outer, device::Servo& servo) const
    {
        const base::StopToken neverStop;
        const device::Context last{outer.bus,     outer.catalog,  outer.journal, neverStop,
                                   outer.notices, outer.priority, outer.hold,    outer.epoch};
        const device::Owned owned = device::own(last, {servo.id});
        const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
        const auto on = torque != nullptr ? device::readRegister(owned.context, servo, *torque)
                                          : base::Result<std::int64_t>(0);
        if (!on)
            return;
        bool written = false;
        for (const device::RegisterValue& value : m_before) {
            if (device::readRegister(owned.context, servo, *value.reg) == value.raw)
                continue;
            (void)device::writeVerified(owned.context, servo, *value.reg, value.raw);
            written = true;
        }
        if (written && *on == 0 && torque != nullptr)
            (void)device::setTorque(owned.context, servo, device::Torque::Off);
    }

private:
    device::RegisterValues m_before;
};

/// One run: collects what the sweep reads, leg by leg.
class StepJob {
public:
    StepJob(const device::Context& context, device::Servo& servo, const StepRequest& request,
            const StepCallbacks& callbacks)
        : m_context(context)
        , m_servo(servo)
        , m_request(request)
        , m_callbacks(callbacks)
    {}

    base::Result<results::StepRun> run();

private:
    base::Result<results::StepRun> runInMode();
    base::Result<void> runSweep();
    base::Result<void> checkGains();
    SweepCallbacks callbacks();
    void addSample(const SweepSample& sample, int leg);
    void finishResponse(const results::SweepLeg& leg);

    const device::Context& m_context;
    device::Servo& m_servo;
    const StepRequest& m_request;
    const StepCallbacks& m_callbacks;
    results::StepRun m_run;
    std::vector<results::StepSample> m_samples; ///< of the present response
    base::Duration m_goalAt{};
    int m_leg = 0;
};

void StepJob::addSample(const SweepSample& sample, int leg)
{
    if (leg == 0 || leg != m_leg || !sample.answered || !sample.position || sample.at < m_goalAt)
        return;
    m_samples.push_back(
        {sample.at - m_goalAt, *sample.position, sample.speed, sample.load, sample.current});
}

void StepJob::finishResponse(const results::SweepLeg& leg)
{
    results::StepResponse response;
    response.number = leg.number;
    response.start = leg.start;
    response.target = leg.target;
    response.missed = leg.missed;
    response.lost = leg.lost;
    response.alarms = leg.alarms;
    response.figures = measureStep(m_samples, leg);
    response.seen = isFullySampled(m_samples, leg, leg.span);
    if (!response.seen)
        clearMotionFigures(response.figures);
    response.samples = std::exchange(m_samples, {});
    if (m_callbacks.onResponse)
        m_callbacks.onResponse(response);
    m_run.responses.push_back(std::move(response));
}

SweepCallbacks StepJob::callbacks()
{
    SweepCallbacks callbacks;
    callbacks.onGoal = [this](std::size_t, int leg, base::Duration at) {
        m_leg = leg;
        m_goalAt = at;
        m_samples.clear();
    };
    callbacks.onSample = [this](std::size_t, const SweepSample& sample, double, int leg) {
        addSample(sample, leg);
    };
    callbacks.onLeg = [this](std::size_t, const results::SweepLeg& leg) { finishResponse(leg); };
    callbacks.onProgress = m_callbacks.onProgress;
    callbacks.onUnreleasedTorque = m_callbacks.onUnreleasedTorque;
    return callbacks;
}

base::Result<void> StepJob::runSweep()
{
    const auto plan = planStep(m_context, m_servo, m_request.spec);
    if (!plan)
        return tl::unexpected(plan.error());
    const auto trial = TemporarySettings::set(m_context, m_servo, itemsOf(m_request.spec.trial));
    if (!trial)
        return tl::unexpected(trial.error());
    if (m_callbacks.onTrial)
        m_callbacks.onTrial((*trial)->items());
    auto gains = readStepGains(m_context, m_servo);
    if (!gains)
        return tl::unexpected(gains.error());
    m_run.gains = std::move(*gains);
    SweepRequest request;
    request.spec = plan->sweep;
    request.limits = {plan->limits};
    request.program = m_request.program;
    request.simulated = m_request.simulated;
    std::vector<device::Servo> servos{m_servo};
    auto done = sweep(m_context, servos, request, callbacks());
    m_servo = servos.front();
    m_context.bus.setReconnectTimeout(SweepLink::maxSilence); // the sweep's has ended with it
    if (done && done->end == results::SweepEnd::Finished) {
        if (const auto same = checkGains(); !same)
            done = tl::unexpected(same.error());
    }
    m_run.isReverted = (*trial)->revert().has_value();
    if (!done)
        return tl::unexpected(done.error());
    // A leg that lost its torque on the way is none of the run's.
    if (const auto legs = done->servos.front().legs.size(); m_run.responses.size() > legs)
        m_run.responses.resize(legs);
    m_run.at = done->at;
    m_run.port = done->port;
    m_run.baud = done->baud;
    m_run.parameters = std::move(done->servos.front().parameters);
    m_run.axis = done->servos.front().axis;
    m_run.end = done->end;
    m_run.sampleRate = done->sampleRate;
    m_run.spec.hold = plan->hold;
    return {};
}

/// Who restarted between the setting and the first goal has moved with its own gains: what a trial
/// of others has brought is not known then.
base::Result<void> StepJob::checkGains()
{
    const auto now = readStepGains(m_context, m_servo);
    if (!now || *now == m_run.gains)
        return {};
    for (std::size_t i = 0; i < now->size() && i < m_run.gains.size(); ++i) {
        if (!((*now)[i] == m_run.gains[i]))
            return tl::unexpected(base::Error{ErrorCode::Refused, QStringLiteral("step"),
                                              QStringLiteral("trial-lost"), m_servo.id,
                                              (*now)[i].key});
    }
    return {};
}

base::Result<results::StepRun> StepJob::run()
{
    // A plug that is pulled may be put back, also while settings are written.
    const bus::ReconnectScope reconnect(m_context.bus, SweepLink::maxSilence);
    return runInMode();
}

base::Result<results::StepRun> StepJob::runInMode()
{
    m_run.program = m_request.program;
    m_run.simulated = m_request.simulated;
    m_run.spec = m_request.spec;
    if (const auto good = checkTrial(m_servo, m_request.spec.trial); !good)
        return tl::unexpected(good.error());
    std::unique_ptr<TemporarySettings> mode;
    if (m_request.switchMode) {
        auto switched = TemporarySettings::positionMode(m_context, m_servo);
        if (!switched)
            return tl::unexpected(switched.error());
        mode = std::move(*switched);
    }
    const auto rates = SpeedSettings::of(m_context, m_servo, mode == nullptr);
    if (!rates)
        return tl::unexpected(rates.error());
    const auto ran = runSweep();
    waitForReconnection(m_context.bus);
    if (m_run.end != results::SweepEnd::Emergency && !m_context.bus.lost())
        rates->revert(m_context, m_servo);
    if (mode && !mode->revert())
        m_run.isReverted = false;
    if (!ran)
        return tl::unexpected(ran.error());
    m_run.mean = results::meanOf(m_run.responses);
    return std::move(m_run);
}
} // namespace

namespace {
/// Values that an interrupted trial left in the servo are not its own: its own are restored first.
base::Result<void> revertEarlierTrials(const device::Context& context, const device::Servo& servo)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    const base::ServoIdentity identity = servo.identity();
    const int baud = context.bus.baud();
    for (const base::Intent& intent : *open) {
        if (intent.kind != base::IntentKind::Trial || intent.servo.id != identity.id ||
            intent.servo.port != identity.port || !intent.servo.isSameKind(identity))
            continue;
        const auto back = recoverIntent(context, intent, RecoveryAction::Undo);
        if (context.bus.canSetBaud())
            (void)context.bus.setBaud(baud);
        if (!back)
            return tl::unexpected(back.error());
        if (back->error)
            return tl::unexpected(*back->error);
    }
    return {};
}
} // namespace

base::Result<results::StepRun> stepResponse(const device::Context& outer, device::Servo& servo,
                                            const StepRequest& request,
                                            const StepCallbacks& callbacks)
{
    // Nothing of it may follow an emergency stop.
    const device::Context context{outer.bus,     outer.catalog,
                                  outer.journal, outer.stop,
                                  outer.notices, outer.priority,
                                  outer.hold,    outer.epoch.value_or(outer.bus.emergencyCount())};
    const auto may = device::beginWriting(context, servo, QStringLiteral("step-response"));
    if (!may)
        return tl::unexpected(may.error());
    if (const auto ended = revertEarlierTrials(context, servo); !ended)
        return tl::unexpected(ended.error());
    return StepJob(context, servo, request, callbacks).run();
}
} // namespace jobs
