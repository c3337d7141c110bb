// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/leave_question.h"

#include "ui/dialogs/ask.h"

#include <algorithm>

namespace ui {
using session::AtClose;
using session::MovingServo;

LeaveQuestion::LeaveQuestion(session::Desk& desk, QWidget* window)
    : QObject(window)
    , m_desk(desk)
    , m_window(window)
{
    connect(&desk, &session::Desk::motionFound, this, &LeaveQuestion::found);
}

void LeaveQuestion::disconnectPort()
{
    begin(Way::Disconnect);
}

void LeaveQuestion::closeWindow()
{
    begin(Way::Close);
}

void LeaveQuestion::begin(Way way)
{
    if (m_way) // it is being asked already
        return;
    m_way = way;
    if (const auto holds = m_desk.testHolds())
        askAboutTest(*holds);
    else
        proceed();
}

void LeaveQuestion::askAboutTest(bool holds)
{
    const bool closes = m_way == Way::Close;
    Question question;
    question.title = closes ? tr("A test is running. Stop it and close?")
                            : tr("A test is running. Stop it and disconnect?");
    question.text = holds ? tr("Its servos then hold their position with torque on.")
                          : tr("Its servos then have no torque.");
    question.yes = closes ? tr("Stop and close") : tr("Stop and disconnect");
    question.harmless = true;
    question.guard = this;
    question.refused = [this] { m_way.reset(); };
    ask(m_window, question, [this] { proceed(); });
}

void LeaveQuestion::proceed()
{
    if (m_desk.state() == session::LinkState::Open)
        m_desk.findMotion();
    else
        go(AtClose::Stop);
}

void LeaveQuestion::found(const std::vector<MovingServo>& moving)
{
    if (!m_way)
        return;
    QStringList ids;
    for (const MovingServo& one : moving) {
        if (const session::ServoEntry* servo = m_desk.servo(one.servo))
            ids << QString::number(servo->servo.id);
    }
    if (ids.isEmpty()) {
        go(AtClose::StopOrStay); // one may have begun to move since
        return;
    }
    const bool closes = m_way == Way::Close;
    const bool one = ids.size() == 1;
    const bool endless = std::any_of(moving.begin(), moving.end(),
                                     [](const MovingServo& servo) { return servo.endless; });
    const QString which = ids.join(QStringLiteral(", "));
    Question question;
    if (closes)
        question.title = one ? tr("Servo %1 is turning. Stop it before closing?").arg(which)
                             : tr("Servos %1 are turning. Stop them before closing?").arg(which);
    else
        question.title =
            one ? tr("Servo %1 is turning. Stop it before disconnecting?").arg(which)
                : tr("Servos %1 are turning. Stop them before disconnecting?").arg(which);
    question.text = tr("Stopping ends the motion; torque stays on where the servo can hold its "
                       "position.");
    question.risk = endless ? tr("Left turning, it does not stop by itself, and ServoDesk can no "
                                 "longer stop it.")
                            : tr("Left moving, it goes on to its goal, and ServoDesk can no longer "
                                 "stop it.");
    question.yes = closes ? tr("Stop and close") : tr("Stop and disconnect");
    question.other = one ? tr("Leave it turning") : tr("Leave them turning");
    question.otherTip = question.risk;
    question.harmless = true;
    question.guard = this;
    question.otherwise = [this] { go(AtClose::LeaveMoving); };
    question.refused = [this] { m_way.reset(); };
    ask(m_window, question, [this] { go(AtClose::StopOrStay); });
}

void LeaveQuestion::go(AtClose how)
{
    const Way way = m_way.value_or(Way::Disconnect);
    m_way.reset();
    if (way == Way::Close)
        m_desk.close(how);
    else
        m_desk.disconnectFrom(how);
}
} // namespace ui
