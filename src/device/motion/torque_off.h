// SPDX-License-Identifier: GPL-3.0-or-later
// Torque off that is sent even where writing is refused: two servos on one ID, a family in doubt, a
// line that never falls silent. In every Feetech table, as in each other protocol, the torque
// switch has the same address, so the frame has the same effect on every servo that receives it.
// The job's thread.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// The WRITE that turns torque off.
struct TorqueOffWrite {
    int offset = 0;
    base::Bytes data{};
};
/// The address of the torque switch in every servo of this protocol.
TorqueOffWrite torqueOffFor(base::Protocol protocol);
/// By the servo's own table, or its protocol where no table is known; null: it has no switch.
std::optional<TorqueOffWrite> torqueOffOf(const Servo& servo);

/// Sends it without reading anything before. True: it was sent.
bool sendTorqueOff(const Context& context, Servo& servo);

/// After a failure with `why`: torque off is still sent. Success where reading then shows it and a
/// single servo answers; otherwise `why`, whose operation states that it was sent.
base::Result<void> forceTorqueOff(const Context& context, Servo& servo, base::Error why);

/// The same error, stating that torque off was sent although nothing proves it.
base::Error markUnverified(base::Error why);
bool isMarkedUnverified(const base::Error& error);

/// The same for an ID that could not be identified, in each of these protocols. Proves nothing.
base::Error forceTorqueOffUnidentified(const Context& context, int id,
                                       const std::vector<base::Protocol>& protocols,
                                       base::Error why);
} // namespace device
