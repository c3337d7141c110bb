// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/factory_snapshot.h"

#include "catalog/value.h"

namespace snapshot {
namespace {
/// The known values of a new servo: the defaults of the sheet, and the identity that selected the
/// profile.
std::optional<std::int64_t> factoryRaw(const catalog::Register& reg,
                                       const catalog::Identity& identity)
{
    using catalog::Role;
    const auto known = [](int number) {
        return number >= 0 ? std::optional<std::int64_t>(number) : std::nullopt;
    };
    switch (reg.role) {
    case Role::FirmwareMajor:
        return known(identity.firmwareMajor);
    case Role::FirmwareMinor:
        return known(identity.firmwareMinor);
    case Role::ModelMajor:
        return known(identity.modelMajor);
    case Role::ModelMinor:
        return known(identity.modelMinor);
    default:
        return reg.defaultRaw;
    }
}

/// "9.3" → 9, 3; -1 for other texts.
std::pair<int, int> parseVersionPair(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('.'));
    bool majorKnown = false;
    bool minorKnown = false;
    const int major = parts.value(0).toInt(&majorKnown);
    const int minor = parts.value(1).toInt(&minorKnown);
    return parts.size() == 2 && majorKnown && minorKnown ? std::pair{major, minor}
                                                         : std::pair{-1, -1};
}
} // namespace

Snapshot factorySnapshot(const catalog::Profile& profile)
{
    const catalog::Lookup lookup = [&](const QString& key) -> std::optional<std::int64_t> {
        const catalog::Register* reg = profile.find(key);
        return reg != nullptr ? factoryRaw(*reg, profile.identity) : std::nullopt;
    };
    Snapshot snapshot;
    snapshot.baud = profile.defaultBaud.value_or(0);
    snapshot.servo = {-1,
                      profile.modelName,
                      profile.identity.modelId(),
                      profile.identity.firmware(),
                      profile.mapKey,
                      base::protocolName(profile.protocol)};
    for (const catalog::Register& reg : profile.registers) {
        const catalog::ValueFormat meaning = catalog::valueFormat(reg, profile, lookup);
        SnapshotRegister row;
        row.key = reg.key;
        row.address = reg.address;
        row.raw = factoryRaw(reg, profile.identity);
        if (row.raw)
            row.value = catalog::toPhysical(*row.raw, meaning);
        row.unit = meaning.unit;
        row.area = reg.area;
        row.access = reg.access;
        snapshot.registers.push_back(std::move(row));
    }
    return snapshot;
}

catalog::ProfilePtr profileOf(const Snapshot& snapshot, const catalog::Catalog& catalog)
{
    const SnapshotServo& servo = snapshot.servo;
    const auto protocol = base::protocolFromName(servo.protocol);
    if (!protocol)
        return nullptr;
    catalog::Identity identity;
    identity.protocol = *protocol;
    std::tie(identity.modelMajor, identity.modelMinor) = parseVersionPair(servo.modelId);
    std::tie(identity.firmwareMajor, identity.firmwareMinor) = parseVersionPair(servo.firmware);
    const SnapshotRegister* order = snapshot.find(QStringLiteral("byte_order"));
    const std::int64_t flag = order != nullptr ? order->raw.value_or(-1) : -1;
    if (flag == 0 || flag == 1)
        identity.byteOrderFlag = static_cast<int>(flag);
    catalog::ProfilePtr profile = catalog.resolve(identity);
    return profile->mapKey == servo.map ? profile : nullptr;
}
} // namespace snapshot
