// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_search.h"

#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/translate.h"
#include "text/language.h"
#include "transport/port_opener.h"

#include <algorithm>

namespace cli {
namespace {
base::Result<jobs::ScanSpec> specOf(const Run& run, const Values& values)
{
    jobs::ScanSpec spec;
    if (const auto ids = values.option("--ids")) {
        const auto range = parseIdRange(*ids);
        if (!range)
            return tl::unexpected(range.error());
        spec.firstId = range->first;
        spec.lastId = range->last;
    }
    if (const auto bauds = values.option("--bauds")) {
        const auto rates = parseBauds(*bauds);
        if (!rates)
            return tl::unexpected(rates.error());
        spec.bauds = *rates;
    } else if (run.globals().autoBaud) {
        spec.bauds = transport::standardBaudRates();
    }
    spec.slowPass = values.has("--slow");
    if (run.globals().protocol)
        spec.protocols = {*run.globals().protocol};
    return spec;
}

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
} // namespace

std::vector<Option> searchOptions()
{
    return {{"--ids", QT_TRANSLATE_NOOP("cli", "only these IDs (default: 0-253)"), "A-B"},
            {"--bauds", QT_TRANSLATE_NOOP("cli", "baud rates to use for the search"), "all|N,N…"},
            {"--slow",
             QT_TRANSLATE_NOOP("cli", "retry IDs that did not reply, using a longer timeout")}};
}

base::Result<jobs::ScanReport> searchBus(Run& run, const Values& values)
{
    const auto spec = specOf(run, values);
    if (!spec)
        return tl::unexpected(spec.error());
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    ProgressLine line(run.console(), translate("cli", "Searching"));
    return jobs::scan(*context, *spec,
                      [&line](const jobs::Progress& progress) { line.update(progress); });
}

Json jsonScan(const jobs::ScanReport& report)
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

QString scanNote(const jobs::FoundServo& found)
{
    if (found.duplicateSuspected)
        return translate("cli", "possibly two servos with this ID");
    const bool unclear = found.servo.profile && found.servo.profile->conflict;
    return unclear ? translate("cli", "family unclear, so read-only") : QString();
}

QString notFoundText(const jobs::ScanReport& report)
{
    if (!report.found.empty())
        return {};
    QStringList rates;
    for (const int rate : report.rates)
        rates << QString::number(rate);
    return translate("cli",
                     "No servo replied. Check the power supply and wiring, and try --bauds all.") +
           QLatin1Char('\n') +
           translate("cli", "Searched at %1 baud. Only Feetech servos use 1000000 baud; LX, Modbus "
                            "and most SMS servos use 115200.")
               .arg(text::joinItems(rates)) +
           QLatin1Char('\n');
}

QString scanRemarks(const jobs::ScanReport& report)
{
    QStringList lines;
    if (report.hasGarbledReplies)
        lines << translate(
            "cli", "Unreadable data was received, but no servo could be confirmed. Possible "
                   "causes: a different baud rate, two servos with the same ID, or noise.");
    if (std::any_of(report.found.begin(), report.found.end(),
                    [](const jobs::FoundServo& found) { return found.duplicateSuspected; }))
        lines << translate("cli", "New servos all have the same ID. Connect them one at a time and "
                                  "give each its own ID: servodesk-cli commission --help");
    if (report.slowPassAdvised)
        lines << translate(
            "cli",
            "Several servos replied late, so others may have been missed. Try again with --slow.");
    for (const int rate : report.unsupportedRates)
        lines << translate("cli", "This adapter does not support %1 baud.").arg(rate);
    for (const int rate : report.busyRates)
        lines << translate("cli", "At %1 baud, the bus is never idle: a device is sending "
                                  "continuously. Servos may have been missed.")
                     .arg(rate);
    if (report.stopped)
        lines << translate("cli", "The search was stopped early.");
    return lines.isEmpty() ? QString() : lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}
} // namespace cli
