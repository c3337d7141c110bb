// SPDX-License-Identifier: GPL-3.0-or-later
// Where a row of a map lies: from the address as the sheet prints it (byte, Modbus register, LX
// command) to bytes of the flat table that requests count in (protocol/request.h), and which rows
// travel together. Pure functions; any thread.
#pragma once

#include "catalog/json_fields.h"

namespace catalog {
inline constexpr int tableBytes = 1024; ///< every offset of every language lies below

/// address and size; LX also place, write and save. Complains about what lies outside the table.
void readLocation(JsonFields& fields, Register& reg, base::Protocol protocol);

/// Gives every row of an LX map its block: all rows with the same read command.
void assignBlocks(MapDef& map);
} // namespace catalog
