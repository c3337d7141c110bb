// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a sweep test: every leg, the figures over the run, the verdict. Plain values, kept
// in the report; any thread. Positions in steps of the servo's feedback, speeds in steps/s, current
// in mA, load in %, voltage in V, temperature in °C. A value that the family cannot measure is
// nullopt. As JSON: sweep_json.h; as CSV: legs.
#pragma once

#include "results/sweep_limits.h"
#include "results/sweep_spec.h"
#include "snapshot/snapshot.h"

namespace results {
/// Alarms and losses count as long as the leg lasts.
struct SweepLeg {
    int number = 0;        ///< from 1
    int cycle = 0;         ///< from 1
    base::Duration at{};   ///< the goal was sent, from the start of the run
    base::Duration span{}; ///< until the next goal, or the end
    double start = 0;      ///< where it stood
    double target = 0;
    std::optional<double> reached{};              ///< mean of the last readings
    std::optional<base::Duration> timeToTarget{}; ///< first within tolerance; none: missed
    std::optional<base::Duration> settling{};     ///< from then until it stayed within
    std::optional<double> overshoot{};            ///< beyond the target, % of the way
    std::optional<double> overshootSteps{};
    std::optional<double> steadyError{}; ///< reached − target
    std::optional<double> meanSpeed{};   ///< over the middle 80 % of the way
    std::optional<double> topSpeed{};
    std::optional<double> followingError{}; ///< largest lag behind the commanded path
    std::optional<double> phaseLag{};       ///< of a sine: behind the goals, degrees of its period
    std::optional<double> currentPeak{};
    std::optional<double> currentMean{};
    std::optional<double> loadPeak{};
    std::optional<double> loadMean{};
    std::optional<double> voltageMin{};
    std::optional<double> temperatureMax{};
    int samples = 0;
    int lost = 0;                    ///< readings without an answer
    bool missed = false;             ///< never within tolerance
    std::optional<bool> flagWrong{}; ///< the moving flag contradicted the position
    std::uint8_t alarms = 0;         ///< status bits seen
    bool operator==(const SweepLeg&) const = default;
};

/// One figure over the run. `value` is the one that is evaluated; see sweepMetrics().
struct SweepMetric {
    QString key; ///< "overshoot", also in the limits file
    QString unit;
    std::optional<double> value{}; ///< nullopt: not measured
    std::optional<double> mean{};
    std::optional<double> min{};
    std::optional<double> max{};
    std::uint64_t count = 0; ///< of the legs, targets or samples it was computed from
    bool operator==(const SweepMetric&) const = default;
};

enum class Grade : std::uint8_t { Pass, Warn, Fail, NotMeasured };
QString gradeName(Grade grade); ///< "pass", "warn", "fail", "not-measured"
std::optional<Grade> gradeFromName(const QString& name);

struct VerdictLine {
    SweepLimit limit;
    std::optional<double> value{};
    Grade grade = Grade::NotMeasured;
    bool operator==(const VerdictLine&) const = default;
};

enum class SweepEnd : std::uint8_t {
    Finished,
    Stopped,   ///< by the user
    Emergency, ///< the stop key
    Alarm,
    Stall,
    Failure, ///< the first failed line, if the test stops there
    LinkLost,
    Refused,       ///< a servo no longer took a goal: its limits or its mode have changed
    TorqueLost,    ///< a servo had no torque any more (a restart, another program), and is left so
    ServoReplaced, ///< another servo answers under the ID of one of them, and is left alone
};
QString sweepEndName(SweepEnd end);
std::optional<SweepEnd> sweepEndFromName(const QString& name);

/// A gap without replies, after which the test continued.
struct SweepGap {
    base::Duration at{};
    base::Duration span{};
    bool operator==(const SweepGap&) const = default;
};

struct SweepErrors {
    std::uint64_t asked = 0; ///< readings and writes
    std::uint64_t timeouts = 0;
    std::uint64_t badChecksums = 0;
    std::uint64_t foreign = 0;
    std::uint64_t late = 0;
    bool operator==(const SweepErrors&) const = default;
};

struct SweepServo {
    snapshot::Snapshot parameters; ///< identity and memory table at the start
    SweepAxis axis;
    SweepLimits limits; ///< as they were then
    std::vector<SweepLeg> legs{};
    std::vector<SweepMetric> metrics{};
    std::vector<VerdictLine> lines{};
    SweepErrors errors{};
    Grade verdict =
        Grade::NotMeasured; ///< by sweep_verdict.h, which also gives the reason for none
    bool operator==(const SweepServo&) const = default;
};

struct SweepRun {
    QString program{}; ///< "ServoDesk 0.1.0"
    QDateTime at{};    ///< start, UTC
    QString port{};
    int baud = 0;
    bool simulated = false;
    SweepSpec spec{};
    base::Duration length{};
    SweepEnd end = SweepEnd::Finished;
    int endedBy = -1; ///< ID of the servo that ended it, -1: none
    std::vector<SweepGap> gaps{};
    double sampleRate = 0; ///< readings a second of one servo, achieved
    std::vector<SweepServo> servos{};
    bool operator==(const SweepRun&) const = default;

    Grade verdict() const; ///< the worst of the servos'; an early end is never a pass
};
} // namespace results
