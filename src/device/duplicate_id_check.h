// SPDX-License-Identifier: GPL-3.0-or-later
// Do two servos answer under one ID? Reads the registers that distinguish servos a few times,
// listens as long as replies on this link may be late, and looks for what one servo could not send:
// a second reply to one request, settings that differ between two readings, a jump no shaft can
// make, replies that collide. Only READs. Two servos with the same content that answer in step look
// like one. The job's thread.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
enum class DuplicateIdSign : std::uint8_t {
    None,            ///< one servo answers
    SecondReply,     ///< repeatedly two replies came to one request
    DifferentValues, ///< repeatedly readings that one servo could not give
    BrokenReplies,   ///< too many unreadable replies: noise or a collision
};

struct DuplicateIdResult {
    DuplicateIdSign sign = DuplicateIdSign::None;
    int reads = 0;
    int broken = 0;
    /// The value of the lock register; null: the map has none.
    std::optional<std::int64_t> lock;
};

/// NoReply when too few replies came for a result; Stopped, LinkLost, Preempted, Held.
base::Result<DuplicateIdResult> checkDuplicateId(const Context& context, const Servo& servo);

/// Could one servo have given both readings, `apart` from one another?
bool canBeOneServo(const Servo& before, const Servo& after, base::Duration apart);
} // namespace device
