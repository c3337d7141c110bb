// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/units.h"

#include <algorithm>
#include <iterator>

namespace catalog {
namespace {
struct Suffix {
    QLatin1String unit;
    const char16_t* text;
};

constexpr Suffix unitSuffixes[] = {
    {QLatin1String("deg"), u"°"},
    {QLatin1String("degC"), u" °C"},
    {QLatin1String("us"), u" µs"},
    {QLatin1String("deg/s2"), u" °/s²"},
};

struct Spelling {
    QLatin1String unit;
    const char16_t* typed; ///< lower case, without blanks
    double factor;
};

constexpr Spelling unitSpellings[] = {
    {QLatin1String("deg"), u"deg", 1},       {QLatin1String("deg"), u"°", 1},
    {QLatin1String("deg"), u"degrees", 1},   {QLatin1String("deg"), u"度", 1},
    {QLatin1String("degC"), u"°c", 1},       {QLatin1String("degC"), u"℃", 1},
    {QLatin1String("degC"), u"degc", 1},     {QLatin1String("degC"), u"c", 1},
    {QLatin1String("rpm"), u"rpm", 1},       {QLatin1String("rpm"), u"deg/s", 1.0 / 6},
    {QLatin1String("rpm"), u"°/s", 1.0 / 6}, {QLatin1String("V"), u"v", 1},
    {QLatin1String("V"), u"mv", 0.001},      {QLatin1String("ms"), u"ms", 1},
    {QLatin1String("ms"), u"s", 1000},       {QLatin1String("us"), u"us", 1},
    {QLatin1String("us"), u"µs", 1},         {QLatin1String("us"), u"μs", 1},
    {QLatin1String("us"), u"ms", 1000},      {QLatin1String("mA"), u"ma", 1},
    {QLatin1String("mA"), u"a", 1000},       {QLatin1String("deg/s2"), u"deg/s2", 1},
    {QLatin1String("deg/s2"), u"°/s²", 1},   {QLatin1String("deg/s2"), u"°/s2", 1},
    {QLatin1String("deg/s2"), u"deg/s²", 1}, {QLatin1String("step"), u"steps", 1},
};
} // namespace

QString unitSuffix(const QString& unit)
{
    const auto* it = std::find_if(std::begin(unitSuffixes), std::end(unitSuffixes),
                                  [&](const Suffix& suffix) { return suffix.unit == unit; });
    if (it != std::end(unitSuffixes))
        return QString::fromUtf16(it->text);
    return unit.isEmpty() ? QString() : QLatin1Char(' ') + unit;
}

std::optional<double> unitFactor(const QString& typed, const QString& unit)
{
    if (unit.isEmpty())
        return std::nullopt;
    QString word = typed.toLower();
    word.remove(QLatin1Char(' '));
    if (word == unit.toLower())
        return 1.0;
    for (const Spelling& spelling : unitSpellings) {
        if (spelling.unit == unit && word == QStringView(spelling.typed))
            return spelling.factor;
    }
    return std::nullopt;
}
} // namespace catalog
