// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step/step_advice.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using catalog::Role;
using results::StepRemedy;
using results::StepSymptom;

namespace {
constexpr double minSwings = 4;
constexpr double overshootThreshold = 2;      ///< %
constexpr double overshootStepsThreshold = 4; ///< above the noise of any encoder
constexpr double staticErrorThreshold = 2;    ///< steps: row 14 of the advice
constexpr double speedLimitFraction = 0.95;
constexpr std::int64_t gainDivisor = 8; ///< of the value: a small step
constexpr double positionNoise = 3;     ///< steps
constexpr std::size_t minSamples = 20;
constexpr double restBand = 4; ///< steps
constexpr double arrivalFraction = 64;
constexpr double noiseFraction = 0.02;

/// Nothing is known of a response without readings, nor of one that began at its target.
std::optional<bool> hasMoved(const results::StepResponse& response)
{
    const double way = response.target - response.start;
    const double minDistance = std::max(positionNoise, noiseFraction * std::abs(way));
    if (response.samples.empty() || std::abs(way) <= minDistance)
        return std::nullopt;
    return std::any_of(response.samples.begin(), response.samples.end(),
                       [&](const results::StepSample& sample) {
                           const double travel = sample.position - response.start;
                           return (way < 0 ? -travel : travel) > minDistance;
                       });
}

bool neverMoved(const std::vector<results::StepResponse>& responses)
{
    bool any = false;
    for (const results::StepResponse& response : responses) {
        const auto firstMotion = hasMoved(response);
        if (firstMotion.value_or(false))
            return false;
        any = any || firstMotion.has_value();
    }
    return any;
}

/// Neither gain nor speed explains it.
bool isBlocked(const results::StepResponse& response, const results::SweepAxis& axis)
{
    const auto& samples = response.samples;
    if (!response.missed || !response.seen || samples.size() < minSamples)
        return false;
    const auto last = samples.end() - std::ptrdiff_t(samples.size() / 4);
    const auto [low, high] =
        std::minmax_element(last, samples.end(), [](const auto& one, const auto& other) {
            return one.position < other.position;
        });
    const double remaining = std::abs(samples.back().position - response.target);
    return high->position - low->position <= restBand &&
           remaining > std::max(axis.tolerance, axis.stepsPerTurn / arrivalFraction);
}

class StepAdvisor {
public:
    StepAdvisor(const results::StepRun& run, const catalog::Profile& profile)
        : m_run(run)
        , m_profile(profile)
    {}

    std::vector<results::StepAdvice> advices();

private:
    void adviseOnOscillation();
    void adviseOnJitter();
    void adviseOnOvershoot();
    void adviseOnLag();
    void adviseOnStaticError();

    std::optional<std::int64_t> now(Role role) const;
    void propose(StepSymptom symptom, StepRemedy remedy, Role role, std::int64_t value);
    void addAdvice(StepSymptom symptom, StepRemedy remedy)
    {
        m_advice.push_back({symptom, remedy});
    }

    bool missed() const
    {
        return std::any_of(m_run.responses.begin(), m_run.responses.end(),
                           [](const results::StepResponse& one) { return one.missed; });
    }
    bool swings() const { return m_run.mean.swings.value_or(0) >= minSwings; }

    const results::StepRun& m_run;
    const catalog::Profile& m_profile;
    std::vector<results::StepAdvice> m_advice;
};

std::int64_t smallStep(std::int64_t value)
{
    return std::max<std::int64_t>(1, value / gainDivisor);
}

/// The value during the run.
std::optional<std::int64_t> StepAdvisor::now(Role role) const
{
    const catalog::Register* reg = m_profile.byRole(role);
    if (reg == nullptr)
        return std::nullopt;
    for (const results::StepGain& gain : m_run.gains) {
        if (gain.key == reg->key)
            return gain.raw;
    }
    return std::nullopt;
}

void StepAdvisor::propose(StepSymptom symptom, StepRemedy remedy, Role role, std::int64_t value)
{
    const catalog::Register& reg = *m_profile.byRole(role);
    const std::int64_t present = *now(role);
    const std::int64_t inside = std::clamp(
        value, reg.min.value_or(value), std::max(reg.min.value_or(value), reg.max.value_or(value)));
    if (inside != present)
        m_advice.push_back({symptom, remedy, reg.key, present, inside});
}

void StepAdvisor::adviseOnOscillation()
{
    const auto p = now(Role::PositionP);
    if (!p)
        return;
    const auto stored = m_profile.byRole(Role::PositionP)->defaultRaw;
    const std::int64_t less = *p - std::max<std::int64_t>(1, *p / 4);
    propose(StepSymptom::Oscillation, StepRemedy::LowerP, Role::PositionP,
            stored && *stored < *p ? *stored : less);
}

void StepAdvisor::adviseOnJitter()
{
    const StepSymptom jitter = StepSymptom::Jitter;
    if (const auto i = now(Role::PositionI); i && *i > 0)
        propose(jitter, StepRemedy::DisableI, Role::PositionI, 0);
    if (const auto d = now(Role::PositionD); d && *d > 0)
        propose(jitter, StepRemedy::LowerD, Role::PositionD, *d - smallStep(*d));
    if (const auto force = now(Role::StartupForce); force && *force > 0)
        propose(jitter, StepRemedy::LowerStartupForce, Role::StartupForce,
                *force - smallStep(*force));
    for (const Role zone : {Role::CwDeadZone, Role::CcwDeadZone}) {
        if (const auto width = now(zone))
            propose(jitter, StepRemedy::WidenDeadZone, zone, *width + 1);
    }
}

void StepAdvisor::adviseOnOvershoot()
{
    if (const auto d = now(Role::PositionD))
        propose(StepSymptom::Overshoot, StepRemedy::RaiseD, Role::PositionD, *d + smallStep(*d));
}

void StepAdvisor::adviseOnLag()
{
    const auto peak = m_run.mean.peakSpeed;
    const bool limited = !m_run.spec.speed.isEmpty() && m_run.axis.speed && peak &&
                         *peak >= speedLimitFraction * *m_run.axis.speed;
    if (limited)
        addAdvice(StepSymptom::SpeedLimit, StepRemedy::RaiseSpeed);
    if (!m_run.spec.acceleration.isEmpty() && m_run.axis.acceleration)
        addAdvice(StepSymptom::SpeedLimit, StepRemedy::RaiseAcceleration);
    const auto& mean = m_run.mean;
    const bool creeps = mean.riseTime && mean.deadTime && mean.timeToTarget &&
                        *mean.timeToTarget - *mean.deadTime - *mean.riseTime > *mean.riseTime;
    const auto p = now(Role::PositionP);
    if (p && (missed() || creeps))
        propose(StepSymptom::Lag, StepRemedy::RaiseP, Role::PositionP, *p + smallStep(*p));
}

void StepAdvisor::adviseOnStaticError()
{
    if (const auto i = now(Role::PositionI))
        propose(StepSymptom::StaticError, StepRemedy::RaiseI, Role::PositionI, *i + smallStep(*i));
    for (const Role zone : {Role::CwDeadZone, Role::CcwDeadZone}) {
        if (const auto width = now(zone); width && *width > 0)
            propose(StepSymptom::StaticError, StepRemedy::NarrowDeadZone, zone, *width - 1);
    }
}

std::vector<results::StepAdvice> StepAdvisor::advices()
{
    if (m_run.responses.empty())
        return {};
    const auto seen = [](const results::StepResponse& one) { return one.seen; };
    if (!std::all_of(m_run.responses.begin(), m_run.responses.end(), seen))
        addAdvice(StepSymptom::NotSeen, StepRemedy::RepeatRun);
    if (neverMoved(m_run.responses)) {
        addAdvice(StepSymptom::NoMotion, StepRemedy::FreeMotion);
        return m_advice;
    }
    if (std::any_of(m_run.responses.begin(), m_run.responses.end(),
                    [this](const auto& one) { return isBlocked(one, m_run.axis); })) {
        addAdvice(StepSymptom::Blocked, StepRemedy::RemoveObstacle);
        return m_advice;
    }
    const auto& mean = m_run.mean;
    if (swings()) {
        // While it oscillates, its resting position is unknown.
        if (mean.swingAmplitude.value_or(0) > m_run.axis.tolerance)
            adviseOnOscillation();
        else
            adviseOnJitter();
        return m_advice;
    }
    const bool overshoots = mean.overshoot.value_or(0) > overshootThreshold &&
                            mean.overshootSteps.value_or(0) > overshootStepsThreshold;
    if (overshoots)
        adviseOnOvershoot();
    adviseOnLag();
    // More I would increase the overshoot.
    if (!overshoots && mean.steadyError.value_or(0) >= staticErrorThreshold)
        adviseOnStaticError();
    return m_advice;
}
} // namespace

std::vector<results::StepAdvice> adviseStep(const results::StepRun& run,
                                            const catalog::Profile& profile)
{
    return StepAdvisor(run, profile).advices();
}

bool wasMeasured(const results::StepAdvice& advice, const std::vector<results::StepRun>& runs)
{
    if (advice.key.isEmpty() || runs.empty())
        return false;
    const results::StepRun& last = runs.back();
    std::vector<results::StepGain> gains = last.gains;
    for (results::StepGain& gain : gains)
        gain.raw = gain.key == advice.key ? advice.proposed : gain.raw;
    return std::any_of(runs.begin(), runs.end() - 1, [&](const results::StepRun& run) {
        return run.end == results::SweepEnd::Finished &&
               run.parameters.servo == last.parameters.servo && results::isSameMotion(run, last) &&
               run.gains == gains;
    });
}

catalog::ProfilePtr profileOf(const results::StepRun& run, const catalog::Catalog& catalog)
{
    const snapshot::SnapshotServo& servo = run.parameters.servo;
    const catalog::ModelEntry* model = catalog.model(servo.model);
    const QStringList version = servo.firmware.split(QLatin1Char('.'));
    return model == nullptr
               ? nullptr
               : catalog.profileFor(*model, version.value(0).toInt(), version.value(1).toInt());
}

std::vector<results::StepAdvice> adviseStoredStep(const results::StepRun& run,
                                                  const catalog::Catalog& catalog)
{
    const catalog::ProfilePtr profile = profileOf(run, catalog);
    return profile ? adviseStep(run, *profile) : std::vector<results::StepAdvice>();
}
} // namespace jobs
