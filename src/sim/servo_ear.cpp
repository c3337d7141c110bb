// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo_ear.h"

namespace sim {
namespace {
constexpr Nanos frameTimeout = 10'000'000;
constexpr std::size_t longestModbus = 256;

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

ServoEar::ServoEar(base::Protocol protocol, int baud, Nanos from)
    : m_protocol(protocol)
    , m_receiver(Listens::Host, baud, from)
    , m_lastEnd(from)
{}

std::optional<Nanos> ServoEar::silenceDue() const
{
    if (m_protocol != base::Protocol::Modbus || (m_buffer.empty() && !m_spoiled))
        return std::nullopt;
    return m_lastEnd + modbusSilence(baud());
}

std::optional<ServoEar::Event> ServoEar::peek(const WireLine& line) const
{
    const auto heard = m_receiver.peek(line);
    const auto due = silenceDue();
    if (due && (!heard || heard->start >= *due))
        return Event{*due, std::nullopt};
    if (!heard)
        return std::nullopt;
    return Event{heard->end, heard};
}

std::optional<HeardFrame> ServoEar::take(const Event& event)
{
    if (!event.byte)
        return endFrame(event.at);
    hear(*event.byte);
    return m_protocol == base::Protocol::Modbus ? std::nullopt : scanStream(event.at);
}

void ServoEar::hear(const Heard& heard)
{
    m_receiver.take(heard);
    const bool modbus = m_protocol == base::Protocol::Modbus;
    const bool tooLate = !modbus && heard.start - m_lastEnd > frameTimeout;
    if (!heard.framed || tooLate || m_buffer.size() == longestModbus)
        clear();
    m_lastEnd = heard.end;
    if (!heard.framed) {
        m_spoiled = modbus;
        return;
    }
    m_buffer.push_back(heard.value);
    m_starts.push_back(heard.start);
}

std::optional<HeardFrame> ServoEar::scanStream(Nanos end)
{
    while (!m_buffer.empty()) {
        auto scan = scanRequest(m_protocol, m_buffer);
        switch (scan.kind) {
        case protocol::ScanKind::Incomplete:
            return std::nullopt;
        case protocol::ScanKind::Reply: {
            HeardFrame frame = frameOf(std::move(scan), end);
            clear();
            return frame;
        }
        case protocol::ScanKind::Noise:
            drop(scan.consumed);
            break;
        case protocol::ScanKind::Foreign:
        case protocol::ScanKind::BadCheck:
            clear();
            break;
        }
    }
    return std::nullopt;
}

std::optional<HeardFrame> ServoEar::endFrame(Nanos end)
{
    std::optional<HeardFrame> frame;
    if (!m_spoiled) {
        auto scan = scanRequest(m_protocol, m_buffer);
        if (scan.kind == protocol::ScanKind::Reply && scan.consumed == m_buffer.size())
            frame = frameOf(std::move(scan), end);
    }
    clear();
    m_spoiled = false;
    return frame;
}

HeardFrame ServoEar::frameOf(protocol::RequestScan scan, Nanos end) const
{
    return {std::move(scan), m_protocol, baud(), m_starts.front(), end};
}

void ServoEar::clear()
{
    m_buffer.clear();
    m_starts.clear();
}

void ServoEar::drop(std::size_t count)
{
    const auto n = static_cast<std::ptrdiff_t>(count);
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + n);
    m_starts.erase(m_starts.begin(), m_starts.begin() + n);
}
} // namespace sim
