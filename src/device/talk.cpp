// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/talk.h"

namespace device {
namespace {
base::Result<bus::Outcome> say(const Context& context, Servo& servo, protocol::Request request)
{
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.request.protocol = servo.protocol;
    transaction.priority = context.priority;
    transaction.hold = context.hold;
    auto outcome = context.bus.transact(transaction);
    if (outcome && !outcome->parts.empty())
        servo.status = outcome->status();
    return outcome;
}
} // namespace

base::Result<void> readBlock(const Context& context, Servo& servo, int address, int count)
{
    const auto outcome = say(context, servo, protocol::Request::read(servo.id, address, count));
    if (!outcome)
        return tl::unexpected(outcome.error());
    servo.image.store(address, outcome->data(), outcome->sentAt + outcome->roundTrip);
    return {};
}

base::Result<std::int64_t> readRegister(const Context& context, Servo& servo,
                                        const catalog::Register& reg)
{
    auto done = readBlock(context, servo, reg.offset, reg.size);
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

base::Result<void> writeBlock(const Context& context, Servo& servo, int address, base::Bytes data,
                              protocol::Repeat repeat)
{
    auto request = protocol::Request::write(servo.id, address, std::move(data), repeat);
    request.acknowledged = servo.answersWrites();
    const auto outcome = say(context, servo, std::move(request));
    if (!outcome)
        return tl::unexpected(outcome.error());
    return {};
}

bool answerLost(const base::Error& error)
{
    switch (error.code) {
    case base::ErrorCode::Uncertain:
    case base::ErrorCode::NoAnswer:
    case base::ErrorCode::Garbled:
    case base::ErrorCode::WrongAnswer:
        return true;
    default:
        return false;
    }
}

base::Result<void> writeProven(const Context& context, Servo& servo, int address,
                               const base::Bytes& data)
{
    constexpr int tries = 2;
    const int count = static_cast<int>(data.size());
    for (int attempt = 0; attempt < tries; ++attempt) {
        const auto sent = writeBlock(context, servo, address, data, protocol::Repeat::Safe);
        if (sent ? servo.answersWrites() : !answerLost(sent.error()))
            return sent;
        if (const auto back = readBlock(context, servo, address, count); !back)
            return back;
        if (servo.image.bytes(address, count) == data)
            return {};
    }
    return base::fail(base::ErrorCode::Refused, QStringLiteral("write"), {}, servo.id);
}

base::Result<void> writeVerified(const Context& context, Servo& servo, const catalog::Register& reg,
                                 std::int64_t raw)
{
    constexpr int tries = 2;
    base::Error last;
    for (int attempt = 0; attempt < tries; ++attempt) {
        const auto sent = writeBlock(context, servo, reg.writeOffset, wireBytes(servo, reg, raw),
                                     protocol::Repeat::Safe);
        if (!sent && sent.error().code == base::ErrorCode::LinkLost)
            return sent;
        if (reg.eprom())
            context.bus.clock().sleepFor(epromWriteTime);
        const auto back = readRegister(context, servo, reg);
        if (!back)
            return tl::unexpected(back.error());
        if (*back == raw)
            return {};
        last = {base::ErrorCode::Mismatch,
                QStringLiteral("write"),
                QString::number(*back),
                servo.id,
                reg.key,
                attempt + 1};
    }
    return tl::unexpected(last);
}
} // namespace device
