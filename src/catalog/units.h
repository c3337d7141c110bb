// SPDX-License-Identifier: GPL-3.0-or-later
// How units are written and which spellings are understood. Pure functions; any thread.
#pragma once

#include <QString>

#include <optional>

namespace catalog {
/// The unit as it follows a number: "°", " V", " °C"; empty for a plain number.
QString unitSuffix(const QString& unit);

/// What a number in the spelling `typed` must be multiplied with to be in `unit` ("s" → "ms":
/// 1000); nullopt if the spelling does not fit the unit.
std::optional<double> unitFactor(const QString& typed, const QString& unit);
} // namespace catalog
