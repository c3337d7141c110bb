// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the memory table as plain data: what was read of a register, its age, and the result
// of the last write to it. Raw values and states only; texts are in memory_text.h. Pure functions
// on a servo entry; any thread.
#pragma once

#include "session/servos/servo_entry.h"

namespace ui {
enum class RowState : std::uint8_t {
    NotRead,    ///< never read
    Read,       ///< read, nothing written to it in this session
    Unreadable, ///< the latest reading failed: no number is shown
    Pending,    ///< a write is on its way
    Kept,
    Temporary,
    Mismatch,
    Refused,
    NoReply,
    Unknown,
    NotSent,    ///< its turn never came: stopped, or the cable was out
    NotWritten, ///< refused before the first byte; error has the reason
    Superseded, ///< what was written there has changed since
};

/// How old a reading is, in the steps in which it is shown: 0, 1, 2, 3, 5, 10 … seconds.
struct RowAge {
    int seconds = -1; ///< -1: never read
    bool operator==(const RowAge&) const = default;
};
RowAge rowAge(std::optional<base::Duration> readAt, base::Duration now);

/// The circumstances all rows of one servo share.
struct RowContext {
    base::Duration now{};
    bool isLinkOpen = true; ///< false: nothing shown is of this moment
};

struct MemoryRow {
    const catalog::Register* reg = nullptr; ///< lives as long as the profile
    catalog::ValueFormat meaning;
    std::optional<std::int64_t> raw;      ///< nullopt: not read, or the latest reading failed
    std::optional<std::int64_t> firstRaw; ///< as read first in this session
    std::int64_t requestedRaw = 0;        ///< of the latest write
    int pending = 0;                      ///< writes not ended yet
    RowState state = RowState::NotRead;
    std::optional<base::Error> error; ///< of the latest write that failed
    RowAge age;
    bool isStale = false;    ///< too old to be taken for the present
    bool hasSensor = true;   ///< false: the servo has the register, but no sensor for it
    bool isWritable = false; ///< of this servo, now that its map is known

    bool isChanged() const { return raw && firstRaw && *raw != *firstRaw; }
    /// Nullopt: the default or the value is not known.
    std::optional<bool> differsFromDefault() const;
    /// What an editor starts from: the value on its way, else the one that was read.
    std::optional<std::int64_t> editValue() const { return pending > 0 ? requestedRaw : raw; }
    bool sameAs(const MemoryRow& other) const;
};

MemoryRow memoryRow(const session::ServoEntry& entry, const catalog::Register& reg,
                    const RowContext& clock);
} // namespace ui
