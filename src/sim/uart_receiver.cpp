// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/uart_receiver.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
constexpr double stopBitBegins = bitsPerByte - 1;

Nanos bits(double count, double bitNanos)
{
    return std::llround(count * bitNanos);
}
} // namespace

UartReceiver::UartReceiver(Listens whom, int baud, Nanos from)
    : m_whom(whom)
    , m_baud(baud)
    , m_bitNanos(1e9 / baud)
    , m_cursor(from)
{}

bool UartReceiver::hears(const Burst& burst) const
{
    return m_whom == Listens::All || (m_whom == Listens::Host) == (burst.speaker == hostSpeaker);
}

std::optional<Heard> UartReceiver::peek(const WireLine& line) const
{
    for (const Burst& burst : line.bursts()) {
        if (!hears(burst) || burst.end() <= m_cursor)
            continue;
        if (const auto heard = exact(line, burst))
            return heard;
        if (const auto heard = sampled(line, burst))
            return heard;
    }
    return std::nullopt;
}

// The common case without any bit work: same rate, in step with the speaker, nobody else talking.
std::optional<Heard> UartReceiver::exact(const WireLine& line, const Burst& burst) const
{
    if (burst.baud != m_baud || m_awaitIdle)
        return std::nullopt;
    std::size_t index = 0;
    if (m_cursor > burst.start) {
        const double bit = static_cast<double>(m_cursor - burst.start) / burst.bitNanos;
        index = static_cast<std::size_t>(bit / bitsPerByte);
        const double within = bit - static_cast<double>(index * bitsPerByte);
        if (within >= stopBitBegins)
            ++index;
        else if (m_cursor > burst.byteStart(index))
            return std::nullopt;
    }
    if (index >= burst.bytes.size())
        return std::nullopt;
    const Nanos start = burst.byteStart(index);
    const Nanos end = burst.byteStart(index + 1);
    if (!line.undisturbed(burst, std::min(start, std::max(m_cursor, burst.start)), end))
        return std::nullopt;
    return Heard{burst.bytes[index], start, end, burst.end(), end, true};
}

std::optional<Heard> UartReceiver::sampled(const WireLine& line, const Burst& burst) const
{
    Nanos from = m_cursor;
    while (m_awaitIdle && !line.high(from)) {
        const auto next = line.nextBoundary(from);
        if (!next)
            return std::nullopt;
        from = *next;
    }
    from = std::max(from, burst.start);
    const auto start = findStartBit(line, from, burst.end());
    if (!start)
        return std::nullopt;
    Heard heard;
    heard.start = *start;
    for (int bit = 0; bit < 8; ++bit) {
        if (line.high(*start + bits(bit + 1.5, m_bitNanos)))
            heard.value = static_cast<std::uint8_t>(heard.value | (1U << bit));
    }
    heard.resume = *start + bits(stopBitBegins + 0.5, m_bitNanos);
    heard.framed = line.high(heard.resume);
    heard.end = *start + bits(bitsPerByte, m_bitNanos);
    heard.burstEnd = std::max(heard.end, burst.end());
    return heard;
}

std::optional<Nanos> UartReceiver::findStartBit(const WireLine& line, Nanos from, Nanos until) const
{
    for (std::optional<Nanos> at = from; at && *at < until; at = line.nextBoundary(*at)) {
        const bool glitch = line.high(*at + bits(0.5, m_bitNanos));
        if (!line.high(*at) && !glitch)
            return at;
    }
    return std::nullopt;
}

void UartReceiver::take(const Heard& heard)
{
    m_cursor = heard.resume;
    m_awaitIdle = !heard.framed;
}
} // namespace sim
