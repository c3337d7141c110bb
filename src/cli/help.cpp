// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/examples.h"
#include "cli/output/table.h"
#include "cli/parser.h"
#include "cli/translate.h"

namespace cli {
namespace {
constexpr int nameWidth = 30;

/// A name that leaves no room beside it stands above its explanation.
QString entry(const QString& name, const char* help)
{
    const QString indent = name.size() > nameWidth - 2
                               ? name + QLatin1Char('\n') + QString(nameWidth, QLatin1Char(' '))
                               : padded(name, nameWidth - 2);
    return QStringLiteral("  ") + indent + QLatin1Char(' ') + translate("cli", help) +
           QLatin1Char('\n');
}

QString formatName(const Positional& positional)
{
    QString name = QString::fromUtf8(positional.name);
    if (positional.max == many && !name.contains(u'…'))
        name += u'…';
    return positional.min == 0 ? QStringLiteral("[%1]").arg(name) : name;
}

QString formatFlag(const Option& option)
{
    return option.value == nullptr ? QString::fromLatin1(option.flag)
                                   : QStringLiteral("%1 %2").arg(QLatin1String(option.flag),
                                                                 QString::fromUtf8(option.value));
}

QString optionList(const QString& title, const std::vector<Option>& options)
{
    if (options.empty())
        return {};
    QString text = QLatin1Char('\n') + title + QLatin1Char('\n');
    for (const Option& option : options)
        text += entry(formatFlag(option), option.help);
    return text;
}

QString exampleList(const Command& command)
{
    QString text;
    for (const Examples& one : allExamples()) {
        if (qstrcmp(one.command, command.name) != 0)
            continue;
        text += QLatin1Char('\n') + translate("cli", "Examples:") + QLatin1Char('\n');
        for (const char* line : {one.first, one.second})
            text += QStringLiteral("  servodesk-cli %1\n").arg(QLatin1String(line));
    }
    return text;
}

QString usage(const Command& command)
{
    QString line = QLatin1String(command.name);
    for (const Positional& positional : command.positionals)
        line += QLatin1Char(' ') + formatName(positional);
    return line;
}

Json jsonOptions(const std::vector<Option>& options)
{
    Json::Array all;
    for (const Option& option : options)
        all.push_back(Json::object()
                          .add("flag", QString::fromLatin1(option.flag))
                          .add("value", option.value != nullptr
                                            ? Json(QString::fromUtf8(option.value))
                                            : Json())
                          .add("help", translate("cli", option.help)));
    return Json(std::move(all));
}

Json jsonCommand(const Command& command)
{
    Json::Array arguments;
    for (const Positional& one : command.positionals)
        arguments.push_back(Json::object()
                                .add("name", QString::fromUtf8(one.name))
                                .add("help", translate("cli", one.help))
                                .add("required", one.min > 0)
                                .add("repeated", one.max == many));
    QStringList examples;
    for (const Examples& one : allExamples()) {
        if (qstrcmp(one.command, command.name) == 0)
            examples << QString::fromLatin1(one.first) << QString::fromLatin1(one.second);
    }
    return Json::object()
        .add("name", QString::fromLatin1(command.name))
        .add("usage", usage(command))
        .add("help", translate("cli", command.help))
        .add("arguments", Json(std::move(arguments)))
        .add("options", jsonOptions(command.options))
        .add("examples", Json(examples));
}
} // namespace

Json helpJson(const Command* command)
{
    if (command != nullptr)
        return jsonCommand(*command);
    Json::Array groups;
    for (const CommandGroup& group : commandGroups()) {
        Json::Array members;
        for (const Command& one : group.commands)
            members.push_back(jsonCommand(one));
        groups.push_back(Json::object()
                             .add("title", translate("cli", group.title))
                             .add("commands", Json(std::move(members))));
    }
    return Json::object()
        .add("version", QCoreApplication::applicationVersion())
        .add("groups", Json(std::move(groups)))
        .add("options", jsonOptions(globalOptions()));
}

QString helpText(const Command* command)
{
    QString text;
    if (command == nullptr) {
        text = translate("cli", "Finds, reads, configures and drives serial bus servos.") +
               QStringLiteral("\n\n") +
               translate("cli", "Usage: servodesk-cli [OPTIONS] COMMAND …") + QLatin1Char('\n');
        for (const CommandGroup& group : commandGroups()) {
            text += QLatin1Char('\n') + translate("cli", group.title) + QLatin1Char('\n');
            for (const Command& one : group.commands)
                text += entry(usage(one), one.help);
        }
    } else {
        text = translate("cli", command->help) + QStringLiteral("\n\n") +
               translate("cli", "Usage: servodesk-cli [OPTIONS] %1").arg(usage(*command)) +
               QLatin1Char('\n');
        if (!command->positionals.empty())
            text += QLatin1Char('\n');
        for (const Positional& positional : command->positionals)
            text += entry(formatName(positional), positional.help);
        text += optionList(translate("cli", "Options for this command:"), command->options);
        text += exampleList(*command);
    }
    text += optionList(translate("cli", "Options:"), globalOptions());
    if (command == nullptr) {
        text += QLatin1Char('\n') +
                translate(
                    "cli",
                    "Exit codes: 0 success, 1 not executed, failed, different or stopped, 2 usage "
                    "error, 3 port error, 4 no reply, 5 file error.\n\"servodesk-cli "
                    "help COMMAND\" describes a command.") +
                QLatin1Char('\n');
    }
    return text;
}
} // namespace cli
