// SPDX-License-Identifier: GPL-3.0-or-later
// Which writes must ask, in every family: from the data sheets, not from the register maps, for the
// tests of every way a value takes to a servo.
#pragma once

#include "catalog/register.h"

#include <optional>
#include <set>
#include <vector>

namespace support {
/// By the names of the register maps, whose addresses are those of the sheets.
inline const std::set<QString> riskyKeys{QStringLiteral("id"),
                                         QStringLiteral("secondary_id"),
                                         QStringLiteral("baud_rate"),
                                         QStringLiteral("response_level"),
                                         QStringLiteral("phase"),
                                         QStringLiteral("unload_condition"),
                                         QStringLiteral("angle_offset"),
                                         QStringLiteral("angle_resolution"),
                                         QStringLiteral("return_delay"),
                                         QStringLiteral("position_offset"),
                                         QStringLiteral("operating_mode")};

struct FamilyRules {
    const char* servos;
    int baud;
    std::set<QString> harmless; ///< of riskyKeys: only delays a reply in this family
    const char* centerKey;      ///< takes a value that sets the midpoint
    std::int64_t centerValue;
};

/// Torque switch 40 = 128 (STS and SMS), bit 2 of the fault reset register (Modbus).
inline const std::vector<FamilyRules>& consentFamilies()
{
    static const std::vector<FamilyRules> all{
        {"sts3215@1", 1'000'000, {QStringLiteral("return_delay")}, "torque_switch", 128},
        {"sm40blhv@1", 115'200, {}, "torque_switch", 128},
        {"scs15@1", 1'000'000, {QStringLiteral("return_delay")}, "", 0},
        {"hls3606@1", 1'000'000, {QStringLiteral("return_delay")}, "", 0},
        {"sm60-360m@1", 115'200, {}, "", 0},
        {"scs15-2@1", 1'000'000, {QStringLiteral("return_delay")}, "", 0},
        {"smsmb@1", 115'200, {}, "fault_reset", 4},
        {"lx16a@1", 115'200, {}, "", 0}};
    return all;
}

inline std::set<std::int64_t> specialValues(const catalog::Register& reg,
                                            std::optional<std::int64_t> present)
{
    std::set<std::int64_t> values{0, 1, 2, 4, 128, 254};
    for (const auto& bound : {reg.min, reg.max}) {
        if (bound)
            values.insert(*bound);
    }
    for (const catalog::NamedValue& named : reg.values)
        values.insert(named.value);
    if (present)
        values.insert({*present - 1, *present + 1});
    return values;
}

inline bool mustAsk(const FamilyRules& rules, const catalog::Register& reg, std::int64_t raw)
{
    if (reg.key == QLatin1String(rules.centerKey))
        return *rules.centerKey == 'f' ? (raw & rules.centerValue) != 0 : raw == rules.centerValue;
    return reg.area == catalog::Area::Factory ||
           (riskyKeys.count(reg.key) > 0 && rules.harmless.count(reg.key) == 0);
}
} // namespace support
