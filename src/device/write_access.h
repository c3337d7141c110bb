// SPDX-License-Identifier: GPL-3.0-or-later
// May this servo be written to? Asked by every path before its first byte, and once more by the
// frames themselves: is its family known and unambiguous, and does it answer alone. The job's
// thread.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// By what it says of itself: UnknownModel, or FamilyConflict with the facts in its detail.
base::Result<void> requireWritable(const Servo& servo, const QString& operation);

/// The same and the byte at the lock's place, as far as it has been read: for whoever shows the
/// servo. Null: nothing speaks against writing.
std::optional<base::Error> writeObstacle(const Servo& servo);

/// For whoever keeps what is read: DuplicateId where a second one seems to answer under its ID.
/// Errors of reading besides.
base::Result<void> requireUniqueId(const Context& context, const Servo& servo,
                                   const QString& operation);

/// Asks the servo who it is, by one short read: a servo can be exchanged on the open line, and no
/// byte of the next write would show it. IdentityMismatch as below; errors of reading besides.
base::Result<void> requireSameServo(const Context& context, const Servo& servo,
                                    const QString& operation);

/// The above, and asks the servo who it is: one that was exchanged since it was identified is
/// IdentityMismatch, with the model found as detail (an LX servo tells nothing to compare). Where
/// this connection has not written to the servo before: looks whether a second one answers under
/// its ID (DuplicateId) and what stands at the lock's place. Remembered on the bus once it is
/// well. Neither delays nor refuses what belongs to an emergency stop. Errors of reading besides.
base::Result<void> beginWriting(const Context& context, const Servo& servo,
                                const QString& operation);

/// The same for a manoeuvre that may be a step of a larger one: a hold that was taken before has
/// asked already.
base::Result<void> beginWriting(const Owned& owned, const Servo& servo, const QString& operation);

/// For the frames themselves, after beginWriting(): the same, without asking a verified servo
/// again.
base::Result<void> requireVerified(const Context& context, const Servo& servo,
                                   const QString& operation);

/// After a change of ID or rate: where the servo answers now it needs no second look, and whoever
/// is plugged in where it was needs one.
void transferVerification(bus::Bus& bus, const Servo& servo, int oldId, int oldBaud);
} // namespace device
