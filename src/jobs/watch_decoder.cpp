// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/watch_decoder.h"

#include "bus/poll_planner.h"
#include "device/reader.h"

#include <algorithm>

namespace jobs {
namespace {
using base::ErrorCode;

/// A row whose other blocks stay out for so long (the servo is held by a job) is given up.
constexpr base::Duration longestRound = std::chrono::seconds(1);

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

QStringList keysOf(const WatchSpec& spec)
{
    QStringList keys = spec.keys.isEmpty() ? feedbackKeys(spec.servos) : spec.keys;
    keys.removeDuplicates();
    return keys;
}

/// Servos of one number may share a sync read.
std::map<std::pair<QString, base::ByteOrder>, int>
families(const std::vector<device::Servo>& servos)
{
    std::map<std::pair<QString, base::ByteOrder>, int> numbers;
    for (const device::Servo& servo : servos)
        numbers.try_emplace({servo.profile->mapKey, servo.profile->byteOrder}, int(numbers.size()));
    return numbers;
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
    for (const QString& key : keysOf(spec)) {
        for (const device::Servo& servo : spec.servos) {
            const catalog::Register* reg = servo.profile->find(key);
            if (reg == nullptr || !servo.measures(*reg))
                continue;
            const WatchColumn column{key, servo.meaning(*reg).unit};
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
    const QStringList keys = keysOf(spec);
    const auto groups = families(spec.servos);
    for (const device::Servo& servo : spec.servos) {
        if (const auto added = decoder.addServo(servo, keys); !added)
            return tl::unexpected(added.error());
        decoder.m_sources[servo.id].group =
            groups.at({servo.profile->mapKey, servo.profile->byteOrder});
    }
    return decoder;
}

base::Result<void> WatchDecoder::addServo(const device::Servo& servo, const QStringList& keys)
{
    Source source;
    source.profile = servo.profile;
    std::vector<const catalog::Register*> registers;
    bool known = false;
    for (const QString& key : keys) {
        const catalog::Register* reg = servo.profile->find(key);
        known = known || reg != nullptr;
        if (reg == nullptr || !servo.measures(*reg))
            continue;
        const catalog::Meaning meaning = servo.meaning(*reg);
        const auto column =
            std::find(m_columns.begin(), m_columns.end(), WatchColumn{key, meaning.unit});
        source.fields.push_back({reg, meaning, std::size_t(column - m_columns.begin())});
        registers.push_back(reg);
    }
    if (registers.empty())
        return base::fail(known ? ErrorCode::NotSupported : ErrorCode::UnknownRegister,
                          QStringLiteral("watch"), keys.join(QLatin1Char(',')), servo.id);
    source.spans = bus::mergeSpans(device::planSpans(*servo.profile, registers),
                                   servo.profile->readGap, servo.profile->maxRead);
    source.row = emptyRow(servo.id);
    m_sources[servo.id] = std::move(source);
    return {};
}

bus::PollPlan WatchDecoder::plan() const
{
    bus::PollPlan plan;
    plan.period = m_period;
    for (const auto& [id, source] : m_sources) {
        const catalog::Profile& profile = *source.profile;
        plan.servos.push_back({id, source.spans, profile.syncRead, source.group, profile.protocol,
                               profile.readGap, profile.maxRead});
    }
    return plan;
}

// The blocks of a round come by address. One that is not answered ends the round for its servo: the
// bus then leaves it alone for a while, so what comes next belongs to another round.
std::vector<WatchRow> WatchDecoder::add(const bus::Sample& sample)
{
    const auto found = m_sources.find(sample.id);
    if (found == m_sources.end())
        return {};
    Source& source = found->second;
    if (source.pendingFrom && sample.address <= *source.pendingFrom)
        close(source);
    source.pendingFrom = sample.address;
    source.row.at = sample.at;
    if (sample.answered)
        decode(source, sample, source.row);
    if (!sample.answered || sample.address >= source.spans.back().address)
        close(source);
    return release(sample.at - longestRound);
}

std::vector<WatchRow> WatchDecoder::flush()
{
    return release(base::Duration::max());
}

void WatchDecoder::close(Source& source)
{
    WatchRow row = std::exchange(source.row, emptyRow(source.row.id));
    source.pendingFrom.reset();
    const auto place =
        std::upper_bound(m_ready.begin(), m_ready.end(), row,
                         [](const WatchRow& a, const WatchRow& b) { return a.at < b.at; });
    m_ready.insert(place, std::move(row));
}

// A finished row waits while an unfinished one is older, so that rows leave in time order.
std::vector<WatchRow> WatchDecoder::release(base::Duration staleBefore)
{
    base::Duration until = base::Duration::max();
    for (auto& [id, source] : m_sources) {
        if (source.pendingFrom && source.row.at < staleBefore)
            close(source);
        if (source.pendingFrom)
            until = std::min(until, source.row.at);
    }
    const auto end = std::find_if(m_ready.begin(), m_ready.end(),
                                  [until](const WatchRow& row) { return row.at >= until; });
    std::vector<WatchRow> rows(std::make_move_iterator(m_ready.begin()),
                               std::make_move_iterator(end));
    m_ready.erase(m_ready.begin(), end);
    return rows;
}

WatchRow WatchDecoder::emptyRow(int id) const
{
    WatchRow row;
    row.id = id;
    row.values.resize(m_columns.size());
    return row;
}

void WatchDecoder::decode(const Source& source, const bus::Sample& sample, WatchRow& row)
{
    row.answered = true;
    row.status = sample.status;
    for (const Field& field : source.fields) {
        const int offset = field.reg->offset - sample.address;
        if (offset < 0 || offset + field.reg->size > int(sample.data.size()))
            continue;
        const auto wire =
            base::ByteView(sample.data).subspan(std::size_t(offset), std::size_t(field.reg->size));
        const std::int64_t raw =
            catalog::decodeRaw(wire, *field.reg, field.meaning, source.profile->byteOrder);
        row.values[field.column] = catalog::toPhysical(raw, field.meaning);
    }
}
} // namespace jobs
