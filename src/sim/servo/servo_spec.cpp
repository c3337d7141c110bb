// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_spec.h"

#include "protocol/request.h"
#include "sim/faults/defect_list.h"
#include "sim/host/presets.h"
#include "sim/servo/servo_types.h"

#include <QStringList>

#include <algorithm>

namespace sim {
namespace {
tl::unexpected<base::Error> invalidServo(const QString& item, const QString& why)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("simulate"),
                      QStringLiteral("%1: %2").arg(item, why));
}

/// A firmware that each simulated series was seen with, or that its map requires. LX reports none.
struct Firmware {
    const char* series;
    int major;
    int minor;
};
constexpr Firmware defaultFirmwares[] = {
    {"STS", 3, 10}, {"SMS", 2, 53},  {"SCS", 0, 4},    {"HLS", 3, 46},
    {"SMCL", 1, 6}, {"SCS2", 3, 24}, {"SMSMB", 20, 9}, {"LX", -1, -1},
};

const Firmware* firmwareOf(const QString& series)
{
    const auto* found = std::find_if(
        std::begin(defaultFirmwares), std::end(defaultFirmwares),
        [&](const Firmware& firmware) { return series == QLatin1String(firmware.series); });
    return found == std::end(defaultFirmwares) ? nullptr : found;
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

bool supportsBaud(const catalog::Profile& profile, int baud)
{
    const catalog::Register* rate = profile.byRole(catalog::Role::BaudRate);
    if (profile.protocol == base::Protocol::Lx) // no register, and yet seen at others (LX sheet)
        return baud > 0;
    if (rate == nullptr)
        return profile.defaultBaud == baud;
    return std::any_of(rate->values.begin(), rate->values.end(),
                       [baud](const auto& value) { return value.key == QString::number(baud); });
}

/// The middle of the model's supply range, or a typical value where its sheet states none.
double supplyOf(const catalog::Profile& profile)
{
    if (!profile.minVoltage || !profile.maxVoltage)
        return servoType(profile).nominalVolts;
    return (*profile.minVoltage + *profile.maxVoltage) / 2;
}

/// Stations are counted from 1, and end where Modbus ends them.
bool supportsId(const catalog::Profile& profile, int id)
{
    const catalog::Register* reg = profile.byRole(catalog::Role::Id);
    return reg != nullptr && id >= reg->min.value_or(0) && id <= reg->max.value_or(protocol::maxId);
}

/// How far servos of one model differ on a bench. No sheet states the figures; chosen.
constexpr double restingDegrees = 30;
constexpr double cableVolts = 0.1;
constexpr double roomCelsius = 1.5;

void setResting(ServoConfig& config, const ServoSpec& servoSpec, const catalog::Profile& profile,
                std::optional<std::uint64_t> seed)
{
    SeededRandom random(seed.value_or(0));
    const auto differing = [&](double most) { return seed ? random.within(most) : 0; };
    config.initialDegrees =
        servoSpec.initialDegrees.value_or(config.initialDegrees + differing(restingDegrees));
    config.environment.supplyVolts =
        servoSpec.supplyVolts.value_or(supplyOf(profile) + differing(cableVolts));
    config.environment.ambientCelsius = servoSpec.ambientCelsius.value_or(
        config.environment.ambientCelsius + differing(roomCelsius));
}

base::Result<VirtualServo> makeServo(const ServoSpec& servoSpec, const catalog::Catalog& catalog,
                                     std::optional<base::Duration> epromTime, std::uint64_t seed,
                                     bool identicalServos)
{
    const QString item = QStringLiteral("%1@%2").arg(servoSpec.model).arg(servoSpec.id);
    const catalog::ModelEntry* model = findModel(catalog, servoSpec.model);
    if (model == nullptr)
        return invalidServo(item, QStringLiteral("no such model"));
    const Firmware* firmware = firmwareOf(model->series);
    if (firmware == nullptr || !model->supported)
        return invalidServo(item, QStringLiteral("this series cannot be simulated"));
    const auto profile = catalog.profileFor(*model, firmware->major,
                                            servoSpec.firmwareMinor.value_or(firmware->minor));
    if (!supportsId(*profile, servoSpec.id))
        return invalidServo(item, QStringLiteral("this model has no ID %1").arg(servoSpec.id));
    if (servoSpec.baud && !supportsBaud(*profile, *servoSpec.baud))
        return invalidServo(item, QStringLiteral("this model has no rate %1").arg(*servoSpec.baud));
    ServoConfig config;
    config.id = servoSpec.id;
    config.baud = servoSpec.baud;
    config.load = servoSpec.load;
    setResting(config, servoSpec, *profile, identicalServos ? std::nullopt : std::optional(seed));
    config.environment.supplyOhms = servoSpec.supplyOhms.value_or(config.environment.supplyOhms);
    config.defects = servoSpec.defects;
    config.epromTime = servoSpec.epromTime.value_or(epromTime.value_or(config.epromTime));
    config.behavior = servoSpec.behavior;
    config.timing = identicalServos ? ReplyTiming() : ReplyTiming(seed);
    config.seed = seed;
    VirtualServo servo(profile, config);
    if (servoSpec.prepare)
        servoSpec.prepare(servo);
    return servo;
}

base::Result<ServoSpec> parseServo(const QString& item)
{
    const QString form = QStringLiteral("expected MODEL@ID or MODEL@ID:BAUD, +NAME=VALUE behind");
    QStringList words = item.split(QLatin1Char('+'));
    const QStringList modelAndRest = words.takeFirst().split(QLatin1Char('@'));
    if (modelAndRest.size() != 2 || modelAndRest[0].isEmpty())
        return invalidServo(item, form);
    const QStringList idAndBaud = modelAndRest[1].split(QLatin1Char(':'));
    bool ok = false;
    ServoSpec servoSpec;
    servoSpec.model = modelAndRest[0];
    servoSpec.id = idAndBaud[0].toInt(&ok);
    if (!ok || idAndBaud.size() > 2)
        return invalidServo(item, form);
    if (servoSpec.id < 0 || servoSpec.id > protocol::maxId)
        return invalidServo(item, QStringLiteral("an ID is 0 to 253"));
    if (idAndBaud.size() == 2) {
        servoSpec.baud = idAndBaud[1].toInt(&ok);
        if (!ok)
            return invalidServo(item, form);
    }
    if (auto added = addDefects(servoSpec, words); !added)
        return tl::unexpected(added.error());
    return servoSpec;
}
} // namespace

base::Result<std::unique_ptr<VirtualBus>> makeBus(const std::vector<ServoSpec>& servoSpecs,
                                                  const catalog::Catalog& catalog,
                                                  const WireConfig& wire,
                                                  std::optional<base::Duration> epromTime)
{
    auto bus = std::make_unique<VirtualBus>(wire);
    std::uint64_t seed = wire.seed;
    for (const ServoSpec& servoSpec : servoSpecs) {
        auto servo = makeServo(servoSpec, catalog, epromTime, seed++, wire.identicalServos);
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
    std::vector<ServoSpec> servoSpecs;
    for (const QString& part : list.split(QLatin1Char(','))) {
        auto servoSpec = parseServo(part.trimmed());
        if (!servoSpec)
            return tl::unexpected(servoSpec.error());
        if (!servoSpec->baud)
            servoSpec->baud = baud;
        servoSpecs.push_back(std::move(*servoSpec));
    }
    return makeBus(servoSpecs, catalog, wire, epromTime);
}
} // namespace sim
