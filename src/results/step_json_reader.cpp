// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/json_format.h"
#include "files/text_file.h"
#include "results/axis_json.h"
#include "results/step_json.h"
#include "results/sweep_fields.h"
#include "snapshot/snapshot_json_reader.h"

#include <QJsonArray>

#include <cmath>

namespace results {
namespace {
const QString loadStepOperation = QStringLiteral("load-step-response");
constexpr qint64 maxStepFileSize = 256 * 1024 * 1024;
constexpr int stepVersion = 1;
constexpr int cellsPerSample = 5; ///< of a sample

std::vector<StepGain> readGains(const files::JsonReader& json, const char* key)
{
    std::vector<StepGain> gains;
    for (const files::JsonReader& gain : json.objects(key))
        gains.push_back({gain.nonEmptyText("key"), gain.integer("raw")});
    return gains;
}

StepFigures readFigures(const files::JsonReader& json)
{
    StepFigures figures;
    for (const StepFigure& figure : stepFigures)
        figures.*figure.member = json.numberOrNull(figure.key);
    return figures;
}

StepSpec readSpec(const files::JsonReader& json)
{
    StepSpec spec;
    spec.size = json.text("size");
    spec.from = json.text("from");
    spec.repeats = json.smallInteger("repeats");
    spec.hold = readMilliseconds(json, "hold_ms", json.number("hold_ms"));
    spec.speed = json.text("speed");
    spec.acceleration = json.text("acceleration");
    spec.trial = readGains(json, "trial");
    spec.operatorName = json.text("operator");
    spec.note = json.text("note");
    return spec;
}

std::vector<StepSample> readSamples(const files::JsonReader& json)
{
    std::vector<StepSample> samples;
    const QJsonArray rows = json.content().value(QLatin1String("samples")).toArray();
    for (const QJsonValue& row : rows) {
        const QJsonArray values = row.toArray();
        if (values.size() != cellsPerSample || !values[0].isDouble() || !values[1].isDouble()) {
            json.reportError("samples",
                             QStringLiteral("expected rows of %1 numbers").arg(cellsPerSample));
            return {};
        }
        const auto optional = [&values](int cell) {
            return values[cell].isDouble() ? std::optional(values[cell].toDouble()) : std::nullopt;
        };
        samples.push_back({readMilliseconds(json, "samples", values[0].toDouble()),
                           values[1].toDouble(), optional(2), optional(3), optional(4)});
    }
    return samples;
}

StepResponse readResponse(const files::JsonReader& json)
{
    StepResponse response;
    response.number = json.smallInteger("number");
    response.start = json.number("start");
    response.target = json.number("target");
    response.missed = json.flag("missed");
    response.lost = json.smallInteger("lost");
    response.seen = !json.contains("seen") || json.flag("seen"); // missing in older files
    response.alarms = std::uint8_t(json.smallInteger("alarms"));
    response.figures = readFigures(json.object("figures"));
    response.samples = readSamples(json);
    return response;
}

StepRun readStepRun(const files::JsonReader& json)
{
    StepRun run;
    run.program = json.text("program");
    run.at = json.time("time");
    run.port = json.text("port");
    run.baud = json.smallInteger("baud");
    run.simulated = json.flag("simulated");
    run.end = json.enumValue("end", sweepEndFromName);
    run.sampleRate = json.number("sample_rate");
    run.isReverted = json.flag("put_back");
    run.spec = readSpec(json.object("test"));
    run.gains = readGains(json, "gains");
    run.axis = readAxis(json.object("axis"), AxisFields::Range);
    run.mean = readFigures(json.object("mean"));
    for (const files::JsonReader& response : json.objects("responses"))
        run.responses.push_back(readResponse(response));
    run.parameters = snapshot::readSnapshot(json.object("parameters"));
    return run;
}
} // namespace

base::Result<std::vector<StepRun>> decodeStepRuns(const QByteArray& text)
{
    const auto document = files::parseJson(text);
    if (!document)
        return base::fail(base::ErrorCode::FileFormat, loadStepOperation, document.error());
    files::JsonReadError readError;
    const files::JsonReader json(*document, readError);
    files::checkFormat(json, QLatin1StringView("servodesk-step-response"), stepVersion,
                       QStringLiteral("not a step response of ServoDesk"));
    std::vector<StepRun> runs;
    for (const files::JsonReader& run : json.objects("runs"))
        runs.push_back(readStepRun(run));
    if (readError.isSet())
        return base::fail(base::ErrorCode::FileFormat, loadStepOperation, readError.text());
    return runs;
}

base::Result<std::vector<StepRun>> loadStepRuns(const QString& path)
{
    const auto text = files::readTextFile(loadStepOperation, path, maxStepFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto runs = decodeStepRuns(*text);
    if (!runs) {
        base::Error error = runs.error();
        error.detail = path + QStringLiteral(": ") + error.detail;
        return tl::unexpected(error);
    }
    return runs;
}
} // namespace results
