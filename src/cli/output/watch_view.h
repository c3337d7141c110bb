// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of "watch" as text: one line per servo, updated in place on a terminal; one line per
// reading elsewhere. Main thread. Does nothing in JSON mode.
#pragma once

#include "cli/output/console.h"
#include "jobs/watch/watch.h"

#include <chrono>
#include <map>

namespace cli {
class WatchView {
public:
    WatchView(Console& console, const jobs::WatchSpec& spec, bool quiet);

    void add(const jobs::WatchRow& row);
    /// Prints the last readings once more and leaves the cursor below them.
    void finish();

private:
    using Clock = std::chrono::steady_clock;

    QString header() const;
    QString line(const jobs::WatchRow& row) const;
    void remember(const jobs::WatchRow& row);
    void redraw();

    Console& m_console;
    /// Only measured values: flags are in the alarms and in the file.
    struct Column {
        std::size_t place = 0; ///< in the values of a row
        QString title;
        int width = 0;
    };
    std::vector<Column> m_columns;
    std::map<int, catalog::ProfilePtr> m_profiles;
    std::map<int, jobs::WatchRow> m_latest;
    std::optional<base::Duration> m_start;
    Clock::time_point m_next;
    int m_drawn = 0; ///< number of lines that the next redraw replaces
    bool m_inPlace = false;
    bool m_quiet = false; ///< the readings go to a file, and there is no terminal
    bool m_headerShown = false;
};
} // namespace cli
