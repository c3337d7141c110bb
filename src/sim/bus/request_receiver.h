// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that servos of one baud rate and one protocol receive from the host, and the request
// frame they are collecting from it. Feetech and LX firmware takes frames byte by byte: a frame
// with a wrong checksum is lost as a whole, and an unfinished one is dropped after a silence.
// Modbus-RTU finds frames by the silence around them only: bytes without one belong to the frame
// before, and a silence ends the frame, even if it is incomplete. Owned by VirtualBus; one thread.
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

/// The silence of 3.5 characters that separates Modbus frames. The standard's fixed 1.75 ms above
/// 19200 baud is longer; servos that answer after 0.3 ms at 115200 show that they do not wait for
/// it.
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

    /// Takes the event just peeked. Returns the frame if it completes one.
    std::optional<ReceivedFrame> take(const Event& event);

    /// When a frame ends by the silence after the bytes so far, if nothing follows.
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
    bool m_framingError = false; ///< Modbus: a byte of this frame was broken
};
} // namespace sim
