// SPDX-License-Identifier: GPL-3.0-or-later
// The few transactions with one servo that every operation is made of, and their frames. Keeps its
// image and status up to date with every reply. The job's thread; errors are those of
// bus::Bus::transact.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// Time between an EPROM write and its read-back. No official figure exists; the sheet advises
/// 10–20 ms.
constexpr base::Duration epromWriteTime = std::chrono::milliseconds(20);

/// False when this servo's protocol has no such request. Sends nothing.
bool canEncode(const Servo& servo, const protocol::Request& request);

/// One PING, not repeated.
base::Result<bus::Outcome> pingOnce(const Context& context, base::Protocol protocol, int id,
                                    base::Duration timeout);

/// `retries` −1: the bus' default.
base::Result<void> readBlock(const Context& context, Servo& servo, int offset, int count,
                             int retries = -1);
/// Reads it, with the block that it travels in.
base::Result<std::int64_t> readRegister(const Context& context, Servo& servo,
                                        const catalog::Register& reg);

/// Every byte that comes within `span` after a PING to all servos: their replies, often on top of
/// each other, or what comes unasked.
base::Result<base::Bytes> listenAfterPing(const Context& context, base::Duration span);

struct RegisterValue {
    const catalog::Register* reg = nullptr;
    std::int64_t raw = 0;
};
using RegisterValues = std::vector<RegisterValue>;

/// The bytes as they go into the frame, in the servo's byte order and encoding.
base::Bytes wireBytes(const Servo& servo, const catalog::Register& reg, std::int64_t raw);

/// One WRITE frame: its bytes, their address, and where they are read back.
struct Patch {
    int writeOffset = 0;
    int readOffset = 0;
    base::Bytes data;
    int count() const { return static_cast<int>(data.size()); }
};

/// True when `next` goes into the frame that ends with `last`: it follows directly, or travels in
/// the same block.
bool sharesFrame(const catalog::Register& last, const catalog::Register& next);

/// The one frame for registers that share it, in the order of writing. The bytes of their block
/// that do not change are those in the servo's image, which must be known.
Patch patchOf(const Servo& servo, const RegisterValues& values);

/// The same, with the block read afresh where it holds more than `values`.
base::Result<Patch> freshPatch(const Context& context, Servo& servo, const RegisterValues& values);

/// One WRITE frame. Does not read back.
base::Result<void> writeBlock(const Context& context, Servo& servo, const Patch& patch,
                              protocol::Repeat repeat);

/// For writes that make a servo safe (torque off, lock closed) after a read has failed because the
/// line never falls silent: the write is still sent, without proof.
void writeUnverified(const Context& context, Servo& servo, const catalog::Register& reg,
                     std::int64_t raw, const base::Error& readFailed);

/// True when a request was sent and only its reply is missing: reading shows the result.
bool isReplyLost(const base::Error& error);

/// Reading proved that a write had no effect, and it is sent again. `replyLost`: an expected
/// acknowledgement did not come.
void noteResent(const Context& context, const Servo& servo, bool replyLost,
                const QString& key = {});

/// A WRITE that may be repeated; where its answer is lost, or never comes (response level 0, LX),
/// the block is read back and decides. Refused when it does not show what was written.
base::Result<void> writeConfirmed(const Context& context, Servo& servo, const Patch& patch);

/// Writes registers that share a frame and reads them back, once more if the servo still shows the
/// old values. Ends in Mismatch when it shows anything else. For registers that may be repeated.
base::Result<void> writeVerified(const Context& context, Servo& servo,
                                 const RegisterValues& values);
base::Result<void> writeVerified(const Context& context, Servo& servo, const catalog::Register& reg,
                                 std::int64_t raw);

/// Makes the present value of a register with a save command stay. Nothing proves it, so it is said
/// twice.
base::Result<void> save(const Context& context, Servo& servo, const catalog::Register& reg);
} // namespace device
