// SPDX-License-Identifier: GPL-3.0-or-later
// Which servos of the list answer, and whether they are still the ones that were identified: a
// servo can be exchanged on the open line, and its ID does not tell.
#include "session/desk_work.h"

#include <algorithm>

namespace session {
namespace {
/// So many requests in a row without an answer are no lost reply.
constexpr std::uint64_t maxMissedReplies = 3;

/// Says nothing about who is there: the next attempt may.
bool isTransient(base::ErrorCode code)
{
    return code == base::ErrorCode::Held || code == base::ErrorCode::Preempted ||
           code == base::ErrorCode::Stopped;
}

QString modelOf(const device::Servo& servo)
{
    return servo.profile ? servo.profile->modelName : QString();
}
} // namespace

bool isSameKind(const device::Servo& a, const device::Servo& b)
{
    return !a.profile || !b.profile || a.profile->identity == b.profile->identity;
}

/// What a job reads comes into the list when it has ended; that its servos answer, or do not, is
/// seen here. What is asked elsewhere, or while a search asks everybody, says nothing of them.
void Desk::updatePresence()
{
    const bool counted = canPoll() && !m_search;
    for (const auto& [id, counters] : m_connection->bus().statistics().byId) {
        const auto [place, fresh] = m_replyCounters.try_emplace(id);
        ReplyCounters& before = place->second;
        const bool heard = std::exchange(before.ok, counters.ok) != counters.ok;
        if (heard || fresh || !counted)
            before.missed = counters.timeouts;
        const bool missed = counters.timeouts - before.missed >= maxMissedReplies;
        if (!heard && !missed)
            continue;
        const auto answers = [this, id = id](const auto& item) {
            const device::Servo& servo = item.second.servo;
            return servo.id == id && (!canSetBaud() || servo.baud == baud());
        };
        const auto first = std::find_if(m_servos.begin(), m_servos.end(), answers);
        const bool alone = first != m_servos.end() && std::find_if(std::next(first), m_servos.end(),
                                                                   answers) == m_servos.end();
        if (!alone)
            continue;
        ServoEntry& known = first->second;
        if (heard) {
            known.lastSeen = now();
            known.answeredAgain = known.silent;
        } else if (!std::exchange(known.silent, true)) {
            Q_EMIT servoChanged(first->first);
        }
    }
}

/// A servo that answers after a silence is identified before it counts as the same.
void Desk::identifyReturned()
{
    std::vector<ServoRef> heard;
    for (const auto& [ref, known] : m_servos) {
        if (known.silent && known.answeredAgain)
            heard.push_back(ref);
    }
    for (const ServoRef ref : heard)
        reidentify(ref);
}

void Desk::reidentify(ServoRef ref)
{
    const ServoEntry* known = servo(ref);
    const bool here = known != nullptr && (!canSetBaud() || known->servo.baud == baud());
    if (!here || !canPoll() || m_search || !m_identifying.insert(ref).second)
        return;
    m_searchThread->start([this, ref, id = known->servo.id, protocol = known->servo.protocol] {
        base::StopToken stop;
        device::Notices notices;
        const auto now = device::identify(m_connection->context(stop, notices), id, protocol);
        m_mainQueue.post([this, ref, now] { reidentified(ref, now); });
    });
}

void Desk::reidentified(ServoRef ref, const base::Result<device::Servo>& now)
{
    m_identifying.erase(ref);
    ServoEntry* known = entry(ref);
    if (known != nullptr && !now) {
        known->answeredAgain = isTransient(now.error().code);
    } else if (known != nullptr && now->id == known->servo.id && now->baud == known->servo.baud) {
        if (!isSameKind(known->servo, *now)) {
            replace(ref, {*now});
        } else if (known->silent) {
            known->silent = known->garbled = known->answeredAgain = false;
            known->snapshotPath.clear(); // another one of its kind may have been put in its place
            known->lastSeen = this->now();
            changed(*known);
        }
    }
    scheduleNext();
}

/// Its journal stays with the servo that was here. While a task is at work with it the list keeps
/// it, as silent.
void Desk::replace(ServoRef ref, const jobs::FoundServo& now)
{
    ServoEntry& known = m_servos.at(ref);
    const bool working = m_running && [&] {
        const auto refs = m_running->refs();
        return std::find(refs.begin(), refs.end(), ref) != refs.end();
    }();
    if (working) {
        known.silent = known.answeredAgain = true;
        return;
    }
    const QString before = modelOf(known.servo);
    const device::Servo& servo = now.servo;
    m_connection->bus().verifiedIds().remove(servo.protocol, servo.id, servo.baud);
    m_connection->addStopTarget(servo);
    remove(ref);
    const ServoRef added = add(now);
    emitEvent({.kind = Event::Kind::Replaced, .servo = added, .task = before});
}

/// A write was refused because another servo answers.
void Desk::suspectReplacement(const Work& ended)
{
    if (!ended.error || ended.error->code != base::ErrorCode::IdentityMismatch)
        return;
    for (const ServoRef ref : ended.refs()) {
        ServoEntry* known = entry(ref);
        if (known == nullptr || (ended.error->id >= 0 && known->servo.id != ended.error->id))
            continue;
        known->silent = known->answeredAgain = true; // identifyReturned() follows
    }
}
} // namespace session
