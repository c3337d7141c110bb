// SPDX-License-Identifier: GPL-3.0-or-later
// How PollingService processes the samples.
#include "session/polling/polling_service.h"

#include <algorithm>

namespace session {
using base::Duration;
using catalog::Role;
using recording::MarkKind;

namespace {
constexpr double degreesPerSecondPerRpm = 6;

/// As measured by the servo.
std::optional<double> speedIn(const Reading& reading, const device::Servo& servo)
{
    for (const jobs::PollValue& value : reading.values) {
        if (value.reg->role == Role::PresentSpeed &&
            servo.meaning(*value.reg).unit == QLatin1StringView("rpm"))
            return value.physical * degreesPerSecondPerRpm;
    }
    return std::nullopt;
}
} // namespace

std::vector<recording::Mark> latchAlarms(ServoEntry& entry, Duration at)
{
    std::vector<recording::Mark> marks;
    for (const AlarmLatch::Change& change : entry.alarms.update(activeAlarms(entry.servo), at)) {
        QString text = change.what.key;
        if (change.what.derived)
            text += QStringLiteral(" (derived)");
        marks.push_back(
            {at, change.raised ? MarkKind::Fault : MarkKind::FaultCleared, entry.servo.id, text});
    }
    return marks;
}

namespace {
/// The polled table shows which model answers.
bool isDifferentModel(const catalog::Profile& profile, const bus::Sample& sample)
{
    constexpr std::size_t head = 5; // firmware, byte order, model
    constexpr std::size_t modelMajor = 3;
    const catalog::Identity& identity = profile.identity;
    if (sample.protocol != base::Protocol::Feetech || sample.address != 0 ||
        sample.data.size() < head)
        return false;
    return sample.data[0] != identity.firmwareMajor || sample.data[1] != identity.firmwareMinor ||
           sample.data[modelMajor] != identity.modelMajor ||
           sample.data[modelMajor + 1] != identity.modelMinor;
}
} // namespace

ReadingBatch PollingService::takeBatch(bus::Bus& bus, const EntryLookup& entryLookup)
{
    m_batch = {};
    m_takenAt = bus.clock().now();
    // At another baud rate the servo could not answer.
    const bool here = bus.baud() == m_baud;
    std::map<Source*, ServoEntry*> entries;
    for (std::size_t poll = 0; poll < m_polls.size(); ++poll) {
        if (m_polls[poll] == 0)
            continue;
        for (const bus::Sample& sample : bus.takeSamples(m_polls[poll])) {
            const auto found = m_sources.find({sample.protocol, sample.id});
            if (found == m_sources.end() || (!sample.answered && !here))
                continue;
            Source& source = found->second;
            const auto [it, first] = entries.try_emplace(&source, nullptr);
            if (first) {
                ServoEntry* known = entryLookup(source.target.ref);
                const bool same = known != nullptr && known->servo.id == sample.id &&
                                  known->servo.profile == source.target.profile;
                it->second = same ? known : nullptr;
                for (PollState& state : source.polls) {
                    if (same)
                        state.reader.updateMeanings(known->servo);
                }
            }
            if (it->second != nullptr)
                takeSample(source, poll, *it->second, sample);
        }
    }
    for (const auto& [source, entry] : entries) {
        if (entry == nullptr)
            continue;
        finishBatch(*source, *entry);
        // Another servo may be in its place when it answers again.
        if (m_batch.changed.count(entry->ref) > 0)
            bus.verifiedIds().remove(entry->servo.protocol, entry->servo.id, m_baud);
    }
    std::stable_sort(m_batch.readings.begin(), m_batch.readings.end(),
                     [](const Reading& a, const Reading& b) { return a.at < b.at; });
    std::stable_sort(m_batch.marks.begin(), m_batch.marks.end(),
                     [](const auto& a, const auto& b) { return a.at < b.at; });
    return std::move(m_batch);
}

void PollingService::takeSample(Source& source, std::size_t poll, ServoEntry& entry,
                                const bus::Sample& sample)
{
    PollState& state = source.polls[poll];
    if (auto unfinished = state.reader.takeUnfinishedBefore(sample))
        takeReading(source.target, entry, std::move(*unfinished));
    state.answered[state.reader.blockIndex(sample)] = sample.answered;
    if (sample.answered && isDifferentModel(*source.target.profile, sample))
        entry.silent = true;
    // After a silence it is not known yet which servo answers.
    if (auto reading = state.reader.add(sample, entry.silent ? nullptr : &entry.servo))
        takeReading(source.target, entry, std::move(*reading));
}

void PollingService::takeReading(const PollTarget& target, ServoEntry& entry,
                                 jobs::PollReading polled)
{
    Reading reading{std::move(polled), target.ref, target.profile};
    if (!entry.servo.repliesCarryStatus() || !reading.answered)
        reading.status = entry.servo.status;
    updateState(entry, reading);
    if (entry.silent && reading.answered)
        return;
    count(reading);
    m_batch.updated.insert(entry.ref);
    m_batch.readings.push_back(std::move(reading));
}

/// Presence, alarms and turns that follow from a reading.
void PollingService::updateState(ServoEntry& entry, const Reading& reading)
{
    if (reading.answered && !entry.silent)
        entry.statusAt = reading.at;
    const LinkMonitor::Transition news = entry.linkMonitor.addReading(
        reading.answered, reading.at, reading.error == base::ErrorCode::Garbled);
    if (news == LinkMonitor::Transition::Lost) {
        entry.silent = true;
        m_batch.marks.push_back({entry.linkMonitor.silentSince().value_or(reading.at),
                                 MarkKind::LinkError, entry.servo.id,
                                 base::errorName(reading.error)});
    } else if (news == LinkMonitor::Transition::Back) {
        entry.turns.reset(); // it may have been without supply
        m_batch.marks.push_back({reading.at, MarkKind::LinkRestored, entry.servo.id, {}});
    }
    const bool garbled = entry.linkMonitor.isLost() && entry.linkMonitor.isGarbled();
    const bool garbledChanged = std::exchange(entry.garbled, garbled) != garbled;
    if (news != LinkMonitor::Transition::None || garbledChanged)
        m_batch.changed.insert(entry.ref);
    if (!reading.answered)
        return;
    entry.lastSeen = reading.at;
    if (entry.silent) { // until it has been identified
        if (!std::exchange(entry.answeredAgain, true))
            m_batch.changed.insert(entry.ref);
        return;
    }
    const bool statusChanged = std::exchange(entry.servo.status, reading.status) != reading.status;
    if (statusChanged || !entry.servo.repliesCarryStatus()) {
        const auto marks = latchAlarms(entry, reading.at);
        m_batch.marks.insert(m_batch.marks.end(), marks.begin(), marks.end());
        if (statusChanged || !marks.empty())
            m_batch.changed.insert(entry.ref);
    }
    for (const jobs::PollValue& value : reading.values) {
        if (value.reg->role == Role::PresentPosition)
            entry.turns.reading(value.raw, speedIn(reading, entry.servo), reading.at);
    }
}

/// Once per servo and batch.
void PollingService::finishBatch(Source& source, ServoEntry& entry)
{
    entry.firstImage.mergeMissing(entry.servo.image);
    entry.turns.on(device::turnBasis(entry.servo));
    const auto& registers = source.target.profile->registers;
    for (PollState& state : source.polls) {
        const auto& spans = state.reader.spans();
        for (const auto& [block, answered] : std::exchange(state.answered, {})) {
            if (block >= spans.size() || (answered && entry.unreadable.empty()))
                continue;
            const bus::PollSpan& span = spans[block];
            for (const catalog::Register& reg : registers) {
                if (reg.offset < span.address || reg.offset + reg.size > span.address + span.count)
                    continue;
                if (answered)
                    entry.unreadable.erase(reg.key);
                else
                    entry.unreadable.insert(reg.key);
            }
        }
    }
}
} // namespace session
