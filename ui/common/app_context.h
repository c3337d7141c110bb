// SPDX-License-Identifier: GPL-3.0-or-later
// The services that every page of the window uses: the workbench, the ports of this computer, the
// selected servo and the commands. Made before the window and destroyed after it, because its
// widgets use all of this until they are destroyed. The session must outlive it. Main thread.
#pragma once

#include "session/port_watcher.h"
#include "session/workbench.h"
#include "ui/common/commands.h"

namespace ui {
struct AppContext {
    explicit AppContext(session::Session& session)
        : workbench(session)
        , commands(workbench, selection)
    {
        (void)workbench.historyRecorder();
    }

    session::Workbench workbench;
    session::PortWatcher ports;
    Selection selection;
    Commands commands;
};
} // namespace ui
