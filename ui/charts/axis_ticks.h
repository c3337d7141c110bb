// SPDX-License-Identifier: GPL-3.0-or-later
// The ticks of an axis and their labels: round numbers, and times as people read them. Pure
// functions. Times are seconds; a step is never 0.
#pragma once

#include <QString>

#include <vector>

namespace ui {
struct AxisRange {
    double low = 0;
    double high = 1;
    bool operator==(const AxisRange&) const = default;
    double size() const { return high - low; }
};

/// The smallest round step that divides `span` into at most `most` parts. Angles like 15, 30, 45.
double valueStep(double span, int maxParts, const QString& unit);
/// As above, on the clock: 10 ms, 1 s, 15 s, 5 min, 2 h …
double timeStep(double seconds, int maxParts);
/// The multiples of `step` within the range; a hundred at most.
std::vector<double> ticks(const AxisRange& range, double step);

/// "-250 ms", "-7.5 s", "1:30", "1:02:30.25": the shape follows what else is on the axis.
QString timeText(double seconds, const AxisRange& axis, double step);
/// With as many decimals as the step has.
QString valueText(double value, double step);
/// The step in which live readings of this unit are shown: 0.1 °, 1 mA.
double displayStep(const QString& unit);
/// A reading, to about one part in ten thousand of `range`, at most nine decimals.
QString readingText(double value, double range);
/// "2.500 s", "12.3 ms", "1:02:30.250"
QString spanText(double seconds);

/// The values with a twentieth of their span above and below, but not across zero on a side where
/// no value is. At least as tall as makes sense for the unit: noise of one step stays small.
AxisRange paddedRange(double min, double max, const QString& unit);
/// Made taller until this share of its height, 0 … 1, is below zero. Zero must be inside.
AxisRange stretchedRange(const AxisRange& range, double shareBelowZero);
} // namespace ui
