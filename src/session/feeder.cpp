// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/feeder.h"

#include "device/alarms.h"

#include <algorithm>

namespace session {
using base::Duration;
using catalog::Role;
using record::MarkKind;

namespace {
/// A round whose other blocks stay out for so long (the servo is held by a job) is given up.
constexpr Duration longestRound = std::chrono::seconds(1);
constexpr Duration rateSpan = std::chrono::seconds(1);
constexpr double degreesPerSecondPerRpm = 6;

void forgetOld(std::deque<Duration>& instants, Duration before)
{
    while (!instants.empty() && instants.front() <= before)
        instants.pop_front();
}

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
    for (const AlarmLatch::Change& change : entry.alarms.update(alarmsNow(entry.servo), at)) {
        QString text = change.what.key;
        if (change.what.derived)
            text += QStringLiteral(" (derived)");
        marks.push_back(
            {at, change.came ? MarkKind::Fault : MarkKind::FaultOver, entry.servo.id, text});
    }
    return marks;
}

void Feeder::wish(const QString& user, const FeedWish& wish)
{
    if (wish.parts.empty())
        m_wishes.erase(user);
    else
        m_wishes[user] = wish;
    m_wishesChanged = true;
}

void Feeder::forget(ServoRef ref)
{
    for (auto wish = m_wishes.begin(); wish != m_wishes.end();) {
        std::erase_if(wish->second.parts,
                      [ref](const FeedPart& part) { return part.servo == ref; });
        wish = wish->second.parts.empty() ? m_wishes.erase(wish) : std::next(wish);
    }
    m_past.erase(ref);
}

void Feeder::forgetAll()
{
    m_wishes.clear();
    m_past.clear();
    m_wishesChanged = true;
}

bool Feeder::wished(ServoRef ref) const
{
    for (const auto& [user, wish] : m_wishes) {
        if (std::any_of(wish.parts.begin(), wish.parts.end(),
                        [ref](const FeedPart& part) { return part.servo == ref; }))
            return true;
    }
    return false;
}

std::vector<Feeder::Asked> Feeder::askedOf(const std::vector<const ServoEntry*>& present) const
{
    std::vector<Asked> asked;
    for (const ServoEntry* entry : present) {
        if (wished(entry->ref))
            asked.push_back({entry->ref, entry->servo.id, entry->servo.profile.get()});
    }
    return asked;
}

bool Feeder::outdated(const std::vector<const ServoEntry*>& present, int baud) const
{
    if (m_wishes.empty() && m_asked.empty())
        return false;
    return m_wishesChanged || (baud != m_baud && !m_asked.empty()) || askedOf(present) != m_asked;
}

void Feeder::start(bus::Bus& bus, const std::vector<const ServoEntry*>& present)
{
    endPolls(&bus);
    m_baud = bus.baud();
    m_asked = askedOf(present);
    m_wishesChanged = false;
    std::vector<FeedWish> wishes;
    for (const auto& [user, one] : m_wishes)
        wishes.push_back(one);
    FeedPlan plan = planFeed(wishes, present, m_baud);
    for (auto& [ref, past] : m_past) {
        if (std::none_of(plan.targets.begin(), plan.targets.end(),
                         [r = ref](const FeedTarget& target) { return target.ref == r; }))
            past.end();
    }
    for (FeedTarget& target : plan.targets) {
        Past& past = m_past[target.ref];
        if (past.answered.empty() && past.missed.empty())
            past.since = bus.clock().now();
        Source& source = m_sources[{target.protocol, target.id}];
        for (const catalog::Register* reg : target.registers)
            source.fields.push_back({reg, {}});
        source.target = std::move(target);
    }
    if (!plan.common.servos.empty())
        m_polls[0] = bus.startPoll(plan.common);
    if (!plan.beside.servos.empty())
        m_polls[1] = bus.startPoll(plan.beside);
}

void Feeder::stop(bus::Bus* bus)
{
    endPolls(bus);
    for (auto& [ref, past] : m_past)
        past.end();
}

void Feeder::endPolls(bus::Bus* bus)
{
    for (bus::PollId& poll : m_polls) {
        if (poll != 0 && bus != nullptr)
            bus->stopPoll(poll);
        poll = 0;
    }
    m_sources.clear();
    m_asked.clear();
}

const std::vector<bus::PollSpan>& Feeder::spansOf(const Source& source, std::size_t poll)
{
    return poll == 0 ? source.target.common : source.target.beside;
}

/// What phase and mode make of the registers may have changed since the batch before.
void Feeder::freshen(Source& source, const ServoEntry& entry)
{
    for (Field& field : source.fields)
        field.meaning = entry.servo.meaning(*field.reg);
}

FeedBatch Feeder::take(bus::Bus& bus, const EntryOf& entryOf)
{
    m_batch = {};
    m_takenAt = bus.clock().now();
    // Whoever has been taken to another rate could not answer.
    const bool here = bus.baud() == m_baud;
    std::map<Source*, ServoEntry*> met;
    for (std::size_t poll = 0; poll < m_polls.size(); ++poll) {
        if (m_polls[poll] == 0)
            continue;
        for (const bus::Sample& sample : bus.takeSamples(m_polls[poll])) {
            const auto found = m_sources.find({sample.protocol, sample.id});
            if (found == m_sources.end() || (!sample.answered && !here))
                continue;
            Source& source = found->second;
            const auto [place, first] = met.try_emplace(&source, nullptr);
            if (first) {
                ServoEntry* known = entryOf(source.target.ref);
                const bool same = known != nullptr && known->servo.id == sample.id &&
                                  known->servo.profile == source.target.profile;
                place->second = same ? known : nullptr;
                if (same)
                    freshen(source, *known);
            }
            if (place->second != nullptr)
                takeSample(source, poll, *place->second, sample);
        }
    }
    for (const auto& [source, entry] : met) {
        if (entry != nullptr)
            finishBatch(*source, *entry);
    }
    std::stable_sort(m_batch.readings.begin(), m_batch.readings.end(),
                     [](const Reading& a, const Reading& b) { return a.at < b.at; });
    std::stable_sort(m_batch.marks.begin(), m_batch.marks.end(),
                     [](const auto& a, const auto& b) { return a.at < b.at; });
    return std::move(m_batch);
}

void Feeder::takeSample(Source& source, std::size_t poll, ServoEntry& entry,
                        const bus::Sample& sample)
{
    Round& round = source.rounds[poll];
    const std::size_t block = jobs::blockOf(sample, spansOf(source, poll));
    if (round.cut.startsAnew(block) ||
        (round.cut.open() && round.reading.at < sample.at - longestRound))
        close(source, poll, entry);
    round.answered[block] = sample.answered;
    Reading& reading = round.reading;
    reading.at = sample.at;
    if (sample.answered) {
        device::Servo& servo = entry.servo;
        servo.image.store(sample.address, sample.data, sample.at);
        if (servo.repliesCarryStatus())
            reading.status = sample.status;
        else
            device::takeStatus(servo, sample.address, static_cast<int>(sample.data.size()));
        reading.answered = true;
        decode(source, reading, sample);
    } else {
        reading.error = sample.error;
    }
    if (round.cut.take(block, sample))
        close(source, poll, entry);
}

void Feeder::decode(const Source& source, Reading& into, const bus::Sample& sample)
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

void Feeder::close(Source& source, std::size_t poll, ServoEntry& entry)
{
    Round& round = source.rounds[poll];
    round.cut.close();
    Reading reading = std::exchange(round.reading, Reading{});
    reading.values.reserve(source.fields.size());
    round.reading.values.reserve(source.fields.size());
    reading.servo = source.target.ref;
    reading.profile = source.target.profile;
    if (!entry.servo.repliesCarryStatus() || !reading.answered)
        reading.status = entry.servo.status;
    look(entry, reading);
    count(reading);
    m_batch.read.insert(entry.ref);
    m_batch.readings.push_back(std::move(reading));
}

/// What a reading tells beside its numbers.
void Feeder::look(ServoEntry& entry, const Reading& reading)
{
    const LinkWatch::News news = entry.link.reading(reading.answered, reading.at);
    if (news == LinkWatch::News::Lost) {
        entry.silent = true;
        m_batch.marks.push_back({entry.link.silentSince().value_or(reading.at), MarkKind::LinkError,
                                 entry.servo.id, base::errorName(reading.error)});
    } else if (news == LinkWatch::News::Back) {
        entry.turns.reset(); // it may have been without supply
        m_batch.marks.push_back({reading.at, MarkKind::LinkBack, entry.servo.id, {}});
    }
    if (news != LinkWatch::News::None)
        m_batch.news.insert(entry.ref);
    if (!reading.answered)
        return;
    if (std::exchange(entry.silent, false))
        m_batch.news.insert(entry.ref);
    entry.lastSeen = reading.at;
    const bool otherStatus = std::exchange(entry.servo.status, reading.status) != reading.status;
    if (otherStatus || !entry.servo.repliesCarryStatus()) {
        const auto marks = latchAlarms(entry, reading.at);
        m_batch.marks.insert(m_batch.marks.end(), marks.begin(), marks.end());
        if (otherStatus || !marks.empty())
            m_batch.news.insert(entry.ref);
    }
    for (const ReadValue& value : reading.values) {
        if (value.reg->role == Role::PresentPosition)
            entry.turns.reading(value.raw, speedIn(reading, entry.servo), reading.at);
    }
}

/// Once a servo and batch, however many readings there were.
void Feeder::finishBatch(Source& source, ServoEntry& entry)
{
    entry.firstImage.takeMissing(entry.servo.image);
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

void Feeder::count(const Reading& reading)
{
    Past& past = m_past[reading.servo];
    forgetOld(past.answered, reading.at - rateSpan);
    forgetOld(past.missed, reading.at - rateSpan);
    (reading.answered ? past.answered : past.missed).push_back(reading.at);
    if (reading.answered)
        past.lastAt = reading.at;
}

FeedRate Feeder::rate(ServoRef ref) const
{
    const auto found = m_past.find(ref);
    if (found == m_past.end())
        return {};
    const Past& past = found->second;
    const Duration from = m_takenAt - rateSpan;
    const auto within = [&](const std::deque<Duration>& instants) {
        return std::uint64_t(instants.end() -
                             std::upper_bound(instants.begin(), instants.end(), from));
    };
    const Duration span = std::clamp(m_takenAt - past.since, Duration(1), rateSpan);
    const double seconds = std::chrono::duration<double>(span).count();
    return {double(within(past.answered)) / seconds, within(past.missed), past.lastAt};
}
} // namespace session
