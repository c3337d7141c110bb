// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/completion.h"

#include "cli/parser.h"
#include "cli/translate.h"
#include "session/session.h"
#include "transport/port_inventory.h"

#include <QProcess>

#include <algorithm>

namespace cli {
namespace {
/// A command line up to the cursor.
struct Typed {
    QStringList commandWords{};      ///< without options and their values
    const Option* valueOf = nullptr; ///< the option whose value is being typed
    QString word{};                  ///< being typed; may be empty
};

const Option* findOption(const std::vector<Option>& options, const QString& flag)
{
    const auto found = std::find_if(options.begin(), options.end(), [&](const Option& one) {
        return flag == QLatin1String(one.flag);
    });
    return found == options.end() ? nullptr : &*found;
}

/// "arm test", else "arm"; null: none of the words is a command.
const Command* findCommand(const QStringList& words)
{
    for (const qsizetype count : {2, 1}) {
        const QString name = words.mid(0, count).join(QLatin1Char(' '));
        for (const Command& command : commands()) {
            if (words.size() >= count && name == QLatin1String(command.name))
                return &command;
        }
    }
    return nullptr;
}

const Option* findOption(const Command* command, const QString& flag)
{
    if (const Option* option = findOption(globalOptions(), flag))
        return option;
    return command != nullptr ? findOption(command->options, flag) : nullptr;
}

Typed parse(const QString& line)
{
    QStringList words = QProcess::splitCommand(line);
    Typed typed;
    if (!line.isEmpty() && !line.back().isSpace() && !words.isEmpty())
        typed.word = words.takeLast();
    for (const QString& word : words.mid(1)) {
        if (typed.valueOf != nullptr) {
            typed.valueOf = nullptr;
        } else if (word.startsWith(QLatin1Char('-'))) {
            const Option* option = findOption(findCommand(typed.commandWords), word);
            typed.valueOf = option != nullptr && option->value != nullptr ? option : nullptr;
        } else if (word != QLatin1String("help")) {
            typed.commandWords << word;
        }
    }
    return typed;
}

/// "write|sync|async": these; "N|auto": "auto", because what is in capitals stands for a value.
void addValues(const Option& option, std::vector<Completion>& all)
{
    const QLatin1StringView flag(option.flag);
    if (flag == QLatin1String("--port")) {
        for (const transport::PortInfo& port : transport::listPorts())
            all.push_back({port.path, port.description});
        for (const QString& name : session::simulatedPorts())
            all.push_back({name});
    } else if (flag == QLatin1String("--protocol")) {
        for (const char* name : {"auto", "feetech", "modbus", "lx"})
            all.push_back({QLatin1String(name)});
    } else {
        const QStringList values =
            QString::fromUtf8(option.value).split(QLatin1Char('|'), Qt::SkipEmptyParts);
        for (const QString& value : values) {
            if (values.size() > 1 && value != value.toUpper())
                all.push_back({value});
        }
    }
}

void addOptions(const std::vector<Option>& options, std::vector<Completion>& all)
{
    for (const Option& option : options)
        all.push_back({QLatin1String(option.flag), translate("cli", option.help)});
}

/// The first words of all commands, or the second words of those that begin with `group`.
void addCommands(const QString& group, std::vector<Completion>& all)
{
    for (const Command& command : commands()) {
        const QStringList words = QString::fromLatin1(command.name).split(QLatin1Char(' '));
        const QString word = group.isEmpty()          ? words.front()
                             : words.front() == group ? words.value(1)
                                                      : QString();
        const QString help =
            group.isEmpty() && words.size() > 1 ? QString() : translate("cli", command.help);
        const auto known = std::find_if(all.begin(), all.end(),
                                        [&](const Completion& one) { return one.word == word; });
        if (word.isEmpty())
            continue;
        if (known == all.end())
            all.push_back({word, help});
        else if (known->help.isEmpty())
            known->help = help;
    }
}
} // namespace

std::vector<Completion> completionsOf(const QString& line)
{
    const Typed typed = parse(line);
    std::vector<Completion> all;
    if (typed.valueOf != nullptr) {
        addValues(*typed.valueOf, all);
    } else if (typed.word.startsWith(QLatin1Char('-'))) {
        if (const Command* command = findCommand(typed.commandWords))
            addOptions(command->options, all);
        addOptions(globalOptions(), all);
    } else if (typed.commandWords.isEmpty()) {
        addCommands({}, all);
        all.push_back({QStringLiteral("help"), translate("cli", "describe a command")});
    } else if (typed.commandWords.size() == 1) {
        addCommands(typed.commandWords.front(), all);
    }
    all.erase(
        std::remove_if(all.begin(), all.end(),
                       [&](const Completion& one) { return !one.word.startsWith(typed.word); }),
        all.end());
    return all;
}

QString completionText(const std::vector<Completion>& completions)
{
    QString text;
    for (const Completion& one : completions)
        text += one.help.isEmpty() ? one.word + QLatin1Char('\n')
                                   : one.word + QLatin1Char('\t') + one.help + QLatin1Char('\n');
    return text;
}
} // namespace cli
