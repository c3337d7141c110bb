// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_send.h"

#include "device/motion/move_limits.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/segmented_control.h"

#include <QPushButton>

namespace ui {
using device::MoveMethod;

ControlSend::ControlSend(QWidget* parent)
    : QWidget(parent)
    , m_method(new SegmentedControl(this))
    , m_execute(new QPushButton(this))
    , m_set(new QPushButton(this))
{
    setObjectName(QStringLiteral("controlWrite"));
    for (const char* name : {"howWrite", "howSync", "howAsync"})
        m_method->addSegment(QString::fromLatin1(name));
    m_method->select(0);
    m_execute->setObjectName(QStringLiteral("execute"));
    m_set->setObjectName(QStringLiteral("setGoal"));
    makeMainAction(m_set);
    for (QWidget* button : {m_execute, m_set})
        new PressGuard(button);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    auto* row = new FlowLayout(this, 6); // where words are long, Set is in a second row
    for (QWidget* control : std::initializer_list<QWidget*>{m_method, m_execute, m_set})
        row->addWidget(control);
    connect(m_execute, &QPushButton::clicked, this, &ControlSend::executeRequested);
    connect(m_set, &QPushButton::clicked, this, &ControlSend::sendRequested);
}

MoveMethod ControlSend::method() const
{
    return static_cast<MoveMethod>(std::max(0, m_method->selected()));
}

bool ControlSend::canSend() const
{
    return m_set->isEnabled();
}

void ControlSend::showServo(const session::ServoEntry& entry, const State& state)
{
    int offers = 0;
    for (const MoveMethod one : {MoveMethod::Write, MoveMethod::Sync, MoveMethod::Async}) {
        const bool offered = device::supports(entry.servo, one);
        offers += offered ? 1 : 0;
        m_method->segment(static_cast<int>(one))->setVisible(offered);
        if (!offered && method() == one)
            m_method->select(0);
    }
    m_method->setVisible(offers > 1);
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
        m_method->select(static_cast<int>(MoveMethod::Sync));
    else if (!severalServos && method() == MoveMethod::Sync)
        m_method->select(static_cast<int>(MoveMethod::Write));
}

void ControlSend::retranslate()
{
    static const std::array words{
        std::pair{QT_TR_NOOP("Write"), QT_TR_NOOP("Writes to one servo after another; each "
                                                  "write is acknowledged")},
        std::pair{QT_TR_NOOP("Sync"),
                  QT_TR_NOOP("Sends one packet to all selected servos; they start together")},
        std::pair{QT_TR_NOOP("Async"),
                  QT_TR_NOOP("Stores the goal in the servo until you click Execute")}};
    for (int i = 0; i < 3; ++i) {
        QAbstractButton* button = m_method->segment(i);
        setButtonText(button, tr(words[static_cast<std::size_t>(i)].first),
                      tr(words[static_cast<std::size_t>(i)].second));
    }
    m_execute->setAccessibleName(tr("Execute"));
    m_execute->setToolTip(tr("Executes all goals waiting in the servos"));
    setButtonText(m_set, tr("Set"), tr("Sends the goal and the changed fields"));
}
} // namespace ui
