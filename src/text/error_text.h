// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of errors for a technician: what happened, the likely cause, and what to do, in the
// language of the interface. Causes and remedies follow the fault table of the data sheets, in our
// own words. Pure; any thread.
#pragma once

#include "base/error.h"

namespace text {
struct Description {
    QString message; ///< one sentence, never empty
    QString cause;   ///< likely cause; empty where the message is enough
    QString remedy;  ///< what to do, never empty
};

Description describe(const base::Error& error);

/// "servo 3, goal_position": what the error is about; empty if it names nothing.
QString subject(const base::Error& error);
} // namespace text
