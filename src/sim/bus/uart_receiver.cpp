// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/bus/uart_receiver.h"

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

UartReceiver::UartReceiver(RxFilter filter, int baud, Nanos from)
    : m_filter(filter)
    , m_baud(baud)
    , m_bitNanos(1e9 / baud)
    , m_cursor(from)
{}

bool UartReceiver::accepts(const Burst& burst) const
{
    return m_filter == RxFilter::All ||
           (m_filter == RxFilter::Host) == (burst.sender == hostSender);
}

std::optional<ReceivedByte> UartReceiver::peek(const WireLine& line) const
{
    for (const Burst& burst : line.bursts()) {
        if (!accepts(burst) || burst.end() <= m_cursor)
            continue;
        if (const auto received = decodeExact(line, burst))
            return received;
        if (const auto received = decodeSampled(line, burst))
            return received;
    }
    return std::nullopt;
}

// The common case without any bit work: same rate, in step with the sender, no other sender.
std::optional<ReceivedByte> UartReceiver::decodeExact(const WireLine& line,
                                                      const Burst& burst) const
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
    if (!line.isUndisturbed(burst, std::min(start, std::max(m_cursor, burst.start)), end))
        return std::nullopt;
    return ReceivedByte{burst.bytes[index], start, end, burst.end(), end, true};
}

std::optional<ReceivedByte> UartReceiver::decodeSampled(const WireLine& line,
                                                        const Burst& burst) const
{
    Nanos from = m_cursor;
    while (m_awaitIdle && !line.isHigh(from)) {
        const auto next = line.nextBoundary(from);
        if (!next)
            return std::nullopt;
        from = *next;
    }
    from = std::max(from, burst.start);
    const auto start = findStartBit(line, from, burst.end());
    if (!start)
        return std::nullopt;
    ReceivedByte received;
    received.start = *start;
    for (int bit = 0; bit < 8; ++bit) {
        if (line.isHigh(*start + bits(bit + 1.5, m_bitNanos)))
            received.value = static_cast<std::uint8_t>(received.value | (1U << bit));
    }
    received.resume = *start + bits(stopBitBegins + 0.5, m_bitNanos);
    received.framed = line.isHigh(received.resume);
    received.end = *start + bits(bitsPerByte, m_bitNanos);
    received.burstEnd = std::max(received.end, burst.end());
    return received;
}

std::optional<Nanos> UartReceiver::findStartBit(const WireLine& line, Nanos from, Nanos until) const
{
    for (std::optional<Nanos> at = from; at && *at < until; at = line.nextBoundary(*at)) {
        const bool glitch = line.isHigh(*at + bits(0.5, m_bitNanos));
        if (!line.isHigh(*at) && !glitch)
            return at;
    }
    return std::nullopt;
}

void UartReceiver::take(const ReceivedByte& received)
{
    m_cursor = received.resume;
    m_awaitIdle = !received.framed;
}
} // namespace sim
