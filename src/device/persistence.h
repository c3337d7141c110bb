// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a value survive power-off: an open lock, nothing at all, a save command. Pure
// functions on the register's description; any thread. Source: lock rules of the Feetech and Modbus
// sheets, "kept at power-off" of the LX sheet.
#pragma once

#include "catalog/register.h"

namespace device {
enum class Keeping : std::uint8_t {
    Lock,      ///< kept when the lock is open for its area
    Always,    ///< every write is kept
    Save,      ///< kept once the save command has been sent
    Never,     ///< lost at power-off
    NotStated, ///< nobody says
};
Keeping keepingOf(const catalog::Register& reg);

/// Can survive power-off: what recovery has to bring to one side or the other.
bool lasting(const catalog::Register& reg);

/// Writing it may wear memory that needs its time before it reads back.
bool takesTime(const catalog::Register& reg);

/// The value of the lock register under which writes to this area are kept.
std::int64_t openFor(catalog::Area area);

/// The value of the lock register that keeps nothing.
constexpr std::int64_t lockClosed = 1;

/// A lock that shows this is open for some area.
bool isOpen(std::int64_t lock);
} // namespace device
