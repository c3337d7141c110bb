// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and stop of long tasks. A job is a plain sequential function on the caller's
// thread; it writes as described in its header and returns a report or an error.
#pragma once

#include "device/context.h"

#include <functional>
#include <optional>

namespace jobs {
struct Progress {
    double fraction = 0;                               ///< 0…1
    std::optional<base::Duration> remaining{};         ///< where the job knows better than the
                                                       ///< time it took so far
    int found = 0;                                     ///< scan: servos so far
    int baud = 0;                                      ///< scan: rate being searched
    base::Protocol protocol = base::Protocol::Feetech; ///< scan: protocol being searched
};

using ProgressFn = std::function<void(const Progress&)>;

/// How long a job still takes: its own estimate, or one by the time since its first report.
class TimeLeft {
public:
    /// None while too little is done to tell. In the order of the reports.
    std::optional<base::Duration> estimate(const Progress& progress, base::Duration now)
    {
        constexpr double leastDone = 0.02;
        if (!m_first)
            m_first = {now, progress.fraction};
        const double done = progress.fraction - m_first->fraction;
        if (progress.remaining || done < leastDone)
            return progress.remaining;
        return base::Duration(base::Duration::rep(double((now - m_first->at).count()) *
                                                  (1 - progress.fraction) / done));
    }

private:
    struct Report {
        base::Duration at;
        double fraction;
    };
    std::optional<Report> m_first;
};
} // namespace jobs
