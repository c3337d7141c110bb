// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/allow_movement_button.h"

#include "text/language.h"
#include "ui/common/follow_language.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/question_dialog.h"

#include <QPointer>

#include <algorithm>

namespace ui {
AllowMovementButton::AllowMovementButton(session::EmergencyStop& emergencyStop,
                                         const session::ServoRegistry& registry,
                                         const session::LinkController& link, Banner& banner,
                                         QWidget* parent)
    : QPushButton(parent)
    , m_emergencyStop(emergencyStop)
    , m_registry(registry)
    , m_link(link)
    , m_banner(banner)
{
    new PressGuard(this);
    connect(this, &QPushButton::clicked, this, &AllowMovementButton::askToAllow);
    followLanguage(this, [this] { retranslate(); });
    hide();
}

std::vector<session::ServoRef> AllowMovementButton::blocked() const
{
    std::vector<session::ServoRef> found;
    std::copy_if(m_servos.begin(), m_servos.end(), std::back_inserter(found),
                 [this](session::ServoRef ref) {
                     const session::ServoEntry* entry = m_registry.servo(ref);
                     return entry != nullptr && entry->stopped;
                 });
    return found;
}

void AllowMovementButton::showFor(const std::vector<session::ServoRef>& servos)
{
    m_servos = servos;
    setVisible(m_link.state() == session::LinkState::Open && !blocked().empty());
    setEnabled(m_emergencyStop.canAllowMovement());
}

void AllowMovementButton::askToAllow()
{
    Question question;
    question.title = tr("Turn torque on?");
    question.text =
        tr("The emergency stop turned torque off for %1. Torque will be turned on again at the "
           "servos' present positions; nothing moves until you start a test.")
            .arg(blockedByStopText(m_registry, m_servos));
    question.risk = tr("Keep hands and objects away from the servos. Esc immediately turns torque "
                       "off on all servos.");
    question.acceptText = tr("Turn torque on");
    question.guard = this;
    std::vector<AskedServo> asked;
    for (const session::ServoRef ref : blocked())
        asked.push_back({ref, m_registry.servo(ref)->stoppedAt});
    ask(this, question, [this, asked] { allow(asked); });
}

/// Only those that were named in the question, and not after another stop: it may have been open
/// for a while.
void AllowMovementButton::allow(const std::vector<AskedServo>& asked)
{
    std::vector<session::ServoRef> servos;
    for (const AskedServo& one : asked) {
        const session::ServoEntry* entry = m_registry.servo(one.servo);
        if (entry != nullptr && entry->stopped && entry->stoppedAt == one.stoppedAt)
            servos.push_back(one.servo);
    }
    const auto report = [this](const session::TaskCompletion& end) {
        if (end.error)
            m_banner.showMessage(*end.error);
    };
    if (servos.size() < asked.size() || !m_emergencyStop.allowMovement(servos, this, report)) {
        m_banner.showMessage([] {
            return BannerText{
                Tone::Warn,
                tr("Torque was not turned on."),
                {},
                tr("Wait until the search or test has ended, then click “Allow movement” again.")};
        });
        return;
    }
    Q_EMIT allowed();
}

void AllowMovementButton::retranslate()
{
    setText(tr("Allow movement"));
    setAccessibleName(text());
    setToolTip(tr("Turns torque on after the emergency stop; nothing moves yet"));
}

QString blockedByStopText(const session::ServoRegistry& registry,
                          const std::vector<session::ServoRef>& servos)
{
    QStringList ids;
    for (const session::ServoRef ref : servos) {
        const session::ServoEntry* entry = registry.servo(ref);
        if (entry != nullptr && entry->stopped)
            ids.append(QStringLiteral("ID %1").arg(entry->servo.id));
    }
    return text::joinItems(ids);
}
} // namespace ui
