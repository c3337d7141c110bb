// SPDX-License-Identifier: GPL-3.0-or-later
// Two command lines for each command, as its help shows them: they name no port, because the only
// adapter is used without one. tst_cli_examples runs all of them, in this order. Any thread.
#pragma once

#include "cli/command.h"

namespace cli {
struct Examples {
    const char* command;
    const char* first; ///< without the name of the program
    const char* second;
};
const std::vector<Examples>& allExamples();
} // namespace cli
