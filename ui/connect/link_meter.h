// SPDX-License-Identifier: GPL-3.0-or-later
// The values of the status light of an open port, calculated from the bus counters between two
// updates. Silence during a search is no error, because a search asks free IDs and uses broadcasts;
// neither is the silence of an ID that never answered. A value; main thread.
#pragma once

#include "bus/statistics.h"

#include <optional>

namespace ui {
class LinkMeter {
public:
    struct Values {
        int readsPerSecond = 0;
        std::uint64_t errors = 0; ///< since the port was opened: lost, damaged, foreign answers
        double busLoad = 0;       ///< 0…1
    };

    void reset();
    /// Call now and then, and when a search begins and ends. `searched`: a search has been running
    /// since the last look. `at`: any clock, as long as it is always the same.
    void addStatistics(const bus::Statistics& now, bool searched, base::Duration at);
    const Values& values() const { return m_values; }

private:
    bus::Statistics m_last;
    std::optional<bus::Statistics> m_rateFrom; ///< rates need some time between two looks
    base::Duration m_rateAt{};
    Values m_values;
};
} // namespace ui
