// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in a servo before its firmware: it has no ID and one rate, takes a firmware block by
// block, and knows nothing of what is in it. Plain value of one servo; its thread. The times are
// chosen. Source: kuterd/feetech-fw-util and 0o8o0-blip/sts3215-firmware.
#pragma once

#include "base/bytes.h"
#include "base/clock.h"

#include <cstdint>
#include <optional>

namespace sim {
class Bootloader {
public:
    static constexpr int baud = 500'000;
    /// After a start it waits for a firmware for this long.
    static constexpr base::Duration window = std::chrono::milliseconds(800);

    struct Reply {
        std::uint8_t byte = 0;
        base::Duration wait{}; ///< erasing and writing its memory
    };

    /// Its reply to this byte, if it has one.
    std::optional<Reply> receive(std::uint8_t byte);

    /// It has been told to wait for blocks, and no longer starts the firmware on its own.
    bool isTransferring() const { return m_state == State::Transferring; }
    bool hasErased() const { return m_accepted > 0; } ///< the old firmware is gone
    /// Once: the last block has come, or blocks without end were refused.
    bool hasEnded() const { return m_state == State::Ended; }
    bool isComplete() const { return m_isComplete; }

private:
    enum class State : std::uint8_t { Waiting, Announced, Transferring, Ended };

    Reply takeBlock();
    bool isBlockGood() const;

    State m_state = State::Waiting;
    std::size_t m_matched = 0; ///< bytes of the preamble
    base::Bytes m_block;
    int m_accepted = 0; ///< blocks
    int m_refused = 0;  ///< in a row
    bool m_isComplete = false;
};
} // namespace sim
