// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/transactions.h"
#include "device/write_access.h"
#include "jobs/change/change_steps.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using device::NoticeCode;
using device::WriteOutcome;

namespace {
const QString changeBaudOperation = QStringLiteral("set-baud");

base::Result<std::int64_t> baudCode(const device::Servo& servo, const catalog::Register& reg,
                                    int baud)
{
    QStringList known;
    for (const catalog::NamedValue& value : reg.values) {
        if (value.key == QString::number(baud))
            return value.value;
        known.append(value.key);
    }
    return base::fail(ErrorCode::OutOfRange, changeBaudOperation, known.join(QStringLiteral(", ")),
                      servo.id);
}

/// Opens the new rate and goes back: a servo must never get a rate that the adapter cannot run.
base::Result<void> checkRateSupported(bus::Bus& bus, int newBaud)
{
    const int oldBaud = bus.baud();
    const auto can = bus.setBaud(newBaud);
    const auto back = bus.setBaud(oldBaud);
    return can ? back : can;
}

/// Tries the new rate, then the old. Leaves the bus at the rate where the servo answers, at the old
/// one if it does not. True if it answers.
base::Result<bool> locate(const device::Context& context, const device::Servo& servo, int oldBaud,
                          int newBaud)
{
    for (const int baud : {newBaud, oldBaud}) {
        if (const auto set = context.bus.setBaud(baud); !set)
            return tl::unexpected(set.error());
        const auto answering = isAnswering(context, servo.protocol, servo.id);
        if (!answering && answering.error().code == ErrorCode::LinkLost)
            return tl::unexpected(answering.error());
        if (answering && *answering)
            return true;
    }
    return false;
}

base::Result<void> writeAndVerify(const device::Context& context, device::Servo& servo,
                                  std::int64_t code, int newBaud, device::WriteResult& result)
{
    const catalog::Register& reg = *servo.profile->byRole(Role::BaudRate);
    const int oldBaud = context.bus.baud();
    constexpr int sends = 2;
    for (int attempt = 0; attempt < sends; ++attempt) {
        auto request =
            protocol::Request::write(servo.id, reg.writeOffset, device::wireBytes(servo, reg, code),
                                     protocol::Repeat::Never);
        request.acknowledged = servo.repliesToWrites();
        const auto sent = sendOnce(context, request.in(servo.protocol));
        if (!sent)
            return tl::unexpected(sent.error());
        context.bus.clock().sleepFor(device::epromWriteTime);
        const auto found = locate(context, servo, oldBaud, newBaud);
        if (!found)
            return tl::unexpected(found.error());
        if (!*found)
            return base::fail(ErrorCode::NoReply, changeBaudOperation, {}, servo.id);
        servo.baud = context.bus.baud();
        device::transferVerification(context.bus, servo, servo.id, oldBaud);
        const auto back = device::readRegister(context, servo, reg);
        if (!back)
            return tl::unexpected(back.error());
        result.readBack = *back;
        if (*back == code) {
            if (servo.baud != newBaud)
                context.note(NoticeCode::EffectiveAfterRestart, servo.id, reg.key, newBaud);
            return {};
        }
        if (attempt + 1 < sends)
            device::noteResent(context, servo, sent->lost, reg.key);
    }
    return base::fail(ErrorCode::Refused, changeBaudOperation, {}, servo.id);
}

device::WriteReport changeUnlocked(const device::Context& context, device::Servo& servo,
                                   std::int64_t code, int newBaud)
{
    const catalog::Register& reg = *servo.profile->byRole(Role::BaudRate);
    device::WriteReport report;
    report.id = servo.id;
    device::WriteResult result{
        reg.key, reg.address, servo.raw(reg), code, {}, WriteOutcome::Unknown, {}};
    const int oldBaud = context.bus.baud();
    auto eprom = device::UnlockedEprom::open(context, servo, reg);
    if (!eprom) {
        result.outcome = device::outcomeBeforeSending(eprom.error());
        result.error = eprom.error();
        report.lock = device::closeLock(context, servo);
    } else {
        const auto followed = writeAndVerify(context, servo, code, newBaud, result);
        if (followed)
            result.outcome = WriteOutcome::Kept;
        else
            result = failedResult(result, followed.error());
        report.lock = eprom->close();
        if (report.lock == device::LockState::Closed && !eprom->stayedOpen())
            markUncertain(result);
        if (context.bus.baud() != oldBaud)
            context.note(NoticeCode::RateChanged, servo.id, reg.key, context.bus.baud());
    }
    report.writes.push_back(result);
    return report;
}

base::Result<void> checkPreconditions(const device::Context& context, const device::Servo& servo)
{
    if (const auto writable = device::requireWritable(servo, changeBaudOperation); !writable)
        return writable;
    if (servo.profile->byRole(Role::BaudRate) == nullptr)
        return base::fail(ErrorCode::NotSupported, changeBaudOperation,
                          QStringLiteral("fixed-rate"), servo.id);
    // Behind a TCP bridge the program could not follow the servo to its new rate.
    if (!context.bus.canSetBaud())
        return base::fail(ErrorCode::NotSupported, changeBaudOperation, QStringLiteral("bridge"),
                          servo.id);
    return {};
}
} // namespace

base::Result<device::WriteReport> changeBaud(const device::Context& outer, device::Servo& servo,
                                             int newBaud)
{
    if (const auto possible = checkPreconditions(outer, servo); !possible)
        return tl::unexpected(possible.error());
    const catalog::Register& reg = *servo.profile->byRole(Role::BaudRate);
    const auto code = baudCode(servo, reg, newBaud);
    if (!code)
        return tl::unexpected(code.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    if (const auto may = device::beginWriting(context, servo, changeBaudOperation); !may)
        return tl::unexpected(may.error());
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    if (servo.raw(reg) == *code && context.bus.baud() == newBaud) {
        context.note(NoticeCode::AlreadySet, servo.id, reg.key);
        device::WriteReport emptyReport;
        emptyReport.id = servo.id;
        return emptyReport;
    }
    if (const auto can = checkRateSupported(context.bus, newBaud); !can)
        return tl::unexpected(can.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, changeBaudOperation, {}, servo.id);
    const auto uuid = beginIntent(context, servo, base::IntentKind::SetBaud,
                                  {{reg.key, reg.address, servo.raw(reg).value_or(0), *code}});
    if (!uuid)
        return tl::unexpected(uuid.error());
    const device::WriteReport report = changeUnlocked(context, servo, *code, newBaud);
    endIntent(context, *uuid, report);
    return report;
}
} // namespace jobs
