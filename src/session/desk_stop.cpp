// SPDX-License-Identifier: GPL-3.0-or-later
// The emergency stop: frames first, then proof, then nothing moves until torque is switched on.
#include "jobs/stop_check.h"
#include "session/desk_work.h"

#include <algorithm>

namespace session {
void Desk::emergencyStop()
{
    if (!m_connection)
        return;
    m_connection->bus().emergency();
    if (m_running)
        m_running->stop.request(); // it may be between two requests, where nothing is preempted
    dropQueue(base::ErrorCode::Preempted);
    for (auto& [ref, known] : m_servos)
        known.stopped = true;
    mark(record::MarkKind::Stop, nullptr, QStringLiteral("torque off"));
    checkStop();
    tell({.kind = Event::Kind::Stopped});
    const std::vector<ServoRef> all = m_order; // who hears of it may change the list
    for (const ServoRef ref : all)
        Q_EMIT servoChanged(ref);
}

/// A task like others, so that it comes after what is running has closed its locks.
void Desk::checkStop()
{
    const auto check = std::make_shared<StopCheck>();
    std::vector<ServoRef> asked;
    for (const ServoRef ref : m_order) {
        const bool here = !hasBaud() || m_servos.at(ref).servo.baud == baud();
        (here ? asked : check->elsewhere).push_back(ref);
    }
    if (asked.empty() || m_state != LinkState::Open)
        return;
    const auto work = std::make_shared<Work>();
    work->ref = asked.front();
    work->readOnly = true; // what it writes can wait for no search
    work->task.name = QStringLiteral("stop-check");
    work->task.quiet = true;
    work->task.others.assign(asked.begin() + 1, asked.end());
    const auto verdicts = std::make_shared<std::vector<jobs::StopVerdict>>();
    work->task.work = [verdicts](TaskContext& task) -> base::Result<void> {
        std::vector<device::Servo*> servos{&task.servo};
        servos.insert(servos.end(), task.others.begin(), task.others.end());
        auto result = jobs::checkStopped(task.device, servos);
        if (!result)
            return tl::unexpected(result.error());
        *verdicts = std::move(*result);
        return {};
    };
    work->merged = [this, asked, check, verdicts](Work& ended) {
        if (ended.error && ended.error->code == base::ErrorCode::Preempted)
            return; // by another stop, which has its own
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const jobs::StopVerdict verdict =
                i < verdicts->size() ? (*verdicts)[i] : jobs::StopVerdict{};
            auto& place = verdict.torque == jobs::StopVerdict::Torque::On    ? check->stillOn
                          : verdict.torque == jobs::StopVerdict::Torque::Off ? check->off
                                                                             : check->silent;
            place.push_back(asked[i]);
            ServoEntry* known = entry(asked[i]);
            if (known != nullptr && verdict.torque == jobs::StopVerdict::Torque::Unknown)
                known->silent = true;
            if (verdict.mayHold)
                check->stillHeld.push_back(asked[i]);
        }
        tell({.kind = Event::Kind::StopChecked, .error = ended.error, .stop = *check});
    };
    enqueue(work);
}

/// After a stop only torque may be switched on.
bool Desk::refusedByStop(const Work& work) const
{
    if (work.task.effect != Effect::Moves)
        return false;
    const auto refs = work.refs();
    return std::any_of(refs.begin(), refs.end(), [this](ServoRef ref) {
        const ServoEntry* known = servo(ref);
        return known != nullptr && known->stopped;
    });
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
        return jobs::disarm(context.device, context.servo).map([](bool) {});
    };
    perform(ref, std::move(task));
}

/// The user has switched torque on, and the servo has shown it.
void Desk::maybeReleased(const Work& ended)
{
    if (ended.task.effect != Effect::Energises)
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
