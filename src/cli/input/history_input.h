// SPDX-License-Identifier: GPL-3.0-or-later
// What is typed after "history" as a filter, and the history itself for as long as a command takes.
// Main thread. BadArgument, and the errors of record/history.h.
#pragma once

#include "cli/command.h"
#include "history/history.h"
#include "history/history_export.h"
#include "history/history_profiles.h"

namespace cli {
/// --servo, --id, --model, --label, --since, --until, --register, --trouble, --most
std::vector<Option> historyOptions();
/// Null: there is none yet, and none is made by looking.
base::Result<std::unique_ptr<record::History>> openHistory();
/// With a null history --servo names nobody.
base::Result<record::HistoryFilter> historyFilter(const record::History* history,
                                                  const Values& values);

/// "2026-11-22", "2026-11-22T10:30" or "2026-11-22 10:30:05" (local, unless it says otherwise),
/// "10:30" (today), "90m", "2h", "3d", "1w" (ago). Answers UTC.
base::Result<QDateTime> parseDateTime(const QString& word, const QDateTime& now);
/// The number of a servo, or the label of the only one that has it.
base::Result<std::int64_t> parseServo(const record::History& history, const QString& word);

/// All servos of the history, so that values can be shown with their units.
base::Result<void> loadProfiles(const record::History& history, record::HistoryProfiles& profiles);
} // namespace cli
