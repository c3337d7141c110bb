// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_search.h"
#include "cli/commands.h"
#include "cli/output/report_text.h"
#include "cli/translate.h"

#include <algorithm>
#include <set>

namespace cli {
namespace {
using Version = std::pair<int, int>;

struct FirmwareRow {
    const jobs::FoundServo* found;
    std::optional<Version> version; ///< none: the servo reports none
    std::optional<catalog::KnownFirmware> newer;
    bool differs = false; ///< from most servos of its model
};

std::vector<FirmwareRow> firmwareRows(const jobs::ScanReport& report,
                                      const catalog::Catalog& catalog)
{
    std::vector<FirmwareRow> rows;
    std::vector<catalog::ProfilePtr> profiles;
    for (const jobs::FoundServo& found : report.found) {
        FirmwareRow row{&found, {}, {}};
        if (const catalog::Profile* profile = found.servo.profile.get()) {
            row.newer = catalog.newerFirmware(*profile);
            if (profile->identity.firmwareMajor >= 0)
                row.version =
                    Version(profile->identity.firmwareMajor, profile->identity.firmwareMinor);
        }
        rows.push_back(row);
        profiles.push_back(found.servo.profile);
    }
    const std::vector<bool> differs = catalog::differingFirmware(profiles);
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].differs = differs[i];
    return rows;
}

/// LeRobot compares all servos of a bus, whatever their model.
std::set<std::optional<Version>> versionsOf(const std::vector<FirmwareRow>& rows)
{
    std::set<std::optional<Version>> versions;
    for (const FirmwareRow& row : rows)
        versions.insert(row.version);
    return versions;
}

Json jsonRow(const FirmwareRow& row)
{
    const catalog::Profile* profile = row.found->servo.profile.get();
    Json json = Json::object();
    json.add("id", row.found->servo.id)
        .add("baud", row.found->servo.baud)
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
                 translate("cli", "Model number"), translate("cli", "Baud rate"),
                 translate("cli", "Firmware"), translate("cli", "Newer version known"),
                 translate("cli", "Note")});
    table.alignRight({0, 3});
    for (const FirmwareRow& row : rows) {
        const catalog::Profile* profile = row.found->servo.profile.get();
        const QString newer =
            row.newer
                ? QStringLiteral("%1 (%2)").arg(row.newer->version(),
                                                row.newer->date.toString(QStringLiteral("yyyy-MM")))
                : noValue();
        table.add(
            {QString::number(row.found->servo.id),
             profile != nullptr ? profile->modelName : QStringLiteral("?"),
             profile != nullptr ? profile->identity.modelId() : QStringLiteral("?"),
             QString::number(row.found->servo.baud),
             row.version ? profile->identity.firmware() : QStringLiteral("?"), newer,
             row.differs ? translate("cli", "differs from the others") : scanNote(*row.found)});
    }
    return table;
}

QString remarks(const std::vector<FirmwareRow>& rows)
{
    QStringList lines;
    std::set<std::optional<Version>> known = versionsOf(rows);
    known.erase(std::nullopt);
    if (known.size() > 1)
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
    const auto report = searchBus(run, values);
    if (!report)
        return tl::unexpected(report.error());
    const std::vector<FirmwareRow> rows = firmwareRows(*report, run.session().catalog());
    Json::Array servos;
    for (const FirmwareRow& row : rows)
        servos.push_back(jsonRow(row));
    const auto versions = versionsOf(rows);
    Json document = Json::object();
    document.add("port", report->port)
        .add("servos", std::move(servos))
        .add("same_firmware", versions.size() == 1 && versions.begin()->has_value());
    if (report->stopped)
        document.add("stopped", true);
    const QString table = rows.empty() ? QString() : tableOf(rows).text();
    run.finish(document, table + remarks(rows) + notFoundText(*report) + scanRemarks(*report));
    return report->stopped ? Exit::Failed : rows.empty() ? Exit::NoReply : Exit::Success;
}
} // namespace

Command firmwareListCommand()
{
    return {"firmware list",
            QT_TRANSLATE_NOOP("cli", "list the servos' firmware versions, and those that differ"),
            {},
            searchOptions(),
            runFirmwareList};
}
} // namespace cli
