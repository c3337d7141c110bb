// SPDX-License-Identifier: GPL-3.0-or-later
// A command of servodesk-cli as data: its name, its help, and the function that runs it. How to add
// one is in CONTRIBUTING.md.
#pragma once

#include "cli/exit_code.h"

#include <QHash>
#include <QStringList>

#include <optional>
#include <vector>

namespace cli {
class Run;

/// Help texts are marked with QT_TRANSLATE_NOOP("cli", …) and translated when they are printed.
struct Positional {
    const char* name; ///< "ID", "KEY=VALUE"
    const char* help;
    int min = 1; ///< number of arguments
    int max = 1; ///< 1 or many
};
constexpr int many = -1;
inline constexpr Positional servoIdArgument{"ID", QT_TRANSLATE_NOOP("cli", "ID of the servo")};
inline constexpr Positional outputFileArgument{
    "FILE",
    QT_TRANSLATE_NOOP("cli", "output file, for example NAME.servo.json; an existing file is "
                             "replaced")};

struct Option {
    const char* flag; ///< "--csv"
    const char* help;
    const char* value = nullptr; ///< "FILE"; null: a switch
};

/// The arguments of a command, by the name of the positional and the flag of the option.
struct Values {
    QHash<QString, QStringList> positionals;
    QHash<QString, QString> options;
    QStringList switches;

    QStringList arguments(const char* positional) const
    {
        return positionals.value(QString::fromUtf8(positional));
    }
    QString argument(const char* positional) const { return arguments(positional).value(0); }
    std::optional<QString> option(const char* flag) const
    {
        const auto it = options.find(QLatin1String(flag));
        return it == options.end() ? std::nullopt : std::optional(*it);
    }
    bool has(const char* flag) const { return switches.contains(QLatin1String(flag)); }
};

struct Command {
    const char* name; ///< "set-id"; a group and its member: "snapshot save"
    const char* help;
    std::vector<Positional> positionals;
    std::vector<Option> options;
    /// Prints the result. The caller prints an error and maps it to an exit code.
    base::Result<Exit> (*run)(Run&, const Values&);
};

/// What one does with them, as the help lists them.
struct CommandGroup {
    const char* title; ///< "Write:"
    std::vector<Command> commands;
};
const std::vector<CommandGroup>& commandGroups();

/// All of them.
const std::vector<Command>& commands();
} // namespace cli
