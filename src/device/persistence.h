// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a value survive power-off: an open lock, nothing at all, a save command. Pure
// functions on the register's description; any thread. Source: lock rules of the Feetech and Modbus
// sheets, "kept at power-off" of the LX sheet.
#pragma once

#include "catalog/register.h"

namespace device {
enum class Retention : std::uint8_t {
    Lock,      ///< kept when the lock is open for its area
    Always,    ///< every write is kept
    Save,      ///< kept once the save command has been sent
    Never,     ///< lost at power-off
    NotStated, ///< nobody says
};
Retention retentionOf(const catalog::Register& reg);

/// Can survive power-off: what recovery has to bring to one side or the other.
bool isPersistent(const catalog::Register& reg);

/// Writing it may wear memory that needs its time before it reads back.
bool needsWriteTime(const catalog::Register& reg);

/// The value of the lock register under which writes to this area are kept.
std::int64_t unlockValue(catalog::Area area);

/// The value of the lock register that keeps nothing.
constexpr std::int64_t lockClosed = 1;

/// A lock that shows this is open for some area.
bool isLockOpen(std::int64_t lock);
} // namespace device
