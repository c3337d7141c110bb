// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_csv.h"

#include "files/csv_text.h"
#include "files/text_file.h"
#include "results/sweep_fields.h"

#include <QLocale>

#include <cmath>

namespace results {
namespace {
QByteArray legsHeader()
{
    QByteArray header = "servo,leg,cycle,at[ms],span[ms],start[step],target[step],time[ms],"
                        "settling[ms]";
    for (const LegFigure& figure : legFigures)
        header += QByteArray(",") + figure.key + '[' + figure.unit + ']';
    return header + ",samples,lost,missed,flag_wrong,alarms\n";
}

QByteArray legLine(int servo, const SweepLeg& leg)
{
    QByteArray line = QByteArray::number(servo) + ',' + QByteArray::number(leg.number) + ',' +
                      QByteArray::number(leg.cycle) + ',' + files::csvNumber(inMs(leg.at)) + ',' +
                      files::csvNumber(inMs(leg.span)) + ',' + files::csvNumber(leg.start) + ',' +
                      files::csvNumber(leg.target) + ',' +
                      files::csvNumber(inMs(leg.timeToTarget)) + ',' +
                      files::csvNumber(inMs(leg.settling));
    for (const LegFigure& figure : legFigures)
        line += ',' + files::csvNumber(leg.*figure.member);
    return line + ',' + QByteArray::number(leg.samples) + ',' + QByteArray::number(leg.lost) +
           (leg.missed ? ",1," : ",0,") + files::csvNumber(leg.flagWrong) + ',' +
           QByteArray::number(leg.alarms) + '\n';
}

void writeLegs(const SweepRun& run, const files::TextSink& sink)
{
    sink(legsHeader());
    for (const SweepServo& servo : run.servos) {
        QByteArray lines;
        for (const SweepLeg& leg : servo.legs) {
            lines += legLine(servo.parameters.servo.id, leg);
            if (lines.size() > 65536 && !sink(std::exchange(lines, {})))
                return;
        }
        sink(lines);
    }
}
} // namespace

base::Result<void> saveSweepLegs(const SweepRun& run, const QString& path)
{
    return files::saveTextFile(
        QStringLiteral("save-legs"), [&](const files::TextSink& sink) { writeLegs(run, sink); },
        path);
}
} // namespace results
