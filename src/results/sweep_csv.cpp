// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_csv.h"

#include "files/csv_text.h"
#include "files/text_file.h"
#include "results/sweep_fields.h"

#include <QLocale>

#include <cmath>

namespace record {
namespace {
void writeLegs(const SweepRun& run, const TextSink& sink)
{
    sink(sweepLegsHeader());
    for (const SweepServo& servo : run.servos) {
        QByteArray lines;
        for (const SweepLeg& leg : servo.legs) {
            lines += sweepLegsLine(servo.parameters.servo.id, leg);
            if (lines.size() > 65536 && !sink(std::exchange(lines, {})))
                return;
        }
        sink(lines);
    }
}
} // namespace

QByteArray sweepLegsHeader()
{
    QByteArray header = "servo,leg,cycle,at[ms],span[ms],start[step],target[step],time[ms],"
                        "settling[ms]";
    for (const LegFigure& figure : legFigures)
        header += QByteArray(",") + figure.key + '[' + figure.unit + ']';
    return header + ",samples,lost,missed,flag_wrong,alarms\n";
}

QByteArray sweepLegsLine(int servo, const SweepLeg& leg)
{
    QByteArray line = QByteArray::number(servo) + ',' + QByteArray::number(leg.number) + ',' +
                      QByteArray::number(leg.cycle) + ',' + csvNumber(inMs(leg.at)) + ',' +
                      csvNumber(inMs(leg.span)) + ',' + csvNumber(leg.start) + ',' +
                      csvNumber(leg.target) + ',' + csvNumber(inMs(leg.timeToTarget)) + ',' +
                      csvNumber(inMs(leg.settling));
    for (const LegFigure& figure : legFigures)
        line += ',' + csvNumber(leg.*figure.member);
    return line + ',' + QByteArray::number(leg.samples) + ',' + QByteArray::number(leg.lost) +
           (leg.missed ? ",1," : ",0,") + csvNumber(leg.flagWrong) + ',' +
           QByteArray::number(leg.alarms) + '\n';
}

QByteArray encodeSweepLegs(const SweepRun& run)
{
    QByteArray text;
    writeLegs(run, [&](const QByteArray& piece) {
        text += piece;
        return true;
    });
    return text;
}

base::Result<void> saveSweepLegs(const SweepRun& run, const QString& path)
{
    return saveTextFile(
        QStringLiteral("save-legs"), [&](const TextSink& sink) { writeLegs(run, sink); }, path);
}
} // namespace record
