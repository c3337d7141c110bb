// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/change_steps.h"

#include "device/talk.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;

namespace {
bus::Transaction pingOf(const device::Context& context, base::Protocol protocol, int id)
{
    bus::Transaction ping;
    ping.request = protocol::Request::ping(id).in(protocol);
    ping.priority = context.priority;
    ping.patience = context.bus.replyTimeout();
    ping.hold = context.hold;
    return ping;
}

base::Result<bool> heard(const base::Result<bus::Outcome>& outcome)
{
    // Who refuses to say more is there all the same.
    if (outcome || outcome.error().code == ErrorCode::Refused)
        return true;
    if (outcome.error().code == ErrorCode::NoAnswer)
        return false;
    return tl::unexpected(outcome.error());
}
} // namespace

base::Result<bool> answers(const device::Context& context, base::Protocol protocol, int id,
                           int retries)
{
    bus::Transaction ping = pingOf(context, protocol, id);
    ping.retries = retries;
    return heard(context.bus.transact(ping));
}

base::Result<bool> isFree(const device::Context& context, base::Protocol protocol, int id,
                          int questions)
{
    context.bus.takeStrays();
    for (int i = 0; i < questions; ++i) {
        bus::Transaction ping = pingOf(context, protocol, id);
        ping.retries = 0;
        ping.stop = &context.stop; // nothing has been written yet
        const auto taken = heard(context.bus.transact(ping));
        if (!taken || *taken)
            return taken.map([](bool answered) { return !answered; });
    }
    if (const auto listened = context.bus.listen(context.bus.replyTimeout()); !listened)
        return tl::unexpected(listened.error());
    const auto strays = context.bus.takeStrays();
    return std::none_of(strays.begin(), strays.end(),
                        [id](const bus::Stray& stray) { return stray.id == id; });
}

base::Result<Sent> sendOnce(const device::Context& context, protocol::Request request)
{
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.priority = context.priority;
    transaction.hold = context.hold;
    const auto outcome = context.bus.transact(transaction);
    if (outcome)
        return Sent{false, outcome->parts.empty() ? -1 : outcome->parts.front().id};
    if (device::answerLost(outcome.error()))
        return Sent{true, -1};
    return tl::unexpected(outcome.error());
}

base::Result<QString> journalIntent(const device::Context& context, const device::Servo& servo,
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
    if (!certainEnd(report))
        return;
    context.record(uuid, report.id,
                   {report.allGood() ? QStringLiteral("done") : QStringLiteral("failed"), QString(),
                    report.itemEnds()});
}

base::Result<void> requireSayable(const device::Servo& servo, const protocol::Request& request,
                                  const QString& operation, const QString& detail)
{
    if (device::canSay(servo, request))
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
    case ErrorCode::NoAnswer:
        result.outcome = device::WriteOutcome::NoAnswer;
        break;
    default:
        result.outcome = device::WriteOutcome::Unknown;
        break;
    }
    return result;
}

void doubt(device::WriteResult& result)
{
    if (!result.readBack)
        return;
    result.outcome = device::WriteOutcome::Unknown;
    result.error = base::Error{ErrorCode::Uncertain, QStringLiteral("keep"),
                               QStringLiteral("restarted"), -1, result.key};
}

bool certainEnd(const device::WriteReport& report)
{
    for (const device::WriteResult& result : report.writes) {
        if (result.outcome == device::WriteOutcome::Unknown ||
            result.outcome == device::WriteOutcome::NoAnswer)
            return false;
    }
    return report.lock == device::LockState::Closed || report.lock == device::LockState::None;
}
} // namespace jobs
