// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/reader.h"
#include "device/write_access.h"
#include "jobs/commission/commission_recovery.h"
#include "jobs/commission/commission_runner.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using record::CommissionIssue;
using record::CommissionVerdict;
using record::PendingCommission;

namespace {
const QString commissionSetupOperation = QStringLiteral("commission");

/// What is kept in them tells two of a kind apart, as far as anything does.
bool sameSettings(const device::Servo& one, const device::Servo& other)
{
    return std::none_of(one.profile->registers.begin(), one.profile->registers.end(),
                        [&](const catalog::Register& reg) {
                            const auto before = one.raw(reg);
                            const auto now = other.raw(reg);
                            return reg.area == catalog::Area::Eprom && before && now &&
                                   *before != *now;
                        });
}
} // namespace

PendingCommission* CommissionRunner::findPending(int newId, const QString& protocol)
{
    for (PendingCommission& one : m_batch.pending) {
        if (one.newId == newId && one.servo.protocol == protocol)
            return &one;
    }
    return nullptr;
}

PendingCommission* CommissionRunner::pendingOf(const CommissionWork& work)
{
    return findPending(work.newId, work.row.servo.protocol);
}

/// Is it one that was left in the middle? Then it goes on with what it was to get. At its old place
/// it may as well be another one of the kind, if the new ID may have been written already or a
/// write to it has not ended, unless its lock still stands open. Once the new ID was read back it
/// certainly is another one.
bool CommissionRunner::matchPending(CommissionWork& work, CommissionView& view)
{
    const record::SnapshotServo identity = snapshotServo(work.servo);
    for (const PendingCommission& one : m_batch.pending) {
        const bool isSameKind = one.servo.protocol == identity.protocol &&
                                one.servo.modelId == identity.modelId &&
                                one.servo.firmware == identity.firmware;
        const bool atNew = one.isIdSent && identity.id == one.newId;
        const bool isAtOldId = identity.id == one.servo.id && !one.isIdConfirmed;
        const bool rate = work.servo.baud == one.oldBaud || work.servo.baud == one.newBaud;
        if (!isSameKind || !rate || !(atNew || isAtOldId))
            continue;
        work.isVerified = hasLeftLockOpen(m_context, work.servo, one);
        const bool begun = one.isIdSent || hasOpenIntent(m_context, one);
        if (!atNew && begun && !work.isVerified) {
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

/// Beside the question whether it is the one that was begun: what is known of that one.
void CommissionRunner::addUnfinishedIssues(const CommissionWork& work, CommissionView& view)
{
    const int newId = view.candidateId >= 0 ? view.candidateId : work.newId;
    const PendingCommission* one = findPending(newId, work.row.servo.protocol);
    if (one == nullptr)
        return;
    for (const CommissionIssue& issue : record::unfinishedIssues(*one))
        view.issues.push_back(issue);
}

base::Result<void> CommissionRunner::processServo(device::Servo servo)
{
    m_lost = false;
    CommissionView view;
    view.step = CommissionStep::Checking;
    CommissionWork work;
    work.servo = std::move(servo);
    work.row.at = QDateTime::fromSecsSinceEpoch(QDateTime::currentSecsSinceEpoch(), Qt::UTC);
    work.row.servo = snapshotServo(work.servo);
    work.row.oldBaud = work.servo.baud;
    work.newId = nextId().value_or(-1);
    work.newBaud = m_spec.baud > 0 ? m_spec.baud : work.servo.baud;
    view.isResumed = matchPending(work, view);
    if (work.newId < 0)
        work.newId = view.candidateId; // there is no ID for another one
    view.servo = snapshotServo(work.servo);
    view.baud = work.servo.baud;
    const int id = work.servo.id;
    if (!view.isResumed && id != factoryId && m_batch.isIdTaken(id)) {
        view.newId = id;
        view.newBaud = view.baud;
        view.issues = {{QStringLiteral("already-done")}};
        return waitForUnplug(locationOf(work.servo), view);
    }
    auto issues = checkServo(m_context, m_spec, work);
    if (!issues)
        return handleFailure(work, issues.error());
    if (!view.isResumed && id != factoryId)
        issues->push_back({QStringLiteral("other-id"), QString::number(id)});
    if (work.newId < 0)
        return skip(work, {{QStringLiteral("no-id-left")}});
    const auto agreed = decide(work, view, *issues);
    if (!agreed || !*agreed)
        return agreed ? base::Result<void>() : tl::unexpected(agreed.error());
    work.row.issues = *issues;
    view.newId = work.newId;
    view.isResumed = view.isResumed || work.newId == view.candidateId;
    if (const auto done = setUp(work, view); !done)
        return handleFailure(work, done.error());
    return finish(work);
}

/// As confirm(). Without a click where nothing speaks against it; but whatever answers after a
/// silence may be another servo, and that is for the user to say.
base::Result<bool> CommissionRunner::decide(CommissionWork& work, CommissionView& view,
                                            std::vector<CommissionIssue>& issues)
{
    view.newId = work.newId;
    view.newBaud = work.newBaud;
    view.issues = issues;
    const bool unclear = view.candidateId >= 0 || (view.isResumed && !work.isVerified);
    if (unclear)
        addUnfinishedIssues(work, view);
    show(view);
    if (!m_spec.automatic || unclear)
        return confirm(work, view, issues);
    if (std::none_of(issues.begin(), issues.end(), needsDecision))
        return true;
    const auto skipped = skip(work, issues);
    return skipped ? base::Result<bool>(false) : tl::unexpected(skipped.error());
}

/// False: it is not to be set up now, and whatever is to be done about that has been done.
base::Result<bool> CommissionRunner::confirm(CommissionWork& work, CommissionView view,
                                             std::vector<CommissionIssue>& issues)
{
    view.step = CommissionStep::Confirm;
    show(view);
    int missedPings = 0;
    for (;;) {
        CommissionAnswer answer =
            m_callbacks.answer ? m_callbacks.answer() : CommissionAnswer::None;
        if (answer == CommissionAnswer::Continue && view.candidateId == work.newId)
            answer = CommissionAnswer::None; // there is no ID for another one
        if (answer == CommissionAnswer::Skip) {
            const auto skipped = skip(work, issues);
            return skipped ? base::Result<bool>(false) : tl::unexpected(skipped.error());
        }
        if (answer == CommissionAnswer::SameServo && view.candidateId >= 0)
            work.newId = view.candidateId;
        if (answer != CommissionAnswer::None)
            return isStillAlone(work);
        const auto stillPresent = m_detector.isPresent(locationOf(work.servo));
        if (!stillPresent)
            return tl::unexpected(stillPresent.error());
        missedPings = *stillPresent ? 0 : missedPings + 1;
        if (missedPings >= missedPingsUntilGone)
            return false;
        if (const auto paused = pause(pollPause); !paused)
            return tl::unexpected(paused.error());
    }
}

/// Between the check and the click another servo may have been plugged in, or swapped for it.
base::Result<bool> CommissionRunner::isStillAlone(CommissionWork& work)
{
    CommissionView checking = *m_view;
    checking.step = CommissionStep::Checking;
    show(checking);
    device::Servo now;
    const auto ready = isAlone(locationOf(work.servo), now);
    if (!ready || !*ready || now.id != work.servo.id || now.baud != work.servo.baud ||
        !now.identity().isSameKind(work.servo.identity()))
        return ready ? base::Result<bool>(false) : ready;
    if (const auto read = device::readAll(m_context, now); !read)
        return read.error().code == ErrorCode::NoReply
                   ? base::Result<bool>(false)
                   : base::Result<bool>(tl::unexpected(read.error()));
    return sameSettings(work.servo, now);
}

base::Result<void> CommissionRunner::skip(const CommissionWork& work,
                                          const std::vector<CommissionIssue>& why)
{
    record::CommissionRow row = work.row;
    row.servo = snapshotServo(work.servo);
    row.verdict = CommissionVerdict::Skipped;
    row.issues = why;
    if (why.empty())
        row.issues = {{QStringLiteral("by-hand")}};
    row.volts = work.servo.physical(catalog::Role::PresentVoltage);
    row.celsius = work.servo.physical(catalog::Role::PresentTemperature);
    CommissionView view;
    view.baud = row.oldBaud;
    return recordRow(work, row, view);
}

/// From here on the servo is in the batch's file, so that it is known wherever it is left.
base::Result<void> CommissionRunner::begin(CommissionWork& work, CommissionView& view)
{
    if (view.isResumed) {
        if (work.servo.id == work.newId)
            (void)saveName(work, labelOf(work)); // before anything more is written to it
        if (const PendingCommission* one = pendingOf(work)) {
            if (const auto recovered = recoverOpenIntents(m_context, *one); !recovered)
                return recovered;
        }
        const auto issues = checkServo(m_context, m_spec, work);
        if (!issues)
            return tl::unexpected(issues.error());
    }
    const PendingCommission* known = pendingOf(work);
    const QString first = known != nullptr && view.isResumed ? known->snapshot : QString();
    if (hasWork(work)) {
        const auto may = device::beginWriting(m_context, work.servo, commissionSetupOperation);
        if (!may)
            return may;
        view.step = CommissionStep::Snapshot;
        show(view);
        if (!view.isResumed && work.servo.id == factoryId && m_callbacks.onNewServo)
            (void)m_callbacks.onNewServo(
                work.servo); // a history that cannot be used refuses the write itself
        if (const auto saved = saveTable(m_context, m_callbacks, work); !saved)
            return saved;
    }
    if (!first.isEmpty())
        work.row.snapshot = first; // as it was when it came, not when it was left in the middle
    view.snapshot = work.row.snapshot;
    return hasWork(work) ? addPending(work, view) : base::Result<void>();
}

/// Into the batch's file.
base::Result<void> CommissionRunner::addPending(const CommissionWork& work,
                                                const CommissionView& view)
{
    PendingCommission* known = pendingOf(work);
    const bool atNew = work.servo.id == work.newId;
    PendingCommission now{QDateTime::currentDateTimeUtc(),
                          work.row.servo,
                          work.row.oldBaud,
                          work.newId,
                          work.newBaud,
                          atNew,
                          work.row.snapshot};
    if (known != nullptr && view.isResumed) {
        now.at = known->at;
        now.isIdSent = now.isIdSent || known->isIdSent;
        now.isIdConfirmed = known->isIdConfirmed || (atNew && !hasOpenIntent(m_context, *known));
    }
    if (known != nullptr)
        *known = now; // of another one that never got the ID: it begins anew when it comes back
    else
        m_batch.pending.push_back(now);
    return saveBatch();
}

base::Result<void> CommissionRunner::assignId(CommissionWork& work)
{
    if (work.servo.id == work.newId)
        return {};
    PendingCommission* one = pendingOf(work);
    if (!one->isIdSent) {
        one->isIdSent = true;
        if (const auto saveResult = saveBatch(); !saveResult)
            return saveResult;
    }
    const auto given = changeServoId(m_context, work);
    if (work.isIdConfirmed) {
        one->isIdConfirmed = true;
        if (const auto saveResult = saveBatch(); !saveResult)
            return saveResult;
    }
    return given;
}

/// As early as it has its ID, so that what is written from now on is its own in the history.
base::Result<void> CommissionRunner::assignIdAndName(CommissionWork& work)
{
    return assignId(work).map(
        [&] { (void)saveName(work, labelOf(work)); }); // tried again at the end
}

base::Result<void> CommissionRunner::setUp(CommissionWork& work, CommissionView& view)
{
    const auto step = [&](CommissionStep now, auto&& action) -> base::Result<void> {
        if (m_context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, commissionSetupOperation, {}, work.servo.id);
        view.step = now;
        view.baud = work.servo.baud;
        show(view);
        return action();
    };
    return begin(work, view)
        .and_then([&] {
            return step(CommissionStep::Template,
                        [&] { return applyTemplate(m_context, m_spec, work); });
        })
        .and_then([&] { return step(CommissionStep::Id, [&] { return assignIdAndName(work); }); })
        .and_then([&] {
            return step(CommissionStep::Rate, [&] { return changeServoRate(m_context, work); });
        })
        .and_then([&] {
            return step(CommissionStep::Center, [&] { return centerServo(m_context, work); });
        })
        .and_then([&] {
            return step(CommissionStep::Health, [&] { return checkHealth(m_context, work); });
        });
}
} // namespace jobs
