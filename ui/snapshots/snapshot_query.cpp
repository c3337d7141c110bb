// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/snapshot_query.h"

#include <algorithm>

namespace ui {
base::Result<std::vector<history::HistorySnapshot>>
findSnapshots(const history::History& history, const std::optional<base::ServoIdentity>& identity,
              std::int64_t required, int limit)
{
    const history::HistoryLog log = history.log();
    history::HistoryFilter filter;
    filter.limit = limit;
    if (identity) {
        const auto servo = log.of(*identity);
        if (!servo)
            return tl::unexpected(servo.error());
        if (!*servo)
            return std::vector<history::HistorySnapshot>(); // not in the history
        filter.servo = (*servo)->number;
    }
    auto rows = log.snapshots(filter);
    const bool isIncluded = !rows || required == 0 ||
                            std::any_of(rows->begin(), rows->end(),
                                        [&](const auto& row) { return row.number == required; });
    if (isIncluded)
        return rows;
    if (auto row = log.snapshotRow(required))
        rows->push_back(std::move(*row));
    return rows;
}
} // namespace ui
