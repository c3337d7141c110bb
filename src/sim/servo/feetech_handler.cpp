// SPDX-License-Identifier: GPL-3.0-or-later
// Feetech instructions: what is done, and what is answered. Source: instruction and answer tables
// of the Feetech protocol notes. Unknown instructions and malformed parameters stay unanswered.
#include "sim/servo/servo_state.h"

#include <algorithm>

namespace sim {
namespace {
enum Instruction : std::uint8_t {
    Ping = 0x01,
    Read = 0x02,
    Write = 0x03,
    RegWrite = 0x04,
    Action = 0x05,
    Restore = 0x06,
    InstReboot = 0x08,
    Backup = 0x09,
    StateReset = 0x0A,
    Calibrate = 0x0B,
    SyncRead = 0x82,
    SyncWrite = 0x83,
};

/// 0x0B came to the STS with firmware 3.10, beside the 128 they all know.
bool supportsCalibration(const catalog::Profile& profile)
{
    const catalog::Identity& id = profile.identity;
    const bool isNewSts = profile.series == QLatin1String("STS") && id.firmwareMajor == 3;
    return profile.centering == catalog::Centering::Instruction0B ||
           (isNewSts && id.firmwareMinor >= 10);
}

constexpr int maxReadCount = 253; ///< LEN is one byte and counts two more
constexpr int tableSize = 256;
constexpr base::Duration pingSlot = std::chrono::milliseconds(3);
} // namespace

/// The second ID is for groups, so nobody answers to it; which instructions it serves is from the
/// HLS table.
AddressMatch VirtualServo::State::addressMatch(int id, std::uint8_t instruction) const
{
    if (id == settings.id) {
        return AddressMatch::Yes;
    }
    if (!secondaryId.exists() || id != map.read(memory, secondaryId)) {
        return AddressMatch::No;
    }
    const bool isGroupInstruction = instruction == Write || instruction == RegWrite ||
                                    instruction == Action || instruction == SyncWrite;
    return isGroupInstruction ? AddressMatch::Silently : AddressMatch::No;
}

std::optional<ServoReply> VirtualServo::State::makeReply(base::ByteView data) const
{
    return ServoReply{settings.id, protection.status(), base::Bytes(data.begin(), data.end())};
}

std::optional<ServoReply> VirtualServo::State::ping(const ServoRequest& request) const
{
    if (!request.params.empty()) {
        return std::nullopt;
    }
    auto reply = makeReply();
    if (request.broadcast && config.behavior.staggersBroadcastPing) {
        reply->wait = pingSlot * settings.id;
    }
    return reply;
}

std::optional<ServoReply> VirtualServo::State::readTable(base::ByteView params)
{
    const int address = params[0];
    const int count = params[1];
    if (count > maxReadCount || address + count > tableSize) {
        return std::nullopt;
    }
    updateFeedback();
    return makeReply(memory.view(address, count));
}

std::optional<ServoReply> VirtualServo::State::handleFeetech(const ServoRequest& request)
{
    switch (request.instruction) {
    case Ping:
        return ping(request);
    case Read:
        if (request.broadcast || request.params.size() != 2) {
            return std::nullopt;
        }
        return readTable(request.params);
    case SyncRead:
        if (!profile->syncRead || request.syncReadIndex < 0 || request.params.size() < 3) {
            return std::nullopt;
        }
        return readTable(request.params);
    default:
        break;
    }
    const int oldId = settings.id;
    const int oldLevel = settings.responseLevel;
    if (!execute(request)) {
        return std::nullopt;
    }
    return acknowledge(request, oldId, oldLevel);
}

std::optional<ServoReply> VirtualServo::State::acknowledge(const ServoRequest& request, int oldId,
                                                           int oldLevel)
{
    if (request.broadcast || oldLevel == 0 || !isRunning() || request.instruction == SyncWrite) {
        return std::nullopt;
    }
    auto reply = makeReply();
    if (!config.behavior.acknowledgesWithNewId) {
        reply->id = oldId;
    }
    return reply;
}

/// False: not understood.
bool VirtualServo::State::execute(const ServoRequest& request)
{
    const base::ByteView params = request.params;
    switch (request.instruction) {
    case Write:
        if (params.size() < 2) {
            return false;
        }
        write(params[0], params.subspan(1));
        return true;
    case RegWrite:
        return storePendingWrite(params);
    case SyncWrite:
        syncWrite(params);
        return true;
    case Calibrate:
        return calibrate(params);
    default:
        break;
    }
    if (!params.empty()) {
        return false;
    }
    switch (request.instruction) {
    case Action:
        executePendingWrite();
        return true;
    case Restore:
        restore();
        return true;
    case Backup:
        backup();
        return true;
    case StateReset:
        resetTurnBase();
        return true;
    case InstReboot:
        restart();
        return true;
    default:
        return false;
    }
}

void VirtualServo::State::syncWrite(base::ByteView params)
{
    if (params.size() < 2) {
        return;
    }
    const std::size_t count = params[1];
    const base::ByteView list = params.subspan(2);
    if (count == 0 || list.size() % (count + 1) != 0) {
        return;
    }
    for (std::size_t at = 0; at < list.size(); at += count + 1) {
        if (addressMatch(list[at], SyncWrite) != AddressMatch::No) {
            write(params[0], list.subspan(at + 1, count));
            return;
        }
    }
}

bool VirtualServo::State::storePendingWrite(base::ByteView params)
{
    if (params.size() < 2) {
        return false;
    }
    pendingWrite = PendingWrite{params[0], base::Bytes(params.begin() + 1, params.end())};
    return true;
}

void VirtualServo::State::executePendingWrite()
{
    if (pendingWrite) {
        const PendingWrite now = std::move(*pendingWrite);
        pendingWrite.reset();
        write(now.address, now.data);
    }
}

bool VirtualServo::State::calibrate(base::ByteView params)
{
    if (!supportsCalibration(*profile) || (!params.empty() && params.size() != 2)) {
        return false;
    }
    constexpr int middle = 2048;
    setPresentPosition(params.empty() ? middle
                                      : int(base::readUnsigned(params, profile->byteOrder)) % 4096);
    return true;
}
} // namespace sim
