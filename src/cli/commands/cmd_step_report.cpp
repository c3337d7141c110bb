// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses that are stored: shown, compared and saved as reports.
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/step_output.h"
#include "cli/run.h"
#include "cli/sweep_history.h"
#include "cli/translate.h"
#include "jobs/step/step_advice.h"
#include "report/step_report.h"
#include "results/step_json.h"
#include "text/language.h"

namespace cli {
namespace {
base::Result<std::vector<results::StepRun>> loadArgument(const Values& values, const char* name)
{
    const auto word = parseRunSelector(values.argument(name));
    if (!word)
        return tl::unexpected(word.error());
    auto runs = loadSteps(*word);
    if (runs && runs->empty())
        return badArgument(translate("cli", "%1 contains no step response").arg(word->name));
    return runs;
}

std::vector<results::StepAdvice> adviceFor(Run& run, const results::StepRun& step)
{
    return jobs::adviseStoredStep(step, run.session().catalog());
}

base::Result<Exit> runStepReport(Run& run, const Values& values)
{
    const QString path = values.argument("FILE");
    if (const auto known = checkStepReportName(path); !known)
        return tl::unexpected(known.error());
    const auto runs = loadArgument(values, "RUN");
    if (!runs)
        return tl::unexpected(runs.error());
    const auto advice = adviceFor(run, runs->back());
    if (const auto saved = report::saveStepReport(*runs, advice, text::isUiChinese(), path); !saved)
        return tl::unexpected(saved.error());
    run.finish(Json::object().add("run", values.argument("RUN")).add("file", path),
               translate("cli", "Report: %1").arg(path) + QLatin1Char('\n'));
    return Exit::Success;
}

/// Of a report file with several runs the last one counts.
base::Result<Exit> runStepCompare(Run& run, const Values& values)
{
    const auto path = values.option("--report");
    if (path) {
        if (const auto known = checkStepReportName(*path); !known)
            return tl::unexpected(known.error());
    }
    std::vector<results::StepRun> pair;
    for (const char* name : {"A", "B"}) {
        auto runs = loadArgument(values, name);
        if (!runs)
            return tl::unexpected(runs.error());
        pair.push_back(std::move(runs->back()));
    }
    const auto advice = adviceFor(run, pair.back());
    if (path) {
        if (const auto saved = report::saveStepReport(pair, advice, text::isUiChinese(), *path);
            !saved)
            return tl::unexpected(saved.error());
    }
    if (run.console().isJson())
        run.console().write(results::encodeStepRuns(pair, advice));
    else
        run.console().print(
            stepRunsText(pair, advice) +
            (path ? translate("cli", "Report: %1").arg(*path) + QLatin1Char('\n') : QString()));
    return Exit::Success;
}
} // namespace

Command stepReportCommand()
{
    return {
        "step-report",
        QT_TRANSLATE_NOOP("cli", "create a report of an earlier step response; no port is needed"),
        {{"RUN",
          QT_TRANSLATE_NOOP("cli", "test run number in the history, or a .json report file")},
         {"FILE", QT_TRANSLATE_NOOP("cli", "report file; its extension sets the format: "
                                           ".html, .pdf, .json or .csv")}},
        {},
        runStepReport};
}

Command stepCompareCommand()
{
    return {
        "step-compare",
        QT_TRANSLATE_NOOP("cli", "compare two step responses; no port is needed"),
        {{"A",
          QT_TRANSLATE_NOOP(
              "cli",
              "step response before the change: number in the history, or a .json report file")},
         {"B", QT_TRANSLATE_NOOP("cli", "step response after the change")}},
        {{"--report", QT_TRANSLATE_NOOP("cli", "write both step responses to a file"),
          "FILE.html|pdf|json|csv"}},
        runStepCompare};
}
} // namespace cli
