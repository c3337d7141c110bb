// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the snapshots that the browser lists, newest first. On the thread of the history; errors
// are those of the history.
#pragma once

#include "history/history.h"

namespace ui {
/// Of one servo, or of all. The snapshot numbered `required` is included, however old it is; 0:
/// none.
base::Result<std::vector<history::HistorySnapshot>>
findSnapshots(const history::History& history, const std::optional<base::ServoIdentity>& identity,
              std::int64_t required, int limit);
} // namespace ui
