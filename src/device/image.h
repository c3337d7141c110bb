// SPDX-License-Identifier: GPL-3.0-or-later
// What has really been read of a servo's memory table, byte by byte, with the time of reading.
// A plain value; never holds a number that did not come from the wire. Places are bytes of the
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
    /// What was read later already stays: a polled block may be handed over after the write that
    /// followed it.
    void store(int offset, base::ByteView bytes, base::Duration at);
    void invalidate(int offset, int count);
    /// The same before a write whose read-back may be lost: what was read by then, here or by
    /// others, no longer says what stands there.
    void invalidate(int offset, int count, base::Duration readUntil);
    void clear();
    /// Takes what `other` has read from `since` on, where it is the newer reading.
    void mergeNewer(const Image& other, base::Duration since);
    /// Takes what `other` has where nothing was read here.
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

    std::vector<Cell> m_cells; ///< as far as anything has been read
};
} // namespace device
