// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/alarms.h"
#include "device/reader.h"
#include "session/desk_work.h"

#include <algorithm>

namespace session {
namespace {
constexpr base::Duration silentAfter = std::chrono::seconds(1);
} // namespace

void Desk::watchLive(ServoRef ref, const QStringList& keys, base::Duration period)
{
    if (ref == m_live.servo && keys == m_live.keys && period == m_live.period)
        return;
    stopPoll();
    m_live = {keys.isEmpty() ? 0 : ref, keys, period, 0, -1, {}, {}};
    updateLive();
}

void Desk::stopPoll()
{
    if (m_live.poll != 0 && m_connection) {
        collectSamples();
        m_connection->bus().stopPoll(m_live.poll);
    }
    m_live.poll = 0;
    m_liveTimer.stop();
}

/// Polling goes on only while nobody takes the bus to another rate.
bool Desk::mayPoll(const ServoEntry& entry) const
{
    const bool rateMoves = m_search && m_search->started && !m_search->staysHere;
    const bool here = !hasBaud() || entry.servo.baud == baud();
    const bool otherWork = m_running && m_running->ref != entry.ref;
    return m_state == LinkState::Open && entry.servo.profile && here && !rateMoves && !otherWork;
}

void Desk::updateLive()
{
    const ServoEntry* known = servo(m_live.servo);
    const bool may = known != nullptr && mayPoll(*known);
    const bool other =
        may && (known->servo.id != m_live.id || known->servo.profile != m_live.profile);
    if (!may || other)
        stopPoll();
    if (!may || m_live.poll != 0)
        return;
    const catalog::Profile& profile = *known->servo.profile;
    std::vector<const catalog::Register*> registers;
    for (const QString& key : m_live.keys) {
        if (const catalog::Register* reg = profile.find(key))
            registers.push_back(reg);
    }
    if (registers.empty())
        return;
    bus::PollPlan plan;
    plan.period = m_live.period;
    m_live.spans = device::planSpans(profile, registers);
    plan.servos.push_back({known->servo.id, m_live.spans, false, 0, known->servo.protocol,
                           profile.readGap, profile.maxRead});
    m_live.id = known->servo.id;
    m_live.profile = known->servo.profile;
    m_live.poll = m_connection->bus().startPoll(plan);
    m_liveTimer.start();
}

void Desk::takeSamples()
{
    collectSamples();
    updateLive(); // it may have a new ID now: asked under that one
}

void Desk::collectSamples()
{
    if (m_live.poll == 0 || !m_connection)
        return;
    const auto samples = m_connection->bus().takeSamples(m_live.poll);
    ServoEntry* known = entry(m_live.servo);
    if (known == nullptr || samples.empty())
        return;
    const std::uint8_t statusBefore = known->servo.status;
    const bool silentBefore = known->silent;
    for (const bus::Sample& sample : samples)
        take(*known, sample);
    const ServoRef ref = known->ref;
    const bool news = known->servo.status != statusBefore || known->silent != silentBefore;
    Q_EMIT tableChanged(ref);
    if (news)
        Q_EMIT servoChanged(ref);
}

void Desk::take(ServoEntry& entry, const bus::Sample& sample)
{
    const catalog::Profile& profile = *entry.servo.profile;
    if (sample.id != entry.servo.id || entry.servo.profile != m_live.profile)
        return;
    const auto span =
        std::find_if(m_live.spans.begin(), m_live.spans.end(),
                     [&](const bus::PollSpan& one) { return one.address == sample.address; });
    int end = sample.address + static_cast<int>(sample.data.size());
    if (!sample.answered && span != m_live.spans.end())
        end = span->address + span->count;
    // One register that never answers (stored move of some LX) is not a silent servo.
    entry.silent = !sample.answered && now() - entry.lastSeen > silentAfter;
    if (sample.answered) {
        entry.servo.image.store(sample.address, sample.data, sample.at);
        entry.firstImage.takeMissing(entry.servo.image);
        entry.lastSeen = sample.at;
        if (entry.servo.repliesCarryStatus())
            entry.servo.status = sample.status;
        else
            device::takeStatus(entry.servo, sample.address, static_cast<int>(sample.data.size()));
    }
    for (const catalog::Register& reg : profile.registers) {
        if (reg.offset < sample.address || reg.offset + reg.size > end)
            continue;
        if (sample.answered)
            entry.unreadable.erase(reg.key);
        else
            entry.unreadable.insert(reg.key);
    }
}
} // namespace session
