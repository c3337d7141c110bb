// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svg_chart.h"

#include "report/svg_elements.h"
#include "report/sweep_text.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {
constexpr double left = 64;
constexpr double right = chartWidth - 14;
constexpr double top = 30;
constexpr double bottom = chartHeight - 46;
constexpr std::size_t maxPoints = 2000;
constexpr int maxBars = 400;

ChartAxis axisOver(double low, double high, double begin, double end, int ticks)
{
    if (!(high - low > 1e-9 * std::max({1.0, std::abs(low), std::abs(high)}))) {
        low -= 0.5;
        high += 0.5;
    }
    return {low, high, niceStep((high - low) / ticks), begin, end};
}

QString frame(const HtmlWriter& htmlWriter, const ChartAxis& x, const ChartAxis& y,
              const Text& xTitle, const Text& yTitle)
{
    constexpr auto grid = "stroke=\"#d0d7de\" stroke-width=\"1\"";
    QString marks;
    for (double at = std::ceil(x.low / x.step) * x.step; at <= x.high + x.step / 1e6; at += x.step)
        marks += svgLine(x.at(at), top, x.at(at), bottom, grid) +
                 svgText(x.at(at), bottom + 16, "middle", exactNumber(at));
    for (double at = std::ceil(y.low / y.step) * y.step; at <= y.high + y.step / 1e6; at += y.step)
        marks += svgLine(left, y.at(at), right, y.at(at), grid) +
                 svgText(left - 6, y.at(at) + 4, "end", exactNumber(at));
    return marks +
           QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" fill=\"none\" "
                          "stroke=\"#57606a\" stroke-width=\"1\"/>\n")
               .arg(svgNumber(left), svgNumber(top), svgNumber(right - left),
                    svgNumber(bottom - top)) +
           svgText((left + right) / 2, chartHeight - 10, "middle", htmlWriter.htmlInSvg(xTitle)) +
           svgText(left, top - 12, "start", htmlWriter.htmlInSvg(yTitle));
}

QString path(const QString& points, const char* style)
{
    if (points.isEmpty())
        return {};
    return QStringLiteral("<path d=\"%1\" fill=\"none\" %2/>\n")
        .arg(points, QString::fromLatin1(style));
}

/// `stairs`: the value stays until it changes (the goal), instead of a straight line (the
/// position).
QString curve(const std::vector<ChartSample>& samples, double ChartSample::*member, bool stairs,
              const ChartAxis& x, const ChartAxis& y)
{
    QString points;
    bool drawing = false;
    for (const ChartSample& sample : samples) {
        if (!std::isfinite(sample.*member)) {
            drawing = false;
            continue;
        }
        const QString across = svgNumber(x.at(sample.t));
        const QString up = svgNumber(y.at(sample.*member));
        if (!drawing)
            points += u'M' + across + u' ' + up;
        else
            points += stairs ? u'H' + across + u'V' + up : u'L' + across + u' ' + up;
        drawing = true;
    }
    return points;
}

QString legend(const HtmlWriter& htmlWriter)
{
    const SweepTexts& words = sweepTexts();
    return svgLine(right - 190, top - 16, right - 160, top - 16,
                   "stroke=\"#0b57d0\" stroke-width=\"1.5\"") +
           svgText(right - 154, top - 12, "start", htmlWriter.htmlInSvg(words.position)) +
           svgLine(right - 85, top - 16, right - 55, top - 16,
                   "stroke=\"#57606a\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"") +
           svgText(right - 49, top - 12, "start", htmlWriter.htmlInSvg(words.goal));
}

struct Bars {
    double first = 0; ///< left edge
    double width = 1;
    std::vector<int> counts;
};

Bars barsOf(const std::vector<double>& errors)
{
    const auto [low, high] = std::minmax_element(errors.begin(), errors.end());
    Bars bars;
    bars.width = std::max(0.1, niceStep(std::max(*high - *low, 1.0) / 20));
    // A bar is centered on its value, so one is centered on 0.
    bars.first = (std::floor(*low / bars.width + 0.5) - 0.5) * bars.width;
    bars.counts.resize(std::size_t(
        std::clamp(std::floor((*high - bars.first) / bars.width) + 1, 1.0, double(maxBars))));
    for (const double error : errors) {
        const auto place = std::size_t(std::max(0.0, (error - bars.first) / bars.width));
        ++bars.counts[std::min(place, bars.counts.size() - 1)];
    }
    return bars;
}

/// And their legend above the frame, `place` pixels from the right.
QString limitLines(const HtmlWriter& htmlWriter, const ChartAxis& x, std::optional<double> limit,
                   const Text& name, double place, const char* style)
{
    if (!limit)
        return {};
    const QString number = QStringLiteral(" > ") + exactNumber(*limit);
    QString lines = svgLine(right - place, top - 16, right - place + 30, top - 16, style) +
                    svgText(right - place + 36, top - 12, "start",
                            htmlWriter.htmlInSvg({name.en + number, name.zh + number}));
    for (const double side : {-1.0, 1.0}) {
        const double at = side * *limit;
        if (at >= x.low && at <= x.high)
            lines += svgLine(x.at(at), top, x.at(at), bottom, style);
    }
    return lines;
}
} // namespace

std::vector<ChartSample> decimated(const std::vector<ChartSample>& samples, std::size_t maxCount)
{
    if (samples.size() <= maxCount || maxCount < 2)
        return samples;
    const std::size_t buckets = maxCount / 2;
    std::vector<ChartSample> kept;
    kept.reserve(2 * buckets);
    for (std::size_t i = 0; i < buckets; ++i) {
        const auto begin = samples.begin() + std::ptrdiff_t(i * samples.size() / buckets);
        const auto end = samples.begin() + std::ptrdiff_t((i + 1) * samples.size() / buckets);
        // NaN has no order: it counts as the lowest, so a section without a position stays a gap.
        const auto lower = [](const ChartSample& a, const ChartSample& b) {
            const double low = -std::numeric_limits<double>::infinity();
            return (std::isnan(a.position) ? low : a.position) <
                   (std::isnan(b.position) ? low : b.position);
        };
        auto [low, high] = std::minmax_element(begin, end, lower);
        if (high < low)
            std::swap(low, high);
        kept.push_back(*low);
        if (high != low)
            kept.push_back(*high);
    }
    return kept;
}

QString positionChart(const HtmlWriter& htmlWriter, const std::vector<ChartSample>& samples)
{
    const SweepTexts& words = sweepTexts();
    const std::vector<ChartSample> shown = decimated(samples, maxPoints);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const ChartSample& sample : shown) {
        for (const double value : {sample.position, sample.goal}) {
            low = std::isfinite(value) ? std::min(low, value) : low;
            high = std::isfinite(value) ? std::max(high, value) : high;
        }
    }
    if (shown.empty() || low > high)
        return htmlWriter.paragraph(words.noSeries);
    const double margin = (high - low) * 0.05;
    const ChartAxis x = axisOver(shown.front().t, shown.back().t, left, right, 10);
    const ChartAxis y = axisOver(low - margin, high + margin, bottom, top, 6);
    return svgChart(htmlWriter, words.positionChart, chartWidth, chartHeight,
                    frame(htmlWriter, x, y, words.timeAxis, words.positionAxis) +
                        path(curve(shown, &ChartSample::goal, true, x, y),
                             "stroke=\"#57606a\" stroke-width=\"1.2\" stroke-dasharray=\"5 3\"") +
                        path(curve(shown, &ChartSample::position, false, x, y),
                             "stroke=\"#0b57d0\" stroke-width=\"1.5\" stroke-linejoin=\"round\"") +
                        legend(htmlWriter));
}

QString errorHistogram(const HtmlWriter& htmlWriter, const std::vector<double>& errors,
                       std::optional<double> warn, std::optional<double> fail)
{
    const SweepTexts& words = sweepTexts();
    const Bars bars = barsOf(errors);
    const double end = bars.first + bars.width * double(bars.counts.size());
    const int maxCount = *std::max_element(bars.counts.begin(), bars.counts.end());
    // Room for all errors and for the warning limit.
    const double room = std::max({warn.value_or(0) * 1.1, -bars.first, end});
    const ChartAxis x = axisOver(-room, room, left, right, 12);
    ChartAxis y = axisOver(0, maxCount * 1.08, bottom, top, 5);
    y.step = std::max(1.0, y.step);
    QString content = frame(htmlWriter, x, y, words.errorAxis, words.legsAxis);
    for (std::size_t i = 0; i < bars.counts.size(); ++i) {
        if (bars.counts[i] == 0)
            continue;
        const double from = x.at(bars.first + bars.width * double(i));
        const double to = x.at(bars.first + bars.width * double(i + 1));
        const double height = bottom - y.at(bars.counts[i]);
        content += QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" "
                                  "fill=\"#0b57d0\" stroke=\"#ffffff\" stroke-width=\"0.5\"/>\n")
                       .arg(svgNumber(from), svgNumber(bottom - height),
                            svgNumber(std::max(1.0, to - from)), svgNumber(height));
    }
    content += svgLine(x.at(0), top, x.at(0), bottom, "stroke=\"#1f2328\" stroke-width=\"1\"") +
               limitLines(htmlWriter, x, warn, words.warnLimit, 250,
                          "stroke=\"#8a5a00\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"") +
               limitLines(htmlWriter, x, fail, words.failLimit, 120,
                          "stroke=\"#b3261e\" stroke-width=\"1.5\" stroke-dasharray=\"2 2\"");
    return svgChart(htmlWriter, words.histogram, chartWidth, chartHeight, content);
}
} // namespace report
