// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {
constexpr double minContrast = 3.0;

struct ColorPair {
    QRgb onLight, onDark;
};
// Blue, orange, green, purple, sky, vermilion, yellow, gray.
constexpr std::array<ColorPair, trendColorCount> colors{{
    {0xff0a62c4, 0xff4c9bff},
    {0xffb06f00, 0xffe9a52b},
    {0xff008060, 0xff2fbf95},
    {0xffa8437f, 0xffdf8fbe},
    {0xff2b86b8, 0xff7cc8f2},
    {0xffcc4a00, 0xffff7d45},
    {0xff857a00, 0xffe6da50},
    {0xff5d6675, 0xffa9b1bd},
}};

bool isDarkBackground(const QColor& background)
{
    return contrast(background, Qt::white) > contrast(background, Qt::black);
}

double luminance(const QColor& color)
{
    const auto linear = [](float part) {
        const double v = double(part);
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
           0.0722 * linear(color.blueF());
}
} // namespace

double contrast(const QColor& one, const QColor& other)
{
    const double a = luminance(one) + 0.05;
    const double b = luminance(other) + 0.05;
    return std::max(a, b) / std::min(a, b);
}

QColor trendColor(int index, const QColor& background)
{
    const int slot = ((index % trendColorCount) + trendColorCount) % trendColorCount;
    const ColorPair& pair = colors[std::size_t(slot)];
    return QColor(isDarkBackground(background) ? pair.onDark : pair.onLight);
}

QColor trendColorOn(const QColor& requested, const QColor& background)
{
    for (int i = 0; i < trendColorCount; ++i) {
        const ColorPair& pair = colors[std::size_t(i)];
        if (requested.rgb() == pair.onLight || requested.rgb() == pair.onDark)
            return trendColor(i, background);
    }
    QColor shown = requested.isValid() ? requested.toRgb() : trendColor(0, background);
    const QColor end = isDarkBackground(background) ? Qt::white : Qt::black;
    for (int percent = 5; contrast(shown, background) < minContrast && percent <= 100;
         percent += 5) {
        const auto mix = [&](int from, int to) { return from + (to - from) * percent / 100; };
        const QColor from = requested.toRgb();
        shown = QColor(mix(from.red(), end.red()), mix(from.green(), end.green()),
                       mix(from.blue(), end.blue()));
    }
    return shown;
}
} // namespace ui
