// SPDX-License-Identifier: GPL-3.0-or-later
// How a remedy names a task: window and command line have different names for it. Set once at the
// start of a program; any thread.
#pragma once

#include <QString>

namespace text {
enum class FrontEnd { CommandLine, Window };

/// Default: the command line.
void setFrontEnd(FrontEnd frontEnd);

/// The task that finishes or undoes open changes: "recover", "Port → Interrupted writes".
QString recoveryName();

/// A translated sentence with "%recover" replaced by recoveryName().
QString withRecoveryName(QString sentence);
} // namespace text
