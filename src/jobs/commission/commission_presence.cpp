// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_presence.h"

#include "device/reader.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;

namespace {
constexpr base::Duration roundPause = std::chrono::milliseconds(20);
constexpr base::Duration blockedPause = std::chrono::milliseconds(250);
constexpr base::Duration pollPause = std::chrono::milliseconds(50);
constexpr int missedPingsUntilGone = 3;

/// As far as anything tells two servos of a kind apart, their settings do.
bool hasSameSettings(const device::Servo& one, const device::Servo& other)
{
    return std::none_of(one.profile->registers.begin(), one.profile->registers.end(),
                        [&](const catalog::Register& reg) {
                            const auto before = one.raw(reg);
                            const auto now = other.raw(reg);
                            return reg.area == catalog::Area::Eprom && before && now &&
                                   *before != *now;
                        });
}

CommissionView blockedView(const std::vector<FoundServo>& found)
{
    CommissionView view;
    view.step = CommissionStep::Blocked;
    for (const FoundServo& one : found)
        view.detected.push_back(
            {one.servo.profile ? one.servo.profile->modelName : QString(),
             {base::protocolName(one.servo.protocol), one.servo.id, one.servo.baud}});
    return view;
}
} // namespace

base::Result<void> CommissionPresence::pause(base::Duration span)
{
    if (m_context.bus.pauseUntil(m_context.bus.clock().now() + span, &m_context.stop) &&
        !m_context.stop.isRequested())
        return {};
    return base::fail(ErrorCode::Stopped, QStringLiteral("commission"));
}

base::Result<void> CommissionPresence::setRate(int baud)
{
    if (!m_context.bus.canSetBaud() || m_context.bus.baud() == baud)
        return {};
    return m_context.bus.setBaud(baud);
}

/// True: one servo replies, by itself, and is identified; `servo` is it. Otherwise the obstacle is
/// shown, if anything replies.
base::Result<bool> CommissionPresence::isAlone(const BusLocation& first, device::Servo& servo)
{
    const auto found = m_detector.findAll(first);
    if (!found)
        return tl::unexpected(found.error());
    if (found->empty())
        return false;
    servo = found->front().servo;
    if (const auto set = setRate(servo.baud); !set)
        return tl::unexpected(set.error());
    bool hasDuplicateId = found->front().duplicateSuspected;
    if (found->size() == 1 && !hasDuplicateId && servo.profile) {
        const auto suspected = m_detector.hasDuplicateId(servo);
        if (!suspected)
            return tl::unexpected(suspected.error());
        hasDuplicateId = *suspected;
    }
    CommissionView blocked = blockedView(*found);
    if (found->size() > 1)
        blocked.obstacle = CommissionObstacle::DuplicateId;
    else if (hasDuplicateId)
        blocked.obstacle = CommissionObstacle::DuplicateIds;
    else if (!servo.profile)
        blocked.obstacle = CommissionObstacle::Unreadable;
    else
        return true;
    m_display.show(blocked);
    return false;
}

base::Result<device::Servo> CommissionPresence::waitForServo()
{
    m_display.show(m_progress.waitingView());
    for (;;) {
        const auto heard = m_detector.scanRound(m_progress.expectedLocations());
        if (!heard)
            return tl::unexpected(heard.error());
        base::Duration span = roundPause;
        if (!*heard) {
            m_display.show(m_progress.waitingView());
        } else {
            if (m_display.view().step != CommissionStep::Blocked) {
                CommissionView checking = m_progress.waitingView();
                checking.step = CommissionStep::Checking;
                m_display.show(checking);
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

base::Result<bool> CommissionPresence::isStillAlone(const device::Servo& servo)
{
    CommissionView checking = m_display.view();
    checking.step = CommissionStep::Checking;
    m_display.show(checking);
    device::Servo now;
    const auto ready = isAlone(CommissionProgress::locationOf(servo), now);
    if (!ready || !*ready || now.id != servo.id || now.baud != servo.baud ||
        !now.identity().isSameKind(servo.identity()))
        return ready ? base::Result<bool>(false) : ready;
    if (const auto read = device::readAll(m_context, now); !read)
        return read.error().code == ErrorCode::NoReply
                   ? base::Result<bool>(false)
                   : base::Result<bool>(tl::unexpected(read.error()));
    return hasSameSettings(servo, now);
}

base::Result<bool> CommissionPresence::isGone(const BusLocation& place, int& missed)
{
    const auto isPresent = m_detector.isPresent(place);
    if (!isPresent)
        return tl::unexpected(isPresent.error());
    missed = *isPresent ? 0 : missed + 1;
    if (missed >= missedPingsUntilGone)
        return true;
    return pause(pollPause).map([] { return false; });
}

base::Result<void> CommissionPresence::waitUntilGone(const BusLocation& place)
{
    for (int missed = 0;;) {
        const auto gone = isGone(place, missed);
        if (!gone)
            return tl::unexpected(gone.error());
        if (*gone)
            return {};
    }
}

base::Result<std::optional<CommissionPresence::BusLocation>>
CommissionPresence::findAgain(const CommissionWork& work)
{
    for (const int baud : {work.servo.baud, work.newBaud, work.row.oldBaud}) {
        for (const int id : {work.servo.id, work.newId, work.row.servo.id}) {
            if (id < 0)
                continue;
            const BusLocation place{work.servo.protocol, id, baud};
            const auto isPresent = m_detector.isPresent(place);
            if (!isPresent)
                return tl::unexpected(isPresent.error());
            if (*isPresent)
                return place;
        }
    }
    return std::nullopt;
}
} // namespace jobs
