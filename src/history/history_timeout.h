// SPDX-License-Identifier: GPL-3.0-or-later
// How long access to the history waits for another program that is writing to it. A command
// needs it twice (the table before a write, then the journal) and must report within two seconds
// that it is locked; a transaction of this program takes some milliseconds.
#pragma once

#include <chrono>

namespace history {
constexpr std::chrono::milliseconds historyTimeout{600};
} // namespace history
