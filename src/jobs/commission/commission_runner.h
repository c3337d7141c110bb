// SPDX-License-Identifier: GPL-3.0-or-later
// The line itself: waits for servos, deals with each, keeps the batch. Lives for one call of
// commission(); internal to jobs; its thread. commission_line.cpp knows who is there,
// commission_setup.cpp what is done to a servo, commission_end.cpp how it ends.
#pragma once

#include "jobs/commission/commission_detector.h"
#include "jobs/commission/commission_steps.h"

#include <map>

namespace jobs {
constexpr base::Duration pollPause = std::chrono::milliseconds(50);
/// A plug that is being pulled makes contact more than once.
constexpr int missedPingsUntilGone = 3;

class CommissionRunner {
public:
    CommissionRunner(const device::Context& context, const CommissionSpec& spec,
                     record::CommissionBatch& batch, QString csvPath,
                     const CommissionCallbacks& callbacks)
        : m_context(context)
        , m_spec(spec)
        , m_batch(batch)
        , m_csvPath(std::move(csvPath))
        , m_callbacks(callbacks)
        , m_detector(context, spec)
    {}

    base::Result<CommissionEnd> run();

private:
    using BusLocation = CommissionDetector::BusLocation;

    static BusLocation locationOf(const record::ServoLocation& kept);
    static BusLocation locationOf(const device::Servo& servo);
    std::optional<int> nextId() const;
    void show(const CommissionView& view);
    base::Result<void> pause(base::Duration span);
    base::Result<void> saveBatch();

    // --- who is there ---
    base::Result<device::Servo> waitForServo();
    base::Result<bool> isAlone(const BusLocation& first, device::Servo& servo);
    std::vector<BusLocation> expectedLocations() const;
    CommissionView waitingView() const;
    base::Result<void> waitForUnplug(const BusLocation& place, CommissionView view);
    /// The row of a servo that is done with, and waits until it is unplugged.
    base::Result<void> recordRow(const CommissionWork& work, const record::CommissionRow& row,
                                 CommissionView view);

    // --- one servo ---
    base::Result<void> processServo(device::Servo servo);
    base::Result<void> skip(const CommissionWork& work,
                            const std::vector<record::CommissionIssue>& why);
    base::Result<bool> decide(CommissionWork& work, CommissionView& view,
                              std::vector<record::CommissionIssue>& issues);
    base::Result<bool> confirm(CommissionWork& work, CommissionView view,
                               std::vector<record::CommissionIssue>& issues);
    base::Result<void> setUp(CommissionWork& work, CommissionView& view);
    base::Result<void> begin(CommissionWork& work, CommissionView& view);
    base::Result<void> addPending(const CommissionWork& work, const CommissionView& view);
    base::Result<void> assignId(CommissionWork& work);
    base::Result<void> assignIdAndName(CommissionWork& work);
    enum class SameServoCheck : std::uint8_t {
        NotVerified, ///< another one may be here by now
        Resolved,    ///< the very servo, and nothing of it is open any more
        Unresolved,  ///< the very servo: its lock does not close, or a write is refused
    };
    base::Result<SameServoCheck> verifySameServo(CommissionWork& work,
                                                 const record::PendingCommission& pending);
    base::Result<void> handleFailure(CommissionWork& work, const base::Error& error);
    base::Result<void> markLost();
    base::Result<void> finish(CommissionWork& work);
    base::Result<void> saveName(CommissionWork& work, const QString& label);
    QString labelOf(const CommissionWork& work) const;
    base::Result<bool> isStillAlone(CommissionWork& work);
    bool matchPending(CommissionWork& work, CommissionView& view);
    void addUnfinishedIssues(const CommissionWork& work, CommissionView& view);
    record::PendingCommission* findPending(int newId, const QString& protocol);
    record::PendingCommission* pendingOf(const CommissionWork& work);

    const device::Context& m_context;
    const CommissionSpec& m_spec;
    record::CommissionBatch& m_batch;
    const QString m_csvPath;
    const CommissionCallbacks& m_callbacks;
    CommissionDetector m_detector;
    std::optional<CommissionView> m_view;
    std::map<int, int>
        m_reidentifications; ///< by the ID it was to have: how often it was looked at anew
    bool m_lost = false;     ///< the last one went away in the middle
};
} // namespace jobs
