// SPDX-License-Identifier: GPL-3.0-or-later
// Where a remedy sends the user: the window and the command line name the same task differently.
#pragma once

#include <QString>

namespace text {
enum class FrontEnd { CommandLine, Window };

/// Once at the start of a program; the command line if it is not set.
void setFrontEnd(FrontEnd frontEnd);

/// The task that finishes or undoes open changes: "recover", "Port → Interrupted writes".
QString recoveryName();

/// A translated sentence with "%recover" replaced by recoveryName().
QString withRecoveryName(QString sentence);
} // namespace text
