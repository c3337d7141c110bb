// SPDX-License-Identifier: GPL-3.0-or-later
// How far a long task is and how long it still takes, the same words in the window and on the
// command line. Pure; any thread.
#pragma once

#include "base/clock.h"

#include <QString>

#include <optional>

namespace text {
/// "12 s", "1 min 20 s", "2 h 5 min".
QString durationText(base::Duration span);
/// "43 %, about 12 s left"; without an estimate only "43 %".
QString progressText(double fraction, std::optional<base::Duration> remaining);
} // namespace text
