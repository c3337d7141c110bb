// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/axis_ticks.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {
constexpr double minute = 60;
constexpr double hour = 3600;
constexpr double tiny = 1e-9;

double decimalStep(double minStep)
{
    const double power = std::pow(10.0, std::floor(std::log10(minStep)));
    for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
        if (factor * power >= minStep * (1 - tiny))
            return factor * power;
    }
    return 10 * power;
}

template <std::size_t N>
double listedStep(const std::array<double, N>& steps, double minStep)
{
    const auto found = std::lower_bound(steps.begin(), steps.end(), minStep * (1 - tiny));
    return found != steps.end() ? *found : 0;
}

constexpr std::array<double, 9> angleSteps{5, 10, 15, 30, 45, 90, 180, 360, 720};
constexpr std::array<double, 17> clockSteps{1,   2,   5,    10,   15,   30,    60,    120,  300,
                                            600, 900, 1800, 3600, 7200, 14400, 21600, 43200};

int decimalsOf(double step)
{
    int decimals = 0;
    for (double rest = step; decimals < 9; ++decimals, rest *= 10) {
        if (std::abs(rest - std::round(rest)) < 1e-6 * std::max(1.0, rest))
            break;
    }
    return decimals;
}

QString clockText(double seconds, int decimals)
{
    const double scale = std::pow(10.0, decimals);
    const double rounded = std::round(std::abs(seconds) * scale) / scale;
    const auto whole = static_cast<long long>(rounded / minute);
    const double rest = rounded - double(whole) * minute;
    QString tail = QString::number(rest, 'f', decimals);
    if (rest < 10)
        tail.prepend(QLatin1Char('0'));
    QString head = QString::number(whole % 60);
    if (whole >= 60)
        head = QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
    const bool negative = seconds < 0 && rounded > 0;
    return (negative ? QStringLiteral("-") : QString()) + head + QLatin1Char(':') + tail;
}

constexpr double padding = 0.05;     ///< of the span, above and below
constexpr double snapShare = 0.0125; ///< a growing axis takes steps of this part of its span

struct MinSpan {
    double size = 0;
    bool aroundZero = false; ///< what stays this small is shown on both sides of zero
    /// Where the middle of the values is, as a share of the span from the lower edge: at rest,
    /// curves of several units do not lie on each other.
    double middleAt = 0.5;
};

MinSpan minSpan(const QString& unit, double middle)
{
    if (unit == QLatin1String("mA"))
        return {400, true};
    if (unit == QLatin1String("rpm"))
        return {20, true};
    if (unit == QLatin1String("V"))
        return {.size = 0.5, .middleAt = 0.8};
    if (unit == QLatin1String("ms"))
        return {40};
    if (unit == QStringLiteral("°"))
        return {.size = 5, .middleAt = 0.65};
    if (unit == QStringLiteral("°C"))
        return {.size = 5, .middleAt = 0.3};
    if (unit == QLatin1String("%"))
        return {5};
    return {std::max(4.0, std::abs(middle) * 1e-9)};
}
} // namespace

double valueStep(double span, int maxParts, const QString& unit)
{
    if (!std::isfinite(span) || span <= 0)
        return 1;
    const double minStep = span / std::max(maxParts, 1);
    const double listed =
        unit == QStringLiteral("°") && minStep > 2 ? listedStep(angleSteps, minStep) : 0;
    return listed > 0 ? listed : decimalStep(minStep);
}

double timeStep(double seconds, int maxParts)
{
    if (!std::isfinite(seconds) || seconds <= 0)
        return 1;
    const double minStep = seconds / std::max(maxParts, 1);
    if (minStep <= 0.5)
        return decimalStep(minStep);
    const double listed = listedStep(clockSteps, minStep);
    return listed > 0 ? listed : std::ceil(minStep / (24 * hour)) * 24 * hour;
}

std::vector<double> ticks(const AxisRange& range, double step)
{
    std::vector<double> places;
    const double slack = step * 1e-6;
    for (double i = std::ceil((range.low - slack) / step); places.size() < 100; ++i) {
        if (i * step > range.high + slack)
            break;
        places.push_back(i * step);
    }
    return places;
}

QString timeText(double seconds, const AxisRange& axis, double step)
{
    const double farthest = std::max(std::abs(axis.low), std::abs(axis.high));
    if (farthest <= 1.0 + tiny && step < 0.5)
        return QStringLiteral("%1 ms").arg(valueText(seconds * 1000, step * 1000));
    if (farthest <= 2 * minute + tiny)
        return QStringLiteral("%1 s").arg(valueText(seconds, step));
    return clockText(seconds, decimalsOf(std::min(step, 1.0)));
}

QString valueText(double value, double step)
{
    const double shown = std::abs(value) < step * 1e-6 ? 0.0 : value; // no "-0"
    return QString::number(shown, 'f', decimalsOf(step));
}

double displayStep(const QString& unit)
{
    static const QStringList tenths{QStringLiteral("°"), QStringLiteral("rpm"), QStringLiteral("%"),
                                    QStringLiteral("V")};
    return tenths.contains(unit) ? 0.1 : 1;
}

QString readingText(double value, double range)
{
    if (!std::isfinite(value))
        return {};
    const double whole = std::max(std::abs(range), 1e-6);
    const int decimals = std::clamp(int(std::ceil(3 - std::log10(whole))), 0, 9);
    const double shown = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
    return QString::number(shown, 'f', decimals);
}

QString spanText(double seconds)
{
    const double size = std::abs(seconds);
    if (size > 0 && size < 1)
        return QStringLiteral("%1 ms").arg(seconds * 1000, 0, 'f', size < 0.1 ? 3 : 1);
    if (size <= 2 * minute)
        return QStringLiteral("%1 s").arg(seconds, 0, 'f', 3);
    return clockText(seconds, 3);
}

AxisRange paddedRange(double min, double max, const QString& unit)
{
    const double middle = (min + max) / 2;
    const MinSpan least = minSpan(unit, middle);
    if (least.aroundZero && std::max(std::abs(min), std::abs(max)) <= least.size / 2)
        return {-least.size / 2, least.size / 2};
    double low = min - padding * (max - min);
    double high = max + padding * (max - min);
    if (high - low < least.size) {
        low = std::clamp(middle - least.size * least.middleAt, high - least.size, low);
        high = low + least.size;
    }
    const double snap = decimalStep((high - low) * snapShare);
    low = std::floor(low / snap + tiny) * snap;
    high = std::ceil(high / snap - tiny) * snap;
    if (min >= 0 && low < 0)
        return {0, std::max(high, least.size)};
    if (max <= 0 && high > 0)
        return {std::min(low, -least.size), 0};
    return {low, high};
}

AxisRange stretchedRange(const AxisRange& range, double shareBelowZero)
{
    const double share = std::clamp(shareBelowZero, tiny, 1 - tiny);
    const double height = std::max(-range.low / share, range.high / (1 - share));
    return {-height * share, height * (1 - share)};
}
} // namespace ui
