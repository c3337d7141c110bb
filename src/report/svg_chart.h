// SPDX-License-Identifier: GPL-3.0-or-later
// Charts of a report as SVG, for an HTML page or for QSvgRenderer. Lines are decimated to what the
// width can show; extremes are kept. Pure; any thread.
#pragma once

#include "report/html_page.h"

#include <vector>

namespace report {
/// One reading; no position or no goal (NaN) is a gap of that curve.
struct ChartSample {
    double t = 0; ///< s
    double position = 0;
    double goal = 0;
};

/// At most `maxCount`: the lowest and the highest sample of each section, in their order.
std::vector<ChartSample> decimated(const std::vector<ChartSample>& samples, std::size_t maxCount);

constexpr int chartWidth = 760;
constexpr int chartHeight = 280;

QString positionChart(const HtmlWriter& htmlWriter, const std::vector<ChartSample>& samples);

/// Limits are drawn on both sides of 0. `errors` must not be empty.
QString errorHistogram(const HtmlWriter& htmlWriter, const std::vector<double>& errors,
                       std::optional<double> warn, std::optional<double> fail);
} // namespace report
