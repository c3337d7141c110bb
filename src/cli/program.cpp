// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/program.h"

#include "cli/completion.h"
#include "cli/output/report_text.h"
#include "cli/parser.h"
#include "cli/translate.h"
#include "text/language.h"

#include <cerrno>
#include <system_error>

namespace cli {
namespace {
Exit report(const base::Error& error, Console& console)
{
    if (console.isJson())
        console.write(Json::object().add("error", jsonError(error)).text());
    else
        console.printMessage(errorText(error));
    return exitCode(error.code);
}

/// A reader that has ended ("| head") needs no message; a full disk does.
Exit checkOutput(Exit exit, Console& console)
{
    if (!console.writeError())
        return exit;
    if (*console.writeError() != EPIPE) {
        const auto why = std::generic_category().message(*console.writeError());
        console.printMessage(translate("cli", "The result could not be written: %1")
                                 .arg(QString::fromStdString(why)));
    }
    return exit == Exit::Success ? Exit::File : exit;
}

Exit runCommand(const ParsedCommandLine& parsed, Console& console, const base::StopToken& stop)
{
    Run run(parsed.globals, console, stop);
    const auto done = parsed.command->run(run, parsed.values);
    if (done)
        return *done == Exit::Success && run.hasUnrecordedChange() ? Exit::File : *done;
    run.fail(done.error());
    return exitCode(done.error().code);
}
} // namespace

int runProgram(const QStringList& arguments, const base::StopToken& stop)
{
    Console console(arguments.contains(QLatin1String("--json")));
    text::installTranslator({});
    const auto language = requestedLanguage(arguments);
    if (!language)
        return report(language.error(), console);
    text::installTranslator(*language);
    if (arguments.value(0) == QLatin1String("--complete")) {
        console.write(completionText(completionsOf(arguments.value(1))).toUtf8());
        return checkOutput(Exit::Success, console);
    }
    const auto parsed = parseCommandLine(arguments);
    if (!parsed)
        return report(parsed.error(), console);
    Exit exit = Exit::Success;
    switch (parsed->action) {
    case ParsedCommandLine::Action::Help:
        console.write(console.isJson() ? helpJson(parsed->command).text()
                                       : helpText(parsed->command).toUtf8());
        break;
    case ParsedCommandLine::Action::Version:
        console.write("servodesk-cli " + QCoreApplication::applicationVersion().toUtf8() + '\n');
        break;
    case ParsedCommandLine::Action::Command:
        exit = runCommand(*parsed, console, stop);
        break;
    }
    return checkOutput(exit, console);
}
} // namespace cli
