// SPDX-License-Identifier: GPL-3.0-or-later
// Reading by register: keys become the fewest block reads that cover them. Fills the servo's image.
// Errors are those of bus::Bus::transact, plus UnknownRegister, and NotSupported ("not-readable")
// for registers that this servo never reports.
#pragma once

#include "bus/poll.h"
#include "device/context.h"
#include "device/servo.h"

#include <QStringList>

namespace device {
/// The blocks that cover these registers. Gaps are included as far as the profile allows, because a
/// few bytes cost less than another transaction; registers that travel as a block stay together.
std::vector<bus::PollSpan> planSpans(const catalog::Profile& profile,
                                     const std::vector<const catalog::Register*>& registers);

/// Reads the identity of the servo (Feetech: registers 0–8, equal in all tables; Modbus: 0–3;
/// LX: its ID and nothing else) and chooses the profile. Writes nothing.
base::Result<Servo> identify(const Context& context, int id,
                             base::Protocol protocol = base::Protocol::Feetech);

/// The servo that answers to `id` in one of these protocols. AmbiguousProtocol if it is more than
/// one: two servos share the ID, and it is not clear which is meant. NoReply when all are silent.
base::Result<Servo> identifyAmong(const Context& context, int id,
                                  const std::vector<base::Protocol>& protocols);

base::Result<void> read(const Context& context, Servo& servo,
                        const std::vector<const catalog::Register*>& registers);
base::Result<void> readKeys(const Context& context, Servo& servo, const QStringList& keys);
base::Result<void> readRoles(const Context& context, Servo& servo,
                             const std::vector<catalog::Role>& roles);
/// The whole readable table (STS: 2 transactions). Registers that this servo never reports (stored
/// move of some LX) stay unread, which is no error.
base::Result<void> readAll(const Context& context, Servo& servo);
/// The registers that decide what others mean: modes, limits, phase, factor, level, torque, lock;
/// not the stored move.
base::Result<void> readSettings(const Context& context, Servo& servo);
/// Whether all of them were read at this time of the bus clock or later.
bool settingsReadSince(const Servo& servo, base::Duration since);
} // namespace device
