// SPDX-License-Identifier: GPL-3.0-or-later
// The progress of a long task, on stderr: nothing in the first second, then one line that is
// rewritten on a terminal, an occasional line in a pipe, nothing in a file. Main thread.
#pragma once

#include "cli/output/console.h"
#include "jobs/job.h"

#include <chrono>

namespace cli {
class ProgressLine {
public:
    ProgressLine(Console& console, QString task);
    ~ProgressLine(); ///< removes the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void update(const jobs::Progress& progress);
    void show(const QString& state);

private:
    using Clock = std::chrono::steady_clock;

    Console& m_console;
    QString m_task;
    Clock::time_point m_next;
    jobs::TimeLeft m_left;
    bool m_shown = false;
};
} // namespace cli
