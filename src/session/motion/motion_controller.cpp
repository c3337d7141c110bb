// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/motion/motion_controller.h"

#include "session/motion/motion_tasks.h"

#include <algorithm>

namespace session {
using base::ErrorCode;
using device::MoveMethod;

namespace {
/// Interval at which a drag checks whether another program has changed the settings.
constexpr base::Duration maxDragSettingsAge = std::chrono::milliseconds(900);

/// The user has stopped it, and knows. Asking for more after a stop is answered ("torque-first").
bool wasStopped(const base::Error& error)
{
    return (error.code == ErrorCode::Preempted && error.detail.isEmpty()) ||
           error.code == ErrorCode::Stopped;
}

/// As the marks in charts and recordings have it: "2048 (180.0°)".
QString goalText(const device::Servo& servo, const device::MovePlan& plan)
{
    const catalog::Register* reg = servo.profile ? servo.profile->byRole(plan.goalRole) : nullptr;
    const QString raw = QString::number(plan.goalRaw);
    if (reg == nullptr || servo.meaning(*reg).unit.isEmpty())
        return raw;
    return QStringLiteral("%1 (%2)").arg(
        raw, catalog::formatValue(plan.goalRaw, *reg, servo.meaning(*reg), false));
}
} // namespace

/// One request on its way to the wire.
struct MotionController::PendingMove {
    MoveRequest request;
    std::vector<ServoRef> servos;
    std::shared_ptr<std::vector<device::MovePlan>> plans; ///< filled on the job thread
    bool marked = true;                                   ///< of a drag only the first
};

MotionController::MotionController(Workbench& workbench, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
{
    connect(&workbench, &Workbench::eventOccurred, this, &MotionController::handleEvent);
    connect(&workbench.registry(), &ServoRegistry::servoRemoved, this,
            &MotionController::removeMissing);
    connect(&workbench.registry(), &ServoRegistry::servosCleared, this,
            &MotionController::removeMissing);
    connect(&workbench.link(), &LinkController::linkChanged, this, [this] {
        if (m_workbench.link().state() == LinkState::Open)
            return;
        // When the port is opened again the servos may have been switched off in between.
        m_next.reset();
        m_lastStep.reset();
        m_held.clear();
        m_totalSteps.clear();
        Q_EMIT changed();
    });
}

void MotionController::handleEvent(const Event& event)
{
    if (event.kind == Event::Kind::StopVerified) { // these have forgotten what they held
        for (const ServoRef ref : event.stop.off) {
            const auto& still = event.stop.stillHeld;
            if (std::find(still.begin(), still.end(), ref) == still.end())
                m_held.erase(ref);
        }
        Q_EMIT changed();
    }
    if (event.kind != Event::Kind::Stopped)
        return;
    m_next.reset();
    m_lastStep.reset();
    m_dragFailed = m_dragging;
    Q_EMIT changed();
}

bool MotionController::isStopped() const
{
    return std::any_of(m_servos.begin(), m_servos.end(), [this](ServoRef ref) {
        const ServoEntry* known = m_workbench.registry().servo(ref);
        return known != nullptr && known->stopped;
    });
}

void MotionController::removeMissing()
{
    const auto gone = [this](const auto& item) {
        return m_workbench.registry().servo(item.first) == nullptr;
    };
    std::erase_if(m_held, gone);
    std::erase_if(m_totalSteps, gone);
    std::erase_if(m_servos,
                  [this](ServoRef ref) { return m_workbench.registry().servo(ref) == nullptr; });
    if (m_servos.empty())
        m_next.reset();
    Q_EMIT changed();
}

void MotionController::setServos(const std::vector<ServoRef>& servos)
{
    if (servos == m_servos)
        return;
    m_servos = servos;
    m_next.reset();
    m_lastStep.reset();
    endDrag();
    Q_EMIT changed();
}

std::int64_t MotionController::totalSteps(ServoRef ref) const
{
    const auto sum = m_totalSteps.find(ref);
    return sum != m_totalSteps.end() ? sum->second : 0;
}

bool MotionController::move(const MoveRequest& request)
{
    if (m_servos.empty())
        return false;
    if (!request.dragged)
        endDrag();
    if (m_dragFailed)
        return false;
    if (m_sending)
        m_next = request;
    else
        send(request);
    return true;
}

void MotionController::endDrag()
{
    m_dragging = false;
    m_dragFailed = false;
    m_dragNotices.clear();
}

void MotionController::repeatStep()
{
    if (m_lastStep)
        move(*m_lastStep);
}

void MotionController::send(const MoveRequest& request)
{
    const bool inDrag = request.dragged && std::exchange(m_dragging, request.dragged);
    MoveJob job{request, inDrag ? maxDragSettingsAge : base::Duration::zero(), {}};
    for (const ServoRef ref : m_servos) {
        const ServoEntry* known = m_workbench.registry().servo(ref);
        const catalog::Mode* mode =
            known != nullptr && known->servo.profile ? known->servo.mode() : nullptr;
        job.expected.push_back({mode != nullptr ? mode->key : QString(), totalSteps(ref)});
    }
    PendingMove sending{request, m_servos, std::make_shared<std::vector<device::MovePlan>>(),
                        !inDrag};
    Task task;
    task.name = QStringLiteral("move");
    task.quiet = true;
    task.effect = Effect::Moves;
    task.work = [job = std::move(job), plans = sending.plans](TaskContext& context) {
        return sendMove(context, job, *plans);
    };
    m_sending = true;
    perform(m_servos, std::move(task),
            [this, sending](const TaskCompletion& end) { moveEnded(sending, end); });
}

void MotionController::moveEnded(const PendingMove& sending, const TaskCompletion& end)
{
    m_sending = false;
    noteHeld(sending.servos, *sending.plans); // one that failed half-way may stand in some of them
    if (end.error) {
        m_next.reset();
        m_dragFailed = m_dragging;
        reportCompletion(end);
        return;
    }
    for (std::size_t i = 0; i < sending.plans->size(); ++i) {
        const device::MovePlan& plan = (*sending.plans)[i];
        const ServoRef ref = sending.servos[i];
        if (sending.request.how != MoveMethod::Async && plan.relative)
            m_totalSteps[ref] += plan.goalRaw;
        if (plan.relative && sending.servos == m_servos)
            m_lastStep = sending.request;
        if (sending.request.how != MoveMethod::Async && sending.marked)
            markMove(ref, plan, sending.request.dragged);
    }
    reportCompletion(end);
    Q_EMIT moveSent(sending.request);
    sendNext();
}

void MotionController::markMove(ServoRef ref, const device::MovePlan& plan, bool dragged)
{
    if (const ServoEntry* known = m_workbench.registry().servo(ref))
        m_workbench.polling().markMove(ref, goalText(known->servo, plan), dragged);
}

/// Execute offers what may wait in its servo, and nothing else.
void MotionController::noteHeld(const std::vector<ServoRef>& servos,
                                const std::vector<device::MovePlan>& plans)
{
    for (std::size_t i = 0; i < plans.size() && m_workbench.link().state() == LinkState::Open;
         ++i) {
        if (plans[i].held.value_or(false))
            m_held[servos[i]] = plans[i];
        else if (plans[i].held)
            m_held.erase(servos[i]);
    }
}

void MotionController::sendNext()
{
    if (m_sending || !m_next || m_servos.empty())
        return;
    const MoveRequest request = *std::exchange(m_next, std::nullopt);
    send(request);
}

void MotionController::startHeldMoves()
{
    std::vector<ServoRef> servos;
    auto plans = std::make_shared<std::vector<device::MovePlan>>();
    for (const auto& [ref, plan] : m_held) {
        servos.push_back(ref);
        plans->push_back(plan);
    }
    if (servos.empty())
        return;
    Task task;
    task.name = QStringLiteral("execute");
    task.quiet = true;
    task.effect = Effect::Moves;
    task.work = [plans](TaskContext& context) { return startHeldGoals(context, *plans); };
    perform(servos, std::move(task), [this, servos, plans](const TaskCompletion& end) {
        for (std::size_t i = 0; i < servos.size(); ++i) {
            if ((*plans)[i].held == false)
                m_held.erase(servos[i]);
        }
        if (!end.error) {
            for (std::size_t i = 0; i < servos.size(); ++i) {
                if ((*plans)[i].relative)
                    m_totalSteps[servos[i]] += (*plans)[i].goalRaw;
                markMove(servos[i], (*plans)[i]);
            }
        }
        reportCompletion(end);
    });
}

void MotionController::setTorque(device::Torque torque)
{
    m_next.reset();
    Task task;
    task.name = QStringLiteral("torque");
    if (torque != device::Torque::Off)
        task.effect = Effect::EnablesTorque;
    task.work = [torque](TaskContext& context) { return setTorqueAll(context, torque); };
    perform(m_servos, std::move(task),
            [this](const TaskCompletion& end) { reportCompletion(end); });
}

void MotionController::halt()
{
    m_next.reset();
    Task task;
    task.name = QStringLiteral("halt");
    task.quiet = true;
    task.work = [](TaskContext& context) { return haltAll(context); };
    perform(m_servos, std::move(task),
            [this](const TaskCompletion& end) { reportCompletion(end); });
}

void MotionController::switchMode(const QString& mode)
{
    m_next.reset();
    m_lastStep.reset();
    ModeJob job{mode, {}};
    for (const ServoRef ref : m_servos) {
        const auto held = m_held.find(ref);
        job.held.push_back(held != m_held.end() ? std::optional(held->second) : std::nullopt);
    }
    Task task;
    task.name = QStringLiteral("mode");
    task.savesTable = true;
    task.work = [job = std::move(job)](TaskContext& context) {
        return switchModeAll(context, job);
    };
    perform(m_servos, std::move(task), [this, servos = m_servos](const TaskCompletion& end) {
        for (const ServoRef ref : servos) {
            if (!end.error) {
                m_held.erase(ref);
                m_totalSteps.erase(ref);
            }
        }
        reportCompletion(end);
        if (!end.error)
            Q_EMIT modeSwitched();
    });
}

void MotionController::previewMode(const QString& mode)
{
    if (m_servos.empty())
        return;
    auto plan = std::make_shared<device::ModePlan>();
    Task task;
    task.name = QStringLiteral("plan-mode");
    task.quiet = true;
    task.work = [mode, plan](TaskContext& context) -> base::Result<void> {
        auto planned = device::planMode(context.device, context.servo, mode);
        if (!planned)
            return tl::unexpected(planned.error());
        *plan = std::move(*planned);
        return {};
    };
    perform({m_servos.front()}, std::move(task), [this, plan](const TaskCompletion& end) {
        reportCompletion(end);
        if (!end.error)
            Q_EMIT modePreviewed(*plan);
    });
}

/// By the workbench's own safe write: recorded, shown in the table, and taken back by undo.
void MotionController::setTorqueLimit(std::int64_t raw)
{
    for (const ServoRef ref : m_servos) {
        const ServoEntry* known = m_workbench.registry().servo(ref);
        if (known == nullptr || !known->servo.profile)
            continue;
        const device::TorqueLimit limit = device::torqueLimit(*known->servo.profile);
        if (limit.reg == nullptr)
            continue;
        WriteRequest moveOrder;
        moveOrder.items.push_back({limit.reg->key, raw});
        moveOrder.temporary = limit.temporary;
        m_workbench.writes().write(ref, moveOrder);
    }
}

void MotionController::perform(const std::vector<ServoRef>& servos, Task task,
                               std::function<void(const TaskCompletion&)> done)
{
    if (servos.empty())
        return;
    task.otherServos.assign(servos.begin() + 1, servos.end());
    task.guard = this;
    task.done = [this, done = std::move(done)](const TaskCompletion& end) {
        --m_running;
        done(end);
        Q_EMIT changed();
    };
    ++m_running;
    m_workbench.tasks().perform(servos.front(), std::move(task));
    Q_EMIT changed();
}

/// In a drag the same notice is shown once.
void MotionController::reportCompletion(const TaskCompletion& end)
{
    device::Notices newNotices;
    for (const device::Notice& notice : end.notices) {
        const bool reported = m_dragging && std::find(m_dragNotices.begin(), m_dragNotices.end(),
                                                      notice) != m_dragNotices.end();
        if (!reported)
            newNotices.push_back(notice);
    }
    if (m_dragging)
        m_dragNotices.insert(m_dragNotices.end(), newNotices.begin(), newNotices.end());
    if (!newNotices.empty())
        Q_EMIT noticesReported(newNotices);
    if (end.error && !wasStopped(*end.error))
        Q_EMIT failed(*end.error);
}
} // namespace session
