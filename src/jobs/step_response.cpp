// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step_response.h"

#include "device/motion.h"
#include "device/talk.h"
#include "device/write_access.h"
#include "jobs/link_return.h"
#include "jobs/recover_settle.h"
#include "jobs/step_meter.h"
#include "jobs/sweep_runner.h"
#include "jobs/temporary.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Role;

namespace {
std::vector<device::WriteItem> itemsOf(const std::vector<record::StepGain>& gains)
{
    std::vector<device::WriteItem> items;
    for (const record::StepGain& gain : gains)
        items.push_back({gain.key, gain.raw});
    return items;
}

base::Result<void> checkTrial(const device::Servo& servo,
                              const std::vector<record::StepGain>& trial)
{
    const auto known = stepRegisters(*servo.profile);
    for (const record::StepGain& gain : trial) {
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

base::Result<std::vector<record::StepGain>> gainsOf(const device::Context& context,
                                                    device::Servo& servo)
{
    const auto registers = stepRegisters(*servo.profile);
    if (const auto known = device::read(context, servo, registers); !known)
        return tl::unexpected(known.error());
    std::vector<record::StepGain> gains;
    for (const catalog::Register* reg : registers) {
        if (const auto raw = servo.raw(*reg))
            gains.push_back({reg->key, *raw});
    }
    return gains;
}

/// The speed and the acceleration a servo had before, which are in its RAM only.
class Rates {
public:
    /// `speed` false: in the servo's own mode it is no limit, but the command.
    static base::Result<Rates> of(const device::Context& context, device::Servo& servo, bool speed)
    {
        Rates rates;
        std::vector<Role> roles{Role::Acceleration};
        if (speed)
            roles.push_back(Role::GoalSpeed);
        if (const auto known = device::readRoles(context, servo, roles); !known)
            return tl::unexpected(known.error());
        for (const Role role : roles) {
            const catalog::Register* reg = servo.profile->byRole(role);
            // What travels in one frame with a goal or a mode is no setting of its own (LX).
            if (reg != nullptr && !reg->block && servo.raw(*reg))
                rates.m_before.push_back({reg, *servo.raw(*reg)});
        }
        return rates;
    }

    /// As far as the servo answers; who is without torque stays so.
    void putBack(const device::Context& outer, device::Servo& servo) const
    {
        const base::Stop unstopped;
        const device::Context last{outer.bus,     outer.catalog,  outer.journal, unstopped,
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
    StepJob(const device::Context& context, device::Servo& servo, const StepOrder& order,
            const StepWatch& watch)
        : m_context(context)
        , m_servo(servo)
        , m_order(order)
        , m_watch(watch)
    {}

    base::Result<record::StepRun> run();

private:
    base::Result<record::StepRun> ride();
    base::Result<void> drive();
    base::Result<void> checkGains();
    SweepWatch watch();
    void take(const SweepSample& sample, int leg);
    void close(const record::SweepLeg& leg);

    const device::Context& m_context;
    device::Servo& m_servo;
    const StepOrder& m_order;
    const StepWatch& m_watch;
    record::StepRun m_run;
    std::vector<record::StepSample> m_samples; ///< of the present response
    base::Duration m_goalAt{};
    int m_leg = 0;
};

void StepJob::take(const SweepSample& sample, int leg)
{
    if (leg == 0 || leg != m_leg || !sample.answered || !sample.position || sample.at < m_goalAt)
        return;
    m_samples.push_back(
        {sample.at - m_goalAt, *sample.position, sample.speed, sample.load, sample.current});
}

void StepJob::close(const record::SweepLeg& leg)
{
    record::StepResponse response;
    response.number = leg.number;
    response.start = leg.start;
    response.target = leg.target;
    response.missed = leg.missed;
    response.lost = leg.lost;
    response.alarms = leg.alarms;
    response.figures = stepFigures(m_samples, leg);
    response.seen = seenThroughout(m_samples, leg, leg.span);
    if (!response.seen)
        forgetMotion(response.figures);
    response.samples = std::exchange(m_samples, {});
    if (m_watch.onResponse)
        m_watch.onResponse(response);
    m_run.responses.push_back(std::move(response));
}

SweepWatch StepJob::watch()
{
    SweepWatch watch;
    watch.onGoal = [this](std::size_t, int leg, base::Duration at) {
        m_leg = leg;
        m_goalAt = at;
        m_samples.clear();
    };
    watch.onSample = [this](std::size_t, const SweepSample& sample, double, int leg) {
        take(sample, leg);
    };
    watch.onLeg = [this](std::size_t, const record::SweepLeg& leg) { close(leg); };
    watch.onProgress = m_watch.onProgress;
    watch.onTorqueLeft = m_watch.onTorqueLeft;
    return watch;
}

base::Result<void> StepJob::drive()
{
    const auto plan = planStep(m_context, m_servo, m_order.spec);
    if (!plan)
        return tl::unexpected(plan.error());
    const auto trial = TemporarySettings::set(m_context, m_servo, itemsOf(m_order.spec.trial));
    if (!trial)
        return tl::unexpected(trial.error());
    if (m_watch.onTrial)
        m_watch.onTrial((*trial)->items());
    auto gains = gainsOf(m_context, m_servo);
    if (!gains)
        return tl::unexpected(gains.error());
    m_run.gains = std::move(*gains);
    SweepOrder order;
    order.spec = plan->sweep;
    order.limits = {plan->limits};
    order.program = m_order.program;
    order.simulated = m_order.simulated;
    std::vector<device::Servo> servos{m_servo};
    auto done = sweep(m_context, servos, order, watch());
    m_servo = servos.front();
    m_context.bus.awaitReturn(SweepRunner::mostSilence); // the sweep's has ended with it
    if (done && done->end == record::SweepEnd::Finished) {
        if (const auto same = checkGains(); !same)
            done = tl::unexpected(same.error());
    }
    m_run.putBack = (*trial)->putBack().has_value();
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
    const auto now = gainsOf(m_context, m_servo);
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

base::Result<record::StepRun> StepJob::run()
{
    // A plug that is pulled may be put back, also while settings are written.
    const bus::LinkPatience patience(m_context.bus, SweepRunner::mostSilence);
    return ride();
}

base::Result<record::StepRun> StepJob::ride()
{
    m_run.program = m_order.program;
    m_run.simulated = m_order.simulated;
    m_run.spec = m_order.spec;
    if (const auto good = checkTrial(m_servo, m_order.spec.trial); !good)
        return tl::unexpected(good.error());
    std::unique_ptr<TemporarySettings> mode;
    if (m_order.switchMode) {
        auto switched = TemporarySettings::positionMode(m_context, m_servo);
        if (!switched)
            return tl::unexpected(switched.error());
        mode = std::move(*switched);
    }
    const auto rates = Rates::of(m_context, m_servo, mode == nullptr);
    if (!rates)
        return tl::unexpected(rates.error());
    const auto driven = drive();
    waitWhileAway(m_context.bus);
    if (m_run.end != record::SweepEnd::Emergency && !m_context.bus.lost())
        rates->putBack(m_context, m_servo);
    if (mode && !mode->putBack())
        m_run.putBack = false;
    if (!driven)
        return tl::unexpected(driven.error());
    m_run.mean = record::meanOf(m_run.responses);
    return std::move(m_run);
}
} // namespace

namespace {
/// What an interrupted trial has left in the servo is none of its own values: they go back first.
base::Result<void> endEarlierTrials(const device::Context& context, const device::Servo& servo)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    const base::ServoIdentity who = servo.identity();
    const int baud = context.bus.baud();
    for (const base::Intent& intent : *open) {
        if (intent.kind != base::IntentKind::Trial || intent.servo.id != who.id ||
            intent.servo.port != who.port || !intent.servo.sameKind(who))
            continue;
        const auto back = recoverOne(context, intent, RecoverAction::Undo);
        if (context.bus.hasBaud())
            (void)context.bus.setBaud(baud);
        if (!back)
            return tl::unexpected(back.error());
        if (back->error)
            return tl::unexpected(*back->error);
    }
    return {};
}
} // namespace

base::Result<record::StepRun> stepResponse(const device::Context& outer, device::Servo& servo,
                                           const StepOrder& order, const StepWatch& watch)
{
    // Nothing of it may follow an emergency stop.
    const device::Context context{outer.bus,     outer.catalog,
                                  outer.journal, outer.stop,
                                  outer.notices, outer.priority,
                                  outer.hold,    outer.epoch.value_or(outer.bus.emergencies())};
    const auto may = device::beginWriting(context, servo, QStringLiteral("step-response"));
    if (!may)
        return tl::unexpected(may.error());
    if (const auto ended = endEarlierTrials(context, servo); !ended)
        return tl::unexpected(ended.error());
    return StepJob(context, servo, order, watch).run();
}
} // namespace jobs
