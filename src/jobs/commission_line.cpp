// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission_line.h"

#include "jobs/commission_settle.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using record::CommissionPending;

namespace {
constexpr base::Duration roundPause = std::chrono::milliseconds(20);
constexpr base::Duration blockedPause = std::chrono::milliseconds(250);
} // namespace

base::Result<CommissionEnd> CommissionLine::run()
{
    if (m_batch.onWire) {
        CommissionView view;
        view.step = CommissionStep::Unplug;
        view.newId = m_batch.onWire->id;
        view.newBaud = m_batch.onWire->baud;
        if (const auto gone = awaitGone(placeOf(*m_batch.onWire), view); !gone)
            return tl::unexpected(gone.error());
    }
    for (;;) {
        if (m_spec.count > 0 && m_batch.done() >= m_spec.count)
            return CommissionEnd::CountReached;
        if (!nextId() && m_batch.pending.empty())
            return CommissionEnd::IdsUsedUp;
        auto servo = awaitServo();
        if (!servo)
            return tl::unexpected(servo.error());
        if (const auto dealt = deal(std::move(*servo)); !dealt)
            return tl::unexpected(dealt.error());
    }
}

CommissionLine::Place CommissionLine::placeOf(const record::CommissionPlace& kept)
{
    return {base::protocolFromName(kept.protocol).value_or(base::Protocol::Feetech), kept.id,
            kept.baud};
}

CommissionLine::Place CommissionLine::placeOf(const device::Servo& servo)
{
    return {servo.protocol, servo.id, servo.baud};
}

std::optional<int> CommissionLine::nextId() const
{
    const auto taken = [this](int id) {
        return m_batch.idTaken(id) ||
               std::any_of(m_batch.pending.begin(), m_batch.pending.end(), [&](const auto& one) {
                   return one.newId == id && owesChange(m_context, one);
               });
    };
    const auto next = std::find_if_not(m_spec.ids.begin(), m_spec.ids.end(), taken);
    return next == m_spec.ids.end() ? std::nullopt : std::optional(*next);
}

void CommissionLine::show(const CommissionView& view)
{
    if (m_view == view)
        return;
    m_view = view;
    if (m_hooks.onChange)
        m_hooks.onChange(view);
}

base::Result<void> CommissionLine::pause(base::Duration span)
{
    if (m_context.bus.pauseUntil(m_context.bus.clock().now() + span, &m_context.stop) &&
        !m_context.stop.requested())
        return {};
    return base::fail(ErrorCode::Stopped, QStringLiteral("commission"));
}

base::Result<void> CommissionLine::keep()
{
    updateLocks(m_context, m_batch.pending);
    auto saved = record::saveCommissionBatch(m_batch, m_csvPath);
    if (saved && m_hooks.onBatch)
        m_hooks.onBatch();
    return saved;
}

CommissionView CommissionLine::waitingView() const
{
    CommissionView view;
    view.newId = nextId().value_or(-1);
    view.newBaud = m_spec.baud;
    if (m_lost && !m_batch.pending.empty()) {
        view.obstacle = CommissionObstacle::Lost;
        view.servo = m_batch.pending.back().servo;
        view.newId = m_batch.pending.back().newId;
        view.concerns = record::unfinishedTroubles(m_batch.pending.back());
    }
    return view;
}

/// Where a servo that was left in the middle may answer.
std::vector<CommissionLook::Place> CommissionLine::expected() const
{
    std::vector<Place> places;
    for (const CommissionPending& one : m_batch.pending) {
        const auto protocol =
            base::protocolFromName(one.servo.protocol).value_or(base::Protocol::Feetech);
        if (!one.idSent)
            continue; // at its old place it is found like any other
        places.push_back({protocol, one.newId, one.newBaud});
        if (one.oldBaud != one.newBaud)
            places.push_back({protocol, one.newId, one.oldBaud});
    }
    return places;
}

/// One servo, by itself, that says who it is; `servo` is it. Else the obstacle is shown.
base::Result<bool> CommissionLine::alone(const Place& first, device::Servo& servo)
{
    const auto found = m_look.everybody(first);
    if (!found)
        return tl::unexpected(found.error());
    if (found->empty())
        return false;
    CommissionView blocked;
    blocked.step = CommissionStep::Blocked;
    for (const Found& one : *found)
        blocked.heard.push_back(
            {one.servo.profile ? one.servo.profile->modelName : QString(),
             {base::protocolName(one.servo.protocol), one.servo.id, one.servo.baud}});
    servo = found->front().servo;
    if (m_context.bus.hasBaud() && m_context.bus.baud() != servo.baud) {
        if (const auto set = m_context.bus.setBaud(servo.baud); !set)
            return tl::unexpected(set.error());
    }
    bool twins = found->front().twinsSuspected;
    if (found->size() == 1 && !twins && servo.profile) {
        const auto suspected = m_look.twins(servo);
        if (!suspected)
            return tl::unexpected(suspected.error());
        twins = *suspected;
    }
    if (found->size() > 1)
        blocked.obstacle = CommissionObstacle::SeveralServos;
    else if (twins)
        blocked.obstacle = CommissionObstacle::TwinIds;
    else if (!servo.profile)
        blocked.obstacle = CommissionObstacle::Unreadable;
    else
        return true;
    show(blocked);
    return false;
}

base::Result<device::Servo> CommissionLine::awaitServo()
{
    show(waitingView());
    for (;;) {
        const auto heard = m_look.round(expected());
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
            const auto ready = alone(**heard, servo);
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

base::Result<void> CommissionLine::awaitGone(const Place& place, CommissionView view)
{
    view.step = CommissionStep::Unplug;
    show(view);
    for (int silences = 0; silences < silencesUntilGone;) {
        const auto here = m_look.present(place);
        if (!here)
            return tl::unexpected(here.error());
        silences = *here ? 0 : silences + 1;
        if (const auto paused = pause(answerPause); !paused)
            return paused;
    }
    if (!m_batch.onWire)
        return {};
    m_batch.onWire.reset();
    return keep();
}
} // namespace jobs
