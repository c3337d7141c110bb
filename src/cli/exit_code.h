// SPDX-License-Identifier: GPL-3.0-or-later
// What the program's exit code says, in one table. Pure.
#pragma once

#include "base/error.h"
#include "device/writer.h"

namespace cli {
enum Exit : int {
    Success = 0,
    Failed = 1, ///< the servo did not do it, or not all that was asked for
    Usage = 2,
    Port = 3,
    NoReply = 4,
    File = 5,
};

Exit exitCode(base::ErrorCode code);
Exit exitCode(const device::WriteReport& report);
} // namespace cli
