// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/encode_error.h"
#include "protocol/feetech_codec.h"
#include "protocol/feetech_frame.h"

#include <bitset>

namespace protocol {
namespace {
using base::Bytes;
using base::Result;

constexpr int tableSize = 256;
constexpr int maxReadCount = static_cast<int>(feetech::maxFrame - feetech::overhead);

Result<Bytes> framed(const Request& request, int id, std::uint8_t instruction, const Bytes& params)
{
    if (params.size() + feetech::overhead > feetech::maxFrame)
        return refuse(request,
                      QStringLiteral("packet longer than %1 bytes").arg(feetech::maxFrame));
    return feetech::buildFrame(id, instruction, params);
}

Result<void> checkId(const Request& request)
{
    const bool probe = request.op == Op::Read && request.id == broadcastId &&
                       request.address == feetechEchoProbe().address &&
                       request.count == feetechEchoProbe().count;
    const int maxTarget = request.op == Op::Read && !probe ? maxId : broadcastId;
    if (request.id < 0 || request.id > maxTarget)
        return refuse(request, QStringLiteral("ID %1").arg(request.id));
    return {};
}

Result<void> checkArea(const Request& request, std::size_t count)
{
    if (request.address < 0 || request.address >= tableSize)
        return refuse(request, QStringLiteral("address %1").arg(request.address));
    if (count == 0)
        return refuse(request, QStringLiteral("no bytes"));
    if (count > std::size_t(tableSize - request.address))
        return refuse(request, QStringLiteral("%1 bytes from address %2 pass the end of the table")
                                   .arg(count)
                                   .arg(request.address));
    return {};
}

Result<void> checkCount(const Request& request)
{
    if (request.count < 1 || request.count > maxReadCount)
        return refuse(request, QStringLiteral("%1 bytes").arg(request.count));
    return checkArea(request, std::size_t(request.count));
}

Result<void> checkTargets(const Request& request)
{
    if (request.targets.empty())
        return refuse(request, QStringLiteral("no servos"));
    std::bitset<maxId + 1> seen;
    for (const Target& target : request.targets) {
        if (target.id < 0 || target.id > maxId)
            return refuse(request, QStringLiteral("ID %1").arg(target.id));
        if (seen.test(std::size_t(target.id)))
            return refuse(request, QStringLiteral("ID %1 twice").arg(target.id));
        seen.set(std::size_t(target.id));
        if (target.data.size() != request.targets.front().data.size())
            return refuse(request, QStringLiteral("data of unequal length"));
    }
    return {};
}

Result<Bytes> encodeRead(const Request& request)
{
    return checkCount(request).and_then([&] {
        return framed(request, request.id, feetech::instRead,
                      {std::uint8_t(request.address), std::uint8_t(request.count)});
    });
}

Result<Bytes> encodeWrite(const Request& request, std::uint8_t instruction)
{
    return checkArea(request, request.data.size()).and_then([&] {
        Bytes params{std::uint8_t(request.address)};
        params.insert(params.end(), request.data.begin(), request.data.end());
        return framed(request, request.id, instruction, params);
    });
}

Result<Bytes> encodeCalibrate(const Request& request)
{
    if (!request.data.empty() && request.data.size() != 2)
        return refuse(request, QStringLiteral("value of %1 bytes").arg(request.data.size()));
    return framed(request, request.id, feetech::instCalibrate, request.data);
}

Result<Bytes> encodeSyncRead(const Request& request)
{
    return checkCount(request).and_then([&] { return checkTargets(request); }).and_then([&] {
        Bytes params{std::uint8_t(request.address), std::uint8_t(request.count)};
        for (const Target& target : request.targets)
            params.push_back(std::uint8_t(target.id));
        return framed(request, broadcastId, feetech::instSyncRead, params);
    });
}

Result<Bytes> encodeSyncWrite(const Request& request)
{
    return checkTargets(request)
        .and_then([&] { return checkArea(request, request.targets.front().data.size()); })
        .and_then([&] {
            Bytes params{std::uint8_t(request.address),
                         std::uint8_t(request.targets.front().data.size())};
            for (const Target& target : request.targets) {
                params.push_back(std::uint8_t(target.id));
                params.insert(params.end(), target.data.begin(), target.data.end());
            }
            return framed(request, broadcastId, feetech::instSyncWrite, params);
        });
}

Result<Bytes> encodeUnicast(const Request& request)
{
    const auto plain = [&](std::uint8_t code) { return framed(request, request.id, code, {}); };
    switch (request.op) {
    case Op::Ping:
        return plain(feetech::instPing);
    case Op::Read:
        return encodeRead(request);
    case Op::Write:
        return encodeWrite(request, feetech::instWrite);
    case Op::RegWrite:
        return encodeWrite(request, feetech::instRegWrite);
    case Op::Action:
        return plain(feetech::instAction);
    case Op::Restore:
        return plain(feetech::instRestore);
    case Op::Backup:
        return plain(feetech::instBackup);
    case Op::StateReset:
        return plain(feetech::instStateReset);
    case Op::Calibrate:
        return encodeCalibrate(request);
    case Op::Reboot:
        return plain(feetech::instReboot);
    case Op::SyncRead:
    case Op::SyncWrite:
    case Op::Raw:
        return refuse(request, QStringLiteral("not addressed to one servo"));
    case Op::Halt:
        break;
    }
    return refuseUnsupported(request);
}
} // namespace

Result<Bytes> encodeFeetech(const Request& request)
{
    switch (request.op) {
    case Op::SyncRead:
        return encodeSyncRead(request);
    case Op::SyncWrite:
        return encodeSyncWrite(request);
    case Op::Raw:
        return encodeRaw(request, feetech::maxFrame);
    default:
        return checkId(request).and_then([&] { return encodeUnicast(request); });
    }
}

Request feetechEchoProbe()
{
    return Request::read(broadcastId, 0, 1);
}

Bytes encodeFeetechStatus(int id, std::uint8_t status, base::ByteView data)
{
    return feetech::buildFrame(id, status, data);
}
} // namespace protocol
