// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli without main: parses, runs the command, words its error, answers the exit code.
// Main thread, inside the application object.
#pragma once

#include "base/stop_token.h"

#include <QStringList>

namespace cli {
/// `arguments` without the program's name.
int runProgram(const QStringList& arguments, const base::StopToken& stop);
} // namespace cli
