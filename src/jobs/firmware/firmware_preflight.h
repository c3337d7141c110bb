// SPDX-License-Identifier: GPL-3.0-or-later
// What is looked at before a firmware update: the bus, the file against the servo, and the supply,
// at rest and while the torque is switched on for a moment at the present position. Leaves torque
// off; writes nothing else. The servo's torque must be allowed to go off: the update restarts it.
// Errors: those that end a job, and of reading; NotSupported ("no-firmware-update") for families
// whose bootloader is not known.
#pragma once

#include "base/firmware_update.h"
#include "device/servo.h"
#include "jobs/firmware/firmware_file.h"
#include "jobs/job.h"

namespace jobs {
struct FirmwarePreflight {
    FirmwareFile file;
    base::Result<void> savedTable;       ///< whether the memory table is in a file
    std::optional<int> batteryPercent{}; ///< none: not running on a battery that is low
};

base::Result<std::vector<base::FirmwareCheckResult>>
checkFirmwareUpdate(const device::Context& context, device::Servo& servo,
                    const FirmwarePreflight& preflight, const ProgressFn& progress = {});
} // namespace jobs
