// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/bootloader.h"

#include "base/crc.h"

#include <array>

namespace sim {
namespace {
using namespace std::chrono_literals;

constexpr std::array<std::uint8_t, 5> preamble{'1', 'f', 'B', 'V', 'A'};
constexpr std::uint8_t start = 0x01;
constexpr std::uint8_t accepted = 0x06;
constexpr std::uint8_t refused = 0x15;

constexpr std::size_t blockSize = 70;
constexpr std::uint8_t lastBlock = 0x04;
constexpr std::uint8_t busServoFile = 1;
constexpr int maxRefused = 200; ///< in a row
constexpr int blocksPerPage = 16;
constexpr base::Duration eraseTime = 20ms;
constexpr base::Duration writeTime = 1ms;
} // namespace

std::optional<Bootloader::Reply> Bootloader::receive(std::uint8_t byte)
{
    if (m_state == State::Transferring) {
        m_block.push_back(byte);
        return m_block.size() == blockSize ? std::optional(takeBlock()) : std::nullopt;
    }
    if (m_state == State::Announced && byte == start) {
        m_state = State::Transferring;
        return Reply{accepted};
    }
    if (byte != preamble[m_matched])
        m_matched = 0; // its first byte does not occur again in it
    if (byte == preamble[m_matched])
        ++m_matched;
    if (m_matched < preamble.size())
        return std::nullopt;
    m_matched = 0;
    m_state = State::Announced;
    return Reply{accepted};
}

Bootloader::Reply Bootloader::takeBlock()
{
    const bool isGood = isBlockGood();
    const bool isLast = m_block.back() == lastBlock;
    m_block.clear();
    if (!isGood) {
        if (++m_refused == maxRefused)
            m_state = State::Ended;
        return {refused};
    }
    m_refused = 0;
    const base::Duration erasing = m_accepted % blocksPerPage == 0 ? eraseTime : base::Duration{};
    ++m_accepted;
    if (isLast) {
        m_state = State::Ended;
        m_isComplete = true;
    }
    return {accepted, writeTime + erasing};
}

bool Bootloader::isBlockGood() const
{
    constexpr std::size_t checked = 64; // the checksum leaves out the last three bytes of the data
    const std::uint16_t sum = base::crc16Xmodem(base::ByteView(m_block).first(checked));
    return m_block[0] == std::uint8_t(m_accepted + 1) && m_block[1] == std::uint8_t(~m_block[0]) &&
           m_block[2] == busServoFile && m_block[67] == sum >> 8 && m_block[68] == (sum & 0xFF);
}
} // namespace sim
