// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/servos/presence_monitor.h"

#include "session/tasks/work.h"
#include "session/workbench.h"

#include <algorithm>

namespace session {
namespace {
/// This number of requests in a row without an answer is no lost reply.
constexpr std::uint64_t maxMissedReplies = 3;

/// After a reconnect, servos may get their power later than the adapter.
constexpr auto patience = std::chrono::seconds(20);
constexpr auto askInterval = std::chrono::seconds(2);

/// Proves nothing about which servo is there: the next attempt may.
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

PresenceMonitor::PresenceMonitor(Workbench& bench)
    : m_bench(bench)
{}

/// What a job reads comes into the list when it has ended; that its servos answer, or do not, is
/// seen here. What is asked elsewhere, or while a search asks everybody, says nothing of them.
void PresenceMonitor::update()
{
    const bool counted = m_bench.polling().canPoll() && !m_bench.search().isSearching();
    for (const auto& [id, counters] : m_bench.link().connection()->bus().statistics().byId) {
        const auto [place, fresh] = m_counters.try_emplace(id);
        ReplyCounters& before = place->second;
        const bool heard = std::exchange(before.ok, counters.ok) != counters.ok;
        if (heard || fresh || !counted)
            before.missed = counters.timeouts;
        const bool missed = counters.timeouts - before.missed >= maxMissedReplies;
        if (!heard && !missed)
            continue;
        const auto answers = [this, id = id](ServoRef ref) {
            const device::Servo& servo = m_bench.registry().servo(ref)->servo;
            return servo.id == id &&
                   (!m_bench.link().canSetBaud() || servo.baud == m_bench.link().baud());
        };
        const std::vector<ServoRef>& all = m_bench.registry().order();
        const auto first = std::find_if(all.begin(), all.end(), answers);
        if (first == all.end() || std::any_of(std::next(first), all.end(), answers))
            continue;
        ServoEntry& known = *m_bench.registry().entry(*first);
        if (heard) {
            known.lastSeen = m_bench.now();
            known.answeredAgain = known.silent;
        } else if (!std::exchange(known.silent, true)) {
            Q_EMIT m_bench.registry().servoChanged(known.ref);
        }
    }
}

void PresenceMonitor::askAll()
{
    for (const ServoRef ref : m_bench.registry().order()) {
        ServoEntry& known = *m_bench.registry().entry(ref);
        known.silent = true;
        known.hasFullTable = false; // another one of its kind may have been put in its place
        known.snapshotPath.clear();
        known.readError.reset();
    }
    m_askUntil = m_bench.now() + patience;
    m_nextAsk = {};
    for (const ServoRef ref : std::vector(m_bench.registry().order()))
        Q_EMIT m_bench.registry().servoChanged(ref);
}

/// A servo that answers after a silence is identified before it counts as the same.
void PresenceMonitor::identifyReturned()
{
    if (m_bench.now() < m_askUntil && m_bench.now() >= m_nextAsk) {
        m_nextAsk = m_bench.now() + askInterval;
        for (const ServoRef ref : m_bench.registry().order()) {
            ServoEntry& known = *m_bench.registry().entry(ref);
            known.answeredAgain |= known.silent;
        }
    }
    std::vector<ServoRef> heard;
    for (const auto& [ref, known] : m_bench.registry().entries()) {
        if (known.silent && known.answeredAgain)
            heard.push_back(ref);
    }
    for (const ServoRef ref : heard)
        reidentify(ref);
}

void PresenceMonitor::reidentify(ServoRef ref)
{
    const ServoEntry* known = m_bench.registry().servo(ref);
    const bool here = known != nullptr &&
                      (!m_bench.link().canSetBaud() || known->servo.baud == m_bench.link().baud());
    if (!here || !m_bench.polling().canPoll() || m_bench.search().isSearching() ||
        !m_identifying.insert(ref).second)
        return;
    m_bench.searchThread().start(
        [this, ref, id = known->servo.id, protocol = known->servo.protocol] {
            base::StopToken stop;
            device::Notices notices;
            device::Context context = m_bench.link().connection()->context(stop, notices);
            context.patient = false; // asked again soon
            const auto now = device::identify(context, id, protocol);
            m_bench.mainQueue().post([this, ref, now] { reidentified(ref, now); });
        });
}

void PresenceMonitor::reidentified(ServoRef ref, const base::Result<device::Servo>& now)
{
    m_identifying.erase(ref);
    ServoEntry* known = m_bench.registry().entry(ref);
    if (known != nullptr && !now) {
        known->answeredAgain = isTransient(now.error().code);
    } else if (known != nullptr && now->id == known->servo.id && now->baud == known->servo.baud) {
        if (!isSameKind(known->servo, *now)) {
            replace(ref, {*now});
        } else if (known->silent) {
            known->silent = known->garbled = known->answeredAgain = false;
            known->snapshotPath.clear(); // another one of its kind may have been put in its place
            known->lastSeen = m_bench.now();
            m_bench.registry().changed(*known);
        }
    }
    m_bench.scheduleNext();
}

/// Its journal stays with the servo that was here. While a task is at work with it the list keeps
/// it, as silent.
void PresenceMonitor::replace(ServoRef ref, const jobs::FoundServo& now)
{
    ServoEntry& known = *m_bench.registry().entry(ref);
    const bool working = m_bench.tasks().running() && [&] {
        const auto refs = m_bench.tasks().running()->refs();
        return std::find(refs.begin(), refs.end(), ref) != refs.end();
    }();
    if (working) {
        known.silent = known.answeredAgain = true;
        return;
    }
    const QString before = modelOf(known.servo);
    const device::Servo& servo = now.servo;
    m_bench.link().connection()->bus().verifiedIds().remove(servo.protocol, servo.id, servo.baud);
    m_bench.link().connection()->addStopTarget(servo);
    m_bench.registry().remove(ref);
    const ServoRef added = m_bench.registry().add(now);
    m_bench.emitEvent({.kind = Event::Kind::Replaced, .servo = added, .task = before});
}

/// A write was refused because another servo answers.
void PresenceMonitor::suspectReplacement(const Work& ended)
{
    if (!ended.error || ended.error->code != base::ErrorCode::IdentityMismatch)
        return;
    for (const ServoRef ref : ended.refs()) {
        ServoEntry* known = m_bench.registry().entry(ref);
        if (known == nullptr || (ended.error->id >= 0 && known->servo.id != ended.error->id))
            continue;
        known->silent = known->answeredAgain = true; // identifyReturned() follows
    }
}
} // namespace session
