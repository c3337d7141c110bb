// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svg_chart.h"

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

struct Axis {
    double low = 0;
    double high = 1;
    double step = 1;
    double begin = 0; ///< in the picture
    double end = 1;
    double at(double value) const { return begin + (value - low) / (high - low) * (end - begin); }
};

/// 1, 2 or 5 times a power of ten.
double niceStep(double rough)
{
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double times = rough / power;
    return power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
}

Axis axisOver(double low, double high, double begin, double end, int ticks)
{
    if (!(high - low > 1e-9 * std::max({1.0, std::abs(low), std::abs(high)}))) {
        low -= 0.5;
        high += 0.5;
    }
    return {low, high, niceStep((high - low) / ticks), begin, end};
}

QString number(double value)
{
    return QString::number(value, 'f', 1);
}

QString line(double x1, double y1, double x2, double y2, const char* style)
{
    return QStringLiteral("<line x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\" %5/>\n")
        .arg(number(x1), number(y1), number(x2), number(y2), QString::fromLatin1(style));
}

QString text(double x, double y, const char* anchor, const QString& content,
             const QString& more = {})
{
    return QStringLiteral("<text x=\"%1\" y=\"%2\" text-anchor=\"%3\" font-size=\"12\" "
                          "fill=\"#1f2328\"%5>%4</text>\n")
        .arg(number(x), number(y), QString::fromLatin1(anchor), content, more);
}

QString frame(const HtmlWriter& htmlWriter, const Axis& x, const Axis& y, const Text& xTitle,
              const Text& yTitle)
{
    constexpr auto grid = "stroke=\"#d0d7de\" stroke-width=\"1\"";
    QString marks;
    for (double at = std::ceil(x.low / x.step) * x.step; at <= x.high + x.step / 1e6; at += x.step)
        marks += line(x.at(at), top, x.at(at), bottom, grid) +
                 text(x.at(at), bottom + 16, "middle", figure(at));
    for (double at = std::ceil(y.low / y.step) * y.step; at <= y.high + y.step / 1e6; at += y.step)
        marks += line(left, y.at(at), right, y.at(at), grid) +
                 text(left - 6, y.at(at) + 4, "end", figure(at));
    return marks +
           QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" fill=\"none\" "
                          "stroke=\"#57606a\" stroke-width=\"1\"/>\n")
               .arg(number(left), number(top), number(right - left), number(bottom - top)) +
           text((left + right) / 2, chartHeight - 10, "middle", htmlWriter.htmlInSvg(xTitle)) +
           text(left, top - 12, "start", htmlWriter.htmlInSvg(yTitle));
}

QString picture(const HtmlWriter& htmlWriter, const Text& title, const QString& content)
{
    return QStringLiteral(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
               "aria-label=\"%1\" width=\"%2\" height=\"%3\" viewBox=\"0 0 %2 %3\">\n"
               "<rect x=\"0\" y=\"0\" width=\"%2\" height=\"%3\" fill=\"#ffffff\"/>\n%4</svg>\n")
        .arg(htmlWriter.attributeText(title))
        .arg(chartWidth)
        .arg(chartHeight)
        .arg(content);
}

QString path(const QString& points, const char* style)
{
    if (points.isEmpty())
        return {};
    return QStringLiteral("<path d=\"%1\" fill=\"none\" %2/>\n")
        .arg(points, QString::fromLatin1(style));
}

/// The goal stays until it changes; the position goes straight from reading to reading.
QString curve(const std::vector<ChartSample>& samples, double ChartSample::*member, bool stairs,
              const Axis& x, const Axis& y)
{
    QString points;
    bool drawing = false;
    for (const ChartSample& sample : samples) {
        if (!std::isfinite(sample.*member)) {
            drawing = false;
            continue;
        }
        const QString across = number(x.at(sample.t));
        const QString up = number(y.at(sample.*member));
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
    return line(right - 190, top - 16, right - 160, top - 16,
                "stroke=\"#0b57d0\" stroke-width=\"1.5\"") +
           text(right - 154, top - 12, "start", htmlWriter.htmlInSvg(words.position)) +
           line(right - 85, top - 16, right - 55, top - 16,
                "stroke=\"#b3261e\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"") +
           text(right - 49, top - 12, "start", htmlWriter.htmlInSvg(words.goal));
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
    // A bar stands around its value, so that 0 is the middle of one.
    bars.first = (std::floor(*low / bars.width + 0.5) - 0.5) * bars.width;
    bars.counts.resize(std::size_t(
        std::clamp(std::floor((*high - bars.first) / bars.width) + 1, 1.0, double(maxBars))));
    for (const double error : errors) {
        const auto place = std::size_t(std::max(0.0, (error - bars.first) / bars.width));
        ++bars.counts[std::min(place, bars.counts.size() - 1)];
    }
    return bars;
}

/// With what it is, `place` from the right, above the frame.
QString limitLines(const HtmlWriter& htmlWriter, const Axis& x, std::optional<double> limit,
                   const Text& name, double place, const char* style)
{
    if (!limit)
        return {};
    const QString number = QStringLiteral(" > ") + figure(*limit);
    QString lines = line(right - place, top - 16, right - place + 30, top - 16, style) +
                    text(right - place + 36, top - 12, "start",
                         htmlWriter.htmlInSvg({name.en + number, name.zh + number}));
    for (const double side : {-1.0, 1.0}) {
        const double at = side * *limit;
        if (at >= x.low && at <= x.high)
            lines += line(x.at(at), top, x.at(at), bottom, style);
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
        // Comparing with NaN has no order; a gap stays where a stretch has nothing else.
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
    const Axis x = axisOver(shown.front().t, shown.back().t, left, right, 10);
    const Axis y = axisOver(low - margin, high + margin, bottom, top, 6);
    return picture(htmlWriter, words.positionChart,
                   frame(htmlWriter, x, y, words.timeAxis, words.positionAxis) +
                       path(curve(shown, &ChartSample::goal, true, x, y),
                            "stroke=\"#b3261e\" stroke-width=\"1.2\" stroke-dasharray=\"5 3\"") +
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
    // Room for 0, and for the warning if it is not far away.
    const double room = std::max({warn.value_or(0) * 1.1, -bars.first, end});
    const Axis x = axisOver(-room, room, left, right, 12);
    Axis y = axisOver(0, maxCount * 1.08, bottom, top, 5);
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
                       .arg(number(from), number(bottom - height), number(std::max(1.0, to - from)),
                            number(height));
    }
    content += line(x.at(0), top, x.at(0), bottom, "stroke=\"#1f2328\" stroke-width=\"1\"") +
               limitLines(htmlWriter, x, warn, words.warnLimit, 250,
                          "stroke=\"#8a5a00\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"") +
               limitLines(htmlWriter, x, fail, words.failLimit, 120,
                          "stroke=\"#b3261e\" stroke-width=\"1.5\" stroke-dasharray=\"2 2\"");
    return picture(htmlWriter, words.histogram, content);
}
} // namespace report
