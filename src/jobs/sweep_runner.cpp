// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep_runner.h"

#include "jobs/sweep_axis.h"
#include "jobs/sweep_meter.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using base::Duration;
using base::ErrorCode;
using record::SweepEnd;
using record::SweepShape;
using namespace std::chrono_literals;

namespace {
constexpr Duration reportEvery = 100ms;

/// At rest for so long it has arrived at the start. One that rests a little beside it comes no
/// nearer: how far that is the test will measure.
constexpr Duration approachRest = 200ms;

/// Goals of a sine follow each other so fast that the servo's own ramp does not show.
constexpr Duration waveStep = 20ms;

/// A leg that is not over after thrice its time has missed its target.
constexpr Duration slowestStart = 2s;
constexpr Duration unknownTravel = 20s;

/// What nobody saw from beginning to end is not measured.
void forgetMotion(record::SweepLeg& leg)
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
void forgetRest(record::SweepLeg& leg)
{
    leg.reached.reset();
    leg.steadyError.reset();
}
} // namespace

SweepRunner::SweepRunner(const device::Context& context, std::vector<device::Servo>& servos,
                         record::SweepRun run, const SweepWatch& watch)
    : m_context(context)
    , m_servos(servos)
    , m_run(std::move(run))
    , m_watch(watch)
    , m_reader(servos)
    , m_emergencies(context.bus.emergencies())
{
    for (const record::SweepServo& servo : m_run.servos)
        m_tracks.push_back({SweepPath(m_run.spec, servo.axis)});
}

base::Result<record::SweepRun> SweepRunner::run()
{
    const bus::LinkPatience patience(m_context.bus, mostSilence);
    m_poll = m_context.bus.startPoll(m_reader.plan());
    for (Track& track : m_tracks)
        track.heardAt = now();
    const auto moved = goThrough();
    if (!moved)
        endRun(SweepEnd::Refused); // nobody goes on towards a goal that was not to be
    record::giveVerdicts(m_run);
    m_context.bus.stopPoll(m_poll);
    m_toldAt = {};
    tellProgress();
    leaveSafe(m_context, m_servos, m_run, leaving(), m_watch);
    if (!moved)
        return tl::unexpected(moved.error());
    return std::move(m_run);
}

base::Result<void> SweepRunner::goThrough()
{
    if (const auto there = approach(); !there)
        return there;
    if (m_run.spec.warmUp > Duration::zero() && !ended()) {
        warmUp();
        if (const auto back = ended() ? base::Result<void>{} : approach(); !back)
            return back;
    }
    if (!ended()) {
        measure();
        confirmEnd();
        forgetLegsInDoubt();
        finish();
    }
    return {};
}

/// Finished is only a test whose servos have all answered after their last leg, still have
/// torque and are the ones that were tested. A silence is waited out here as in any leg.
void SweepRunner::confirmEnd()
{
    if (ended())
        return;
    const Duration over = now();
    m_askHeld = true;
    m_legInDoubt = true;
    const auto answered = [over](const Track& track) { return track.heardAt >= over; };
    for (;;) {
        read(Duration::max(),
             [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), answered); });
        if (ended())
            return;
        const auto held = stillHeld();
        if (held)
            return;
        if (!canRetry(held.error()))
            break;
    }
    endRun(SweepEnd::Refused);
}

/// When in its latest leg a servo has lost its torque, or was exchanged, is not known.
void SweepRunner::forgetLegsInDoubt()
{
    if (!m_legInDoubt)
        return;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        std::vector<record::SweepLeg>& legs = m_run.servos[i].legs;
        if (!m_tracks[i].held() && !legs.empty())
            legs.pop_back();
    }
}

/// To the first place of the path, which is no leg.
base::Result<void> SweepRunner::approach()
{
    // How long it may take is known only from where it stands.
    const auto placed = [](const Track& track) { return track.position.has_value(); };
    read(now() + mostSilence,
         [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), placed); });
    std::vector<double> targets;
    for (const Track& track : m_tracks)
        targets.push_back(track.path.first());
    if (ended())
        return {};
    if (const auto sent = send(targets); !sent || ended())
        return sent;
    const Duration at = now();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        Track& track = m_tracks[i];
        track.meter.emplace(m_run.servos[i].axis, 0, 0, at, track.position.value_or(track.goal),
                            track.goal);
    }
    const auto there = [](const Track& track) {
        return track.meter->arrived(approachRest) || track.meter->standsNear(approachRest);
    };
    const auto allThere = [&] { return std::all_of(m_tracks.begin(), m_tracks.end(), there); };
    read(at + patience(), allThere);
    if (silent()) { // perhaps it is there
        read(Duration::max(), [this] { return !silent(); });
        read(now() + patience(), allThere);
    }
    for (std::size_t i = 0; i < m_tracks.size() && !ended(); ++i) {
        if (!m_tracks[i].meter->arrived(Duration::zero()) && !there(m_tracks[i]))
            return notAtStart(i);
        m_reader.anchor(i, m_tracks[i].goal);
    }
    for (Track& track : m_tracks)
        track.meter.reset();
    return {};
}

/// Who has lost its torque on the way is not to blame for that.
base::Result<void> SweepRunner::notAtStart(std::size_t i)
{
    m_askHeld = true;
    if (const auto held = stillHeld(); held && !*held)
        return {};
    endRun(SweepEnd::Stall, int(i));
    return tl::unexpected(base::Error{ErrorCode::Refused, QStringLiteral("sweep"),
                                      QStringLiteral("no-start"), m_servos[i].id});
}

/// The same legs, not measured.
void SweepRunner::warmUp()
{
    const Duration end = now() + m_run.spec.warmUp;
    for (int number = 1; !ended() && now() < end; ++number)
        step(number);
    for (Track& track : m_tracks)
        track.meter.reset();
}

void SweepRunner::measure()
{
    m_measuring = true;
    m_start = now();
    m_nextAt = {};
    m_before = m_context.bus.statistics();
    for (Track& track : m_tracks)
        track.answered = 0;
    for (int number = 1; !ended() && !over(number); ++number)
        step(number);
}

bool SweepRunner::over(int number) const
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
        wave(number);
        return;
    }
    std::vector<double> targets;
    Duration pause = m_run.spec.pause;
    for (const Track& track : m_tracks) {
        const SweepStop stop = track.path.leg(number);
        targets.push_back(stop.target);
        pause = stop.pause.value_or(pause);
    }
    if (!sendOrEnd(targets))
        return;
    const Duration at = now();
    begin(number, at);
    if (m_run.spec.pace == record::SweepPace::Delay) {
        // From instant to instant, so that delays do not add up with what sending takes.
        const bool onTime = m_nextAt > Duration::zero() && at - m_nextAt < pause;
        m_nextAt = (onTime ? m_nextAt : at) + pause;
        read(m_nextAt, [] { return false; });
    } else {
        read(at + patience() + pause, [&] { return arrived(pause); });
    }
    close();
    judgeCycle(number);
}

/// Goals along half a period.
void SweepRunner::wave(int number)
{
    const Duration half = m_run.spec.period / 2;
    if (number == 1) {
        if (!confirmHeld()) // it has rested at the start
            return;
        m_waveStart = now();
    }
    const Duration end = m_waveStart + number * half;
    begin(number, now());
    for (Track& track : m_tracks) {
        const Duration before = now() - m_waveStart;
        track.meter->follow(
            [&track, before](Duration since) { return track.path.wave(before + since); },
            m_run.spec.period);
        track.meter->command(now(), track.goal);
    }
    while (!ended() && now() < end) {
        std::vector<double> targets;
        for (const Track& track : m_tracks)
            targets.push_back(track.path.wave(now() - m_waveStart));
        if (!sendOrEnd(targets))
            break;
        for (Track& track : m_tracks)
            track.meter->command(now(), track.goal);
        read(std::min(end, now() + waveStep), [] { return false; });
    }
    close();
    judgeCycle(number);
}

void SweepRunner::begin(int number, Duration at)
{
    m_leg = m_measuring ? number : 0;
    m_legAt = at;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        Track& track = m_tracks[i];
        track.gapInLeg = false;
        const SweepStop stop = track.path.leg(number);
        double target = stop.target;
        (void)sweepMove(m_servos[i], m_run.spec, target);
        track.meter.emplace(m_run.servos[i].axis, number, stop.cycle, at,
                            track.position.value_or(track.goal), target);
        if (m_measuring && m_watch.onGoal)
            m_watch.onGoal(i, number, at);
    }
}

/// The leg is over: its figures are worked out and kept.
void SweepRunner::close()
{
    drain();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        Track& track = m_tracks[i];
        if (!track.meter || !m_measuring)
            continue;
        record::SweepLeg leg = track.meter->finish(now(), m_start);
        // A target that there was no time for is not missed, nor one that nobody saw it come to:
        // when that was is not known either.
        const bool endUnseen = now() - track.heardAt >= gapFrom;
        const bool unseen = track.gapInLeg || endUnseen;
        leg.missed = leg.missed && !ended() && !unseen;
        if (unseen) {
            forgetMotion(leg);
            m_nextAt = {}; // the next leg gets its whole time
        }
        if (endUnseen)
            forgetRest(leg);
        m_run.servos[i].legs.push_back(leg);
        if (m_watch.onLeg)
            m_watch.onLeg(i, leg);
    }
    const bool lost = std::any_of(m_tracks.begin(), m_tracks.end(),
                                  [](const Track& track) { return !track.held(); });
    m_legInDoubt = m_askHeld || lost;
    for (Track& track : m_tracks)
        track.meter.reset();
    m_legAt = Duration::max(); // what comes now belongs to none
}

void SweepRunner::endRun(SweepEnd end, int servo)
{
    if (m_ended)
        return;
    m_ended = true;
    m_fault = servo;
    m_run.end = end;
    m_run.endedBy = servo < 0 ? -1 : m_servos[std::size_t(servo)].id;
}

/// Neither heat nor a jammed lever gets better by pushing on; a servo that has come in another
/// one's place is none of the test's.
std::vector<Leaving> SweepRunner::leaving() const
{
    std::vector<Leaving> all(m_tracks.size(), Leaving::AsOrdered);
    if (m_fault >= 0)
        all[std::size_t(m_fault)] = Leaving::Released;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        if (m_tracks[i].exchanged)
            all[i] = Leaving::Alone;
    }
    return all;
}

bool SweepRunner::arrived(Duration rest) const
{
    return std::all_of(m_tracks.begin(), m_tracks.end(),
                       [rest](const Track& track) { return track.meter->arrived(rest); });
}

/// So long a servo may take for what it has been told.
Duration SweepRunner::patience() const
{
    Duration longest{};
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        const Track& track = m_tracks[i];
        const double way = track.goal - track.position.value_or(track.goal);
        const auto travel = travelTime(std::abs(way), m_run.servos[i].axis);
        longest = std::max(longest, travel ? 3 * *travel + slowestStart : unknownTravel);
    }
    return longest;
}

void SweepRunner::tellProgress()
{
    if (!m_watch.onProgress || (m_toldAt > Duration::zero() && now() - m_toldAt < reportEvery))
        return;
    m_toldAt = now();
    SweepProgress progress;
    progress.ended = ended();
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        const Duration silence = now() - m_tracks[i].heardAt;
        if (silence < gapFrom)
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
    m_watch.onProgress(progress);
}

/// After each cycle, when the first failure is to end the test.
void SweepRunner::judgeCycle(int number)
{
    if (!m_run.spec.stopOnFailure || !m_measuring || ended() ||
        number % m_tracks.front().path.legsPerCycle() != 0)
        return;
    const bus::Statistics statistics = m_context.bus.statistics();
    for (std::size_t i = 0; i < m_tracks.size() && !ended(); ++i) {
        work(i, statistics);
        if (record::worst(m_run.servos[i].lines) != record::Grade::Fail)
            continue;
        if (confirmHeld()) // else that may be what has failed
            endRun(SweepEnd::Failure, int(i));
        else
            m_legInDoubt = true;
    }
}

/// Figures and grades of one servo from what there is so far.
void SweepRunner::work(std::size_t i, const bus::Statistics& statistics)
{
    record::SweepServo& servo = m_run.servos[i];
    const auto of = [id = m_servos[i].id](const bus::Statistics& all) {
        const auto found = all.byId.find(id);
        return found != all.byId.end() ? found->second : bus::Counters{};
    };
    const bus::Counters after = of(statistics);
    const bus::Counters before = of(m_before);
    servo.errors = {after.sent - before.sent, after.timeOuts - before.timeOuts,
                    after.badChecks - before.badChecks, after.foreign - before.foreign,
                    after.late - before.late};
    servo.metrics = sweepMetrics(servo.legs, servo.errors, m_tracks[i].startCelsius,
                                 followedPath(m_run.spec, servo.axis));
    servo.lines = record::judge(servo, servo.metrics, m_run.spec.shape);
}

void SweepRunner::finish()
{
    m_run.length = now() - m_start;
    const bus::Statistics statistics = m_context.bus.statistics();
    std::uint64_t answered = 0;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        work(i, statistics);
        answered += m_tracks[i].answered;
    }
    const double seconds = std::chrono::duration<double>(m_run.length).count();
    if (seconds > 0)
        m_run.sampleRate = double(answered) / double(m_tracks.size()) / seconds;
}
} // namespace jobs
