// SPDX-License-Identifier: GPL-3.0-or-later
// A UART that listens to the wire at its own rate: finds start bits, samples in the middle of its
// bits, checks the stop bit. Bytes of a single sender at its own rate come out exact; at any other
// rate, or when senders overlap, it receives what the levels give. Value; one thread.
#pragma once

#include "sim/bus/wire_line.h"

namespace sim {
enum class RxFilter : std::uint8_t { Host, Servos, All };

struct ReceivedByte {
    std::uint8_t value = 0;
    Nanos start = 0;
    Nanos end = 0;
    Nanos burstEnd = 0; ///< when the sender will have finished
    Nanos resume = 0;   ///< where to look for the next start bit
    bool framed = true; ///< false: the stop bit was low
};

class UartReceiver {
public:
    UartReceiver(RxFilter filter, int baud, Nanos from);

    int baud() const { return m_baud; }
    void setFilter(RxFilter filter) { m_filter = filter; }

    /// The next byte on the wire as known so far; the caller takes it once its end has come.
    std::optional<ReceivedByte> peek(const WireLine& line) const;
    void take(const ReceivedByte& received);

private:
    bool accepts(const Burst& burst) const;
    std::optional<ReceivedByte> decodeExact(const WireLine& line, const Burst& burst) const;
    std::optional<ReceivedByte> decodeSampled(const WireLine& line, const Burst& burst) const;
    std::optional<Nanos> findStartBit(const WireLine& line, Nanos from, Nanos until) const;

    RxFilter m_filter;
    int m_baud;
    double m_bitNanos;
    Nanos m_cursor;
    bool m_awaitIdle = false; ///< after a framing error the line must rise first
};
} // namespace sim
