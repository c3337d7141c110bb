// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/definition.h"

#include <algorithm>
#include <map>

namespace catalog {
namespace {
std::optional<Version> versionOf(const ProfilePtr& servo)
{
    if (!servo || servo->identity.firmwareMajor < 0)
        return std::nullopt;
    return Version{servo->identity.firmwareMajor, servo->identity.firmwareMinor};
}

bool concerns(const FirmwareDef& firmware, const Identity& identity, base::ByteOrder order)
{
    if (firmware.protocol != identity.protocol || firmware.byteOrder != order)
        return false;
    if (!firmware.fromModel)
        return true;
    const Version model{identity.modelMajor, identity.modelMinor};
    return model >= *firmware.fromModel && model <= *firmware.toModel;
}
} // namespace

QString KnownFirmware::version() const
{
    return QStringLiteral("%1.%2").arg(major).arg(minor);
}

std::optional<KnownFirmware> Catalog::newerFirmware(const Profile& profile) const
{
    const Version running{profile.identity.firmwareMajor, profile.identity.firmwareMinor};
    if (running.major < 0 || running.minor < 0)
        return std::nullopt;
    const FirmwareDef* newest = nullptr;
    for (const FirmwareDef& firmware : m_data->firmware) {
        if (concerns(firmware, profile.identity, profile.byteOrder) && firmware.version > running &&
            (newest == nullptr || firmware.version >= newest->version))
            newest = &firmware;
    }
    if (newest == nullptr)
        return std::nullopt;
    // Models were sold with hardware of two families: the other's firmware is not for this one.
    Identity updated = profile.identity;
    updated.firmwareMajor = newest->version.major;
    updated.firmwareMinor = newest->version.minor;
    if (resolve(updated)->mapKey != profile.mapKey)
        return std::nullopt;
    return KnownFirmware{newest->version.major, newest->version.minor, newest->date,
                         newest->source};
}

std::optional<KnownFirmware> Catalog::firmwareOf(const Profile& profile) const
{
    for (const FirmwareDef& firmware : m_data->firmware) {
        if (concerns(firmware, profile.identity, profile.byteOrder))
            return KnownFirmware{firmware.version.major, firmware.version.minor, firmware.date,
                                 firmware.source};
    }
    return std::nullopt;
}

std::vector<bool> differingFirmware(const std::vector<ProfilePtr>& servos)
{
    std::map<QString, std::map<Version, int>> counts; // by model
    for (const ProfilePtr& servo : servos) {
        if (const auto version = versionOf(servo))
            ++counts[servo->identity.modelId()][*version];
    }
    std::vector<bool> differs;
    for (const ProfilePtr& servo : servos) {
        const auto version = versionOf(servo);
        if (!version) {
            differs.push_back(false);
            continue;
        }
        const auto& ofModel = counts[servo->identity.modelId()];
        const auto usual =
            std::max_element(ofModel.begin(), ofModel.end(), [](const auto& a, const auto& b) {
                return a.second < b.second || (a.second == b.second && a.first < b.first);
            });
        differs.push_back(usual->first != *version);
    }
    return differs;
}
} // namespace catalog
