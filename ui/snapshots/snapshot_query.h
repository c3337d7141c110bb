// SPDX-License-Identifier: GPL-3.0-or-later
// The snapshots that the shelf lists, newest first. On the thread of the history.
#pragma once

#include "history/history.h"

namespace ui {
/// Of one servo, or of all. The snapshot numbered `wanted` comes along, however old it is; 0: none.
base::Result<std::vector<record::HistorySnapshot>>
findSnapshots(const record::History& history, const std::optional<base::ServoIdentity>& identity,
              std::int64_t required, int most);
} // namespace ui
