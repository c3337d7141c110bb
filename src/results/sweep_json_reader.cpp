// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/json_format.h"
#include "files/text_file.h"
#include "results/axis_json.h"
#include "results/sweep_fields.h"
#include "results/sweep_json.h"
#include "results/sweep_limits_json.h"
#include "results/sweep_verdict.h"
#include "snapshot/snapshot_json_reader.h"

#include <cmath>
#include <limits>

namespace results {
namespace {
const QString loadSweepOperation = QStringLiteral("load-sweep");
constexpr qint64 maxSweepFileSize = 512 * 1024 * 1024;
constexpr int sweepVersion = 1;

std::optional<base::Duration> spanOrNull(const files::JsonReader& json, const char* key)
{
    const auto ms = json.numberOrNull(key);
    if (!ms)
        return {};
    return readMilliseconds(json, key, *ms);
}

base::Duration span(const files::JsonReader& json, const char* key)
{
    const auto found = spanOrNull(json, key);
    if (!found)
        json.reportError(key, QStringLiteral("expected a number"));
    return found.value_or(base::Duration());
}

std::uint64_t count(const files::JsonReader& json, const char* key)
{
    const std::int64_t found = json.integer(key);
    if (found < 0)
        json.reportError(key, QStringLiteral("must not be negative"));
    return std::uint64_t(std::max<std::int64_t>(found, 0));
}

SweepRange readRange(const files::JsonReader& json)
{
    return {json.text("from"), json.text("to")};
}

SweepSpec readTest(const files::JsonReader& json)
{
    SweepSpec spec;
    spec.shape = json.enumValue("shape", sweepShapeFromName);
    spec.range = readRange(json);
    for (const files::JsonReader& range : json.objects("ranges"))
        spec.ranges[range.smallInteger("servo")] = readRange(range);
    spec.step = json.text("step");
    for (const files::JsonReader& point : json.objects("points"))
        spec.points.push_back({point.text("target"), spanOrNull(point, "pause_ms")});
    const std::uint64_t seed = count(json, "seed");
    if (seed > std::numeric_limits<std::uint32_t>::max())
        json.reportError("seed", QStringLiteral("number too large"));
    spec.seed = std::uint32_t(seed);
    spec.period = span(json, "period_ms");
    spec.pace = json.enumValue("pace", sweepPaceFromName);
    spec.pause = span(json, "pause_ms");
    spec.cycles = json.smallInteger("cycles");
    spec.length = span(json, "length_ms");
    spec.speed = json.text("speed");
    spec.acceleration = json.text("acceleration");
    spec.time = json.text("time");
    spec.warmUp = span(json, "warm_up_ms");
    spec.releaseAtEnd = json.flag("release_at_end");
    spec.stopOnAlarm = json.flag("stop_on_alarm");
    spec.stopOnStall = json.flag("stop_on_stall");
    spec.stopOnFailure = json.flag("stop_on_failure");
    spec.operatorName = json.text("operator");
    spec.note = json.text("note");
    return spec;
}

VerdictLine readVerdict(const files::JsonReader& json)
{
    VerdictLine line;
    line.limit.metric = json.nonEmptyText("metric");
    line.limit.unit = json.text("unit");
    line.limit.atLeast = json.flag("at_least");
    line.limit.warn = json.numberOrNull("warn");
    line.limit.fail = json.numberOrNull("fail");
    line.value = json.numberOrNull("value");
    line.grade = json.enumValue("grade", gradeFromName);
    return line;
}

SweepErrors readErrors(const files::JsonReader& json)
{
    return {count(json, "asked"), count(json, "time_outs"), count(json, "bad_checks"),
            count(json, "foreign"), count(json, "late")};
}

SweepServo readSweepServo(const files::JsonReader& json)
{
    SweepServo servo;
    servo.parameters = snapshot::readSnapshot(json.object("parameters"));
    servo.axis = readAxis(json.object("axis"), AxisFields::Path);
    servo.limits = readSweepLimits(json.object("limits"));
    for (const files::JsonReader& line : json.objects("lines"))
        servo.lines.push_back(readVerdict(line));
    servo.errors = readErrors(json.object("errors"));
    (void)json.enumValue("verdict", gradeFromName); // it follows from the lines and the end
    if (json.smallInteger("id") != servo.parameters.servo.id)
        json.reportError("id", QStringLiteral("is not the one of its parameters"));
    return servo;
}

std::vector<SweepServo> readServos(const files::JsonReader& json)
{
    std::vector<SweepServo> servos;
    for (const files::JsonReader& object : json.objects("servos")) {
        SweepServo servo = readSweepServo(object);
        for (const SweepServo& before : servos) {
            if (before.parameters.servo.id == servo.parameters.servo.id)
                object.reportError("id", QStringLiteral("is there twice"));
        }
        servos.push_back(std::move(servo));
    }
    return servos;
}

SweepMetric readMetric(const files::JsonReader& json)
{
    SweepMetric metric;
    metric.key = json.nonEmptyText("metric");
    metric.unit = json.text("unit");
    metric.value = json.numberOrNull("value");
    metric.mean = json.numberOrNull("mean");
    metric.min = json.numberOrNull("min");
    metric.max = json.numberOrNull("max");
    metric.count = count(json, "count");
    return metric;
}

SweepLeg readLeg(const files::JsonReader& json)
{
    SweepLeg leg;
    leg.number = json.smallInteger("leg");
    leg.cycle = json.smallInteger("cycle");
    leg.at = span(json, "at_ms");
    leg.span = span(json, "span_ms");
    leg.start = json.number("start");
    leg.target = json.number("target");
    leg.timeToTarget = spanOrNull(json, "time_ms");
    leg.settling = spanOrNull(json, "settling_ms");
    for (const LegFigure& figure : legFigures) {
        if (!figure.isLater || json.contains(figure.key))
            leg.*figure.member = json.numberOrNull(figure.key);
    }
    leg.samples = json.smallInteger("samples");
    leg.lost = json.smallInteger("lost");
    leg.missed = json.flag("missed");
    if (!json.content().value(QLatin1StringView("flag_wrong")).isNull())
        leg.flagWrong = json.flag("flag_wrong");
    const int alarms = json.smallInteger("alarms");
    if (alarms < 0 || alarms > std::numeric_limits<std::uint8_t>::max())
        json.reportError("alarms", QStringLiteral("expected 0 to 255"));
    leg.alarms = std::uint8_t(alarms);
    return leg;
}

template <typename Item>
void readRows(const files::JsonReader& json, const char* key, std::vector<SweepServo>& servos,
              std::vector<Item> SweepServo::*items, Item (*read)(const files::JsonReader&))
{
    for (const files::JsonReader& row : json.objects(key)) {
        const int id = row.smallInteger("servo");
        const auto servo = std::find_if(servos.begin(), servos.end(), [id](const SweepServo& one) {
            return one.parameters.servo.id == id;
        });
        if (servo == servos.end())
            row.reportError("servo", QStringLiteral("there is no servo %1 in this test").arg(id));
        else
            ((*servo).*items).push_back(read(row));
    }
}

SweepRun readSweepRun(const files::JsonReader& json)
{
    files::checkFormat(json, QLatin1StringView("servodesk-sweep"), sweepVersion,
                       QStringLiteral("not a sweep test of ServoDesk"));
    SweepRun run;
    run.program = json.text("program");
    run.at = json.time("time");
    run.port = json.text("port");
    run.baud = json.smallInteger("baud");
    run.simulated = json.flag("simulated");
    run.length = span(json, "length_ms");
    run.end = json.enumValue("end", sweepEndFromName);
    run.endedBy = json.integerOrNull("ended_by") ? json.smallInteger("ended_by") : -1;
    run.sampleRate = json.number("sample_rate");
    for (const files::JsonReader& gap : json.objects("gaps"))
        run.gaps.push_back({span(gap, "at_ms"), span(gap, "span_ms")});
    run.spec = readTest(json.object("test"));
    run.servos = readServos(json);
    readRows(json, "metrics", run.servos, &SweepServo::metrics, readMetric);
    readRows(json, "legs", run.servos, &SweepServo::legs, readLeg);
    assignVerdicts(run);
    return run;
}
} // namespace

base::Result<SweepRun> decodeSweepRun(const QByteArray& text)
{
    const auto document = files::parseJson(text);
    if (!document)
        return base::fail(base::ErrorCode::FileFormat, loadSweepOperation, document.error());
    files::JsonReadError readError;
    SweepRun run = readSweepRun(files::JsonReader(*document, readError));
    if (readError.isSet())
        return base::fail(base::ErrorCode::FileFormat, loadSweepOperation, readError.text());
    return run;
}

base::Result<SweepRun> loadSweepRun(const QString& path)
{
    const auto text = files::readTextFile(loadSweepOperation, path, maxSweepFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto run = decodeSweepRun(*text);
    if (!run) {
        base::Error error = run.error();
        error.detail = path + QStringLiteral(": ") + error.detail;
        return tl::unexpected(error);
    }
    return run;
}
} // namespace results
