// SPDX-License-Identifier: GPL-3.0-or-later
// A ready-made frame that takes torque off, for the emergency lane. A value; any thread.
#pragma once

#include "base/bytes.h"
#include "base/protocol.h"

namespace bus {
struct StopFrame {
    base::Protocol protocol = base::Protocol::Feetech;
    base::Bytes bytes;
};
} // namespace bus
