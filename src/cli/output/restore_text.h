// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots, restore plans and their results as tables and as JSON, and the options that several
// commands of restoring share. Pure; main thread (translated words).
#pragma once

#include "cli/command.h"
#include "cli/output/json.h"
#include "cli/output/table.h"
#include "jobs/restore/restore_many.h"

namespace cli {
/// "300 · 26.4°"; "–" where there is no number.
QString formatNumber(std::optional<std::int64_t> raw, std::optional<double> value,
                     const QString& unit);

/// --only, --live, --dangerous, --roll-back, --dry-run, --result; the command adds its own.
std::vector<Option> restoreOptions(std::vector<Option> more = {});
jobs::RestoreChoice choiceOf(const Values& values);
jobs::RestoreOptions restoreOptionsOf(const Values& values);

/// Keys of --only that neither the file nor this servo has. UnknownRegister, with what is near.
base::Result<void> checkOnly(const Values& values, const record::Snapshot& snapshot);

/// Adds "writes", "steps", "left_out", "alarms" and what is known of model and firmware.
void addPlan(Json& json, const jobs::RestorePlan& plan);
/// The writes as a table, what is left out and why, and which limits would cause an alarm now.
QString planText(const jobs::RestorePlan& plan);
/// One line for each limit that the servo's readings are outside of; empty where there is none.
QString alarmsText(const jobs::RestorePlan& plan);
/// "2 rows were left out: …", each with its reason; empty where there is none.
QString leftOutText(const jobs::RestorePlan& plan);
/// What happens around the writes, line by line.
QString stepsText(const jobs::RestorePlan& plan);

/// Adds "verdict", "results", "lock" and where it answers.
void addOutcome(Json& json, const jobs::RestoreOutcome& outcome);
QString outcomeText(const jobs::RestoreOutcome& outcome, const device::Servo& servo);
/// Nothing had to be written, or all of it was.
bool isSuccess(const jobs::RestoreOutcome& outcome);
/// A row that was asked for by name differs, or might, and is not written.
bool hasUnwrittenRequest(const jobs::RestorePlan& plan);
/// NotDone also where a row that was asked for by name is left out.
Exit exitCode(const jobs::RestoreOutcome& outcome, const jobs::RestorePlan& plan);

/// Several servos: one line each, then the rows that did not go well.
Json jsonApplied(const jobs::ApplyResult& applied);
QString appliedText(const std::vector<jobs::ApplyResult>& all);
Exit exitCode(const std::vector<jobs::ApplyResult>& all);

/// For --result; servos that never answered have a line without rows.
std::vector<record::RestoreResult> resultsOf(const std::vector<jobs::ApplyResult>& all,
                                             const QString& source);
} // namespace cli
