// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/watch/watch_decoder.h"

#include "device/alarms.h"

#include <algorithm>

namespace jobs {
namespace {
using base::ErrorCode;

/// A row whose other blocks stay out for so long (the servo is held by a job) is given up.
constexpr base::Duration maxRoundTime = std::chrono::seconds(1);

QStringList feedbackKeys(const std::vector<device::Servo>& servos)
{
    std::vector<std::pair<int, QString>> sorted;
    for (const device::Servo& servo : servos) {
        for (const catalog::Register& reg : servo.profile->registers) {
            if (reg.area == catalog::Area::Feedback && servo.measures(reg))
                sorted.emplace_back(reg.offset, reg.key);
        }
    }
    std::sort(sorted.begin(), sorted.end());
    QStringList keys;
    for (const auto& [address, key] : sorted) {
        if (!keys.contains(key))
            keys.append(key);
    }
    return keys;
}

catalog::Role roleOf(const WatchSpec& spec, const QString& key)
{
    for (const device::Servo& servo : spec.servos) {
        if (const catalog::Register* reg = servo.profile->find(key))
            return reg->role;
    }
    return catalog::Role::None;
}

std::vector<WatchKey> watchedKeys(const WatchSpec& spec)
{
    std::vector<WatchKey> keys;
    for (const QString& key : spec.keys.isEmpty() ? feedbackKeys(spec.servos) : spec.keys) {
        const catalog::Role role = roleOf(spec, key);
        const bool isListed = std::any_of(keys.begin(), keys.end(), [&](const WatchKey& other) {
            return other.key == key || (role != catalog::Role::None && other.role == role);
        });
        if (!isListed)
            keys.push_back({key, role});
    }
    return keys;
}

const catalog::Register* findRegister(const device::Servo& servo, const WatchKey& wanted)
{
    const catalog::Register* reg = servo.profile->find(wanted.key);
    const bool isUnknownRegister = reg == nullptr && wanted.role != catalog::Role::None;
    return isUnknownRegister ? servo.profile->byRole(wanted.role) : reg;
}

base::Result<void> check(const WatchSpec& spec)
{
    if (spec.servos.empty())
        return base::fail(ErrorCode::BadArgument, QStringLiteral("watch"),
                          QStringLiteral("no servo"));
    for (const device::Servo& servo : spec.servos) {
        if (!servo.profile)
            return base::fail(ErrorCode::BadArgument, QStringLiteral("watch"),
                              QStringLiteral("not identified"), servo.id);
    }
    for (const QString& key : spec.keys) {
        const bool known =
            std::any_of(spec.servos.begin(), spec.servos.end(), [&](const device::Servo& servo) {
                return servo.profile->find(key) != nullptr;
            });
        if (!known)
            return tl::unexpected(
                base::Error{ErrorCode::UnknownRegister, QStringLiteral("watch"), key, -1, key});
    }
    return {};
}
} // namespace

std::vector<WatchColumn> watchColumns(const WatchSpec& spec)
{
    std::vector<WatchColumn> columns;
    if (!check(spec))
        return columns;
    for (const WatchKey& wanted : watchedKeys(spec)) {
        for (const device::Servo& servo : spec.servos) {
            const catalog::Register* reg = findRegister(servo, wanted);
            if (reg == nullptr || !servo.measures(*reg))
                continue;
            const WatchColumn column{wanted.key, servo.meaning(*reg).unit};
            if (std::find(columns.begin(), columns.end(), column) == columns.end())
                columns.push_back(column);
        }
    }
    return columns;
}

base::Result<WatchDecoder> WatchDecoder::make(const WatchSpec& spec)
{
    if (const auto good = check(spec); !good)
        return tl::unexpected(good.error());
    WatchDecoder decoder;
    decoder.m_period = spec.period;
    decoder.m_columns = watchColumns(spec);
    const std::vector<WatchKey> keys = watchedKeys(spec);
    SyncReadGroups families;
    for (const device::Servo& servo : spec.servos) {
        if (const auto added = decoder.addServo(servo, keys, families.of(*servo.profile)); !added)
            return tl::unexpected(added.error());
    }
    return decoder;
}

base::Result<void> WatchDecoder::addServo(const device::Servo& servo,
                                          const std::vector<WatchKey>& keys, int group)
{
    Source source;
    source.servo = servo;
    source.group = group;
    std::vector<const catalog::Register*> registers;
    bool known = false;
    QStringList names;
    for (const WatchKey& wanted : keys) {
        names.append(wanted.key);
        const catalog::Register* reg = findRegister(servo, wanted);
        known = known || reg != nullptr;
        if (reg == nullptr || !servo.measures(*reg))
            continue;
        const catalog::ValueFormat meaning = servo.meaning(*reg);
        const auto column =
            std::find(m_columns.begin(), m_columns.end(), WatchColumn{wanted.key, meaning.unit});
        source.fields.push_back({reg, meaning, std::size_t(column - m_columns.begin())});
        registers.push_back(reg);
    }
    if (registers.empty())
        return base::fail(known ? ErrorCode::NotSupported : ErrorCode::UnknownRegister,
                          QStringLiteral("watch"), names.join(QLatin1Char(',')), servo.id);
    // An alarm shows in every row, whatever is watched.
    const catalog::Register* status = servo.profile->byRole(catalog::Role::Status);
    if (status != nullptr && !servo.repliesCarryStatus())
        registers.push_back(status);
    source.spans = pollSpans(*servo.profile, registers, m_period);
    source.row = emptyRow(servo);
    m_sources[{servo.protocol, servo.id}] = std::move(source);
    return {};
}

bus::PollPlan WatchDecoder::plan() const
{
    bus::PollPlan plan;
    plan.period = m_period;
    for (const auto& [identity, source] : m_sources) {
        const catalog::Profile& profile = *source.servo.profile;
        plan.servos.push_back({source.servo.id, source.spans, profile.syncRead, source.group,
                               source.servo.protocol, profile.readGap, profile.maxRead});
    }
    return plan;
}

std::vector<WatchRow> WatchDecoder::add(const bus::Sample& sample)
{
    const auto found = m_sources.find({sample.protocol, sample.id});
    if (found == m_sources.end())
        return {};
    Source& source = found->second;
    const std::size_t block = blockIndex(sample, source.spans);
    if (source.round.startsNewRound(block))
        finishRow(source);
    source.row.at = sample.at;
    if (sample.answered)
        decode(source, sample);
    if (source.round.take(block, sample))
        finishRow(source);
    return takeReadyRows(sample.at - maxRoundTime);
}

std::vector<WatchRow> WatchDecoder::flush()
{
    return takeReadyRows(base::Duration::max());
}

void WatchDecoder::finishRow(Source& source)
{
    WatchRow row = std::exchange(source.row, emptyRow(source.servo));
    source.round.reset();
    const auto place =
        std::upper_bound(m_ready.begin(), m_ready.end(), row,
                         [](const WatchRow& a, const WatchRow& b) { return a.at < b.at; });
    m_ready.insert(place, std::move(row));
}

// A finished row waits while an unfinished one is older, so that rows leave in time order.
std::vector<WatchRow> WatchDecoder::takeReadyRows(base::Duration staleBefore)
{
    base::Duration until = base::Duration::max();
    for (auto& [identity, source] : m_sources) {
        if (source.round.open() && source.row.at < staleBefore)
            finishRow(source);
        if (source.round.open())
            until = std::min(until, source.row.at);
    }
    const auto end = std::find_if(m_ready.begin(), m_ready.end(),
                                  [until](const WatchRow& row) { return row.at >= until; });
    std::vector<WatchRow> rows(std::make_move_iterator(m_ready.begin()),
                               std::make_move_iterator(end));
    m_ready.erase(m_ready.begin(), end);
    return rows;
}

WatchRow WatchDecoder::emptyRow(const device::Servo& servo) const
{
    WatchRow row;
    row.protocol = servo.protocol;
    row.id = servo.id;
    row.values.resize(m_columns.size());
    return row;
}

void WatchDecoder::decode(Source& source, const bus::Sample& sample)
{
    WatchRow& row = source.row;
    row.answered = true;
    if (!source.servo.repliesCarryStatus())
        deriveAlarms(source, sample);
    row.status = source.servo.repliesCarryStatus() ? sample.status : source.servo.status;
    for (const Field& field : source.fields) {
        const int offset = field.reg->offset - sample.address;
        if (offset < 0 || offset + field.reg->size > int(sample.data.size()))
            continue;
        const auto wire =
            base::ByteView(sample.data).subspan(std::size_t(offset), std::size_t(field.reg->size));
        const std::int64_t raw =
            catalog::decodeRaw(wire, *field.reg, field.meaning, source.servo.profile->byteOrder);
        row.values[field.column] = catalog::toPhysical(raw, field.meaning);
    }
}

/// Faults of a servo whose replies carry none: from its status register, or worked out.
void WatchDecoder::deriveAlarms(Source& source, const bus::Sample& sample)
{
    source.servo.image.store(sample.address, sample.data, sample.at);
    device::updateStatus(source.servo, sample.address, int(sample.data.size()));
    for (device::Notice& alarm : device::derivedAlarms(source.servo)) {
        if (source.reported.insert(alarm.code).second)
            m_alarms.push_back(std::move(alarm));
    }
}
} // namespace jobs
