// SPDX-License-Identifier: GPL-3.0-or-later
// "Undo this write" of the history: puts the old value back on the servo that was written to, if it
// is in the list of servos. Main thread; never waits.
#pragma once

#include "history/history_rows.h"
#include "session/workbench.h"

class QWidget;

namespace ui {
/// Why this write cannot be undone now; empty: it can. `servo`: whose write it was; null: unknown.
QString undoRefusal(const session::Workbench& workbench, const history::HistoryWrite& write,
                    const history::HistoryServo* servo);

/// Always asks: the servo is out of sight on this page, and the value may have changed since. Does
/// nothing where undoRefusal() has a reason.
void askToUndo(QWidget* page, session::Workbench& workbench, const history::HistoryWrite& write,
               const history::HistoryServo* servo);
} // namespace ui
