// SPDX-License-Identifier: GPL-3.0-or-later
// What goes to a Feetech servo's bootloader: the bytes that announce a new firmware, and its blocks
// of 70 bytes. The bytes of the file are passed on as they are. Pure; any thread. Not tried on real
// hardware by us. Source: kuterd/feetech-fw-util, confirmed by 0o8o0-blip/sts3215-firmware.
#pragma once

#include "base/bytes.h"

#include <array>

namespace protocol {
constexpr int bootloaderBaud = 500'000;
constexpr std::array<std::uint8_t, 5> firmwarePreamble{'1', 'f', 'B', 'V', 'A'};
constexpr std::uint8_t firmwareStart = 0x01;
constexpr std::uint8_t blockAccepted = 0x06;
constexpr std::uint8_t blockRefused = 0x15; ///< to be sent again

constexpr std::size_t firmwareBlockData = 64; ///< bytes of the file in a block

int firmwareBlocks(std::size_t fileSize);
/// From 0. The last one is filled up with 0xFF.
base::Bytes firmwareBlock(base::ByteView file, int index);
} // namespace protocol
