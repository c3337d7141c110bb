// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_search.h"
#include "cli/commands.h"
#include "cli/output/report_text.h"
#include "cli/translate.h"
#include "text/notice_text.h"

namespace cli {
namespace {
Json jsonFound(const jobs::FoundServo& found)
{
    const catalog::Profile* profile = found.servo.profile.get();
    Json json = Json::object();
    json.add("id", found.servo.id)
        .add("protocol", base::protocolName(found.servo.protocol))
        .add("model", profile != nullptr ? Json(profile->modelName) : Json())
        .add("model_id", profile != nullptr ? Json(profile->identity.modelId()) : Json())
        .add("map", profile != nullptr ? Json(profile->mapKey) : Json())
        .add("firmware", profile != nullptr ? Json(profile->identity.firmware()) : Json())
        .add("baud", found.servo.baud)
        .add("status", jsonAlarms(found.servo.status, profile));
    if (found.duplicateSuspected)
        json.add("twins_suspected", true);
    return json;
}

Json jsonReport(const jobs::ScanReport& report)
{
    Json::Array servos;
    for (const jobs::FoundServo& found : report.found)
        servos.push_back(jsonFound(found));
    const auto elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(report.elapsed);
    Json json = Json::object();
    json.add("port", report.port)
        .add("elapsed_ms", std::int64_t{elapsed.count()})
        .add("found", std::move(servos));
    Json::Array refused(report.unsupportedRates.begin(), report.unsupportedRates.end());
    if (!refused.empty())
        json.add("rates_refused", std::move(refused));
    Json::Array busy(report.busyRates.begin(), report.busyRates.end());
    if (!busy.empty())
        json.add("rates_busy", std::move(busy));
    if (report.slowPassAdvised)
        json.add("slow_pass_advised", true);
    if (report.stopped)
        json.add("stopped", true);
    return json;
}

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
    run.finish(jsonReport(*report), table + summary + QLatin1Char('\n') + scanRemarks(*report));
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
