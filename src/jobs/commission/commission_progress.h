// SPDX-License-Identifier: GPL-3.0-or-later
// How far the batch is: which servos are done, which are unfinished and where they may answer, and
// which ID is next. Every change is on the disk before the line goes on. Internal to jobs; the
// job's thread. Errors are those of results::saveCommissionBatch.
#pragma once

#include "jobs/commission/commission_detector.h"
#include "jobs/commission/commission_steps.h"

namespace jobs {
class CommissionProgress {
public:
    using BusLocation = CommissionDetector::BusLocation;

    CommissionProgress(const device::Context& context, const CommissionSpec& spec,
                       results::CommissionBatch& batch, QString csvPath,
                       const CommissionCallbacks& callbacks)
        : m_context(context)
        , m_spec(spec)
        , m_batch(batch)
        , m_csvPath(std::move(csvPath))
        , m_callbacks(callbacks)
    {}

    static BusLocation locationOf(const results::ServoLocation& kept);
    static BusLocation locationOf(const device::Servo& servo);

    const results::CommissionBatch& batch() const { return m_batch; }
    base::Result<void> save();

    std::optional<int> nextId() const;
    /// Where an unfinished servo may answer, other than under its old ID.
    std::vector<BusLocation> expectedLocations() const;
    CommissionView waitingView() const;

    /// The unfinished servo that gets this ID; null: there is none. Valid until the next change.
    results::PendingCommission* findPending(int newId, const QString& protocol);
    results::PendingCommission* pendingOf(const CommissionWork& work);
    /// Is `work` a servo that is unfinished? Then it continues with its assigned ID. Where it may
    /// as well be another one of the kind, the view names the ID in question instead.
    bool matchPending(CommissionWork& work, CommissionView& view) const;
    base::Result<void> addPending(const CommissionWork& work, bool isResumed);

    /// The servo is done, unless the journal holds a change of it that has not ended.
    void removePending(const CommissionWork& work);
    base::Result<void> addRow(const CommissionWork& work, const results::CommissionRow& row);
    base::Result<void> setUnplugged();         ///< the servo of the last row
    void setLost(bool lost) { m_lost = lost; } ///< a servo was disconnected before it was done

private:
    const device::Context& m_context;
    const CommissionSpec& m_spec;
    results::CommissionBatch& m_batch;
    const QString m_csvPath;
    const CommissionCallbacks& m_callbacks;
    bool m_lost = false;
};
} // namespace jobs
