// SPDX-License-Identifier: GPL-3.0-or-later
// How long a reading counts as the present state of a servo.
#pragma once

#include "base/clock.h"

namespace session {
/// An older one does not say how the servo is now.
inline constexpr base::Duration maxReadingAge = std::chrono::seconds(5);
} // namespace session
