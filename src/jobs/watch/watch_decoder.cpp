// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/watch/watch_decoder.h"

#include "device/alarms.h"
#include "jobs/watch/poll_spans.h"

#include <algorithm>

namespace jobs {
namespace {
using base::ErrorCode;

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
        source.columns[reg] = std::size_t(column - m_columns.begin());
        registers.push_back(reg);
    }
    if (registers.empty())
        return base::fail(known ? ErrorCode::NotSupported : ErrorCode::UnknownRegister,
                          QStringLiteral("watch"), names.join(QLatin1Char(',')), servo.id);
    // An alarm shows in every row, whatever is watched.
    std::vector<const catalog::Register*> polled = registers;
    const catalog::Register* status = servo.profile->byRole(catalog::Role::Status);
    if (status != nullptr && !servo.repliesCarryStatus())
        polled.push_back(status);
    source.reader = PollReader(registers, pollSpans(*servo.profile, polled, m_period));
    source.reader.updateMeanings(servo);
    m_sources[{servo.protocol, servo.id}] = std::move(source);
    return {};
}

bus::PollPlan WatchDecoder::plan() const
{
    bus::PollPlan plan;
    plan.period = m_period;
    for (const auto& [identity, source] : m_sources)
        plan.servos.push_back(pollServo(source.servo, source.reader.spans(), source.group));
    return plan;
}

std::vector<WatchRow> WatchDecoder::add(const bus::Sample& sample)
{
    const auto found = m_sources.find({sample.protocol, sample.id});
    if (found == m_sources.end())
        return {};
    Source& source = found->second;
    if (const auto unfinished = source.reader.takeUnfinishedBefore(sample))
        addRow(source, *unfinished);
    if (const auto reading = source.reader.add(sample, &source.servo))
        addRow(source, *reading);
    if (sample.answered && !source.servo.repliesCarryStatus())
        deriveAlarms(source);
    return takeReadyRows(sample.at - maxRoundTime);
}

std::vector<WatchRow> WatchDecoder::flush()
{
    return takeReadyRows(base::Duration::max());
}

void WatchDecoder::addRow(const Source& source, const PollReading& reading)
{
    WatchRow row{reading.at,     source.servo.protocol, source.servo.id,
                 reading.status, reading.answered,      {}};
    row.values.resize(m_columns.size());
    for (const PollValue& value : reading.values)
        row.values[source.columns.at(value.reg)] = value.physical;
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
        const auto at = source.reader.unfinishedAt();
        if (at && *at < staleBefore)
            addRow(source, source.reader.takeUnfinished());
        else if (at)
            until = std::min(until, *at);
    }
    const auto end = std::find_if(m_ready.begin(), m_ready.end(),
                                  [until](const WatchRow& row) { return row.at >= until; });
    std::vector<WatchRow> rows(std::make_move_iterator(m_ready.begin()),
                               std::make_move_iterator(end));
    m_ready.erase(m_ready.begin(), end);
    return rows;
}

/// Alarms of a servo that reports none itself.
void WatchDecoder::deriveAlarms(Source& source)
{
    for (device::Notice& alarm : device::derivedAlarms(source.servo)) {
        if (source.reported.insert(alarm.code).second)
            m_alarms.push_back(std::move(alarm));
    }
}
} // namespace jobs
