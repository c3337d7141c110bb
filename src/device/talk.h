// SPDX-License-Identifier: GPL-3.0-or-later
// The few sentences every manoeuvre says to one servo. Keeps its image and status up to date with
// every reply. The job's thread; errors are those of bus::Bus::transact.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// Time an EPROM write is given before it is read back. No official figure exists; the sheet
/// advises 10–20 ms.
constexpr base::Duration epromWriteTime = std::chrono::milliseconds(20);

base::Result<void> readBlock(const Context& context, Servo& servo, int address, int count);
base::Result<std::int64_t> readRegister(const Context& context, Servo& servo,
                                        const catalog::Register& reg);

/// The bytes as they go into the frame, in the servo's byte order and encoding.
base::Bytes wireBytes(const Servo& servo, const catalog::Register& reg, std::int64_t raw);

/// One WRITE frame. Does not read back.
base::Result<void> writeBlock(const Context& context, Servo& servo, int address, base::Bytes data,
                              protocol::Repeat repeat);

/// True when a request went out and only its answer is missing: reading tells what happened.
bool answerLost(const base::Error& error);

/// A WRITE that may be repeated; where its answer is lost, or never comes (response level 0), the
/// block is read back and decides. Refused when it does not show what was written.
base::Result<void> writeProven(const Context& context, Servo& servo, int address,
                               const base::Bytes& data);

/// Writes and reads back, once more if the servo still shows the old value. Ends in Mismatch when
/// it shows anything else than `raw`. For registers that may be repeated.
base::Result<void> writeVerified(const Context& context, Servo& servo, const catalog::Register& reg,
                                 std::int64_t raw);
} // namespace device
