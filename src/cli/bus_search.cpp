// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_search.h"

#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/translate.h"
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

QString scanNote(const jobs::FoundServo& found)
{
    if (found.duplicateSuspected)
        return translate("cli", "possibly two servos with this ID");
    const bool unclear = found.servo.profile && found.servo.profile->conflict;
    return unclear ? translate("cli", "family unclear, so read-only") : QString();
}

QString scanRemarks(const jobs::ScanReport& report)
{
    QStringList lines;
    if (report.found.empty()) {
        QStringList rates;
        for (const int rate : report.rates)
            rates << QString::number(rate);
        lines << translate(
                     "cli",
                     "No servo replied. Check the power supply and wiring, and try --bauds all.")
              << translate("cli", "Searched at %1 baud. Only Feetech servos use 1000000 baud; "
                                  "LX, Modbus and most SMS servos use 115200.")
                     .arg(rates.join(QStringLiteral(", ")));
    }
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
