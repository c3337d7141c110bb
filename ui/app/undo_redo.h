// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo in the window. Both select the servo they write to, because it may be another one
// than the one selected, and ask what a write of these values asks; nothing is written before the
// yes. Both return at once; main thread.
#pragma once

#include "session/servos/servo_registry.h"
#include "session/writes/write_service.h"
#include "ui/common/selection.h"

class QWidget;

namespace ui {
/// Takes back the last step. If another one is next at the yes, nothing happens; redo likewise.
void undo(session::WriteService& writes, const session::ServoRegistry& registry,
          Selection& selection, QWidget* parent);
/// Repeats the step that is next now.
void redo(session::WriteService& writes, const session::ServoRegistry& registry,
          Selection& selection, QWidget* parent);
} // namespace ui
