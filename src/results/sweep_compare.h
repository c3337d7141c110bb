// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep tests of two servos side by side: A is the reference, B is compared with it. Figures and
// the differences of the tests and of the servos' settings, so that incomparable runs are not
// compared. Pure values; any thread; never fails. Words are in report/sweep_compare_text.h.
#pragma once

#include "results/sweep_run.h"

namespace results {
struct SweepSide {
    QString name; ///< number in the history, or file
    const SweepRun& run;
    const SweepServo& servo; ///< of this run
};

enum class Better : std::uint8_t { Neither, A, B };

/// One figure of SweepServo::metrics.
struct FigureDifference {
    QString key;
    QString unit;
    std::optional<double> a{};
    std::optional<double> b{};
    std::optional<double> difference{}; ///< b − a, where both were measured
    Better better = Better::Neither;
    std::optional<Grade> gradeA{}; ///< none: the limits have no line for it
    std::optional<Grade> gradeB{};
    bool operator==(const FigureDifference&) const = default;
};

enum class TestItem : std::uint8_t {
    Model,
    Firmware,
    Resolution,
    Simulated,
    Shape,
    Range,
    Step,
    Points,
    Seed,
    Period,
    Pace,
    Pause,
    Speed,
    Acceleration,
    MoveTime,
    WarmUp,
    Tolerance,
    Cycles,
    SampleRate, ///< half as much again, or more
    Limits,
    End,
};

/// The effect of a difference of the tests on the comparison.
enum class DifferenceImpact : std::uint8_t {
    Path,   ///< the servos did different things: figures cannot be compared
    Figure, ///< some figures depend on it
    Grade,  ///< figures can be compared, grades cannot
};

/// a and b: numbers as text, or technical names ("both-sides", "stopped", "true").
struct TestDifference {
    TestItem item = TestItem::Model;
    DifferenceImpact weight = DifferenceImpact::Path;
    QString a;
    QString b;
    bool operator==(const TestDifference&) const = default;
};

/// A setting that is not the same; nullopt: not read, or the other map has no such register.
struct SettingDifference {
    QString key;
    std::optional<std::int64_t> rawA{};
    std::optional<std::int64_t> rawB{};
    std::optional<double> a{};
    std::optional<double> b{};
    QString unit{};
    bool operator==(const SettingDifference&) const = default;
};

struct SweepComparison {
    std::vector<FigureDifference> figures{}; ///< every metric, in the order of a report
    std::vector<TestDifference> tests{};
    std::vector<SettingDifference> settings{}; ///< in the order of A, then what only B has
    bool comparable() const;                   ///< no difference of Weight::Path
    bool operator==(const SweepComparison&) const = default;
};

SweepComparison compareSweeps(const SweepSide& a, const SweepSide& b);

/// Null: the run has no such servo.
const SweepServo* servoOf(const SweepRun& run, int id);

QString testItemName(TestItem item);         ///< "sample-rate", for JSON
QString weightName(DifferenceImpact weight); ///< "path", "figure", "grade"
} // namespace results
