// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that servos of one baud rate hear of the host, and the request frame they are
// collecting from it. Real firmware takes frames byte by byte: a frame with a wrong checksum is
// gone whole, and an unfinished one is given up after a silence. Owned by VirtualBus; one thread.
#pragma once

#include "protocol/codec.h"
#include "sim/uart_receiver.h"

namespace sim {
/// A request as the servos have understood it.
struct HeardFrame {
    protocol::RequestScan content;
    int baud = 0;
    Nanos start = 0;
    Nanos end = 0;
};

class ServoEar {
public:
    ServoEar(int baud, Nanos from);

    int baud() const { return m_receiver.baud(); }
    std::optional<Heard> peek(const WireLine& line) const { return m_receiver.peek(line); }

    /// Takes the byte just peeked; the frame, if this byte completes one.
    std::optional<HeardFrame> take(const Heard& heard);

private:
    void clear();
    void drop(std::size_t count);

    UartReceiver m_receiver;
    base::Bytes m_buffer;
    std::vector<Nanos> m_starts; ///< of the bytes in the buffer
    Nanos m_lastEnd;
};
} // namespace sim
