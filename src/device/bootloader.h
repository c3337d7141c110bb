// SPDX-License-Identifier: GPL-3.0-or-later
// A Feetech servo's bootloader as jobs see it. It has one rate and no ID: every servo that is in
// its bootloader takes what is sent. To be called at bootloaderBaud; the job's thread. Not tried on
// real hardware by us. Errors are those of bus::Bus::transact; silence is none of them. Source:
// kuterd/feetech-fw-util, 0o8o0-blip/sts3215-firmware.
#pragma once

#include "device/context.h"
#include "protocol/firmware_block.h"

namespace device {
/// The only rate of a servo's bootloader.
constexpr int bootloaderBaud = protocol::bootloaderBaud;

enum class BootloaderReply : std::uint8_t {
    Silence,
    Accepted,
    Refused,
    Other, ///< several bytes, or another one
};

/// Sends the bytes that announce a new firmware, and listens for the whole `span`. None is sent, so
/// the bootloader goes on as before.
base::Result<BootloaderReply> askBootloader(const Context& context, base::Duration span);

/// The same, but returns with the first byte, and does not wait for late ones.
base::Result<BootloaderReply> callBootloader(const Context& context, base::Duration span);

/// After an accepted announcement: blocks follow. From here on it no longer starts the firmware on
/// its own.
base::Result<BootloaderReply> startTransfer(const Context& context);

/// Of protocol::firmwareBlocks(). Returns with the first byte of the reply. The first accepted
/// block destroys the old firmware. Is not ended by a stop.
base::Result<BootloaderReply> sendFirmwareBlock(const Context& context, base::ByteView file,
                                                int index);
} // namespace device
