// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and stop of long tasks. A job is a plain sequential function on the caller's
// thread; it writes as described in its header and returns a report or an error.
#pragma once

#include "device/context.h"

#include <functional>

namespace jobs {
struct Progress {
    double fraction = 0;                               ///< 0…1
    base::Duration remaining{};                        ///< estimate
    int found = 0;                                     ///< scan: servos so far
    int baud = 0;                                      ///< scan: rate being searched
    base::Protocol protocol = base::Protocol::Feetech; ///< scan: protocol being searched
};

using ProgressFn = std::function<void(const Progress&)>;
} // namespace jobs
