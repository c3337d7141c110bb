// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/unrest_meter.h"

#include <algorithm>

namespace bus {
namespace {
using base::Duration;
using namespace std::chrono_literals;

/// Adapters hand bytes over every 16 ms: a shorter gap says nothing.
constexpr Duration pause = 25ms;
/// The line is full when less than a tenth of it is free.
constexpr int fullTenths = 9;
constexpr int enoughFrames = 1000;
} // namespace

Duration UnrestMeter::levelAt(Duration now) const
{
    return std::max(m_level - (now - m_lastAt) * fullTenths / 10, Duration{});
}

void UnrestMeter::heard(Duration wireTime, bool frame, Duration now, Duration most)
{
    if (now - m_lastAt > pause)
        m_frames = 0;
    m_level = std::min(levelAt(now) + wireTime, most);
    m_lastAt = now;
    m_frames = std::min(m_frames + (frame ? 1 : 0), enoughFrames);
}

bool UnrestMeter::overloaded(Duration allowed, Duration now) const
{
    return levelAt(now) > allowed;
}
} // namespace bus
