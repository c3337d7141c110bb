// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_progress.h"

#include "jobs/commission/commission_recovery.h"
#include "jobs/restore/take_snapshot.h"

#include <algorithm>

namespace jobs {
using results::PendingCommission;

CommissionProgress::BusLocation CommissionProgress::locationOf(const results::ServoLocation& kept)
{
    return {base::protocolFromName(kept.protocol).value_or(base::Protocol::Feetech), kept.id,
            kept.baud};
}

CommissionProgress::BusLocation CommissionProgress::locationOf(const device::Servo& servo)
{
    return {servo.protocol, servo.id, servo.baud};
}

base::Result<void> CommissionProgress::save()
{
    updateLockStates(m_context, m_batch.pending);
    auto saved = results::saveCommissionBatch(m_batch, m_csvPath);
    if (saved && m_callbacks.onBatch)
        m_callbacks.onBatch();
    return saved;
}

std::optional<int> CommissionProgress::nextId() const
{
    const auto isUsedId = [this](int id) {
        return m_batch.isIdTaken(id) ||
               std::any_of(m_batch.pending.begin(), m_batch.pending.end(), [&](const auto& one) {
                   return one.newId == id && hasOpenIntent(m_context, one);
               });
    };
    const auto next = std::find_if_not(m_spec.ids.begin(), m_spec.ids.end(), isUsedId);
    return next == m_spec.ids.end() ? std::nullopt : std::optional(*next);
}

std::vector<CommissionProgress::BusLocation> CommissionProgress::expectedLocations() const
{
    std::vector<BusLocation> places;
    for (const PendingCommission& one : m_batch.pending) {
        const auto protocol =
            base::protocolFromName(one.servo.protocol).value_or(base::Protocol::Feetech);
        if (!one.isIdSent)
            continue; // under its old ID it is found like any other servo
        places.push_back({protocol, one.newId, one.newBaud});
        if (one.oldBaud != one.newBaud)
            places.push_back({protocol, one.newId, one.oldBaud});
    }
    return places;
}

CommissionView CommissionProgress::waitingView() const
{
    CommissionView view;
    view.newId = nextId().value_or(-1);
    view.newBaud = m_spec.baud;
    if (m_lost && !m_batch.pending.empty()) {
        view.obstacle = CommissionObstacle::Lost;
        view.servo = m_batch.pending.back().servo;
        view.newId = m_batch.pending.back().newId;
        view.issues = results::unfinishedIssues(m_batch.pending.back());
    }
    return view;
}

PendingCommission* CommissionProgress::findPending(int newId, const QString& protocol)
{
    for (PendingCommission& one : m_batch.pending) {
        if (one.newId == newId && one.servo.protocol == protocol)
            return &one;
    }
    return nullptr;
}

PendingCommission* CommissionProgress::pendingOf(const CommissionWork& work)
{
    return findPending(work.newId, work.row.servo.protocol);
}

/// Under its old ID it may be another servo of the kind, if the new ID may have been written
/// already or a write to it has not ended, unless its lock is still open. Once the new ID was read
/// back, it certainly is another servo.
bool CommissionProgress::matchPending(CommissionWork& work, CommissionView& view) const
{
    const snapshot::SnapshotServo identity = snapshotServo(work.servo);
    for (const PendingCommission& one : m_batch.pending) {
        const bool isSameKind = one.servo.protocol == identity.protocol &&
                                one.servo.modelId == identity.modelId &&
                                one.servo.firmware == identity.firmware;
        const bool isAtNewId = one.isIdSent && identity.id == one.newId;
        const bool isAtOldId = identity.id == one.servo.id && !one.isIdConfirmed;
        const bool isAtRate = work.servo.baud == one.oldBaud || work.servo.baud == one.newBaud;
        if (!isSameKind || !isAtRate || !(isAtNewId || isAtOldId))
            continue;
        work.isVerified = hasLeftLockOpen(m_context, work.servo, one);
        const bool begun = one.isIdSent || hasOpenIntent(m_context, one);
        if (!isAtNewId && begun && !work.isVerified) {
            view.candidateId = one.newId;
            continue;
        }
        work.newId = one.newId;
        work.row.servo = one.servo;
        work.row.oldBaud = one.oldBaud;
        view.candidateId = -1;
        return true;
    }
    return false;
}

base::Result<void> CommissionProgress::addPending(const CommissionWork& work, bool isResumed)
{
    PendingCommission* known = pendingOf(work);
    const bool isAtNewId = work.servo.id == work.newId;
    PendingCommission now{QDateTime::currentDateTimeUtc(),
                          work.row.servo,
                          work.row.oldBaud,
                          work.newId,
                          work.newBaud,
                          isAtNewId,
                          work.row.snapshot};
    now.simulated = work.row.simulated;
    if (known != nullptr && isResumed) {
        now.at = known->at;
        now.isIdSent = now.isIdSent || known->isIdSent;
        now.isIdConfirmed =
            known->isIdConfirmed || (isAtNewId && !hasOpenIntent(m_context, *known));
    }
    if (known != nullptr)
        *known = now; // another servo that never got the ID: it begins anew when it comes back
    else
        m_batch.pending.push_back(now);
    return save();
}

void CommissionProgress::removePending(const CommissionWork& work)
{
    const PendingCommission* one = pendingOf(work);
    if (one != nullptr && !hasOpenIntent(m_context, *one))
        m_batch.pending.erase(m_batch.pending.begin() + (one - m_batch.pending.data()));
}

base::Result<void> CommissionProgress::addRow(const CommissionWork& work,
                                              const results::CommissionRow& row)
{
    m_batch.rows.push_back(row);
    m_batch.attachedServo = {base::protocolName(work.servo.protocol), work.servo.id,
                             work.servo.baud};
    return save();
}

base::Result<void> CommissionProgress::setUnplugged()
{
    if (!m_batch.attachedServo)
        return {};
    m_batch.attachedServo.reset();
    return save();
}
} // namespace jobs
