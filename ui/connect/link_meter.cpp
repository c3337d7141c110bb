// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/link_meter.h"

#include <QtGlobal>

#include <algorithm>

namespace ui {
namespace {
constexpr double minInterval = 0.5; ///< seconds

/// Timeouts of servos since the last update. An ID that never answered is not a servo, but a free
/// ID that a change of ID has checked.
std::uint64_t silences(const bus::Statistics& last, const bus::Statistics& now)
{
    std::uint64_t sum = 0;
    for (const auto& [id, counters] : now.byId) {
        const auto before = last.byId.find(id);
        const std::uint64_t then = before != last.byId.end() ? before->second.timeouts : 0;
        if (counters.ok > 0 && counters.timeouts > then)
            sum += counters.timeouts - then;
    }
    return sum;
}
} // namespace

void LinkMeter::reset()
{
    *this = {};
}

void LinkMeter::addStatistics(const bus::Statistics& now, bool searched, base::Duration at)
{
    const auto samplesAdded = [&](const bus::Statistics& last,
                                  std::uint64_t bus::Counters::*counter) {
        const std::uint64_t before = last.total.*counter;
        return now.total.*counter > before ? now.total.*counter - before : 0;
    };
    if (!searched) {
        m_values.errors += samplesAdded(m_last, &bus::Counters::badChecksums) +
                           samplesAdded(m_last, &bus::Counters::foreign) + silences(m_last, now);
    }
    m_last = now;
    const double seconds = double((at - m_rateAt).count()) / 1e6;
    if (m_rateFrom && seconds < minInterval)
        return;
    if (m_rateFrom) {
        const auto reads = double(samplesAdded(*m_rateFrom, &bus::Counters::ok));
        m_values.readsPerSecond = qRound(reads / seconds);
        const double wire = double((now.wireTime - m_rateFrom->wireTime).count()) / 1e6;
        m_values.busLoad = std::clamp(wire / seconds, 0.0, 1.0);
    }
    m_rateFrom = now;
    m_rateAt = at;
}
} // namespace ui
