// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_runner.h"

#include "jobs/sweep/sweep_axis.h"
#include "jobs/sweep/sweep_statistics.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using base::Duration;
using base::ErrorCode;
using record::SweepEnd;
using record::SweepShape;
using namespace std::chrono_literals;

namespace {
constexpr Duration reportInterval = 100ms;

/// At rest for so long it has arrived at the start. One that rests a little beside it comes no
/// nearer: how far that is the test will measure.
constexpr Duration approachRest = 200ms;

/// Goals of a sine follow each other so fast that the servo's own ramp does not show.
constexpr Duration sineInterval = 20ms;

/// A leg that is not over after thrice its time has missed its target.
constexpr Duration maxStartDelay = 2s;
constexpr Duration defaultTravelTime = 20s;

/// What nobody saw from beginning to end is not measured.
void clearMotionFigures(record::SweepLeg& leg)
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

/// Where it came to rest is not known of a leg whose end was not seen.
void clearRestFigures(record::SweepLeg& leg)
{
    leg.reached.reset();
    leg.steadyError.reset();
}
} // namespace

SweepRunner::SweepRunner(const device::Context& context, std::vector<device::Servo>& servos,
                         record::SweepRun run, const SweepCallbacks& callbacks)
    : m_context(context)
    , m_servos(servos)
    , m_run(std::move(run))
    , m_callbacks(callbacks)
    , m_reader(servos)
    , m_emergencyCount(context.bus.emergencyCount())
{
    for (const record::SweepServo& servo : m_run.servos)
        m_tracks.push_back({SweepPath(m_run.spec, servo.axis)});
}

base::Result<record::SweepRun> SweepRunner::run()
{
    const bus::ReconnectScope reconnect(m_context.bus, maxSilence);
    m_poll = m_context.bus.startPoll(m_reader.plan());
    for (ServoTrack& track : m_tracks)
        track.lastReplyAt = now();
    const auto moved = runPhases();
    if (!moved)
        endRun(SweepEnd::Refused); // nobody goes on towards a goal that was not to be
    record::assignVerdicts(m_run);
    m_context.bus.stopPoll(m_poll);
    m_progressAt = {};
    reportProgress();
    leaveServosSafe(m_context, m_servos, m_run, endStates(), m_callbacks);
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

/// Finished is only a test whose servos have all answered after their last leg, still have
/// torque and are the ones that were tested. A silence is waited out here as in any leg.
void SweepRunner::confirmFinalState()
{
    if (hasEnded())
        return;
    const Duration over = now();
    m_checkHolding = true;
    m_isLegUncertain = true;
    const auto answered = [over](const ServoTrack& track) { return track.lastReplyAt >= over; };
    for (;;) {
        readUntil(Duration::max(),
                  [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), answered); });
        if (hasEnded())
            return;
        const auto isHolding = areStillHolding();
        if (isHolding)
            return;
        if (!canRetry(isHolding.error()))
            break;
    }
    endRun(SweepEnd::Refused);
}

/// When in its latest leg a servo has lost its torque, or was exchanged, is not known.
void SweepRunner::dropUncertainLegs()
{
    if (!m_isLegUncertain)
        return;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        std::vector<record::SweepLeg>& legs = m_run.servos[i].legs;
        if (!m_tracks[i].isHolding() && !legs.empty())
            legs.pop_back();
    }
}

/// To the first place of the path, which is no leg.
base::Result<void> SweepRunner::moveToStart()
{
    // How long it may take is known only from where it stands.
    const auto hasPosition = [](const ServoTrack& track) { return track.position.has_value(); };
    readUntil(now() + maxSilence,
              [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), hasPosition); });
    std::vector<double> targets;
    for (const ServoTrack& track : m_tracks)
        targets.push_back(track.path.first());
    if (hasEnded())
        return {};
    if (const auto sent = send(targets); !sent || hasEnded())
        return sent;
    const Duration at = now();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        ServoTrack& track = m_tracks[i];
        track.meter.emplace(m_run.servos[i].axis, 0, 0, at, track.position.value_or(track.goal),
                            track.goal);
    }
    const auto there = [](const ServoTrack& track) {
        return track.meter->arrived(approachRest) || track.meter->restsNearTarget(approachRest);
    };
    const auto areAllAtStart = [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), there); };
    readUntil(at + timeout(), areAllAtStart);
    if (isAnySilent()) { // perhaps it is there
        readUntil(Duration::max(), [this] { return !isAnySilent(); });
        readUntil(now() + timeout(), areAllAtStart);
    }
    for (std::size_t i = 0; i < m_tracks.size() && !hasEnded(); ++i) {
        if (!m_tracks[i].meter->arrived(Duration::zero()) && !there(m_tracks[i]))
            return failAtStart(i);
        m_reader.anchor(i, m_tracks[i].goal);
    }
    for (ServoTrack& track : m_tracks)
        track.meter.reset();
    return {};
}

/// Who has lost its torque on the way is not to blame for that.
base::Result<void> SweepRunner::failAtStart(std::size_t i)
{
    m_checkHolding = true;
    if (const auto isHolding = areStillHolding(); isHolding && !*isHolding)
        return {};
    endRun(SweepEnd::Stall, int(i));
    return tl::unexpected(base::Error{ErrorCode::Refused, QStringLiteral("sweep"),
                                      QStringLiteral("no-start"), m_servos[i].id});
}

/// The same legs, not measured.
void SweepRunner::warmUp()
{
    const Duration end = now() + m_run.spec.warmUp;
    for (int number = 1; !hasEnded() && now() < end; ++number)
        step(number);
    for (ServoTrack& track : m_tracks)
        track.meter.reset();
}

void SweepRunner::measure()
{
    m_measuring = true;
    m_start = now();
    m_nextGoalAt = {};
    m_statisticsBefore = m_context.bus.statistics();
    for (ServoTrack& track : m_tracks)
        track.answered = 0;
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

/// One leg of all servos: goals, and reading until it is over.
void SweepRunner::step(int number)
{
    if (m_run.spec.shape == SweepShape::Sine) {
        runSineLeg(number);
        return;
    }
    std::vector<double> targets;
    Duration pause = m_run.spec.pause;
    for (const ServoTrack& track : m_tracks) {
        const SweepTarget stop = track.path.leg(number);
        targets.push_back(stop.target);
        pause = stop.pause.value_or(pause);
    }
    if (!sendOrEnd(targets))
        return;
    const Duration at = now();
    beginLeg(number, at);
    if (m_run.spec.pace == record::SweepPace::Delay) {
        // From instant to instant, so that delays do not add up with what sending takes.
        const bool onTime = m_nextGoalAt > Duration::zero() && at - m_nextGoalAt < pause;
        m_nextGoalAt = (onTime ? m_nextGoalAt : at) + pause;
        readUntil(m_nextGoalAt, [] { return false; });
    } else {
        readUntil(at + timeout() + pause, [&] { return arrived(pause); });
    }
    endLeg();
    evaluateCycle(number);
}

/// Goals along half a period.
void SweepRunner::runSineLeg(int number)
{
    const Duration half = m_run.spec.period / 2;
    if (number == 1) {
        if (!confirmHolding()) // it has rested at the start
            return;
        m_sineStart = now();
    }
    const Duration end = m_sineStart + number * half;
    beginLeg(number, now());
    for (ServoTrack& track : m_tracks) {
        const Duration before = now() - m_sineStart;
        track.meter->followPath(
            [&track, before](Duration since) { return track.path.sineTarget(before + since); },
            m_run.spec.period);
        track.meter->setGoal(now(), track.goal);
    }
    while (!hasEnded() && now() < end) {
        std::vector<double> targets;
        for (const ServoTrack& track : m_tracks)
            targets.push_back(track.path.sineTarget(now() - m_sineStart));
        if (!sendOrEnd(targets))
            break;
        for (ServoTrack& track : m_tracks)
            track.meter->setGoal(now(), track.goal);
        readUntil(std::min(end, now() + sineInterval), [] { return false; });
    }
    endLeg();
    evaluateCycle(number);
}

void SweepRunner::beginLeg(int number, Duration at)
{
    m_leg = m_measuring ? number : 0;
    m_legStart = at;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        ServoTrack& track = m_tracks[i];
        track.gapInLeg = false;
        const SweepTarget stop = track.path.leg(number);
        double target = stop.target;
        (void)makeSweepMove(m_servos[i], m_run.spec, target);
        track.meter.emplace(m_run.servos[i].axis, number, stop.cycle, at,
                            track.position.value_or(track.goal), target);
        if (m_measuring && m_callbacks.onGoal)
            m_callbacks.onGoal(i, number, at);
    }
}

/// The leg is over: its figures are worked out and kept.
void SweepRunner::endLeg()
{
    drain();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        ServoTrack& track = m_tracks[i];
        if (!track.meter || !m_measuring)
            continue;
        record::SweepLeg leg = track.meter->finish(now(), m_start);
        // A target that there was no time for is not missed, nor one that nobody saw it come to:
        // when that was is not known either.
        const bool endUnseen = now() - track.lastReplyAt >= minGap;
        const bool unseen = track.gapInLeg || endUnseen;
        leg.missed = leg.missed && !hasEnded() && !unseen;
        if (unseen) {
            clearMotionFigures(leg);
            m_nextGoalAt = {}; // the next leg gets its whole time
        }
        if (endUnseen)
            clearRestFigures(leg);
        m_run.servos[i].legs.push_back(leg);
        if (m_callbacks.onLeg)
            m_callbacks.onLeg(i, leg);
    }
    const bool lost = std::any_of(m_tracks.begin(), m_tracks.end(),
                                  [](const ServoTrack& track) { return !track.isHolding(); });
    m_isLegUncertain = m_checkHolding || lost;
    for (ServoTrack& track : m_tracks)
        track.meter.reset();
    m_legStart = Duration::max(); // what comes now belongs to none
}

void SweepRunner::endRun(SweepEnd end, int servo)
{
    if (m_ended)
        return;
    m_ended = true;
    m_faultIndex = servo;
    m_run.end = end;
    m_run.endedBy = servo < 0 ? -1 : m_servos[std::size_t(servo)].id;
}

/// Neither heat nor a jammed lever gets better by pushing on; a servo that has come in another
/// one's place is none of the test's.
std::vector<ServoEndState> SweepRunner::endStates() const
{
    std::vector<ServoEndState> all(m_tracks.size(), ServoEndState::AsRequested);
    if (m_faultIndex >= 0)
        all[std::size_t(m_faultIndex)] = ServoEndState::TorqueOff;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        if (m_tracks[i].isReplaced)
            all[i] = ServoEndState::Untouched;
    }
    return all;
}

bool SweepRunner::arrived(Duration rest) const
{
    return std::all_of(m_tracks.begin(), m_tracks.end(),
                       [rest](const ServoTrack& track) { return track.meter->arrived(rest); });
}

/// So long a servo may take for what it has been told.
Duration SweepRunner::timeout() const
{
    Duration maxTravelTime{};
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        const ServoTrack& track = m_tracks[i];
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
        if (silence < minGap)
            continue;
        progress.silent.push_back(m_servos[i].id);
        progress.silentFor = std::max(progress.silentFor, silence);
    }
    progress.warmingUp = !m_measuring;
    progress.leg = m_leg;
    if (m_measuring) {
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

/// After each cycle, when the first failure is to end the test.
void SweepRunner::evaluateCycle(int number)
{
    if (!m_run.spec.stopOnFailure || !m_measuring || hasEnded() ||
        number % m_tracks.front().path.legsPerCycle() != 0)
        return;
    const bus::Statistics statistics = m_context.bus.statistics();
    for (std::size_t i = 0; i < m_tracks.size() && !hasEnded(); ++i) {
        updateMetrics(i, statistics);
        if (record::worstGrade(m_run.servos[i].lines) != record::Grade::Fail)
            continue;
        if (confirmHolding()) // else that may be what has failed
            endRun(SweepEnd::Failure, int(i));
        else
            m_isLegUncertain = true;
    }
}

/// Figures and grades of one servo from what there is so far.
void SweepRunner::updateMetrics(std::size_t i, const bus::Statistics& statistics)
{
    record::SweepServo& servo = m_run.servos[i];
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
    servo.lines = record::evaluate(servo, servo.metrics, m_run.spec.shape);
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
