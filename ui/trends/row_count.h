// SPDX-License-Identifier: GPL-3.0-or-later
// The number of rows of a recording, for tr(), which takes an int. Pure function.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace ui {
inline int rowCount(std::uint64_t rows)
{
    return int(std::min<std::uint64_t>(rows, std::numeric_limits<int>::max()));
}
} // namespace ui
