// SPDX-License-Identifier: GPL-3.0-or-later
// Connects the commands of the servo menu to their dialogs, and offers interrupted writes when
// Workbench has found some. Owned by the window; main thread.
#pragma once

#include "ui/common/commands.h"
#include "ui/common/selection.h"

#include <QPointer>
#include <QSet>

namespace ui {
class ServoTasks final : public QObject {
    Q_OBJECT

public:
    ServoTasks(session::Workbench& workbench, Commands& commands, Selection& selection,
               QWidget* window);

private:
    template <typename Dialog>
    void connectDialog(Command command);
    void findOpenIntents();
    void onIntentsFound(const std::vector<jobs::RecoveryResult>& found,
                        const std::vector<base::Intent>& elsewhere);

    session::Workbench& m_workbench;
    Commands& m_commands;
    Selection& m_selection;
    QWidget* m_window;
    QPointer<QDialog> m_intents;
    bool m_requested = false; ///< by the user: an empty list is an answer as well
    QSet<QString> m_shown;    ///< offered on this connection; left for later
};
} // namespace ui
