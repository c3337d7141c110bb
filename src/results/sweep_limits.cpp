// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_limits.h"

#include "files/json_format.h"
#include "files/json_text.h"
#include "files/text_file.h"
#include "results/sweep_limits_json.h"

#include <QDir>
#include <QFile>
#include <QSet>

#include <algorithm>

// Q_INIT_RESOURCE must be outside every namespace; without it the linker drops the resources of
// a static library.
static void initLimitsResource()
{
    Q_INIT_RESOURCE(limits);
}

namespace results {
namespace {
const QString loadLimitsOperation = QStringLiteral("load-limits");
const QString saving = QStringLiteral("save-limits");
const QLatin1String limitsFormat("servodesk-limits");
constexpr int limitsVersion = 1;
constexpr qint64 maxLimitsFileSize = 1024 * 1024;

const SweepMetricKind* kindOf(const QString& key)
{
    const auto& kinds = sweepMetricKinds();
    const auto it = std::find_if(kinds.begin(), kinds.end(),
                                 [&](const SweepMetricKind& kind) { return kind.key == key; });
    return it == kinds.end() ? nullptr : &*it;
}

/// None where the file has no value, or null.
std::optional<double> boundOf(const files::JsonReader& json, const char* key)
{
    if (!json.contains(key))
        return {};
    const auto bound = json.numberOrNull(key);
    if (bound && *bound < 0)
        json.reportError(key, QStringLiteral("must not be negative"));
    return bound;
}

/// The error also names the metric of the line, because users do not count lines from 0.
void checkBounds(const files::JsonReader& json, const SweepLimit& line)
{
    if (!line.warn && !line.fail)
        json.reportError("fail",
                         QStringLiteral("\"%1\" has neither warn nor fail").arg(line.metric));
    if (!line.warn || !line.fail)
        return;
    const bool crossed = line.atLeast ? *line.warn < *line.fail : *line.warn > *line.fail;
    if (crossed)
        json.reportError("warn",
                         QStringLiteral("\"%1\" would fail before it warns").arg(line.metric));
}

SweepLimit readLine(const files::JsonReader& json)
{
    static const QStringList known{QStringLiteral("metric"),   QStringLiteral("unit"),
                                   QStringLiteral("at_least"), QStringLiteral("warn"),
                                   QStringLiteral("fail"),     QStringLiteral("comment")};
    SweepLimit line;
    line.metric = json.nonEmptyText("metric");
    line.unit = json.text("unit");
    json.rejectUnknownKeys(known);
    const SweepMetricKind* kind = kindOf(line.metric);
    if (!kind) {
        json.reportError("metric", QStringLiteral("there is no metric \"%1\"").arg(line.metric));
        return line;
    }
    if (line.unit != kind->unit)
        json.reportError("unit", QStringLiteral("\"%1\" is in \"%2\", not in \"%3\"")
                                     .arg(line.metric, kind->unit, line.unit));
    line.atLeast = json.contains("at_least") ? json.flag("at_least") : kind->atLeast;
    line.warn = boundOf(json, "warn");
    line.fail = boundOf(json, "fail");
    checkBounds(json, line);
    return line;
}

std::vector<SweepLimit> readLines(const files::JsonReader& json)
{
    std::vector<SweepLimit> lines;
    QSet<QString> seen;
    for (const files::JsonReader& object : json.objects("lines")) {
        lines.push_back(readLine(object));
        const SweepLimit& line = lines.back();
        const QString name = line.metric + (line.atLeast ? u'>' : u'<');
        if (seen.contains(name))
            object.reportError("metric", QStringLiteral("\"%1\" is there twice").arg(line.metric));
        seen.insert(name);
    }
    return lines;
}

QByteArray lineText(const SweepLimit& line)
{
    return "    {\"metric\": " + files::jsonText(line.metric) +
           ", \"unit\": " + files::jsonText(line.unit) +
           ", \"at_least\": " + files::jsonFlag(line.atLeast) +
           ", \"warn\": " + files::jsonNumber(line.warn) +
           ", \"fail\": " + files::jsonNumber(line.fail) + '}';
}

/// In the order of their names; read once.
const std::vector<SweepLimits>& builtIn()
{
    static const std::vector<SweepLimits> all = [] {
        initLimitsResource();
        std::vector<SweepLimits> found;
        const QDir folder(QStringLiteral(":/limits"));
        for (const QString& name : folder.entryList({QStringLiteral("*.json")}, QDir::Files)) {
            const auto limits = loadSweepLimits(folder.filePath(name));
            Q_ASSERT_X(limits, "built-in limits", limits ? "" : qPrintable(limits.error().detail));
            if (limits)
                found.push_back(*limits);
        }
        return found;
    }();
    return all;
}
} // namespace

QByteArray encodeSweepLimits(const SweepLimits& limits)
{
    QByteArray text = "{\n  \"format\": " + files::jsonText(limitsFormat) +
                      ",\n  \"version\": " + QByteArray::number(limitsVersion) +
                      ",\n  \"name\": " + files::jsonText(limits.name) +
                      ",\n  \"models\": " + files::jsonText(limits.models) +
                      ",\n  \"tolerance\": " + files::jsonNumber(limits.tolerance) +
                      ",\n  \"lines\": [";
    const char* separator = "\n";
    for (const SweepLimit& line : limits.lines) {
        text += separator + lineText(line);
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

SweepLimits readSweepLimits(const files::JsonReader& json)
{
    static const QStringList known{QStringLiteral("$schema"), QStringLiteral("format"),
                                   QStringLiteral("version"), QStringLiteral("name"),
                                   QStringLiteral("models"),  QStringLiteral("tolerance"),
                                   QStringLiteral("lines"),   QStringLiteral("comment")};
    files::checkFormat(json, limitsFormat, limitsVersion,
                       QStringLiteral("not a file of ServoDesk limits"));
    json.rejectUnknownKeys(known);
    SweepLimits limits;
    limits.name = json.text("name");
    limits.models = json.contains("models") ? json.texts("models") : QStringList();
    if (json.contains("tolerance"))
        limits.tolerance = json.numberOrNull("tolerance");
    if (limits.tolerance && *limits.tolerance <= 0)
        json.reportError("tolerance", QStringLiteral("must be more than 0"));
    limits.lines = readLines(json);
    return limits;
}

base::Result<SweepLimits> decodeSweepLimits(const QByteArray& text)
{
    const auto document = files::parseJson(text);
    if (!document)
        return base::fail(base::ErrorCode::FileFormat, loadLimitsOperation, document.error());
    files::JsonReadError readError;
    const files::JsonReader json(*document, readError);
    const SweepLimits limits = readSweepLimits(json);
    if (limits.name.isEmpty())
        json.reportError("name", QStringLiteral("must not be empty"));
    if (limits.lines.empty())
        json.reportError("lines", QStringLiteral("without a line every servo would pass"));
    if (readError.isSet())
        return base::fail(base::ErrorCode::FileFormat, loadLimitsOperation, readError.text());
    return limits;
}

base::Result<SweepLimits> loadSweepLimits(const QString& path)
{
    const auto text = files::readTextFile(loadLimitsOperation, path, maxLimitsFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto limits = decodeSweepLimits(*text);
    if (!limits) {
        base::Error error = limits.error();
        error.detail = path + QStringLiteral(": ") + error.detail;
        return tl::unexpected(error);
    }
    return limits;
}

base::Result<void> saveSweepLimits(const SweepLimits& limits, const QString& path)
{
    return files::saveTextFile(saving, encodeSweepLimits(limits), path);
}

SweepLimits builtInSweepLimits(const QString& model, const QString& series)
{
    for (const QString& wanted : {model, series}) {
        for (const SweepLimits& limits : builtIn()) {
            if (limits.models.contains(wanted, Qt::CaseInsensitive))
                return limits;
        }
    }
    for (const SweepLimits& limits : builtIn()) {
        if (limits.models.isEmpty())
            return limits;
    }
    return {};
}

SweepLimits withNameOfItsOwn(SweepLimits limits, const QString& model)
{
    const auto isNamesake = [&](const SweepLimits& one) { return one.name == limits.name; };
    const auto namesake = std::find_if(builtIn().begin(), builtIn().end(), isNamesake);
    if (namesake != builtIn().end() && !(*namesake == limits))
        limits.name = model + customSuffix;
    return limits;
}

const std::vector<SweepMetricKind>& sweepMetricKinds()
{
    const QString ms = QStringLiteral("ms");
    const QString percent = QStringLiteral("%");
    const QString step = QStringLiteral("step");
    const QString stepsPerSecond = QStringLiteral("step/s");
    const QString milliampere = QStringLiteral("mA");
    const QString degree = QStringLiteral("°C");
    const QString legs = QStringLiteral("legs");
    static const std::vector<SweepMetricKind> kinds{
        {QStringLiteral("time_to_target"), ms},
        {QStringLiteral("settling"), ms},
        {QStringLiteral("overshoot"), percent},
        {QStringLiteral("steady_error"), step},
        {QStringLiteral("hysteresis"), step},
        {QStringLiteral("repeatability_sigma"), step},
        {QStringLiteral("repeatability_range"), step},
        {QStringLiteral("following_error"), step},
        {QStringLiteral("following_error_relative"), percent},
        {QStringLiteral("phase_lag"), QStringLiteral("°")},
        {QStringLiteral("readings_per_period"), QString(), true},
        {QStringLiteral("mean_speed"), stepsPerSecond, true},
        {QStringLiteral("top_speed"), stepsPerSecond, true},
        {QStringLiteral("current_peak"), milliampere},
        {QStringLiteral("current_mean"), milliampere},
        {QStringLiteral("load_peak"), percent},
        {QStringLiteral("load_mean"), percent},
        {QStringLiteral("voltage_min"), QStringLiteral("V"), true},
        {QStringLiteral("temperature_rise"), degree},
        {QStringLiteral("temperature_max"), degree},
        {QStringLiteral("moving_flag_errors"), legs},
        {QStringLiteral("missed_targets"), legs},
        {QStringLiteral("communication_errors"), QString()},
        {QStringLiteral("alarms"), QString()},
    };
    return kinds;
}
} // namespace results
