// SPDX-License-Identifier: GPL-3.0-or-later
// What commands that restore to several servos share: saving each table first, the list that grows,
// the end. Lives on the command's stack; main thread.
#pragma once

#include "cli/output/progress.h"
#include "cli/run.h"
#include "jobs/restore/restore_many.h"

namespace cli {
class MultiServoRestore {
public:
    MultiServoRestore(Run& run, const Values& values);

    /// As the options on the command line say. Valid while this lives.
    jobs::ApplyOptions options();
    jobs::ProgressFn progress();
    /// Shows everything; saves the result where --result names a file.
    base::Result<Exit> finish(const std::vector<jobs::ApplyResult>& all, const QString& file);

private:
    Run& m_run;
    const Values& m_values;
    std::optional<ProgressLine> m_line;
};
} // namespace cli
