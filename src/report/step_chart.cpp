// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/step_html.h"
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
constexpr int ticks = 8;
constexpr double minPointDistance = 0.4; ///< px between two points of a curve

/// Dark enough for white paper.
constexpr std::array colors{"#0b57d0", "#b3261e", "#1a7f37", "#8a5a00"};

struct Scale {
    double low = 0;
    double high = 1;
    double begin = 0;
    double end = 1;
    double at(double value) const { return begin + (value - low) / (high - low) * (end - begin); }
    /// 1, 2 or 5 times a power of ten.
    double step() const
    {
        const double rough = std::max(1e-6, (high - low) / ticks);
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        const double times = rough / power;
        return power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
    }
};

double progressTo(const record::StepResponse& response, double position)
{
    return response.target < response.start ? response.start - position : position - response.start;
}

QString px(double value)
{
    return QString::number(value, 'f', 1);
}

QString line(double x1, double y1, double x2, double y2, const QString& style)
{
    return QStringLiteral("<line x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\" %5/>\n")
        .arg(px(x1), px(y1), px(x2), px(y2), style);
}

QString label(double x, double y, const char* anchor, const QString& content)
{
    return QStringLiteral("<text x=\"%1\" y=\"%2\" text-anchor=\"%3\" font-size=\"12\" "
                          "fill=\"#1f2328\">%4</text>\n")
        .arg(px(x), px(y), QString::fromLatin1(anchor), content);
}

/// Both scales, wide enough for everything.
std::pair<Scale, Scale> scalesOf(const std::vector<record::StepRun>& runs)
{
    Scale x{0, 1, plotLeft, plotRight};
    Scale y{0, 1, plotBottom, plotTop};
    for (const record::StepRun& run : runs) {
        for (const record::StepResponse& response : run.responses) {
            y.high = std::max(y.high, std::abs(response.target - response.start));
            for (const record::StepSample& sample : response.samples) {
                x.high = std::max(x.high, *record::inMs(sample.at));
                y.high = std::max(y.high, progressTo(response, sample.position));
                y.low = std::min(y.low, progressTo(response, sample.position));
            }
        }
    }
    const double margin = headroom * (y.high - y.low);
    y.low -= margin;
    y.high += margin;
    return {x, y};
}

QString curve(const record::StepResponse& response, const Scale& x, const Scale& y,
              const char* color)
{
    QString points;
    double drawn = -1;
    for (const record::StepSample& sample : response.samples) {
        const double across = x.at(*record::inMs(sample.at));
        if (!points.isEmpty() && across - drawn < minPointDistance)
            continue;
        points += (points.isEmpty() ? u'M' : u'L') + px(across) + u' ' +
                  px(y.at(progressTo(response, sample.position)));
        drawn = across;
    }
    if (points.isEmpty())
        return {};
    return QStringLiteral("<path d=\"%1\" fill=\"none\" stroke=\"%2\" stroke-width=\"1.2\" "
                          "stroke-opacity=\"0.8\"/>\n")
        .arg(points, QString::fromLatin1(color));
}

QString frame(const HtmlWriter& htmlWriter, const Scale& x, const Scale& y)
{
    const QString grid = QStringLiteral("stroke=\"#d0d7de\" stroke-width=\"1\"");
    QString marks;
    for (double at = 0; at <= x.high; at += x.step())
        marks += line(x.at(at), plotTop, x.at(at), plotBottom, grid) +
                 label(x.at(at), plotBottom + 16, "middle", figure(at));
    for (double at = std::ceil(y.low / y.step()) * y.step(); at <= y.high; at += y.step())
        marks += line(plotLeft, y.at(at), plotRight, y.at(at), grid) +
                 label(plotLeft - 6, y.at(at) + 4, "end", figure(at));
    return marks +
           label((plotLeft + plotRight) / 2, height - 10, "middle",
                 htmlWriter.htmlInSvg({QStringLiteral("ms from the goal on"),
                                       QString::fromUtf8("发出目标后的时间 (ms)")})) +
           label(plotLeft, plotTop - 14, "start",
                 htmlWriter.htmlInSvg({QStringLiteral("steps towards the target"),
                                       QString::fromUtf8("朝目标方向的步数")}));
}

QString legend(std::size_t runs)
{
    QString entries;
    constexpr double entry = 60;
    for (std::size_t i = 0; i < runs; ++i) {
        const double x = plotRight - entry * double(runs - i);
        entries += line(x, plotTop - 18, x + 26, plotTop - 18,
                        QStringLiteral("stroke=\"%1\" stroke-width=\"2\"")
                            .arg(QString::fromLatin1(colors[i % colors.size()]))) +
                   label(x + 32, plotTop - 14, "start", QString::number(i + 1));
    }
    return entries;
}
} // namespace

QString stepChart(const HtmlWriter& htmlWriter, const std::vector<record::StepRun>& runs)
{
    const auto [x, y] = scalesOf(runs);
    QString content = frame(htmlWriter, x, y);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (const record::StepResponse& response : runs[i].responses)
            content += curve(response, x, y, colors[i % colors.size()]);
    }
    if (!runs.empty() && !runs.front().responses.empty()) {
        const record::StepResponse& first = runs.front().responses.front();
        const double target = y.at(std::abs(first.target - first.start));
        content += line(plotLeft, target, plotRight, target,
                        QStringLiteral("stroke=\"#57606a\" stroke-width=\"1\" "
                                       "stroke-dasharray=\"5 3\""));
    }
    return QStringLiteral(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
               "aria-label=\"%1\" width=\"%2\" height=\"%3\" viewBox=\"0 0 %2 %3\">\n"
               "<rect x=\"0\" y=\"0\" width=\"%2\" height=\"%3\" fill=\"#ffffff\"/>\n%4</svg>\n")
        .arg(htmlWriter.attributeText(
            {QStringLiteral("Step responses"), QString::fromUtf8("阶跃响应")}))
        .arg(width)
        .arg(height)
        .arg(content + legend(runs.size()));
}
} // namespace report
