// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_runner.h"

#include "jobs/sweep/sweep_axis.h"
#include "jobs/sweep/sweep_statistics.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using base::Duration;
using base::ErrorCode;
using results::SweepEnd;
using results::SweepShape;
using namespace std::chrono_literals;

namespace {
constexpr Duration reportInterval = 100ms;

/// A servo at rest for this time has arrived at the start, even if it rests a little beside it: the
/// test will measure how far.
constexpr Duration approachRest = 200ms;

/// Goals of a sine follow each other so fast that the servo's own ramp does not show.
constexpr Duration sineInterval = 20ms;

/// A leg that is not over after three times its expected time has missed its target.
constexpr Duration maxStartDelay = 2s;
constexpr Duration defaultTravelTime = 20s;

/// A movement that was not seen from beginning to end is not measured.
void clearMotionFigures(results::SweepLeg& leg)
{
    leg.timeToTarget.reset();
    leg.settling.reset();
    leg.overshoot.reset();
    leg.overshootSteps.reset();
    leg.meanSpeed.reset();
    leg.topSpeed.reset();
    leg.followingError.reset();
    leg.phaseLag.reset();
}

/// If the end of a leg was not seen, its resting position is not known.
void clearRestFigures(results::SweepLeg& leg)
{
    leg.reached.reset();
    leg.steadyError.reset();
}
} // namespace

SweepRunner::SweepRunner(const device::Context& context, std::vector<device::Servo>& servos,
                         results::SweepRun run, const SweepCallbacks& callbacks)
    : m_context(context)
    , m_servos(servos)
    , m_run(std::move(run))
    , m_callbacks(callbacks)
    , m_link(context, servos, m_run, callbacks, [this] { reportProgress(); })
    , m_tracks(m_link.tracks())
{}

base::Result<results::SweepRun> SweepRunner::run()
{
    const bus::ReconnectScope reconnect(m_context.bus, SweepLink::maxSilence);
    m_link.startReading();
    const auto moved = runPhases();
    if (!moved)
        m_link.endRun(SweepEnd::Refused); // no servo moves on to a goal that was refused
    results::assignVerdicts(m_run);
    m_link.stopReading();
    m_progressAt = {};
    reportProgress();
    leaveServosSafe(m_context, m_servos, m_run, m_link.endStates(), m_callbacks);
    if (!moved)
        return tl::unexpected(moved.error());
    return std::move(m_run);
}

base::Result<void> SweepRunner::runPhases()
{
    if (const auto there = moveToStart(); !there)
        return there;
    if (m_run.spec.warmUp > Duration::zero() && !hasEnded()) {
        warmUp();
        if (const auto back = hasEnded() ? base::Result<void>{} : moveToStart(); !back)
            return back;
    }
    if (!hasEnded()) {
        measure();
        confirmFinalState();
        dropUncertainLegs();
        finish();
    }
    return {};
}

/// A test is finished only when all its servos have answered after their last leg, still have
/// torque and were not replaced. A silence is waited for here as in any leg.
void SweepRunner::confirmFinalState()
{
    if (hasEnded())
        return;
    const Duration over = now();
    m_link.requestHoldingCheck();
    m_link.markLegUncertain();
    const auto answered = [over](const SweepLink::ServoTrack& track) {
        return track.lastReplyAt >= over;
    };
    for (;;) {
        m_link.readUntil(Duration::max(),
                         [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), answered); });
        if (hasEnded())
            return;
        const auto isHolding = m_link.areStillHolding();
        if (isHolding)
            return;
        if (!m_link.canRetry(isHolding.error()))
            break;
    }
    m_link.endRun(SweepEnd::Refused);
}

/// It is not known when in its latest leg a servo lost its torque or was replaced.
void SweepRunner::dropUncertainLegs()
{
    if (!m_link.isLegUncertain())
        return;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        std::vector<results::SweepLeg>& legs = m_run.servos[i].legs;
        if (!m_tracks[i].isHolding() && !legs.empty())
            legs.pop_back();
    }
}

/// To the first position of the path; this movement is not a leg.
base::Result<void> SweepRunner::moveToStart()
{
    // The present position decides how long it may take.
    const auto hasPosition = [](const SweepLink::ServoTrack& track) {
        return track.position.has_value();
    };
    m_link.readUntil(now() + SweepLink::maxSilence,
                     [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), hasPosition); });
    std::vector<double> targets;
    for (const SweepLink::ServoTrack& track : m_tracks)
        targets.push_back(track.path.first());
    if (hasEnded())
        return {};
    if (const auto sent = m_link.send(targets); !sent || hasEnded())
        return sent;
    const Duration at = now();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        SweepLink::ServoTrack& track = m_tracks[i];
        track.meter.emplace(m_run.servos[i].axis, 0, 0, at, track.position.value_or(track.goal),
                            track.goal);
    }
    const auto there = [](const SweepLink::ServoTrack& track) {
        return track.meter->arrived(approachRest) || track.meter->restsNearTarget(approachRest);
    };
    const auto areAllAtStart = [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), there); };
    m_link.readUntil(at + timeout(), areAllAtStart);
    if (m_link.isAnySilent()) { // it may have arrived meanwhile
        m_link.readUntil(Duration::max(), [this] { return !m_link.isAnySilent(); });
        m_link.readUntil(now() + timeout(), areAllAtStart);
    }
    for (std::size_t i = 0; i < m_tracks.size() && !hasEnded(); ++i) {
        if (!m_tracks[i].meter->arrived(Duration::zero()) && !there(m_tracks[i]))
            return failAtStart(i);
        m_link.anchor(i, m_tracks[i].goal);
    }
    for (SweepLink::ServoTrack& track : m_tracks)
        track.meter.reset();
    return {};
}

/// A servo that lost its torque on the way is not reported as stalled.
base::Result<void> SweepRunner::failAtStart(std::size_t i)
{
    m_link.requestHoldingCheck();
    if (const auto isHolding = m_link.areStillHolding(); isHolding && !*isHolding)
        return {};
    m_link.endRun(SweepEnd::Stall, int(i));
    return tl::unexpected(base::Error{ErrorCode::Refused, QStringLiteral("sweep"),
                                      QStringLiteral("no-start"), m_servos[i].id});
}

/// The same legs, without measuring.
void SweepRunner::warmUp()
{
    const Duration end = now() + m_run.spec.warmUp;
    for (int number = 1; !hasEnded() && now() < end; ++number)
        step(number);
    for (SweepLink::ServoTrack& track : m_tracks)
        track.meter.reset();
}

void SweepRunner::measure()
{
    m_start = now();
    m_link.beginMeasuring(m_start);
    m_nextGoalAt = {};
    m_statisticsBefore = m_context.bus.statistics();
    for (int number = 1; !hasEnded() && !isOver(number); ++number)
        step(number);
}

bool SweepRunner::isOver(int number) const
{
    const int planned = legCount();
    const Duration length = m_run.spec.length;
    return (planned > 0 && number > planned) ||
           (length > Duration::zero() && now() - m_start >= length);
}

int SweepRunner::legCount() const
{
    return m_run.spec.cycles * m_tracks.front().path.legsPerCycle();
}

/// One leg of all servos: sends goals and reads until the leg is over.
void SweepRunner::step(int number)
{
    if (m_run.spec.shape == SweepShape::Sine) {
        runSineLeg(number);
        return;
    }
    std::vector<double> targets;
    Duration pause = m_run.spec.pause;
    for (const SweepLink::ServoTrack& track : m_tracks) {
        const SweepTarget stop = track.path.leg(number);
        targets.push_back(stop.target);
        pause = stop.pause.value_or(pause);
    }
    if (!m_link.sendOrEnd(targets))
        return;
    const Duration at = now();
    beginLeg(number, at);
    if (m_run.spec.pace == results::SweepPace::Delay) {
        // Counted from one due time to the next, so that the time for sending does not add up.
        const bool onTime = m_nextGoalAt > Duration::zero() && at - m_nextGoalAt < pause;
        m_nextGoalAt = (onTime ? m_nextGoalAt : at) + pause;
        m_link.readUntil(m_nextGoalAt, [] { return false; });
    } else {
        m_link.readUntil(at + timeout() + pause, [&] { return arrived(pause); });
    }
    endLeg();
    evaluateCycle(number);
}

/// Goals along half a period.
void SweepRunner::runSineLeg(int number)
{
    const Duration half = m_run.spec.period / 2;
    if (number == 1) {
        if (!m_link.confirmHolding()) // it was at rest at the start
            return;
        m_sineStart = now();
    }
    const Duration end = m_sineStart + number * half;
    beginLeg(number, now());
    for (SweepLink::ServoTrack& track : m_tracks) {
        const Duration before = now() - m_sineStart;
        track.meter->followPath(
            [&track, before](Duration since) { return track.path.sineTarget(before + since); },
            m_run.spec.period);
        track.meter->setGoal(now(), track.goal);
    }
    while (!hasEnded() && now() < end) {
        std::vector<double> targets;
        for (const SweepLink::ServoTrack& track : m_tracks)
            targets.push_back(track.path.sineTarget(now() - m_sineStart));
        if (!m_link.sendOrEnd(targets))
            break;
        for (SweepLink::ServoTrack& track : m_tracks)
            track.meter->setGoal(now(), track.goal);
        m_link.readUntil(std::min(end, now() + sineInterval), [] { return false; });
    }
    endLeg();
    evaluateCycle(number);
}

void SweepRunner::beginLeg(int number, Duration at)
{
    m_leg = m_link.isMeasuring() ? number : 0;
    m_link.beginLeg(m_leg, at);
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        SweepLink::ServoTrack& track = m_tracks[i];
        const SweepTarget stop = track.path.leg(number);
        double target = stop.target;
        (void)makeSweepMove(m_servos[i], m_run.spec, target);
        track.meter.emplace(m_run.servos[i].axis, number, stop.cycle, at,
                            track.position.value_or(track.goal), target);
        if (m_link.isMeasuring() && m_callbacks.onGoal)
            m_callbacks.onGoal(i, number, at);
    }
}

/// The leg is over: computes its figures and adds it to the run.
void SweepRunner::endLeg()
{
    m_link.drain();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        SweepLink::ServoTrack& track = m_tracks[i];
        if (!track.meter || !m_link.isMeasuring())
            continue;
        results::SweepLeg leg = track.meter->finish(now(), m_start);
        // A target without enough time is not missed, nor one whose arrival was not seen; then the
        // time of arrival is unknown, too.
        const bool endUnseen = now() - track.lastReplyAt >= SweepLink::minGap;
        const bool unseen = track.gapInLeg || endUnseen;
        leg.missed = leg.missed && !hasEnded() && !unseen;
        if (unseen) {
            clearMotionFigures(leg);
            m_nextGoalAt = {}; // the next leg gets its full time
        }
        if (endUnseen)
            clearRestFigures(leg);
        m_run.servos[i].legs.push_back(leg);
        if (m_callbacks.onLeg)
            m_callbacks.onLeg(i, leg);
    }
    m_link.endLeg();
}

bool SweepRunner::arrived(Duration rest) const
{
    return std::all_of(
        m_tracks.begin(), m_tracks.end(),
        [rest](const SweepLink::ServoTrack& track) { return track.meter->arrived(rest); });
}

/// The longest time that a servo may take to its goal.
Duration SweepRunner::timeout() const
{
    Duration maxTravelTime{};
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        const SweepLink::ServoTrack& track = m_tracks[i];
        const double way = track.goal - track.position.value_or(track.goal);
        const auto travel = travelTime(std::abs(way), m_run.servos[i].axis);
        maxTravelTime =
            std::max(maxTravelTime, travel ? 3 * *travel + maxStartDelay : defaultTravelTime);
    }
    return maxTravelTime;
}

void SweepRunner::reportProgress()
{
    if (!m_callbacks.onProgress ||
        (m_progressAt > Duration::zero() && now() - m_progressAt < reportInterval))
        return;
    m_progressAt = now();
    SweepProgress progress;
    progress.ended = hasEnded();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        const Duration silence = now() - m_tracks[i].lastReplyAt;
        if (silence < SweepLink::minGap)
            continue;
        progress.silent.push_back(m_servos[i].id);
        progress.silentFor = std::max(progress.silentFor, silence);
    }
    progress.warmingUp = !m_link.isMeasuring();
    progress.leg = m_leg;
    if (m_link.isMeasuring()) {
        const int planned = legCount();
        progress.elapsed = now() - m_start;
        progress.cycle = m_tracks.front().path.leg(std::max(1, m_leg)).cycle;
        double done = planned > 0 ? double(m_leg) / planned : 0;
        if (m_run.spec.length > Duration::zero())
            done = std::max(done,
                            double(progress.elapsed.count()) / double(m_run.spec.length.count()));
        progress.fraction = std::clamp(done, 0.0, 1.0);
        if (progress.fraction > 0)
            progress.remaining = Duration(
                std::llround(double(progress.elapsed.count()) * (1 / progress.fraction - 1)));
    }
    m_callbacks.onProgress(progress);
}

/// After each cycle, if the first failure ends the test.
void SweepRunner::evaluateCycle(int number)
{
    if (!m_run.spec.stopOnFailure || !m_link.isMeasuring() || hasEnded() ||
        number % m_tracks.front().path.legsPerCycle() != 0)
        return;
    const bus::Statistics statistics = m_context.bus.statistics();
    for (std::size_t i = 0; i < m_tracks.size() && !hasEnded(); ++i) {
        updateMetrics(i, statistics);
        if (results::worstGrade(m_run.servos[i].lines) != results::Grade::Fail)
            continue;
        if (m_link.confirmHolding()) // a servo without torque fails as well
            m_link.endRun(SweepEnd::Failure, int(i));
        else
            m_link.markLegUncertain();
    }
}

/// Figures and grades of one servo from the legs so far.
void SweepRunner::updateMetrics(std::size_t i, const bus::Statistics& statistics)
{
    results::SweepServo& servo = m_run.servos[i];
    const auto of = [id = m_servos[i].id](const bus::Statistics& all) {
        const auto found = all.byId.find(id);
        return found != all.byId.end() ? found->second : bus::Counters{};
    };
    const bus::Counters after = of(statistics);
    const bus::Counters before = of(m_statisticsBefore);
    servo.errors = {after.sent - before.sent, after.timeouts - before.timeouts,
                    after.badChecksums - before.badChecksums, after.foreign - before.foreign,
                    after.late - before.late};
    servo.metrics = sweepMetrics(servo.legs, servo.errors, m_tracks[i].startCelsius,
                                 referencePath(m_run.spec, servo.axis));
    servo.lines = results::evaluate(servo, servo.metrics, m_run.spec.shape);
}

void SweepRunner::finish()
{
    m_run.length = now() - m_start;
    const bus::Statistics statistics = m_context.bus.statistics();
    std::uint64_t answered = 0;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        updateMetrics(i, statistics);
        answered += m_tracks[i].answered;
    }
    const double seconds = std::chrono::duration<double>(m_run.length).count();
    if (seconds > 0)
        m_run.sampleRate = double(answered) / double(m_tracks.size()) / seconds;
}
} // namespace jobs
