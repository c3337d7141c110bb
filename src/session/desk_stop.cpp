// SPDX-License-Identifier: GPL-3.0-or-later
// The emergency stop: frames first, then proof, then nothing moves until torque is switched on.
#include "device/motion/held_goal.h"
#include "jobs/stop_check.h"
#include "session/desk_work.h"

#include <algorithm>

namespace session {
void Desk::emergencyStop()
{
    if (!m_connection || m_connection->bus().lost()) {
        if (m_running)
            m_running->stop.request();
        m_stopNotSent = true;
        emitEvent({.kind = Event::Kind::StopNotSent});
        return;
    }
    m_stopNotSent = false;
    m_connection->bus().emergency();
    if (m_running)
        m_running->stop.request(); // it may be between two requests, where nothing is preempted
    clearQueue(base::ErrorCode::Preempted);
    for (auto& [ref, known] : m_servos) {
        known.stopped = true;
        known.stoppedAt = now();
    }
    mark(record::MarkKind::Stop, nullptr, QStringLiteral("torque off"));
    // A search at other rates puts the rate back when it has ended; who is asked must be known
    // then.
    m_checkAfterSearch = m_search && m_search->started && !m_search->keepsBaud;
    if (!m_checkAfterSearch)
        verifyStop();
    emitEvent({.kind = Event::Kind::Stopped, .isPending = m_connection->bus().isReconnecting()});
    const std::vector<ServoRef> all = m_order; // who hears of it may change the list
    for (const ServoRef ref : all)
        Q_EMIT servoChanged(ref);
}

/// Tasks like others, so that they come after what is running has closed its locks; one for each
/// servo, so that one that is gone keeps nobody else from being looked at.
void Desk::verifyStop()
{
    const auto check = std::make_shared<StopVerification>();
    std::vector<ServoRef> asked;
    for (const ServoRef ref : m_order) {
        const bool here = !canSetBaud() || m_servos.at(ref).servo.baud == baud();
        (here ? asked : check->result.otherBaud).push_back(ref);
    }
    if (m_state != LinkState::Open)
        return;
    check->openCount = asked.size();
    check->unread = asked;
    m_stopVerification = check;
    if (!asked.empty())
        m_stopUnconfirmed.start();
    if (asked.empty() && !check->result.otherBaud.empty())
        emitEvent({.kind = Event::Kind::StopVerified, .stop = check->result});
    for (const ServoRef ref : asked)
        verifyStop(ref, check);
}

void Desk::verifyStop(ServoRef ref, const std::shared_ptr<StopVerification>& check)
{
    const auto work = std::make_shared<Work>();
    work->ref = ref;
    work->readOnly = true; // what it writes can wait for no search
    work->task.name = QStringLiteral("stop-check");
    work->task.quiet = true;
    const auto verdict = std::make_shared<jobs::StopCheckResult>();
    work->task.work = [verdict](TaskContext& task) -> base::Result<void> {
        const auto result = jobs::verifyEmergencyStop(task.device, {&task.servo});
        if (!result)
            return tl::unexpected(result.error());
        *verdict = result->front();
        return {};
    };
    work->onMerged = [this, ref, check, verdict](Work& ended) {
        addVerdict(ref, *check, *verdict, ended.error);
    };
    enqueue(work);
}

void Desk::addVerdict(ServoRef ref, StopVerification& check, const jobs::StopCheckResult& verdict,
                      const std::optional<base::Error>& error)
{
    using Torque = jobs::StopCheckResult::Torque;
    // Another stop has come, which has a check of its own.
    check.superseded = check.superseded || (error && error->code == base::ErrorCode::Preempted);
    auto& place = verdict.torque == Torque::On    ? check.result.stillOn
                  : verdict.torque == Torque::Off ? check.result.off
                                                  : check.result.silent;
    place.push_back(ref);
    std::erase(check.unread, ref);
    if (verdict.mayHavePendingGoal)
        check.result.stillHeld.push_back(ref);
    ServoEntry* known = entry(ref);
    if (known != nullptr && verdict.torque == Torque::Unknown && !error)
        known->silent = true;
    if (--check.openCount == 0 && !check.superseded)
        emitEvent({.kind = Event::Kind::StopVerified, .error = error, .stop = check.result});
}

void Desk::reportUnconfirmed()
{
    const auto check = m_stopVerification.lock();
    if (!check || check->superseded || check->unread.empty() || m_state != LinkState::Open)
        return;
    if (m_connection->bus().isReconnecting()) // has been said: it is still owed
        return;
    StopResult result;
    result.silent = check->result.silent;
    result.silent.insert(result.silent.end(), check->unread.begin(), check->unread.end());
    emitEvent({.kind = Event::Kind::StopUnconfirmed, .stop = result});
}

/// After a stop only torque may be switched on.
std::optional<base::Error> Desk::stopRefusal(const Work& work) const
{
    if (work.task.effect != Effect::Moves)
        return std::nullopt;
    base::Error refusal{base::ErrorCode::Preempted, {}, QStringLiteral("torque-first")};
    QStringList held;
    for (const ServoRef ref : work.refs()) {
        const ServoEntry* known = servo(ref);
        if (known == nullptr || !known->stopped)
            continue;
        held.append(QString::number(known->servo.id));
        refusal.id = refusal.id < 0 ? known->servo.id : refusal.id;
    }
    if (held.isEmpty())
        return std::nullopt;
    if (held.size() > 1)
        refusal.detail += QLatin1Char(' ') + held.join(QStringLiteral(", "));
    return refusal;
}

/// What an LX servo stores since the stop is the place where it was then. It may have been turned
/// by hand since, and a start command would turn it back.
void Desk::storeHere(ServoRef ref)
{
    if (servo(ref)->servo.profile->byRole(catalog::Role::StoredGoal) == nullptr)
        return;
    Task task;
    task.name = QStringLiteral("stop-check");
    task.quiet = true;
    task.work = [](TaskContext& context) {
        return device::cancelHeldGoal(context.device, context.servo).map([](bool) {});
    };
    perform(ref, std::move(task));
}

/// The user has switched torque on, and the servo has shown it, after the latest stop.
void Desk::releaseAfterStop(const Work& ended)
{
    if (ended.task.effect != Effect::EnablesTorque || !m_connection ||
        ended.epoch != m_connection->bus().emergencyCount())
        return;
    const auto look = [&](const Work::Part& part) {
        const catalog::Register* torque =
            part.servo.profile ? part.servo.profile->byRole(catalog::Role::TorqueSwitch) : nullptr;
        ServoEntry* known = entry(part.ref);
        if (torque == nullptr || known == nullptr)
            return;
        const auto at = part.servo.image.readAt(torque->offset);
        if (!at || *at < ended.startedAt || part.servo.raw(*torque) != 1)
            return;
        if (std::exchange(known->stopped, false))
            storeHere(part.ref);
    };
    look(ended.own);
    for (const Work::Part& other : ended.others)
        look(other);
}
} // namespace session
