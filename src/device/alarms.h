// SPDX-License-Identifier: GPL-3.0-or-later
// What ails a servo: reported in every reply, read from a status register, or, where the servo
// reports nothing (LX), worked out from its limits and said to be so. The job's thread.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// After a read of these bytes: the status register becomes the servo's status, where replies have
/// no error byte. Bits that are no fault (torque is on) are left out.
void updateStatus(Servo& servo, int offset, int count);

/// Whether a fault bit with one of these keys is set in its status.
bool hasFault(const Servo& servo, const QStringList& faults);

/// Temperature and voltage against the servo's own limits, from what has been read; for servos
/// that report no faults themselves. DerivedTemperature and DerivedVoltage.
std::vector<Notice> derivedAlarms(const Servo& servo);

/// What keeps an alarm alive and what releases it, as notices (facts §7 of the protocol sheet).
/// Reads what it needs where replies tell nothing; what cannot be read is left out.
void addAlarmNotices(const Context& context, Servo& servo);
} // namespace device
