// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/servo_tasks.h"

#include "ui/tasks/alarm_dialog.h"
#include "ui/tasks/center_dialog.h"
#include "ui/tasks/identify_dialog.h"
#include "ui/tasks/intents_dialog.h"
#include "ui/tasks/reboot_dialog.h"
#include "ui/tasks/restore_defaults_dialog.h"
#include "ui/tasks/set_baud_dialog.h"
#include "ui/tasks/set_id_dialog.h"

#include <algorithm>

namespace ui {
using session::Workbench;

ServoTasks::ServoTasks(Workbench& workbench, Commands& commands, Selection& selection,
                       QWidget* window)
    : QObject(window)
    , m_workbench(workbench)
    , m_commands(commands)
    , m_selection(selection)
    , m_window(window)
{
    connectDialog<SetIdDialog>(Command::SetId);
    connectDialog<SetBaudDialog>(Command::SetBaud);
    connectDialog<CenterDialog>(Command::Center);
    connectDialog<RestoreDefaultsDialog>(Command::RestoreDefaults);
    connectDialog<RebootDialog>(Command::Reboot);
    connectDialog<IdentifyDialog>(Command::Identify);
    connectDialog<AlarmDialog>(Command::ClearAlarm);
    connect(commands.action(Command::OpenIntents), &QAction::triggered, this,
            &ServoTasks::findOpenIntents);
    connect(&workbench.recovery(), &session::RecoveryService::openIntentsFound, this,
            &ServoTasks::onIntentsFound);
    connect(&workbench.link(), &session::LinkController::linkChanged, this, [this] {
        if (m_workbench.link().state() != session::LinkState::Open)
            m_shown.clear();
    });
}

template <typename Dialog>
void ServoTasks::connectDialog(Command command)
{
    connect(m_commands.action(command), &QAction::triggered, this, [this] {
        const session::ServoEntry* servo = m_workbench.registry().servo(m_selection.current());
        if (servo == nullptr || !servo->servo.profile)
            return;
        (new Dialog(m_workbench, servo->ref, m_window))->open();
    });
}

void ServoTasks::findOpenIntents()
{
    m_requested = true;
    m_workbench.recovery().findOpenIntents();
}

void ServoTasks::onIntentsFound(const std::vector<jobs::RecoveryResult>& found,
                                const std::vector<base::Intent>& elsewhere)
{
    const bool asked = std::exchange(m_requested, false);
    if (m_intents)
        return; // it follows by itself
    const auto isNewIntent = [this](const base::Intent& intent) {
        return !intent.isActiveElsewhere && !m_shown.contains(intent.uuid);
    };
    const bool hasNew = std::any_of(found.begin(), found.end(), [&](const auto& one) {
        return isNewIntent(one.before.intent);
    });
    const bool hasNewElsewhere = std::any_of(elsewhere.begin(), elsewhere.end(), isNewIntent);
    if (!asked && !hasNew && !hasNewElsewhere)
        return;
    const auto note = [this](const base::Intent& intent) {
        if (!intent.isActiveElsewhere) // if that program fails, it is news
            m_shown.insert(intent.uuid);
    };
    for (const base::Intent& intent : elsewhere)
        note(intent);
    for (const jobs::RecoveryResult& one : found)
        note(one.before.intent);
    m_intents = new IntentsDialog(m_workbench, found, elsewhere, m_window);
    m_intents->open();
}
} // namespace ui
