// SPDX-License-Identifier: GPL-3.0-or-later
// Whether writes need a question first, and its text. For a change of mode: the new mode and the
// steps around it; for dangerous registers: what can go wrong. Pure function of what is known about
// the servo; main thread.
#pragma once

#include "device/writer.h"
#include "session/servos/servo_entry.h"
#include "ui/widgets/question_dialog.h"

namespace ui {
/// What to ask before these are written together; none: nothing. Writes that are still on their way
/// count as done.
std::optional<Question> writeQuestion(const session::ServoEntry& entry,
                                      const std::vector<device::WriteItem>& items, bool temporary);
} // namespace ui
