// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of a sweep test's report, in both languages, because the page contains both and
// switches between them without the program. Constant; any thread.
#pragma once

#include "catalog/register.h"
#include "results/sweep_verdict.h"

namespace report {
using catalog::Text;

struct SweepTexts {
    // heading
    Text title, simulated, bench, test, servo, verdict, date, operatorName, note, port, length,
        sampling, program, end, endedBy, label, model, firmware, protocol, id;
    // the test
    Text shape, from, to, step, period, seed, points, pace, cycles, asLongAs, duration, speed,
        acceleration, moveTime, asTheServoHasIt, warmUp, afterwards, holds, releases, stopsOn,
        stopOnAlarm, stopOnStall, stopOnFailure, onlyOnLostLink, inSteps, tolerance;
    // verdict and figures
    Text result, figure, figures, value, unit, warnLimit, failLimit, reason, within, over, under,
        noFeedback, mean, lowest, highest, count, notMeasured, limits, gradingNote, hysteresisNote,
        paperNote;
    // charts
    Text positionChart, goal, position, timeAxis, positionAxis, histogram, errorAxis, legsAxis,
        noSeries, noErrors;
    // legs
    Text legs, legsShown, worstShown, leg, cycle, at, start, target, reached, timeToTarget,
        settling, overshoot, steadyError, meanSpeed, following, current, load, voltage, temperature,
        lost, remarks, missed, flagWrong;
    // bus, parameters
    Text bus, asked, timeouts, badChecksums, foreign, late, gaps, gapAt, gapSpan, noGaps,
        parameters, address, name, raw, area, readAt, none;
};
const SweepTexts& sweepTexts();

Text gradeLabel(results::Grade grade);     ///< of a servo or a run: "Pass"
Text lineGradeLabel(results::Grade grade); ///< of one figure, not a verdict: "OK"
QString gradeSign(results::Grade grade);   ///< "✔"
/// The style class of its color in a report: "pass".
QString gradeClass(results::Grade grade);
Text endText(results::SweepEnd end); ///< a sentence
Text noVerdictReasonText(
    results::NoVerdictReason reason); ///< sentences: why there is none, and what to do; None: empty
Text shapeText(results::SweepShape shape);
Text paceText(results::SweepPace pace);
Text metricLabel(const QString& key);    ///< an unknown key: the key itself
Text unitText(const QString& unit);      ///< "step" / "步"
Text limitsName(const QString& name);    ///< built-in and custom limits have a Chinese name
Text alarmBitsText(std::uint8_t alarms); ///< "overload, voltage"; empty: none
} // namespace report
