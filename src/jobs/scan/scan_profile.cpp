// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan_profile.h"

#include <algorithm>

namespace jobs {
namespace {
using base::Protocol;
using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr int bitsPerByte = 10;
// The longest reply delay that the bus allows for (SMS, reply delay 254).
constexpr base::Duration maxReplyDelay{508};

constexpr ScanProfile feetech{0, 253, milliseconds(4), 12, {}, false};
// The turn-around of an LX servo is not published; 20 ms and more are in use.
constexpr ScanProfile lx{0, 253, milliseconds(25), 13, {}, true};
constexpr ScanProfile modbus{1, 247, milliseconds(25), 21, microseconds(1750), true};
constexpr std::size_t modbusIdentity = 9; ///< byte count and four registers
} // namespace

const ScanProfile& scanProfileOf(Protocol protocol)
{
    switch (protocol) {
    case Protocol::Lx:
        return lx;
    case Protocol::Modbus:
        return modbus;
    case Protocol::Feetech:
        break;
    }
    return feetech;
}

IdRange idsToScan(const ScanSpec& spec, Protocol protocol)
{
    const ScanProfile& scanProfile = scanProfileOf(protocol);
    return {std::max(spec.firstId, scanProfile.firstId), std::min(spec.lastId, scanProfile.lastId)};
}

base::Duration pingTime(const ScanProfile& scanProfile, int baud, base::Duration timeout)
{
    return base::Duration(std::int64_t{scanProfile.wireBytes} * bitsPerByte * 1'000'000 / baud) +
           maxReplyDelay + scanProfile.pause + timeout;
}

bool isPingReply(Protocol protocol, const bus::UnexpectedFrame& stray)
{
    switch (protocol) {
    case Protocol::Lx:
        return stray.data.size() == 1 && stray.data.front() == stray.id;
    case Protocol::Modbus:
        return stray.data.size() == modbusIdentity &&
               stray.data.front() == static_cast<std::uint8_t>(modbusIdentity - 1);
    case Protocol::Feetech:
        break;
    }
    return stray.data.empty();
}

bool looksLikeEcho(const bus::Bus& bus, Protocol protocol, const bus::UnexpectedFrame& stray)
{
    constexpr std::uint8_t pingInstruction = 1;
    return protocol == Protocol::Feetech && bus.hasEcho() && stray.status == pingInstruction;
}
} // namespace jobs
