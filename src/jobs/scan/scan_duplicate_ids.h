// SPDX-License-Identifier: GPL-3.0-or-later
// Do two servos answer under one ID? Reads the feedback twice, and after any failure the identity
// again, and looks for what one servo could not send: repeatedly broken checksums, a second reply
// to one request, another identity, a jump no shaft can make. Only READs. Used by scan() only,
// which asks many servos quickly; before a write device/duplicate_id_check.h checks more closely.
// Its thread.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace jobs {
/// True: suspected. False proves nothing. `servo` has been identified and gets the feedback read.
/// Stopped, LinkLost, Preempted, Held.
base::Result<bool> suspectDuplicateId(const device::Context& context, device::Servo& servo);
} // namespace jobs
