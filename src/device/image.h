// SPDX-License-Identifier: GPL-3.0-or-later
// What has really been read of a servo's memory table, byte by byte, with the time of reading.
// A plain value; never holds a number that did not come from the wire. Offsets are bytes of the
// table (catalog::Register::offset). Times are bus-clock instants.
#pragma once

#include "base/bytes.h"
#include "base/clock.h"
#include "catalog/profile.h"

#include <optional>
#include <vector>

namespace device {
class Image {
public:
    /// A newer reading stays: a polled block may arrive here after the write that followed it.
    void store(int offset, base::ByteView bytes, base::Duration at);
    void invalidate(int offset, int count);
    /// The same before a write whose read-back may be lost: readings up to then, here or elsewhere,
    /// are void.
    void invalidate(int offset, int count, base::Duration readUntil);
    void clear();
    /// Takes the readings of `other` from `since` on that are newer.
    void mergeNewer(const Image& other, base::Duration since);
    /// Takes the readings of `other` for bytes that were never read here.
    void mergeMissing(const Image& other);

    /// The bytes of a register, if all of them have been read.
    std::optional<base::Bytes> bytes(int offset, int count) const;
    std::optional<base::Duration> readAt(int offset) const;

private:
    struct Cell {
        std::uint8_t value = 0;
        bool read = false;
        base::Duration at{}; ///< not read: readings up to then are void
    };
    const Cell* cell(int offset) const; ///< null: never read

    std::vector<Cell> m_cells; ///< up to the last byte that was read
};
} // namespace device
