// SPDX-License-Identifier: GPL-3.0-or-later
// Changes after which a servo may have another address or another position: new ID, new rate,
// centering, restore, reboot. Each holds the servos it concerns, journals first, and leaves the
// lock closed at the address where the servo answers in the end; `servo` is updated to it.
#pragma once

#include "device/writer.h"
#include "jobs/job.h"

namespace jobs {
/// The factory ID of every family.
inline constexpr int factoryId = 1;

/// Proves the new ID free first (IdInUse); never 254. The acknowledgement may come from either ID.
base::Result<device::WriteReport> changeId(const device::Context& context, device::Servo& servo,
                                           int newId);

/// Proves first that this adapter can run the new rate. Tries the new rate, then the old. The bus
/// is left at the rate at which the servo answers.
base::Result<device::WriteReport> changeBaud(const device::Context& context, device::Servo& servo,
                                             int newBaud);

struct CenterReport {
    std::optional<std::int64_t> offsetBefore, offsetAfter;
    std::optional<std::int64_t> positionBefore, positionAfter;
    device::LockState lock = device::LockState::None;
};
/// The present position becomes the middle. Needs torque off afterwards; NotSupported on SCS.
base::Result<CenterReport> center(const device::Context& context, device::Servo& servo);

struct RestoreDefaultsReport {
    int oldId = -1, newId = -1;
    int oldBaud = 0, newBaud = 0;
    std::vector<QString> changed; ///< keys whose values differ now
    device::LockState lock = device::LockState::None;
};
/// 0x06. Looks for the servo afterwards at its old and at all other rates and IDs.
base::Result<RestoreDefaultsReport> restoreDefaults(const device::Context& context,
                                                    device::Servo& servo,
                                                    const ProgressFn& progress = {});

/// 0x08: torque off first; polls PING from 0.7 s on, at most 2 s. Returns milliseconds. A restart
/// is reported only with proof: the torque limit, which every start loads from the EPROM, or the
/// running time, which every start clears, is set one step off before; a servo that takes no such
/// mark must have been silent. Refused: by a Modbus exception,
/// "not-restarted", "restart-acknowledged" (it did not restart either), "restart-unproven".
base::Result<int> reboot(const device::Context& context, device::Servo& servo);
} // namespace jobs
