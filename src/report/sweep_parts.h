// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a sweep test's report as markup, the same for page and paper; only how a chart gets
// into it differs. Pure; any thread.
#pragma once

#include "report/svg_chart.h"
#include "results/sweep_run.h"

#include <functional>

namespace report {
/// What was kept of one servo's readings for its chart; some thousands are enough.
struct SweepSeries {
    int servo = -1;
    std::vector<ChartSample> samples{};
};

/// Markup that shows this SVG.
using EmbedChart = std::function<QString(const QString& svg)>;

QString sweepBody(const HtmlWriter& htmlWriter, const record::SweepRun& run,
                  const std::vector<SweepSeries>& series, const EmbedChart& place);

/// All up to `all`; else the first and last 50 and the 20 worst of the others (missed, alarms, then
/// the largest steady error), in their order.
std::vector<const record::SweepLeg*> legsToShow(const std::vector<record::SweepLeg>& legs,
                                                std::size_t all = 200);

// of sweep_parts_servo.cpp
QString servoPart(const HtmlWriter& htmlWriter, const record::SweepRun& run,
                  const record::SweepServo& servo, const std::vector<SweepSeries>& series,
                  const EmbedChart& place);
QString badge(const HtmlWriter& htmlWriter, record::Grade grade);
QString lineBadge(const HtmlWriter& htmlWriter, record::Grade grade); ///< of one figure
QString inSeconds(base::Duration span);                               ///< "1.5"
} // namespace report
