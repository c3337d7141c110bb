// SPDX-License-Identifier: GPL-3.0-or-later
// Redo as the window does it: what the first write asked about is asked about again, row by row,
// and nothing is written before the last yes. Returns at once; main thread.
#pragma once

#include "session/desk.h"

class QWidget;

namespace ui {
/// The step that is next when this is called; if another one is by the time of the last yes,
/// nothing happens.
void redo(session::Desk& desk, QWidget* parent);
} // namespace ui
