// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/servos/servo_entry.h"

#include "device/persistence.h"

#include <algorithm>

namespace session {
std::optional<bool> ServoEntry::isLockOpen() const
{
    const auto lock = servo.profile ? servo.raw(catalog::Role::Lock) : std::nullopt;
    return lock ? std::optional(device::isLockOpen(*lock)) : std::nullopt;
}

std::optional<std::int64_t> ServoEntry::displayedRaw(const catalog::Register& reg) const
{
    return unreadable.count(reg.key) > 0 ? std::nullopt : servo.raw(reg);
}

std::optional<std::int64_t> ServoEntry::firstRaw(const catalog::Register& reg) const
{
    const auto bytes = firstImage.bytes(reg.offset, reg.size);
    if (!bytes || !servo.profile)
        return std::nullopt;
    return catalog::decodeRaw(*bytes, reg, servo.meaning(reg), servo.profile->byteOrder);
}

bool ServoEntry::writing() const
{
    return std::any_of(writes.begin(), writes.end(),
                       [](const auto& row) { return row.second.pending > 0; });
}
} // namespace session
