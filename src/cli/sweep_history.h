// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep tests in and out of the history, for the commands. Main thread; opens the database for as
// long as it takes. Errors of record/history.h and of record::loadSweepRun; BadArgument for a
// servo that is not in the run.
#pragma once

#include "cli/output/console.h"
#include "history/history.h"
#include "jobs/sweep/sweep.h"
#include "results/sweep_compare.h"

namespace cli {
/// Answers a line for the user. That the history could not be written is no failure of the test: it
/// is said on stderr, with the place where the run was left.
QString saveSweep(Console& console, const record::SweepRun& run, const QStringList& files);
QString saveStep(Console& console, const record::StepRun& run, const QStringList& files);

/// For SweepCallbacks::onUnreleasedTorque.
QString unreleasedTorqueText(const jobs::UnreleasedTorque& left);

/// Not made if there is none yet.
base::Result<std::vector<record::TestRun>> listSweeps(const record::RunFilter& filter);

/// "12", "#12" (in the history), "12:3" (servo 3 of it), or a report file (.json), also with ":3".
struct RunSelector {
    QString name;
    std::int64_t number = 0; ///< 0: a file
    std::optional<int> servo{};
};
base::Result<RunSelector> parseRunSelector(const QString& word);
base::Result<record::SweepRun> loadSweep(const RunSelector& word);

/// The servo meant; without a word about it, the only one there is.
base::Result<const record::SweepServo*> chooseServo(const record::SweepRun& run,
                                                    const RunSelector& word);
} // namespace cli
