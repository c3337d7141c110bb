// SPDX-License-Identifier: GPL-3.0-or-later
// The shared wire as levels over time: the bursts of bytes of all senders, combined as an open line
// combines them (low wins). Owned by VirtualBus; one thread. Times are nanoseconds, so that byte
// times at odd rates do not drift. 8N1: a byte takes 10 bits, least significant bit first.
#pragma once

#include "base/bytes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace sim {
using Nanos = std::int64_t;

constexpr int hostSender = -1;
constexpr int bitsPerByte = 10;

/// Bytes that one sender sends without a pause.
struct Burst {
    int sender = hostSender; ///< hostSender or a servo's place on the bus
    Nanos start = 0;
    int baud = 0;
    double bitNanos = 0;
    base::Bytes bytes;

    Nanos byteStart(std::size_t index) const;
    Nanos end() const { return m_end; }
    bool isHigh(Nanos at) const;
    /// The first bit boundary after `at`; `at` lies before end().
    Nanos nextBoundary(Nanos at) const;
    void truncate(std::size_t count);

    /// `clockError`: how much faster than `rate` it is sent, as a fraction.
    Burst(int identity, Nanos at, int rate, base::Bytes what, double clockError = 0);

private:
    Nanos m_end = 0;
};

class WireLine {
public:
    const Burst& transmit(Burst burst);
    const std::vector<Burst>& bursts() const { return m_bursts; } ///< by start

    bool isHigh(Nanos at) const;
    /// The next instant after `at` at which the level may change; nullopt: silence from then on.
    std::optional<Nanos> nextBoundary(Nanos at) const;
    /// True when only the sender of `burst` drives the line in [from, to).
    bool isUndisturbed(const Burst& burst, Nanos from, Nanos to) const;

    void removeBefore(Nanos at);
    void removeServos();
    /// One that has left the line at `at`: what it had not begun to send by then never comes.
    void silence(int sender, Nanos at);
    void removeAll() { m_bursts.clear(); }
    void silenceHost(Nanos at) { silence(hostSender, at); }

private:
    std::vector<Burst> m_bursts;
};
} // namespace sim
