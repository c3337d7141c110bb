// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/bus/wire_line.h"

#include <algorithm>
#include <cmath>

namespace sim {
Burst::Burst(int identity, Nanos at, int rate, base::Bytes what, double clockError)
    : sender(identity)
    , start(at)
    , baud(rate)
    , bitNanos(1e9 / rate / (1 + clockError))
    , bytes(std::move(what))
{
    m_end = byteStart(bytes.size());
}

Nanos Burst::byteStart(std::size_t index) const
{
    return start + std::llround(static_cast<double>(index * bitsPerByte) * bitNanos);
}

bool Burst::isHigh(Nanos at) const
{
    if (at < start || at >= m_end)
        return true;
    const auto bit = static_cast<std::size_t>(static_cast<double>(at - start) / bitNanos);
    const std::size_t index = bit / bitsPerByte;
    if (index >= bytes.size())
        return true;
    switch (const std::size_t place = bit % bitsPerByte; place) {
    case 0:
        return false;
    case bitsPerByte - 1:
        return true;
    default:
        return ((bytes[index] >> (place - 1)) & 1U) != 0;
    }
}

Nanos Burst::nextBoundary(Nanos at) const
{
    if (at < start)
        return start;
    const double bit = std::floor(static_cast<double>(at - start) / bitNanos);
    const auto boundary = start + static_cast<Nanos>(std::ceil((bit + 1) * bitNanos));
    return std::max(boundary, at + 1);
}

void Burst::truncate(std::size_t count)
{
    bytes.resize(std::min(count, bytes.size()));
    m_end = byteStart(bytes.size());
}

const Burst& WireLine::transmit(Burst burst)
{
    const auto place =
        std::upper_bound(m_bursts.begin(), m_bursts.end(), burst.start,
                         [](Nanos start, const Burst& other) { return start < other.start; });
    return *m_bursts.insert(place, std::move(burst));
}

bool WireLine::isHigh(Nanos at) const
{
    return std::all_of(m_bursts.begin(), m_bursts.end(),
                       [at](const Burst& burst) { return burst.isHigh(at); });
}

std::optional<Nanos> WireLine::nextBoundary(Nanos at) const
{
    std::optional<Nanos> next;
    for (const Burst& burst : m_bursts) {
        if (burst.end() <= at)
            continue;
        const Nanos boundary = burst.nextBoundary(at);
        if (!next || boundary < *next)
            next = boundary;
    }
    return next;
}

bool WireLine::isUndisturbed(const Burst& burst, Nanos from, Nanos to) const
{
    return std::none_of(m_bursts.begin(), m_bursts.end(), [&](const Burst& other) {
        return &other != &burst && other.start < to && other.end() > from;
    });
}

void WireLine::removeBefore(Nanos at)
{
    std::erase_if(m_bursts, [at](const Burst& burst) { return burst.end() < at; });
}

void WireLine::removeServos()
{
    std::erase_if(m_bursts, [](const Burst& burst) { return burst.sender != hostSender; });
}

void WireLine::silence(int sender, Nanos at)
{
    for (Burst& burst : m_bursts) {
        if (burst.sender != sender || burst.end() <= at)
            continue;
        std::size_t sent = 0;
        while (sent < burst.bytes.size() && burst.byteStart(sent) < at)
            ++sent;
        burst.truncate(sent);
    }
    std::erase_if(m_bursts, [](const Burst& burst) { return burst.bytes.empty(); });
}
} // namespace sim
