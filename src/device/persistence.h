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
    NotStated, ///< no sheet states it
};
Retention retentionOf(const catalog::Register& reg);

/// Can survive power-off, so recovery has to finish or undo it.
bool isPersistent(const catalog::Register& reg);

/// Its memory may need time before a write reads back.
bool needsWriteTime(const catalog::Register& reg);

/// The value of the lock register under which writes to this area are kept.
std::int64_t unlockValue(catalog::Area area);

/// The value of the lock register under which no write is kept.
constexpr std::int64_t lockClosed = 1;

/// Whether a lock with this value is open for some area.
bool isLockOpen(std::int64_t lock);
} // namespace device
