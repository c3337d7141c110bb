// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo in the window. Both select the servo they write to, because it may be another one
// than the one selected. Redo asks what the first write asked, register by register, and writes
// nothing before the last yes. Both return at once; main thread.
#pragma once

#include "session/servos/servo_registry.h"
#include "session/writes/write_service.h"
#include "ui/common/selection.h"

class QWidget;

namespace ui {
void undo(session::WriteService& writes, Selection& selection);
/// Repeats the step that is next now; if another one is next at the last yes, nothing happens.
void redo(session::WriteService& writes, const session::ServoRegistry& registry,
          Selection& selection, QWidget* parent);
} // namespace ui
