// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep test of two servos with every field set to something of its own; for tests of its files
// and reports. The texts are hostile on purpose.
#pragma once

#include "results/sweep_fields.h"
#include "results/sweep_verdict.h"

#include <QRegularExpression>

#include <cmath>

namespace sweep_example {
using namespace std::chrono_literals;

inline const QString hostileNote =
    QStringLiteral("<script>alert('note')</script> & \"worn\" ]]> </td>\n磨损");
inline const QString hostileOperator = QStringLiteral("O'Neill <b>&amp;</b>");
inline const QString hostileLabel = QStringLiteral("left \"knee\"><img src=x onerror=alert(1)>");

/// A measured value as people read it: "2346", "650.5", "12.7", "9.75".
inline QString written(double value)
{
    const double size = std::abs(value);
    QString text = QString::number(value, 'f', size >= 1000 ? 0 : size >= 10 ? 1 : 2);
    static const QRegularExpression zeros(QStringLiteral("\\.0*$|(\\.\\d*?)0+$"));
    text.replace(zeros, QStringLiteral("\\1"));
    return text == QStringLiteral("-0") ? QStringLiteral("0") : text;
}

inline results::SweepLeg leg(int number)
{
    results::SweepLeg leg;
    leg.number = number;
    leg.cycle = (number + 1) / 2;
    leg.at = 1000001us * number;
    leg.span = 1000001us;
    const bool up = number % 2 == 1;
    leg.start = up ? 1003 : 3048;
    leg.target = up ? 3051 : 1000;
    leg.steadyError = up ? -3.25 : 3 + number * 0.125;
    leg.reached = leg.target + *leg.steadyError;
    leg.timeToTarget = 412345us + number * 7us;
    leg.settling = 30007us;
    leg.overshoot = 1.5 + number * 0.0625;
    leg.overshootSteps = 30.1;
    leg.meanSpeed = 2345.678;
    leg.topSpeed = 2999.125;
    leg.followingError = 77.7;
    leg.currentPeak = 650.5;
    leg.currentMean = 211.3;
    leg.loadPeak = 31.4;
    leg.loadMean = 12.7;
    leg.voltageMin = 11.7;
    leg.temperatureMax = 38;
    leg.samples = 401;
    leg.flagWrong = false;
    return leg;
}

/// One that was not reached, of a servo that measures next to nothing.
inline results::SweepLeg missedLeg(int number)
{
    results::SweepLeg leg;
    leg.number = number;
    leg.cycle = number;
    leg.at = 2s * number;
    leg.span = 2s;
    leg.start = 100;
    leg.target = 900.5;
    leg.reached = 612.25;
    leg.lost = 4;
    leg.missed = true;
    leg.flagWrong = true;
    leg.alarms = 0x24;
    return leg;
}

/// How well goals are followed, which the first version did not measure.
inline bool isMetricAddedLater(const QString& key)
{
    return key == QLatin1StringView("following_error_relative") ||
           key == QLatin1StringView("phase_lag") || key == QLatin1StringView("readings_per_period");
}

/// Every metric; those without a mean are counts.
inline std::vector<results::SweepMetric> metrics(bool measured, bool later = true)
{
    std::vector<results::SweepMetric> metrics;
    double value = 1.0625;
    for (const results::SweepMetricKind& kind : results::sweepMetricKinds()) {
        if (!later && isMetricAddedLater(kind.key))
            continue;
        results::SweepMetric metric{kind.key, kind.unit};
        if (measured) {
            metric.value = value;
            metric.mean = value - 0.5;
            metric.min = value - 1.25;
            metric.max = value + 0.25;
            metric.count = 600 + metrics.size();
        }
        metrics.push_back(metric);
        value += 3.5;
    }
    return metrics;
}

inline results::SweepServo servo(int id, const char* model)
{
    results::SweepServo servo;
    servo.parameters.program = QStringLiteral("ServoDesk 0.1.0");
    servo.parameters.at = QDateTime({2026, 3, 9}, {8, 59, 58}, Qt::UTC);
    servo.parameters.label = hostileLabel;
    servo.parameters.port = QStringLiteral("/dev/ttyUSB0");
    servo.parameters.baud = 1000000;
    servo.parameters.servo = {id,
                              QString::fromLatin1(model),
                              QStringLiteral("9.3"),
                              QStringLiteral("3.10"),
                              QStringLiteral("sts-sms"),
                              QStringLiteral("feetech")};
    servo.parameters.registers = {
        {QStringLiteral("min_angle"), 9, 512, 45.0, QStringLiteral("deg"), catalog::Area::Eprom,
         catalog::Access::ReadWrite},
        {QStringLiteral("max_angle"),
         11,
         {},
         {},
         QStringLiteral("deg"),
         catalog::Area::Eprom,
         catalog::Access::ReadWrite},
    };
    servo.axis.from = 1000;
    servo.axis.to = 3051;
    servo.axis.step = 10;
    servo.axis.points = {1, 2.5};
    servo.axis.tolerance = 10.5;
    servo.axis.speed = 3000;
    servo.limits = results::builtInSweepLimits({}, QStringLiteral("STS"));
    servo.errors = {12345, 21, 32, 43, 54};
    return servo;
}

inline results::SweepSpec spec()
{
    results::SweepSpec spec;
    spec.shape = results::SweepShape::BothSides;
    spec.range = {QStringLiteral("1000"), QStringLiteral("268.1deg")};
    spec.ranges[6] = {QStringLiteral("100"), QStringLiteral("900")};
    spec.step = QStringLiteral("10");
    spec.points = {{QStringLiteral("1024"), 750ms}, {QStringLiteral("90deg"), {}}};
    spec.seed = 4294967295U;
    spec.period = 3s;
    spec.pace = results::SweepPace::Dwell;
    spec.pause = 1500ms;
    spec.cycles = 300;
    spec.length = 600s;
    spec.speed = QStringLiteral("30rpm");
    spec.acceleration = QStringLiteral("50");
    spec.time = QStringLiteral("800");
    spec.warmUp = 60s;
    spec.releaseAtEnd = true;
    spec.stopOnAlarm = false;
    spec.stopOnStall = false;
    spec.stopOnFailure = true;
    spec.operatorName = hostileOperator;
    spec.note = hostileNote;
    return spec;
}

/// Servo 5 measured everything and is warned about, servo 6 failed and ended the run, so that
/// servo 5 has no verdict. `legs`: of servo 5.
inline results::SweepRun run(int legs = 6)
{
    results::SweepServo good = servo(5, "STS3215");
    for (int i = 1; i <= legs; ++i)
        good.legs.push_back(leg(i));
    good.metrics = metrics(true);
    good.lines = {{good.limits.lines[0], 2.25, results::Grade::Pass},
                  {good.limits.lines[1], 9.75, results::Grade::Warn}};
    good.verdict = results::Grade::NotMeasured; // the other one ended the run
    results::SweepServo bad = servo(6, "SCS15");
    bad.legs = {missedLeg(1), missedLeg(2)};
    bad.metrics = metrics(false);
    bad.lines = {{{QStringLiteral("missed_targets"), QStringLiteral("legs"), {}, 0.0, false},
                  2.0,
                  results::Grade::Fail},
                 {{QStringLiteral("overshoot"), QStringLiteral("%"), 3.0, 5.0, false},
                  {},
                  results::Grade::NotMeasured}};
    bad.verdict = results::Grade::Fail;

    results::SweepRun run;
    run.program = QStringLiteral("ServoDesk 0.1.0");
    run.at = QDateTime({2026, 3, 9}, {9, 0, 1, 234}, Qt::UTC);
    run.port = QStringLiteral("/dev/ttyUSB0");
    run.baud = 1000000;
    run.simulated = true;
    run.spec = spec();
    run.length = 601234567us;
    run.end = results::SweepEnd::Stall;
    run.endedBy = 6;
    run.gaps = {{12s, 2500ms}, {77s, 1s}};
    run.sampleRate = 398.75;
    run.servos = {good, bad};
    return run;
}

/// The same, run to its end.
inline results::SweepRun finishedRun(int legs = 6)
{
    results::SweepRun run = sweep_example::run(legs);
    run.end = results::SweepEnd::Finished;
    run.endedBy = -1;
    results::assignVerdicts(run);
    return run;
}

/// run() as the first version kept it.
inline results::SweepRun firstVersionRun()
{
    results::SweepRun run = sweep_example::run();
    run.servos[0].metrics = metrics(true, false);
    run.servos[1].metrics = metrics(false, false);
    for (results::SweepServo& servo : run.servos)
        std::erase_if(servo.limits.lines, [](const results::SweepLimit& line) {
            return isMetricAddedLater(line.metric);
        });
    return run;
}
} // namespace sweep_example
