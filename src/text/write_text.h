// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the history of writes in words, for window and command line. Pure look-up, any thread.
#pragma once

#include "base/journal.h"

#include <QString>

namespace text {
/// `ownDefaults`: no new value was known beforehand, the servo took its own defaults.
QString intentLabel(base::IntentKind kind, bool temporary, bool ownDefaults);
/// The outcome of a register, or of the whole intent where only that is known; empty: it is open.
QString writeOutcomeLabel(const QString& outcome);
} // namespace text
