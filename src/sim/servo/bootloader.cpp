// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/bootloader.h"

#include <array>

namespace sim {
namespace {
constexpr std::array<std::uint8_t, 5> preamble{'1', 'f', 'B', 'V', 'A'};
constexpr std::uint8_t accepted = 0x06;
} // namespace

std::optional<std::uint8_t> Bootloader::receive(std::uint8_t byte)
{
    if (byte != preamble[m_matched])
        m_matched = 0; // its first byte does not occur again in it
    if (byte == preamble[m_matched])
        ++m_matched;
    if (m_matched < preamble.size())
        return std::nullopt;
    m_matched = 0;
    return accepted;
}
} // namespace sim
