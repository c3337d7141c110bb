// SPDX-License-Identifier: GPL-3.0-or-later
// The exit codes of the program, in one table. Pure.
#pragma once

#include "base/error.h"
#include "device/writer.h"

namespace cli {
enum Exit : int {
    Success = 0,
    Failed = 1, ///< the servo did not do it, or only a part of it
    Usage = 2,
    Port = 3,
    NoReply = 4,
    File = 5,
};

Exit exitCode(base::ErrorCode code);
Exit exitCode(const device::WriteReport& report);
Exit exitCode(device::LockState lock); ///< success only if it is known that the EPROM is locked
} // namespace cli
