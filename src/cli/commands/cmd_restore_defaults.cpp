// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/change/change.h"
#include "text/language.h"
#include "text/notice_text.h"

namespace cli {
namespace {
Json jsonRestore(const jobs::RestoreDefaultsReport& report)
{
    return Json::object()
        .add("id", report.newId)
        .add("old_id", report.oldId)
        .add("old_baud", report.oldBaud)
        .add("baud", report.newBaud)
        .add("changed", QStringList(report.changed.begin(), report.changed.end()))
        .add("lock", device::lockName(report.lock));
}

QString restoreText(const jobs::RestoreDefaultsReport& report)
{
    const QStringList changed(report.changed.begin(), report.changed.end());
    QStringList lines;
    lines << translate("cli", "The servo replies as ID %1 at %2 baud.")
                 .arg(report.newId)
                 .arg(report.newBaud);
    lines << (changed.isEmpty()
                  ? translate("cli", "No registers have changed.")
                  : translate("cli", "Changed registers: %1").arg(text::joinItems(changed)));
    lines << translate("cli", "EPROM lock: %1").arg(text::lockLabel(device::lockName(report.lock)));
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

base::Result<Exit> runRestoreDefaults(Run& run, const Values& values)
{
    auto servo = run.servoWithSettings(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    base::Result<jobs::RestoreDefaultsReport> report;
    {
        ProgressLine line(run.console(), translate("cli", "Restoring"));
        report = jobs::restoreDefaults(
            *context, *servo, [&line](const jobs::Progress& progress) { line.update(progress); });
    }
    if (!report)
        return tl::unexpected(report.error());
    run.finish(jsonRestore(*report), restoreText(*report));
    return exitCode(report->lock);
}
} // namespace

Command restoreDefaultsCommand()
{
    return {"restore-defaults",
            QT_TRANSLATE_NOOP("cli",
                              "restore the parameters stored in the servo (instruction 0x06); "
                              "the ID and baud rate may change, so connect only this servo"),
            {servoIdArgument},
            {},
            runRestoreDefaults};
}
} // namespace cli
