// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/family_conflict.h"

#include <algorithm>

namespace catalog {
namespace {
/// Equal in all Feetech tables: where the areas begin, and the last byte that each of them has.
constexpr int firstSram = 40;
constexpr int firstFeedback = 56;
constexpr int lastCommonByte = 70;
/// A table of unknown length is not asked for more at once.
constexpr int safeReadCount = 36;

int flagOf(base::ByteOrder order)
{
    return order == base::ByteOrder::Big ? 1 : 0;
}

bool hasFirmware(const SeriesDef& series, Version firmware)
{
    return series.protocol == base::Protocol::Feetech && series.from && series.to &&
           firmware >= *series.from && firmware <= *series.to;
}

/// The byte of the lock in the map of this series; −1: it has none.
int lockOf(const Catalog::Data& data, const QString& series)
{
    const auto def = std::find_if(data.series.begin(), data.series.end(),
                                  [&](const SeriesDef& one) { return one.key == series; });
    const auto map = def == data.series.end() ? data.maps.end() : data.maps.find(def->map);
    if (map == data.maps.end())
        return -1;
    for (const RegisterRow& row : map->second.rows) {
        if (row.base.reg.role == Role::Lock)
            return row.base.reg.offset;
    }
    return -1;
}

/// The model fits when its family has the lock where the chosen family has it: what firmware
/// decides between STS and HLS is no contradiction, since BL and HTS models exist with both.
bool modelFits(const Catalog::Data& data, const ModelEntry& model, const SeriesDef& chosen)
{
    const int lock = lockOf(data, model.series);
    return model.byteOrder == chosen.byteOrder && (lock < 0 || lock == lockOf(data, chosen.key));
}

std::vector<const ModelEntry*> modelsOf(const Catalog::Data& data, const Identity& identity)
{
    std::vector<const ModelEntry*> models;
    for (const ModelEntry& model : data.models) {
        if (identity.modelMajor >= 0 && model.major == identity.modelMajor &&
            model.minor == identity.modelMinor)
            models.push_back(&model);
    }
    return models;
}

/// The last one that fits, as Catalog::resolve() chooses.
const SeriesDef* chosenBy(const Catalog::Data& data, Version firmware, int flag)
{
    const SeriesDef* chosen = nullptr;
    for (const SeriesDef& series : data.series) {
        if (hasFirmware(series, firmware) && flagOf(series.byteOrder) == flag)
            chosen = &series;
    }
    return chosen;
}

Register rawByte(int address)
{
    Register reg;
    reg.key = QStringLiteral("byte_%1").arg(address);
    reg.address = reg.offset = reg.writeOffset = address;
    reg.area = address < firstSram       ? Area::Eprom
               : address < firstFeedback ? Area::Sram
                                         : Area::Feedback;
    reg.min = 0;
    reg.max = 255;
    reg.name = {QStringLiteral("Byte %1").arg(address), QStringLiteral("字节 %1").arg(address)};
    reg.help = {QStringLiteral("The byte as it was read. What it means depends on the family, "
                               "which is unclear."),
                QStringLiteral("读到的原始字节。其含义取决于系列，而系列尚不明确。")};
    reg.source = QStringLiteral("the servo's reply");
    return reg;
}
} // namespace

std::optional<FamilyFacts> familyConflict(const Catalog::Data& data, const Identity& identity)
{
    if (identity.protocol != base::Protocol::Feetech ||
        (identity.byteOrderFlag != 0 && identity.byteOrderFlag != 1))
        return std::nullopt;
    const Version firmware{identity.firmwareMajor, identity.firmwareMinor};
    QStringList families;
    for (const SeriesDef& series : data.series) {
        if (hasFirmware(series, firmware) && !families.contains(series.key))
            families.append(series.key);
    }
    if (families.isEmpty())
        return std::nullopt; // an unknown firmware contradicts nothing
    const auto models = modelsOf(data, identity);
    const SeriesDef* chosen = chosenBy(data, firmware, identity.byteOrderFlag);
    const bool fits =
        chosen != nullptr &&
        (models.empty() || std::any_of(models.begin(), models.end(), [&](const ModelEntry* model) {
             return modelFits(data, *model, *chosen);
         }));
    if (fits)
        return std::nullopt;
    FamilyFacts facts;
    facts.firmware = identity.firmware();
    facts.firmwareSeries = families.join(QLatin1Char('/'));
    facts.byteOrderFlag = identity.byteOrderFlag;
    facts.modelId = identity.modelId();
    if (!models.empty()) {
        facts.modelName = models.front()->name;
        facts.modelFlag = flagOf(models.front()->byteOrder);
    }
    return facts;
}

void replaceWithRawBytes(Profile& profile)
{
    std::erase_if(profile.registers, [](const Register& reg) { return reg.size > 1; });
    for (int address = 0; address <= lastCommonByte; ++address) {
        if (profile.at(address) == nullptr)
            profile.registers.push_back(rawByte(address));
    }
    std::sort(profile.registers.begin(), profile.registers.end(),
              [](const Register& a, const Register& b) { return a.offset < b.offset; });
    profile.mapKey = QStringLiteral("unclear");
    profile.maxRead = safeReadCount;
}
} // namespace catalog
