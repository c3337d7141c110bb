// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_panel.h"

#include "device/write_access.h"
#include "text/error_text.h"
#include "ui/common/theme.h"
#include "ui/operate/control_fields.h"
#include "ui/operate/control_goal.h"
#include "ui/operate/control_limit.h"
#include "ui/operate/control_mode.h"
#include "ui/operate/control_torque.h"
#include "ui/operate/torque_hint.h"
#include "ui/widgets/banner.h"

#include <QButtonGroup>
#include <QLabel>
#include <QPushButton>

namespace ui {
using device::GoalKind;
using device::MoveMethod;

namespace {
/// The stop did not reach it, or another program has switched it on again.
bool isOnSinceStop(const session::ServoEntry& known)
{
    const catalog::Register* torque =
        known.servo.profile ? known.servo.profile->byRole(catalog::Role::TorqueSwitch) : nullptr;
    const auto at = torque != nullptr ? known.servo.image.readAt(torque->offset) : std::nullopt;
    return at && *at > known.stoppedAt && known.servo.raw(*torque) == 1;
}
} // namespace

const session::ServoEntry* ControlPanel::entry() const
{
    return m_desk.servo(m_selection.current());
}

std::size_t ControlPanel::otherCount() const
{
    return m_motion.servos().empty() ? 0 : m_motion.servos().size() - 1;
}

void ControlPanel::onSelectionChanged()
{
    m_motion.setServos(m_selection.selected());
    m_banner->hideMessage();
    clearResult();
    m_resultLabel->setMinimumHeight(0);
    m_hint->dismiss();
    if (isVisible())
        readUnreadTables();
    m_selectionChanged = true;
    refresh();
}

/// Limits and modes belong on the panel; nobody needs them while it is not seen.
void ControlPanel::readUnreadTables()
{
    for (const session::ServoRef ref : m_motion.servos()) {
        const session::ServoEntry* known = m_desk.servo(ref);
        const bool unread = known != nullptr && known->servo.profile && !known->hasFullTable;
        if (unread && m_desk.state() == session::LinkState::Open)
            m_desk.readTable(ref);
    }
}

void ControlPanel::scheduleRefresh()
{
    if (!m_refresh.isActive())
        m_refresh.start();
}

/// Why there is nothing to control; empty: there is.
QString ControlPanel::emptyReason() const
{
    const session::ServoEntry* known = entry();
    if (known == nullptr)
        return tr("Choose a servo at the left. Choosing it moves nothing.");
    if (!known->servo.profile)
        return tr("This servo answers, but does not say what it is, so nobody knows how to move "
                  "it. Search again, or check whether two servos share the ID.");
    if (known->servo.profile->conflict) {
        const auto bar = device::writeObstacle(known->servo);
        const text::Description words = text::describe(*bar);
        return words.message + QLatin1Char('\n') + words.cause + QLatin1Char('\n') + words.remedy;
    }
    if (!known->servo.profile->writable)
        return tr("The firmware of this servo is not known. Its measurements are shown; moving it "
                  "could do damage. A model file makes it possible.");
    if (known->servo.mode() == nullptr)
        return known->readError ? tr("The settings of this servo could not be read.")
                                : tr("Reading the settings of this servo…");
    return {};
}

bool ControlPanel::isUsable() const
{
    return m_desk.state() == session::LinkState::Open;
}

void ControlPanel::refresh()
{
    const QString why = emptyReason();
    if (m_empty->text() != why)
        m_empty->setText(why);
    m_empty->setVisible(!why.isEmpty());
    m_content->setVisible(why.isEmpty());
    showTitle();
    const session::ServoEntry* known = entry();
    m_torque->showServo(why.isEmpty() ? known : nullptr, isUsable());
    showStopped();
    if (m_hintTargets && !isUnchanged(*m_hintTargets))
        m_hint->dismiss();
    if (!why.isEmpty()) {
        Q_EMIT goalStateChanged();
        return;
    }
    const bool drives = isUsable() && !m_motion.isStopped();
    if (!m_motion.isBusy())
        m_goal->clearPending();
    m_mode->showServo(known, isUsable());
    m_goal->showServo(*known, {m_motion.totalSteps(known->ref), m_motion.canRepeatStep()});
    m_fields->showServo(*known, otherCount() > 0);
    m_limit->showServo(known, isUsable());
    m_goal->setEnabled(drives);
    m_fields->setEnabled(drives);
    if (m_dial != nullptr)
        m_dial->setVisible(device::goalRegister(known->servo) != nullptr);
    showWrite();
    Q_EMIT goalStateChanged();
}

void ControlPanel::showTitle()
{
    const session::ServoEntry* known = entry();
    QString words = tr("Motion");
    if (known != nullptr) {
        words = tr("Motion — ID %1").arg(known->servo.id);
        if (known->servo.profile)
            words += QStringLiteral(" · ") + known->servo.profile->modelName;
        if (otherCount() > 0)
            words += QLatin1Char(' ') + tr("+ %1 more").arg(otherCount());
    }
    if (m_title->text() != words)
        m_title->setText(words);
}

void ControlPanel::showStopped()
{
    const bool stopped = m_motion.isStopped() && entry() != nullptr;
    m_stopped->setVisible(stopped);
    const bool stillOn = stopped && isOnSinceStop(*entry());
    m_stopped->setText(QStringLiteral("■ ") +
                       (stillOn ? tr("Stopped, but torque is on. Press Esc to switch it off.")
                                : tr("Stopped. Switch torque on to go on.")));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(Tone::Warn, palette()));
    m_stopped->setPalette(colors);
}

void ControlPanel::showWrite()
{
    const session::ServoEntry* known = entry();
    if (known == nullptr || !known->servo.profile)
        return;
    const bool step = device::goalKind(known->servo) == GoalKind::Step;
    const bool drives = isUsable() && !m_motion.isStopped();
    for (const MoveMethod one : {MoveMethod::Write, MoveMethod::Sync, MoveMethod::Async}) {
        const bool offered = device::supports(known->servo, one);
        m_writeMode->button(static_cast<int>(one))->setVisible(offered);
        if (!offered && writeMode() == one)
            m_writeMode->button(0)->setChecked(true);
    }
    selectWriteMode(*known);
    const bool async = device::supports(known->servo, MoveMethod::Async);
    m_execute->setVisible(async || m_motion.heldCount() > 0);
    m_execute->setEnabled(drives && m_motion.heldCount() > 0);
    m_execute->setText(m_motion.heldCount() > 0 ? tr("Execute (%1)").arg(m_motion.heldCount())
                                                : tr("Execute"));
    m_execute->setAccessibleName(m_execute->text());
    m_set->setVisible(!step);
    m_set->setEnabled(drives);
}

/// Several start together unless the user says otherwise; one alone goes back to the plain write.
void ControlPanel::selectWriteMode(const session::ServoEntry& known)
{
    if (!m_selectionChanged || known.servo.mode() == nullptr)
        return;
    m_selectionChanged = false;
    const bool several = otherCount() > 0;
    if (several && writeMode() == MoveMethod::Write &&
        device::supports(known.servo, MoveMethod::Sync))
        m_writeMode->button(static_cast<int>(MoveMethod::Sync))->setChecked(true);
    else if (!several && writeMode() == MoveMethod::Sync)
        m_writeMode->button(static_cast<int>(MoveMethod::Write))->setChecked(true);
}

MoveMethod ControlPanel::writeMode() const
{
    return static_cast<MoveMethod>(std::max(0, m_writeMode->checkedId()));
}

void ControlPanel::onGoalSent(const session::MoveRequest& request)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg =
        known != nullptr && known->servo.profile ? device::goalRegister(known->servo) : nullptr;
    if (reg == nullptr)
        return;
    const base::Duration now = m_desk.now();
    m_fields->setSent(request, now);
    const auto raw = catalog::parseValue(request.goal, *reg, known->servo.meaning(*reg));
    if (raw && request.how != MoveMethod::Async)
        m_goal->setSent(*raw, now);
    m_banner->hideMessage();
    scheduleRefresh();
}

std::optional<std::int64_t> ControlPanel::positionGoal() const
{
    const session::ServoEntry* known = entry();
    const auto kind =
        known != nullptr && known->servo.profile ? device::goalKind(known->servo) : std::nullopt;
    const bool place = kind == GoalKind::Position || kind == GoalKind::Turns;
    return place ? m_goal->shownGoal() : std::nullopt;
}

bool ControlPanel::isGoalMovable() const
{
    return positionGoal() && m_goal->isEnabled() && emptyReason().isEmpty();
}

void ControlPanel::retranslate()
{
    setAccessibleName(tr("Control"));
    showStopped();
    static const std::array words{
        std::pair{QT_TR_NOOP("Write"), QT_TR_NOOP("One servo after the other, each acknowledged")},
        std::pair{QT_TR_NOOP("Sync"),
                  QT_TR_NOOP("One packet for all chosen servos: they start together")},
        std::pair{QT_TR_NOOP("Async"), QT_TR_NOOP("The goal waits in the servo until Execute")}};
    for (int i = 0; i < 3; ++i) {
        auto* button = m_writeMode->button(i);
        button->setText(tr(words[static_cast<std::size_t>(i)].first));
        button->setAccessibleName(button->text());
        button->setToolTip(tr(words[static_cast<std::size_t>(i)].second));
    }
    m_execute->setAccessibleName(tr("Execute"));
    m_execute->setToolTip(tr("Starts all goals that wait in servos"));
    m_set->setText(tr("Set"));
    m_set->setAccessibleName(m_set->text());
    m_set->setToolTip(tr("Sends goal and changed fields"));
    m_torque->retranslate();
    m_mode->retranslate();
    m_goal->retranslate();
    m_fields->retranslate();
    m_limit->retranslate();
    m_hint->retranslate();
    showResult();
    refresh();
}
} // namespace ui
