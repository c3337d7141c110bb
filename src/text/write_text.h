// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the history of writes, for window and command line. Pure look-up; any thread.
#pragma once

#include "base/journal.h"

#include <QString>

namespace text {
/// `ownDefaults`: the servo has reset itself, so the new values were not known beforehand.
QString intentLabel(base::IntentKind kind, bool temporary, bool ownDefaults);
/// The outcome of a register, or of the whole write if only that is known; empty: unfinished.
QString writeOutcomeLabel(const QString& outcome);
} // namespace text
