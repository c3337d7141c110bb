// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning line: waits for a servo, checks it, asks the user, has it set up, records its
// row and waits until it is disconnected. Lives for one call of commission(); internal to jobs; the
// job's thread. Errors end the line; what happens to one servo is in its row.
#pragma once

#include "jobs/commission/commission_presence.h"
#include "jobs/commission/commission_setup.h"

#include <map>

namespace jobs {
class CommissionRunner {
public:
    CommissionRunner(const device::Context& context, const CommissionSpec& spec,
                     results::CommissionBatch& batch, const QString& csvPath,
                     const CommissionCallbacks& callbacks)
        : m_context(context)
        , m_spec(spec)
        , m_callbacks(callbacks)
        , m_display(callbacks)
        , m_progress(context, spec, batch, csvPath, callbacks)
        , m_presence(context, spec, m_progress, m_display)
        , m_setup(context, spec, callbacks, m_progress, m_display)
    {}

    base::Result<CommissionEnd> run();

private:
    using BusLocation = CommissionDetector::BusLocation;
    using Issues = std::vector<results::CommissionIssue>;

    base::Result<void> processServo(device::Servo servo);
    /// False: the servo is not set up now, and its row is recorded where it gets one.
    base::Result<bool> decide(CommissionWork& work, CommissionView& view, const Issues& issues);
    base::Result<bool> confirm(CommissionWork& work, CommissionView view, const Issues& issues);
    base::Result<bool> skip(const CommissionWork& work, const Issues& issues);
    void addUnfinishedIssues(const CommissionWork& work, CommissionView& view);

    base::Result<void> handleFailure(CommissionWork& work, const base::Error& error);
    enum class SameServoCheck : std::uint8_t {
        NotVerified, ///< it may be another servo
        Resolved,    ///< the same servo, and no change of it is open any more
        Unresolved,  ///< the same servo: its lock does not close, or a write is refused
    };
    base::Result<SameServoCheck> verifySameServo(CommissionWork& work,
                                                 const results::PendingCommission& pending);
    base::Result<void> markLost();

    base::Result<void> finish(CommissionWork& work);
    base::Result<void> recordRow(const CommissionWork& work, const results::CommissionRow& row,
                                 CommissionView view);
    base::Result<void> waitForUnplug(const BusLocation& place, CommissionView view);

    const device::Context& m_context;
    const CommissionSpec& m_spec;
    const CommissionCallbacks& m_callbacks;
    CommissionDisplay m_display;
    CommissionProgress m_progress;
    CommissionPresence m_presence;
    CommissionSetup m_setup;
    std::map<int, int> m_reidentifications; ///< how often, by the ID that was assigned
};
} // namespace jobs
