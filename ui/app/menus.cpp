// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/menus.h"

#include <QActionGroup>
#include <QMenu>

namespace ui {
namespace {
void add(QMenu& menu, const Commands& commands, std::initializer_list<Command> list)
{
    for (const Command command : list) {
        if (command == Command::Count)
            menu.addSeparator();
        else
            menu.addAction(commands.action(command));
    }
}
constexpr auto line = Command::Count; ///< a separator in the lists below
} // namespace

Menus::Menus(QMenuBar& bar, const Commands& commands, const QList<QAction*>& docks)
    : QObject(&bar)
    , m_port(bar.addMenu(QString()))
    , m_edit(bar.addMenu(QString()))
    , m_servo(bar.addMenu(QString()))
    , m_view(bar.addMenu(QString()))
    , m_theme(new QMenu(m_view))
    , m_language(new QMenu(m_view))
    , m_help(bar.addMenu(QString()))
{
    add(*m_port, commands,
        {Command::Connect,
         Command::Disconnect,
         Command::FindServos,
         line,
         Command::UseSimulation,
         Command::UseSimulatedArm,
         Command::PowerCycle,
         line,
         Command::Search,
         Command::StopSearch,
         Command::Diagnose,
         Command::StopTask,
         line,
         Command::OpenIntents,
         line,
         Command::Record,
         Command::OpenRecording,
         Command::ExportTable,
         Command::PrintTable,
         line,
         Command::Quit});
    add(*m_edit, commands,
        {Command::Undo, Command::Redo, line, Command::CopyRows, Command::FindRegister});
    addServoCommands(*m_servo, commands);
    add(*m_theme, commands, {Command::ThemeSystem, Command::ThemeLight, Command::ThemeDark});
    add(*m_language, commands, {Command::English, Command::Chinese});
    add(*m_view, commands,
        {Command::PageOperate, Command::PageMemory, Command::PageSweep, Command::PageStep,
         Command::PageSnapshots, Command::PageCommission, Command::PageArm, Command::PageFirmware,
         Command::PageHistory, line, Command::PreviousTests, Command::PauseTrend, line});
    m_view->addActions(docks);
    m_view->addSeparator();
    m_view->addMenu(m_theme);
    m_view->addMenu(m_language);
    add(*m_help, commands, {Command::Help, Command::Shortcuts, Command::About});
    for (QMenu* menu : {m_theme, m_language}) {
        auto* group = new QActionGroup(this);
        for (QAction* action : menu->actions())
            group->addAction(action);
    }
    for (QMenu* menu : {m_port, m_edit, m_servo, m_view, m_theme, m_language, m_help})
        menu->setToolTipsVisible(true);
    retranslate();
}

void Menus::addServoCommands(QMenu& menu, const Commands& commands)
{
    add(menu, commands,
        {Command::ReadTable, Command::TakeSnapshot, line, Command::Identify, Command::SetId,
         Command::SetBaud, Command::Center, Command::ClearAlarm, line, Command::CloseLock,
         Command::Reboot, Command::RestoreDefaults, Command::UpdateFirmware,
         Command::RescueFirmware, line, Command::TorqueOffAll});
}

void Menus::retranslate()
{
    m_port->setTitle(tr("&Port"));
    m_edit->setTitle(tr("&Edit"));
    m_servo->setTitle(tr("&Servo"));
    m_view->setTitle(tr("&View"));
    m_theme->setTitle(tr("&Theme"));
    m_language->setTitle(tr("&Language"));
    m_help->setTitle(tr("&Help"));
}
} // namespace ui
