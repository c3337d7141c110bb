// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in a servo before its firmware: it has no ID and one rate, and replies to the five
// bytes that announce a new firmware. Plain value of one servo; its thread. Source:
// kuterd/feetech-fw-util and 0o8o0-blip/sts3215-firmware.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace sim {
class Bootloader {
public:
    static constexpr int baud = 500'000;

    /// Its reply to this byte, if it has one.
    std::optional<std::uint8_t> receive(std::uint8_t byte);

private:
    std::size_t m_matched = 0; ///< bytes of the preamble
};
} // namespace sim
