// SPDX-License-Identifier: GPL-3.0-or-later
// What is read in a sweep test, and what in it is a reason to end.
#include "jobs/sweep_runner.h"

#include <algorithm>

namespace jobs {
using base::Duration;
using record::SweepEnd;
using namespace std::chrono_literals;

namespace {
constexpr Duration readEvery = 20ms;
/// Without motion for so long away from its target it is jammed.
constexpr Duration stallTime = 1s;
/// Who restarts misses at least so many readings.
constexpr int lostInRestart = 2;
} // namespace

void SweepRunner::read(Duration until, const std::function<bool()>& done)
{
    while (!ended()) {
        drain();
        if (ended() || done() || now() >= until)
            return;
        if (!m_context.bus.pauseUntil(std::min(until, now() + readEvery), &m_context.stop))
            endRun(m_context.bus.emergencies() != m_emergencies ? SweepEnd::Emergency
                                                                : SweepEnd::Stopped);
        tellProgress();
    }
}

void SweepRunner::drain()
{
    for (const bus::Sample& sample : m_context.bus.takeSamples(m_poll)) {
        if (const auto reading = m_reader.add(sample))
            take(reading->servo, reading->sample);
    }
    watchLine();
}

void SweepRunner::take(std::size_t i, const SweepSample& sample)
{
    Track& track = m_tracks[i];
    if (sample.answered) {
        const Duration silence = sample.at - track.heardAt;
        if (m_measuring && silence >= gapFrom)
            noteGap(track.heardAt - m_start, silence);
        m_askHeld |= silence >= gapFrom;
        track.gapInLeg |= silence >= gapFrom;
        track.heardAt = sample.at;
        track.lostInARow = 0;
        ++track.answered;
        if (sample.position)
            track.position = sample.position;
        if (!track.startCelsius || !m_measuring)
            track.startCelsius = sample.temperature ? sample.temperature : track.startCelsius;
    } else {
        m_askHeld |= ++track.lostInARow >= lostInRestart;
    }
    if (track.meter)
        track.meter->add(sample);
    if (m_watch.onSample)
        m_watch.onSample(i, sample, track.goal, sample.at < m_legAt ? 0 : m_leg);
    if (m_run.spec.stopOnAlarm && sample.answered && sample.status != 0)
        blameAlarm(i);
    if (m_run.spec.stopOnStall && track.meter && track.meter->stalled(stallTime))
        blameStall(i);
}

/// A servo that came in another one's place may bring an alarm along.
void SweepRunner::blameAlarm(std::size_t i)
{
    if (ended())
        return;
    (void)findExchanged();
    endRun(SweepEnd::Alarm, int(i));
}

/// Only who has torque can be jammed.
void SweepRunner::blameStall(std::size_t i)
{
    if (ended())
        return;
    m_askHeld = true;
    const auto held = stillHeld();
    if (held && *held)
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

void SweepRunner::watchLine()
{
    if (ended())
        return;
    if (m_context.bus.lost())
        endRun(SweepEnd::LinkLost);
    else if (m_context.bus.emergencies() != m_emergencies)
        endRun(SweepEnd::Emergency);
    for (std::size_t i = 0; i < m_tracks.size() && !ended(); ++i) {
        if (now() - m_tracks[i].heardAt > mostSilence)
            endRun(SweepEnd::LinkLost, m_context.bus.away() ? -1 : int(i)); // a plug is of no servo
    }
}
} // namespace jobs
