// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/bus/request_receiver.h"

namespace sim {
namespace {
constexpr Nanos frameTimeout = 10'000'000;
constexpr std::size_t maxModbusFrame = 256;

protocol::RequestScan scanRequest(base::Protocol protocol, base::ByteView buffer)
{
    switch (protocol) {
    case base::Protocol::Feetech:
        return protocol::scanFeetechRequest(buffer);
    case base::Protocol::Modbus:
        return protocol::scanModbusRequest(buffer);
    case base::Protocol::Lx:
        break;
    }
    return protocol::scanLxRequest(buffer);
}
} // namespace

Nanos modbusSilence(int baud)
{
    return Nanos(3.5 * bitsPerByte * 1e9 / baud);
}

RequestReceiver::RequestReceiver(base::Protocol protocol, int baud, Nanos from)
    : m_protocol(protocol)
    , m_receiver(RxFilter::Host, baud, from)
    , m_lastEnd(from)
{}

std::optional<Nanos> RequestReceiver::silenceEnd() const
{
    if (m_protocol != base::Protocol::Modbus || (m_buffer.empty() && !m_framingError))
        return std::nullopt;
    return m_lastEnd + modbusSilence(baud());
}

std::optional<RequestReceiver::Event> RequestReceiver::peek(const WireLine& line) const
{
    const auto received = m_receiver.peek(line);
    const auto due = silenceEnd();
    if (due && (!received || received->start >= *due))
        return Event{*due, std::nullopt};
    if (!received)
        return std::nullopt;
    return Event{received->end, received};
}

std::optional<ReceivedFrame> RequestReceiver::take(const Event& event)
{
    if (!event.byte)
        return endFrame(event.at);
    addByte(*event.byte);
    return m_protocol == base::Protocol::Modbus ? std::nullopt : scanStream(event.at);
}

void RequestReceiver::addByte(const ReceivedByte& received)
{
    m_receiver.take(received);
    const bool modbus = m_protocol == base::Protocol::Modbus;
    const bool timedOut = !modbus && received.start - m_lastEnd > frameTimeout;
    if (!received.framed || timedOut || m_buffer.size() == maxModbusFrame)
        clear();
    m_lastEnd = received.end;
    if (!received.framed) {
        m_framingError = modbus;
        return;
    }
    m_buffer.push_back(received.value);
    m_starts.push_back(received.start);
}

std::optional<ReceivedFrame> RequestReceiver::scanStream(Nanos end)
{
    while (!m_buffer.empty()) {
        auto scan = scanRequest(m_protocol, m_buffer);
        switch (scan.kind) {
        case protocol::ScanKind::Incomplete:
            return std::nullopt;
        case protocol::ScanKind::Reply: {
            ReceivedFrame frame = frameOf(std::move(scan), end);
            clear();
            return frame;
        }
        case protocol::ScanKind::Noise:
            drop(scan.consumed);
            break;
        case protocol::ScanKind::Foreign:
        case protocol::ScanKind::BadChecksum:
            clear();
            break;
        }
    }
    return std::nullopt;
}

std::optional<ReceivedFrame> RequestReceiver::endFrame(Nanos end)
{
    std::optional<ReceivedFrame> frame;
    if (!m_framingError) {
        auto scan = scanRequest(m_protocol, m_buffer);
        if (scan.kind == protocol::ScanKind::Reply && scan.consumed == m_buffer.size())
            frame = frameOf(std::move(scan), end);
    }
    clear();
    m_framingError = false;
    return frame;
}

ReceivedFrame RequestReceiver::frameOf(protocol::RequestScan scan, Nanos end) const
{
    return {std::move(scan), m_protocol, baud(), m_starts.front(), end};
}

void RequestReceiver::clear()
{
    m_buffer.clear();
    m_starts.clear();
}

void RequestReceiver::drop(std::size_t count)
{
    const auto n = static_cast<std::ptrdiff_t>(count);
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + n);
    m_starts.erase(m_starts.begin(), m_starts.begin() + n);
}
} // namespace sim
