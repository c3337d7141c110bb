// SPDX-License-Identifier: GPL-3.0-or-later
// What every page of the window works with: the desk, the ports of this computer, the selected
// servo and the commands. Made before the window and gone after it, because its widgets use all of
// this to their last moment. The session must outlive it. Main thread.
#pragma once

#include "session/port_watch.h"
#include "ui/app/commands.h"

namespace ui {
struct Bench {
    explicit Bench(session::Session& session)
        : desk(session)
        , commands(desk, selection)
    {}

    session::Desk desk;
    session::PortWatch ports;
    Selection selection;
    Commands commands;
};
} // namespace ui
