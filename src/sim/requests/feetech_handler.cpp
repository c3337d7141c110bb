// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/requests/feetech_handler.h"

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

/// 0x0B came to the STS with firmware 3.10, beside the 128 that all of them know.
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

/// The second ID is for groups, so a servo does not answer to it; which instructions it serves is
/// from the HLS table.
AddressMatch FeetechHandler::addressMatch(int id, std::uint8_t instruction) const
{
    if (id == settings().id) {
        return AddressMatch::Yes;
    }
    const Field& second = registers().secondaryId();
    if (!second.exists() || id != registers().read(second)) {
        return AddressMatch::No;
    }
    const bool isGroupInstruction = instruction == Write || instruction == RegWrite ||
                                    instruction == Action || instruction == SyncWrite;
    return isGroupInstruction ? AddressMatch::Silently : AddressMatch::No;
}

ServoReply FeetechHandler::makeReply(base::ByteView data) const
{
    return {settings().id, firmware().protection().status(), base::Bytes(data.begin(), data.end())};
}

std::optional<ServoReply> FeetechHandler::ping(const ServoRequest& request) const
{
    if (!request.params.empty()) {
        return std::nullopt;
    }
    ServoReply reply = makeReply();
    if (request.broadcast && firmware().config().behavior.staggersBroadcastPing) {
        reply.wait = pingSlot * settings().id;
    }
    return reply;
}

std::optional<ServoReply> FeetechHandler::readTable(base::ByteView params)
{
    const int address = params[0];
    const int count = params[1];
    if (count > maxReadCount || address + count > tableSize) {
        return std::nullopt;
    }
    return makeReply(read(address, count));
}

std::optional<ServoReply> FeetechHandler::handle(const ServoRequest& request)
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
        if (!profile().syncRead || request.syncReadIndex < 0 || request.params.size() < 3) {
            return std::nullopt;
        }
        return readTable(request.params);
    default:
        break;
    }
    const int oldId = settings().id;
    const int oldLevel = settings().responseLevel;
    if (!execute(request) || !answersWrite(request, oldLevel)) {
        return std::nullopt;
    }
    ServoReply reply = makeReply();
    if (!firmware().config().behavior.acknowledgesWithNewId) {
        reply.id = oldId;
    }
    return reply;
}

bool FeetechHandler::answersWrite(const ServoRequest& request, int level) const
{
    return !request.broadcast && level != 0 && firmware().power().isRunning() &&
           request.instruction != SyncWrite;
}

/// False: not understood.
bool FeetechHandler::execute(const ServoRequest& request)
{
    const base::ByteView params = request.params;
    switch (request.instruction) {
    case Write:
        if (params.size() < 2) {
            return false;
        }
        firmware().write(params[0], params.subspan(1));
        return true;
    case RegWrite:
        return storePendingWrite(params);
    case SyncWrite:
        syncWrite(params);
        return true;
    case Calibrate:
        return calibrate(params);
    default:
        return params.empty() && executeWithoutParams(request.instruction);
    }
}

bool FeetechHandler::executeWithoutParams(std::uint8_t instruction)
{
    switch (instruction) {
    case Action:
        executePendingWrite();
        return true;
    case Restore:
        firmware().restoreBackup();
        return true;
    case Backup:
        registers().makeBackup();
        return true;
    case StateReset:
        firmware().resetTurns();
        return true;
    case InstReboot:
        forgetStored();
        firmware().restart();
        return true;
    default:
        return false;
    }
}

void FeetechHandler::syncWrite(base::ByteView params)
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
            firmware().write(params[0], list.subspan(at + 1, count));
            return;
        }
    }
}

bool FeetechHandler::storePendingWrite(base::ByteView params)
{
    if (params.size() < 2) {
        return false;
    }
    setPendingWrite(PendingWrite{params[0], base::Bytes(params.begin() + 1, params.end())});
    return true;
}

void FeetechHandler::executePendingWrite()
{
    if (m_pendingWrite) {
        const PendingWrite now = std::move(*m_pendingWrite);
        setPendingWrite(std::nullopt);
        firmware().write(now.address, now.data);
    }
}

void FeetechHandler::setPendingWrite(std::optional<PendingWrite> write)
{
    m_pendingWrite = std::move(write);
    registers().put(catalog::Role::AsyncFlag, m_pendingWrite ? 1 : 0);
}

bool FeetechHandler::calibrate(base::ByteView params)
{
    if (!supportsCalibration(profile()) || (!params.empty() && params.size() != 2)) {
        return false;
    }
    constexpr int middle = 2048;
    firmware().setPresentPosition(
        params.empty() ? middle : int(base::readUnsigned(params, profile().byteOrder)) % 4096);
    return true;
}
} // namespace sim
