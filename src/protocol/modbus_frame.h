// SPDX-License-Identifier: GPL-3.0-or-later
// The Modbus-RTU frame as such, shared by the codec's encoder, scanner and explainer: station,
// function, data, CRC low byte first. It has no header and no length: where it ends follows from
// its function, differently for requests and replies. Pure functions, any thread.
// Source: vendor's Modbus page, its library for the order of the CRC, the Modbus standard.
#pragma once

#include "protocol/frame_scan.h"

namespace protocol::modbus {
constexpr std::size_t overhead = 4; ///< station, function, CRC
constexpr std::size_t maxFrame = 256;
constexpr std::size_t exceptionSize = 5;
constexpr int maxStation = 247;
constexpr std::uint8_t exceptionFlag = 0x80;

enum Function : std::uint8_t {
    fnRead = 0x03,
    fnWriteOne = 0x06,
    fnWrite = 0x10,
    fnReportId = 0x11,
    fnReportIdDisputed = 0x17, ///< what the vendor's table prints in the reply to 0x11
    fnReboot = 0x41,
};

base::Bytes buildFrame(int station, std::uint8_t function, base::ByteView data);

/// Length of the request or reply at the front of `rest`: 0 if it is none, rest.size() + 1 while
/// too little of it has come.
std::size_t requestSize(base::ByteView rest);
std::size_t replySize(base::ByteView rest);

bool isCrcValid(base::ByteView frame);

/// What the front of `rest` is if it is a frame of `size` bytes, as those functions give it.
FrameMatch matchOf(base::ByteView rest, std::size_t size);

/// What stands between function and CRC.
inline base::ByteView content(base::ByteView frame)
{
    return frame.subspan(2, frame.size() - overhead);
}

/// 254 in a request is station 0 on the wire.
inline int idOf(std::uint8_t station)
{
    return station == 0 ? broadcastId : station;
}
} // namespace protocol::modbus
