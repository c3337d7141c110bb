// SPDX-License-Identifier: GPL-3.0-or-later
// Why a request was refused, by the detail of the error from device and jobs: sentence, cause and
// remedy, untranslated. Pure look-up; any thread.
#pragma once

#include "base/error.h"

namespace text {
struct RefusalText {
    const char* key; ///< the detail of the error
    const char* message;
    const char* cause;
    const char* remedy;
};

/// Null: this error has no text of its own.
const RefusalText* refusalText(const base::Error& error);
/// "2, 3": the servos held by an emergency stop, if the task was about more than one.
QString heldByStop(const base::Error& error);
/// "1, 2": the servos in which a goal may still wait, if it is more than one.
QString heldGoals(const base::Error& error);
} // namespace text
