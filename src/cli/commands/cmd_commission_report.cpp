// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "report/commission_report.h"
#include "report/report_file.h"
#include "text/language.h"

#include <QFileInfo>

namespace cli {
namespace {
base::Result<Exit> runReport(Run& run, const Values& values)
{
    const QString csv = values.argument("BATCH");
    const QString path = values.argument("FILE");
    if (!report::isReportPath(path))
        return badArgument(translate("cli", "the report file name must end with .html or .pdf"));
    if (!QFileInfo::exists(csv))
        return base::fail(base::ErrorCode::FileMissing, QStringLiteral("load-batch"), csv);
    const auto batch = results::openCommissionBatch(csv);
    if (!batch)
        return tl::unexpected(batch.error());
    if (batch->rows.empty() && batch->pending.empty())
        return badArgument(translate("cli", "%1 contains no servos").arg(csv));
    const auto saved =
        report::saveCommissionReport(*batch, QFileInfo(csv).fileName(), text::isUiChinese(), path);
    if (!saved)
        return tl::unexpected(saved.error());
    run.finish(Json::object().add("batch", csv).add("file", path),
               translate("cli", "Report: %1").arg(path) + QLatin1Char('\n'));
    return Exit::Success;
}
} // namespace

Command commissionReportCommand()
{
    return {"commission-report",
            QT_TRANSLATE_NOOP("cli", "create a report of a commissioning batch; no port is needed"),
            {{"BATCH", QT_TRANSLATE_NOOP("cli", "batch file (.csv)")},
             {"FILE", QT_TRANSLATE_NOOP("cli", "report file: .html or .pdf")}},
            {},
            runReport};
}
} // namespace cli
