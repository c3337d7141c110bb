// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/change/change_steps.h"

#include "bus/late_reply_guard.h"
#include "device/transactions.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;

namespace {
bus::Transaction makePing(const device::Context& context, base::Protocol protocol, int id)
{
    bus::Transaction ping;
    ping.request = protocol::Request::ping(id).in(protocol);
    ping.priority = context.priority;
    ping.timeout = context.bus.maxReplyLateness();
    ping.hold = context.hold;
    return ping;
}

base::Result<bool> isReply(const base::Result<bus::Outcome>& outcome)
{
    // A refusal also proves that the servo is there.
    if (outcome || outcome.error().code == ErrorCode::Refused)
        return true;
    if (outcome.error().code == ErrorCode::NoReply)
        return false;
    return tl::unexpected(outcome.error());
}
} // namespace

base::Result<bool> isAnswering(const device::Context& context, base::Protocol protocol, int id,
                               int retries)
{
    bus::Transaction ping = makePing(context, protocol, id);
    ping.retries = retries;
    return isReply(context.bus.transact(ping));
}

base::Result<bool> isIdFree(const device::Context& context, base::Protocol protocol, int id,
                            int attempts)
{
    context.bus.takeUnexpectedFrames();
    for (int i = 0; i < attempts; ++i) {
        bus::Transaction ping = makePing(context, protocol, id);
        ping.retries = 0;
        ping.stop = &context.stop; // nothing has been written yet
        const auto isTaken = isReply(context.bus.transact(ping));
        if (!isTaken || *isTaken)
            return isTaken.map([](bool answered) { return !answered; });
    }
    // A busy computer may hold back the reply to every attempt; a guess may be quicker.
    const auto latest = attempts > 1 ? bus::LateReplyGuard::maxStall : base::Duration();
    if (const auto listened = context.bus.listen(std::max(latest, context.bus.maxReplyLateness()));
        !listened)
        return tl::unexpected(listened.error());
    const auto strays = context.bus.takeUnexpectedFrames();
    return std::none_of(strays.begin(), strays.end(),
                        [id](const bus::UnexpectedFrame& stray) { return stray.id == id; });
}

base::Result<SendResult> sendOnce(const device::Context& context, protocol::Request request)
{
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.priority = context.priority;
    transaction.hold = context.hold;
    const auto outcome = context.bus.transact(transaction);
    if (outcome)
        return SendResult{false, outcome->replies.empty() ? -1 : outcome->replies.front().id};
    if (device::isReplyLost(outcome.error()))
        return SendResult{true, -1};
    return tl::unexpected(outcome.error());
}

base::Result<QString> beginIntent(const device::Context& context, const device::Servo& servo,
                                  base::IntentKind kind, std::vector<base::JournalItem> items)
{
    base::Intent intent;
    intent.kind = kind;
    intent.lockOpened = servo.profile->byRole(catalog::Role::Lock) != nullptr;
    intent.servo = servo.identity();
    intent.items = std::move(items);
    return context.journal.begin(intent);
}

void endIntent(const device::Context& context, const QString& uuid, int id, bool certain, bool good)
{
    if (certain)
        context.record(uuid, id,
                       {good ? QStringLiteral("done") : QStringLiteral("failed"), QString()});
}

void endIntent(const device::Context& context, const QString& uuid,
               const device::WriteReport& report)
{
    if (!hasCertainOutcome(report))
        return;
    context.record(uuid, report.id,
                   {report.isSuccessful() ? QStringLiteral("done") : QStringLiteral("failed"),
                    QString(), report.itemResults()});
}

base::Result<void> requireEncodable(const device::Servo& servo, const protocol::Request& request,
                                    const QString& operation, const QString& detail)
{
    if (device::canEncode(servo, request))
        return {};
    return base::fail(ErrorCode::NotSupported, operation, detail, servo.id);
}

device::WriteResult failedResult(device::WriteResult result, const base::Error& error)
{
    result.error = error;
    switch (error.code) {
    case ErrorCode::Refused:
        result.outcome = device::WriteOutcome::Refused;
        break;
    case ErrorCode::NoReply:
        result.outcome = device::WriteOutcome::NoReply;
        break;
    default:
        result.outcome = device::WriteOutcome::Unknown;
        break;
    }
    return result;
}

void markUncertain(device::WriteResult& result)
{
    if (!result.readBack)
        return;
    result.outcome = device::WriteOutcome::Unknown;
    result.error = base::Error{ErrorCode::Uncertain, QStringLiteral("keep"),
                               QStringLiteral("restarted"), -1, result.key};
}

bool hasCertainOutcome(const device::WriteReport& report)
{
    for (const device::WriteResult& result : report.writes) {
        if (result.outcome == device::WriteOutcome::Unknown ||
            result.outcome == device::WriteOutcome::NoReply)
            return false;
    }
    return report.lock == device::LockState::Closed || report.lock == device::LockState::None;
}
} // namespace jobs
