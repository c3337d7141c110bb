// SPDX-License-Identifier: GPL-3.0-or-later
// A command of servodesk-cli, as data: how it is called, what it says about itself, and the
// function that does it. To add one: write a file with a Command and name it in commands.cpp.
#pragma once

#include "cli/exit_code.h"

#include <QHash>
#include <QStringList>

#include <optional>
#include <vector>

namespace cli {
class Run;

/// Help texts are marked with QT_TRANSLATE_NOOP("cli", …) and translated when they are shown.
struct Positional {
    const char* name; ///< "ID", "KEY=VALUE"
    const char* help;
    int min = 1; ///< words
    int max = 1; ///< 1 or many
};
constexpr int many = -1;

struct Option {
    const char* flag; ///< "--csv"
    const char* help;
    const char* value = nullptr; ///< "FILE"; null: a switch
};

/// What was typed, by positional name and option flag.
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
    /// Shows the result itself. An error is worded and mapped to an exit code by the caller.
    base::Result<Exit> (*run)(Run&, const Values&);
};

/// All of them, in the order of the help.
const std::vector<Command>& commands();
} // namespace cli
