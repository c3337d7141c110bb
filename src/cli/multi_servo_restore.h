// SPDX-License-Identifier: GPL-3.0-or-later
// What commands that restore to several servos share: saving each memory table first, the progress
// list, the result. Owned by the command, on its stack; main thread.
#pragma once

#include "cli/output/progress.h"
#include "cli/run.h"
#include "jobs/restore/restore_many.h"

namespace cli {
class MultiServoRestore {
public:
    MultiServoRestore(Run& run, const Values& values);

    /// According to the options of the command. Valid while this object exists.
    jobs::ApplyOptions options();
    jobs::ProgressFn progress();
    /// Prints the result and saves it to the file of --result. `document`: what it begins with.
    base::Result<Exit> finish(const std::vector<jobs::ApplyResult>& all, const QString& file,
                              Json document = Json::object());

private:
    Run& m_run;
    const Values& m_values;
    std::optional<ProgressLine> m_line;
};
} // namespace cli
