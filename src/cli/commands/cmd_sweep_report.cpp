// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/run.h"
#include "cli/sweep_history.h"
#include "cli/translate.h"
#include "report/sweep_html.h"
#include "report/sweep_pdf.h"
#include "results/sweep_csv.h"
#include "results/sweep_json.h"
#include "session/sweep/sweep_report.h"
#include "text/language.h"

namespace cli {
namespace {
/// Without position charts, because the history does not contain the readings.
base::Result<void> save(const results::SweepRun& run, session::SweepFormat format,
                        const QString& path)
{
    switch (format) {
    case session::SweepFormat::Html:
        return report::saveSweepHtml(run, {}, text::isUiChinese(), path);
    case session::SweepFormat::Pdf:
        return report::saveSweepPdf(run, {}, text::isUiChinese(), path);
    case session::SweepFormat::Csv:
        return results::saveSweepLegs(run, path);
    case session::SweepFormat::Json:
        break;
    }
    return results::saveSweepRun(run, path);
}

base::Result<Exit> runSweepReport(Run& run, const Values& values)
{
    const QString path = values.argument("FILE");
    const auto format = session::sweepFormatOf(path);
    if (!format)
        return badArgument(
            translate("cli", "the report file name must end with .html, .pdf, .json or .csv"));
    const auto word = parseRunSelector(values.argument("RUN"));
    if (!word)
        return tl::unexpected(word.error());
    const auto sweep = loadSweep(*word);
    if (!sweep)
        return tl::unexpected(sweep.error());
    if (const auto saved = save(*sweep, *format, path); !saved)
        return tl::unexpected(saved.error());
    run.finish(Json::object().add("run", word->name).add("file", path),
               translate("cli", "Report: %1").arg(path) + QLatin1Char('\n'));
    return Exit::Success;
}
} // namespace

Command sweepReportCommand()
{
    return {"sweep-report",
            QT_TRANSLATE_NOOP("cli", "create a report of an earlier sweep test; no port is needed"),
            {{"RUN",
              QT_TRANSLATE_NOOP("cli", "test run number in the history, or a .json report file")},
             {"FILE", QT_TRANSLATE_NOOP("cli", "report file; its extension sets the format: "
                                               ".html, .pdf, .json or .csv")}},
            {},
            runSweepReport};
}
} // namespace cli
