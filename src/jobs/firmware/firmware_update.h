// SPDX-License-Identifier: GPL-3.0-or-later
// Gives a servo a new firmware through its bootloader, from the vendor's file, whose bytes are
// passed on as they are. The first block the servo accepts destroys the old firmware; from then on
// a stop is no longer obeyed, and a servo that did not take every block stays in its bootloader
// until rescueFirmware() has brought it one. Owns the bus; leaves it at its old rate on every way
// out. Emergency stops end it. The job's thread. Not tried on real hardware by us. Source of the
// steps: kuterd/feetech-fw-util, 0o8o0-blip/sts3215-firmware.
#pragma once

#include "base/firmware_update.h"
#include "device/context.h"
#include "device/servo.h"
#include "jobs/firmware/firmware_file.h"
#include "jobs/job.h"
#include "snapshot/snapshot_compare.h"

namespace jobs {
struct FirmwareReport {
    base::FirmwareOutcome outcome = base::FirmwareOutcome::Unchanged;
    int sentBlocks = 0; ///< may have been accepted: also one whose reply is missing
    int acceptedBlocks = 0;
    int blocks = 0;
    int repeats = 0;                           ///< blocks that were refused and sent again
    std::optional<base::Error> error{};        ///< what ended it
    std::optional<device::Servo> servo{};      ///< as it answered afterwards
    std::optional<snapshot::Snapshot> table{}; ///< and its memory table, if it could be read
};

constexpr base::Duration rescueTime = std::chrono::seconds(30);

/// NotSupported ("no-firmware-update"): nothing is known of this family's bootloader.
base::Result<void> requireBootloader(const device::Servo& servo);

/// The kept settings that differ between the two tables of a servo.
std::vector<snapshot::CompareRow> changedSettings(const snapshot::Snapshot& before,
                                                  const snapshot::Snapshot& after);

/// Torque off, restart into the bootloader, the blocks, and wait for the servo at its old address.
/// Errors: what ends it before the restart; everything later is in the report.
base::Result<FirmwareReport> updateFirmware(const device::Context& context, device::Servo& servo,
                                            const FirmwareFile& file, const QString& program,
                                            const ProgressFn& progress = {});

/// For a servo that hangs in its bootloader, or has its supply switched off: calls for rescueTime
/// or until a bootloader answers, which any servo does whose supply comes on meanwhile, and then
/// goes on as above. Afterwards the servo is searched for: its ID and rate are not known here.
/// Errors: NoReply ("no-bootloader"), NotSupported ("rescue-not-alone": a servo answers as ever, so
/// that it could not be told from the rescued one).
base::Result<FirmwareReport> rescueFirmware(const device::Context& context,
                                            const FirmwareFile& file, const QString& program,
                                            const ProgressFn& progress = {});
} // namespace jobs
