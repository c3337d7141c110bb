// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of commands: text, icon, shortcut, and when each can be used. Menus, toolbars,
// buttons and the list of shortcuts all show these actions; the code that executes a command
// connects to its triggered(). Owned by the window; main thread.
#pragma once

#include "session/workbench.h"
#include "ui/common/selection.h"

#include <QAction>

#include <array>

namespace ui {
enum class Command : std::uint8_t {
    Connect,
    Disconnect,
    FindServos,
    UseSimulation,
    UseSimulatedArm,
    PowerCycle,
    Search,
    StopSearch,
    Diagnose,
    StopTask,
    ReadTable,
    FindRegister,
    CloseLock,
    CopyRows,
    ExportTable,
    PrintTable,
    Undo,
    Redo,
    SetId,
    SetBaud,
    Center,
    RestoreDefaults,
    Reboot,
    UpdateFirmware,
    RescueFirmware,
    Identify,
    ClearAlarm,
    OpenIntents,
    PageOperate,
    PageMemory,
    PageSweep,
    PageStep,
    PageSnapshots,
    TakeSnapshot,
    PageCommission,
    PageArm,
    PageFirmware,
    PageHistory,
    PreviousTests,
    PauseTrend,
    Record,
    OpenRecording,
    TorqueOffAll,
    ThemeSystem,
    ThemeLight,
    ThemeDark,
    English,
    Chinese,
    MessageLog,
    Help,
    Shortcuts,
    About,
    Quit,
    Count,
};

class Commands final : public QObject {
    Q_OBJECT

public:
    Commands(session::Workbench& workbench, const Selection& selection, QObject* parent = nullptr);

    QAction* action(Command command) const { return m_actions[static_cast<std::size_t>(command)]; }

    /// After a change of language.
    void retranslate();
    /// After a change of theme: the icons of the other one.
    void updateIcons();

private:
    void refresh();
    void updateUndoTexts();

    session::Workbench& m_workbench;
    const Selection& m_selection;
    std::array<QAction*, static_cast<std::size_t>(Command::Count)> m_actions{};
};
} // namespace ui
