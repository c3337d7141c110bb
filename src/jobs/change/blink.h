// SPDX-License-Identifier: GPL-3.0-or-later
// Makes one servo recognizable among many: its LED blinks, then its setting is restored. Feetech:
// the LED condition is 0 (off) or not (on), written with the lock closed, so that the EPROM does
// not wear and a power-off restores it as well. LX keeps every write, so it blinks slower.
// Journaled: recovery restores the setting after an interruption, when it finishes and when it
// undoes. Nothing moves.
#pragma once

#include "device/writer.h"
#include "jobs/job.h"

namespace jobs {
struct BlinkReport {
    QString key;             ///< the register that was used
    std::int64_t before = 0; ///< the value it has again
    int blinks = 0;
    bool stopped = false; ///< by the user, before the time was over
};

constexpr base::Duration blinkTime = std::chrono::seconds(6);

/// Stop ends it within 100 ms, with the LED restored. NotSupported ("no-led", "factory-led") before
/// the first byte; otherwise the errors of reading and writing, after trying to restore the LED.
base::Result<BlinkReport> blink(const device::Context& context, device::Servo& servo,
                                base::Duration time = blinkTime, const ProgressFn& progress = {});
} // namespace jobs
