// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include "catalog/definition.h"
#include "catalog/family_conflict.h"
#include "catalog/loader.h"

#include <QDir>

#include <algorithm>

// Q_INIT_RESOURCE must be outside every namespace; without it the linker drops the resources of
// a static library.
static void initResources()
{
    Q_INIT_RESOURCE(models);
}

namespace catalog {
namespace {
const QString unknownMapKey = QStringLiteral("unknown");

const SeriesDef* seriesByKey(const Catalog::Data& data, const QString& key)
{
    const auto it = std::find_if(data.series.begin(), data.series.end(),
                                 [&](const SeriesDef& series) { return series.key == key; });
    return it == data.series.end() ? nullptr : &*it;
}

bool firmwareFits(const SeriesDef& series, Version firmware)
{
    return (!series.from || firmware >= *series.from) && (!series.to || firmware <= *series.to);
}

/// Servos of other protocols than Feetech's have no model number; the protocol gives the name.
const SeriesDef* seriesByProtocol(const Catalog::Data& data, base::Protocol protocol,
                                  Version firmware)
{
    const SeriesDef* found = nullptr;
    for (const SeriesDef& series : data.series) {
        if (series.protocol == protocol && firmwareFits(series, firmware))
            found = &series;
    }
    return found;
}

/// The last one that fits, so that a user's series comes before a built-in one. Without a byte
/// order only an unambiguous firmware counts.
const SeriesDef* seriesByFirmware(const Catalog::Data& data, Version firmware,
                                  std::optional<base::ByteOrder> order)
{
    const SeriesDef* found = nullptr;
    for (const SeriesDef& series : data.series) {
        if (series.protocol != base::Protocol::Feetech || !firmwareFits(series, firmware) ||
            (order && series.byteOrder != *order))
            continue;
        if (!order && found && found->byteOrder != series.byteOrder)
            return nullptr;
        found = &series;
    }
    return found;
}

const ModelEntry* modelByNumber(const Catalog::Data& data, int major, int minor,
                                base::ByteOrder order)
{
    if (major < 0 || minor < 0)
        return nullptr;
    for (const ModelEntry& model : data.models) {
        if (model.major == major && model.minor == minor && model.byteOrder == order)
            return &model;
    }
    return nullptr;
}

std::optional<base::ByteOrder> orderOf(const SeriesDef* series)
{
    return series ? std::optional(series->byteOrder) : std::nullopt;
}

/// The value of register 2, else that of the model list, else what the firmware alone implies.
std::optional<base::ByteOrder> byteOrderOf(const Catalog::Data& data, const Identity& identity,
                                           Version firmware)
{
    if (identity.byteOrderFlag == 0 || identity.byteOrderFlag == 1)
        return identity.byteOrderFlag ? base::ByteOrder::Big : base::ByteOrder::Little;
    const auto* little =
        modelByNumber(data, identity.modelMajor, identity.modelMinor, base::ByteOrder::Little);
    const auto* big =
        modelByNumber(data, identity.modelMajor, identity.modelMinor, base::ByteOrder::Big);
    if ((little == nullptr) != (big == nullptr))
        return little ? base::ByteOrder::Little : base::ByteOrder::Big;
    return orderOf(seriesByFirmware(data, firmware, std::nullopt));
}

/// Steps become degrees where the model's range is known.
void resolveAngular(Register& reg, Angular angular, const Profile& profile)
{
    if (angular == Angular::No || !profile.angleRangeDeg)
        return;
    const double degPerStep = *profile.angleRangeDeg / profile.stepsPerTurn;
    const bool speed = angular == Angular::Speed;
    reg.scale *= speed ? degPerStep / 6 : degPerStep; // 1 rpm = 6 °/s
    reg.unit = speed ? QStringLiteral("rpm") : QStringLiteral("deg");
}

Register resolveRegister(const RegisterDef& def, const Profile& profile, Version firmware)
{
    Register reg = def.reg;
    reg.values.clear();
    for (std::size_t i = 0; i < def.reg.values.size(); ++i) {
        if (anyFits(def.valueOnly[i], profile.series, firmware))
            reg.values.push_back(def.reg.values[i]);
    }
    resolveAngular(reg, def.angular, profile);
    return reg;
}

void addRegisters(Profile& profile, const MapDef& map, Version firmware)
{
    for (const RegisterRow& row : map.rows) {
        if (const RegisterDef* def = row.pick(profile.series, firmware))
            profile.registers.push_back(resolveRegister(*def, profile, firmware));
    }
    std::sort(profile.registers.begin(), profile.registers.end(),
              [](const Register& a, const Register& b) { return a.offset < b.offset; });
}

void applySeries(Profile& profile, const SeriesDef& series)
{
    profile.series = series.key;
    profile.line = series.line;
    profile.stepsPerTurn = series.stepsPerTurn;
    profile.angleRangeDeg = series.angleRangeDeg;
    profile.defaultBaud = series.defaultBaud;
    profile.syncRead = series.syncRead;
}

/// How blocks may be read: LX commands one by one, Modbus without the holes between its areas.
void applyProtocol(Profile& profile, base::Protocol protocol)
{
    profile.protocol = protocol;
    switch (protocol) {
    case base::Protocol::Feetech:
        return;
    case base::Protocol::Modbus:
        profile.readGap = 0;
        profile.maxRead = 58; // the vendor's library has a buffer of 64 bytes
        return;
    case base::Protocol::Lx:
        profile.readGap = -1;
        return;
    }
}

/// Everything except reading needs a map.
void applyCapabilities(Profile& profile, const SeriesDef& series, Version firmware)
{
    profile.mapKey = series.map;
    profile.writable = true;
    profile.damping = series.damping;
    profile.multiTurn = series.multiTurn;
    if (!series.centeringFrom || firmware >= *series.centeringFrom)
        profile.centering = series.centering;
    profile.modes = series.modes;
}

void applyModel(Profile& profile, const ModelEntry& model)
{
    profile.modelName = model.name;
    profile.modelKnown = true;
    profile.stepsPerTurn = model.stepsPerTurn;
    profile.angleRangeDeg = model.angleRangeDeg;
    profile.minVoltage = model.minVoltage;
    profile.maxVoltage = model.maxVoltage;
    profile.currentSensing = model.currentSensing;
    if (model.defaultBaud)
        profile.defaultBaud = model.defaultBaud;
}

QString genericName(const Profile& profile)
{
    if (profile.identity.protocol != base::Protocol::Feetech)
        return profile.series.isEmpty() ? QStringLiteral("?") : profile.series;
    const QString kind = profile.series.isEmpty() ? QStringLiteral("?") : profile.series;
    return QStringLiteral("%1 (%2)").arg(kind, profile.identity.modelId());
}

ProfilePtr build(const Catalog::Data& data, const Identity& identity, const ModelEntry* model,
                 const SeriesDef* series, std::optional<base::ByteOrder> order)
{
    const Version firmware{identity.firmwareMajor, identity.firmwareMinor};
    const bool supported = series && !series->map.isEmpty() && (!model || model->supported);
    const SeriesDef* family = series || !model ? series : seriesByKey(data, model->series);

    auto profile = std::make_shared<Profile>();
    profile->identity = identity;
    applyProtocol(*profile, identity.protocol);
    profile->byteOrder = order.value_or(base::ByteOrder::Little);
    profile->mapKey = unknownMapKey;
    profile->writable = false;
    if (family)
        applySeries(*profile, *family);
    if (supported)
        applyCapabilities(*profile, *series, firmware);
    if (model) {
        applyModel(*profile, *model);
        if (!series || !model->supported)
            profile->series = model->series;
    } else {
        profile->modelName = genericName(*profile);
    }
    const auto map = data.maps.find(profile->mapKey);
    if (map != data.maps.end() && map->second.protocol == profile->protocol)
        addRegisters(*profile, map->second, firmware);
    return profile;
}

/// Neither the name of the model nor a map is trusted.
ProfilePtr buildConflicting(const Catalog::Data& data, const Identity& identity,
                            base::ByteOrder order, const FamilyFacts& conflict)
{
    auto profile = std::make_shared<Profile>(*build(data, identity, nullptr, nullptr, order));
    profile->conflict = conflict;
    replaceWithRawBytes(*profile);
    return profile;
}
} // namespace

Catalog::Catalog()
    : m_data(std::make_shared<const Data>())
{}

Catalog::Catalog(std::shared_ptr<const Data> data)
    : m_data(std::move(data))
{}

Catalog::LoadResult Catalog::load(const QStringList& userFolders)
{
    initResources();
    Loader loader;
    const QDir builtIn(QStringLiteral(":/models"));
    for (const QString& name :
         builtIn.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        loader.addFile(builtIn.filePath(name));
    for (const QString& folder : userFolders)
        loader.addFolder(folder);
    return loader.finish();
}

ProfilePtr Catalog::resolve(const Identity& identity) const
{
    const Version firmware{identity.firmwareMajor, identity.firmwareMinor};
    if (identity.protocol != base::Protocol::Feetech) {
        const SeriesDef* series = seriesByProtocol(*m_data, identity.protocol, firmware);
        return build(*m_data, identity, nullptr, series, orderOf(series));
    }
    const auto order = byteOrderOf(*m_data, identity, firmware);
    if (const auto conflict = familyConflict(*m_data, identity))
        return buildConflicting(*m_data, identity, *order, *conflict);
    const ModelEntry* model =
        order ? modelByNumber(*m_data, identity.modelMajor, identity.modelMinor, *order) : nullptr;
    const SeriesDef* series = order ? seriesByFirmware(*m_data, firmware, order) : nullptr;
    return build(*m_data, identity, model, series, order);
}

const ModelEntry* Catalog::model(const QString& name) const
{
    const QString normalized = normalizedModelName(name);
    const auto it =
        std::find_if(m_data->models.begin(), m_data->models.end(), [&](const ModelEntry& entry) {
            return normalizedModelName(entry.name) == normalized;
        });
    return it == m_data->models.end() ? nullptr : &*it;
}

const std::vector<ModelEntry>& Catalog::models() const
{
    return m_data->models;
}

ProfilePtr Catalog::profileFor(const ModelEntry& model, int firmwareMajor, int firmwareMinor) const
{
    const SeriesDef* named = seriesByKey(*m_data, model.series);
    if (named && named->protocol != base::Protocol::Feetech) {
        Identity identity;
        identity.protocol = named->protocol;
        if (named->protocol == base::Protocol::Modbus) {
            identity.firmwareMajor = firmwareMajor;
            identity.firmwareMinor = firmwareMinor;
        }
        return build(*m_data, identity, &model, named, named->byteOrder);
    }
    const bool big = model.byteOrder == base::ByteOrder::Big;
    const Identity identity{firmwareMajor, firmwareMinor, big ? 1 : 0, model.major, model.minor};
    const SeriesDef* series =
        seriesByFirmware(*m_data, {firmwareMajor, firmwareMinor}, model.byteOrder);
    return build(*m_data, identity, &model, series, model.byteOrder);
}

QStringList Catalog::mapKeys() const
{
    QStringList keys;
    for (const auto& [key, map] : m_data->maps)
        keys << key;
    return keys;
}

std::optional<Text> Catalog::registerName(const QString& mapKey, const QString& key) const
{
    const auto map = m_data->maps.find(mapKey);
    if (map == m_data->maps.end())
        return std::nullopt;
    for (const RegisterRow& row : map->second.rows) {
        if (row.base.reg.key == key)
            return row.base.reg.name;
    }
    return std::nullopt;
}
} // namespace catalog
