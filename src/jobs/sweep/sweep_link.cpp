// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_link.h"

#include "device/transactions.h"
#include "device/write_access.h"

#include <algorithm>

namespace jobs {
using base::Duration;
using base::ErrorCode;
using results::SweepEnd;
using namespace std::chrono_literals;

namespace {
constexpr Duration readInterval = 20ms;
/// A servo that does not move for this time, away from its target, is stalled.
constexpr Duration stallTime = 1s;
/// A restart costs at least this number of readings.
constexpr int lossesAtRestart = 2;
} // namespace

SweepLink::SweepLink(const device::Context& context, std::vector<device::Servo>& servos,
                     results::SweepRun& run, const SweepCallbacks& callbacks,
                     std::function<void()> onRead)
    : m_context(context)
    , m_servos(servos)
    , m_run(run)
    , m_callbacks(callbacks)
    , m_onRead(std::move(onRead))
    , m_reader(servos)
    , m_emergencyCount(context.bus.emergencyCount())
{
    for (const results::SweepServo& servo : run.servos)
        m_tracks.push_back({SweepPath(run.spec, servo.axis)});
}

void SweepLink::startReading()
{
    m_poll = m_context.bus.startPoll(m_reader.plan());
    for (ServoTrack& track : m_tracks)
        track.lastReplyAt = now();
}

void SweepLink::stopReading()
{
    m_context.bus.stopPoll(m_poll);
}

void SweepLink::beginMeasuring(Duration start)
{
    m_measuring = true;
    m_start = start;
    for (ServoTrack& track : m_tracks)
        track.answered = 0;
}

void SweepLink::beginLeg(int leg, Duration at)
{
    m_leg = leg;
    m_legStart = at;
    for (ServoTrack& track : m_tracks)
        track.gapInLeg = false;
}

/// Readings that come now belong to no leg.
void SweepLink::endLeg()
{
    m_isLegUncertain =
        m_checkHolding || std::any_of(m_tracks.begin(), m_tracks.end(),
                                      [](const ServoTrack& track) { return !track.isHolding(); });
    for (ServoTrack& track : m_tracks)
        track.meter.reset();
    m_legStart = Duration::max();
}

void SweepLink::readUntil(Duration until, const std::function<bool()>& done)
{
    while (!hasEnded()) {
        drain();
        if (hasEnded() || done() || now() >= until)
            return;
        if (!m_context.bus.pauseUntil(std::min(until, now() + readInterval), &m_context.stop))
            endStopped();
        m_onRead();
    }
}

/// An emergency stop asks the job to stop as well.
void SweepLink::endStopped()
{
    endRun(m_context.bus.emergencyCount() != m_emergencyCount ? SweepEnd::Emergency
                                                              : SweepEnd::Stopped);
}

void SweepLink::drain()
{
    for (const bus::Sample& sample : m_context.bus.takeSamples(m_poll)) {
        if (const auto reading = m_reader.add(sample))
            handleSample(reading->servo, reading->sample);
    }
    checkLink();
}

void SweepLink::handleSample(std::size_t i, const SweepSample& sample)
{
    ServoTrack& track = m_tracks[i];
    if (sample.answered) {
        const Duration silence = sample.at - track.lastReplyAt;
        if (m_measuring && silence >= minGap)
            noteGap(track.lastReplyAt - m_start, silence);
        m_checkHolding |= silence >= minGap;
        track.gapInLeg |= silence >= minGap;
        track.lastReplyAt = sample.at;
        track.consecutiveLosses = 0;
        ++track.answered;
        if (sample.position)
            track.position = sample.position;
        if (!track.startCelsius || !m_measuring)
            track.startCelsius = sample.temperature ? sample.temperature : track.startCelsius;
    } else {
        m_checkHolding |= ++track.consecutiveLosses >= lossesAtRestart;
    }
    if (track.meter)
        track.meter->add(sample);
    if (m_callbacks.onSample)
        m_callbacks.onSample(i, sample, track.goal, sample.at < m_legStart ? 0 : m_leg);
    if (m_run.spec.stopOnAlarm && sample.answered && sample.status != 0)
        endOnAlarm(i);
    if (m_run.spec.stopOnStall && track.meter && track.meter->isStalled(stallTime))
        endOnStall(i);
}

/// The alarm may come from a servo that replaced the tested one.
void SweepLink::endOnAlarm(std::size_t i)
{
    if (hasEnded())
        return;
    (void)findReplacedServos();
    endRun(SweepEnd::Alarm, int(i));
}

/// Only a servo with torque can be stalled.
void SweepLink::endOnStall(std::size_t i)
{
    if (hasEnded())
        return;
    m_checkHolding = true;
    const auto isHolding = areStillHolding();
    if (isHolding && *isHolding)
        endRun(SweepEnd::Stall, int(i));
}

/// A silence of the line is reported once by each servo: those that overlap are one gap.
void SweepLink::noteGap(Duration from, Duration span)
{
    if (!m_run.gaps.empty() && from < m_run.gaps.back().at + m_run.gaps.back().span) {
        results::SweepGap& last = m_run.gaps.back();
        last.span = std::max(last.at + last.span, from + span) - last.at;
    } else {
        m_run.gaps.push_back({from, span});
    }
}

void SweepLink::checkLink()
{
    if (hasEnded())
        return;
    if (m_context.bus.lost())
        endRun(SweepEnd::LinkLost);
    else if (m_context.bus.emergencyCount() != m_emergencyCount)
        endRun(SweepEnd::Emergency);
    for (std::size_t i = 0; i < m_tracks.size() && !hasEnded(); ++i) {
        if (now() - m_tracks[i].lastReplyAt > maxSilence)
            endRun(SweepEnd::LinkLost,
                   m_context.bus.isReconnecting() ? -1 : int(i)); // unplugged: no servo's fault
    }
}
/// Tries again while the line is silent; the caller gets any other error.
base::Result<void> SweepLink::send(std::vector<double> targets)
{
    for (;;) {
        const bool anySign = m_checkHolding || isAnySilent();
        // A servo at rest shows no sign of torque that was switched off, nor of a replacement. The
        // goals of a sine follow each other too closely for a check before each of them.
        m_checkHolding |= m_run.spec.shape != results::SweepShape::Sine || !m_hasSentGoal;
        const auto isHolding = areStillHolding();
        if (isHolding && !*isHolding) {
            m_isLegUncertain |= !anySign; // it may have happened before the leg was over
            return {};
        }
        const auto sent = isHolding ? sendSweepGoals(m_context, m_servos, m_run.spec, targets)
                                    : base::Result<void>(tl::unexpected(isHolding.error()));
        if (sent) {
            for (std::size_t i = 0; i < m_tracks.size(); ++i)
                m_tracks[i].goal = targets[i];
            m_hasSentGoal = true;
            return {};
        }
        if (!canRetry(sent.error()))
            return hasEnded() ? base::Result<void>{} : sent;
    }
}

/// True after an error that a silent line explains, once the line was read for a while. An error
/// that ends the test ends it here.
bool SweepLink::canRetry(const base::Error& error)
{
    switch (error.code) {
    case ErrorCode::NoReply:
    case ErrorCode::Garbled:
    case ErrorCode::UnexpectedReply:
    case ErrorCode::LineBusy:
    case ErrorCode::Uncertain: // sending a position goal twice does no harm
        m_checkHolding = true;
        readUntil(now() + minGap, [] { return false; });
        return !hasEnded();
    case ErrorCode::Stopped:
        endStopped();
        return false;
    case ErrorCode::Preempted:
        endRun(SweepEnd::Emergency);
        return false;
    case ErrorCode::LinkLost:
        endRun(SweepEnd::LinkLost);
        return false;
    case ErrorCode::IdentityMismatch:
        endReplaced(indexOfServo(error.id));
        return false;
    default:
        return false;
    }
}

/// A servo that restarted, or that another program switched off, has no torque: a goal would turn
/// it on by surprise, from wherever the servo has sunk to. A servo that replaced it has other
/// limits. In both cases the run ends, and this is false. Before the first goal torque may be off:
/// that goal turns it on.
base::Result<bool> SweepLink::areStillHolding()
{
    m_checkHolding |= isAnySilent();
    if (!m_checkHolding)
        return true;
    if (const auto asked = findReplacedServos(); !asked)
        return tl::unexpected(asked.error());
    for (std::size_t i = 0; m_hasSentGoal && i < m_servos.size(); ++i) {
        device::Servo& servo = m_servos[i];
        const catalog::Register* torque = servo.profile->byRole(catalog::Role::TorqueSwitch);
        if (torque == nullptr || m_tracks[i].isReplaced)
            continue;
        const auto raw = device::readRegister(m_context, servo, *torque);
        if (!raw && hasEnded())
            continue; // the run has ended because of another servo
        if (!raw)
            return tl::unexpected(raw.error());
        if (*raw != 0)
            continue;
        // What has no torque may be a servo that has replaced it since it was asked.
        if (const auto asked = findReplacedServos(); !asked)
            return tl::unexpected(asked.error());
        m_tracks[i].hasLostTorque = !m_tracks[i].isReplaced;
        endRun(SweepEnd::TorqueLost, int(i));
    }
    m_checkHolding = false;
    return std::all_of(m_tracks.begin(), m_tracks.end(),
                       [](const ServoTrack& track) { return track.isHolding(); });
}

/// A servo can be replaced by another one with its ID, with or without a silence in between.
base::Result<void> SweepLink::findReplacedServos()
{
    const auto ask = [this](const device::Servo& servo) {
        return device::requireSameServo(m_context, servo, QStringLiteral("sweep"));
    };
    for (std::size_t i = 0; i < m_servos.size(); ++i) {
        auto same = ask(m_servos[i]);
        // With so many readings a disturbed reply may pass its checksum, but hardly twice in a row.
        if (!same && same.error().code == ErrorCode::IdentityMismatch)
            same = ask(m_servos[i]);
        if (!same && same.error().code == ErrorCode::IdentityMismatch)
            endReplaced(int(i));
        else if (!same && !hasEnded())
            return same;
    }
    return {};
}

void SweepLink::endReplaced(int servo)
{
    if (servo >= 0)
        m_tracks[std::size_t(servo)].isReplaced = true;
    endRun(SweepEnd::ServoReplaced, servo);
}

/// Checks every servo and waits until a silence is over. False: the run has ended.
bool SweepLink::confirmHolding()
{
    while (!hasEnded()) {
        m_checkHolding = true;
        const auto isHolding = areStillHolding();
        if (isHolding)
            return *isHolding;
        if (!canRetry(isHolding.error()))
            endRun(SweepEnd::Refused);
    }
    return false;
}

bool SweepLink::isAnySilent() const
{
    return std::any_of(m_tracks.begin(), m_tracks.end(), [this](const ServoTrack& track) {
        return now() - track.lastReplyAt >= minGap;
    });
}

bool SweepLink::sendOrEnd(const std::vector<double>& targets)
{
    const auto sent = send(targets);
    if (!sent) {
        // The servo does not take a goal it took before: its limits or mode have changed.
        endRun(SweepEnd::Refused, indexOfServo(sent.error().id));
    }
    return !hasEnded();
}

int SweepLink::indexOfServo(int id) const
{
    for (std::size_t i = 0; i < m_servos.size(); ++i) {
        if (m_servos[i].id == id)
            return int(i);
    }
    return -1;
}

void SweepLink::endRun(SweepEnd end, int servo)
{
    if (m_ended)
        return;
    m_ended = true;
    m_faultIndex = servo;
    m_run.end = end;
    m_run.endedBy = servo < 0 ? -1 : m_servos[std::size_t(servo)].id;
}

/// Torque would make an overheated or jammed servo worse; a servo that replaced a tested one is not
/// touched.
std::vector<ServoEndState> SweepLink::endStates() const
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
} // namespace jobs
