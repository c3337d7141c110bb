// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/scan/scan.h"
#include "transport/port_opener.h"

#include <algorithm>
#include <map>
#include <set>

namespace cli {
namespace {
using Version = std::pair<int, int>;

struct FirmwareRow {
    const device::Servo* servo;
    std::optional<Version> version; ///< none: the servo reports none
    std::optional<catalog::KnownFirmware> newer;
    bool differs = false; ///< from most servos of its model
};

/// Of versions that are equally frequent the newest counts.
Version mostFrequentVersion(const std::vector<Version>& versions)
{
    std::map<Version, int> counts;
    for (const Version& version : versions)
        ++counts[version];
    return std::max_element(counts.begin(), counts.end(),
                            [](const auto& a, const auto& b) {
                                return std::pair(a.second, a.first) < std::pair(b.second, b.first);
                            })
        ->first;
}

std::vector<FirmwareRow> firmwareRows(const jobs::ScanReport& report,
                                      const catalog::Catalog& catalog)
{
    std::vector<FirmwareRow> rows;
    std::map<QString, std::vector<Version>> byModel;
    for (const jobs::FoundServo& found : report.found) {
        FirmwareRow row{&found.servo, {}, {}};
        if (const catalog::Profile* profile = found.servo.profile.get()) {
            const catalog::Identity& identity = profile->identity;
            row.newer = catalog.newerFirmware(*profile);
            if (identity.firmwareMajor >= 0) {
                row.version = Version(identity.firmwareMajor, identity.firmwareMinor);
                byModel[identity.modelId()].push_back(*row.version);
            }
        }
        rows.push_back(row);
    }
    for (FirmwareRow& row : rows) {
        if (row.version)
            row.differs = *row.version !=
                          mostFrequentVersion(byModel[row.servo->profile->identity.modelId()]);
    }
    return rows;
}

/// LeRobot compares all servos of a bus, whatever their model.
bool isSameEverywhere(const std::vector<FirmwareRow>& rows)
{
    std::set<Version> versions;
    for (const FirmwareRow& row : rows) {
        if (row.version)
            versions.insert(*row.version);
    }
    return versions.size() <= 1;
}

Json jsonRow(const FirmwareRow& row)
{
    const catalog::Profile* profile = row.servo->profile.get();
    Json json = Json::object();
    json.add("id", row.servo->id)
        .add("baud", row.servo->baud)
        .add("model", profile != nullptr ? Json(profile->modelName) : Json())
        .add("model_id", profile != nullptr ? Json(profile->identity.modelId()) : Json())
        .add("firmware", row.version ? Json(profile->identity.firmware()) : Json())
        .add("differs", row.differs);
    json.add("newer", row.newer ? Json::object()
                                      .add("version", row.newer->version())
                                      .add("date", row.newer->date.toString(Qt::ISODate))
                                      .add("source", row.newer->source)
                                : Json());
    return json;
}

Table tableOf(const std::vector<FirmwareRow>& rows)
{
    Table table({translate("cli", "ID"), translate("cli", "Model"),
                 translate("cli", "Model number"), translate("cli", "Firmware"),
                 translate("cli", "Newer version known"), translate("cli", "Note")});
    table.alignRight({0});
    for (const FirmwareRow& row : rows) {
        const catalog::Profile* profile = row.servo->profile.get();
        const QString newer =
            row.newer
                ? QStringLiteral("%1 (%2)").arg(row.newer->version(),
                                                row.newer->date.toString(QStringLiteral("yyyy-MM")))
                : noValue();
        table.add({QString::number(row.servo->id),
                   profile != nullptr ? profile->modelName : QStringLiteral("?"),
                   profile != nullptr ? profile->identity.modelId() : QStringLiteral("?"),
                   row.version ? profile->identity.firmware() : QStringLiteral("?"), newer,
                   row.differs ? translate("cli", "differs from the others") : QString()});
    }
    return table;
}

QString remarks(const std::vector<FirmwareRow>& rows)
{
    QStringList lines;
    if (!isSameEverywhere(rows))
        lines << translate("cli",
                           "The firmware versions differ. LeRobot refuses a bus whose servos "
                           "do not all have the same version.");
    if (std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.newer; }))
        lines << translate("cli", "Newer versions are listed in the vendor's firmware catalog; "
                                  "they may not be the latest.");
    return lines.isEmpty() ? QString() : lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

base::Result<Exit> runFirmwareList(Run& run, const Values& values)
{
    jobs::ScanSpec spec;
    if (const auto bauds = values.option("--bauds")) {
        const auto rates = parseBauds(*bauds);
        if (!rates)
            return tl::unexpected(rates.error());
        spec.bauds = *rates;
    } else if (run.globals().autoBaud) {
        spec.bauds = transport::standardBaudRates();
    }
    if (run.globals().protocol)
        spec.protocols = {*run.globals().protocol};
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    base::Result<jobs::ScanReport> report;
    {
        ProgressLine line(run.console(), translate("cli", "Searching"));
        report = jobs::scan(*context, spec,
                            [&line](const jobs::Progress& progress) { line.update(progress); });
    }
    if (!report)
        return tl::unexpected(report.error());
    const std::vector<FirmwareRow> rows = firmwareRows(*report, run.session().catalog());
    Json::Array servos;
    for (const FirmwareRow& row : rows)
        servos.push_back(jsonRow(row));
    Json document = Json::object();
    document.add("port", report->port)
        .add("servos", std::move(servos))
        .add("same_firmware", isSameEverywhere(rows));
    if (report->stopped)
        document.add("stopped", true);
    const QString text = rows.empty() ? translate("cli", "No servo replied.") + QLatin1Char('\n')
                                      : tableOf(rows).text() + remarks(rows);
    run.finish(document, text);
    return report->stopped ? Exit::Failed : rows.empty() ? Exit::NoReply : Exit::Success;
}
} // namespace

Command firmwareListCommand()
{
    return {"firmware list",
            QT_TRANSLATE_NOOP("cli", "list the servos' firmware versions, and those that differ"),
            {},
            {{"--bauds", QT_TRANSLATE_NOOP("cli", "baud rates to use for the search"), "all|N,N…"}},
            runFirmwareList};
}
} // namespace cli
