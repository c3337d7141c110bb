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
    connect(&desk, &session::Desk::unfinishedFound, this, &LeaveQuestion::askAboutWrites);
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
    m_lock = session::LockAtClose::CloseOrStay;
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
    m_desk.findUnfinished();
}

/// Without them there is no question.
void LeaveQuestion::askAboutWrites(const session::UnfinishedWrites& found)
{
    if (!m_way)
        return;
    QStringList ids;
    for (const int id : found.ids)
        ids << QString::number(id);
    QStringList open;
    for (const session::ServoRef ref : found.unlocked)
        open << QString::number(m_desk.servo(ref)->servo.id);
    if (ids.isEmpty() && open.isEmpty()) {
        askAboutMotion();
        return;
    }
    const bool closes = m_way == Way::Close;
    const bool connected = m_desk.state() == session::LinkState::Open;
    Question question;
    question.title = closes ? tr("A write is unfinished. Close anyway?")
                            : tr("A write is unfinished. Disconnect anyway?");
    if (!ids.isEmpty())
        question.text = tr("ID %1: the journal still holds the unfinished write. The next "
                           "connection offers to finish or undo it.")
                            .arg(ids.join(QStringLiteral(", ")));
    question.yes = closes ? tr("Close") : tr("Disconnect");
    if (!open.isEmpty()) {
        const QString which = open.join(QStringLiteral(", "));
        question.risk =
            connected ? tr("The EPROM lock of ID %1 is open. It is closed first.").arg(which)
                      : tr("The EPROM lock of ID %1 is open and cannot be closed now.").arg(which);
    }
    if (!found.openElsewhere.isEmpty()) {
        const QString more =
            tr("The EPROM lock of the servo with ID %1 was opened and has not been proven "
               "closed.")
                .arg(found.openElsewhere.join(QStringLiteral(", ")));
        question.risk += question.risk.isEmpty() ? more : QLatin1Char(' ') + more;
    }
    if (!open.isEmpty() && connected) {
        question.yes = closes ? tr("Lock and close") : tr("Lock and disconnect");
        question.other = tr("Leave it open");
        question.otherTip = tr("The EPROM lock stays open: settings written by any program are "
                               "kept at power-off.");
    }
    question.harmless = true;
    question.guard = this;
    question.otherwise = [this] {
        m_lock = session::LockAtClose::LeaveOpen;
        askAboutMotion();
    };
    question.refused = [this] { m_way.reset(); };
    ask(m_window, question, [this] { askAboutMotion(); });
}

void LeaveQuestion::askAboutMotion()
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
        m_desk.close(how, m_lock);
    else
        m_desk.disconnectFrom(how, m_lock);
}
} // namespace ui
