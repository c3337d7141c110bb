// SPDX-License-Identifier: GPL-3.0-or-later
// Wire bytes ↔ raw number ↔ physical value ↔ text, for any register. Pure functions; any thread.
// Raw is the number after sign decoding; negative zero reads 0; unnamed bits are kept.
#pragma once

#include "base/error.h"
#include "catalog/profile.h"

#include <functional>

namespace catalog {
/// Returns the raw value of another register of the same servo, as far as it is known.
using Lookup = std::function<std::optional<std::int64_t>(const QString& key)>;
inline std::optional<std::int64_t> noLookup(const QString&)
{
    return std::nullopt;
}

/// A register's numeric meaning with its variants resolved.
struct ValueFormat {
    Encoding encoding = Encoding::Unsigned;
    int signBit = 0;
    double scale = 1.0;
    QString unit;
    std::optional<std::int64_t> min;
    std::optional<std::int64_t> max;
    Text name;
    /// True when a deciding register is unknown, so that the meaning is the sheet's assumption.
    bool assumed = false;
};
ValueFormat valueFormat(const Register& reg, const Profile& profile, const Lookup& lookup);

std::int64_t decodeRaw(base::ByteView wire, const Register& reg, const ValueFormat& meaning,
                       base::ByteOrder order);
base::Bytes encodeRaw(std::int64_t raw, const Register& reg, const ValueFormat& meaning,
                      base::ByteOrder order);

double toPhysical(std::int64_t raw, const ValueFormat& meaning);
std::int64_t toRaw(double physical, const ValueFormat& meaning); ///< nearest

/// "8.5 V", "90.00°", the name of the enum value, or the names of the set bits ("voltage +
/// overload"). A number without a unit is shown raw. What is shown can be parsed again.
QString formatValue(std::int64_t raw, const Register& reg, const ValueFormat& meaning,
                    bool chinese);

/// Raw number ("85"), physical value with its unit ("8.5V", "90deg", "12rpm") or a value's key
/// ("position"; bits: "overload+voltage"). BadArgument names what is expected.
base::Result<std::int64_t> parseValue(const QString& text, const Register& reg,
                                      const ValueFormat& meaning);

/// Range, access and enum membership of a *new* value. The value just read may always be written
/// back. ReadOnly or OutOfRange.
base::Result<void> checkNewValue(std::int64_t raw, const Register& reg, const ValueFormat& meaning,
                                 std::optional<std::int64_t> present);
} // namespace catalog
