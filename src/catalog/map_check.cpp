// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/map_check.h"

#include <QSet>

#include <array>
#include <set>

namespace catalog {
namespace {
/// One situation in which a row's conditions may turn out differently.
struct Situation {
    QString series;
    Version firmware;
};

Version next(Version version)
{
    return version.minor < 255 ? Version{version.major, version.minor + 1}
                               : Version{version.major + 1, 0};
}

/// Every series that is named, one that is not, and both sides of every firmware bound: between
/// two bounds nothing changes.
std::vector<Situation> situations(const MapDef& map)
{
    QSet<QString> series{QString()};
    std::set<Version> versions{Version{}};
    const auto collect = [&](const Condition& condition) {
        for (const QString& name : condition.series)
            series.insert(name);
        if (condition.from)
            versions.insert(*condition.from);
        if (condition.to)
            versions.insert(next(*condition.to));
    };
    for (const RegisterRow& row : map.rows) {
        for (const Condition& condition : row.only)
            collect(condition);
        for (const auto& [condition, def] : row.set)
            collect(condition);
    }
    std::vector<Situation> all;
    for (const QString& name : series) {
        for (const Version& version : versions)
            all.push_back({name, version});
    }
    return all;
}

/// The row that is in the way of `rows[i]` in this situation marks it as dropped.
void markOverlaps(const MapDef& map, const Situation& situation, std::vector<QString>& reasons)
{
    std::array<int, 1024> owner;
    owner.fill(-1);
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
        const RegisterDef* def = map.rows[i].pick(situation.series, situation.firmware);
        if (!def || !reasons[i].isEmpty())
            continue;
        for (int byte = def->reg.offset; byte < def->reg.offset + def->reg.size; ++byte) {
            const int other = owner[static_cast<std::size_t>(byte)];
            if (other >= 0) {
                reasons[i] = QStringLiteral("address %1 belongs to \"%2\"")
                                 .arg(byte)
                                 .arg(map.rows[static_cast<std::size_t>(other)].base.reg.key);
                break;
            }
            owner[static_cast<std::size_t>(byte)] = static_cast<int>(i);
        }
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

void dropConflicts(MapDef& map,
                   const std::function<void(const QString& key, const QString& reason)>& report)
{
    constexpr std::size_t MostSituations = 512; // far above need, so that a hostile file ends soon
    std::vector<QString> reasons(map.rows.size());
    const auto all = situations(map);
    if (all.size() > MostSituations) {
        report(map.key, QStringLiteral("too many different conditions"));
        map.rows.clear();
        return;
    }
    markDuplicates(map, reasons);
    markMissingReferences(map, reasons);
    for (const Situation& situation : all)
        markOverlaps(map, situation, reasons);
    std::vector<RegisterRow> kept;
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
        if (reasons[i].isEmpty())
            kept.push_back(std::move(map.rows[i]));
        else
            report(map.rows[i].base.reg.key, reasons[i]);
    }
    map.rows = std::move(kept);
}
} // namespace catalog
