// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parser.h"

#include "cli/input/arguments.h"
#include "cli/translate.h"
#include "text/language.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <list>

namespace cli {
namespace {
constexpr int maxTimeoutMs = 60'000;
constexpr int maxRetries = 20;
constexpr int maxSilenceUs = 100'000;

/// Filled by CLI11 for one command.
struct Slots {
    const Command* command = nullptr;
    CLI::App* app = nullptr;
    std::list<std::vector<std::string>> positionals;
    std::list<std::pair<const Option*, std::string>> options;
};

void addOptions(CLI::App& app, const std::vector<Option>& options, Slots& into)
{
    for (const Option& option : options) {
        auto& slot = into.options.emplace_back(&option, std::string());
        if (option.value != nullptr)
            app.add_option(option.flag, slot.second);
        else
            app.add_flag(option.flag)->disable_flag_override();
    }
}

CLI::App* addCommand(CLI::App& parent, const QString& name)
{
    const qsizetype blank = name.indexOf(QLatin1Char(' '));
    const std::string first = name.left(blank).toStdString();
    const auto known =
        parent.get_subcommands([&first](const CLI::App* sub) { return sub->get_name() == first; });
    CLI::App* app =
        known.empty()
            ? parent.add_subcommand(first)->fallthrough()->allow_extras()->require_subcommand(0, 1)
            : known.front();
    return blank < 0 ? app : addCommand(*app, name.mid(blank + 1));
}

void addCommand(CLI::App& root, const Command& command, Slots& into)
{
    into.command = &command;
    into.app = addCommand(root, QLatin1String(command.name));
    int number = 0;
    for (const Positional& positional : command.positionals) {
        auto& slot = into.positionals.emplace_back();
        CLI::Option* option = into.app->add_option("p" + std::to_string(number++), slot);
        if (positional.max == many)
            option->expected(1, CLI::detail::expected_max_vector_size);
        else
            option->expected(1)->allow_extra_args(false);
    }
    addOptions(*into.app, command.options, into);
}

base::Result<Values> valuesOf(const Slots& from)
{
    Values values;
    auto slot = from.positionals.begin();
    for (const Positional& positional : from.command->positionals) {
        QStringList words;
        for (const std::string& word : *slot)
            words << QString::fromStdString(word);
        ++slot;
        if (words.size() < positional.min)
            return badArgument(
                translate("cli", "%1 is missing").arg(QString::fromUtf8(positional.name)));
        values.positionals.insert(QString::fromUtf8(positional.name), words);
    }
    return values;
}

void takeOptions(const Slots& from, Values& values)
{
    for (const auto& [option, value] : from.options) {
        if (from.app->count(option->flag) == 0)
            continue;
        const QString flag = QLatin1String(option->flag);
        if (option->value != nullptr)
            values.options.insert(flag, QString::fromStdString(value));
        else
            values.switches << flag;
    }
}

base::Result<Globals> globalsOf(const Values& values)
{
    Globals globals;
    globals.port = values.option("--port").value_or(QString());
    if (const auto baud = values.option("--baud")) {
        globals.autoBaud = *baud == QLatin1String("auto");
        const auto rates = parseBauds(globals.autoBaud ? QStringLiteral("all") : *baud);
        if (!rates)
            return tl::unexpected(rates.error());
        if (!globals.autoBaud)
            globals.baud = rates->front();
    }
    if (const auto word = values.option("--protocol")) {
        const auto protocol = parseProtocol(*word);
        if (!protocol)
            return tl::unexpected(protocol.error());
        globals.protocol = *protocol;
    }
    if (const auto silence = values.option("--silence")) {
        const auto us = parseInt(*silence, 0, maxSilenceUs);
        if (!us)
            return tl::unexpected(us.error());
        globals.frameSilence = std::chrono::microseconds(*us);
    }
    if (const auto timeout = values.option("--timeout")) {
        const auto ms = parseInt(*timeout, 1, maxTimeoutMs);
        if (!ms)
            return tl::unexpected(ms.error());
        globals.maxReplyLateness = std::chrono::milliseconds(*ms);
    }
    if (const auto retries = values.option("--retries")) {
        const auto number = parseInt(*retries, 0, maxRetries);
        if (!number)
            return tl::unexpected(number.error());
        globals.retries = *number;
    }
    return globals;
}

tl::unexpected<base::Error> parseFailure(const QString& word, bool commandKnown)
{
    QStringList known;
    for (const Command& command : commands())
        known << QString::fromLatin1(command.name);
    QStringList near =
        commandKnown || word.startsWith(QLatin1Char('-')) ? QStringList() : nearest(word, known);
    if (near.isEmpty() && !commandKnown) { // the first of two words may be wrong
        for (QString& name : known)
            name = name.section(QLatin1Char(' '), 0, 0);
        known.removeDuplicates();
        near = nearest(word, known);
    }
    if (!near.isEmpty())
        return badArgument(translate("cli", "unknown command \"%1\"; did you mean %2?")
                               .arg(word, text::joinItems(near)));
    if (!commandKnown && !word.startsWith(QLatin1Char('-')))
        return badArgument(translate("cli", "unknown command \"%1\"").arg(word));
    return badArgument(translate("cli", "unexpected argument \"%1\"").arg(word));
}

/// The parser of one command line; CLI11 refers to its slots.
class Parser {
public:
    Parser();
    base::Result<ParsedCommandLine> parse(const QStringList& arguments);

private:
    base::Result<ParsedCommandLine> result();
    base::Result<ParsedCommandLine> helpOn(const QStringList& words) const;
    const Slots* chosen() const;

    CLI::App m_app;
    CLI::App* m_help;
    Slots m_helpOptions;
    Slots m_globals;
    std::list<Slots> m_commands;
};

Parser::Parser()
{
    m_app.allow_extras()->require_subcommand(0, 1);
    m_app.set_version_flag("--version", "");
    m_help = m_app.add_subcommand("help")->allow_extras();
    addOptions(*m_help, globalOptions(), m_helpOptions);
    m_globals.app = &m_app;
    addOptions(m_app, globalOptions(), m_globals);
    for (const Command& command : commands())
        addCommand(m_app, command, m_commands.emplace_back());
}

const Slots* Parser::chosen() const
{
    const auto it = std::find_if(m_commands.begin(), m_commands.end(),
                                 [](const Slots& slots) { return slots.app->parsed(); });
    return it == m_commands.end() ? nullptr : &*it;
}

base::Result<ParsedCommandLine> Parser::result()
{
    if (m_help->parsed()) {
        QStringList words;
        for (const std::string& word : m_help->remaining())
            words << QString::fromStdString(word);
        return helpOn(words);
    }
    const Slots* command = chosen();
    const auto rest = m_app.remaining(true);
    if (!rest.empty())
        return parseFailure(QString::fromStdString(rest.front()), command != nullptr);
    if (command == nullptr)
        return badArgument(translate("cli", "a command is required; --help lists all commands"));
    Values global;
    takeOptions(m_globals, global);
    const auto globals = globalsOf(global);
    if (!globals)
        return tl::unexpected(globals.error());
    auto values = valuesOf(*command);
    if (!values)
        return tl::unexpected(values.error());
    takeOptions(*command, *values);
    return ParsedCommandLine{ParsedCommandLine::Action::Command, command->command,
                             std::move(*values), *globals, global.has("--json")};
}

/// As COMMAND --help does.
base::Result<ParsedCommandLine> Parser::helpOn(const QStringList& words) const
{
    ParsedCommandLine help;
    help.action = ParsedCommandLine::Action::Help;
    if (words.isEmpty())
        return help;
    const QString wanted = words.join(QLatin1Char(' '));
    for (const Command& command : commands()) {
        if (wanted == QLatin1String(command.name))
            help.command = &command;
    }
    if (help.command == nullptr)
        return parseFailure(wanted, false);
    return help;
}

base::Result<ParsedCommandLine> Parser::parse(const QStringList& arguments)
{
    // CLI11 expects the last one first.
    std::vector<std::string> words;
    for (auto it = arguments.crbegin(); it != arguments.crend(); ++it)
        words.push_back(it->toStdString());
    try {
        m_app.parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        ParsedCommandLine help;
        help.action = ParsedCommandLine::Action::Help;
        help.command = chosen() != nullptr ? chosen()->command : nullptr;
        return help;
    } catch (const CLI::CallForVersion&) {
        ParsedCommandLine version;
        version.action = ParsedCommandLine::Action::Version;
        return version;
    } catch (const CLI::ArgumentMismatch& error) {
        return badArgument(translate("cli", "an option has no value or is used twice (%1)")
                               .arg(QString::fromUtf8(error.what())));
    } catch (const CLI::Error& error) {
        return badArgument(QString::fromUtf8(error.what()));
    }
    return result();
}
} // namespace

const std::vector<Option>& globalOptions()
{
    static const std::vector<Option> options{
        {"--port",
         QT_TRANSLATE_NOOP(
             "cli", "device path, tcp://HOST:PORT, or a simulated bus (reset at each start): "
                    "sim:demo, sim:trouble, sim:modbus, sim:lx, sim:sts3215@1,lx16a@2"),
         "P"},
        {"--baud",
         QT_TRANSLATE_NOOP("cli", "baud rate, or auto to try all (default: 1000000; 115200 for "
                                  "LX and Modbus)"),
         "N|auto"},
        {"--protocol",
         QT_TRANSLATE_NOOP("cli", "servo protocol: auto, feetech, modbus or lx (default: auto, "
                                  "which tries all protocols possible at the baud rate)"),
         "NAME"},
        {"--timeout",
         QT_TRANSLATE_NOOP(
             "cli", "reply timeout in milliseconds, in addition to the transmission time (default: "
                    "25, longer for slow adapters; a servo counts as silent after 500 ms)"),
         "MS"},
        {"--retries", QT_TRANSLATE_NOOP("cli", "number of retries after a communication error"),
         "N"},
        {"--silence",
         QT_TRANSLATE_NOOP("cli", "silence between Modbus frames in microseconds (default: 1750 "
                                  "above 19200 baud, as in the standard)"),
         "US"},
        {"--json",
         QT_TRANSLATE_NOOP("cli", "print the result as a single JSON document (commission: one "
                                  "line per servo)")},
        {"--lang", QT_TRANSLATE_NOOP("cli", "output language"), "en|zh_CN"},
    };
    return options;
}

base::Result<QString> requestedLanguage(const QStringList& arguments)
{
    QString language;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == QLatin1String("--lang"))
            language = arguments.value(i + 1);
        else if (arguments[i].startsWith(QLatin1String("--lang=")))
            language = arguments[i].mid(7);
        else
            continue;
        if (language != QLatin1String("en") && language != QLatin1String("zh_CN"))
            return badArgument(
                translate("cli", "unsupported language \"%1\" (en, zh_CN)").arg(language));
    }
    return language;
}

base::Result<ParsedCommandLine> parseCommandLine(const QStringList& arguments)
{
    return Parser().parse(arguments);
}
} // namespace cli
