// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_runner.h"

#include "jobs/commission/commission_recovery.h"
#include "jobs/restore/take_snapshot.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using results::CommissionIssue;
using results::CommissionVerdict;
using results::PendingCommission;

namespace {
/// How often a servo with an open change is waited for again before its row says "failed".
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

CommissionVerdict verdictOf(const results::CommissionRow& row)
{
    if (row.verdict != CommissionVerdict::Good || row.issues.empty())
        return row.verdict;
    const bool alarmed = std::any_of(row.issues.begin(), row.issues.end(), [](const auto& one) {
        return one.word == QLatin1String("alarm");
    });
    return alarmed ? CommissionVerdict::Failed : CommissionVerdict::Remark;
}
} // namespace

base::Result<CommissionEnd> CommissionRunner::run()
{
    const results::CommissionBatch& batch = m_progress.batch();
    if (batch.attachedServo) {
        CommissionView view;
        view.newId = batch.attachedServo->id;
        view.newBaud = batch.attachedServo->baud;
        const auto gone = waitForUnplug(CommissionProgress::locationOf(*batch.attachedServo), view);
        if (!gone)
            return tl::unexpected(gone.error());
    }
    for (;;) {
        if (m_spec.count > 0 && batch.done() >= m_spec.count)
            return CommissionEnd::CountReached;
        if (!m_progress.nextId() && batch.pending.empty())
            return CommissionEnd::IdsExhausted;
        auto servo = m_presence.waitForServo();
        if (!servo)
            return tl::unexpected(servo.error());
        if (const auto processed = processServo(std::move(*servo)); !processed)
            return tl::unexpected(processed.error());
    }
}

base::Result<void> CommissionRunner::processServo(device::Servo servo)
{
    m_progress.setLost(false);
    const int id = servo.id;
    CommissionView view;
    view.step = CommissionStep::Checking;
    view.servo = snapshotServo(servo);
    view.baud = servo.baud;
    CommissionWork work;
    work.servo = std::move(servo);
    work.row.at = QDateTime::fromSecsSinceEpoch(QDateTime::currentSecsSinceEpoch(), Qt::UTC);
    work.row.servo = view.servo;
    work.row.simulated = work.servo.identity().isSimulated();
    work.row.oldBaud = view.baud;
    work.newId = m_progress.nextId().value_or(-1);
    work.newBaud = m_spec.baud > 0 ? m_spec.baud : view.baud;
    view.isResumed = m_progress.matchPending(work, view);
    if (work.newId < 0)
        work.newId = view.candidateId; // no ID is left for another servo
    if (!view.isResumed && id != factoryId && m_progress.batch().isIdTaken(id)) {
        view.newId = id;
        view.newBaud = view.baud;
        view.issues = {{QStringLiteral("already-done")}};
        return waitForUnplug(CommissionProgress::locationOf(work.servo), view);
    }
    auto issues = checkServo(m_context, m_spec, work);
    if (!issues)
        return handleFailure(work, issues.error());
    if (!view.isResumed && id != factoryId)
        issues->push_back({QStringLiteral("other-id"), QString::number(id)});
    if (work.newId < 0)
        return skip(work, {{QStringLiteral("no-id-left")}}).map([](bool) {});
    const auto agreed = decide(work, view, *issues);
    if (!agreed || !*agreed)
        return agreed ? base::Result<void>() : tl::unexpected(agreed.error());
    work.row.issues = *issues;
    view.newId = work.newId;
    view.isResumed = view.isResumed || work.newId == view.candidateId;
    if (const auto done = m_setup.run(work, view); !done)
        return handleFailure(work, done.error());
    return finish(work);
}

/// Beside the question whether it is the unfinished servo: what is known of that one.
void CommissionRunner::addUnfinishedIssues(const CommissionWork& work, CommissionView& view)
{
    const int newId = view.candidateId >= 0 ? view.candidateId : work.newId;
    const PendingCommission* one = m_progress.findPending(newId, work.row.servo.protocol);
    if (one == nullptr)
        return;
    for (const CommissionIssue& issue : results::unfinishedIssues(*one))
        view.issues.push_back(issue);
}

/// An automatic line needs no click for a servo without issues; but a servo that replies after a
/// silence may be another one, which only the user can tell.
base::Result<bool> CommissionRunner::decide(CommissionWork& work, CommissionView& view,
                                            const Issues& issues)
{
    view.newId = work.newId;
    view.newBaud = work.newBaud;
    view.issues = issues;
    const bool unclear = view.candidateId >= 0 || (view.isResumed && !work.isVerified);
    if (unclear)
        addUnfinishedIssues(work, view);
    m_display.show(view);
    if (!m_spec.automatic || unclear)
        return confirm(work, view, issues);
    if (std::none_of(issues.begin(), issues.end(), needsDecision))
        return true;
    return skip(work, issues);
}

base::Result<bool> CommissionRunner::confirm(CommissionWork& work, CommissionView view,
                                             const Issues& issues)
{
    view.step = CommissionStep::Confirm;
    m_display.show(view);
    for (int missed = 0;;) {
        CommissionAnswer answer =
            m_callbacks.answer ? m_callbacks.answer() : CommissionAnswer::None;
        if (answer == CommissionAnswer::Continue && view.candidateId == work.newId)
            answer = CommissionAnswer::None; // no ID is left for another servo
        if (answer == CommissionAnswer::Skip)
            return skip(work, issues);
        if (answer == CommissionAnswer::SameServo && view.candidateId >= 0)
            work.newId = view.candidateId;
        if (answer != CommissionAnswer::None)
            return m_presence.isStillAlone(work.servo);
        const auto gone = m_presence.isGone(CommissionProgress::locationOf(work.servo), missed);
        if (!gone)
            return tl::unexpected(gone.error());
        if (*gone)
            return false;
    }
}

base::Result<bool> CommissionRunner::skip(const CommissionWork& work, const Issues& issues)
{
    results::CommissionRow row = work.row;
    row.servo = snapshotServo(work.servo);
    row.verdict = CommissionVerdict::Skipped;
    row.issues = issues;
    if (issues.empty())
        row.issues = {{QStringLiteral("by-hand")}};
    row.volts = work.servo.physical(catalog::Role::PresentVoltage);
    row.celsius = work.servo.physical(catalog::Role::PresentTemperature);
    CommissionView view;
    view.baud = row.oldBaud;
    return recordRow(work, row, view).map([] { return false; });
}

/// Ends the line, waits for a servo that was disconnected, or records its failure.
base::Result<void> CommissionRunner::handleFailure(CommissionWork& work, const base::Error& error)
{
    if (endsBatch(error.code))
        return tl::unexpected(error);
    const auto place = m_presence.findAgain(work);
    if (!place)
        return tl::unexpected(place.error());
    PendingCommission* one = m_progress.pendingOf(work);
    if (!*place)
        return one != nullptr ? markLost() : base::Result<void>();
    const int foundId = (*place)->id;
    if (one != nullptr && one->isIdConfirmed && foundId != work.newId)
        return markLost(); // another servo has taken its place
    work.servo.id = foundId;
    work.servo.baud = (*place)->baud;
    if (one != nullptr && hasOpenIntent(m_context, *one)) {
        const auto known = verifySameServo(work, *one);
        if (!known)
            return tl::unexpected(known.error());
        // It may have been swapped for another one, so it is identified again.
        if (*known == SameServoCheck::NotVerified &&
            ++m_reidentifications[work.newId] <= maxReidentifications)
            return markLost();
    }
    if (one != nullptr && foundId != work.newId && one->isIdSent &&
        !hasOpenIntent(m_context, *one)) {
        one->isIdSent = false; // it replies under its old ID: no servo has the new one
        if (const auto saved = m_progress.save(); !saved)
            return saved;
    }
    work.row.issues.push_back(issueOf(error));
    work.row.verdict = CommissionVerdict::Failed;
    return finish(work);
}

/// Ends what was begun, if it is the same servo.
base::Result<CommissionRunner::SameServoCheck>
CommissionRunner::verifySameServo(CommissionWork& work, const PendingCommission& pending)
{
    if (const auto set = m_presence.setRate(work.servo.baud); !set)
        return tl::unexpected(set.error());
    if (!hasLeftLockOpen(m_context, work.servo, pending))
        return SameServoCheck::NotVerified;
    const auto recovered = recoverOpenIntents(m_context, pending);
    if (!recovered && endsBatch(recovered.error().code))
        return tl::unexpected(recovered.error());
    return recovered && !hasOpenIntent(m_context, pending) ? SameServoCheck::Resolved
                                                           : SameServoCheck::Unresolved;
}

/// Saved at once: the lock of the servo may be open by now, which the batch records.
base::Result<void> CommissionRunner::markLost()
{
    m_progress.setLost(true);
    return m_progress.save();
}

base::Result<void> CommissionRunner::finish(CommissionWork& work)
{
    results::CommissionRow& row = work.row;
    if (work.servo.id == work.newId) {
        row.newId = work.newId;
        row.newBaud = work.servo.baud;
    }
    row.label = row.newId < 0 ? QString() : m_setup.labelOf(work);
    if (const auto named = m_setup.saveName(work, row.label); !named)
        row.issues.push_back({QStringLiteral("label-not-kept"), issueOf(named.error()).word});
    row.verdict = verdictOf(row);
    m_progress.removePending(work);
    CommissionView view;
    view.baud = work.servo.baud;
    view.newId = row.newId;
    view.newBaud = row.newBaud;
    view.snapshot = row.snapshot;
    return recordRow(work, row, view);
}

/// The row is on the disk before it is reported.
base::Result<void> CommissionRunner::recordRow(const CommissionWork& work,
                                               const results::CommissionRow& row,
                                               CommissionView view)
{
    if (const auto saved = m_progress.addRow(work, row); !saved)
        return saved;
    if (m_callbacks.onRow)
        m_callbacks.onRow(row);
    view.servo = row.servo;
    view.issues = row.issues;
    return waitForUnplug(CommissionProgress::locationOf(work.servo), view);
}

base::Result<void> CommissionRunner::waitForUnplug(const BusLocation& place, CommissionView view)
{
    view.step = CommissionStep::Unplug;
    m_display.show(view);
    return m_presence.waitUntilGone(place).and_then([&] { return m_progress.setUnplugged(); });
}
} // namespace jobs
