// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/close_confirmation.h"

#include "ui/widgets/question_dialog.h"

#include <algorithm>

namespace ui {
using session::MotionOnClose;
using session::MovingServo;

CloseConfirmation::CloseConfirmation(session::Desk& desk, QWidget* window)
    : QObject(window)
    , m_desk(desk)
    , m_window(window)
{
    connect(&desk, &session::Desk::motionDetected, this, &CloseConfirmation::handleMotion);
    connect(&desk, &session::Desk::openWritesFound, this, &CloseConfirmation::confirmOpenWrites);
}

void CloseConfirmation::disconnectPort()
{
    requestClose(CloseTarget::Disconnect);
}

void CloseConfirmation::closeWindow()
{
    requestClose(CloseTarget::Close);
}

void CloseConfirmation::requestClose(CloseTarget target)
{
    if (m_target) // it is being asked already
        return;
    m_target = target;
    m_lock = session::LockOnClose::CloseOrKeepOpen;
    if (const auto holds = m_desk.testHoldsTorque())
        confirmTest(*holds);
    else
        proceed();
}

void CloseConfirmation::confirmTest(bool holds)
{
    const bool closes = m_target == CloseTarget::Close;
    Question question;
    question.title = closes ? tr("A test is running. Stop it and close?")
                            : tr("A test is running. Stop it and disconnect?");
    question.text = holds ? tr("Its servos then hold their position with torque on.")
                          : tr("Its servos then have no torque.");
    question.acceptText = closes ? tr("Stop and close") : tr("Stop and disconnect");
    question.acceptIsDefault = true;
    question.guard = this;
    question.rejected = [this] { m_target.reset(); };
    ask(m_window, question, [this] { proceed(); });
}

void CloseConfirmation::proceed()
{
    m_desk.findOpenWrites();
}

/// Without them there is no question.
void CloseConfirmation::confirmOpenWrites(const session::OpenWrites& found)
{
    if (!m_target)
        return;
    QStringList ids;
    for (const int id : found.ids)
        ids << QString::number(id);
    QStringList open;
    for (const session::ServoRef ref : found.unlocked)
        open << QString::number(m_desk.servo(ref)->servo.id);
    if (ids.isEmpty() && open.isEmpty()) {
        confirmMotion();
        return;
    }
    const bool closes = m_target == CloseTarget::Close;
    const bool connected = m_desk.state() == session::LinkState::Open;
    Question question;
    question.title = closes ? tr("A write is unfinished. Close anyway?")
                            : tr("A write is unfinished. Disconnect anyway?");
    if (!ids.isEmpty())
        question.text = tr("ID %1: the journal still holds the unfinished write. The next "
                           "connection offers to finish or undo it.")
                            .arg(ids.join(QStringLiteral(", ")));
    question.acceptText = closes ? tr("Close") : tr("Disconnect");
    if (!open.isEmpty()) {
        const QString which = open.join(QStringLiteral(", "));
        question.risk =
            connected ? tr("The EPROM lock of ID %1 is open. It is closed first.").arg(which)
                      : tr("The EPROM lock of ID %1 is open and cannot be closed now.").arg(which);
    }
    if (!found.unlockedElsewhere.isEmpty()) {
        const QString more =
            tr("The EPROM lock of the servo with ID %1 was opened and has not been proven "
               "closed.")
                .arg(found.unlockedElsewhere.join(QStringLiteral(", ")));
        question.risk += question.risk.isEmpty() ? more : QLatin1Char(' ') + more;
    }
    if (!open.isEmpty() && connected) {
        question.acceptText = closes ? tr("Lock and close") : tr("Lock and disconnect");
        question.alternativeText = tr("Leave it open");
        question.alternativeToolTip =
            tr("The EPROM lock stays open: settings written by any program are "
               "kept at power-off.");
    }
    question.acceptIsDefault = true;
    question.guard = this;
    question.alternativeAction = [this] {
        m_lock = session::LockOnClose::LeaveOpen;
        confirmMotion();
    };
    question.rejected = [this] { m_target.reset(); };
    ask(m_window, question, [this] { confirmMotion(); });
}

void CloseConfirmation::confirmMotion()
{
    if (m_desk.state() == session::LinkState::Open)
        m_desk.detectMotion();
    else
        close(MotionOnClose::Stop);
}

void CloseConfirmation::handleMotion(const std::vector<MovingServo>& moving)
{
    if (!m_target)
        return;
    QStringList ids;
    for (const MovingServo& one : moving) {
        if (const session::ServoEntry* servo = m_desk.servo(one.servo))
            ids << QString::number(servo->servo.id);
    }
    if (ids.isEmpty()) {
        close(MotionOnClose::StopOrKeepOpen); // one may have begun to move since
        return;
    }
    const bool closes = m_target == CloseTarget::Close;
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
    question.acceptText = closes ? tr("Stop and close") : tr("Stop and disconnect");
    question.alternativeText = one ? tr("Leave it turning") : tr("Leave them turning");
    question.alternativeToolTip = question.risk;
    question.acceptIsDefault = true;
    question.guard = this;
    question.alternativeAction = [this] { close(MotionOnClose::LeaveMoving); };
    question.rejected = [this] { m_target.reset(); };
    ask(m_window, question, [this] { close(MotionOnClose::StopOrKeepOpen); });
}

void CloseConfirmation::close(MotionOnClose how)
{
    const CloseTarget target = m_target.value_or(CloseTarget::Disconnect);
    m_target.reset();
    if (target == CloseTarget::Close)
        m_desk.closeForExit(how, m_lock);
    else
        m_desk.disconnectFrom(how, m_lock);
}
} // namespace ui
