// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore/restore_rows.h"

#include "catalog/raw_range.h"
#include "device/write_meaning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace jobs {
using catalog::Area;
using catalog::Encoding;
using catalog::Role;

namespace {
bool isLive(const catalog::Register& reg)
{
    const bool isVolatile = reg.area == Area::Sram || reg.area == Area::Feedback;
    return reg.writable() && isVolatile && (reg.motion || reg.role == Role::Lock);
}

/// Whether the file's unit and scale are the same here.
bool hasSameScale(const snapshot::SnapshotRegister& file, const catalog::ValueFormat& meaning)
{
    if (file.unit != meaning.unit)
        return false;
    if (!file.value)
        return true;
    constexpr double noise = 1e-6; // of one step; files keep twelve digits
    const double physicalValue = catalog::toPhysical(*file.raw, meaning);
    return std::abs(physicalValue - *file.value) <= noise * std::abs(meaning.scale);
}

std::optional<std::int64_t> baudCodeOf(const catalog::Register& reg, int baud)
{
    for (const catalog::NamedValue& value : reg.values) {
        if (value.key == QString::number(baud))
            return value.value;
    }
    return std::nullopt;
}

bool isEnumeration(Encoding encoding)
{
    return encoding == Encoding::Enum || encoding == Encoding::Bits;
}

/// From another family or firmware: by the meaning of the value.
std::optional<std::int64_t> convertedValue(RestoreRow& row, const catalog::Register& reg,
                                           const catalog::ValueFormat& meaning,
                                           const snapshot::SnapshotRegister& file,
                                           const Compatibility& compatibility)
{
    if (reg.role == Role::BaudRate)
        return compatibility.sameMap ? *file.raw : baudCodeOf(reg, compatibility.fileBaud);
    if (compatibility.sameMap && hasSameScale(file, meaning))
        return file.raw;
    if (reg.role == Role::Id)
        return file.raw;
    if (!compatibility.sameMap && isEnumeration(meaning.encoding))
        return std::nullopt; // the file has their numbers only, which differ between families
    if (hasSameScale(file, meaning)) {
        if (meaning.unit.isEmpty())
            row.reasons |= RestoreReason::PlainNumber;
        return file.raw;
    }
    if (meaning.unit.isEmpty() || meaning.unit != file.unit || !file.value)
        return std::nullopt;
    row.reasons |= RestoreReason::Converted;
    return catalog::toRaw(*file.value, meaning);
}

bool isAllowedValue(std::int64_t raw, const catalog::Register& reg,
                    const catalog::ValueFormat& meaning, std::optional<std::int64_t> now)
{
    const auto range = catalog::representableRange(reg.size, meaning.encoding, meaning.signBit);
    if (raw < range.min || raw > range.max)
        return false;
    return !reg.writable() || catalog::checkNewValue(raw, reg, meaning, now).has_value();
}
} // namespace

RestoreReasons registerReasons(const catalog::Register& reg)
{
    RestoreReasons reasons;
    reasons.setFlag(RestoreReason::ReadOnly, !reg.writable());
    reasons.setFlag(RestoreReason::Factory, reg.area == Area::Factory);
    reasons.setFlag(RestoreReason::Identity, reg.identity);
    reasons.setFlag(RestoreReason::Live, isLive(reg));
    reasons.setFlag(RestoreReason::MovesShaft, reg.role == Role::PositionOffset);
    if (!reg.writable())
        return reasons;
    reasons.setFlag(RestoreReason::OptIn, reg.area == Area::Sram && !isLive(reg));
    reasons.setFlag(RestoreReason::NeedsConsent, device::alwaysNeedsConsent(reg) && !reg.identity);
    return reasons;
}

bool isProtectionLimit(const catalog::Register& reg)
{
    switch (reg.role) {
    case Role::MinVoltage:
    case Role::MaxVoltage:
    case Role::MaxTemperature:
    case Role::MaxTorque:
    case Role::TorqueLimit:
    case Role::ProtectionCurrent:
    case Role::ProtectionTorque:
    case Role::OverloadTorque:
        return true;
    default:
        return false;
    }
}

namespace {
struct ProtectionLimit {
    Role limit;
    Role reading;
    bool lower; ///< a lower limit
    const char* fault;
};

constexpr std::array protectionLimits{
    ProtectionLimit{Role::MinVoltage, Role::PresentVoltage, true, "voltage"},
    ProtectionLimit{Role::MaxVoltage, Role::PresentVoltage, false, "voltage"},
    ProtectionLimit{Role::MaxTemperature, Role::PresentTemperature, false, "temperature"},
    ProtectionLimit{Role::ProtectionCurrent, Role::PresentCurrent, false, "current"},
    ProtectionLimit{Role::OverloadTorque, Role::PresentLoad, false, "overload"},
};
} // namespace

void predictAlarm(RestoreRow& row, const device::Servo& servo, const catalog::Register& reg)
{
    const auto protection =
        std::find_if(protectionLimits.begin(), protectionLimits.end(),
                     [&](const ProtectionLimit& one) { return one.limit == reg.role; });
    const catalog::Register* measured =
        protection != protectionLimits.end() ? servo.profile->byRole(protection->reading) : nullptr;
    const auto raw = measured != nullptr ? servo.raw(*measured) : std::nullopt;
    if (!raw || !row.newRaw)
        return;
    const catalog::ValueFormat meaning = servo.meaning(*measured);
    const catalog::ValueFormat limit = servo.meaning(reg);
    const double reading = std::abs(catalog::toPhysical(*raw, meaning));
    const auto outside = [&](std::int64_t value) {
        const double bound = catalog::toPhysical(value, limit);
        return protection->lower ? reading < bound : reading > bound;
    };
    if (meaning.unit != limit.unit || !outside(*row.newRaw) || (row.now && outside(*row.now)))
        return;
    row.reasons |= RestoreReason::WouldAlarm;
    row.alarm = QLatin1String(protection->fault);
    row.reading = reading;
    row.readingUnit = meaning.unit;
}

RestoreStage stageOf(const catalog::Register& reg)
{
    switch (reg.role) {
    case Role::Id:
        return RestoreStage::Id;
    case Role::BaudRate:
        return RestoreStage::Baud;
    case Role::MinAngle:
    case Role::MaxAngle:
    case Role::MinVoltage:
    case Role::MaxVoltage:
    case Role::MaxTemperature:
    case Role::MaxTorque:
        return RestoreStage::Limits;
    case Role::OperatingMode:
    case Role::Phase:
    case Role::AngleResolution:
    case Role::PositionOffset:
        return RestoreStage::Mode;
    case Role::PositionP:
    case Role::PositionI:
    case Role::PositionD:
    case Role::SpeedP:
    case Role::SpeedI:
    case Role::IntegralLimit:
    case Role::StartupForce:
        return RestoreStage::Gains;
    case Role::ReturnDelay:
    case Role::ResponseLevel:
        return RestoreStage::Link;
    default:
        return reg.area == Area::Sram ? RestoreStage::Live : RestoreStage::Rest;
    }
}

Compatibility compatibilityOf(const device::Servo& servo, const snapshot::Snapshot& snapshot)
{
    const catalog::Profile& profile = *servo.profile;
    Compatibility compatibility;
    compatibility.sameMap = snapshot.servo.map == profile.mapKey;
    compatibility.isSameKind = compatibility.sameMap &&
                               snapshot.servo.modelId == profile.identity.modelId() &&
                               snapshot.servo.firmware == profile.identity.firmware();
    compatibility.otherModel =
        !compatibility.sameMap || snapshot.servo.modelId != profile.identity.modelId();
    compatibility.fileBaud = snapshot.baud;
    return compatibility;
}

void mapValue(RestoreRow& row, const device::Servo& servo, const catalog::Register& reg,
              const snapshot::SnapshotRegister& file, const Compatibility& compatibility)
{
    const catalog::ValueFormat meaning = servo.meaning(reg);
    const auto newRaw = compatibility.isSameKind
                            ? file.raw
                            : convertedValue(row, reg, meaning, file, compatibility);
    if (!newRaw)
        row.reasons |= RestoreReason::OtherMeaning;
    else if (!isAllowedValue(*newRaw, reg, meaning, row.now))
        row.reasons |= RestoreReason::OutsideRange;
    row.newRaw = newRaw;
}
} // namespace jobs
