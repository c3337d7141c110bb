// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_runner.h"

#include "jobs/commission/commission_recovery.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using record::PendingCommission;

namespace {
constexpr base::Duration roundPause = std::chrono::milliseconds(20);
constexpr base::Duration blockedPause = std::chrono::milliseconds(250);
} // namespace

base::Result<CommissionEnd> CommissionRunner::run()
{
    if (m_batch.attachedServo) {
        CommissionView view;
        view.step = CommissionStep::Unplug;
        view.newId = m_batch.attachedServo->id;
        view.newBaud = m_batch.attachedServo->baud;
        if (const auto gone = waitForUnplug(locationOf(*m_batch.attachedServo), view); !gone)
            return tl::unexpected(gone.error());
    }
    for (;;) {
        if (m_spec.count > 0 && m_batch.done() >= m_spec.count)
            return CommissionEnd::CountReached;
        if (!nextId() && m_batch.pending.empty())
            return CommissionEnd::IdsExhausted;
        auto servo = waitForServo();
        if (!servo)
            return tl::unexpected(servo.error());
        if (const auto processed = processServo(std::move(*servo)); !processed)
            return tl::unexpected(processed.error());
    }
}

CommissionRunner::BusLocation CommissionRunner::locationOf(const record::ServoLocation& kept)
{
    return {base::protocolFromName(kept.protocol).value_or(base::Protocol::Feetech), kept.id,
            kept.baud};
}

CommissionRunner::BusLocation CommissionRunner::locationOf(const device::Servo& servo)
{
    return {servo.protocol, servo.id, servo.baud};
}

std::optional<int> CommissionRunner::nextId() const
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

void CommissionRunner::show(const CommissionView& view)
{
    if (m_view == view)
        return;
    m_view = view;
    if (m_callbacks.onChange)
        m_callbacks.onChange(view);
}

base::Result<void> CommissionRunner::pause(base::Duration span)
{
    if (m_context.bus.pauseUntil(m_context.bus.clock().now() + span, &m_context.stop) &&
        !m_context.stop.isRequested())
        return {};
    return base::fail(ErrorCode::Stopped, QStringLiteral("commission"));
}

base::Result<void> CommissionRunner::saveBatch()
{
    updateLockStates(m_context, m_batch.pending);
    auto saved = record::saveCommissionBatch(m_batch, m_csvPath);
    if (saved && m_callbacks.onBatch)
        m_callbacks.onBatch();
    return saved;
}

CommissionView CommissionRunner::waitingView() const
{
    CommissionView view;
    view.newId = nextId().value_or(-1);
    view.newBaud = m_spec.baud;
    if (m_lost && !m_batch.pending.empty()) {
        view.obstacle = CommissionObstacle::Lost;
        view.servo = m_batch.pending.back().servo;
        view.newId = m_batch.pending.back().newId;
        view.issues = record::unfinishedIssues(m_batch.pending.back());
    }
    return view;
}

/// Where a servo that was left in the middle may answer.
std::vector<CommissionDetector::BusLocation> CommissionRunner::expectedLocations() const
{
    std::vector<BusLocation> places;
    for (const PendingCommission& one : m_batch.pending) {
        const auto protocol =
            base::protocolFromName(one.servo.protocol).value_or(base::Protocol::Feetech);
        if (!one.isIdSent)
            continue; // at its old place it is found like any other
        places.push_back({protocol, one.newId, one.newBaud});
        if (one.oldBaud != one.newBaud)
            places.push_back({protocol, one.newId, one.oldBaud});
    }
    return places;
}

/// One servo, by itself, that says who it is; `servo` is it. Else the obstacle is shown.
base::Result<bool> CommissionRunner::isAlone(const BusLocation& first, device::Servo& servo)
{
    const auto found = m_detector.findAll(first);
    if (!found)
        return tl::unexpected(found.error());
    if (found->empty())
        return false;
    CommissionView blocked;
    blocked.step = CommissionStep::Blocked;
    for (const FoundServo& one : *found)
        blocked.detected.push_back(
            {one.servo.profile ? one.servo.profile->modelName : QString(),
             {base::protocolName(one.servo.protocol), one.servo.id, one.servo.baud}});
    servo = found->front().servo;
    if (m_context.bus.canSetBaud() && m_context.bus.baud() != servo.baud) {
        if (const auto set = m_context.bus.setBaud(servo.baud); !set)
            return tl::unexpected(set.error());
    }
    bool hasDuplicateId = found->front().duplicateSuspected;
    if (found->size() == 1 && !hasDuplicateId && servo.profile) {
        const auto suspected = m_detector.hasDuplicateId(servo);
        if (!suspected)
            return tl::unexpected(suspected.error());
        hasDuplicateId = *suspected;
    }
    if (found->size() > 1)
        blocked.obstacle = CommissionObstacle::DuplicateId;
    else if (hasDuplicateId)
        blocked.obstacle = CommissionObstacle::DuplicateIds;
    else if (!servo.profile)
        blocked.obstacle = CommissionObstacle::Unreadable;
    else
        return true;
    show(blocked);
    return false;
}

base::Result<device::Servo> CommissionRunner::waitForServo()
{
    show(waitingView());
    for (;;) {
        const auto heard = m_detector.scanRound(expectedLocations());
        if (!heard)
            return tl::unexpected(heard.error());
        base::Duration span = roundPause;
        if (!*heard) {
            show(waitingView());
        } else {
            if (m_view->step != CommissionStep::Blocked) {
                CommissionView checking = waitingView();
                checking.step = CommissionStep::Checking;
                show(checking);
            }
            device::Servo servo;
            const auto ready = isAlone(**heard, servo);
            if (!ready)
                return tl::unexpected(ready.error());
            if (*ready)
                return servo;
            span = blockedPause;
        }
        if (const auto paused = pause(span); !paused)
            return tl::unexpected(paused.error());
    }
}

base::Result<void> CommissionRunner::waitForUnplug(const BusLocation& place, CommissionView view)
{
    view.step = CommissionStep::Unplug;
    show(view);
    for (int missedPings = 0; missedPings < missedPingsUntilGone;) {
        const auto stillPresent = m_detector.isPresent(place);
        if (!stillPresent)
            return tl::unexpected(stillPresent.error());
        missedPings = *stillPresent ? 0 : missedPings + 1;
        if (const auto paused = pause(pollPause); !paused)
            return paused;
    }
    if (!m_batch.attachedServo)
        return {};
    m_batch.attachedServo.reset();
    return saveBatch();
}
} // namespace jobs
