// SPDX-License-Identifier: GPL-3.0-or-later
// The command line into a command and its values. CLI11 does the splitting; the words are ours.
// Needs the language installed, because it words its errors. Errors: BadArgument.
#pragma once

#include "cli/run.h"

namespace cli {
struct ParsedCommandLine {
    enum class Action { Command, Help, Version };
    Action action = Action::Command;
    const Command* command = nullptr; ///< null: help on everything
    Values values;
    Globals globals;
    bool json = false;
};

/// Without the program's name.
base::Result<ParsedCommandLine> parseCommandLine(const QStringList& arguments);

/// Global options, for parser and help. --json and --lang are looked at before all else.
const std::vector<Option>& globalOptions();

/// The value of --lang, wherever it stands; empty if it is not there. BadArgument for a language
/// there is none of.
base::Result<QString> requestedLanguage(const QStringList& arguments);

/// Usage of one command, or of the program (null).
QString helpText(const Command* command);
} // namespace cli
