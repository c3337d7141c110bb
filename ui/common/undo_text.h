// SPDX-License-Identifier: GPL-3.0-or-later
// What Undo and Redo would write, and to which servo, as text. Free functions; main thread.
#pragma once

#include "session/servos/servo_registry.h"
#include "session/tasks/task.h"

#include <QStringList>

namespace ui {
struct UndoText {
    QString brief;     ///< for a button: "ID 2 · position P"
    QStringList lines; ///< one a register: "ID 2 · position P: 40 → 32"
};

/// `undo`: as Undo writes it; else as Redo does.
UndoText undoText(const session::ServoRegistry& registry, const session::UndoStep& step, bool undo);
} // namespace ui
