// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/persistence.h"
#include "device/reader.h"
#include "device/transactions.h"
#include "device/write_access.h"
#include "jobs/change/change_steps.h"

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using device::NoticeCode;
using device::WriteOutcome;

namespace {
const QString changeIdOperation = QStringLiteral("set-id");

/// Feetech and LX: 0–253, Modbus: 1–247; never the broadcast address.
base::Result<void> checkId(const device::Servo& servo, int newId)
{
    const catalog::Register& reg = *servo.profile->byRole(Role::Id);
    const std::int64_t lowest = reg.min.value_or(0);
    const std::int64_t highest = reg.max.value_or(protocol::maxId);
    if (newId >= lowest && newId <= highest)
        return {};
    base::Error error{ErrorCode::OutOfRange, changeIdOperation,
                      QStringLiteral("%1 … %2").arg(lowest).arg(highest), servo.id};
    error.registerKey = reg.key;
    return tl::unexpected(error);
}

/// Only silence under the new ID means that it is free; even a collision means that it is taken.
/// Other errors concern the servo that still has its old ID.
base::Result<void> ensureIdFree(const device::Context& context, base::Protocol protocol, int oldId,
                                int newId)
{
    const auto free = isIdFree(context, protocol, newId);
    if (!free) {
        const ErrorCode code = free.error().code;
        if (code == ErrorCode::Garbled || code == ErrorCode::UnexpectedReply)
            return base::fail(ErrorCode::IdInUse, changeIdOperation, QStringLiteral("garbled"),
                              newId);
        base::Error error = free.error();
        error.id = oldId;
        return tl::unexpected(error);
    }
    if (!*free)
        return base::fail(ErrorCode::IdInUse, changeIdOperation, {}, newId);
    return {};
}

/// The ID under which the servo answers after the write; -1: none. Its lock is open, so a short
/// interruption of the link or the computer is waited for.
base::Result<int> locate(const device::Context& context, base::Protocol protocol, int oldId,
                         int newId)
{
    constexpr int rounds = 3;
    constexpr base::Duration pause = std::chrono::milliseconds(200);
    for (int round = 0; round < rounds; ++round) {
        if (round > 0)
            context.bus.clock().sleepFor(pause);
        for (const int id : {newId, oldId}) {
            const auto answering = isAnswering(context, protocol, id);
            if (!answering && answering.error().code == ErrorCode::LinkLost)
                return tl::unexpected(answering.error());
            if (answering && *answering)
                return id;
        }
    }
    return -1;
}

/// A second write goes to the servo of the first one only: it has not confirmed the new ID, and its
/// lock is still open. Another servo in its place has a closed lock.
bool canRetryWrite(const device::Context& context, device::Servo& servo, const SendResult& sent,
                   int newId)
{
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    if (sent.answeredBy == newId || lock == nullptr)
        return sent.answeredBy != newId;
    const auto flag = device::readRegister(context, servo, *lock);
    return flag && device::isLockOpen(*flag);
}

/// Writes the ID and follows the servo to the ID under which it answers then.
base::Result<void> writeAndVerify(const device::Context& context, device::Servo& servo, int newId,
                                  device::WriteResult& result)
{
    const catalog::Register& reg = *servo.profile->byRole(Role::Id);
    const int oldId = servo.id;
    constexpr int sends = 2;
    for (int attempt = 0; attempt < sends; ++attempt) {
        auto request = protocol::Request::write(
            oldId, reg.writeOffset, device::wireBytes(servo, reg, newId), protocol::Repeat::Never);
        request.acknowledged = servo.repliesToWrites();
        request.alternateReplyId = newId;
        const auto sent = sendOnce(context, request.in(servo.protocol));
        if (!sent)
            return tl::unexpected(sent.error());
        if (sent->answeredBy == newId)
            context.note(NoticeCode::AckFromNewId, oldId, reg.key, newId);
        context.bus.clock().sleepFor(device::epromWriteTime);
        const auto place = locate(context, servo.protocol, oldId, newId);
        if (!place)
            return tl::unexpected(place.error());
        if (*place < 0) {
            // A servo that has acknowledged under the new ID has its lock there.
            servo.id = sent->answeredBy == newId ? newId : oldId;
            device::transferVerification(context.bus, servo, oldId, context.bus.baud());
            return base::fail(ErrorCode::NoReply, changeIdOperation, {}, newId);
        }
        servo.id = *place;
        device::transferVerification(context.bus, servo, oldId, context.bus.baud());
        const auto back = device::readRegister(context, servo, reg);
        if (!back)
            return tl::unexpected(back.error());
        result.readBack = *back;
        if (*place == newId || *back == newId)
            return {};
        // It still answers with the old ID and value: nothing has happened, so writing again is
        // safe.
        if (!canRetryWrite(context, servo, *sent, newId))
            return base::fail(ErrorCode::Uncertain, changeIdOperation, QStringLiteral("exchanged"),
                              oldId);
        if (attempt + 1 < sends)
            device::noteResent(context, servo, sent->lost, reg.key);
    }
    return base::fail(ErrorCode::Refused, changeIdOperation, {}, oldId);
}

device::WriteReport changeUnlocked(const device::Context& context, device::Servo& servo, int newId)
{
    const catalog::Register& reg = *servo.profile->byRole(Role::Id);
    device::WriteReport report;
    device::WriteResult result{reg.key, reg.address,           servo.id, newId,
                               {},      WriteOutcome::Unknown, {}};
    const int oldId = servo.id;
    auto eprom = device::UnlockedEprom::open(context, servo, reg);
    if (!eprom) {
        result.outcome = device::outcomeBeforeSending(eprom.error());
        result.error = eprom.error();
        report.lock = device::closeLock(context, servo);
    } else {
        const auto followed = writeAndVerify(context, servo, newId, result);
        if (followed) {
            result.outcome = result.readBack == newId ? WriteOutcome::Kept : WriteOutcome::Mismatch;
        } else {
            result = failedResult(result, followed.error());
        }
        report.lock = eprom->close();
        if (report.lock == device::LockState::Closed && !eprom->stayedOpen())
            markUncertain(result);
        if (servo.id != oldId)
            context.note(NoticeCode::IdChanged, oldId, reg.key, servo.id);
    }
    report.id = servo.id;
    report.writes.push_back(result);
    return report;
}

/// An ID that answers in two protocols would make every later command ambiguous.
std::vector<base::Protocol> protocolsOnBus(const device::Context& context,
                                           const device::Servo& servo)
{
    std::vector<base::Protocol> protocols{servo.protocol};
    if (!context.bus.canSetBaud())
        return protocols;
    for (const base::Protocol other : context.catalog.protocolsAt(context.bus.baud())) {
        if (other != servo.protocol)
            protocols.push_back(other);
    }
    return protocols;
}
} // namespace

base::Result<device::WriteReport> changeId(const device::Context& outer, device::Servo& servo,
                                           int newId)
{
    if (const auto writable = device::requireWritable(servo, changeIdOperation); !writable)
        return tl::unexpected(writable.error());
    if (const auto possible = checkId(servo, newId); !possible)
        return tl::unexpected(possible.error());
    if (newId == servo.id) {
        outer.note(NoticeCode::AlreadySet, servo.id);
        device::WriteReport emptyReport;
        emptyReport.id = servo.id;
        return emptyReport;
    }
    const device::Owned owned = device::own(outer, {servo.id, newId});
    const device::Context& context = owned.context;
    if (const auto may = device::beginWriting(context, servo, changeIdOperation); !may)
        return tl::unexpected(may.error());
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    for (const base::Protocol protocol : protocolsOnBus(context, servo)) {
        if (const auto free = ensureIdFree(context, protocol, servo.id, newId); !free)
            return tl::unexpected(free.error());
    }
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, changeIdOperation, {}, servo.id);
    const catalog::Register& reg = *servo.profile->byRole(Role::Id);
    const auto uuid = beginIntent(context, servo, base::IntentKind::SetId,
                                  {{reg.key, reg.address, servo.id, newId}});
    if (!uuid)
        return tl::unexpected(uuid.error());
    const device::WriteReport report = changeUnlocked(context, servo, newId);
    endIntent(context, *uuid, report);
    return report;
}
} // namespace jobs
