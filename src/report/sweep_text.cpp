// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_text.h"

#include "report/bilingual.h"
#include "results/sweep_limits.h"
#include "text/text_table.h"

#include <array>

namespace report {
using text::NamedText;

namespace {
void fillHeading(SweepTexts& words)
{
    words.title = translate("SweepText", "Sweep test report");
    words.simulated = translate("SweepText", "SIMULATED: no real servo was tested");
    words.bench = translate("SweepText", "Bench");
    words.test = translate("SweepText", "Test");
    words.servo = translate("SweepText", "Servo");
    words.verdict = translate("SweepText", "Verdict");
    words.date = translate("SweepText", "Date");
    words.operatorName = translate("SweepText", "Operator");
    words.note = translate("SweepText", "Note");
    words.port = translate("SweepText", "Port");
    words.length = translate("SweepText", "Duration");
    words.sampling = translate("SweepText", "Reading rate per servo");
    words.program = translate("SweepText", "Program");
    words.end = translate("SweepText", "End");
    words.endedBy = translate("SweepText", "Ended by servo");
    words.label = translate("SweepText", "Label");
    words.model = translate("SweepText", "Model");
    words.firmware = translate("SweepText", "Firmware");
    words.protocol = translate("SweepText", "Protocol");
    words.id = inBoth(QStringLiteral("ID"));
}

void fillTest(SweepTexts& words)
{
    words.shape = translate("SweepText", "Movement pattern");
    words.from = translate("SweepText", "Start");
    words.to = translate("SweepText", "End");
    words.step = translate("SweepText", "Step size");
    words.period = translate("SweepText", "Period");
    words.seed = translate("SweepText", "Random seed");
    words.points = translate("SweepText", "Goals");
    words.pace = translate("SweepText", "Next goal");
    words.cycles = translate("SweepText", "Cycles");
    words.asLongAs = translate("SweepText", "unlimited");
    words.duration = translate("SweepText", "Maximum duration");
    words.speed = translate("SweepText", "Speed");
    words.acceleration = translate("SweepText", "Acceleration");
    words.moveTime = translate("SweepText", "Travel time, ms");
    words.asTheServoHasIt = translate("SweepText", "the servo's present setting");
    words.warmUp = translate("SweepText", "Warm-up (not measured)");
    words.afterwards = translate("SweepText", "After the test");
    words.holds = translate("SweepText", "hold position");
    words.releases = translate("SweepText", "torque off");
    words.stopsOn = translate("SweepText", "End early after");
    words.stopOnAlarm = translate("SweepText", "an alarm");
    words.stopOnStall = translate("SweepText", "a stall");
    words.stopOnFailure = translate("SweepText", "the first failure");
    words.onlyOnLostLink = translate("SweepText", "only a lost connection");
    words.inSteps = translate("SweepText", "Range in steps");
    words.tolerance = translate("SweepText", "Tolerance");
}

void fillFigures(SweepTexts& words)
{
    words.result = translate("SweepText", "Result");
    words.figure = translate("SweepText", "Metric");
    words.figures = translate("SweepText", "Metrics");
    words.value = translate("SweepText", "Value");
    words.unit = translate("SweepText", "Unit");
    words.warnLimit = translate("SweepText", "Warn at");
    words.failLimit = translate("SweepText", "Fail at");
    words.reason = translate("SweepText", "Reason");
    words.within = translate("SweepText", "within the limits");
    words.over = translate("SweepText", "above %1");
    words.under = translate("SweepText", "below %1");
    words.noFeedback = translate(
        "SweepText", "not measured: the servo does not report this value, or no move was suitable");
    words.mean = translate("SweepText", "Mean");
    words.lowest = translate("SweepText", "Min");
    words.highest = translate("SweepText", "Max");
    words.count = translate("SweepText", "Count");
    words.notMeasured = translate("SweepText", "not measured");
    words.limits = translate("SweepText", "Limits");
    words.gradingNote = translate(
        "SweepText", "Errors, overshoot, settling time, phase lag, repeatability, current and load "
                     "are judged by the worst move. Speeds and the time to goal are judged by "
                     "their means; counts are judged by their sums.");
    words.paperNote = translate(
        "SweepText",
        "The HTML report also contains the memory tables and more details about each move.");
    words.hysteresisNote = translate("SweepText", "Positions are as reported by the servo; gear "
                                                  "backlash beyond the encoder is not measured.");
}

void fillCharts(SweepTexts& words)
{
    words.positionChart = translate("SweepText", "Position and goal");
    words.goal = translate("SweepText", "goal");
    words.position = translate("SweepText", "position");
    words.timeAxis = translate("SweepText", "Time, s");
    words.positionAxis = translate("SweepText", "Position, steps");
    words.histogram = translate("SweepText", "Distribution of steady-state error");
    words.errorAxis = translate("SweepText", "Steady-state error, steps");
    words.legsAxis = translate("SweepText", "Moves", "number");
    words.noSeries =
        translate("SweepText", "No chart is available because no readings were stored.");
    words.noErrors = translate("SweepText", "Steady-state error was not measured.");
}

void fillLegs(SweepTexts& words)
{
    words.legs = translate("SweepText", "Moves");
    words.legsShown = translate(
        "SweepText", "The first 50, the last 50, and the worst 20 of the remaining moves are shown "
                     "(%1 moves in total). The CSV and JSON files contain all moves.");
    words.worstShown =
        translate("SweepText", "Only the worst %1 of %2 moves are shown. The HTML report shows "
                               "more; the CSV and JSON files contain all moves.");
    words.leg = translate("SweepText", "Move");
    words.cycle = translate("SweepText", "Cycle");
    words.at = translate("SweepText", "Time, s");
    words.start = translate("SweepText", "Start");
    words.target = translate("SweepText", "Goal");
    words.reached = translate("SweepText", "Position reached");
    words.timeToTarget = translate("SweepText", "Time to goal, ms");
    words.settling = translate("SweepText", "Settling, ms");
    words.overshoot = translate("SweepText", "Overshoot, %");
    words.steadyError = translate("SweepText", "Error, steps");
    words.meanSpeed = translate("SweepText", "Mean speed, step/s");
    words.following = translate("SweepText", "Following error, steps");
    words.current = translate("SweepText", "Peak current, mA");
    words.load = translate("SweepText", "Peak load, %");
    words.voltage = translate("SweepText", "Min voltage, V");
    words.temperature = translate("SweepText", "Temp., °C");
    words.lost = translate("SweepText", "Lost readings");
    words.remarks = translate("SweepText", "Remarks");
    words.missed = translate("SweepText", "goal missed");
    words.flagWrong = translate("SweepText", "moving flag error");
}

void fillBus(SweepTexts& words)
{
    words.bus = translate("SweepText", "Bus");
    words.asked = translate("SweepText", "Reads and writes");
    words.timeouts = translate("SweepText", "No reply");
    words.badChecksums = translate("SweepText", "Wrong checksum");
    words.foreign = translate("SweepText", "Unexpected packets");
    words.late = translate("SweepText", "Late replies");
    words.gaps = translate("SweepText", "Interruptions");
    words.gapAt = translate("SweepText", "Time, s");
    words.gapSpan = translate("SweepText", "Duration, s");
    words.noGaps = translate("SweepText", "The connection was never interrupted.");
    words.parameters = translate("SweepText", "Memory table at the start");
    words.address = translate("SweepText", "Address");
    words.name = translate("SweepText", "Register");
    words.raw = translate("SweepText", "Raw value");
    words.area = translate("SweepText", "Area");
    words.readAt = translate("SweepText", "Read at");
    words.none = translate("SweepText", "none");
}

constexpr std::array builtInLimitsEntries{
    NamedText{"Any servo, built in", QT_TRANSLATE_NOOP("SweepText", "Any servo, built in")},
    NamedText{"4096 steps a turn, built in",
              QT_TRANSLATE_NOOP("SweepText", "4096 steps a turn, built in")},
    NamedText{"SCS, 1024 steps, built in",
              QT_TRANSLATE_NOOP("SweepText", "SCS, 1024 steps, built in")},
    NamedText{"LX, 1000 steps, built in",
              QT_TRANSLATE_NOOP("SweepText", "LX, 1000 steps, built in")},
};

constexpr std::array metricEntries{
    NamedText{"time_to_target", QT_TRANSLATE_NOOP("SweepText", "Time to goal")},
    NamedText{"settling", QT_TRANSLATE_NOOP("SweepText", "Settling time")},
    NamedText{"overshoot", QT_TRANSLATE_NOOP("SweepText", "Overshoot")},
    NamedText{"steady_error", QT_TRANSLATE_NOOP("SweepText", "Steady-state error")},
    NamedText{"hysteresis", QT_TRANSLATE_NOOP("SweepText", "Hysteresis, both directions")},
    NamedText{"repeatability_sigma", QT_TRANSLATE_NOOP("SweepText", "Repeatability σ")},
    NamedText{"repeatability_range", QT_TRANSLATE_NOOP("SweepText", "Repeatability range")},
    NamedText{"following_error", QT_TRANSLATE_NOOP("SweepText", "Following error")},
    NamedText{"following_error_relative",
              QT_TRANSLATE_NOOP("SweepText", "Relative following error")},
    NamedText{"phase_lag", QT_TRANSLATE_NOOP("SweepText", "Phase lag")},
    NamedText{"readings_per_period", QT_TRANSLATE_NOOP("SweepText", "Readings per period")},
    NamedText{"mean_speed", QT_TRANSLATE_NOOP("SweepText", "Mean speed")},
    NamedText{"top_speed", QT_TRANSLATE_NOOP("SweepText", "Top speed")},
    NamedText{"current_peak", QT_TRANSLATE_NOOP("SweepText", "Peak current")},
    NamedText{"current_mean", QT_TRANSLATE_NOOP("SweepText", "Mean current")},
    NamedText{"load_peak", QT_TRANSLATE_NOOP("SweepText", "Peak load")},
    NamedText{"load_mean", QT_TRANSLATE_NOOP("SweepText", "Mean load")},
    NamedText{"voltage_min", QT_TRANSLATE_NOOP("SweepText", "Lowest voltage")},
    NamedText{"temperature_rise", QT_TRANSLATE_NOOP("SweepText", "Temperature rise")},
    NamedText{"temperature_max", QT_TRANSLATE_NOOP("SweepText", "Highest temperature")},
    NamedText{"moving_flag_errors", QT_TRANSLATE_NOOP("SweepText", "Moving flag errors")},
    NamedText{"missed_targets", QT_TRANSLATE_NOOP("SweepText", "Missed goals")},
    NamedText{"communication_errors", QT_TRANSLATE_NOOP("SweepText", "Communication errors")},
    NamedText{"alarms", QT_TRANSLATE_NOOP("SweepText", "Alarms")},
};

constexpr std::array unitEntries{
    NamedText{"step", QT_TRANSLATE_NOOP("SweepText", "step")},
    NamedText{"step/s", QT_TRANSLATE_NOOP("SweepText", "step/s")},
    NamedText{"legs", QT_TRANSLATE_NOOP("SweepText", "moves")},
};

/// By the bit of the status byte, which is the same in all maps that have one.
constexpr std::array alarmEntries{
    QT_TRANSLATE_NOOP("SweepText", "voltage"),     QT_TRANSLATE_NOOP("SweepText", "sensor"),
    QT_TRANSLATE_NOOP("SweepText", "temperature"), QT_TRANSLATE_NOOP("SweepText", "overcurrent"),
    QT_TRANSLATE_NOOP("SweepText", "angle"),       QT_TRANSLATE_NOOP("SweepText", "overload"),
};

struct GradeEntry {
    results::Grade key;
    const char* label;
    const char* lineLabel;
    const char* sign;
    const char* styleClass;
};

constexpr std::array gradeEntries{
    GradeEntry{results::Grade::Pass, QT_TRANSLATE_NOOP("SweepText", "Pass"),
               QT_TRANSLATE_NOOP("SweepText", "OK"), "✔", "pass"},
    GradeEntry{results::Grade::Warn, QT_TRANSLATE_NOOP("SweepText", "Warn"),
               QT_TRANSLATE_NOOP("SweepText", "Warn"), "⚠", "warn"},
    GradeEntry{results::Grade::Fail, QT_TRANSLATE_NOOP("SweepText", "Fail"),
               QT_TRANSLATE_NOOP("SweepText", "Fail"), "✘", "fail"},
    GradeEntry{results::Grade::NotMeasured, QT_TRANSLATE_NOOP("SweepText", "No verdict"),
               QT_TRANSLATE_NOOP("SweepText", "not measured"), "–", "none"},
};

const GradeEntry& gradeEntry(results::Grade grade)
{
    return *text::entryFor(gradeEntries, grade);
}

template <typename Table>
Text sweepText(const Table& table, const QString& key)
{
    const NamedText* entry = text::entryFor(table, key);
    return entry != nullptr ? translate("SweepText", entry->text) : inBoth(key);
}
} // namespace

const SweepTexts& sweepTexts()
{
    static const SweepTexts words = [] {
        SweepTexts all;
        fillHeading(all);
        fillTest(all);
        fillFigures(all);
        fillCharts(all);
        fillLegs(all);
        fillBus(all);
        return all;
    }();
    return words;
}

Text gradeLabel(results::Grade grade)
{
    return translate("SweepText", gradeEntry(grade).label);
}

Text lineGradeLabel(results::Grade grade)
{
    return translate("SweepText", gradeEntry(grade).lineLabel);
}

QString gradeSign(results::Grade grade)
{
    return QString::fromUtf8(gradeEntry(grade).sign);
}

QString gradeClass(results::Grade grade)
{
    return QLatin1String(gradeEntry(grade).styleClass);
}

Text noVerdictReasonText(results::NoVerdictReason reason)
{
    switch (reason) {
    case results::NoVerdictReason::None:
        return {};
    case results::NoVerdictReason::Ended:
        return translate("SweepText", "The test ended too early.");
    case results::NoVerdictReason::TooShort:
        return translate("SweepText",
                         "The test was too short to judge. Run at least one whole cycle.");
    case results::NoVerdictReason::TooFewReadings:
        return translate("SweepText", "There were fewer than 20 readings per period. Use a longer "
                                      "period, fewer servos or a higher baud rate.");
    case results::NoVerdictReason::TooFast:
        return translate("SweepText", "The sine motion is faster than the speed set for the servo. "
                                      "Use a longer period, a smaller range or a higher speed.");
    case results::NoVerdictReason::NoLimit:
        return translate("SweepText",
                         "No limits are set for how closely the servo follows its goal. Add limits "
                         "for the relative following error and the phase lag.");
    case results::NoVerdictReason::ShortMoves:
        return translate(
            "SweepText",
            "The moves are too short for the tolerance, so even a servo that does not move would "
            "pass. Make each move at least three times as long as the tolerance.");
    case results::NoVerdictReason::SlowLink:
        return translate("SweepText",
                         "The servo lags too far behind, but the communication delay "
                         "may be the cause. At least 40 readings per period are needed: use a "
                         "longer period, fewer servos or a faster adapter.");
    case results::NoVerdictReason::NotMeasured:
        break;
    }
    return translate("SweepText",
                     "The metrics needed for a verdict were not measured in most moves. Allow more "
                     "time for each move, or read faster: use fewer servos or a faster adapter.");
}

Text endText(results::SweepEnd end)
{
    switch (end) {
    case results::SweepEnd::Finished:
        return translate("SweepText", "Completed.");
    case results::SweepEnd::Stopped:
        return translate("SweepText", "Stopped by the user.");
    case results::SweepEnd::Emergency:
        return translate("SweepText",
                         "Ended by the emergency stop; torque was turned off on the whole bus.");
    case results::SweepEnd::Alarm:
        return translate("SweepText", "Ended early: a servo raised an alarm.");
    case results::SweepEnd::Stall:
        return translate("SweepText", "Ended early: a servo stalled before reaching its goal.");
    case results::SweepEnd::Failure:
        return translate("SweepText", "Ended early: a limit was violated, and the test was set to "
                                      "stop at the first failure.");
    case results::SweepEnd::Refused:
        return translate(
            "SweepText",
            "Ended early: a servo no longer accepted its goal because its limits or mode changed.");
    case results::SweepEnd::TorqueLost:
        return translate("SweepText",
                         "Ended early: a servo lost torque because it rebooted or another program "
                         "turned torque off. Torque was not turned on again.");
    case results::SweepEnd::ServoReplaced:
        return translate(
            "SweepText",
            "Ended early: a different servo is now replying with the ID of the tested servo.");
    case results::SweepEnd::LinkLost:
        break;
    }
    return translate("SweepText", "Ended early: the connection was lost and was not restored.");
}

Text shapeText(results::SweepShape shape)
{
    switch (shape) {
    case results::SweepShape::Sweep:
        return translate("SweepText", "back and forth");
    case results::SweepShape::Stairs:
        return translate("SweepText", "staircase up and down");
    case results::SweepShape::BothSides:
        return translate("SweepText", "middle of the range from both directions");
    case results::SweepShape::Random:
        return translate("SweepText", "random goals");
    case results::SweepShape::Sine:
        return translate("SweepText", "sine");
    case results::SweepShape::Points:
        break;
    }
    return translate("SweepText", "list of goals");
}

Text paceText(results::SweepPace pace)
{
    return pace == results::SweepPace::Delay
               ? translate("SweepText",
                           "delay from one goal to the next, whether or not the goal is reached")
               : translate("SweepText", "dwell after arrival");
}

Text metricLabel(const QString& key)
{
    return sweepText(metricEntries, key);
}

Text unitText(const QString& unit)
{
    return sweepText(unitEntries, unit);
}

Text limitsName(const QString& name)
{
    if (name.endsWith(results::customSuffix))
        return filled(translate("SweepText", "%1, custom"),
                      inBoth(name.chopped(results::customSuffix.size())));
    return sweepText(builtInLimitsEntries, name);
}

Text alarmBitsText(std::uint8_t alarms)
{
    Text words;
    for (std::size_t bit = 0; bit < 8; ++bit) {
        if (!(alarms & (1U << bit)))
            continue;
        const Text one = bit < alarmEntries.size() ? translate("SweepText", alarmEntries[bit])
                                                   : filled(translate("SweepText", "bit %1"),
                                                            inBoth(QString::number(bit)));
        words.en += (words.en.isEmpty() ? QString() : QStringLiteral(", ")) + one.en;
        words.zh += (words.zh.isEmpty() ? QString() : QStringLiteral("、")) + one.zh;
    }
    return words;
}
} // namespace report
