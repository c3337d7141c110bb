// SPDX-License-Identifier: GPL-3.0-or-later
// What PollingService makes of the samples that have come.
#include "device/alarms.h"
#include "session/polling/polling_service.h"

#include <algorithm>

namespace session {
using base::Duration;
using catalog::Role;
using record::MarkKind;

namespace {
/// A round whose other blocks stay out for so long (the servo is held by a job) is given up.
constexpr Duration maxRoundDuration = std::chrono::seconds(1);
constexpr double degreesPerSecondPerRpm = 6;

/// As the servo measures it.
std::optional<double> speedIn(const Reading& reading, const device::Servo& servo)
{
    for (const ReadValue& value : reading.values) {
        if (value.reg->role == Role::PresentSpeed &&
            servo.meaning(*value.reg).unit == QLatin1StringView("rpm"))
            return value.physical * degreesPerSecondPerRpm;
    }
    return std::nullopt;
}
} // namespace

std::vector<record::Mark> latchAlarms(ServoEntry& entry, Duration at)
{
    std::vector<record::Mark> marks;
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
/// The polled table shows who answers.
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

/// What phase and mode make of the registers may have changed since the batch before.
void PollingService::updateMeanings(Source& source, const ServoEntry& entry)
{
    for (Field& field : source.fields)
        field.meaning = entry.servo.meaning(*field.reg);
}

ReadingBatch PollingService::takeBatch(bus::Bus& bus, const EntryLookup& entryLookup)
{
    m_batch = {};
    m_takenAt = bus.clock().now();
    // Whoever has been taken to another rate could not answer.
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
                if (same)
                    updateMeanings(source, *known);
            }
            if (it->second != nullptr)
                takeSample(source, poll, *it->second, sample);
        }
    }
    for (const auto& [source, entry] : entries) {
        if (entry == nullptr)
            continue;
        finishBatch(*source, *entry);
        // Another servo may stand in its place when it is heard again.
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
    Round& round = source.rounds[poll];
    const std::size_t block = jobs::blockIndex(sample, spansOf(source, poll));
    if (round.cut.startsNewRound(block) ||
        (round.cut.open() && round.reading.at < sample.at - maxRoundDuration))
        finishRound(source, poll, entry);
    round.answered[block] = sample.answered;
    Reading& reading = round.reading;
    reading.at = sample.at;
    if (sample.answered && isDifferentModel(*source.target.profile, sample))
        entry.silent = true;
    if (sample.answered && entry.silent) {
        reading.answered = true; // by whom is not known yet
    } else if (sample.answered) {
        device::Servo& servo = entry.servo;
        servo.image.store(sample.address, sample.data, sample.at);
        if (servo.repliesCarryStatus())
            reading.status = sample.status;
        else
            device::updateStatus(servo, sample.address, static_cast<int>(sample.data.size()));
        reading.answered = true;
        decode(source, reading, sample);
    } else {
        reading.error = sample.error;
    }
    if (round.cut.take(block, sample))
        finishRound(source, poll, entry);
}

void PollingService::decode(const Source& source, Reading& into, const bus::Sample& sample)
{
    const base::ByteView data(sample.data);
    for (const Field& field : source.fields) {
        const int offset = field.reg->offset - sample.address;
        if (offset < 0 || offset + field.reg->size > static_cast<int>(data.size()))
            continue;
        const auto wire = data.subspan(static_cast<std::size_t>(offset),
                                       static_cast<std::size_t>(field.reg->size));
        const std::int64_t raw =
            catalog::decodeRaw(wire, *field.reg, field.meaning, source.target.profile->byteOrder);
        into.values.push_back({field.reg, raw, catalog::toPhysical(raw, field.meaning)});
    }
}

void PollingService::finishRound(Source& source, std::size_t poll, ServoEntry& entry)
{
    Round& round = source.rounds[poll];
    round.cut.reset();
    Reading reading = std::exchange(round.reading, Reading{});
    reading.values.reserve(source.fields.size());
    round.reading.values.reserve(source.fields.size());
    reading.servo = source.target.ref;
    reading.profile = source.target.profile;
    if (!entry.servo.repliesCarryStatus() || !reading.answered)
        reading.status = entry.servo.status;
    updateState(entry, reading);
    if (entry.silent && reading.answered)
        return;
    count(reading);
    m_batch.updated.insert(entry.ref);
    m_batch.readings.push_back(std::move(reading));
}

/// What a reading tells beside its numbers.
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
    for (const ReadValue& value : reading.values) {
        if (value.reg->role == Role::PresentPosition)
            entry.turns.reading(value.raw, speedIn(reading, entry.servo), reading.at);
    }
}

/// Once a servo and batch, however many readings there were.
void PollingService::finishBatch(Source& source, ServoEntry& entry)
{
    entry.firstImage.mergeMissing(entry.servo.image);
    entry.turns.on(device::turnBasis(entry.servo));
    const auto& registers = source.target.profile->registers;
    for (std::size_t poll = 0; poll < source.rounds.size(); ++poll) {
        const auto& spans = spansOf(source, poll);
        for (const auto& [block, answered] : std::exchange(source.rounds[poll].answered, {})) {
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
