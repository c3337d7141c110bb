// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_search.h"
#include "cli/commands.h"
#include "cli/output/report_text.h"
#include "cli/translate.h"
#include "text/notice_text.h"

namespace cli {
namespace {
Table foundTable(const jobs::ScanReport& report)
{
    Table table({translate("cli", "ID"), translate("cli", "Model"),
                 translate("cli", "Model number"), translate("cli", "Firmware"),
                 translate("cli", "Protocol"), translate("cli", "Register map"),
                 translate("cli", "Baud rate"), translate("cli", "Alarms"),
                 translate("cli", "Note")});
    table.alignRight({0, 6});
    for (const jobs::FoundServo& found : report.found) {
        const catalog::Profile* profile = found.servo.profile.get();
        const bool known = profile != nullptr;
        table.add({QString::number(found.servo.id),
                   known ? profile->modelName : QStringLiteral("?"),
                   known ? profile->identity.modelId() : QStringLiteral("?"),
                   known ? profile->identity.firmware() : QStringLiteral("?"),
                   base::protocolName(found.servo.protocol),
                   known ? profile->mapKey : QStringLiteral("?"), QString::number(found.servo.baud),
                   text::statusText(found.servo.status, profile), scanNote(found)});
    }
    return table;
}

base::Result<Exit> runScan(Run& run, const Values& values)
{
    const auto report = searchBus(run, values);
    if (!report)
        return tl::unexpected(report.error());
    const QString summary =
        translate("cli", "%n servo(s) found on %1 in %2 s", nullptr, int(report->found.size()))
            .arg(report->port)
            .arg(std::chrono::duration<double>(report->elapsed).count(), 0, 'f', 2);
    const QString table = report->found.empty() ? QString() : foundTable(*report).text();
    run.finish(jsonScan(*report),
               table + summary + QLatin1Char('\n') + notFoundText(*report) + scanRemarks(*report));
    return report->stopped ? Exit::Failed : report->found.empty() ? Exit::NoReply : Exit::Success;
}
} // namespace

Command scanCommand()
{
    return {"scan",
            QT_TRANSLATE_NOOP("cli", "search the bus without writing anything"),
            {},
            searchOptions(),
            runScan};
}
} // namespace cli
