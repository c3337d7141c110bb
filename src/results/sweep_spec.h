// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a sweep test, and what they mean for one servo. Values, kept in the report;
// any thread. Texts are as the user typed them ("1024", "90deg", "1500", "30rpm"): a number without
// a unit counts as the register does, so that servos of several families can share one test.
#pragma once

#include "base/clock.h"

#include <QString>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace results {
enum class SweepShape : std::uint8_t {
    Sweep,     ///< start, end, start …
    Stairs,    ///< start to end and back by `step`
    BothSides, ///< start, middle, end, middle …: the middle is approached from both sides
    Random,    ///< targets between start and end, the same ones for the same seed
    Sine,      ///< goals follow a sine between start and end; a leg is half a period
    Points,    ///< a list of the user's
};

enum class SweepPace : std::uint8_t {
    Delay, ///< from one goal to the next, arrived or not (FD: 延时)
    Dwell, ///< after arrival; a target that is not reached in time is missed
};

QString sweepShapeName(SweepShape shape); ///< "sweep", "stairs", "both-sides" …
std::optional<SweepShape> sweepShapeFromName(const QString& name);
QString sweepPaceName(SweepPace pace); ///< "delay", "dwell"
std::optional<SweepPace> sweepPaceFromName(const QString& name);

struct SweepPoint {
    QString target;
    std::optional<base::Duration> pause{}; ///< else the test's
    bool operator==(const SweepPoint&) const = default;
};

struct SweepRange {
    QString from;
    QString to;
    bool operator==(const SweepRange&) const = default;
};

/// A cycle is there and back: two legs of a sweep, all stairs up and down, the whole list once. The
/// approach to the first target is no leg.
struct SweepSpec {
    SweepShape shape = SweepShape::Sweep;
    SweepRange range{};
    std::map<int, SweepRange> ranges{}; ///< of servos (by ID) that have one of their own
    QString step{};                     ///< Stairs
    std::vector<SweepPoint> points{};   ///< Points
    std::uint32_t seed = 1;             ///< Random
    base::Duration period{};            ///< Sine
    SweepPace pace = SweepPace::Delay;
    base::Duration pause{};  ///< the delay or the dwell
    int cycles = 1;          ///< 0: limited by `length`
    base::Duration length{}; ///< 0: limited by `cycles`; with both, the first limit ends the test
    QString speed{};         ///< empty: as the servo has it
    QString acceleration{};
    QString time{};          ///< ms; families that move by time
    base::Duration warmUp{}; ///< time of cycles before, which are not measured
    bool releaseAtEnd = false;
    bool stopOnAlarm = true; ///< includes over-temperature and stall as reported by the servo
    bool stopOnStall = true; ///< stands still away from its target
    bool stopOnFailure = false;
    QString operatorName{};
    QString note{};
    bool operator==(const SweepSpec&) const = default;
};

/// The test in one servo's terms. Steps are those of its position feedback.
struct SweepAxis {
    double from = 0;
    double to = 0;
    double step = 0;              ///< Stairs
    std::vector<double> points{}; ///< Points
    double stepsPerTurn = 4096;
    double tolerance = 0;                 ///< so near a target it has arrived, steps
    std::optional<double> speed{};        ///< commanded speed in steps/s; none: not limited
    std::optional<double> acceleration{}; ///< steps/s²; none: at once
    bool operator==(const SweepAxis&) const = default;
};
} // namespace results
