// SPDX-License-Identifier: GPL-3.0-or-later
// What the status light says of an open port, worked out from the bus's counters between two looks.
// What a search hears is no error: it asks IDs that nobody has, and everybody at once. A value;
// main thread.
#pragma once

#include "bus/statistics.h"

#include <optional>

namespace ui {
class LinkMeter {
public:
    struct Figures {
        int readsPerSecond = 0;
        std::uint64_t errors = 0; ///< since the port was opened: lost, damaged, foreign answers
        double wireUse = 0;       ///< 0…1
    };

    void reset();
    /// `at`: any clock, as long as it is always the same.
    void look(const bus::Statistics& now, bool searching, base::Duration at);
    const Figures& figures() const { return m_figures; }

private:
    std::optional<bus::Statistics> m_last;
    base::Duration m_lastAt{};
    bool m_lastSearching = false;
    Figures m_figures;
};
} // namespace ui
