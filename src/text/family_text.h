// SPDX-License-Identifier: GPL-3.0-or-later
// Why nothing is written to a servo whose family is unclear, or under an ID that two servos share:
// the facts that were found. Pure functions; any thread.
#pragma once

#include "base/error.h"

namespace text {
/// Empty for every other error.
QString writeRefusedMessage(const base::Error& error);
QString writeRefusedCause(const base::Error& error);
QString writeRefusedRemedy(const base::Error& error);
} // namespace text
