// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/motion.h"
#include "device/transactions.h"
#include "device/write_access.h"
#include "jobs/change/change_steps.h"

#include <algorithm>
#include <utility>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
const QString restoreDefaultsOperation = QStringLiteral("restore-defaults");
/// The whole EPROM is rewritten; no official time is known.
constexpr base::Duration rewriteTime = 300ms;

std::vector<base::JournalItem> epromItems(const device::Servo& servo)
{
    std::vector<base::JournalItem> items;
    for (const catalog::Register& reg : servo.profile->registers) {
        const auto raw = servo.raw(reg);
        if (reg.eprom() && reg.writable() && raw)
            items.push_back({reg.key, reg.address, *raw, *raw});
    }
    return items;
}

/// The present values, read afresh. A value that did not change may be in RAM only, so "kept" is
/// not reported.
std::vector<base::ItemResult> itemResults(const device::Servo& servo)
{
    std::vector<base::ItemResult> ends;
    for (const base::JournalItem& item : epromItems(servo))
        ends.push_back({item.key, item.newRaw, QStringLiteral("done")});
    return ends;
}

std::vector<int> ratesOf(const device::Servo& servo, int present)
{
    std::vector<int> rates{present};
    if (const catalog::Register* reg = servo.profile->byRole(Role::BaudRate)) {
        for (const catalog::NamedValue& value : reg->values) {
            const int rate = value.key.toInt();
            if (rate > 0 && rate != present)
                rates.push_back(rate);
        }
    }
    return rates;
}

/// Searches at the old rate first, then at the others of the family; at each under the old ID, then
/// under the factory ID, which counts only if no servo had it before.
base::Result<bool> findAgain(const device::Context& context, device::Servo& servo,
                             bool isFactoryIdFree, const ProgressFn& progress)
{
    const int oldBaud = context.bus.baud();
    std::vector<int> ids{servo.id};
    if (servo.id != factoryId && isFactoryIdFree)
        ids.push_back(factoryId);
    const std::vector<int> rates =
        context.bus.canSetBaud() ? ratesOf(servo, oldBaud) : std::vector<int>{oldBaud};
    const base::Duration began = context.bus.clock().now();
    for (std::size_t i = 0; i < rates.size(); ++i) {
        std::optional<base::Duration> left;
        if (i > 0)
            left = (context.bus.clock().now() - began) * int(rates.size() - i) / int(i);
        if (progress)
            progress({double(i) / double(rates.size()), left, 0, rates[i]});
        if (context.bus.canSetBaud() && !context.bus.setBaud(rates[i]))
            continue; // a rate this adapter cannot run
        for (const int id : ids) {
            const auto answering = isAnswering(context, servo.protocol, id);
            if (!answering && answering.error().code == ErrorCode::LinkLost)
                return tl::unexpected(answering.error());
            if (answering && *answering) {
                const int oldId = std::exchange(servo.id, id);
                servo.baud = context.bus.baud();
                device::transferVerification(context.bus, servo, oldId, oldBaud);
                return true;
            }
        }
    }
    if (context.bus.canSetBaud()) {
        if (const auto back = context.bus.setBaud(oldBaud); !back)
            return tl::unexpected(back.error());
    }
    return false;
}

std::vector<QString> differences(const device::Servo& before, const device::Servo& after)
{
    std::vector<QString> keys;
    for (const catalog::Register& reg : before.profile->registers) {
        if (reg.eprom() && reg.writable() && before.raw(reg) != after.raw(reg))
            keys.push_back(reg.key);
    }
    return keys;
}

/// Sends 0x06 once, and a second time only after reading proved that the first one never arrived.
base::Result<void> restore(const device::Context& context, device::Servo& servo,
                           bool isFactoryIdFree, const ProgressFn& progress,
                           RestoreDefaultsReport& report)
{
    const device::Servo before = servo;
    constexpr int sends = 2;
    for (int attempt = 0; attempt < sends; ++attempt) {
        auto request = protocol::Request::restore(servo.id);
        request.acknowledged = before.repliesToWrites();
        const auto sent = sendOnce(context, request.in(servo.protocol));
        if (!sent)
            return tl::unexpected(sent.error());
        context.bus.clock().sleepFor(rewriteTime);
        const auto found = findAgain(context, servo, isFactoryIdFree, progress);
        if (!found)
            return tl::unexpected(found.error());
        if (!*found)
            return base::fail(ErrorCode::NoReply, restoreDefaultsOperation, {}, servo.id);
        servo.image.clear();
        if (const auto fresh = device::readAll(context, servo); !fresh)
            return fresh;
        report.changed = differences(before, servo);
        const bool lost = sent->lost || !before.repliesToWrites();
        if (!lost || !report.changed.empty())
            return {};
        if (attempt + 1 < sends)
            device::noteResent(context, before, sent->lost);
    }
    return base::fail(ErrorCode::Uncertain, restoreDefaultsOperation,
                      QStringLiteral("nothing-changed"), servo.id);
}
} // namespace

base::Result<RestoreDefaultsReport>
restoreDefaults(const device::Context& outer, device::Servo& servo, const ProgressFn& progress)
{
    if (const auto writable = device::requireWritable(servo, restoreDefaultsOperation); !writable)
        return tl::unexpected(writable.error());
    if (const auto possible =
            requireEncodable(servo, protocol::Request::restore(servo.id), restoreDefaultsOperation,
                             QStringLiteral("no-restore"));
        !possible)
        return tl::unexpected(possible.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    if (const auto may = device::beginWriting(context, servo, restoreDefaultsOperation); !may)
        return tl::unexpected(may.error());
    if (const auto fresh = device::readAll(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    const auto factoryFree = servo.id == factoryId ? base::Result<bool>(false)
                                                   : isIdFree(context, servo.protocol, factoryId);
    const bool isFactoryIdFree = factoryFree.value_or(false);
    if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
        return tl::unexpected(off.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, restoreDefaultsOperation, {}, servo.id);
    const auto uuid = beginIntent(context, servo, base::IntentKind::Restore, epromItems(servo));
    if (!uuid)
        return tl::unexpected(uuid.error());

    RestoreDefaultsReport report;
    report.oldId = servo.id;
    report.oldBaud = context.bus.baud();
    auto eprom = device::UnlockedEprom::open(context, servo, *servo.profile->byRole(Role::Id));
    base::Result<void> done;
    if (eprom) {
        done = restore(context, servo, isFactoryIdFree, progress, report);
        report.lock = eprom->close();
    } else {
        done = tl::unexpected(eprom.error());
        report.lock = device::closeLock(context, servo);
    }
    report.newId = servo.id;
    report.newBaud = context.bus.baud();
    if (done && report.lock == device::LockState::Closed)
        context.record(*uuid, servo.id, {QStringLiteral("done"), {}, itemResults(servo)});
    if (!done)
        return tl::unexpected(done.error());
    return report;
}
} // namespace jobs
