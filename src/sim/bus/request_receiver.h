// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that servos of one baud rate and one language hear of the host, and the request frame
// they are collecting from it. Feetech and LX firmware takes frames byte by byte: a frame with a
// wrong checksum is gone whole, and an unfinished one is given up after a silence. Modbus-RTU knows
// frames by the silence around them only: what comes without one belongs to the frame before, and
// a silence ends the frame, whatever is missing. Owned by VirtualBus; one thread.
#pragma once

#include "protocol/codec.h"
#include "sim/bus/uart_receiver.h"

namespace sim {
/// A request as the servos have understood it.
struct ReceivedFrame {
    protocol::RequestScan content;
    base::Protocol protocol = base::Protocol::Feetech;
    int baud = 0;
    Nanos start = 0;
    Nanos end = 0; ///< when they know; Modbus: after the silence
};

/// 3.5 characters: what separates Modbus frames. The standard's fixed 1.75 ms above 19200 baud is
/// longer; servos that answer after 0.3 ms at 115200 show that they do not wait for it.
Nanos modbusSilence(int baud);

class RequestReceiver {
public:
    RequestReceiver(base::Protocol protocol, int baud, Nanos from);

    base::Protocol protocol() const { return m_protocol; }
    int baud() const { return m_receiver.baud(); }

    /// The next byte, or the silence (without a byte) that ends a Modbus frame before it.
    struct Event {
        Nanos at = 0;
        std::optional<ReceivedByte> byte;
    };
    std::optional<Event> peek(const WireLine& line) const;

    /// Takes what was just peeked; the frame, if this completes one.
    std::optional<ReceivedFrame> take(const Event& event);

    /// When the silence after what was heard so far will have ended a frame, if nothing follows.
    std::optional<Nanos> silenceEnd() const;

private:
    void addByte(const ReceivedByte& received);
    std::optional<ReceivedFrame> scanStream(Nanos end);
    std::optional<ReceivedFrame> endFrame(Nanos end);
    ReceivedFrame frameOf(protocol::RequestScan scan, Nanos end) const;
    void clear();
    void drop(std::size_t count);

    base::Protocol m_protocol;
    UartReceiver m_receiver;
    base::Bytes m_buffer;
    std::vector<Nanos> m_starts; ///< of the bytes in the buffer
    Nanos m_lastEnd;
    bool m_framingError = false; ///< Modbus: a byte of this frame was none
};
} // namespace sim
