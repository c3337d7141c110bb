// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of servodesk-sim. Pure: text in, options or a message out.
#pragma once

#include "session/sim/sim_program.h"

#include <optional>
#include <string>

namespace cli {
struct SimCommandLine {
    std::optional<session::SimOptions> options; ///< empty: print `message` and exit
    std::string message;
    int exitCode = 0; ///< 0 for --help and --version, 2 for a usage error
};

SimCommandLine parseSimCommandLine(int argc, const char* const* argv);
} // namespace cli
