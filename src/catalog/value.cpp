// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/value.h"

#include "catalog/raw_range.h"

#include <algorithm>
#include <cmath>

namespace catalog {
namespace {
/// Whether a variant holds; nullopt while the register that decides is unknown.
std::optional<bool> matches(const Variant& variant, const Profile& profile, const Lookup& lookup)
{
    if (!variant.andBothLimitsZero) {
        const auto decidingValue = lookup(variant.whenKey);
        if (!decidingValue)
            return std::nullopt;
        return (*decidingValue & variant.mask) == variant.equals;
    }
    bool unknown = false;
    for (const Role role : {Role::MinAngle, Role::MaxAngle}) {
        const Register* limit = profile.byRole(role);
        const auto raw = limit ? lookup(limit->key) : std::nullopt;
        if (raw && *raw != 0)
            return false;
        unknown = unknown || !raw;
    }
    return unknown ? std::nullopt : std::optional(true);
}

void apply(const Variant& variant, ValueFormat& meaning)
{
    meaning.scale = variant.scale.value_or(meaning.scale);
    meaning.unit = variant.unit.value_or(meaning.unit);
    meaning.encoding = variant.encoding.value_or(meaning.encoding);
    meaning.signBit = variant.signBit.value_or(meaning.signBit);
    meaning.name = variant.name.value_or(meaning.name);
    if (variant.min)
        meaning.min = variant.min;
    if (variant.max)
        meaning.max = variant.max;
}

/// Four-byte numbers go low word first, each word in the family's order.
std::uint64_t readWire(base::ByteView wire, base::ByteOrder order)
{
    if (wire.size() != 4 || order == base::ByteOrder::Little)
        return base::readUnsigned(wire, order);
    return base::readUnsigned(wire.first(2), order) | base::readUnsigned(wire.last(2), order) << 16;
}

base::Bytes writeWire(std::uint64_t value, std::size_t size, base::ByteOrder order)
{
    if (size != 4 || order == base::ByteOrder::Little)
        return base::writeUnsigned(value, size, order);
    base::Bytes bytes = base::writeUnsigned(value & 0xFFFF, 2, order);
    const base::Bytes high = base::writeUnsigned(value >> 16, 2, order);
    bytes.insert(bytes.end(), high.begin(), high.end());
    return bytes;
}

std::int64_t signedMagnitude(std::uint64_t magnitude, bool negative)
{
    const auto value = static_cast<std::int64_t>(magnitude);
    return negative ? -value : value;
}

/// "0…1000", and what that is in the unit the user thinks in.
QString rangeText(RawRange range, const Register& reg, const ValueFormat& meaning)
{
    const QString raw = QStringLiteral("%1…%2").arg(range.min).arg(range.max);
    if (meaning.unit.isEmpty() || meaning.scale == 1.0)
        return raw;
    return QStringLiteral("%1, %2 … %3")
        .arg(raw, formatValue(range.min, reg, meaning, false),
             formatValue(range.max, reg, meaning, false));
}

base::Result<void> refuse(base::ErrorCode code, const Register& reg, const QString& detail)
{
    base::Error error{code, QStringLiteral("write"), detail};
    error.registerKey = reg.key;
    return tl::unexpected(error);
}
} // namespace

ValueFormat valueFormat(const Register& reg, const Profile& profile, const Lookup& lookup)
{
    ValueFormat meaning{reg.encoding, reg.signBit, reg.scale, reg.unit, reg.min, reg.max, reg.name};
    for (const Variant& variant : reg.variants) {
        const auto decided = matches(variant, profile, lookup);
        if (!decided)
            meaning.assumed = true;
        else if (*decided)
            apply(variant, meaning);
    }
    if (!reg.scaleBy.isEmpty()) {
        const auto factor = lookup(reg.scaleBy);
        if (factor && *factor > 0)
            meaning.scale *= static_cast<double>(*factor);
        else
            meaning.assumed = true;
    }
    return meaning;
}

RawRange representableRange(int size, Encoding encoding, int signBit)
{
    const auto bits = std::clamp(size, 1, 4) * 8;
    switch (encoding) {
    case Encoding::SignBit: {
        const auto magnitude = (std::int64_t{1} << signBit) - 1;
        return {-magnitude, magnitude};
    }
    case Encoding::SignBit11Ext12:
        return {-4095, 4095};
    case Encoding::TwosComplement:
        return {-(std::int64_t{1} << (bits - 1)), (std::int64_t{1} << (bits - 1)) - 1};
    case Encoding::Unsigned:
    case Encoding::Bits:
    case Encoding::Enum:
        break;
    }
    return {0, (std::int64_t{1} << bits) - 1};
}

std::int64_t decodeRaw(base::ByteView wire, const Register& reg, const ValueFormat& meaning,
                       base::ByteOrder order)
{
    const auto size = std::min(wire.size(), static_cast<std::size_t>(reg.size));
    if (size == 0)
        return 0;
    const std::uint64_t word = readWire(wire.first(size), order);
    switch (meaning.encoding) {
    case Encoding::SignBit: {
        const std::uint64_t sign = std::uint64_t{1} << meaning.signBit;
        return signedMagnitude(word & (sign - 1), (word & sign) != 0);
    }
    case Encoding::SignBit11Ext12:
        return signedMagnitude((word & 0x7FF) + ((word & 0x1000) ? 0x800 : 0), (word & 0x800) != 0);
    case Encoding::TwosComplement: {
        const std::uint64_t sign = std::uint64_t{1} << (size * 8 - 1);
        return static_cast<std::int64_t>(word ^ sign) - static_cast<std::int64_t>(sign);
    }
    case Encoding::Unsigned:
    case Encoding::Bits:
    case Encoding::Enum:
        break;
    }
    return static_cast<std::int64_t>(word);
}

base::Bytes encodeRaw(std::int64_t raw, const Register& reg, const ValueFormat& meaning,
                      base::ByteOrder order)
{
    const RawRange range = representableRange(reg.size, meaning.encoding, meaning.signBit);
    const std::int64_t value = std::clamp(raw, range.min, range.max);
    const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
    const auto size = static_cast<std::size_t>(reg.size);
    switch (meaning.encoding) {
    case Encoding::SignBit: {
        const std::uint64_t sign = value < 0 ? std::uint64_t{1} << meaning.signBit : 0;
        return writeWire(magnitude | sign, size, order);
    }
    case Encoding::SignBit11Ext12:
        return writeWire((magnitude & 0x7FF) | (magnitude > 0x7FF ? 0x1000U : 0U) |
                             (value < 0 ? 0x800U : 0U),
                         size, order);
    case Encoding::TwosComplement:
    case Encoding::Unsigned:
    case Encoding::Bits:
    case Encoding::Enum:
        break;
    }
    return writeWire(static_cast<std::uint64_t>(value), size, order);
}

double toPhysical(std::int64_t raw, const ValueFormat& meaning)
{
    return static_cast<double>(raw) * meaning.scale;
}

std::int64_t toRaw(double physical, const ValueFormat& meaning)
{
    constexpr double maxMagnitude = 4.0e15; // far beyond any register, still exact in a double
    const double steps = physical / meaning.scale;
    if (std::isnan(steps))
        return 0;
    return std::llround(std::clamp(steps, -maxMagnitude, maxMagnitude));
}

base::Result<void> checkNewValue(std::int64_t raw, const Register& reg, const ValueFormat& meaning,
                                 std::optional<std::int64_t> present)
{
    if (!reg.writable())
        return refuse(base::ErrorCode::ReadOnly, reg, {});
    if (present && *present == raw)
        return {};
    if (meaning.encoding == Encoding::Enum && !reg.values.empty()) {
        const bool named = std::any_of(reg.values.begin(), reg.values.end(),
                                       [&](const NamedValue& v) { return v.value == raw; });
        if (!named)
            return refuse(base::ErrorCode::OutOfRange, reg, valueKeys(reg));
    }
    RawRange range = representableRange(reg.size, meaning.encoding, meaning.signBit);
    // A servo that shows bit 12 proves that its firmware knows the wide offset coding.
    const bool isExtendedOffset =
        meaning.encoding == Encoding::SignBit11Ext12 && present && std::abs(*present) > 2047;
    if (!isExtendedOffset) {
        range.min = std::max(range.min, meaning.min.value_or(range.min));
        range.max = std::min(range.max, meaning.max.value_or(range.max));
    }
    if (raw < range.min || raw > range.max)
        return refuse(base::ErrorCode::OutOfRange, reg, rangeText(range, reg, meaning));
    return {};
}
} // namespace catalog
