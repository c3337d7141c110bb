// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bootloader.h"

namespace device {
namespace {
constexpr base::Duration blockTimeout = std::chrono::milliseconds(500);

BootloaderReply replyOf(const base::Bytes& received)
{
    if (received.empty())
        return BootloaderReply::Silence;
    if (received == base::Bytes{protocol::blockAccepted})
        return BootloaderReply::Accepted;
    return received == base::Bytes{protocol::blockRefused} ? BootloaderReply::Refused
                                                           : BootloaderReply::Other;
}

base::Bytes preamble()
{
    return {protocol::firmwarePreamble.begin(), protocol::firmwarePreamble.end()};
}

/// `replyBytes` 0: all that comes within the time.
base::Result<BootloaderReply> send(const Context& context, base::Bytes bytes, int replyBytes,
                                   base::Duration timeout)
{
    bus::Transaction transaction;
    transaction.request = protocol::Request::raw(std::move(bytes), replyBytes);
    transaction.retries = 0;
    transaction.priority = context.priority;
    transaction.timeout = timeout;
    transaction.hold = context.hold;
    transaction.epoch = context.epoch;
    const auto outcome = context.bus.transact(transaction);
    return outcome.map([](const bus::Outcome& result) {
        return result.replies.empty() ? BootloaderReply::Silence : replyOf(result.data());
    });
}
} // namespace

base::Result<BootloaderReply> askBootloader(const Context& context, base::Duration span)
{
    return send(context, preamble(), 0, span);
}

base::Result<BootloaderReply> callBootloader(const Context& context, base::Duration span)
{
    return send(context, preamble(), 1, span);
}

base::Result<BootloaderReply> startTransfer(const Context& context)
{
    return send(context, {protocol::firmwareStart}, 1, blockTimeout);
}

base::Result<BootloaderReply> sendFirmwareBlock(const Context& context, base::ByteView file,
                                                int index)
{
    return send(context, protocol::firmwareBlock(file, index), 1, blockTimeout);
}
} // namespace device
