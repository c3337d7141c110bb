// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/definition.h"

#include <algorithm>

namespace catalog {
namespace {
bool listsBaud(const RegisterDef& def, const QString& baud)
{
    return def.reg.role == Role::BaudRate &&
           std::any_of(def.reg.values.begin(), def.reg.values.end(),
                       [&](const NamedValue& value) { return value.key == baud; });
}

/// Whether servos with this map can be set to the rate, with any firmware.
bool listsBaud(const MapDef& map, const QString& baud)
{
    return std::any_of(map.rows.begin(), map.rows.end(), [&](const RegisterRow& row) {
        return listsBaud(row.base, baud) ||
               std::any_of(row.set.begin(), row.set.end(),
                           [&](const auto& rule) { return listsBaud(rule.second, baud); });
    });
}

bool isBaudSupported(const Catalog::Data& data, base::Protocol protocol, int baud)
{
    const QString baudKey = QString::number(baud);
    return std::any_of(data.series.begin(), data.series.end(), [&](const SeriesDef& series) {
        if (series.protocol != protocol)
            return false;
        const auto map = data.maps.find(series.map);
        return series.defaultBaud == baud ||
               (map != data.maps.end() && listsBaud(map->second, baudKey));
    });
}
} // namespace

std::vector<base::Protocol> Catalog::protocolsAt(int baud) const
{
    // Feetech has families without a public map, whose rates are unknown.
    std::vector<base::Protocol> found{base::Protocol::Feetech};
    for (const auto protocol : {base::Protocol::Lx, base::Protocol::Modbus}) {
        if (isBaudSupported(*m_data, protocol, baud))
            found.push_back(protocol);
    }
    return found;
}
} // namespace catalog
