// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/recover_text.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/recover/recover.h"
#include "text/error_text.h"

#include <algorithm>
#include <iterator>

namespace cli {
namespace {
QString nothingOpen(const UncheckedChanges& elsewhere)
{
    return elsewhere.intents.empty()
               ? translate("cli", "No unfinished changes.") + QLatin1Char('\n')
               : translate("cli", "No unfinished changes on %1.").arg(elsewhere.port) +
                     QLatin1Char('\n');
}

void show(Run& run, const std::vector<jobs::RecoveryResult>& all, jobs::RecoveryAction action,
          const UncheckedChanges& elsewhere)
{
    Json::Array intents;
    for (const jobs::RecoveryResult& one : all)
        intents.push_back(jsonRecovered(one));
    QString text = all.empty() ? nothingOpen(elsewhere) : recoveredTable(all, action).text();
    for (const jobs::RecoveryResult& one : all)
        text += changesBelow(one.before.intent) + notWrittenLine(one) +
                userConfirmedText(one, elsewhere.port);
    for (const jobs::RecoveryResult& one : all) {
        if (one.error)
            text += text::describe(*one.error).message + QLatin1Char('\n');
    }
    if (!all.empty() && action == jobs::RecoveryAction::Preview)
        text += translate("cli", "Nothing was written. Use --finish to complete the changes, "
                                 "--undo to restore the old values, or --forget to abandon a "
                                 "change whose servo will not be connected again.") +
                QLatin1Char('\n');
    Json document = Json::object().add("intents", std::move(intents));
    elsewhere.addTo(document, "elsewhere");
    addRecoverCommand(document, elsewhere);
    run.finish(std::move(document), text + elsewhere.text(otherPortsTitle()));
}

/// Lists the unfinished changes although the port cannot be opened.
base::Result<Exit> showWithoutPort(Run& run, const std::vector<base::Intent>& open,
                                   const base::Error& why)
{
    const UncheckedChanges elsewhere{jobs::startedOnOtherPorts(open, run.portName()), {}};
    UncheckedChanges own{{}, run.portName(), false};
    std::copy_if(open.begin(), open.end(), std::back_inserter(own.intents),
                 [&](const base::Intent& intent) { return intent.servo.port == own.port; });
    if (elsewhere.intents.empty() && own.intents.empty())
        return tl::unexpected(why);
    if (!run.console().isJson()) {
        run.console().print(own.text(translate("cli", "Unfinished changes on this port:")) +
                            elsewhere.text(otherPortsTitle()));
        return tl::unexpected(why);
    }
    Json document = Json::object();
    own.addTo(document, "here");
    elsewhere.addTo(document, "elsewhere");
    addRecoverCommand(document, own, elsewhere);
    run.finish(std::move(document.add("error", jsonError(why))), {});
    return exitCode(why.code);
}

Exit exitOf(const std::vector<jobs::RecoveryResult>& all, jobs::RecoveryAction action)
{
    Exit exit = Exit::Success;
    for (const jobs::RecoveryResult& one : all) {
        if (one.done || action == jobs::RecoveryAction::Preview || exit != Exit::Success)
            continue;
        exit = one.error                                      ? exitCode(one.error->code)
               : one.before.finding == jobs::Finding::NoReply ? Exit::NoReply
                                                              : Exit::Failed;
    }
    return exit;
}

/// The one change whose name starts with `which`.
base::Result<std::vector<base::Intent>> changeNamed(std::vector<base::Intent> open,
                                                    const QString& which)
{
    std::erase_if(open, [&](const base::Intent& one) { return !one.uuid.startsWith(which); });
    if (open.empty())
        return badArgument(translate("cli", "no unfinished change \"%1\"").arg(which));
    if (open.size() > 1)
        return badArgument(
            translate("cli", "the names of several changes start with \"%1\"").arg(which));
    return open;
}

/// Marks changes as abandoned, for servos that will not return. Needs no port. Changes that another
/// program is making are not abandoned.
base::Result<Exit> forget(Run& run, const std::vector<base::Intent>& open, const QString& which)
{
    const auto chosen = which == QLatin1String("all") ? open : changeNamed(open, which);
    if (!chosen)
        return tl::unexpected(chosen.error());
    QStringList forgotten;
    Json::Array details;
    QString lines;
    UncheckedChanges running;
    for (const base::Intent& intent : *chosen) {
        if (intent.isActiveElsewhere) {
            running.intents.push_back(intent);
            continue;
        }
        if (const auto ended = jobs::forget(run.session().journal(), intent); !ended)
            return tl::unexpected(ended.error());
        forgotten << intent.uuid;
        details.push_back(jsonDiscarded(intent));
        lines += discardedText(intent);
    }
    Json document = Json::object().add("forgotten", forgotten).add("given_up", std::move(details));
    running.addTo(document, "under_way");
    run.finish(std::move(document),
               translate("cli", "%n change(s) abandoned", nullptr, int(forgotten.size())) +
                   QLatin1Char('\n') + lines + running.advice());
    return running.intents.empty() ? Exit::Success : Exit::Failed;
}

/// The change named with --change, or all.
base::Result<std::vector<base::Intent>> chosenChanges(std::vector<base::Intent> open,
                                                      const Values& values)
{
    const auto which = values.option("--change");
    return which ? changeNamed(std::move(open), *which) : open;
}

/// A change from another port that still exists must be named, because that port has its own servo.
jobs::RecoveryOptions optionsOf(Run& run, const std::vector<base::Intent>& open,
                                const Values& values)
{
    jobs::RecoveryOptions options;
    const bool named = values.option("--change").has_value();
    if (values.has("--any-port"))
        options.ports = named ? jobs::IntentPorts::Any : jobs::IntentPorts::IncludingMissing;
    if (named)
        options.uuid = open.front().uuid;
    options.beforeWrite = [&run](const device::Context& inner, device::Servo& servo) {
        return run.backupTable(inner, servo);
    };
    return options;
}

base::Result<Exit> runRecovery(Run& run, const std::vector<base::Intent>& open,
                               jobs::RecoveryAction action, const Values& values)
{
    run.listsOpenChanges();
    const auto context = run.context();
    if (!context)
        return showWithoutPort(run, open, context.error());
    const jobs::RecoveryOptions options = optionsOf(run, open, values);
    std::optional<ProgressLine> line;
    line.emplace(run.console(), action == jobs::RecoveryAction::Preview
                                    ? translate("cli", "Comparing with the servos")
                                    : translate("cli", "Recovering"));
    const auto recovered =
        jobs::recover(*context, action, options,
                      [&line](const jobs::Progress& progress) { line->update(progress); });
    line.reset();
    if (!recovered)
        return tl::unexpected(recovered.error());
    const QString port = context->bus.portName();
    const UncheckedChanges elsewhere{jobs::startedOnOtherPorts(open, port, options.ports), port};
    show(run, *recovered, action, elsewhere);
    const Exit exit = exitOf(*recovered, action);
    return exit == Exit::Success && !elsewhere.intents.empty() ? Exit::Failed : exit;
}

base::Result<Exit> runRecover(Run& run, const Values& values)
{
    if (values.has("--finish") && values.has("--undo"))
        return badArgument(translate("cli", "use either --finish or --undo, not both"));
    const auto action = values.has("--finish") ? jobs::RecoveryAction::Finish
                        : values.has("--undo") ? jobs::RecoveryAction::Undo
                                               : jobs::RecoveryAction::Preview;
    const auto open = run.session().journal().open();
    if (!open)
        return tl::unexpected(open.error());
    if (const auto which = values.option("--forget"))
        return forget(run, *open, *which);
    const auto chosen = chosenChanges(*open, values);
    if (!chosen)
        return tl::unexpected(chosen.error());
    if (chosen->empty()) {
        show(run, {}, action, {});
        return Exit::Success;
    }
    return runRecovery(run, *chosen, action, values);
}
} // namespace

Command recoverCommand()
{
    return {"recover",
            QT_TRANSLATE_NOOP("cli", "show unfinished changes, and finish or undo them"),
            {},
            {{"--finish", QT_TRANSLATE_NOOP("cli", "complete the changes")},
             {"--undo", QT_TRANSLATE_NOOP("cli", "restore the old values")},
             {"--forget",
              QT_TRANSLATE_NOOP("cli",
                                "abandon a change whose servo will not be connected again, or all "
                                "(the first characters of the change name are enough)"),
              "CHANGE|all"},
             {"--change",
              QT_TRANSLATE_NOOP("cli", "only this change (the first characters of its name are "
                                       "enough)"),
              "CHANGE"},
             {"--any-port",
              QT_TRANSLATE_NOOP("cli", "include changes started on ports that no longer exist and, "
                                       "with --change, on ports that still exist. The exit code is "
                                       "1 while changes started on other ports are unfinished")}},
            runRecover};
}
} // namespace cli
