// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a sweep test's report as markup, the same for HTML and PDF, which only embed charts
// differently. Pure; any thread.
#pragma once

#include "report/svg_chart.h"
#include "results/sweep_run.h"

#include <functional>

namespace report {
/// The readings of one servo for its chart; a few thousand are enough.
struct SweepSeries {
    int servo = -1;
    std::vector<ChartSample> samples{};
};

/// Markup that shows this SVG.
using EmbedChart = std::function<QString(const QString& svg)>;

QString sweepBody(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const std::vector<SweepSeries>& series, const EmbedChart& place);

/// The legs that the report lists, in their order. Of more than `all`: the first and the last 50,
/// and the 20 worst of the others (missed, then alarms, then the largest steady-state error).
std::vector<const results::SweepLeg*> legsToShow(const std::vector<results::SweepLeg>& legs,
                                                 std::size_t all = 200);

// in sweep_parts_servo.cpp
QString servoPart(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const results::SweepServo& servo, const std::vector<SweepSeries>& series,
                  const EmbedChart& place);
/// The histogram of the steady-state errors as SVG; a paragraph where none was measured.
QString errorsChart(const HtmlWriter& htmlWriter, const results::SweepServo& servo);
QString badge(const HtmlWriter& htmlWriter, results::Grade grade);
QString lineBadge(const HtmlWriter& htmlWriter, results::Grade grade); ///< of one figure
QString inSeconds(base::Duration span);                                ///< "1.5"
} // namespace report
