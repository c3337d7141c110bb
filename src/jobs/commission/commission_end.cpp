// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a servo on the line: its row, its name in the history.
#include "jobs/commission/commission_recovery.h"
#include "jobs/commission/commission_runner.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using record::CommissionIssue;
using record::CommissionVerdict;
using record::PendingCommission;

namespace {
/// So often a servo whose change is still open is waited for again; then its row says "failed".
constexpr int maxReidentifications = 2;

bool endsBatch(ErrorCode code)
{
    switch (code) {
    case ErrorCode::LinkLost:
    case ErrorCode::Stopped:
    case ErrorCode::Preempted:
    case ErrorCode::Held:
    case ErrorCode::FileUnwritable:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileFormat:
    case ErrorCode::DiskFull:
        return true;
    default:
        return false;
    }
}

CommissionIssue issueOf(const base::Error& error)
{
    return {base::errorName(error.code),
            error.registerKey.isEmpty() ? error.detail : error.registerKey};
}
} // namespace

/// Is it the very servo? Then what was begun on it is brought to one side.
base::Result<CommissionRunner::SameServoCheck>
CommissionRunner::verifySameServo(CommissionWork& work, const PendingCommission& begun)
{
    if (m_context.bus.canSetBaud() && m_context.bus.baud() != work.servo.baud) {
        if (const auto set = m_context.bus.setBaud(work.servo.baud); !set)
            return tl::unexpected(set.error());
    }
    if (!hasLeftLockOpen(m_context, work.servo, begun))
        return SameServoCheck::NotVerified;
    const auto recovered = recoverOpenIntents(m_context, begun);
    if (!recovered && endsBatch(recovered.error().code))
        return tl::unexpected(recovered.error());
    const bool over = recovered.has_value() && !hasOpenIntent(m_context, begun);
    return over ? SameServoCheck::Resolved : SameServoCheck::Unresolved;
}

/// Its lock may be open by now: the batch says so.
base::Result<void> CommissionRunner::markLost()
{
    m_lost = true;
    return saveBatch();
}

/// Ends the line, or waits for a servo that has gone away, or sets its failure down.
base::Result<void> CommissionRunner::handleFailure(CommissionWork& work, const base::Error& error)
{
    if (endsBatch(error.code))
        return tl::unexpected(error);
    const base::Protocol language = work.servo.protocol;
    std::optional<BusLocation> foundLocation;
    for (const int baud : {work.servo.baud, work.newBaud, work.row.oldBaud}) {
        for (const int id : {work.servo.id, work.newId, work.row.servo.id}) {
            if (foundLocation || id < 0)
                continue;
            const auto isPresent = m_detector.isPresent({language, id, baud});
            if (!isPresent)
                return tl::unexpected(isPresent.error());
            if (*isPresent)
                foundLocation = BusLocation{language, id, baud};
        }
    }
    PendingCommission* one = pendingOf(work);
    if (!foundLocation)
        return one != nullptr ? markLost() : base::Result<void>();
    if (one != nullptr && one->isIdConfirmed && foundLocation->id != work.newId)
        return markLost(); // another servo has taken its place
    work.servo.id = foundLocation->id;
    work.servo.baud = foundLocation->baud;
    if (one != nullptr && hasOpenIntent(m_context, *one)) {
        const auto known = verifySameServo(work, *one);
        if (!known)
            return tl::unexpected(known.error());
        // It may have been swapped for another one, so it is identified again.
        if (*known == SameServoCheck::NotVerified &&
            ++m_reidentifications[work.newId] <= maxReidentifications)
            return markLost();
    }
    if (one != nullptr && foundLocation->id != work.newId && one->isIdSent &&
        !hasOpenIntent(m_context, *one)) {
        one->isIdSent = false; // it is proven to answer as before: no servo has the new ID
        if (const auto saveResult = saveBatch(); !saveResult)
            return saveResult;
    }
    work.row.issues.push_back(issueOf(error));
    work.row.verdict = CommissionVerdict::Failed;
    return finish(work);
}

QString CommissionRunner::labelOf(const CommissionWork& work) const
{
    record::CommissionRow row = work.row;
    row.newId = work.newId;
    row.newBaud = row.newBaud > 0 ? row.newBaud : work.newBaud;
    return record::commissionLabel(m_spec.labelFormat, row).trimmed();
}

base::Result<void> CommissionRunner::saveName(CommissionWork& work, const QString& label)
{
    if (!m_callbacks.name || label.isEmpty() || label == work.savedLabel)
        return {};
    const bool another = work.row.servo.id != work.newId || work.newId == factoryId;
    const auto named = m_callbacks.name(work.servo, label, another);
    if (named)
        work.savedLabel = label;
    return named;
}

base::Result<void> CommissionRunner::finish(CommissionWork& work)
{
    record::CommissionRow& row = work.row;
    if (work.servo.id == work.newId) {
        row.newId = work.newId;
        row.newBaud = work.servo.baud;
    }
    row.label = row.newId < 0 ? QString() : labelOf(work);
    if (const auto named = saveName(work, row.label); !named)
        row.issues.push_back({QStringLiteral("label-not-kept"), issueOf(named.error()).word});
    const bool alarmed = std::any_of(row.issues.begin(), row.issues.end(), [](const auto& one) {
        return one.word == QLatin1String("alarm");
    });
    if (row.verdict == CommissionVerdict::Good && !row.issues.empty())
        row.verdict = alarmed ? CommissionVerdict::Failed : CommissionVerdict::Remark;
    // What the journal still holds open is not over with this row: it stays unfinished.
    const PendingCommission* one = pendingOf(work);
    if (one != nullptr && !hasOpenIntent(m_context, *one))
        m_batch.pending.erase(m_batch.pending.begin() + (one - m_batch.pending.data()));
    CommissionView view;
    view.baud = work.servo.baud;
    view.newId = row.newId;
    view.newBaud = row.newBaud;
    view.snapshot = row.snapshot;
    return recordRow(work, row, view);
}

/// On the disk before anybody is told of it.
base::Result<void> CommissionRunner::recordRow(const CommissionWork& work,
                                               const record::CommissionRow& row,
                                               CommissionView view)
{
    m_batch.rows.push_back(row);
    m_batch.attachedServo = {base::protocolName(work.servo.protocol), work.servo.id,
                             work.servo.baud};
    if (const auto saveResult = saveBatch(); !saveResult)
        return saveResult;
    if (m_callbacks.onRow)
        m_callbacks.onRow(row);
    view.servo = row.servo;
    view.issues = row.issues;
    return waitForUnplug(locationOf(work.servo), view);
}
} // namespace jobs
