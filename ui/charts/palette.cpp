// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {
constexpr double leastContrast = 3.0;

struct Twins {
    QRgb onLight, onDark;
};
// Blue, orange, green, purple, sky, vermilion, yellow, grey.
constexpr std::array<Twins, trendColourCount> colours{{
    {0xff0a62c4, 0xff4c9bff},
    {0xffb06f00, 0xffe9a52b},
    {0xff008060, 0xff2fbf95},
    {0xffa8437f, 0xffdf8fbe},
    {0xff2b86b8, 0xff7cc8f2},
    {0xffcc4a00, 0xffff7d45},
    {0xff857a00, 0xffe6da50},
    {0xff5d6675, 0xffa9b1bd},
}};

bool isDarkGround(const QColor& ground)
{
    return contrast(ground, Qt::white) > contrast(ground, Qt::black);
}

double luminance(const QColor& colour)
{
    const auto linear = [](float part) {
        const double v = double(part);
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}
} // namespace

double contrast(const QColor& one, const QColor& other)
{
    const double a = luminance(one) + 0.05;
    const double b = luminance(other) + 0.05;
    return std::max(a, b) / std::min(a, b);
}

QColor trendColour(int index, const QColor& ground)
{
    const int place = ((index % trendColourCount) + trendColourCount) % trendColourCount;
    const Twins& twins = colours[std::size_t(place)];
    return QColor(isDarkGround(ground) ? twins.onDark : twins.onLight);
}

QColor trendColourOn(const QColor& wanted, const QColor& ground)
{
    for (int i = 0; i < trendColourCount; ++i) {
        const Twins& twins = colours[std::size_t(i)];
        if (wanted.rgb() == twins.onLight || wanted.rgb() == twins.onDark)
            return trendColour(i, ground);
    }
    QColor shown = wanted.isValid() ? wanted.toRgb() : trendColour(0, ground);
    const QColor end = isDarkGround(ground) ? Qt::white : Qt::black;
    for (int percent = 5; contrast(shown, ground) < leastContrast && percent <= 100; percent += 5) {
        const auto mix = [&](int from, int to) { return from + (to - from) * percent / 100; };
        const QColor from = wanted.toRgb();
        shown = QColor(mix(from.red(), end.red()), mix(from.green(), end.green()),
                       mix(from.blue(), end.blue()));
    }
    return shown;
}
} // namespace ui
