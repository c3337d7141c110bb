// SPDX-License-Identifier: GPL-3.0-or-later
// The options of "history" as a filter, and opening the history for a command. Main thread.
// BadArgument, and the errors of history/history.h.
#pragma once

#include "cli/command.h"
#include "history/history.h"
#include "history/history_export.h"
#include "history/history_profiles.h"

namespace cli {
/// --servo, --id, --model, --label, --since, --until, --register, --problems, --limit
std::vector<Option> historyOptions();
/// Null: there is no history yet; it is not created.
base::Result<std::unique_ptr<history::History>> openHistory();
/// With a null history, --servo is ignored.
base::Result<history::HistoryFilter> historyFilter(const history::History* history,
                                                   const Values& values);

/// "2026-11-22", "2026-11-22T10:30" or "2026-11-22 10:30:05" (local time unless stated),
/// "10:30" (today), "90m", "2h", "3d", "1w" (ago). Returns UTC.
base::Result<QDateTime> parseDateTime(const QString& word, const QDateTime& now);
/// By the number of the servo, or by a label that only one servo has.
base::Result<std::int64_t> parseServo(const history::History& history, const QString& word);

/// The profiles of all servos in the history, for the units of values.
base::Result<void> loadProfiles(const history::History& history,
                                history::HistoryProfiles& profiles);
} // namespace cli
