// SPDX-License-Identifier: GPL-3.0-or-later
// What the control panel orders, what it asks before, and what it says afterwards.
#include "text/error_words.h"
#include "text/language.h"
#include "text/notice_words.h"
#include "ui/app/theme.h"
#include "ui/dialogs/ask.h"
#include "ui/models/memory_words.h"
#include "ui/pages/control_fields.h"
#include "ui/pages/control_goal.h"
#include "ui/pages/control_hint.h"
#include "ui/pages/control_panel.h"
#include "ui/pages/control_words.h"
#include "ui/widgets/banner.h"

#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace ui {
using catalog::Role;
using device::GoalKind;
using device::MoveHow;
using device::NoticeCode;

namespace {
/// What somebody at the bench must see, beside what only tells how it was done.
bool warns(const device::Notice& notice)
{
    switch (notice.code) {
    case NoticeCode::OverloadHolds:
    case NoticeCode::OvercurrentHolds:
    case NoticeCode::VoltageHolds:
    case NoticeCode::TemperatureHolds:
    case NoticeCode::SensorHolds:
    case NoticeCode::DerivedTemperature:
    case NoticeCode::DerivedVoltage:
    case NoticeCode::NoCurrentAllowed:
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
            notice.key = reg->name.in(text::inChinese());
        lines << text::describe(notice);
    }
    lines.removeDuplicates();
    return lines.join(QLatin1Char('\n'));
}
} // namespace

/// The chosen servos, and their modes as far as they are known.
ControlPanel::Meant ControlPanel::meantNow() const
{
    Meant meant;
    for (const session::ServoRef ref : m_drive.servos()) {
        const session::ServoEntry* known = m_desk.servo(ref);
        const catalog::Mode* mode =
            known != nullptr && known->servo.profile ? known->servo.mode() : nullptr;
        meant.push_back({ref, mode != nullptr ? mode->key : QString()});
    }
    return meant;
}

/// A mode that was not known yet when it was asked for is no other mode.
bool ControlPanel::isStill(const Meant& meant) const
{
    const Meant now = meantNow();
    return usable() &&
           std::equal(meant.begin(), meant.end(), now.begin(), now.end(),
                      [](const auto& before, const auto& after) {
                          return before.first == after.first &&
                                 (before.second.isEmpty() || before.second == after.second);
                      });
}

/// The same number is a place in one mode and a speed in another: what waits for an answer is done
/// only in the modes it was meant for.
bool ControlPanel::passedHint(std::function<void()> deed)
{
    Meant meant = meantNow();
    const bool passed = m_hint->passed([this, meant, deed = std::move(deed)] {
        if (deed && isStill(meant))
            deed();
    });
    if (!passed)
        m_meant = std::move(meant);
    return passed;
}

/// False: the hint is shown first. A servo that has torque already has been energised knowingly.
bool ControlPanel::mayEnergise(std::function<void()> deed)
{
    for (const session::ServoRef ref : m_drive.servos()) {
        const session::ServoEntry* known = m_desk.servo(ref);
        if (known != nullptr && known->servo.profile && known->servo.raw(Role::TorqueSwitch) == 1)
            continue;
        return passedHint(std::move(deed));
    }
    return true;
}

void ControlPanel::setGoalFromDial(std::int64_t raw)
{
    if (!goalMovable())
        return;
    m_dialRest.start();
    m_goal->put(raw);
}

/// Held writes are not sent while dragging: Set leaves one goal, not a hundred.
void ControlPanel::dragTo(std::int64_t raw, bool dragged)
{
    if (how() == MoveHow::Async) {
        m_goal->type(raw);
        return;
    }
    // Nobody asked for the way to the place where the hint was answered.
    if (!mayEnergise({})) {
        m_goal->giveUp();
        refreshSoon();
        return;
    }
    order(raw, dragged);
}

void ControlPanel::set()
{
    const session::ServoEntry* known = entry();
    if (known == nullptr || !m_set->isEnabled())
        return;
    const auto raw = m_goal->goal();
    if (!raw) {
        complain([this] { return m_goal->complaint(); });
        return;
    }
    if (device::goalKind(known->servo) == GoalKind::Step) {
        step(*raw);
        return;
    }
    if (mayEnergise([this, goal = *raw] { order(goal, false); }))
        order(*raw, false);
}

void ControlPanel::step(std::int64_t raw)
{
    if (mayEnergise([this, raw] { order(raw, false); }))
        order(raw, false);
}

void ControlPanel::order(std::int64_t raw, bool dragged)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg =
        known != nullptr && known->servo.profile ? device::goalRegister(known->servo) : nullptr;
    if (reg == nullptr)
        return;
    if (!m_fields->complaint().isEmpty()) {
        complain([this] { return m_fields->complaint(); });
        return;
    }
    // What was said about the last move is not true of this one. In a drag it is told once.
    if (!std::exchange(m_inDrag, dragged) || !dragged)
        unsay();
    session::MoveWish wish{device::exactText(raw, known->servo.meaning(*reg))};
    m_fields->fill(wish);
    wish.how = how();
    wish.dragged = dragged;
    if (m_drive.move(wish) && wish.how != MoveHow::Async)
        m_goal->isSending(raw);
}

void ControlPanel::orderTorque(device::Torque torque)
{
    const auto deed = [this, torque] {
        unsay();
        m_drive.setTorque(torque);
    };
    m_banner->clear();
    if (torque != device::Torque::On || passedHint(deed))
        deed();
}

void ControlPanel::halt()
{
    m_hint->dismiss();
    unsay();
    m_drive.halt();
}

void ControlPanel::askForMode(const device::ModePlan& plan)
{
    const session::ServoEntry* known = entry();
    if (known == nullptr || !known->servo.profile || plan.writes.empty())
        return;
    const catalog::Mode* mode = known->servo.profile->mode(plan.to);
    if (mode == nullptr)
        return;
    Question question;
    question.title = tr("Switch ID %1 to \"%2\"?").arg(known->servo.id).arg(modeTitle(*mode));
    question.text = modePlanWords(plan, *known->servo.profile, static_cast<int>(others()));
    question.yes = tr("Switch");
    question.guard = this;
    ask(this, question, [this, ref = known->ref, to = plan.to] {
        if (m_selection.current() != ref)
            return;
        m_hint->dismiss();
        unsay();
        m_drive.switchMode(to);
    });
}

void ControlPanel::showError(const base::Error& error)
{
    m_goal->giveUp();
    m_goal->forgetSent();
    const session::ServoEntry* known = entry();
    const auto profile = known != nullptr ? known->servo.profile : nullptr;
    m_banner->present([error, profile] {
        const catalog::Register* reg = profile ? profile->find(error.registerKey) : nullptr;
        const text::Description words = text::describe(withName(error, reg));
        return BannerWords{Tone::Bad, words.what, words.cause, words.remedy};
    });
    refreshSoon();
}

void ControlPanel::showNotices(const device::Notices& notices)
{
    const session::ServoEntry* known = entry();
    m_saidOf = known != nullptr ? known->servo.profile : nullptr;
    m_notices = notices;
    if (!linesOf(m_saidOf, notices, true).isEmpty()) {
        m_banner->present([profile = m_saidOf, notices] {
            return BannerWords{Tone::Warn, linesOf(profile, notices, true)};
        });
    }
    showSaid();
}

void ControlPanel::showSaid()
{
    const QString said = linesOf(m_saidOf, m_notices, false);
    m_said->setText(said);
    if (!said.isEmpty())
        reserveSaid();
}

/// Its room stays when it goes: a panel that is scrolled to its end would shift otherwise.
void ControlPanel::reserveSaid()
{
    const int needed = m_said->heightForWidth(m_said->width());
    m_said->setMinimumHeight(std::max(m_said->minimumHeight(), needed));
}

void ControlPanel::unsay()
{
    m_notices.clear();
    showSaid();
}

/// What has been put right meanwhile has no words any more: the last ones stay.
void ControlPanel::complain(const std::function<QString()>& wrong)
{
    m_banner->present([wrong, last = QString()]() mutable {
        if (const QString words = wrong(); !words.isEmpty())
            last = words;
        return BannerWords{Tone::Warn, last};
    });
}
} // namespace ui
