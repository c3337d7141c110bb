// SPDX-License-Identifier: GPL-3.0-or-later
// Writing; step_json_reader.cpp reads.
#include "results/step_json.h"

#include "base/enum_names.h"
#include "files/csv_text.h"
#include "files/json_text.h"
#include "files/text_file.h"
#include "results/axis_json.h"
#include "results/sweep_fields.h"

#include <QLocale>

#include <cmath>

namespace results {
namespace {
QByteArray gainText(const StepGain& gain)
{
    return files::JsonObjectWriter().text("key", gain.key).integer("raw", gain.raw).done();
}

QByteArray gainsText(const std::vector<StepGain>& gains)
{
    return files::jsonLines(gains, "      ", gainText);
}

QByteArray figuresText(const StepFigures& figures)
{
    files::JsonObjectWriter line;
    for (const StepFigure& figure : stepFigures)
        line.number(figure.key, figures.*figure.member);
    return line.done();
}

QByteArray specText(const StepSpec& spec)
{
    return files::JsonObjectWriter()
        .text("size", spec.size)
        .text("from", spec.from)
        .integer("repeats", spec.repeats)
        .number("hold_ms", inMs(spec.hold))
        .text("speed", spec.speed)
        .text("acceleration", spec.acceleration)
        .raw("trial", gainsText(spec.trial))
        .text("operator", spec.operatorName)
        .text("note", spec.note)
        .done();
}

QByteArray sampleText(const StepSample& sample)
{
    return '[' + files::jsonNumber(inMs(sample.at)) + ", " + files::jsonNumber(sample.position) +
           ", " + files::jsonNumber(sample.speed) + ", " + files::jsonNumber(sample.load) + ", " +
           files::jsonNumber(sample.current) + ']';
}

QByteArray responseText(const StepResponse& response)
{
    QByteArray samples;
    for (const StepSample& sample : response.samples)
        samples += (samples.isEmpty() ? "" : ", ") + sampleText(sample);
    return files::JsonObjectWriter()
        .integer("number", response.number)
        .number("start", response.start)
        .number("target", response.target)
        .flag("missed", response.missed)
        .integer("lost", response.lost)
        .flag("seen", response.seen)
        .integer("alarms", response.alarms)
        .raw("figures", figuresText(response.figures))
        .raw("samples", '[' + samples + ']')
        .done();
}

QByteArray runText(const StepRun& run)
{
    return "{\n      \"servo\": " + QByteArray::number(run.parameters.servo.id) +
           ",\n      \"program\": " + files::jsonText(run.program) +
           ",\n      \"time\": " + files::jsonText(run.at.toUTC().toString(Qt::ISODateWithMs)) +
           ",\n      \"port\": " + files::jsonText(run.port) +
           ",\n      \"baud\": " + QByteArray::number(run.baud) +
           ",\n      \"simulated\": " + files::jsonFlag(run.simulated) +
           ",\n      \"end\": " + files::jsonText(sweepEndName(run.end)) +
           ",\n      \"sample_rate\": " + files::jsonNumber(run.sampleRate) +
           ",\n      \"put_back\": " + files::jsonFlag(run.isReverted) +
           ",\n      \"test\": " + specText(run.spec) +
           ",\n      \"gains\": " + gainsText(run.gains) +
           ",\n      \"axis\": " + encodeAxis(run.axis, AxisFields::Range) +
           ",\n      \"mean\": " + figuresText(run.mean) +
           ",\n      \"responses\": " + files::jsonLines(run.responses, "      ", responseText) +
           ",\n      \"parameters\": " +
           snapshot::encodeSnapshot(run.parameters).trimmed().replace("\n", "\n      ") + "\n    }";
}

constexpr base::EnumName<StepChange> changeNames[]{
    {StepChange::Same, "same"},
    {StepChange::Better, "better"},
    {StepChange::Worse, "worse"},
    {StepChange::Neither, "neither"},
    {StepChange::NotMeasured, "not-measured"},
};

QByteArray differenceText(const StepDifference& row)
{
    return files::JsonObjectWriter()
        .text("figure", QString::fromLatin1(row.figure.key))
        .text("unit", QString::fromUtf8(row.figure.unit))
        .number("before", row.before)
        .number("after", row.after)
        .number("difference", row.difference)
        .text("change", base::nameOf(changeNames, row.change))
        .done();
}

QByteArray adviceText(const StepAdvice& advice)
{
    files::JsonObjectWriter line;
    line.text("symptom", stepSymptomName(advice.symptom))
        .text("remedy", stepRemedyName(advice.remedy));
    if (!advice.key.isEmpty())
        line.text("key", advice.key).integer("now", advice.now).integer("try", advice.proposed);
    return line.done();
}

QByteArray sampleLines(int run, const StepResponse& response)
{
    QByteArray lines;
    for (const StepSample& sample : response.samples) {
        lines += QByteArray::number(run) + ',' + QByteArray::number(response.number) + ',' +
                 files::csvNumber(inMs(sample.at)) + ',' + files::csvNumber(response.start) + ',' +
                 files::csvNumber(response.target) + ',' + files::csvNumber(sample.position) + ',' +
                 files::csvNumber(sample.speed) + ',' + files::csvNumber(sample.load) + ',' +
                 files::csvNumber(sample.current) + '\n';
    }
    return lines;
}
} // namespace

QByteArray encodeStepRuns(const std::vector<StepRun>& runs, const std::vector<StepAdvice>& advice)
{
    std::vector<StepDifference> differences;
    if (runs.size() > 1)
        differences = compareSteps(runs.front(), runs.back());
    return "{\n  \"format\": \"servodesk-step-response\",\n  \"version\": 1,\n  \"runs\": " +
           files::jsonLines(runs, "  ", runText) +
           ",\n  \"differences\": " + files::jsonLines(differences, "  ", differenceText) +
           ",\n  \"advice\": " + files::jsonLines(advice, "  ", adviceText) + "\n}\n";
}

base::Result<void> saveStepRuns(const std::vector<StepRun>& runs,
                                const std::vector<StepAdvice>& advice, const QString& path)
{
    return files::saveTextFile(QStringLiteral("save-step-response"), encodeStepRuns(runs, advice),
                               path);
}

base::Result<void> saveStepSamples(const std::vector<StepRun>& runs, const QString& path)
{
    return files::saveTextFile(
        QStringLiteral("save-step-response"),
        [&](const files::TextSink& sink) {
            if (!sink("run,response,t[ms],start[step],target[step],position[step],speed[step/s],"
                      "load[%],current[mA]\n"))
                return;
            int number = 0;
            for (const StepRun& run : runs) {
                ++number;
                for (const StepResponse& response : run.responses) {
                    if (!sink(sampleLines(number, response)))
                        return;
                }
            }
        },
        path);
}
} // namespace results
