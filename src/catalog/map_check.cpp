// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/map_check.h"

#include "catalog/register_location.h"

#include <QSet>

#include <array>
#include <map>
#include <set>

namespace catalog {
namespace {
/// One situation in which a row's conditions may turn out differently.
struct ConditionCase {
    QString series;
    Version firmware;
};

Version nextVersion(Version version)
{
    return version.minor < 255 ? Version{version.major, version.minor + 1}
                               : Version{version.major + 1, 0};
}

/// Every series that is named, one that is not, and both sides of every firmware bound: between
/// two bounds nothing changes.
std::vector<ConditionCase> conditionCases(const MapDef& map)
{
    QSet<QString> series{QString()};
    std::set<Version> versions{Version{}};
    const auto collect = [&](const Condition& condition) {
        for (const QString& name : condition.series)
            series.insert(name);
        if (condition.from)
            versions.insert(*condition.from);
        if (condition.to)
            versions.insert(nextVersion(*condition.to));
    };
    for (const RegisterRow& row : map.rows) {
        for (const Condition& condition : row.only)
            collect(condition);
        for (const auto& [condition, def] : row.set)
            collect(condition);
    }
    std::vector<ConditionCase> cases;
    for (const QString& name : series) {
        for (const Version& version : versions)
            cases.push_back({name, version});
    }
    return cases;
}

/// Which row owns a byte of the table.
class AddressOwners {
public:
    AddressOwners() { m_rows.fill(-1); }

    /// The row that already has one of the bytes, or -1 and they are taken.
    int claim(int offset, int size, int row)
    {
        for (int byte = offset; byte < offset + size; ++byte) {
            int& owner = m_rows[static_cast<std::size_t>(byte)];
            if (owner >= 0 && owner != row)
                return owner;
            owner = row;
        }
        return -1;
    }

private:
    std::array<int, tableBytes> m_rows;
};

/// The row that is in the way of `rows[i]` in this situation marks it as dropped. Reads and writes
/// share one table: an LX command number is either read or written.
void markOverlaps(const MapDef& map, const ConditionCase& situation, std::vector<QString>& reasons)
{
    AddressOwners addressOwners;
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
        const RegisterDef* def = map.rows[i].pick(situation.series, situation.firmware);
        if (!def || !reasons[i].isEmpty())
            continue;
        const Register& reg = def->reg;
        const int row = static_cast<int>(i);
        int other = addressOwners.claim(reg.offset, reg.size, row);
        if (other < 0)
            other = addressOwners.claim(reg.writeOffset, reg.size, row);
        if (other >= 0) {
            const Register& owner = map.rows[static_cast<std::size_t>(other)].base.reg;
            reasons[i] =
                QStringLiteral("address %1 belongs to \"%2\"").arg(owner.address).arg(owner.key);
        }
    }
}

/// LX rows that are read by one command are written by one command, in the same order.
void markInconsistentBlocks(const MapDef& map, std::vector<QString>& reasons)
{
    std::map<int, int> distances; // from read to write, by read command
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
        const Register& reg = map.rows[i].base.reg;
        if (map.protocol != base::Protocol::Lx || !reasons[i].isEmpty() || !reg.writable())
            continue;
        const auto [it, first] = distances.emplace(reg.address, reg.writeOffset - reg.offset);
        if (!first && it->second != reg.writeOffset - reg.offset)
            reasons[i] = QStringLiteral("\"write\" differs from that of its neighbour");
    }
}

void markDuplicates(const MapDef& map, std::vector<QString>& reasons)
{
    QSet<QString> keys;
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
        const QString& key = map.rows[i].base.reg.key;
        if (keys.contains(key))
            reasons[i] = QStringLiteral("the key occurs twice");
        keys.insert(key);
    }
}

QString missingReference(const RegisterDef& def, const QSet<QString>& keys)
{
    if (!def.reg.scaleBy.isEmpty() && !keys.contains(def.reg.scaleBy))
        return QStringLiteral("\"scale_by\" names no register: \"%1\"").arg(def.reg.scaleBy);
    for (const Variant& variant : def.reg.variants) {
        if (!variant.andBothLimitsZero && !keys.contains(variant.whenKey))
            return QStringLiteral("\"when\" names no register: \"%1\"").arg(variant.whenKey);
    }
    return {};
}

void markMissingReferences(const MapDef& map, std::vector<QString>& reasons)
{
    QSet<QString> keys;
    for (const RegisterRow& row : map.rows)
        keys.insert(row.base.reg.key);
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
        QString missing = missingReference(map.rows[i].base, keys);
        for (const auto& [condition, def] : map.rows[i].set) {
            if (missing.isEmpty())
                missing = missingReference(def, keys);
        }
        if (reasons[i].isEmpty())
            reasons[i] = missing;
    }
}
} // namespace

void removeConflicts(MapDef& map,
                     const std::function<void(const QString& key, const QString& reason)>& report)
{
    constexpr std::size_t maxConditionCases =
        512; // far more than needed; limits the time for a malicious file
    std::vector<QString> reasons(map.rows.size());
    const auto cases = conditionCases(map);
    if (cases.size() > maxConditionCases) {
        report(map.key, QStringLiteral("too many different conditions"));
        map.rows.clear();
        return;
    }
    markDuplicates(map, reasons);
    markMissingReferences(map, reasons);
    markInconsistentBlocks(map, reasons);
    for (const ConditionCase& situation : cases)
        markOverlaps(map, situation, reasons);
    std::vector<RegisterRow> remaining;
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
        if (reasons[i].isEmpty())
            remaining.push_back(std::move(map.rows[i]));
        else
            report(map.rows[i].base.reg.key, reasons[i]);
    }
    map.rows = std::move(remaining);
}
} // namespace catalog
