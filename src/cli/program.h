// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli without main: parses the command line, runs the command, prints its error, returns
// the exit code. Main thread; needs the application object.
#pragma once

#include "base/stop_token.h"

#include <QStringList>

namespace cli {
/// `arguments` without the name of the program.
int runProgram(const QStringList& arguments, const base::StopToken& stop);
} // namespace cli
