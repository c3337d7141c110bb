// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo_maker.h"

#include "protocol/request.h"
#include "sim/defect_list.h"
#include "sim/presets.h"
#include "sim/servo_types.h"

#include <QStringList>

#include <algorithm>

namespace sim {
namespace {
tl::unexpected<base::Error> badServo(const QString& item, const QString& why)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("simulate"),
                      QStringLiteral("%1: %2").arg(item, why));
}

/// A firmware that each simulated series was seen with, or that its map asks for. LX says nothing.
struct Firmware {
    const char* series;
    int major;
    int minor;
};
constexpr Firmware firmwares[] = {
    {"STS", 3, 10}, {"SMS", 2, 53},  {"SCS", 0, 4},    {"HLS", 3, 46},
    {"SMCL", 1, 6}, {"SCS2", 3, 24}, {"SMSMB", 20, 9}, {"LX", -1, -1},
};

const Firmware* firmwareOf(const QString& series)
{
    const auto* found =
        std::find_if(std::begin(firmwares), std::end(firmwares), [&](const Firmware& firmware) {
            return series == QLatin1String(firmware.series);
        });
    return found == std::end(firmwares) ? nullptr : found;
}

/// Shops add an M to the HLS models of the vendor's list.
const catalog::ModelEntry* findModel(const catalog::Catalog& catalog, const QString& name)
{
    const catalog::ModelEntry* model = catalog.model(name);
    if (model != nullptr || !name.endsWith(QLatin1Char('m'), Qt::CaseInsensitive))
        return model;
    model = catalog.model(name.chopped(1));
    return model != nullptr && model->series == QLatin1String("HLS") ? model : nullptr;
}

bool knowsRate(const catalog::Profile& profile, int baud)
{
    const catalog::Register* rate = profile.byRole(catalog::Role::BaudRate);
    if (rate == nullptr)
        return profile.defaultBaud == baud;
    return std::any_of(rate->values.begin(), rate->values.end(),
                       [baud](const auto& value) { return value.key == QString::number(baud); });
}

/// The middle of what the model may be fed, or what is usual where its sheet says nothing.
double supplyOf(const catalog::Profile& profile)
{
    if (!profile.minVoltage || !profile.maxVoltage)
        return servoType(profile).nominalVolts;
    return (*profile.minVoltage + *profile.maxVoltage) / 2;
}

/// Stations are counted from 1, and end where Modbus ends them.
bool knowsId(const catalog::Profile& profile, int id)
{
    const catalog::Register* reg = profile.byRole(catalog::Role::Id);
    return reg != nullptr && id >= reg->min.value_or(0) && id <= reg->max.value_or(protocol::maxId);
}

base::Result<VirtualServo> makeServo(const ServoRecipe& recipe, const catalog::Catalog& catalog,
                                     std::optional<base::Duration> epromTime, std::uint64_t seed)
{
    const QString item = QStringLiteral("%1@%2").arg(recipe.model).arg(recipe.id);
    const catalog::ModelEntry* model = findModel(catalog, recipe.model);
    if (model == nullptr)
        return badServo(item, QStringLiteral("no such model"));
    const Firmware* firmware = firmwareOf(model->series);
    if (firmware == nullptr || !model->supported)
        return badServo(item, QStringLiteral("this series cannot be simulated"));
    const auto profile = catalog.profileFor(*model, firmware->major, firmware->minor);
    if (!knowsId(*profile, recipe.id))
        return badServo(item, QStringLiteral("this model has no ID %1").arg(recipe.id));
    if (recipe.baud && !knowsRate(*profile, *recipe.baud))
        return badServo(item, QStringLiteral("this model has no rate %1").arg(*recipe.baud));
    ServoConfig config;
    config.id = recipe.id;
    config.baud = recipe.baud;
    config.load = recipe.load;
    config.surroundings.supplyVolts = recipe.supplyVolts.value_or(supplyOf(*profile));
    config.surroundings.supplyOhms = recipe.supplyOhms.value_or(config.surroundings.supplyOhms);
    config.surroundings.ambientCelsius =
        recipe.ambientCelsius.value_or(config.surroundings.ambientCelsius);
    config.defects = recipe.defects;
    config.initialDegrees = recipe.initialDegrees;
    config.epromTime = recipe.epromTime.value_or(epromTime.value_or(config.epromTime));
    config.behavior = recipe.behavior;
    config.seed = seed;
    VirtualServo servo(profile, config);
    if (recipe.prepare)
        recipe.prepare(servo);
    return servo;
}

base::Result<ServoRecipe> parseServo(const QString& item)
{
    const QString form = QStringLiteral("expected MODEL@ID or MODEL@ID:BAUD, +NAME=VALUE behind");
    QStringList words = item.split(QLatin1Char('+'));
    const QStringList halves = words.takeFirst().split(QLatin1Char('@'));
    if (halves.size() != 2 || halves[0].isEmpty())
        return badServo(item, form);
    const QStringList place = halves[1].split(QLatin1Char(':'));
    bool ok = false;
    ServoRecipe recipe;
    recipe.model = halves[0];
    recipe.id = place[0].toInt(&ok);
    if (!ok || place.size() > 2)
        return badServo(item, form);
    if (recipe.id < 0 || recipe.id > protocol::maxId)
        return badServo(item, QStringLiteral("an ID is 0 to 253"));
    if (place.size() == 2) {
        recipe.baud = place[1].toInt(&ok);
        if (!ok)
            return badServo(item, form);
    }
    if (auto added = addDefects(recipe, words); !added)
        return tl::unexpected(added.error());
    return recipe;
}
} // namespace

base::Result<std::unique_ptr<VirtualBus>> makeBus(const std::vector<ServoRecipe>& recipes,
                                                  const catalog::Catalog& catalog,
                                                  const WireConfig& wire,
                                                  std::optional<base::Duration> epromTime)
{
    auto bus = std::make_unique<VirtualBus>(wire);
    std::uint64_t seed = wire.seed;
    for (const ServoRecipe& recipe : recipes) {
        auto servo = makeServo(recipe, catalog, epromTime, seed++);
        if (!servo)
            return tl::unexpected(servo.error());
        bus->add(std::move(*servo));
    }
    return bus;
}

base::Result<std::unique_ptr<VirtualBus>>
makeServos(const QString& list, const catalog::Catalog& catalog, std::optional<int> baud,
           const WireConfig& wire, std::optional<base::Duration> epromTime)
{
    std::vector<ServoRecipe> recipes;
    for (const QString& part : list.split(QLatin1Char(','))) {
        auto recipe = parseServo(part.trimmed());
        if (!recipe)
            return tl::unexpected(recipe.error());
        if (!recipe->baud)
            recipe->baud = baud;
        recipes.push_back(std::move(*recipe));
    }
    return makeBus(recipes, catalog, wire, epromTime);
}
} // namespace sim
