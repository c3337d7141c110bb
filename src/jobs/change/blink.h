// SPDX-License-Identifier: GPL-3.0-or-later
// Makes one servo recognizable among many: its LED blinks, then its setting is put back as it was.
// Feetech: the LED condition is 0 (off) or not (on), written with the lock closed, so that nothing
// wears and a power-off puts it back as well. LX keeps every write, so it blinks slower.
// Journalled: an interrupted one is put back by recovery, whichever way it is settled. Nothing
// moves.
#pragma once

#include "device/writer.h"
#include "jobs/job.h"

namespace jobs {
struct BlinkReport {
    QString key;             ///< the register that was used
    std::int64_t before = 0; ///< and holds again
    int blinks = 0;
    bool stopped = false; ///< by the user, before the time was over
};

constexpr base::Duration blinkTime = std::chrono::seconds(6);

/// Stop ends it within 100 ms, LED put back. NotSupported ("no-led", "factory-led") before the
/// first byte; otherwise the errors of reading and writing, after trying to put the LED back.
base::Result<BlinkReport> blink(const device::Context& context, device::Servo& servo,
                                base::Duration time = blinkTime, const ProgressFn& progress = {});
} // namespace jobs
