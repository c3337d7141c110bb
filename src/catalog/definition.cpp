// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/definition.h"

#include <algorithm>

namespace catalog {
bool Condition::fits(const QString& ofSeries, Version firmware) const
{
    return (series.isEmpty() || series.contains(ofSeries)) && (!from || firmware >= *from) &&
           (!to || firmware <= *to);
}

bool anyFits(const std::vector<Condition>& conditions, const QString& series, Version firmware)
{
    return conditions.empty() ||
           std::any_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
               return condition.fits(series, firmware);
           });
}

QString normalizedModelName(const QString& name)
{
    QString normalized = name.toLower();
    normalized.remove(QLatin1Char('-')).remove(QLatin1Char(' '));
    return normalized;
}

const RegisterDef* RegisterRow::pick(const QString& series, Version firmware) const
{
    if (!anyFits(only, series, firmware))
        return nullptr;
    for (const auto& [condition, changed] : set) {
        if (condition.fits(series, firmware))
            return &changed;
    }
    return &base;
}
} // namespace catalog
