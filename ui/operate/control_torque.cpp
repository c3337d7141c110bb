// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_torque.h"

#include "ui/common/theme.h"
#include "ui/widgets/press_guard.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace ui {
namespace {
constexpr std::int64_t torqueOn = 1;
constexpr std::int64_t torqueDamping = 2;
} // namespace

ControlTorque::ControlTorque(Commands& commands, QWidget* parent)
    : QWidget(parent)
    , m_commands(commands)
    , m_switch(new QToolButton(this))
    , m_more(new QToolButton(this))
    , m_menu(new QMenu(this))
{
    setObjectName(QStringLiteral("controlTorque"));
    m_switch->setObjectName(QStringLiteral("torqueSwitch"));
    m_switch->setCheckable(true);
    m_switch->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_switch->setFocusPolicy(Qt::StrongFocus);
    m_more->setObjectName(QStringLiteral("torqueMore"));
    m_more->setText(QStringLiteral("⋯"));
    m_more->setFocusPolicy(Qt::StrongFocus);
    m_menu->setObjectName(QStringLiteral("torqueMenu"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->setSpacing(4);
    row->addWidget(m_switch);
    row->addWidget(m_more);
    // It shows what was read from the servo, not what was clicked.
    connect(m_switch, &QToolButton::clicked, this, [this] {
        const bool on = m_state == torqueOn || m_state == torqueDamping;
        showState();
        Q_EMIT requested(on ? device::Torque::Off : device::Torque::On);
    });
    connect(m_more, &QToolButton::clicked, this,
            [this] { m_menu->popup(m_more->mapToGlobal(QPoint(0, m_more->height()))); });
    new PressGuard(m_switch);
    retranslate();
}

void ControlTorque::fillMenu()
{
    m_menu->clear();
    if (m_damping) {
        QAction* damp = m_menu->addAction(tr("Damping"));
        damp->setObjectName(QStringLiteral("torqueDamp"));
        damp->setToolTip(tr("Does not hold the position, but brakes the shaft when it is turned"));
        connect(damp, &QAction::triggered, this,
                [this] { Q_EMIT requested(device::Torque::Damp); });
    }
    if (m_centering)
        m_menu->addAction(m_commands.action(Command::Center));
}

QString ControlTorque::torqueStateText(std::optional<std::int64_t> state)
{
    if (!state)
        return tr("Torque: not read");
    return *state == torqueOn        ? tr("● Torque on")
           : *state == torqueDamping ? tr("◐ Damping")
                                     : tr("○ Torque off");
}

void ControlTorque::showServo(const session::ServoEntry* entry, bool usable)
{
    const bool known = entry != nullptr && entry->servo.profile;
    const catalog::Register* reg =
        known ? entry->servo.profile->byRole(catalog::Role::TorqueSwitch) : nullptr;
    const bool damping = known && entry->servo.profile->damping;
    const bool centering = known && entry->servo.profile->centering != catalog::Centering::None;
    m_state = reg != nullptr ? entry->servo.raw(*reg) : std::nullopt;
    if (damping != m_damping || centering != m_centering) {
        m_damping = damping;
        m_centering = centering;
        fillMenu();
    }
    setVisible(reg != nullptr && entry->servo.profile->writable);
    m_more->setVisible(damping || centering);
    setEnabled(usable);
    showState();
}

void ControlTorque::showState()
{
    const QString text = torqueStateText(m_state);
    m_switch->setText(text);
    m_switch->setAccessibleName(text);
    m_switch->setChecked(m_state == torqueOn || m_state == torqueDamping);
    QPalette colors = palette();
    if (m_state == torqueOn && isEnabled())
        colors.setColor(QPalette::ButtonText, tone(Tone::Good, palette()));
    if (m_switch->palette() != colors)
        m_switch->setPalette(colors);
}

/// The widest state, so that nothing beside it moves when torque goes on or off.
void ControlTorque::reserveWidth()
{
    int widest = 0;
    for (const std::optional<std::int64_t> state :
         {std::optional<std::int64_t>(), std::optional<std::int64_t>(0),
          std::optional<std::int64_t>(torqueOn), std::optional<std::int64_t>(torqueDamping)}) {
        m_switch->setText(torqueStateText(state));
        widest = std::max(widest, m_switch->sizeHint().width());
    }
    m_switch->setMinimumWidth(widest);
    showState();
}

void ControlTorque::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        reserveWidth();
}

void ControlTorque::retranslate()
{
    m_switch->setToolTip(
        tr("When torque is on, the servo holds its present position; when it is off, "
           "the shaft turns freely"));
    m_more->setAccessibleName(tr("More torque options"));
    m_more->setToolTip(tr("Damping and midpoint"));
    fillMenu();
    reserveWidth();
}
} // namespace ui
