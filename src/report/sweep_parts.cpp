// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_parts.h"

#include "report/bilingual.h"
#include "report/sweep_text.h"

namespace report {
namespace {
using Rows = std::vector<QStringList>;

Text seconds(base::Duration span)
{
    return inBoth(inSeconds(span) + QStringLiteral(" s"));
}

/// No row for an empty text.
void addUserRow(const HtmlWriter& htmlWriter, Rows& rows, const Text& name, const QString& text)
{
    if (!text.isEmpty())
        rows.push_back({htmlWriter.htmlText(name), userText(text)});
}

QString rangeOf(const results::SweepRange& range)
{
    return escaped(range.from) + QStringLiteral(" … ") + escaped(range.to);
}

QString pointsOf(const results::SweepSpec& spec)
{
    QStringList points;
    for (const results::SweepPoint& point : spec.points)
        points.append(
            escaped(point.target) +
            (point.pause ? QStringLiteral(" (%1 s)").arg(inSeconds(*point.pause)) : QString()));
    return points.join(QStringLiteral("; "));
}

/// Rows that only some shapes have.
void addShapeRows(const HtmlWriter& htmlWriter, const results::SweepSpec& spec, Rows& rows)
{
    using results::SweepShape;
    const SweepTexts& words = sweepTexts();
    if (spec.shape == SweepShape::Points) {
        rows.push_back({htmlWriter.htmlText(words.points), pointsOf(spec)});
    } else {
        const QString ends =
            htmlWriter.htmlText(words.from) + QStringLiteral(" … ") + htmlWriter.htmlText(words.to);
        rows.push_back({ends, rangeOf(spec.range)});
        for (const auto& [id, range] : spec.ranges)
            rows.push_back({ends + QStringLiteral(", ID ") + QString::number(id), rangeOf(range)});
    }
    if (spec.shape == SweepShape::Stairs)
        rows.push_back({htmlWriter.htmlText(words.step), escaped(spec.step)});
    if (spec.shape == SweepShape::Sine)
        rows.push_back(
            {htmlWriter.htmlText(words.period), htmlWriter.htmlText(seconds(spec.period))});
    if (spec.shape == SweepShape::Random)
        rows.push_back({htmlWriter.htmlText(words.seed), QString::number(spec.seed)});
}

void addMotionRows(const HtmlWriter& htmlWriter, const results::SweepSpec& spec, Rows& rows)
{
    const SweepTexts& words = sweepTexts();
    const auto asked = [&](const QString& text) {
        return text.isEmpty() ? htmlWriter.htmlText(words.asTheServoHasIt) : escaped(text);
    };
    rows.push_back({htmlWriter.htmlText(words.speed), asked(spec.speed)});
    rows.push_back({htmlWriter.htmlText(words.acceleration), asked(spec.acceleration)});
    if (!spec.time.isEmpty())
        rows.push_back({htmlWriter.htmlText(words.moveTime), escaped(spec.time)});
}

QString stopsOf(const HtmlWriter& htmlWriter, const results::SweepSpec& spec)
{
    const SweepTexts& words = sweepTexts();
    QStringList stops;
    if (spec.stopOnAlarm)
        stops.append(htmlWriter.htmlText(words.stopOnAlarm));
    if (spec.stopOnStall)
        stops.append(htmlWriter.htmlText(words.stopOnStall));
    if (spec.stopOnFailure)
        stops.append(htmlWriter.htmlText(words.stopOnFailure));
    return stops.isEmpty() ? htmlWriter.htmlText(words.onlyOnLostLink)
                           : stops.join(htmlWriter.htmlText(listComma()));
}

QString valueOf(const results::SweepServo& servo, const char* metric)
{
    for (const results::SweepMetric& one : servo.metrics) {
        if (one.key == QLatin1String(metric) && one.value)
            return figure(*one.value);
    }
    return QStringLiteral("–");
}

/// All servos with their verdicts, the reasons, and the figures that are asked for first.
QString servosTable(const HtmlWriter& htmlWriter, const results::SweepRun& run)
{
    const SweepTexts& words = sweepTexts();
    Rows rows;
    for (const results::SweepServo& servo : run.servos) {
        const snapshot::SnapshotServo& identity = servo.parameters.servo;
        QString name = escaped(identity.model);
        if (!servo.parameters.label.isEmpty())
            name += QStringLiteral("<br/>") + userText(servo.parameters.label);
        rows.push_back({QString::number(identity.id), name, badge(htmlWriter, servo.verdict),
                        reasonsOf(htmlWriter, run, servo), valueOf(servo, "time_to_target"),
                        valueOf(servo, "overshoot"), valueOf(servo, "steady_error"),
                        valueOf(servo, "current_peak")});
    }
    return table({htmlWriter.htmlText(words.id), htmlWriter.htmlText(words.servo),
                  htmlWriter.htmlText(words.verdict), htmlWriter.htmlText(words.reason),
                  htmlWriter.htmlText(words.timeToTarget), htmlWriter.htmlText(words.overshoot),
                  htmlWriter.htmlText(words.steadyError), htmlWriter.htmlText(words.current)},
                 rows);
}
} // namespace

QString verdictPart(const HtmlWriter& htmlWriter, const results::SweepRun& run)
{
    const SweepTexts& words = sweepTexts();
    QString text = htmlWriter.heading(1, words.title);
    if (run.simulated)
        text += QStringLiteral("<p class=\"simulated\">") + htmlWriter.htmlText(words.simulated) +
                QStringLiteral("</p>\n");
    text += QStringLiteral("<p class=\"overall ") + gradeClass(run.verdict()) +
            QStringLiteral("\">") + badge(htmlWriter, run.verdict()) + QStringLiteral("</p>\n<p>") +
            htmlWriter.htmlText(endText(run.end));
    if (run.endedBy >= 0)
        text += u' ' + htmlWriter.htmlText(words.endedBy) + QStringLiteral(": ID ") +
                QString::number(run.endedBy);
    return text + QStringLiteral("</p>\n") + servosTable(htmlWriter, run);
}

QString benchPart(const HtmlWriter& htmlWriter, const results::SweepRun& run)
{
    const SweepTexts& words = sweepTexts();
    Rows rows;
    rows.push_back({htmlWriter.htmlText(words.date), localTime(run.at)});
    addUserRow(htmlWriter, rows, words.operatorName, run.spec.operatorName);
    addUserRow(htmlWriter, rows, words.note, run.spec.note);
    rows.push_back({htmlWriter.htmlText(words.port), escaped(run.port) + QStringLiteral(", ") +
                                                         QString::number(run.baud) +
                                                         QStringLiteral(" baud")});
    rows.push_back({htmlWriter.htmlText(words.length),
                    figure(double(run.length.count()) / 1e6) + QStringLiteral(" s")});
    rows.push_back(
        {htmlWriter.htmlText(words.sampling), figure(run.sampleRate) + QStringLiteral(" /s")});
    rows.push_back({htmlWriter.htmlText(words.program), escaped(run.program)});
    return htmlWriter.heading(2, words.bench) + keyValueTable(rows);
}

QString testPart(const HtmlWriter& htmlWriter, const results::SweepRun& run)
{
    const SweepTexts& words = sweepTexts();
    const results::SweepSpec& spec = run.spec;
    Rows rows;
    rows.push_back({htmlWriter.htmlText(words.shape), htmlWriter.htmlText(shapeText(spec.shape))});
    addShapeRows(htmlWriter, spec, rows);
    rows.push_back({htmlWriter.htmlText(words.pace), inSeconds(spec.pause) + QStringLiteral(" s ") +
                                                         htmlWriter.htmlText(paceText(spec.pace))});
    rows.push_back({htmlWriter.htmlText(words.cycles), spec.cycles > 0
                                                           ? QString::number(spec.cycles)
                                                           : htmlWriter.htmlText(words.asLongAs)});
    if (spec.length.count() > 0)
        rows.push_back(
            {htmlWriter.htmlText(words.duration), htmlWriter.htmlText(seconds(spec.length))});
    addMotionRows(htmlWriter, spec, rows);
    if (spec.warmUp.count() > 0)
        rows.push_back(
            {htmlWriter.htmlText(words.warmUp), htmlWriter.htmlText(seconds(spec.warmUp))});
    rows.push_back({htmlWriter.htmlText(words.afterwards),
                    htmlWriter.htmlText(spec.releaseAtEnd ? words.releases : words.holds)});
    rows.push_back({htmlWriter.htmlText(words.stopsOn), stopsOf(htmlWriter, spec)});
    return htmlWriter.heading(2, words.test) + keyValueTable(rows);
}

QString busPart(const HtmlWriter& htmlWriter, const results::SweepRun& run)
{
    const SweepTexts& words = sweepTexts();
    const auto count = [](std::uint64_t number) { return QString::number(number); };
    Rows rows;
    for (const results::SweepServo& servo : run.servos) {
        const results::SweepErrors& errors = servo.errors;
        rows.push_back({QString::number(servo.parameters.servo.id), count(errors.asked),
                        count(errors.timeouts), count(errors.badChecksums), count(errors.foreign),
                        count(errors.late)});
    }
    QString text =
        htmlWriter.heading(2, words.bus) +
        table({htmlWriter.htmlText(words.id), htmlWriter.htmlText(words.asked),
               htmlWriter.htmlText(words.timeouts), htmlWriter.htmlText(words.badChecksums),
               htmlWriter.htmlText(words.foreign), htmlWriter.htmlText(words.late)},
              rows) +
        htmlWriter.heading(3, words.gaps);
    if (run.gaps.empty())
        return text + htmlWriter.paragraph(words.noGaps);
    Rows gaps;
    for (const results::SweepGap& gap : run.gaps)
        gaps.push_back({QString::number(double(gap.at.count()) / 1e6, 'f', 2),
                        figure(double(gap.span.count()) / 1e6)});
    return text +
           table({htmlWriter.htmlText(words.gapAt), htmlWriter.htmlText(words.gapSpan)}, gaps);
}
QString sweepBody(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const std::vector<SweepSeries>& series, const EmbedChart& place)
{
    QString text = verdictPart(htmlWriter, run) + benchPart(htmlWriter, run) +
                   testPart(htmlWriter, run) + htmlWriter.paragraph(sweepTexts().gradingNote) +
                   htmlWriter.paragraph(sweepTexts().hysteresisNote);
    for (const results::SweepServo& servo : run.servos)
        text += servoPart(htmlWriter, run, servo, series, place);
    return text + busPart(htmlWriter, run);
}
} // namespace report
