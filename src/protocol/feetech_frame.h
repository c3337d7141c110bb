// SPDX-License-Identifier: GPL-3.0-or-later
// The Feetech frame as such, shared by the codec's encoder, scanner and explainer:
// FF FF ID LEN INST|ERR P1..Pn CHK, LEN = n + 2, CHK = low byte of NOT(ID + LEN + … + Pn).
// Pure functions, any thread. Source: Feetech protocol page; the 250-byte cap is the vendor SDK's.
#pragma once

#include "base/bytes.h"

#include <cstdint>

namespace protocol::feetech {
constexpr std::size_t overhead = 6; ///< bytes of a frame without parameters
constexpr std::size_t maxFrame = 250;
constexpr int maxFrameId = 254; ///< 255 is the header byte

enum Instruction : std::uint8_t {
    instPing = 0x01,
    instRead = 0x02,
    instWrite = 0x03,
    instRegWrite = 0x04,
    instAction = 0x05,
    instRestore = 0x06,
    instReboot = 0x08,
    instBackup = 0x09,
    instStateReset = 0x0A,
    instCalibrate = 0x0B,
    instSyncRead = 0x82,
    instSyncWrite = 0x83,
};

/// `body` is everything between header and checksum: ID, LEN, INST or ERR, parameters.
std::uint8_t checksum(base::ByteView body);

base::Bytes buildFrame(int id, std::uint8_t instructionOrError, base::ByteView params);

enum class FrameState : std::uint8_t {
    None,    ///< no frame can start here
    Partial, ///< may become a frame
    Broken,  ///< whole, but its checksum is wrong
    Valid,
};

/// What starts at `offset`.
FrameState frameStateAt(base::ByteView buffer, std::size_t offset);

/// First place at or after `from` where a frame may start; the buffer's size if there is none.
std::size_t nextStart(base::ByteView buffer, std::size_t from);

/// Length of the frame that starts at `offset`; its shape is Broken or Valid.
inline std::size_t frameSize(base::ByteView buffer, std::size_t offset)
{
    return std::size_t{buffer[offset + 3]} + 4;
}

/// Parameters of the whole frame `frame`.
inline base::ByteView params(base::ByteView frame)
{
    return frame.subspan(5, frame.size() - overhead);
}
} // namespace protocol::feetech
