// SPDX-License-Identifier: GPL-3.0-or-later
// Before the port closes: servos that this program has set in motion and that would go on without
// it.
#include "device/motion.h"
#include "jobs/motion_check.h"
#include "session/desk_work.h"

#include <algorithm>

namespace session {
using jobs::Motion;

namespace {
MovingServo asMoving(ServoRef ref, Motion motion)
{
    return {ref, motion == Motion::Endless};
}
} // namespace

/// Servos that this program has moved or energised; a lasting test ends its own ones.
std::vector<ServoRef> Desk::driven() const
{
    std::vector<ServoRef> refs;
    const std::vector<ServoRef> tested = testing() ? m_running->refs() : std::vector<ServoRef>{};
    for (const ServoRef ref : m_order) {
        const bool ended = std::find(tested.begin(), tested.end(), ref) != tested.end();
        if (m_servos.at(ref).driven && !ended)
            refs.push_back(ref);
    }
    return refs;
}

/// One that cannot be read now is judged by what it said last.
void Desk::findMotion()
{
    const auto found = std::make_shared<std::vector<MovingServo>>();
    const auto tell = [this, found] { Q_EMIT motionFound(*found); };
    const std::vector<ServoRef> asked =
        m_state == LinkState::Open ? driven() : std::vector<ServoRef>{};
    const bool readable = !testing() && !m_search;
    for (const ServoRef ref : asked) {
        const Motion known = jobs::lastKnownMotion(m_servos.at(ref).servo);
        if (!readable && known != Motion::Rest)
            found->push_back(asMoving(ref, known));
    }
    if (asked.empty() || !readable) {
        m_inbox.post(tell);
        return;
    }
    const auto open = std::make_shared<std::size_t>(asked.size());
    for (const ServoRef ref : asked) {
        const auto work = std::make_shared<Work>();
        work->ref = ref;
        work->readOnly = true;
        work->task.name = QStringLiteral("motion");
        work->task.quiet = true;
        const auto motion = std::make_shared<std::optional<Motion>>();
        work->task.work = [motion](TaskContext& task) -> base::Result<void> {
            const auto read = jobs::readMotion(task.device, task.servo);
            if (!read)
                return tl::unexpected(read.error());
            *motion = *read;
            return {};
        };
        work->merged = [this, ref, motion, open, found, tell](Work&) {
            const ServoEntry* known = servo(ref);
            const Motion last =
                known != nullptr ? jobs::lastKnownMotion(known->servo) : Motion::Rest;
            if (const Motion now = motion->value_or(last); now != Motion::Rest)
                found->push_back(asMoving(ref, now));
            if (--*open == 0)
                tell();
        };
        enqueue(work);
    }
}

/// Reads anew, since what moved a moment ago may rest and the other way round.
void Desk::haltDriven()
{
    const std::vector<ServoRef> all = driven();
    m_leaving->open = all.size();
    for (const ServoRef ref : all) {
        const auto work = std::make_shared<Work>();
        work->ref = ref;
        work->finishes = true;
        work->task.name = QStringLiteral("halt");
        work->task.quiet = true;
        work->epoch = m_connection->bus().emergencies();
        const auto moved = std::make_shared<bool>(false);
        work->task.work = [moved](TaskContext& task) -> base::Result<void> {
            const Motion known = jobs::lastKnownMotion(task.servo);
            const auto now = jobs::readMotion(task.device, task.servo);
            *moved = now.value_or(known) != Motion::Rest;
            if (!*moved)
                return {};
            return now ? device::halt(task.device, task.servo) : tl::unexpected(now.error());
        };
        work->merged = [this, ref, moved](Work& ended) { halted(ref, *moved, ended.error); };
        m_queue.push_back(work);
    }
    Q_EMIT taskChanged();
    goOn();
}

void Desk::halted(ServoRef ref, bool moved, const std::optional<base::Error>& error)
{
    if (!m_leaving)
        return;
    // An emergency stop in between has taken its torque off.
    const bool stopped = error && error->code == base::ErrorCode::Preempted;
    if (moved && !stopped)
        (error ? m_leaving->moving : m_leaving->halted).push_back(ref);
    if (--m_leaving->open > 0)
        return;
    m_inbox.post([this] { leave(); }); // not from within the end of its own work
}

/// After the servos that moved have been told to stop.
void Desk::leave()
{
    if (!m_leaving)
        return;
    const bool stays = m_leaving->how == AtClose::StopOrStay && !m_leaving->moving.empty() &&
                       m_state == LinkState::Open;
    if (stays) {
        const std::vector<ServoRef> moving = m_leaving->moving;
        m_leaving.reset();
        m_closing = false;
        m_nextRequest.reset();
        tell({.kind = Event::Kind::NotHalted, .moving = moving});
        Q_EMIT stayedOpen();
        return;
    }
    closeNow();
}
} // namespace session
