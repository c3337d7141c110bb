// SPDX-License-Identifier: GPL-3.0-or-later
// What the control panel orders, what it asks before, and what it says afterwards.
#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "ui/common/theme.h"
#include "ui/editors/register_text.h"
#include "ui/operate/control_fields.h"
#include "ui/operate/control_goal.h"
#include "ui/operate/control_panel.h"
#include "ui/operate/control_text.h"
#include "ui/operate/torque_hint.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/question_dialog.h"

#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace ui {
using catalog::Role;
using device::GoalKind;
using device::MoveMethod;
using device::NoticeCode;

namespace {
/// What somebody at the bench must see, beside what only tells how it was done.
bool warns(const device::Notice& notice)
{
    switch (notice.code) {
    case NoticeCode::OverloadActive:
    case NoticeCode::OvercurrentActive:
    case NoticeCode::VoltageAlarmActive:
    case NoticeCode::TemperatureAlarmActive:
    case NoticeCode::SensorAlarmActive:
    case NoticeCode::DerivedTemperature:
    case NoticeCode::DerivedVoltage:
    case NoticeCode::CurrentLimitZero:
    case NoticeCode::LockLeftOpen:
        return true;
    default:
        return false;
    }
}

/// Registers are called by their names, not by their keys.
QString linesOf(const catalog::ProfilePtr& profile, const device::Notices& notices, bool warning)
{
    QStringList lines;
    for (device::Notice notice : notices) {
        if (warns(notice) != warning)
            continue;
        const catalog::Register* reg = profile ? profile->find(notice.key) : nullptr;
        if (reg != nullptr)
            notice.key = reg->name.in(text::isUiChinese());
        lines << text::describe(notice);
    }
    lines.removeDuplicates();
    return lines.join(QLatin1Char('\n'));
}
} // namespace

/// The chosen servos, and their modes as far as they are known.
ControlPanel::HintTargets ControlPanel::currentTargets() const
{
    HintTargets targets;
    for (const session::ServoRef ref : m_motion.servos()) {
        const session::ServoEntry* known = m_desk.servo(ref);
        const catalog::Mode* mode =
            known != nullptr && known->servo.profile ? known->servo.mode() : nullptr;
        targets.push_back({ref, mode != nullptr ? mode->key : QString()});
    }
    return targets;
}

/// A mode that was not known yet when it was asked for is no other mode.
bool ControlPanel::isUnchanged(const HintTargets& targets) const
{
    const HintTargets now = currentTargets();
    return isUsable() &&
           std::equal(targets.begin(), targets.end(), now.begin(), now.end(),
                      [](const auto& before, const auto& after) {
                          return before.first == after.first &&
                                 (before.second.isEmpty() || before.second == after.second);
                      });
}

/// The same number is a place in one mode and a speed in another: what waits for an answer is done
/// only in the modes it was meant for.
bool ControlPanel::confirmHint(std::function<void()> action)
{
    HintTargets targets = currentTargets();
    const bool isConfirmed = m_hint->isConfirmed([this, targets, action = std::move(action)] {
        if (action && isUnchanged(targets))
            action();
    });
    if (!isConfirmed)
        m_hintTargets = std::move(targets);
    return isConfirmed;
}

/// False: the hint is shown first. A servo that has torque already has been energised knowingly.
bool ControlPanel::confirmEnergize(std::function<void()> action)
{
    for (const session::ServoRef ref : m_motion.servos()) {
        const session::ServoEntry* known = m_desk.servo(ref);
        if (known != nullptr && known->servo.profile && known->servo.raw(Role::TorqueSwitch) == 1)
            continue;
        return confirmHint(std::move(action));
    }
    return true;
}

void ControlPanel::setGoalFromDial(std::int64_t raw)
{
    if (!isGoalMovable())
        return;
    m_dialDragTimer.start();
    m_goal->setFromDial(raw);
}

/// Held writes are not sent while dragging: Set leaves one goal, not a hundred.
void ControlPanel::dragTo(std::int64_t raw, bool dragged)
{
    if (writeMode() == MoveMethod::Async) {
        m_goal->enterValue(raw);
        return;
    }
    // Nobody asked for the way to the place where the hint was answered.
    if (!confirmEnergize({})) {
        m_goal->cancelDrag();
        scheduleRefresh();
        return;
    }
    sendGoal(raw, dragged);
}

void ControlPanel::sendGoalFromField()
{
    const session::ServoEntry* known = entry();
    if (known == nullptr || !m_set->isEnabled())
        return;
    const auto raw = m_goal->goal();
    if (!raw) {
        showInputError([this] { return m_goal->inputError(); });
        return;
    }
    if (device::goalKind(known->servo) == GoalKind::Step) {
        step(*raw);
        return;
    }
    if (confirmEnergize([this, goal = *raw] { sendGoal(goal, false); }))
        sendGoal(*raw, false);
}

void ControlPanel::step(std::int64_t raw)
{
    if (confirmEnergize([this, raw] { sendGoal(raw, false); }))
        sendGoal(raw, false);
}

void ControlPanel::sendGoal(std::int64_t raw, bool dragged)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg =
        known != nullptr && known->servo.profile ? device::goalRegister(known->servo) : nullptr;
    if (reg == nullptr)
        return;
    if (!m_fields->inputError().isEmpty()) {
        showInputError([this] { return m_fields->inputError(); });
        return;
    }
    // What was said about the last move is not true of this one. In a drag it is told once.
    if (!std::exchange(m_isDragging, dragged) || !dragged)
        clearResult();
    session::MoveRequest request{device::exactValueText(raw, known->servo.meaning(*reg))};
    m_fields->fill(request);
    request.how = writeMode();
    request.dragged = dragged;
    if (m_motion.move(request) && request.how != MoveMethod::Async)
        m_goal->setPending(raw);
}

void ControlPanel::requestTorque(device::Torque torque)
{
    const auto action = [this, torque] {
        clearResult();
        m_motion.setTorque(torque);
    };
    m_banner->hideMessage();
    if (torque != device::Torque::On || confirmHint(action))
        action();
}

void ControlPanel::stopMove()
{
    m_hint->dismiss();
    clearResult();
    m_motion.halt();
}

void ControlPanel::confirmModeSwitch(const device::ModePlan& plan)
{
    const session::ServoEntry* known = entry();
    if (known == nullptr || !known->servo.profile || plan.writes.empty())
        return;
    const catalog::Mode* mode = known->servo.profile->mode(plan.to);
    if (mode == nullptr)
        return;
    Question question;
    question.title = tr("Switch ID %1 to \"%2\"?").arg(known->servo.id).arg(modeTitle(*mode));
    question.text = modePlanText(plan, *known->servo.profile, static_cast<int>(otherCount()));
    question.acceptText = tr("Switch");
    question.guard = this;
    ask(this, question, [this, ref = known->ref, to = plan.to] {
        if (m_selection.current() != ref)
            return;
        m_hint->dismiss();
        clearResult();
        m_motion.switchMode(to);
    });
}

void ControlPanel::showError(const base::Error& error)
{
    m_goal->cancelDrag();
    m_goal->clearSent();
    const session::ServoEntry* known = entry();
    const auto profile = known != nullptr ? known->servo.profile : nullptr;
    m_banner->showMessage([error, profile] {
        const catalog::Register* reg = profile ? profile->find(error.registerKey) : nullptr;
        const text::Description words = text::describe(withName(error, reg));
        return BannerText{Tone::Bad, words.message, words.cause, words.remedy};
    });
    scheduleRefresh();
}

void ControlPanel::showNotices(const device::Notices& notices)
{
    const session::ServoEntry* known = entry();
    m_resultProfile = known != nullptr ? known->servo.profile : nullptr;
    m_notices = notices;
    if (!linesOf(m_resultProfile, notices, true).isEmpty()) {
        m_banner->showMessage([profile = m_resultProfile, notices] {
            return BannerText{Tone::Warn, linesOf(profile, notices, true)};
        });
    }
    showResult();
}

void ControlPanel::showResult()
{
    const QString resultText = linesOf(m_resultProfile, m_notices, false);
    m_resultLabel->setText(resultText);
    if (!resultText.isEmpty())
        reserveResultHeight();
}

/// Its room stays when it goes: a panel that is scrolled to its end would shift otherwise.
void ControlPanel::reserveResultHeight()
{
    const int needed = m_resultLabel->heightForWidth(m_resultLabel->width());
    m_resultLabel->setMinimumHeight(std::max(m_resultLabel->minimumHeight(), needed));
}

void ControlPanel::clearResult()
{
    m_notices.clear();
    showResult();
}

/// What has been put right meanwhile has no words any more: the last ones stay.
void ControlPanel::showInputError(const std::function<QString()>& wrong)
{
    m_banner->showMessage([wrong, last = QString()]() mutable {
        if (const QString words = wrong(); !words.isEmpty())
            last = words;
        return BannerText{Tone::Warn, last};
    });
}
} // namespace ui
