// SPDX-License-Identifier: GPL-3.0-or-later
// Do two servos answer under one ID? Reads what tells servos apart a few times, listens as long as
// this link may be late, and looks for what one servo could not say: a second reply to one request,
// settings that differ between two readings, a jump no shaft can make, replies that collide. Only
// READs. Two servos with the same content that answer in step cannot be told apart. The job's
// thread.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
enum class DuplicateIdSign : std::uint8_t {
    None,            ///< one servo answers
    SecondReply,     ///< repeatedly two replies came to one request
    DifferentValues, ///< repeatedly readings that one servo could not give
    BrokenReplies,   ///< too many replies were unreadable to tell noise from a collision
};

struct DuplicateIdResult {
    DuplicateIdSign sign = DuplicateIdSign::None;
    int reads = 0;
    int broken = 0;
    /// What stands in the lock register; null: the map has none.
    std::optional<std::int64_t> lock;
};

/// NoReply when too little was answered to tell; Stopped, LinkLost, Preempted, Held.
base::Result<DuplicateIdResult> checkDuplicateId(const Context& context, const Servo& servo);

/// Could one servo have said both, `apart` from one another?
bool canBeOneServo(const Servo& before, const Servo& after, base::Duration apart);
} // namespace device
