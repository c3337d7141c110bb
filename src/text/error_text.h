// SPDX-License-Identifier: GPL-3.0-or-later
// Errors in a technician's words: what happened, the likely cause, and what to do about it. In the
// language of the installed translator. Pure; any thread. Source of causes and remedies: the fault
// table of the sheets, in words of our own.
#pragma once

#include "base/error.h"

namespace text {
struct Description {
    QString message; ///< one sentence, never empty
    QString cause;   ///< likely cause; empty where `what` says it all
    QString remedy;  ///< what to do, never empty
};

Description describe(const base::Error& error);

/// "servo 3, goal_position" — who and what an error is about; empty if it names nothing.
QString subject(const base::Error& error);
} // namespace text
