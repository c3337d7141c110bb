// SPDX-License-Identifier: GPL-3.0-or-later
// A UART that listens to the wire at its own rate: finds start bits, samples in the middle of its
// bits, checks the stop bit. Bytes at its own rate with nobody else talking come out exact; at any
// other rate, or when speakers overlap, it hears what the levels give. Value; one thread.
#pragma once

#include "sim/wire_line.h"

namespace sim {
enum class Listens : std::uint8_t { Host, Servos, All };

struct Heard {
    std::uint8_t value = 0;
    Nanos start = 0;
    Nanos end = 0;
    Nanos burstEnd = 0; ///< when the speaker will have finished
    Nanos resume = 0;   ///< where to look for the next start bit
    bool framed = true; ///< false: the stop bit was low
};

class UartReceiver {
public:
    UartReceiver(Listens whom, int baud, Nanos from);

    int baud() const { return m_baud; }
    void listenTo(Listens whom) { m_whom = whom; }

    /// The next byte on the wire as known so far; the caller takes it once its end has come.
    std::optional<Heard> peek(const WireLine& line) const;
    void take(const Heard& heard);

private:
    bool hears(const Burst& burst) const;
    std::optional<Heard> exact(const WireLine& line, const Burst& burst) const;
    std::optional<Heard> sampled(const WireLine& line, const Burst& burst) const;
    std::optional<Nanos> findStartBit(const WireLine& line, Nanos from, Nanos until) const;

    Listens m_whom;
    int m_baud;
    double m_bitNanos;
    Nanos m_cursor;
    bool m_awaitIdle = false; ///< after a framing error the line must rise first
};
} // namespace sim
