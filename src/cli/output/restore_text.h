// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots, restore plans and their results as tables and as JSON, and the options of the
// restoring commands. Pure; main thread (translated texts).
#pragma once

#include "cli/command.h"
#include "cli/output/json.h"
#include "cli/output/table.h"
#include "jobs/restore/restore_many.h"

namespace cli {
/// "300 · 26.4°"; "–" if there is no number.
QString formatNumber(std::optional<std::int64_t> raw, std::optional<double> value,
                     const QString& unit);

inline constexpr Option dryRunOption{
    "--dry-run", QT_TRANSLATE_NOOP("cli", "show what would be written, without writing")};
/// --only, --live, --dangerous, --roll-back, --dry-run, --result; plus those of the command.
std::vector<Option> restoreOptions(std::vector<Option> more = {});
jobs::RestoreChoice choiceOf(const Values& values);
jobs::RestoreOptions restoreOptionsOf(const Values& values);

/// The file to restore. UnknownRegister with similar names if --only names a key that it does not
/// contain.
base::Result<snapshot::Snapshot> loadToRestore(const Values& values, const QString& file);

/// Adds "writes", "steps", "left_out", "alarms" and whether model and firmware differ.
void addPlan(Json& json, const jobs::RestorePlan& plan);
/// The writes as a table, what is not written and why, and which limits would cause an alarm now.
QString planText(const jobs::RestorePlan& plan);
/// One line for each limit that the present readings exceed; empty: none.
QString alarmsText(const jobs::RestorePlan& plan);
/// The rows that are not written, each with its reason; empty: none.
QString leftOutText(const jobs::RestorePlan& plan);
/// All steps of the plan, one per line.
QString stepsText(const jobs::RestorePlan& plan);

/// Adds "verdict", "results", "lock", and ID and baud rate afterwards.
void addOutcome(Json& json, const jobs::RestoreOutcome& outcome);
QString outcomeText(const jobs::RestoreOutcome& outcome, const device::Servo& servo);
/// Everything was written, or nothing had to be.
bool isSuccess(const jobs::RestoreOutcome& outcome);
/// A row named with --only differs, or may differ, and is not written.
bool hasUnwrittenRequest(const jobs::RestorePlan& plan);
/// Failed also if a row named with --only is not written.
Exit exitCode(const jobs::RestoreOutcome& outcome, const jobs::RestorePlan& plan);

/// For several servos: one line each, then the rows that failed.
Json jsonApplied(const jobs::ApplyResult& applied);
QString appliedText(const std::vector<jobs::ApplyResult>& all);
Exit exitCode(const std::vector<jobs::ApplyResult>& all);

/// For --result; servos that did not reply have an entry without rows.
std::vector<snapshot::RestoreResult> resultsOf(const std::vector<jobs::ApplyResult>& all,
                                               const QString& source);
} // namespace cli
