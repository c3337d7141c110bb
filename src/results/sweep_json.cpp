// SPDX-License-Identifier: GPL-3.0-or-later
// Writing; sweep_json_reader.cpp reads.
#include "results/sweep_json.h"

#include "files/json_text.h"
#include "files/text_file.h"
#include "results/axis_json.h"
#include "results/sweep_fields.h"
#include "results/sweep_verdict.h"

namespace results {
namespace {
constexpr qsizetype pieceSize = 65536;

/// A nested document that could be a file of its own, indented.
QByteArray indented(const QByteArray& document)
{
    return document.trimmed().replace("\n", "\n      ");
}

files::JsonObjectWriter& addRange(files::JsonObjectWriter& line, const SweepRange& range)
{
    return line.text("from", range.from).text("to", range.to);
}

QByteArray rangeText(const std::pair<const int, SweepRange>& item)
{
    files::JsonObjectWriter line;
    line.integer("servo", item.first);
    return addRange(line, item.second).done();
}

QByteArray pointText(const SweepPoint& point)
{
    return files::JsonObjectWriter()
        .text("target", point.target)
        .number("pause_ms", inMs(point.pause))
        .done();
}

QByteArray testText(const SweepSpec& spec)
{
    files::JsonObjectWriter line;
    line.text("shape", sweepShapeName(spec.shape));
    addRange(line, spec.range)
        .raw("ranges", files::jsonList(spec.ranges, rangeText))
        .text("step", spec.step)
        .raw("points", files::jsonList(spec.points, pointText))
        .integer("seed", spec.seed)
        .number("period_ms", inMs(spec.period))
        .text("pace", sweepPaceName(spec.pace))
        .number("pause_ms", inMs(spec.pause))
        .integer("cycles", spec.cycles)
        .number("length_ms", inMs(spec.length))
        .text("speed", spec.speed)
        .text("acceleration", spec.acceleration)
        .text("time", spec.time)
        .number("warm_up_ms", inMs(spec.warmUp))
        .flag("release_at_end", spec.releaseAtEnd)
        .flag("stop_on_alarm", spec.stopOnAlarm)
        .flag("stop_on_stall", spec.stopOnStall)
        .flag("stop_on_failure", spec.stopOnFailure)
        .text("operator", spec.operatorName)
        .text("note", spec.note);
    return line.done();
}

QByteArray errorsText(const SweepErrors& errors)
{
    return files::JsonObjectWriter()
        .integer("asked", errors.asked)
        .integer("time_outs", errors.timeouts)
        .integer("bad_checks", errors.badChecksums)
        .integer("foreign", errors.foreign)
        .integer("late", errors.late)
        .done();
}

QByteArray verdictText(const VerdictLine& line)
{
    return files::JsonObjectWriter()
        .text("metric", line.limit.metric)
        .text("unit", line.limit.unit)
        .flag("at_least", line.limit.atLeast)
        .number("warn", line.limit.warn)
        .number("fail", line.limit.fail)
        .number("value", line.value)
        .text("grade", gradeName(line.grade))
        .done();
}

QByteArray servoText(const SweepRun& run, const SweepServo& servo)
{
    const QString open = noVerdictReasonName(sweepVerdict(run, servo).reason);
    QByteArray lines;
    for (const VerdictLine& line : servo.lines)
        lines += (lines.isEmpty() ? "\n        " : ",\n        ") + verdictText(line);
    return "{\n      \"id\": " + QByteArray::number(servo.parameters.servo.id) +
           ",\n      \"verdict\": " + files::jsonText(gradeName(servo.verdict)) +
           ",\n      \"no_verdict\": " + (open.isEmpty() ? "null" : files::jsonText(open)) +
           ",\n      \"axis\": " + encodeAxis(servo.axis, AxisFields::Path) +
           ",\n      \"lines\": [" + lines + (lines.isEmpty() ? "]" : "\n      ]") +
           ",\n      \"errors\": " + errorsText(servo.errors) +
           ",\n      \"limits\": " + indented(encodeSweepLimits(servo.limits)) +
           ",\n      \"parameters\": " + indented(snapshot::encodeSnapshot(servo.parameters)) +
           "\n    }";
}

QByteArray metricText(int servo, const SweepMetric& metric)
{
    return files::JsonObjectWriter()
        .integer("servo", servo)
        .text("metric", metric.key)
        .text("unit", metric.unit)
        .number("value", metric.value)
        .number("mean", metric.mean)
        .number("min", metric.min)
        .number("max", metric.max)
        .integer("count", metric.count)
        .done();
}

QByteArray legText(int servo, const SweepLeg& leg)
{
    files::JsonObjectWriter line;
    line.integer("servo", servo)
        .integer("leg", leg.number)
        .integer("cycle", leg.cycle)
        .number("at_ms", inMs(leg.at))
        .number("span_ms", inMs(leg.span))
        .number("start", leg.start)
        .number("target", leg.target)
        .number("time_ms", inMs(leg.timeToTarget))
        .number("settling_ms", inMs(leg.settling));
    for (const LegFigure& figure : legFigures)
        line.number(figure.key, leg.*figure.member);
    return line.integer("samples", leg.samples)
        .integer("lost", leg.lost)
        .flag("missed", leg.missed)
        .raw("flag_wrong", leg.flagWrong ? files::jsonFlag(*leg.flagWrong) : "null")
        .integer("alarms", int(leg.alarms))
        .done();
}

QByteArray gapText(const SweepGap& gap)
{
    return files::JsonObjectWriter()
        .number("at_ms", inMs(gap.at))
        .number("span_ms", inMs(gap.span))
        .done();
}

QByteArray headText(const SweepRun& run)
{
    const QByteArray endedBy = run.endedBy < 0 ? "null" : QByteArray::number(run.endedBy);
    return "{\n  \"format\": \"servodesk-sweep\",\n  \"version\": 1,\n  \"verdict\": " +
           files::jsonText(gradeName(run.verdict())) +
           ",\n  \"program\": " + files::jsonText(run.program) +
           ",\n  \"time\": " + files::jsonText(run.at.toUTC().toString(Qt::ISODateWithMs)) +
           ",\n  \"port\": " + files::jsonText(run.port) +
           ",\n  \"baud\": " + QByteArray::number(run.baud) +
           ",\n  \"simulated\": " + files::jsonFlag(run.simulated) +
           ",\n  \"length_ms\": " + files::jsonNumber(inMs(run.length)) +
           ",\n  \"end\": " + files::jsonText(sweepEndName(run.end)) +
           ",\n  \"ended_by\": " + endedBy +
           ",\n  \"sample_rate\": " + files::jsonNumber(run.sampleRate) +
           ",\n  \"gaps\": " + files::jsonList(run.gaps, gapText) +
           ",\n  \"test\": " + testText(run.spec);
}

/// Items of all servos in one list, one per line, written in pieces.
template <typename Items, typename Write>
void writeList(const SweepRun& run, const char* key, Items SweepServo::*items, const Write& write,
               const files::TextSink& sink)
{
    QByteArray text = ",\n  \"" + QByteArray(key) + "\": [";
    const char* separator = "\n    ";
    for (const SweepServo& servo : run.servos) {
        for (const auto& item : servo.*items) {
            text += separator + write(servo.parameters.servo.id, item);
            separator = ",\n    ";
            if (text.size() > pieceSize && !sink(std::exchange(text, {})))
                return;
        }
    }
    sink(text + "\n  ]");
}
} // namespace

void writeSweepRun(const SweepRun& run, const files::TextSink& sink)
{
    sink(headText(run) + ",\n  \"servos\": [");
    const char* separator = "\n    ";
    for (const SweepServo& servo : run.servos) {
        sink(separator + servoText(run, servo));
        separator = ",\n    ";
    }
    sink("\n  ]");
    writeList(run, "metrics", &SweepServo::metrics, metricText, sink);
    writeList(run, "legs", &SweepServo::legs, legText, sink);
    sink("\n}\n");
}

QByteArray encodeSweepRun(const SweepRun& run)
{
    QByteArray text;
    writeSweepRun(run, [&](const QByteArray& piece) {
        text += piece;
        return true;
    });
    return text;
}

base::Result<void> saveSweepRun(const SweepRun& run, const QString& path)
{
    return files::saveTextFile(
        QStringLiteral("save-sweep"),
        [&](const files::TextSink& sink) { writeSweepRun(run, sink); }, path);
}
} // namespace results
