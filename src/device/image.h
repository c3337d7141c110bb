// SPDX-License-Identifier: GPL-3.0-or-later
// What has really been read of a servo's memory table, byte by byte, with the time of reading.
// A plain value; never holds a number that did not come from the wire. Times are bus-clock
// instants.
#pragma once

#include "base/bytes.h"
#include "base/clock.h"
#include "catalog/profile.h"

#include <array>
#include <optional>

namespace device {
class Image {
public:
    void store(int address, base::ByteView bytes, base::Duration at);
    void forget(int address, int count);
    void clear();

    /// The bytes of a register, if all of them have been read.
    std::optional<base::Bytes> bytes(int address, int count) const;
    std::optional<base::Duration> readAt(int address) const;

private:
    static constexpr std::size_t tableSize = 256;
    std::array<std::uint8_t, tableSize> m_bytes{};
    std::array<std::int64_t, tableSize> m_at{}; ///< microseconds + 1; 0 = never read
};
} // namespace device
