// SPDX-License-Identifier: GPL-3.0-or-later
// What is read in a sweep test, and what in it is a reason to end.
#include "jobs/sweep/sweep_runner.h"

#include <algorithm>

namespace jobs {
using base::Duration;
using record::SweepEnd;
using namespace std::chrono_literals;

namespace {
constexpr Duration readInterval = 20ms;
/// Without motion for so long away from its target it is jammed.
constexpr Duration stallTime = 1s;
/// Who restarts misses at least so many readings.
constexpr int lossesAtRestart = 2;
} // namespace

void SweepRunner::readUntil(Duration until, const std::function<bool()>& done)
{
    while (!hasEnded()) {
        drain();
        if (hasEnded() || done() || now() >= until)
            return;
        if (!m_context.bus.pauseUntil(std::min(until, now() + readInterval), &m_context.stop))
            endRun(m_context.bus.emergencyCount() != m_emergencyCount ? SweepEnd::Emergency
                                                                      : SweepEnd::Stopped);
        reportProgress();
    }
}

void SweepRunner::drain()
{
    for (const bus::Sample& sample : m_context.bus.takeSamples(m_poll)) {
        if (const auto reading = m_reader.add(sample))
            handleSample(reading->servo, reading->sample);
    }
    checkLink();
}

void SweepRunner::handleSample(std::size_t i, const SweepSample& sample)
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

/// A servo that came in another one's place may bring an alarm along.
void SweepRunner::endOnAlarm(std::size_t i)
{
    if (hasEnded())
        return;
    (void)findReplacedServos();
    endRun(SweepEnd::Alarm, int(i));
}

/// Only who has torque can be jammed.
void SweepRunner::endOnStall(std::size_t i)
{
    if (hasEnded())
        return;
    m_checkHolding = true;
    const auto isHolding = areStillHolding();
    if (isHolding && *isHolding)
        endRun(SweepEnd::Stall, int(i));
}

/// A silence of the line is heard of by every servo.
void SweepRunner::noteGap(Duration from, Duration span)
{
    if (!m_run.gaps.empty() && from < m_run.gaps.back().at + m_run.gaps.back().span) {
        record::SweepGap& last = m_run.gaps.back();
        last.span = std::max(last.at + last.span, from + span) - last.at;
    } else {
        m_run.gaps.push_back({from, span});
    }
}

void SweepRunner::checkLink()
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
                   m_context.bus.isReconnecting() ? -1 : int(i)); // a plug is of no servo
    }
}
} // namespace jobs
