// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/line_noise_meter.h"

#include <algorithm>

namespace bus {
namespace {
using base::Duration;
using namespace std::chrono_literals;

/// Adapters hand bytes over every 16 ms: a shorter gap says nothing.
constexpr Duration pause = 25ms;
/// The line is full when less than a tenth of it is free.
constexpr int maxLoadTenths = 9;
constexpr int maxFrameCount = 1000;
} // namespace

Duration LineNoiseMeter::levelAt(Duration now) const
{
    return std::max(m_level - (now - m_lastAt) * maxLoadTenths / 10, Duration{});
}

void LineNoiseMeter::addBytes(Duration wireTime, bool frame, Duration now, Duration maxLevel)
{
    if (now - m_lastAt > pause)
        m_frames = 0;
    m_level = std::min(levelAt(now) + wireTime, maxLevel);
    m_lastAt = now;
    m_frames = std::min(m_frames + (frame ? 1 : 0), maxFrameCount);
}

bool LineNoiseMeter::isOverloaded(Duration allowed, Duration now) const
{
    return levelAt(now) > allowed;
}
} // namespace bus
