// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/control_panel.h"

#include "device/write_access.h"
#include "text/error_words.h"
#include "ui/app/theme.h"
#include "ui/pages/control_fields.h"
#include "ui/pages/control_goal.h"
#include "ui/pages/control_hint.h"
#include "ui/pages/control_limit.h"
#include "ui/pages/control_mode.h"
#include "ui/pages/control_torque.h"
#include "ui/widgets/banner.h"

#include <QButtonGroup>
#include <QLabel>
#include <QPushButton>

namespace ui {
using device::GoalKind;
using device::MoveHow;

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

std::size_t ControlPanel::others() const
{
    return m_drive.servos().empty() ? 0 : m_drive.servos().size() - 1;
}

void ControlPanel::choose()
{
    m_drive.setServos(m_selection.chosen());
    m_banner->clear();
    unsay();
    m_said->setMinimumHeight(0);
    m_hint->dismiss();
    if (isVisible())
        readUnread();
    m_chosenAnew = true;
    refresh();
}

/// Limits and modes belong on the panel; nobody needs them while it is not seen.
void ControlPanel::readUnread()
{
    for (const session::ServoRef ref : m_drive.servos()) {
        const session::ServoEntry* known = m_desk.servo(ref);
        const bool unread = known != nullptr && known->servo.profile && !known->tableRead;
        if (unread && m_desk.state() == session::LinkState::Open)
            m_desk.readTable(ref);
    }
}

void ControlPanel::refreshSoon()
{
    if (!m_refresh.isActive())
        m_refresh.start();
}

/// Why there is nothing to control; empty: there is.
QString ControlPanel::whyEmpty() const
{
    const session::ServoEntry* known = entry();
    if (known == nullptr)
        return tr("Choose a servo at the left. Choosing it moves nothing.");
    if (!known->servo.profile)
        return tr("This servo answers, but does not say what it is, so nobody knows how to move "
                  "it. Search again, or check whether two servos share the ID.");
    if (known->servo.profile->conflict) {
        const auto bar = device::writeBar(known->servo);
        const text::Description words = text::describe(*bar);
        return words.what + QLatin1Char('\n') + words.cause + QLatin1Char('\n') + words.remedy;
    }
    if (!known->servo.profile->writable)
        return tr("The firmware of this servo is not known. Its measurements are shown; moving it "
                  "could do damage. A model file makes it possible.");
    if (known->servo.mode() == nullptr)
        return known->readError ? tr("The settings of this servo could not be read.")
                                : tr("Reading the settings of this servo…");
    return {};
}

bool ControlPanel::usable() const
{
    return m_desk.state() == session::LinkState::Open;
}

void ControlPanel::refresh()
{
    const QString why = whyEmpty();
    if (m_empty->text() != why)
        m_empty->setText(why);
    m_empty->setVisible(!why.isEmpty());
    m_content->setVisible(why.isEmpty());
    showTitle();
    const session::ServoEntry* known = entry();
    m_torque->showServo(why.isEmpty() ? known : nullptr, usable());
    showStopped();
    if (m_meant && !isStill(*m_meant))
        m_hint->dismiss();
    if (!why.isEmpty()) {
        Q_EMIT shownAnew();
        return;
    }
    const bool drives = usable() && !m_drive.stopped();
    if (!m_drive.busy())
        m_goal->endSending();
    m_mode->showServo(known, usable());
    m_goal->showServo(*known, {m_drive.stepSum(known->ref), m_drive.canRepeat()});
    m_fields->showServo(*known, others() > 0);
    m_limit->showServo(known, usable());
    m_goal->setEnabled(drives);
    m_fields->setEnabled(drives);
    if (m_dial != nullptr)
        m_dial->setVisible(device::goalRegister(known->servo) != nullptr);
    showWrite();
    Q_EMIT shownAnew();
}

void ControlPanel::showTitle()
{
    const session::ServoEntry* known = entry();
    QString words = tr("Motion");
    if (known != nullptr) {
        words = tr("Motion — ID %1").arg(known->servo.id);
        if (known->servo.profile)
            words += QStringLiteral(" · ") + known->servo.profile->modelName;
        if (others() > 0)
            words += QLatin1Char(' ') + tr("+ %1 more").arg(others());
    }
    if (m_title->text() != words)
        m_title->setText(words);
}

void ControlPanel::showStopped()
{
    const bool stopped = m_drive.stopped() && entry() != nullptr;
    m_stopped->setVisible(stopped);
    const bool stillOn = stopped && isOnSinceStop(*entry());
    m_stopped->setText(QStringLiteral("■ ") +
                       (stillOn ? tr("Stopped, but torque is on. Press Esc to switch it off.")
                                : tr("Stopped. Switch torque on to go on.")));
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, tone(Tone::Warn, palette()));
    m_stopped->setPalette(colours);
}

void ControlPanel::showWrite()
{
    const session::ServoEntry* known = entry();
    if (known == nullptr || !known->servo.profile)
        return;
    const bool step = device::goalKind(known->servo) == GoalKind::Step;
    const bool drives = usable() && !m_drive.stopped();
    for (const MoveHow one : {MoveHow::Write, MoveHow::Sync, MoveHow::Async}) {
        const bool offered = device::offers(known->servo, one);
        m_how->button(static_cast<int>(one))->setVisible(offered);
        if (!offered && how() == one)
            m_how->button(0)->setChecked(true);
    }
    chooseHow(*known);
    const bool async = device::offers(known->servo, MoveHow::Async);
    m_execute->setVisible(async || m_drive.held() > 0);
    m_execute->setEnabled(drives && m_drive.held() > 0);
    m_execute->setText(m_drive.held() > 0 ? tr("Execute (%1)").arg(m_drive.held()) : tr("Execute"));
    m_execute->setAccessibleName(m_execute->text());
    m_set->setVisible(!step);
    m_set->setEnabled(drives);
}

/// Several start together unless the user says otherwise; one alone goes back to the plain write.
void ControlPanel::chooseHow(const session::ServoEntry& known)
{
    if (!m_chosenAnew || known.servo.mode() == nullptr)
        return;
    m_chosenAnew = false;
    const bool several = others() > 0;
    if (several && how() == MoveHow::Write && device::offers(known.servo, MoveHow::Sync))
        m_how->button(static_cast<int>(MoveHow::Sync))->setChecked(true);
    else if (!several && how() == MoveHow::Sync)
        m_how->button(static_cast<int>(MoveHow::Write))->setChecked(true);
}

MoveHow ControlPanel::how() const
{
    return static_cast<MoveHow>(std::max(0, m_how->checkedId()));
}

void ControlPanel::goalArrived(const session::MoveWish& wish)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg =
        known != nullptr && known->servo.profile ? device::goalRegister(known->servo) : nullptr;
    if (reg == nullptr)
        return;
    const base::Duration now = m_desk.now();
    m_fields->wasSent(wish, now);
    const auto raw = catalog::parseValue(wish.goal, *reg, known->servo.meaning(*reg));
    if (raw && wish.how != MoveHow::Async)
        m_goal->wasSent(*raw, now);
    m_banner->clear();
    refreshSoon();
}

std::optional<std::int64_t> ControlPanel::placeGoal() const
{
    const session::ServoEntry* known = entry();
    const auto kind =
        known != nullptr && known->servo.profile ? device::goalKind(known->servo) : std::nullopt;
    const bool place = kind == GoalKind::Position || kind == GoalKind::Turns;
    return place ? m_goal->shown() : std::nullopt;
}

bool ControlPanel::goalMovable() const
{
    return placeGoal() && m_goal->isEnabled() && whyEmpty().isEmpty();
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
        auto* button = m_how->button(i);
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
    showSaid();
    refresh();
}
} // namespace ui
