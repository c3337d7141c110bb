// SPDX-License-Identifier: GPL-3.0-or-later
// Any mixture of registers written as the table's user means it: torque and centering by their own
// manoeuvres, plain registers by the safe write, then rate and ID, after which the servo answers
// elsewhere. The job's thread. Errors as device::write and the jobs; what had ended before stands
// in the report.
#pragma once

#include "device/writer.h"

namespace session {
/// Before `items` are written back: each of `expected` must still hold its value, or already the
/// one it is to get. Otherwise Mismatch of operation "write-back" with the register as key and
/// "FOUND EXPECTED TARGET" as detail; IdentityMismatch and errors of reading besides. None
/// expected: nothing is asked.
base::Result<void> requireUnchanged(const device::Context& context, device::Servo& servo,
                                    const std::vector<device::WriteItem>& expected,
                                    const std::vector<device::WriteItem>& items);
bool isChangedSince(const base::Error& error);

base::Result<void> writeInOrder(const device::Context& context, device::Servo& servo,
                                const std::vector<device::WriteItem>& items,
                                const device::WriteOptions& options,
                                std::optional<device::WriteReport>& report);
} // namespace session
