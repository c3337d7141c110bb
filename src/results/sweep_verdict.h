// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on a servo of a sweep test, from how the run ended and what was measured. The only
// place that decides it: for a run that has just ended, for a run from a file or the history, and
// for lists. Pure; any thread.
//   Fail         a limit was failed, or the servo ended the run (alarm, stall, its first failure);
//                errors on the wire of a run that ended early are not the servo's
//   NotMeasured  no verdict, for one of the reasons below
//   Pass, Warn   the run finished, and the figures that evaluate its path were measured
#pragma once

#include "results/sweep_run.h"

namespace results {
/// Why a servo has no verdict.
enum class NoVerdictReason : std::uint8_t {
    None,           ///< it has one
    Ended,          ///< the run did not finish
    TooShort,       ///< sine, random: less than one whole cycle
    TooFewReadings, ///< sine: fewer than minReadingsPerPeriod
    TooFast,        ///< sine: faster than the servo is set to turn
    NoLimit,        ///< sine, random: no limit for following or reaching goals
    ShortMoves,     ///< paths with targets: most moves are no longer than a servo that stands still
                    ///< needs to be within tolerance, see provesArrival()
    SlowLink,    ///< sine: too far behind, but only in legs with fewer than minReadingsToFailSine
    NotMeasured, ///< the figures that evaluate the path are missing in most of its legs
};
QString noVerdictReasonName(NoVerdictReason reason); ///< "ended", "too-short" …; None: empty

struct SweepVerdict {
    Grade grade = Grade::NotMeasured;
    NoVerdictReason reason = NoVerdictReason::None;
};

/// With fewer readings the following error of a sine cannot be judged.
inline constexpr int minReadingsPerPeriod = 20;
/// With fewer in a leg (half a period), what a sine shows the servo to be behind by there may be
/// the delay of the link: that it is too much is not known then.
inline constexpr int minReadingsToFailSine = 40;

/// A shorter move proves nothing: a servo that stands still between its ends is within tolerance of
/// both. Tolerances, from where the servo stood.
inline constexpr double minMoveTolerances = 2;
/// Of moves between two targets, which it may stand beside by one tolerance.
inline constexpr double minPlannedTolerances = minMoveTolerances + 1;
bool isLongEnough(const SweepLeg& leg, double tolerance);
/// It reached its target by a move that was long enough, or was seen to miss it.
bool provesArrival(const SweepLeg& leg, double tolerance);

SweepVerdict sweepVerdict(const SweepRun& run, const SweepServo& servo);
/// SweepServo::verdict of all servos.
void assignVerdicts(SweepRun& run);
/// For lists, which have no figures: `grade` is what was stored; `isResponsible`: this servo ended
/// it.
Grade gradeAfter(SweepEnd end, Grade grade, bool isResponsible);
/// An alarm, a stall or a failed limit: one servo caused the end.
bool isServoFault(SweepEnd end);
/// Only a finished run can be a reference for others.
bool canBeReference(SweepEnd end);

/// A line a limit that applies to the path: Fail before Warn; exactly on the limit is still good; a
/// limit without `fail` only warns. What was not measured is NotMeasured; a value that is not a
/// number fails. How far behind a sine is fails only by a leg with minReadingsToFailSine, else that
/// line is NotMeasured with its value. `metrics` are those of servo.legs, `servo.limits` the
/// limits.
std::vector<VerdictLine> evaluate(const SweepServo& servo, const std::vector<SweepMetric>& metrics,
                                  SweepShape shape);
/// Fail before Warn before Pass; NotMeasured when no line was measured.
Grade worstGrade(const std::vector<VerdictLine>& lines);

/// What the following error is relative to, in steps: half the range of a sine (its amplitude),
/// the range of random targets; nullopt: other paths.
std::optional<double> followingScale(SweepShape shape, const SweepAxis& axis);
/// At its midpoint the sine is faster than the commanded speed.
bool isSineTooFast(const SweepSpec& spec, const SweepAxis& axis);
} // namespace results
