// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo_ear.h"

namespace sim {
namespace {
constexpr Nanos frameTimeout = 10'000'000;
}

ServoEar::ServoEar(int baud, Nanos from)
    : m_receiver(Listens::Host, baud, from)
    , m_lastEnd(from)
{}

std::optional<HeardFrame> ServoEar::take(const Heard& heard)
{
    m_receiver.take(heard);
    if (!heard.framed || heard.start - m_lastEnd > frameTimeout)
        clear();
    m_lastEnd = heard.end;
    if (!heard.framed)
        return std::nullopt;
    m_buffer.push_back(heard.value);
    m_starts.push_back(heard.start);
    while (!m_buffer.empty()) {
        auto scan = protocol::scanFeetechRequest(m_buffer);
        switch (scan.kind) {
        case protocol::ScanKind::Incomplete:
            return std::nullopt;
        case protocol::ScanKind::Reply: {
            HeardFrame frame{std::move(scan), baud(), m_starts.front(), heard.end};
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
