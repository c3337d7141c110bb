// SPDX-License-Identifier: GPL-3.0-or-later
// The Hiwonder LX frame as such, shared by the codec's encoder, scanner and explainer:
// 55 55 ID LEN CMD P1..Pn CHK, LEN = n + 3, CHK = low byte of NOT(ID + LEN + CMD + P1 + … + Pn).
// Requests and replies look alike; a read request has no parameters, so LEN 3, a reply at least
// one. Pure functions, any thread. Source: Hiwonder LX protocol page.
#pragma once

#include "protocol/frame_scan.h"

namespace protocol::lx {
constexpr std::size_t overhead = 6; ///< bytes of a frame without parameters
constexpr std::size_t minLength = 3;
constexpr std::size_t maxParams = 8; ///< the sheet's commands have four at most
constexpr std::size_t maxFrame = overhead + maxParams;
constexpr std::size_t maxRawFrame = 258; ///< what one byte of LEN allows
constexpr int bytesPerCommand = 8;       ///< addresses of a Request: 8 × command

enum Command : std::uint8_t {
    cmdMoveStart = 11,
    cmdMoveStop = 12,
    cmdIdRead = 14,
    cmdPositionRead = 28,
};

base::Bytes buildFrame(int id, std::uint8_t command, base::ByteView params);

/// What the front of `rest` is.
FrameMatch matchAt(base::ByteView rest);

/// Parameters of the whole frame `frame`.
inline base::ByteView params(base::ByteView frame)
{
    return frame.subspan(5, frame.size() - overhead);
}
} // namespace protocol::lx
