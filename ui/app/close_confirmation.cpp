// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/close_confirmation.h"

#include "text/language.h"
#include "ui/widgets/question_dialog.h"

#include <algorithm>

namespace ui {
using session::MotionOnClose;
using session::MovingServo;

CloseConfirmation::CloseConfirmation(session::Workbench& workbench, QWidget* window)
    : QObject(window)
    , m_workbench(workbench)
    , m_window(window)
{
    connect(&workbench.closing(), &session::CloseSequence::motionDetected, this,
            &CloseConfirmation::handleMotion);
    connect(&workbench.closing(), &session::CloseSequence::openWritesFound, this,
            &CloseConfirmation::confirmOpenWrites);
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
    if (const auto holds = m_workbench.tasks().testHoldsTorque())
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
    question.text = holds ? tr("The servos will then hold their position with torque on.")
                          : tr("Torque will then be turned off.");
    question.acceptText = closes ? tr("Stop and close") : tr("Stop and disconnect");
    question.acceptIsDefault = true;
    question.guard = this;
    question.rejected = [this] { m_target.reset(); };
    ask(m_window, question, [this] { proceed(); });
}

void CloseConfirmation::proceed()
{
    m_workbench.closing().findOpenWrites();
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
        open << QString::number(m_workbench.registry().servo(ref)->servo.id);
    if (ids.isEmpty() && open.isEmpty()) {
        confirmMotion();
        return;
    }
    Question question = openWritesQuestion(ids, open, found.unlockedElsewhere);
    question.acceptIsDefault = true;
    question.guard = this;
    question.alternativeAction = [this] {
        m_lock = session::LockOnClose::LeaveOpen;
        confirmMotion();
    };
    question.rejected = [this] { m_target.reset(); };
    ask(m_window, question, [this] { confirmMotion(); });
}

/// `open`: IDs of servos in the list whose EPROM is unlocked; `openElsewhere`: of other servos.
Question CloseConfirmation::openWritesQuestion(const QStringList& ids, const QStringList& open,
                                               const QStringList& openElsewhere) const
{
    const bool closes = m_target == CloseTarget::Close;
    const bool connected = m_workbench.link().state() == session::LinkState::Open;
    Question question;
    question.title = closes ? tr("A write is unfinished. Close anyway?")
                            : tr("A write is unfinished. Disconnect anyway?");
    if (!ids.isEmpty())
        question.text = tr("ID %1: the unfinished write is recorded in the journal. The next time "
                           "you connect, ServoDesk will offer to finish or undo it.")
                            .arg(text::joinItems(ids));
    question.acceptText = closes ? tr("Close") : tr("Disconnect");
    if (!open.isEmpty()) {
        const QString which = text::joinItems(open);
        question.risk =
            connected ? tr("The EPROM of ID %1 is unlocked. It will be locked first.").arg(which)
                      : tr("The EPROM of ID %1 is unlocked and cannot be locked now.").arg(which);
    }
    if (!openElsewhere.isEmpty()) {
        const QString more = tr("The EPROM of the servo with ID %1 was unlocked, and ServoDesk "
                                "could not confirm that it was locked again.")
                                 .arg(text::joinItems(openElsewhere));
        question.risk = text::joinSentences({question.risk, more});
    }
    if (!open.isEmpty() && connected) {
        question.acceptText = closes ? tr("Lock and close") : tr("Lock and disconnect");
        question.alternativeText = tr("Leave unlocked");
        question.alternativeToolTip = tr("The EPROM stays unlocked, so settings written by any "
                                         "program are kept after power-off.");
    }
    return question;
}

void CloseConfirmation::confirmMotion()
{
    if (m_workbench.link().state() == session::LinkState::Open)
        m_workbench.closing().detectMotion();
    else
        close(MotionOnClose::Stop);
}

void CloseConfirmation::handleMotion(const std::vector<MovingServo>& moving)
{
    if (!m_target)
        return;
    QStringList ids;
    for (const MovingServo& one : moving) {
        if (const session::ServoEntry* servo = m_workbench.registry().servo(one.servo))
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
    const QString which = text::joinItems(ids);
    Question question;
    if (closes)
        question.title = one ? tr("Servo %1 is turning. Stop it before closing?").arg(which)
                             : tr("Servos %1 are turning. Stop them before closing?").arg(which);
    else
        question.title =
            one ? tr("Servo %1 is turning. Stop it before disconnecting?").arg(which)
                : tr("Servos %1 are turning. Stop them before disconnecting?").arg(which);
    question.text = tr("Once stopped, a servo keeps its torque on if it can hold its position.");
    question.risk = endless ? tr("If not stopped now, the servo will keep turning, and ServoDesk "
                                 "will no longer be able to stop it.")
                            : tr("If not stopped now, the servo will continue to its goal, and "
                                 "ServoDesk will no longer be able to stop it.");
    question.acceptText = closes ? tr("Stop and close") : tr("Stop and disconnect");
    question.alternativeText = tr("Do not stop");
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
        m_workbench.closing().closeForExit(how, m_lock);
    else
        m_workbench.closing().disconnectFrom(how, m_lock);
}
} // namespace ui
