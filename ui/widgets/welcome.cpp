// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/welcome.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int columnWidth = 460;
constexpr double titleScale = 1.5;

QLabel* words(QWidget* parent, const char* name)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}
} // namespace

Welcome::Welcome(Commands& commands, QWidget* parent)
    : QWidget(parent)
    , m_commands(commands)
    , m_title(words(this, "welcomeTitle"))
    , m_adapterText(words(this, "welcomeAdapterWords"))
    , m_simulationText(words(this, "welcomeSimulationWords"))
    , m_adapter(new QPushButton(this))
    , m_find(new QPushButton(this))
    , m_simulation(new QPushButton(this))
    , m_arm(new QPushButton(this))
{
    setObjectName(QStringLiteral("welcome"));
    m_adapter->setObjectName(QStringLiteral("welcomeConnect"));
    m_find->setObjectName(QStringLiteral("welcomeFind"));
    m_simulation->setObjectName(QStringLiteral("welcomeSimulation"));
    m_arm->setObjectName(QStringLiteral("welcomeArm"));
    makeMainAction(m_adapter);
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * titleScale);
    m_title->setFont(large);
    auto* column = new QVBoxLayout;
    column->setSpacing(8);
    column->addWidget(m_title);
    column->addSpacing(12);
    column->addWidget(m_adapterText);
    auto* withAdapter = new QHBoxLayout;
    withAdapter->addWidget(m_adapter);
    withAdapter->addWidget(m_find);
    withAdapter->addStretch(1);
    column->addLayout(withAdapter);
    column->addSpacing(20);
    column->addWidget(m_simulationText);
    auto* simulated = new QHBoxLayout;
    simulated->addWidget(m_simulation);
    simulated->addWidget(m_arm);
    simulated->addStretch(1);
    column->addLayout(simulated);
    auto* room = new QGridLayout(this);
    room->setRowStretch(0, 1);
    room->setRowStretch(2, 2);
    room->setColumnStretch(0, 1);
    room->setColumnStretch(2, 1);
    room->addLayout(column, 1, 1);
    room->setColumnMinimumWidth(1, columnWidth);
    connect(m_adapter, &QPushButton::clicked, m_commands.action(Command::Connect),
            &QAction::trigger);
    connect(m_find, &QPushButton::clicked, m_commands.action(Command::FindServos),
            &QAction::trigger);
    connect(m_simulation, &QPushButton::clicked, m_commands.action(Command::UseSimulation),
            &QAction::trigger);
    connect(m_arm, &QPushButton::clicked, m_commands.action(Command::UseSimulatedArm),
            &QAction::trigger);
    for (const Command command :
         {Command::Connect, Command::FindServos, Command::UseSimulation, Command::UseSimulatedArm})
        connect(m_commands.action(command), &QAction::changed, this, &Welcome::updateEnabled);
    followLanguage(this, [this] { retranslate(); });
    updateEnabled();
}

void Welcome::updateEnabled()
{
    m_adapter->setEnabled(m_commands.action(Command::Connect)->isEnabled());
    m_find->setEnabled(m_commands.action(Command::FindServos)->isEnabled());
    m_simulation->setEnabled(m_commands.action(Command::UseSimulation)->isEnabled());
    m_arm->setEnabled(m_commands.action(Command::UseSimulatedArm)->isEnabled());
}

void Welcome::retranslate()
{
    m_title->setText(tr("No servos connected yet"));
    m_adapterText->setText(
        tr("Plug in the adapter, turn on the servos' power supply, and select the port above. "
           "Connecting and searching do not write anything or move any servo."));
    m_adapter->setText(tr("Connect to selected port"));
    m_adapter->setToolTip(tr("Opens the port selected above and searches it for servos"));
    m_find->setText(tr("Find servos on all ports…"));
    m_find->setToolTip(m_commands.action(Command::FindServos)->toolTip());
    m_simulationText->setText(
        tr("No hardware? The simulated bus has servos of several families, some with faults to "
           "find."));
    m_simulation->setText(tr("Try a simulated bus"));
    m_simulation->setToolTip(tr("Simulated servos; nothing needs to be connected"));
    m_arm->setText(tr("Try a simulated robot arm"));
    m_arm->setToolTip(m_commands.action(Command::UseSimulatedArm)->toolTip());
    for (QPushButton* button : {m_adapter, m_find, m_simulation, m_arm})
        button->setAccessibleName(button->text());
}
} // namespace ui
