// SPDX-License-Identifier: GPL-3.0-or-later
// The alarms of a servo: reported in every reply, read from a status register, or, where the servo
// reports none (LX), derived from its limits and marked as derived. The job's thread.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// After a read of these bytes: where replies have no error byte, the status register becomes the
/// servo's status. Bits that are no fault (torque is on) are left out.
void updateStatus(Servo& servo, int offset, int count);

/// Whether a fault bit with one of these keys is set in its status.
bool hasFault(const Servo& servo, const QStringList& faults);

/// Compares temperature and voltage with the servo's own limits, on the values read so far; for
/// servos that report no faults themselves. DerivedTemperature and DerivedVoltage.
std::vector<Notice> derivedAlarms(const Servo& servo);

/// The cause of each alarm and how to clear it, as notices (facts §7 of the protocol sheet). Reads
/// what it needs where replies carry no status; what cannot be read is left out.
void addAlarmNotices(const Context& context, Servo& servo);
} // namespace device
