// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/link_meter.h"

#include <algorithm>

namespace ui {
void LinkMeter::reset()
{
    *this = {};
}

void LinkMeter::look(const bus::Statistics& now, bool searching, base::Duration at)
{
    const bool searched = searching || m_lastSearching;
    const bus::Statistics last = m_last.value_or(bus::Statistics{});
    const auto grown = [&](std::uint64_t bus::Counters::*counter) {
        const std::uint64_t before = last.total.*counter;
        return now.total.*counter > before ? now.total.*counter - before : 0;
    };
    if (!searched)
        m_figures.errors += grown(&bus::Counters::timeOuts) + grown(&bus::Counters::badChecks) +
                            grown(&bus::Counters::foreign);
    const double seconds = double((at - m_lastAt).count()) / 1e6;
    if (m_last && seconds > 0) {
        m_figures.readsPerSecond = int(double(grown(&bus::Counters::ok)) / seconds + 0.5);
        const double wire = double((now.wireTime - last.wireTime).count()) / 1e6;
        m_figures.wireUse = std::clamp(wire / seconds, 0.0, 1.0);
    }
    m_last = now;
    m_lastAt = at;
    m_lastSearching = searching;
}
} // namespace ui
