// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a write needs a question first, and its text. For a change of mode: the new mode and the
// steps around it; for a dangerous register: what can go wrong. Pure function of what is known
// about the servo; main thread.
#pragma once

#include "session/servos/servo_entry.h"
#include "ui/widgets/question_dialog.h"

namespace ui {
/// Nullopt: nothing to ask. Writes that are still on their way count as done.
std::optional<Question> writeQuestion(const session::ServoEntry& entry,
                                      const catalog::Register& reg, std::int64_t raw,
                                      bool temporary);

/// The mode the servo is in, and the one it would be in after the write; null while not known.
struct ModeTransition {
    const catalog::Mode* from = nullptr;
    const catalog::Mode* to = nullptr;
};
ModeTransition modeTransition(const session::ServoEntry& entry, const catalog::Register& reg,
                              std::int64_t raw);
} // namespace ui
