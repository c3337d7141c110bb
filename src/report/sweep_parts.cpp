// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_parts.h"

#include "report/sweep_words.h"

namespace report {
namespace {
using Rows = std::vector<QStringList>;

QString userText(const QString& text)
{
    return QStringLiteral("<span class=\"user\">") + escaped(text) + QStringLiteral("</span>");
}

Text seconds(base::Duration span)
{
    const QString text = inSeconds(span) + QStringLiteral(" s");
    return {text, text};
}

/// A row only where there is something to say.
void addUserRow(const Scribe& scribe, Rows& rows, const Text& name, const QString& text)
{
    if (!text.isEmpty())
        rows.push_back({scribe.say(name), userText(text)});
}

QString verdictPart(const Scribe& scribe, const record::SweepRun& run)
{
    const SweepWords& words = sweepWords();
    QString text = scribe.heading(1, words.title);
    if (run.simulated)
        text += QStringLiteral("<p class=\"simulated\">") + scribe.say(words.simulated) +
                QStringLiteral("</p>\n");
    text += QStringLiteral("<p class=\"overall\">") + badge(scribe, run.verdict()) +
            QStringLiteral("</p>\n<p>") + scribe.say(endWords(run.end));
    if (run.endedBy >= 0)
        text += u' ' + scribe.say(words.endedBy) + QStringLiteral(": ID ") +
                QString::number(run.endedBy);
    return text + QStringLiteral("</p>\n");
}

QString benchPart(const Scribe& scribe, const record::SweepRun& run)
{
    const SweepWords& words = sweepWords();
    Rows rows;
    rows.push_back(
        {scribe.say(words.date),
         run.at.toUTC().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) + QStringLiteral(" UTC")});
    addUserRow(scribe, rows, words.operatorName, run.spec.operatorName);
    addUserRow(scribe, rows, words.note, run.spec.note);
    rows.push_back({scribe.say(words.port), escaped(run.port) + QStringLiteral(", ") +
                                                QString::number(run.baud) +
                                                QStringLiteral(" baud")});
    rows.push_back({scribe.say(words.length), scribe.say(seconds(run.length))});
    rows.push_back({scribe.say(words.sampling), figure(run.sampleRate) + QStringLiteral(" /s")});
    rows.push_back({scribe.say(words.program), escaped(run.program)});
    return scribe.heading(2, words.bench) + pairs(rows);
}

QString servosPart(const Scribe& scribe, const record::SweepRun& run)
{
    const SweepWords& words = sweepWords();
    Rows rows;
    for (const record::SweepServo& servo : run.servos) {
        const record::SnapshotServo& who = servo.parameters.servo;
        rows.push_back({QString::number(who.id), escaped(who.model), escaped(who.firmware),
                        escaped(who.protocol), userText(servo.parameters.label),
                        badge(scribe, servo.verdict)});
    }
    const QStringList headings{scribe.say(words.id),       scribe.say(words.model),
                               scribe.say(words.firmware), scribe.say(words.protocol),
                               scribe.say(words.label),    scribe.say(words.verdict)};
    return scribe.heading(2, words.servos) + table(headings, rows);
}

QString rangeOf(const record::SweepRange& range)
{
    return escaped(range.from) + QStringLiteral(" … ") + escaped(range.to);
}

QString pointsOf(const record::SweepSpec& spec)
{
    QStringList points;
    for (const record::SweepPoint& point : spec.points)
        points.append(
            escaped(point.target) +
            (point.pause ? QStringLiteral(" (%1 s)").arg(inSeconds(*point.pause)) : QString()));
    return points.join(QStringLiteral("; "));
}

/// What only some shapes have.
void addShapeRows(const Scribe& scribe, const record::SweepSpec& spec, Rows& rows)
{
    using record::SweepShape;
    const SweepWords& words = sweepWords();
    if (spec.shape == SweepShape::Points) {
        rows.push_back({scribe.say(words.points), pointsOf(spec)});
    } else {
        const QString ends = scribe.say(words.from) + QStringLiteral(" … ") + scribe.say(words.to);
        rows.push_back({ends, rangeOf(spec.range)});
        for (const auto& [id, range] : spec.ranges)
            rows.push_back({ends + QStringLiteral(", ID ") + QString::number(id), rangeOf(range)});
    }
    if (spec.shape == SweepShape::Stairs)
        rows.push_back({scribe.say(words.step), escaped(spec.step)});
    if (spec.shape == SweepShape::Sine)
        rows.push_back({scribe.say(words.period), scribe.say(seconds(spec.period))});
    if (spec.shape == SweepShape::Random)
        rows.push_back({scribe.say(words.seed), QString::number(spec.seed)});
}

void addMotionRows(const Scribe& scribe, const record::SweepSpec& spec, Rows& rows)
{
    const SweepWords& words = sweepWords();
    const auto asked = [&](const QString& text) {
        return text.isEmpty() ? scribe.say(words.asTheServoHasIt) : escaped(text);
    };
    rows.push_back({scribe.say(words.speed), asked(spec.speed)});
    rows.push_back({scribe.say(words.acceleration), asked(spec.acceleration)});
    if (!spec.time.isEmpty())
        rows.push_back({scribe.say(words.moveTime), escaped(spec.time)});
}

QString stopsOf(const Scribe& scribe, const record::SweepSpec& spec)
{
    const SweepWords& words = sweepWords();
    QStringList stops;
    if (spec.stopOnAlarm)
        stops.append(scribe.say(words.stopOnAlarm));
    if (spec.stopOnStall)
        stops.append(scribe.say(words.stopOnStall));
    if (spec.stopOnFailure)
        stops.append(scribe.say(words.stopOnFailure));
    return stops.isEmpty() ? scribe.say(words.nothingElse) : stops.join(QStringLiteral(", "));
}

QString testPart(const Scribe& scribe, const record::SweepRun& run)
{
    const SweepWords& words = sweepWords();
    const record::SweepSpec& spec = run.spec;
    Rows rows;
    rows.push_back({scribe.say(words.shape), scribe.say(shapeWords(spec.shape))});
    addShapeRows(scribe, spec, rows);
    rows.push_back({scribe.say(words.pace), inSeconds(spec.pause) + QStringLiteral(" s ") +
                                                scribe.say(paceWords(spec.pace))});
    rows.push_back({scribe.say(words.cycles),
                    spec.cycles > 0 ? QString::number(spec.cycles) : scribe.say(words.asLongAs)});
    if (spec.length.count() > 0)
        rows.push_back({scribe.say(words.duration), scribe.say(seconds(spec.length))});
    addMotionRows(scribe, spec, rows);
    if (spec.warmUp.count() > 0)
        rows.push_back({scribe.say(words.warmUp), scribe.say(seconds(spec.warmUp))});
    rows.push_back({scribe.say(words.afterwards),
                    scribe.say(spec.releaseAtEnd ? words.releases : words.holds)});
    rows.push_back({scribe.say(words.stopsOn), stopsOf(scribe, spec)});
    return scribe.heading(2, words.test) + pairs(rows);
}

QString busPart(const Scribe& scribe, const record::SweepRun& run)
{
    const SweepWords& words = sweepWords();
    const auto count = [](std::uint64_t number) { return QString::number(number); };
    Rows rows;
    for (const record::SweepServo& servo : run.servos) {
        const record::SweepErrors& errors = servo.errors;
        rows.push_back({QString::number(servo.parameters.servo.id), count(errors.asked),
                        count(errors.timeOuts), count(errors.badChecks), count(errors.foreign),
                        count(errors.late)});
    }
    QString text =
        scribe.heading(2, words.bus) +
        table({scribe.say(words.id), scribe.say(words.asked), scribe.say(words.timeOuts),
               scribe.say(words.badChecks), scribe.say(words.foreign), scribe.say(words.late)},
              rows) +
        scribe.heading(3, words.gaps);
    if (run.gaps.empty())
        return text + scribe.paragraph(words.noGaps);
    Rows gaps;
    for (const record::SweepGap& gap : run.gaps)
        gaps.push_back({inSeconds(gap.at), inSeconds(gap.span)});
    return text + table({scribe.say(words.gapAt), scribe.say(words.gapSpan)}, gaps);
}
} // namespace

QString sweepBody(const Scribe& scribe, const record::SweepRun& run,
                  const std::vector<SweepSeries>& series, const PlaceChart& place)
{
    QString text = verdictPart(scribe, run) + servosPart(scribe, run) + benchPart(scribe, run) +
                   testPart(scribe, run);
    for (const record::SweepServo& servo : run.servos)
        text += servoPart(scribe, run, servo, series, place);
    return text + busPart(scribe, run);
}
} // namespace report
