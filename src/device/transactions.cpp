// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/transactions.h"

#include "device/alarms.h"
#include "device/persistence.h"
#include "device/write_access.h"
#include "protocol/codec.h"

#include <algorithm>

namespace device {
using base::ErrorCode;

namespace {
bool isChange(const protocol::Request& request)
{
    return request.op != protocol::Op::Ping && request.op != protocol::Op::Read &&
           request.op != protocol::Op::SyncRead;
}

base::Result<bus::Outcome> send(const Context& context, Servo& servo, protocol::Request request,
                                int retries = -1)
{
    if (isChange(request)) {
        if (const auto may = requireVerified(context, servo, QStringLiteral("write")); !may)
            return tl::unexpected(may.error());
    }
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.request.protocol = servo.protocol;
    transaction.priority = context.priority;
    transaction.retries = retries;
    transaction.hold = context.hold;
    transaction.epoch = context.epoch;
    transaction.patient = context.patient && !context.emergencyStop;
    auto outcome = context.bus.transact(transaction);
    if (outcome && !outcome->replies.empty() && servo.repliesCarryStatus())
        servo.status = outcome->status();
    return outcome;
}

base::Result<base::Bytes> listenAfter(const Context& context, const base::Bytes& request,
                                      base::Duration span)
{
    bus::Transaction transaction;
    transaction.request = protocol::Request::raw(request);
    transaction.request.repeat = protocol::Repeat::Safe; // so that a stop ends the wait
    transaction.retries = 0;
    transaction.priority = context.priority;
    transaction.timeout = span;
    transaction.hold = context.hold;
    transaction.epoch = context.epoch;
    transaction.stop = &context.stop;
    const auto outcome = context.bus.transact(transaction);
    if (!outcome)
        return tl::unexpected(outcome.error());
    return outcome->replies.empty() ? base::Bytes() : outcome->data();
}
} // namespace

bool canEncode(const Servo& servo, const protocol::Request& request)
{
    return protocol::codecFor(servo.protocol).encode(request.in(servo.protocol)).has_value();
}

base::Result<bus::Outcome> pingOnce(const Context& context, base::Protocol protocol, int id,
                                    base::Duration timeout)
{
    bus::Transaction ping;
    ping.request = protocol::Request::ping(id).in(protocol);
    ping.priority = context.priority;
    ping.retries = 0;
    ping.timeout = timeout;
    ping.hold = context.hold;
    ping.epoch = context.epoch;
    ping.stop = &context.stop;
    return context.bus.transact(ping);
}

base::Result<base::Bytes> listenAfterPing(const Context& context, base::Duration span)
{
    const auto ping = protocol::codecFor(base::Protocol::Feetech)
                          .encode(protocol::Request::ping(protocol::broadcastId));
    return ping ? listenAfter(context, *ping, span) : tl::unexpected(ping.error());
}

base::Result<void> readBlock(const Context& context, Servo& servo, int offset, int count,
                             int retries)
{
    const auto outcome =
        send(context, servo, protocol::Request::read(servo.id, offset, count), retries);
    if (!outcome)
        return tl::unexpected(outcome.error());
    servo.image.store(offset, outcome->data(), outcome->sentAt + outcome->roundTrip);
    updateStatus(servo, offset, count);
    return {};
}

base::Result<std::int64_t> readRegister(const Context& context, Servo& servo,
                                        const catalog::Register& reg)
{
    auto done = reg.block ? readBlock(context, servo, reg.block->offset, reg.block->size)
                          : readBlock(context, servo, reg.offset, reg.size);
    if (!done) {
        done.error().registerKey = reg.key;
        return tl::unexpected(done.error());
    }
    return *servo.raw(reg);
}

base::Bytes wireBytes(const Servo& servo, const catalog::Register& reg, std::int64_t raw)
{
    return catalog::encodeRaw(raw, reg, servo.meaning(reg), servo.profile->byteOrder);
}

bool sharesFrame(const catalog::Register& last, const catalog::Register& next)
{
    if (last.block || next.block)
        return last.block == next.block;
    return next.writeOffset == last.writeOffset + last.size;
}

Patch patchOf(const Servo& servo, const RegisterValues& values)
{
    const catalog::Register& first = *values.front().reg;
    Patch patch{first.writeOffset, first.offset, {}};
    if (first.block) {
        const catalog::Block& block = *first.block;
        patch = {block.writeOffset, block.offset,
                 servo.image.bytes(block.offset, block.size)
                     .value_or(base::Bytes(static_cast<std::size_t>(block.size), 0))};
    }
    for (const RegisterValue& value : values) {
        const base::Bytes bytes = wireBytes(servo, *value.reg, value.raw);
        const auto place = static_cast<std::size_t>(value.reg->writeOffset - patch.writeOffset);
        if (patch.data.size() < place + bytes.size())
            patch.data.resize(place + bytes.size());
        std::copy(bytes.begin(), bytes.end(),
                  patch.data.begin() + static_cast<std::ptrdiff_t>(place));
    }
    return patch;
}

base::Result<Patch> freshPatch(const Context& context, Servo& servo, const RegisterValues& values)
{
    const auto& block = values.front().reg->block;
    int givenBytes = 0;
    for (const RegisterValue& value : values)
        givenBytes += value.reg->size;
    if (block && givenBytes < block->size) {
        if (const auto fresh = readBlock(context, servo, block->offset, block->size); !fresh)
            return tl::unexpected(fresh.error());
    }
    return patchOf(servo, values);
}

base::Result<void> writeBlock(const Context& context, Servo& servo, const Patch& patch,
                              protocol::Repeat repeat)
{
    auto request = protocol::Request::write(servo.id, patch.writeOffset, patch.data, repeat);
    request.acknowledged = servo.repliesToWrites();
    const auto outcome = send(context, servo, std::move(request));
    if (!outcome)
        return tl::unexpected(outcome.error());
    return {};
}

void writeUnverified(const Context& context, Servo& servo, const catalog::Register& reg,
                     std::int64_t raw, const base::Error& readFailed)
{
    if (readFailed.code != ErrorCode::LineBusy || reg.block)
        return;
    (void)writeBlock(context, servo, patchOf(servo, {{&reg, raw}}), protocol::Repeat::Safe);
}

bool isReplyLost(const base::Error& error)
{
    switch (error.code) {
    case ErrorCode::Uncertain:
    case ErrorCode::NoReply:
    case ErrorCode::Garbled:
    case ErrorCode::UnexpectedReply:
        return true;
    default:
        return false;
    }
}

void noteResent(const Context& context, const Servo& servo, bool replyLost, const QString& key)
{
    const bool lost = replyLost && servo.repliesToWrites();
    context.note(lost ? NoticeCode::ReplyLostResent : NoticeCode::Resent, servo.id, key);
}

base::Result<void> writeConfirmed(const Context& context, Servo& servo, const Patch& patch)
{
    constexpr int maxAttempts = 2;
    for (int attempt = 0; attempt < maxAttempts; ++attempt) {
        const auto sent = writeBlock(context, servo, patch, protocol::Repeat::Safe);
        if (sent ? servo.repliesToWrites() : !isReplyLost(sent.error()))
            return sent;
        if (const auto back = readBlock(context, servo, patch.readOffset, patch.count()); !back)
            return back;
        if (servo.image.bytes(patch.readOffset, patch.count()) == patch.data)
            return {};
        if (attempt + 1 < maxAttempts)
            noteResent(context, servo, !sent);
    }
    return base::fail(ErrorCode::Refused, QStringLiteral("write"), {}, servo.id);
}

base::Result<void> writeVerified(const Context& context, Servo& servo, const RegisterValues& values)
{
    constexpr int maxAttempts = 2;
    const bool needsTime =
        std::any_of(values.begin(), values.end(),
                    [](const RegisterValue& value) { return needsWriteTime(*value.reg); });
    base::Error last;
    for (int attempt = 0; attempt < maxAttempts; ++attempt) {
        const auto patch = freshPatch(context, servo, values);
        if (!patch)
            return tl::unexpected(patch.error());
        const auto sent = writeBlock(context, servo, *patch, protocol::Repeat::Safe);
        // Any other end (an emergency stop) must not be undone by sending it again.
        if (!sent && !isReplyLost(sent.error()))
            return sent;
        if (needsTime)
            context.bus.clock().sleepFor(epromWriteTime);
        if (auto back = readBlock(context, servo, patch->readOffset, patch->count()); !back) {
            back.error().registerKey = values.front().reg->key;
            return back;
        }
        const auto differs =
            std::find_if(values.begin(), values.end(), [&](const RegisterValue& value) {
                return servo.raw(*value.reg) != value.raw;
            });
        if (differs == values.end())
            return {};
        last = {ErrorCode::Mismatch,
                QStringLiteral("write"),
                QString::number(servo.raw(*differs->reg).value_or(0)),
                servo.id,
                differs->reg->key,
                attempt + 1};
        if (attempt + 1 == maxAttempts)
            break;
        noteResent(context, servo, !sent, differs->reg->key);
    }
    return tl::unexpected(last);
}

base::Result<void> writeVerified(const Context& context, Servo& servo, const catalog::Register& reg,
                                 std::int64_t raw)
{
    return writeVerified(context, servo, {{&reg, raw}});
}

base::Result<void> save(const Context& context, Servo& servo, const catalog::Register& reg)
{
    // There is no reply and no reading to prove it, so one lost frame must not be the end.
    constexpr int sendCount = 2;
    for (int sent = 0; sent < sendCount; ++sent) {
        const auto saved =
            writeBlock(context, servo, {reg.saveOffset, reg.offset, {}}, protocol::Repeat::Safe);
        if (!saved)
            return saved;
        context.bus.clock().sleepFor(epromWriteTime);
    }
    return {};
}
} // namespace device
