// SPDX-License-Identifier: GPL-3.0-or-later
// How one servo that was found replies: lost, damaged and late replies, a second servo on its ID,
// writes that it does not acknowledge. Only reads and PINGs. Job thread; used by diagnose() only.
// Errors: LinkLost, Preempted, Held, Stopped.
#pragma once

#include "base/diagnosis.h"
#include "device/duplicate_id_check.h"
#include "jobs/scan/scan.h"

namespace jobs {
struct ServoProbe {
    int id = 0;
    int baud = 0;
    base::Protocol protocol = base::Protocol::Feetech;
    int asked = 0;
    int lost = 0;
    int damaged = 0;
    base::Duration replyTime{}; ///< median beyond the time on the wire; 0: no reply
    bool duplicateSuspected = false;
    std::optional<device::DuplicateIdResult> duplicate; ///< checked where it was suspected
    bool acknowledges = true;
};

/// `servos`: how many are probed; with many each one is asked less often.
base::Result<ServoProbe> probeServo(const device::Context& context, const FoundServo& found,
                                    int servos);

/// What is wrong with it.
std::vector<base::Evidence> evidenceOf(const ServoProbe& probe);
} // namespace jobs
