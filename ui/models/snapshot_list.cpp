// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/snapshot_list.h"

#include <algorithm>

namespace ui {
base::Result<std::vector<record::HistorySnapshot>>
listedSnapshots(const record::History& history, const std::optional<base::ServoIdentity>& who,
                std::int64_t wanted, int most)
{
    const record::HistoryLog log = history.log();
    record::HistoryFilter filter;
    filter.most = most;
    if (who) {
        const auto servo = log.of(*who);
        if (!servo)
            return tl::unexpected(servo.error());
        if (!*servo)
            return std::vector<record::HistorySnapshot>(); // never met
        filter.servo = (*servo)->number;
    }
    auto rows = log.snapshots(filter);
    const bool there = !rows || wanted == 0 ||
                       std::any_of(rows->begin(), rows->end(),
                                   [&](const auto& row) { return row.number == wanted; });
    if (there)
        return rows;
    if (auto row = log.snapshotRow(wanted))
        rows->push_back(std::move(*row));
    return rows;
}
} // namespace ui
