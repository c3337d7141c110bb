// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a write needs a question first, and its text. For a change of mode: the new mode and the
// steps around it; for a dangerous register: what can go wrong. Pure function of what is known
// about the servo; main thread.
#pragma once

#include "device/writer.h"
#include "session/servos/servo_entry.h"
#include "ui/widgets/question_dialog.h"

namespace ui {
/// What to ask before these are written together, one after the other; empty: nothing. Writes that
/// are still on their way count as done.
std::vector<Question> writeQuestions(const session::ServoEntry& entry,
                                     const std::vector<device::WriteItem>& items, bool temporary);
std::optional<Question> writeQuestion(const session::ServoEntry& entry,
                                      const catalog::Register& reg, std::int64_t raw,
                                      bool temporary);
} // namespace ui
