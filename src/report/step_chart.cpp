// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/bilingual.h"
#include "report/step_report.h"
#include "report/svg_elements.h"
#include "results/sweep_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace report {
using catalog::Text;

namespace {
constexpr double width = 760;
constexpr double height = 340;
constexpr double plotLeft = 64;
constexpr double plotRight = width - 14;
constexpr double plotTop = 34;
constexpr double plotBottom = height - 46;
constexpr double headroom = 0.12; ///< above the target and below the start
constexpr int maxTicks = 8;
constexpr double minPointDistance = 0.4; ///< between two points of a curve

/// Dark enough for white paper.
constexpr std::array colors{"#0b57d0", "#b3261e", "#1a7f37", "#8a5a00"};

double progressTo(const results::StepResponse& response, double position)
{
    return response.target < response.start ? response.start - position : position - response.start;
}

/// Both scales, wide enough for everything.
std::pair<ChartAxis, ChartAxis> scalesOf(const std::vector<results::StepRun>& runs)
{
    ChartAxis x{0, 1, 1, plotLeft, plotRight};
    ChartAxis y{0, 1, 1, plotBottom, plotTop};
    for (const results::StepRun& run : runs) {
        for (const results::StepResponse& response : run.responses) {
            y.high = std::max(y.high, std::abs(response.target - response.start));
            for (const results::StepSample& sample : response.samples) {
                x.high = std::max(x.high, *results::inMs(sample.at));
                y.high = std::max(y.high, progressTo(response, sample.position));
                y.low = std::min(y.low, progressTo(response, sample.position));
            }
        }
    }
    const double margin = headroom * (y.high - y.low);
    y.low -= margin;
    y.high += margin;
    for (ChartAxis* axis : {&x, &y})
        axis->step = niceStep(std::max(1e-6, (axis->high - axis->low) / maxTicks));
    return {x, y};
}

QString curve(const results::StepResponse& response, const ChartAxis& x, const ChartAxis& y,
              const char* color)
{
    QString points;
    double drawn = -1;
    for (const results::StepSample& sample : response.samples) {
        const double across = x.at(*results::inMs(sample.at));
        if (!points.isEmpty() && across - drawn < minPointDistance)
            continue;
        points += (points.isEmpty() ? u'M' : u'L') + svgNumber(across) + u' ' +
                  svgNumber(y.at(progressTo(response, sample.position)));
        drawn = across;
    }
    if (points.isEmpty())
        return {};
    return QStringLiteral("<path d=\"%1\" fill=\"none\" stroke=\"%2\" stroke-width=\"1.2\" "
                          "stroke-opacity=\"0.8\"/>\n")
        .arg(points, QString::fromLatin1(color));
}

QString frame(const HtmlWriter& htmlWriter, const ChartAxis& x, const ChartAxis& y)
{
    constexpr auto grid = "stroke=\"#d0d7de\" stroke-width=\"1\"";
    QString marks;
    for (double at = 0; at <= x.high; at += x.step)
        marks += svgLine(x.at(at), plotTop, x.at(at), plotBottom, grid) +
                 svgText(x.at(at), plotBottom + 16, "middle", exactNumber(at));
    for (double at = std::ceil(y.low / y.step) * y.step; at <= y.high; at += y.step)
        marks += svgLine(plotLeft, y.at(at), plotRight, y.at(at), grid) +
                 svgText(plotLeft - 6, y.at(at) + 4, "end", exactNumber(at));
    return marks +
           svgText((plotLeft + plotRight) / 2, height - 10, "middle",
                   htmlWriter.htmlInSvg(translate("StepText", "Time since goal was sent, ms"))) +
           svgText(plotLeft, plotTop - 14, "start",
                   htmlWriter.htmlInSvg(translate("StepText", "Movement toward goal, steps")));
}

QString legend(std::size_t runs)
{
    QString entries;
    constexpr double entry = 60;
    for (std::size_t i = 0; i < runs; ++i) {
        const double x = plotRight - entry * double(runs - i);
        entries +=
            svgLine(x, plotTop - 18, x + 26, plotTop - 18,
                    QByteArray("stroke=\"") + colors[i % colors.size()] + "\" stroke-width=\"2\"") +
            svgText(x + 32, plotTop - 14, "start", QString::number(i + 1));
    }
    return entries;
}
} // namespace

QString stepChart(const HtmlWriter& htmlWriter, const std::vector<results::StepRun>& runs)
{
    const auto [x, y] = scalesOf(runs);
    QString content = frame(htmlWriter, x, y);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (const results::StepResponse& response : runs[i].responses)
            content += curve(response, x, y, colors[i % colors.size()]);
    }
    if (!runs.empty() && !runs.front().responses.empty()) {
        const results::StepResponse& first = runs.front().responses.front();
        const double target = y.at(std::abs(first.target - first.start));
        content += svgLine(plotLeft, target, plotRight, target,
                           "stroke=\"#57606a\" stroke-width=\"1\" stroke-dasharray=\"5 3\"");
    }
    return svgChart(htmlWriter, translate("StepText", "Step responses"), width, height,
                    content + legend(runs.size()));
}
} // namespace report
