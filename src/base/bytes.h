// SPDX-License-Identifier: GPL-3.0-or-later
// Byte strings as they are on the wire, and the few helpers needed everywhere to build and read
// them. Pure values; any thread; never fail except fromHex.
#pragma once

#include "base/error.h"

#include <QString>

#include <cstdint>
#include <span>
#include <vector>

namespace base {
using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

enum class ByteOrder : std::uint8_t { Little, Big };

/// Reads an unsigned number of `bytes.size()` bytes (1 to 8).
std::uint64_t readUnsigned(ByteView bytes, ByteOrder order);

/// Writes the low `size` bytes of `value`.
Bytes writeUnsigned(std::uint64_t value, std::size_t size, ByteOrder order);

/// "FF FF 01 02" — upper case, blanks between the bytes.
QString toHex(ByteView bytes);

/// Accepts "FFFF0102", "FF FF 01 02", "0xff,0xff"; BadArgument otherwise.
Result<Bytes> fromHex(const QString& text);
} // namespace base
