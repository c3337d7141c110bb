// SPDX-License-Identifier: GPL-3.0-or-later
// What a register's bytes can hold at all, and the words its values go by. Shared by the value
// functions and the loader. Pure functions; any thread.
#pragma once

#include "catalog/register.h"

namespace catalog {
struct RawRange {
    std::int64_t min = 0;
    std::int64_t max = 0;
};

/// Raw numbers that survive the way through `size` bytes.
RawRange representableRange(int size, Encoding encoding, int signBit);

/// "off, on, damp": the keys of a register's values.
QString valueKeys(const Register& reg);
} // namespace catalog
