// SPDX-License-Identifier: GPL-3.0-or-later
// The baud rate a terminal device really has, odd rates included, and setting one on a pseudo-
// terminal. Linux knows any number (termios2); elsewhere only the standard rates are known.
#pragma once

#include <optional>

namespace transport {
/// nullopt when the system cannot report it.
std::optional<int> ttySpeed(int descriptor);

bool setTtySpeed(int descriptor, int baud);
} // namespace transport
