// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace ui {
namespace {
constexpr double minContrast = 3.0;

struct ColorPair {
    QRgb onLight, onDark;
};
// Blue, green, amber, violet, red-brown, teal, olive, gray.
constexpr std::array<ColorPair, trendColorCount> colors{{
    {0xff0a62c4, 0xff4c9bff},
    {0xff0f8050, 0xff3ecb8b},
    {0xffb06f00, 0xffe9a52b},
    {0xff7a48c0, 0xffbd9cf7},
    {0xffa8452a, 0xffef8f6e},
    {0xff0b7f8a, 0xff4cc7d0},
    {0xff75790a, 0xffd9dc5a},
    {0xff5d6675, 0xffa9b1bd},
}};

struct Quantity {
    const char* word; ///< in register keys and roles
    int color;
};
constexpr std::array quantities{Quantity{"position", positionColor},
                                Quantity{"speed", 1},
                                Quantity{"current", 2},
                                Quantity{"load", 3},
                                Quantity{"temperature", 4},
                                Quantity{"voltage", 5},
                                Quantity{"vin", 5},
                                Quantity{"error", 6}};

/// "@speed", "speed" and "present_speed" are one quantity; "speed_p" is none.
std::optional<int> quantityColor(QString key)
{
    if (key.startsWith(QLatin1Char('@')))
        key.remove(0, 1);
    if (key.startsWith(QLatin1String("present_")))
        key.remove(0, int(qstrlen("present_")));
    for (const Quantity& one : quantities) {
        if (key == QLatin1StringView(one.word))
            return one.color;
    }
    return std::nullopt;
}

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

bool isGoalKey(const QString& key)
{
    return key == QLatin1String("@goal") || key.startsWith(QLatin1String("goal_")) ||
           key == QLatin1String("active_goal_position");
}

std::vector<QColor> trendColors(const QStringList& keys, const QColor& background)
{
    std::vector<int> chosen(std::size_t(keys.size()), -1);
    std::set<int> used{goalColor};
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const QString& key = keys[qsizetype(i)];
        const std::optional<int> own = isGoalKey(key) ? goalColor : quantityColor(key);
        if (own && (*own == goalColor || used.insert(*own).second))
            chosen[i] = *own;
    }
    int rest = positionColor;
    std::vector<QColor> found;
    for (int index : chosen) {
        if (index < 0) {
            for (int tries = 0; tries < goalColor && used.count(rest % goalColor) > 0; ++tries)
                ++rest;
            index = rest++ % goalColor;
            used.insert(index);
        }
        found.push_back(trendColor(index, background));
    }
    return found;
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
