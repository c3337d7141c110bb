// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/write_meaning.h"

#include "device/persistence.h"

namespace device {
using catalog::Role;

namespace {
WriteProcedure procedureOf(const catalog::Register& reg, std::int64_t raw)
{
    switch (reg.role) {
    case Role::Id:
        return WriteProcedure::Id;
    case Role::BaudRate:
        return WriteProcedure::BaudRate;
    case Role::TorqueSwitch:
        return valueName(reg, raw) == QLatin1String("center") ? WriteProcedure::Center
                                                              : WriteProcedure::Torque;
    case Role::Lock:
        return isLockOpen(raw) ? WriteProcedure::OpenLock : WriteProcedure::CloseLock;
    case Role::FaultReset:
        return (raw & centerBit) != 0 ? WriteProcedure::Center : WriteProcedure::Register;
    default:
        return WriteProcedure::Register;
    }
}
} // namespace

QString valueName(const catalog::Register& reg, std::int64_t raw)
{
    for (const catalog::NamedValue& value : reg.values) {
        if (value.value == raw && reg.encoding == catalog::Encoding::Enum)
            return value.key;
    }
    return {};
}

bool alwaysNeedsConsent(const catalog::Register& reg)
{
    return reg.dangerous;
}

WriteMeaning classify(const catalog::Register& reg, std::int64_t raw)
{
    WriteMeaning meaning;
    meaning.procedure = procedureOf(reg, raw);
    meaning.needsConsent = alwaysNeedsConsent(reg) || meaning.procedure == WriteProcedure::Center;
    meaning.moves = reg.motion && reg.role != Role::TorqueSwitch;
    meaning.enablesTorque = meaning.procedure == WriteProcedure::Torque && raw != 0;
    return meaning;
}
} // namespace device
