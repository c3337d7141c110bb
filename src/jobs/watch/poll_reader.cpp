// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/watch/poll_reader.h"

#include "device/alarms.h"

#include <algorithm>

namespace jobs {
PollReader::PollReader(const std::vector<const catalog::Register*>& registers,
                       std::vector<bus::PollSpan> spans)
    : m_spans(std::move(spans))
{
    for (const catalog::Register* reg : registers)
        m_fields.push_back({reg});
}

void PollReader::updateMeanings(const device::Servo& servo)
{
    for (Field& field : m_fields)
        field.meaning = servo.meaning(*field.reg);
}

std::size_t PollReader::blockIndex(const bus::Sample& sample) const
{
    const auto span =
        std::find_if(m_spans.begin(), m_spans.end(), [&](const bus::PollSpan& candidate) {
            return candidate.address == sample.address;
        });
    return std::size_t(span - m_spans.begin());
}

std::optional<base::Duration> PollReader::unfinishedAt() const
{
    return m_latestBlock ? std::optional(m_reading.at) : std::nullopt;
}

std::optional<PollReading> PollReader::takeUnfinishedBefore(const bus::Sample& next)
{
    const bool isLater = m_latestBlock && (blockIndex(next) <= *m_latestBlock ||
                                           m_reading.at < next.at - maxRoundTime);
    return isLater ? std::optional(takeUnfinished()) : std::nullopt;
}

PollReading PollReader::takeUnfinished()
{
    m_latestBlock.reset();
    PollReading reading = std::exchange(m_reading, {});
    m_reading.values.reserve(m_fields.size());
    return reading;
}

std::optional<PollReading> PollReader::add(const bus::Sample& sample, device::Servo* servo)
{
    m_latestBlock = blockIndex(sample);
    m_reading.at = sample.at;
    if (!sample.answered)
        m_reading.error = sample.error;
    else if (servo != nullptr)
        decode(sample, *servo);
    m_reading.answered = m_reading.answered || sample.answered;
    return !sample.answered || sample.endsRound ? std::optional(takeUnfinished()) : std::nullopt;
}

void PollReader::decode(const bus::Sample& sample, device::Servo& servo)
{
    const base::ByteView data(sample.data);
    servo.image.store(sample.address, sample.data, sample.at);
    if (!servo.repliesCarryStatus())
        device::updateStatus(servo, sample.address, int(data.size()));
    m_reading.status = servo.repliesCarryStatus() ? sample.status : servo.status;
    for (const Field& field : m_fields) {
        const int offset = field.reg->offset - sample.address;
        if (offset < 0 || offset + field.reg->size > int(data.size()))
            continue;
        const auto wire = data.subspan(std::size_t(offset), std::size_t(field.reg->size));
        const std::int64_t raw =
            catalog::decodeRaw(wire, *field.reg, field.meaning, servo.profile->byteOrder);
        m_reading.values.push_back({field.reg, raw, catalog::toPhysical(raw, field.meaning)});
    }
}
} // namespace jobs
