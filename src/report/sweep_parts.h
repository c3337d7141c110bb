// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a sweep test's report as markup, the same for HTML and PDF, which only embed charts
// differently. Pure; any thread.
#pragma once

#include "report/report_file.h"
#include "report/svg_chart.h"
#include "results/sweep_run.h"

namespace report {
/// The readings of one servo for its chart; a few thousand are enough.
struct SweepSeries {
    int servo = -1;
    std::vector<ChartSample> samples{};
};

QString sweepBody(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const std::vector<SweepSeries>& series, const EmbedChart& place);

/// The title, the verdict, and all servos with theirs and the reasons.
QString verdictPart(const HtmlWriter& htmlWriter, const results::SweepRun& run);
QString benchPart(const HtmlWriter& htmlWriter, const results::SweepRun& run);
QString testPart(const HtmlWriter& htmlWriter, const results::SweepRun& run);
QString busPart(const HtmlWriter& htmlWriter, const results::SweepRun& run);

// in sweep_parts_servo.cpp
QString servoPart(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const results::SweepServo& servo, const std::vector<SweepSeries>& series,
                  const EmbedChart& place);
/// Heading, verdict and its reasons, setup, all metrics with their limits.
QString servoFigures(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                     const results::SweepServo& servo);
/// With headings; a sentence where there is nothing to draw.
QString positionPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
                     const std::vector<SweepSeries>& series, const EmbedChart& place);
QString errorsPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
                   const EmbedChart& place);
/// Which limits were not met, or why there is no verdict; empty for a servo that passed.
QString reasonsOf(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const results::SweepServo& servo);
/// The histogram of the steady-state errors as SVG; a paragraph where none was measured.
QString errorsChart(const HtmlWriter& htmlWriter, const results::SweepServo& servo);
QString badge(const HtmlWriter& htmlWriter, results::Grade grade);
QString lineBadge(const HtmlWriter& htmlWriter, results::Grade grade); ///< of one metric
QString inSeconds(base::Duration span);                                ///< as set: "1.5"

// in sweep_parts_legs.cpp
/// The legs that a page lists, in their order. Of more than `all`: the first and the last 50, and
/// the 20 worst of the others (missed, then alarms, then the largest steady-state error).
std::vector<const results::SweepLeg*> legsToShow(const std::vector<results::SweepLeg>& legs,
                                                 std::size_t all = 200);
/// The worst ones, in their order.
std::vector<const results::SweepLeg*> worstLegs(const std::vector<results::SweepLeg>& legs,
                                                std::size_t count);
QString legsPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo);
/// For paper: fewer legs, without the columns that hardly differ between them.
QString worstLegsPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
                      std::size_t count);
} // namespace report
