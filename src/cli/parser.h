// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the command line into a command and its values. CLI11 splits it; the messages are ours, so
// the language must be installed first. Main thread. Errors: BadArgument.
#pragma once

#include "cli/output/json.h"
#include "cli/run.h"

namespace cli {
struct ParsedCommandLine {
    enum class Action { Command, Help, Version };
    Action action = Action::Command;
    const Command* command = nullptr; ///< null: help for the program
    Values values;
    Globals globals;
    bool json = false;
};

/// Arguments without the name of the program.
base::Result<ParsedCommandLine> parseCommandLine(const QStringList& arguments);

/// Global options, for parser and help. --json and --lang are read first.
const std::vector<Option>& globalOptions();

/// The value of --lang at any position; empty if it is not given. BadArgument for an unsupported
/// language.
base::Result<QString> requestedLanguage(const QStringList& arguments);

/// Usage of one command, or of the program (null).
QString helpText(const Command* command);
/// The same as data, in the order of the help; the manual page is made of it.
Json helpJson(const Command* command);
} // namespace cli
