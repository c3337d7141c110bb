// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of a scan by planned time: the rest of the plan is the estimate. Used by scan()
// only; its thread.
#pragma once

#include "jobs/job.h"

#include <algorithm>

namespace jobs {
class ScanProgress {
public:
    ScanProgress(const ProgressFn& report, base::Clock& clock, base::Duration total)
        : m_report(report)
        , m_clock(clock)
        , m_total(total)
    {}

    /// `foundCount`: servos of the present search that are not counted as found yet.
    void add(base::Duration planned, int foundCount)
    {
        m_progress.found = m_found + foundCount;
        m_done = std::min(m_total, m_done + planned);
        if (m_clock.now() - m_reportedAt >= interval)
            notify();
    }

    void startSearch(int baud, base::Protocol protocol)
    {
        m_progress.baud = baud;
        m_progress.protocol = protocol;
        notify();
    }
    void skip(base::Duration planned) { m_total -= planned; }
    void countFound() { m_progress.found = ++m_found; }

    void notify()
    {
        if (!m_report)
            return;
        m_reportedAt = m_clock.now();
        m_progress.fraction =
            m_total.count() > 0 ? double(m_done.count()) / double(m_total.count()) : 1;
        m_progress.remaining = m_total - m_done;
        m_report(m_progress);
    }

private:
    static constexpr base::Duration interval = std::chrono::milliseconds(50);

    const ProgressFn& m_report;
    base::Clock& m_clock;
    base::Duration m_total;
    base::Duration m_done{};
    base::Duration m_reportedAt{};
    int m_found = 0;
    Progress m_progress;
};
} // namespace jobs
