// SPDX-License-Identifier: GPL-3.0-or-later
// Saves sweep tests and step responses to the history and loads them from it. Main thread; opens
// the database for each call. Errors of history/history.h and of results::loadSweepRun; BadArgument
// for a servo that is not in the run.
#pragma once

#include "cli/output/console.h"
#include "history/history.h"
#include "jobs/sweep/sweep.h"
#include "results/sweep_compare.h"

namespace cli {
/// Returns a line for the user. If the history cannot be written, the test has not failed: a
/// message on stderr names the file in which the run was saved instead.
QString saveSweep(Console& console, const results::SweepRun& run, const QStringList& files);
QString saveStep(Console& console, const results::StepRun& run, const QStringList& files);

/// For SweepCallbacks::onUnreleasedTorque.
QString unreleasedTorqueText(const jobs::UnreleasedTorque& left);

/// Empty if there is no history yet; it is not created.
base::Result<std::vector<history::TestRun>> listRuns(const history::RunFilter& filter);

/// "12", "#12" (in the history), "12:3" (servo 3 of it), or a report file (.json), also with ":3".
struct RunSelector {
    QString name;
    std::int64_t number = 0; ///< 0: a file
    std::optional<int> servo{};
};
base::Result<RunSelector> parseRunSelector(const QString& word);
base::Result<results::SweepRun> loadSweep(const RunSelector& word);
/// One run of the history, or all runs of a report file.
base::Result<std::vector<results::StepRun>> loadSteps(const RunSelector& word);

/// The servo with this ID, or the only one if no ID is given.
base::Result<const results::SweepServo*> chooseServo(const results::SweepRun& run,
                                                     const RunSelector& word);
} // namespace cli
