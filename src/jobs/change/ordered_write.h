// SPDX-License-Identifier: GPL-3.0-or-later
// The one way to write any mixture of registers, for window and command line: each as
// device::classify() says, torque and midpoint by their own procedures, other registers by the safe
// write, then baud rate and ID, after which the servo replies elsewhere. The job's thread. Errors
// as device::write and the jobs; the report has what was written before the error.
#pragma once

#include "device/writer.h"

namespace jobs {
/// Before `items` are written back: each of `expected` must still hold its value, or already its
/// new one. Otherwise Mismatch of operation "write-back" with the register as key and "FOUND
/// EXPECTED TARGET" as detail; also IdentityMismatch and errors of reading. With nothing expected
/// the servo is not asked.
base::Result<void> requireUnchanged(const device::Context& context, device::Servo& servo,
                                    const std::vector<device::WriteItem>& expected,
                                    const std::vector<device::WriteItem>& items);
bool isChangedSince(const base::Error& error);

/// Registers that are written by a procedure of their own: torque, midpoint, baud rate and ID.
enum class SpecialRegisters : std::uint8_t {
    Write,
    Refuse, ///< NotSupported, with the command that changes it, before the first byte
};

/// Without consent in `options` a register that needs it is refused before the first byte.
base::Result<void> writeInOrder(const device::Context& context, device::Servo& servo,
                                const std::vector<device::WriteItem>& items,
                                const device::WriteOptions& options, SpecialRegisters special,
                                std::optional<device::WriteReport>& report);
} // namespace jobs
