// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_send.h"

#include "device/motion/move_limits.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/segment_button.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>

namespace ui {
using device::MoveMethod;

ControlSend::ControlSend(QWidget* parent)
    : QWidget(parent)
    , m_method(new QButtonGroup(this))
{
    setObjectName(QStringLiteral("controlWrite"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    new FlowLayout(this, 6); // where words are long, the buttons that send are in a second row
    QWidget* methods = addGroup();
    static const char* const names[] = {"howWrite", "howSync", "howAsync"};
    for (int i = 0; i < 3; ++i) {
        auto* button = new SegmentButton(methods);
        button->setObjectName(QString::fromLatin1(names[i]));
        m_method->addButton(button, i);
        methods->layout()->addWidget(button);
    }
    m_method->button(0)->setChecked(true);
    QWidget* actions = addGroup();
    m_execute = new QPushButton(actions);
    m_execute->setObjectName(QStringLiteral("execute"));
    m_set = new QPushButton(actions);
    m_set->setObjectName(QStringLiteral("setGoal"));
    m_set->setProperty("mainAction", true);
    for (QWidget* button : {m_execute, m_set}) {
        new PressGuard(button);
        actions->layout()->addWidget(button);
    }
    connect(m_execute, &QPushButton::clicked, this, &ControlSend::executeRequested);
    connect(m_set, &QPushButton::clicked, this, &ControlSend::sendRequested);
}

QWidget* ControlSend::addGroup()
{
    auto* group = new QWidget(this);
    auto* row = new QHBoxLayout(group);
    row->setContentsMargins({});
    row->setSpacing(2);
    layout()->addWidget(group);
    return group;
}

MoveMethod ControlSend::method() const
{
    return static_cast<MoveMethod>(std::max(0, m_method->checkedId()));
}

bool ControlSend::canSend() const
{
    return m_set->isEnabled();
}

void ControlSend::showServo(const session::ServoEntry& entry, const State& state)
{
    for (const MoveMethod one : {MoveMethod::Write, MoveMethod::Sync, MoveMethod::Async}) {
        const bool offered = device::supports(entry.servo, one);
        m_method->button(static_cast<int>(one))->setVisible(offered);
        if (!offered && method() == one)
            m_method->button(0)->setChecked(true);
    }
    chooseMethod(entry.servo, state.severalServos);
    const bool waiting = state.waitingGoals > 0;
    m_execute->setVisible(waiting || device::supports(entry.servo, MoveMethod::Async));
    m_execute->setEnabled(waiting && state.canMove);
    m_execute->setText(waiting ? tr("Execute (%1)").arg(state.waitingGoals) : tr("Execute"));
    m_execute->setAccessibleName(m_execute->text());
    m_set->setVisible(device::goalKind(entry.servo) != device::GoalKind::Step);
    m_set->setEnabled(state.canMove);
}

/// Several servos start together unless the user chooses otherwise; one alone goes back to the
/// plain write.
void ControlSend::chooseMethod(const device::Servo& servo, bool severalServos)
{
    if (m_methodChosen || servo.mode() == nullptr)
        return;
    m_methodChosen = true;
    if (severalServos && method() == MoveMethod::Write && device::supports(servo, MoveMethod::Sync))
        m_method->button(static_cast<int>(MoveMethod::Sync))->setChecked(true);
    else if (!severalServos && method() == MoveMethod::Sync)
        m_method->button(static_cast<int>(MoveMethod::Write))->setChecked(true);
}

void ControlSend::retranslate()
{
    static const std::array words{
        std::pair{QT_TR_NOOP("Write"), QT_TR_NOOP("Writes to one servo after another; each "
                                                  "write is acknowledged")},
        std::pair{QT_TR_NOOP("Sync"),
                  QT_TR_NOOP("Sends one packet to all selected servos; they start together")},
        std::pair{QT_TR_NOOP("Async"), QT_TR_NOOP("The goal waits in the servo until you choose "
                                                  "Execute")}};
    for (int i = 0; i < 3; ++i) {
        auto* button = m_method->button(i);
        setButtonText(button, tr(words[static_cast<std::size_t>(i)].first),
                      tr(words[static_cast<std::size_t>(i)].second));
    }
    m_execute->setAccessibleName(tr("Execute"));
    m_execute->setToolTip(tr("Executes all goals waiting in the servos"));
    setButtonText(m_set, tr("Set"), tr("Sends the goal and the changed fields"));
}
} // namespace ui
