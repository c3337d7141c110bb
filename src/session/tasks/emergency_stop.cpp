// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tasks/emergency_stop.h"

#include "device/motion/held_goal.h"
#include "device/motion/motion.h"
#include "jobs/stop_check.h"
#include "session/workbench.h"

#include <algorithm>

namespace session {
namespace {
/// Torque switches that have not been read back by then are reported.
constexpr auto confirmTimeout = std::chrono::milliseconds(1500);
} // namespace

EmergencyStop::EmergencyStop(Workbench& bench)
    : m_bench(bench)
{
    m_unconfirmed.setInterval(confirmTimeout);
    m_unconfirmed.setSingleShot(true);
    connect(&m_unconfirmed, &QTimer::timeout, this, &EmergencyStop::reportUnconfirmed);
}

void EmergencyStop::portOpened()
{
    if (std::exchange(m_notSent, false))
        m_bench.emitEvent({.kind = Event::Kind::StopNotSent, .isRepeated = true});
}

void EmergencyStop::baudRestored()
{
    if (std::exchange(m_checkAtOldBaud, false))
        verify();
}

void EmergencyStop::trigger()
{
    if (!m_bench.link().connection() || m_bench.link().connection()->bus().lost()) {
        if (m_bench.tasks().running())
            m_bench.tasks().running()->stop.request();
        m_notSent = true;
        m_bench.emitEvent({.kind = Event::Kind::StopNotSent});
        return;
    }
    m_notSent = false;
    m_bench.link().connection()->bus().emergency();
    if (m_bench.tasks().running())
        m_bench.tasks()
            .running()
            ->stop.request(); // it may be between two requests, where nothing is preempted
    m_bench.tasks().clearQueue(base::ErrorCode::Preempted);
    for (const ServoRef ref : m_bench.registry().order()) {
        ServoEntry& known = *m_bench.registry().entry(ref);
        known.stopped = true;
        known.stoppedAt = m_bench.now();
    }
    m_bench.polling().mark(recording::MarkKind::Stop, nullptr, QStringLiteral("torque off"));
    // Who is asked depends on the rate: it is known once it has been put back.
    const auto& running = m_bench.tasks().running();
    m_checkAtOldBaud = (m_bench.search().isStarted() && !m_bench.search().keepsBaud()) ||
                       (running && running->task.changesPortBaud);
    if (!m_checkAtOldBaud)
        verify();
    m_bench.emitEvent({.kind = Event::Kind::Stopped,
                       .isPending = m_bench.link().connection()->bus().isReconnecting()});
    const std::vector<ServoRef> all =
        m_bench.registry().order(); // receivers of the signal may change the list
    for (const ServoRef ref : all)
        Q_EMIT m_bench.registry().servoChanged(ref);
}

/// Tasks like others, so that they come after what is running has closed its locks; one for each
/// servo, so that one that is gone does not keep the others from being checked.
void EmergencyStop::verify()
{
    const auto check = std::make_shared<StopVerification>();
    std::vector<ServoRef> asked;
    for (const ServoRef ref : m_bench.registry().order()) {
        const bool here = !m_bench.link().canSetBaud() ||
                          m_bench.registry().servo(ref)->servo.baud == m_bench.link().baud();
        (here ? asked : check->result.otherBaud).push_back(ref);
    }
    if (m_bench.link().state() != LinkState::Open)
        return;
    check->openCount = asked.size();
    check->unread = asked;
    m_verification = check;
    if (!asked.empty())
        m_unconfirmed.start();
    if (asked.empty() && !check->result.otherBaud.empty())
        m_bench.emitEvent({.kind = Event::Kind::StopVerified, .stop = check->result});
    for (const ServoRef ref : asked)
        verify(ref, check);
}

void EmergencyStop::verify(ServoRef ref, const std::shared_ptr<StopVerification>& check)
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
    m_bench.tasks().enqueue(work);
}

void EmergencyStop::addVerdict(ServoRef ref, StopVerification& check,
                               const jobs::StopCheckResult& verdict,
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
    ServoEntry* known = m_bench.registry().entry(ref);
    if (known != nullptr && verdict.torque == Torque::Unknown && !error)
        known->silent = true;
    if (--check.openCount == 0 && !check.superseded)
        m_bench.emitEvent(
            {.kind = Event::Kind::StopVerified, .error = error, .stop = check.result});
}

void EmergencyStop::reportUnconfirmed()
{
    const auto check = m_verification.lock();
    if (!check || check->superseded || check->unread.empty() ||
        m_bench.link().state() != LinkState::Open)
        return;
    if (m_bench.link().connection()->bus().isReconnecting()) // has been said: it is still owed
        return;
    StopResult result;
    result.silent = check->result.silent;
    result.silent.insert(result.silent.end(), check->unread.begin(), check->unread.end());
    m_bench.emitEvent({.kind = Event::Kind::StopUnconfirmed, .stop = result});
}

bool EmergencyStop::canAllowMovement() const
{
    return !m_bench.search().isSearching() && !m_bench.tasks().isBusy();
}

bool EmergencyStop::allowMovement(const std::vector<ServoRef>& servos, QObject* guard,
                                  const std::function<void(const TaskCompletion&)>& done)
{
    if (!canAllowMovement())
        return false;
    for (const ServoRef ref : servos) {
        Task task;
        task.name = QStringLiteral("torque");
        task.effect = Effect::EnablesTorque;
        task.work = [](TaskContext& context) {
            return device::setTorque(context.device, context.servo, device::Torque::On);
        };
        task.guard = guard;
        task.done = done;
        m_bench.tasks().perform(ref, std::move(task));
    }
    return true;
}

/// After a stop only torque may be switched on.
std::optional<base::Error> EmergencyStop::refusal(const Work& work) const
{
    if (work.task.effect != Effect::Moves)
        return std::nullopt;
    base::Error refusal{base::ErrorCode::Preempted, {}, QStringLiteral("torque-first")};
    QStringList held;
    for (const ServoRef ref : work.refs()) {
        const ServoEntry* known = m_bench.registry().servo(ref);
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
void EmergencyStop::storeHere(ServoRef ref)
{
    if (m_bench.registry().servo(ref)->servo.profile->byRole(catalog::Role::StoredGoal) == nullptr)
        return;
    Task task;
    task.name = QStringLiteral("stop-check");
    task.quiet = true;
    task.work = [](TaskContext& context) {
        return device::cancelHeldGoal(context.device, context.servo).map([](bool) {});
    };
    m_bench.tasks().perform(ref, std::move(task));
}

/// The user has switched torque on, and the servo has shown it, after the latest stop.
void EmergencyStop::release(const Work& ended)
{
    if (ended.task.effect != Effect::EnablesTorque || !m_bench.link().connection() ||
        ended.epoch != m_bench.link().connection()->bus().emergencyCount())
        return;
    const auto look = [&](const Work::Part& part) {
        const catalog::Register* torque =
            part.servo.profile ? part.servo.profile->byRole(catalog::Role::TorqueSwitch) : nullptr;
        ServoEntry* known = m_bench.registry().entry(part.ref);
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
