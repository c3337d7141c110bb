// SPDX-License-Identifier: GPL-3.0-or-later
// What every page of the window works with: the desk, what drives, records and tests beside it, the
// ports of this computer, the selected servo and the commands. Made before the window and gone
// after it, because its widgets use all of this to their last moment. The session must outlive it.
// Main thread.
#pragma once

#include "session/history/history_recorder.h"
#include "session/history/history_sender.h"
#include "session/history/history_service.h"
#include "session/motion/motion_controller.h"
#include "session/port_watcher.h"
#include "session/recording/live_data.h"
#include "session/sweep/sweep_test.h"
#include "ui/common/commands.h"

namespace ui {
struct AppContext {
    explicit AppContext(session::Session& session)
        : desk(session)
        , motion(desk)
        , liveData(desk)
        , sweepTest(desk)
        , historyRecorder(desk, liveData, history)
        , commands(desk, selection)
    {}

    session::Desk desk;
    session::MotionController motion;
    session::LiveData liveData;
    session::SweepTest sweepTest;
    session::HistoryService history;
    session::HistoryRecorder historyRecorder;
    session::HistorySender historySender; ///< no server is set at first
    session::PortWatcher ports;
    Selection selection;
    Commands commands;
};
} // namespace ui
