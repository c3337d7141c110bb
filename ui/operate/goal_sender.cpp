// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/goal_sender.h"

#include "ui/operate/control_fields.h"
#include "ui/operate/control_goal.h"
#include "ui/operate/control_messages.h"
#include "ui/operate/control_send.h"
#include "ui/operate/move_result.h"
#include "ui/operate/torque_confirmation.h"

#include <utility>

namespace ui {
using device::MoveMethod;

namespace {
using namespace std::chrono_literals;
/// A dial that has not moved for this long has been released.
constexpr auto dialDragTimeout = 400ms;
} // namespace

GoalSender::GoalSender(const session::ServoRegistry& registry, const Selection& selection,
                       session::MotionController& motion, const Controls& controls, QObject* parent)
    : QObject(parent)
    , m_registry(registry)
    , m_selection(selection)
    , m_motion(motion)
    , m_controls(controls)
{
    const ControlGoal* goal = &controls.goal;
    connect(goal, &ControlGoal::goalMoved, this, &GoalSender::dragTo);
    connect(goal, &ControlGoal::dragEnded, this, &GoalSender::endDrag);
    connect(goal, &ControlGoal::returnPressed, this, &GoalSender::sendTypedGoal);
    connect(goal, &ControlGoal::stepRequested, this, &GoalSender::confirmAndSend);
    connect(goal, &ControlGoal::repeatRequested, this, [this] {
        m_controls.result.clearNotices();
        m_motion.repeatStep();
    });
    connect(&controls.fields, &ControlFields::returnPressed, this, &GoalSender::sendTypedGoal);
    connect(&controls.send, &ControlSend::sendRequested, this, &GoalSender::sendTypedGoal);
    connect(&controls.send, &ControlSend::executeRequested, this, [this] {
        m_controls.result.clearNotices();
        m_motion.startHeldMoves();
    });
    connect(&m_motion, &session::MotionController::moveSent, this, &GoalSender::onMoveSent);
    m_dialDragTimer.setSingleShot(true);
    m_dialDragTimer.setInterval(dialDragTimeout);
    connect(&m_dialDragTimer, &QTimer::timeout, goal, &ControlGoal::endDialDrag);
}

const session::ServoEntry* GoalSender::entry() const
{
    return m_registry.servo(m_selection.current());
}

const catalog::Register* GoalSender::goalRegister(const session::ServoEntry* entry) const
{
    return entry != nullptr && entry->servo.profile ? device::goalRegister(entry->servo) : nullptr;
}

void GoalSender::dragDialTo(std::int64_t raw)
{
    m_dialDragTimer.start();
    m_controls.goal.setFromDial(raw);
}

/// Goals that wait in the servo are not sent while dragging: Set sends one goal, not a hundred.
void GoalSender::dragTo(std::int64_t raw, bool dragged)
{
    if (m_controls.send.method() == MoveMethod::Async) {
        m_controls.goal.enterValue(raw);
        return;
    }
    // After the hint is confirmed the shaft must not jump to where the drag began.
    if (!m_controls.torque.confirmEnergize({})) {
        m_controls.goal.cancelDrag();
        Q_EMIT controlsChanged();
        return;
    }
    send(raw, dragged);
}

void GoalSender::endDrag()
{
    m_isDragging = false;
    m_motion.endDrag();
    Q_EMIT controlsChanged();
}

void GoalSender::sendTypedGoal()
{
    if (entry() == nullptr || !m_controls.send.canSend())
        return;
    if (const auto raw = m_controls.goal.goal())
        confirmAndSend(*raw);
    else
        m_controls.messages.showInputError([this] { return m_controls.goal.inputError(); });
}

void GoalSender::confirmAndSend(std::int64_t raw)
{
    if (m_controls.torque.confirmEnergize([this, raw] { send(raw, false); }))
        send(raw, false);
}

void GoalSender::send(std::int64_t raw, bool dragged)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg = goalRegister(known);
    if (reg == nullptr)
        return;
    if (!m_controls.fields.inputError().isEmpty()) {
        m_controls.messages.showInputError([this] { return m_controls.fields.inputError(); });
        return;
    }
    // The result of the last move is not true of this one; a drag is one move.
    if (!std::exchange(m_isDragging, dragged) || !dragged)
        m_controls.result.clearNotices();
    session::MoveRequest request{device::exactValueText(raw, known->servo.meaning(*reg))};
    m_controls.fields.fill(request);
    request.how = m_controls.send.method();
    request.dragged = dragged;
    if (m_motion.move(request) && request.how != MoveMethod::Async)
        m_controls.goal.setPending(raw);
}

void GoalSender::onMoveSent(const session::MoveRequest& request)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg = goalRegister(known);
    if (reg == nullptr)
        return;
    const base::Duration now = m_registry.now();
    m_controls.fields.setSent(request, now);
    const auto raw = catalog::parseValue(request.goal, *reg, known->servo.meaning(*reg));
    if (raw && request.how != MoveMethod::Async)
        m_controls.goal.setSent(*raw, now);
    m_controls.messages.hideMessage();
    Q_EMIT controlsChanged();
}
} // namespace ui
