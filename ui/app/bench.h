// SPDX-License-Identifier: GPL-3.0-or-later
// What every page of the window works with: the desk, what drives, records and tests beside it, the
// ports of this computer, the selected servo and the commands. Made before the window and gone
// after it, because its widgets use all of this to their last moment. The session must outlive it.
// Main thread.
#pragma once

#include "session/archive.h"
#include "session/drive.h"
#include "session/history_keeper.h"
#include "session/history_sender.h"
#include "session/port_watch.h"
#include "session/scope.h"
#include "session/sweep_test.h"
#include "ui/app/commands.h"

namespace ui {
struct Bench {
    explicit Bench(session::Session& session)
        : desk(session)
        , drive(desk)
        , scope(desk)
        , sweep(desk)
        , keeper(desk, scope, archive)
        , commands(desk, selection)
    {}

    session::Desk desk;
    session::Drive drive;
    session::Scope scope;
    session::SweepTest sweep;
    session::Archive archive;
    session::HistoryKeeper keeper;
    session::HistorySender sender; ///< no server is set at first
    session::PortWatch ports;
    Selection selection;
    Commands commands;
};
} // namespace ui
