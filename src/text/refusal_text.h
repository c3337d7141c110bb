// SPDX-License-Identifier: GPL-3.0-or-later
// Why a family cannot do a thing, by the detail that device and jobs give: sentence, cause and
// remedy. The words are untranslated; pure look-up, any thread.
#pragma once

#include "base/error.h"

namespace text {
struct RefusalText {
    const char* detail;
    const char* message;
    const char* cause;
    const char* remedy;
};

/// Null: nothing particular is known about this error.
const RefusalText* refusalText(const base::Error& error);
/// "2, 3": the servos that an emergency stop holds, where a task concerned more than one of them.
QString heldByStop(const base::Error& error);
/// "1, 2": the servos in which a goal may still wait, where it is more than one.
QString heldGoals(const base::Error& error);
} // namespace text
