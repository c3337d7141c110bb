// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step_advice.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using catalog::Role;
using record::StepRemedy;
using record::StepSymptom;

namespace {
constexpr double manySwings = 4;
constexpr double badOvershoot = 2;      ///< %
constexpr double badOvershootSteps = 4; ///< above the noise of any encoder
constexpr double badError = 2;          ///< steps: row 14 of the advice
constexpr double atTheLimit = 0.95;
constexpr std::int64_t share = 8; ///< of the value: a small step
constexpr double noise = 3;       ///< steps
constexpr std::size_t leastSamples = 20;
constexpr double stillBand = 4; ///< steps
constexpr double restShare = 64;
constexpr double noiseShare = 0.02;

/// Nothing is known of a response without readings, nor of one that began at its target.
std::optional<bool> moved(const record::StepResponse& response)
{
    const double way = response.target - response.start;
    const double least = std::max(noise, noiseShare * std::abs(way));
    if (response.samples.empty() || std::abs(way) <= least)
        return std::nullopt;
    return std::any_of(response.samples.begin(), response.samples.end(),
                       [&](const record::StepSample& sample) {
                           const double gone = sample.position - response.start;
                           return (way < 0 ? -gone : gone) > least;
                       });
}

bool stood(const std::vector<record::StepResponse>& responses)
{
    bool any = false;
    for (const record::StepResponse& response : responses) {
        const auto went = moved(response);
        if (went.value_or(false))
            return false;
        any = any || went.has_value();
    }
    return any;
}

/// Neither gain nor speed explains it.
bool blocked(const record::StepResponse& response, const record::SweepAxis& axis)
{
    const auto& samples = response.samples;
    if (!response.missed || !response.seen || samples.size() < leastSamples)
        return false;
    const auto last = samples.end() - std::ptrdiff_t(samples.size() / 4);
    const auto [low, high] =
        std::minmax_element(last, samples.end(), [](const auto& one, const auto& other) {
            return one.position < other.position;
        });
    const double left = std::abs(samples.back().position - response.target);
    return high->position - low->position <= stillBand &&
           left > std::max(axis.tolerance, axis.stepsPerTurn / restShare);
}

class Adviser {
public:
    Adviser(const record::StepRun& run, const catalog::Profile& profile)
        : m_run(run)
        , m_profile(profile)
    {}

    std::vector<record::StepAdvice> advise();

private:
    void onOscillation();
    void onJitter();
    void onOvershoot();
    void onLag();
    void onStaticError();

    std::optional<std::int64_t> now(Role role) const;
    void propose(StepSymptom symptom, StepRemedy remedy, Role role, std::int64_t value);
    void say(StepSymptom symptom, StepRemedy remedy) { m_advice.push_back({symptom, remedy}); }

    bool missed() const
    {
        return std::any_of(m_run.responses.begin(), m_run.responses.end(),
                           [](const record::StepResponse& one) { return one.missed; });
    }
    bool swings() const { return m_run.mean.swings.value_or(0) >= manySwings; }

    const record::StepRun& m_run;
    const catalog::Profile& m_profile;
    std::vector<record::StepAdvice> m_advice;
};

std::int64_t little(std::int64_t value)
{
    return std::max<std::int64_t>(1, value / share);
}

/// What was in force while it ran.
std::optional<std::int64_t> Adviser::now(Role role) const
{
    const catalog::Register* reg = m_profile.byRole(role);
    if (reg == nullptr)
        return std::nullopt;
    for (const record::StepGain& gain : m_run.gains) {
        if (gain.key == reg->key)
            return gain.raw;
    }
    return std::nullopt;
}

void Adviser::propose(StepSymptom symptom, StepRemedy remedy, Role role, std::int64_t value)
{
    const catalog::Register& reg = *m_profile.byRole(role);
    const std::int64_t present = *now(role);
    const std::int64_t inside = std::clamp(
        value, reg.min.value_or(value), std::max(reg.min.value_or(value), reg.max.value_or(value)));
    if (inside != present)
        m_advice.push_back({symptom, remedy, reg.key, present, inside});
}

void Adviser::onOscillation()
{
    const auto p = now(Role::PositionP);
    if (!p)
        return;
    const auto stored = m_profile.byRole(Role::PositionP)->defaultRaw;
    const std::int64_t less = *p - std::max<std::int64_t>(1, *p / 4);
    propose(StepSymptom::Oscillation, StepRemedy::LowerP, Role::PositionP,
            stored && *stored < *p ? *stored : less);
}

void Adviser::onJitter()
{
    const StepSymptom jitter = StepSymptom::Jitter;
    if (const auto i = now(Role::PositionI); i && *i > 0)
        propose(jitter, StepRemedy::NoI, Role::PositionI, 0);
    if (const auto d = now(Role::PositionD); d && *d > 0)
        propose(jitter, StepRemedy::LowerD, Role::PositionD, *d - little(*d));
    if (const auto force = now(Role::StartupForce); force && *force > 0)
        propose(jitter, StepRemedy::LowerStartupForce, Role::StartupForce, *force - little(*force));
    for (const Role zone : {Role::CwDeadZone, Role::CcwDeadZone}) {
        if (const auto width = now(zone))
            propose(jitter, StepRemedy::WidenDeadZone, zone, *width + 1);
    }
}

void Adviser::onOvershoot()
{
    if (const auto d = now(Role::PositionD))
        propose(StepSymptom::Overshoot, StepRemedy::RaiseD, Role::PositionD, *d + little(*d));
}

void Adviser::onLag()
{
    const auto peak = m_run.mean.peakSpeed;
    const bool limited = !m_run.spec.speed.isEmpty() && m_run.axis.speed && peak &&
                         *peak >= atTheLimit * *m_run.axis.speed;
    if (limited)
        say(StepSymptom::SpeedLimit, StepRemedy::RaiseSpeed);
    if (!m_run.spec.acceleration.isEmpty() && m_run.axis.acceleration)
        say(StepSymptom::SpeedLimit, StepRemedy::RaiseAcceleration);
    const auto& mean = m_run.mean;
    const bool creeps = mean.riseTime && mean.deadTime && mean.timeToTarget &&
                        *mean.timeToTarget - *mean.deadTime - *mean.riseTime > *mean.riseTime;
    const auto p = now(Role::PositionP);
    if (p && (missed() || creeps))
        propose(StepSymptom::Lag, StepRemedy::RaiseP, Role::PositionP, *p + little(*p));
}

void Adviser::onStaticError()
{
    if (const auto i = now(Role::PositionI))
        propose(StepSymptom::StaticError, StepRemedy::RaiseI, Role::PositionI, *i + little(*i));
    for (const Role zone : {Role::CwDeadZone, Role::CcwDeadZone}) {
        if (const auto width = now(zone); width && *width > 0)
            propose(StepSymptom::StaticError, StepRemedy::NarrowDeadZone, zone, *width - 1);
    }
}

std::vector<record::StepAdvice> Adviser::advise()
{
    if (m_run.responses.empty())
        return {};
    const auto seen = [](const record::StepResponse& one) { return one.seen; };
    if (!std::all_of(m_run.responses.begin(), m_run.responses.end(), seen))
        say(StepSymptom::NotSeen, StepRemedy::RepeatRun);
    if (stood(m_run.responses)) {
        say(StepSymptom::NoMotion, StepRemedy::FreeMotion);
        return m_advice;
    }
    if (std::any_of(m_run.responses.begin(), m_run.responses.end(),
                    [this](const auto& one) { return blocked(one, m_run.axis); })) {
        say(StepSymptom::Blocked, StepRemedy::ClearWay);
        return m_advice;
    }
    const auto& mean = m_run.mean;
    if (swings()) {
        // What swings tells nothing about where it would rest.
        if (mean.swingAmplitude.value_or(0) > m_run.axis.tolerance)
            onOscillation();
        else
            onJitter();
        return m_advice;
    }
    const bool overshoots = mean.overshoot.value_or(0) > badOvershoot &&
                            mean.overshootSteps.value_or(0) > badOvershootSteps;
    if (overshoots)
        onOvershoot();
    onLag();
    // More I would make it go further beyond.
    if (!overshoots && mean.steadyError.value_or(0) >= badError)
        onStaticError();
    return m_advice;
}
} // namespace

std::vector<record::StepAdvice> adviseStep(const record::StepRun& run,
                                           const catalog::Profile& profile)
{
    return Adviser(run, profile).advise();
}
} // namespace jobs
