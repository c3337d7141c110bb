// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission.h"

#include "jobs/commission/commission_recovery.h"
#include "jobs/commission/commission_runner.h"

#include <array>

namespace jobs {
using base::ErrorCode;

namespace {
const QString commissionOperation = QStringLiteral("commission");

base::Result<void> checkCommissionSpec(const device::Context& context, const CommissionSpec& spec,
                                       const record::CommissionBatch& batch)
{
    const auto refuse = [](const QString& why) -> base::Result<void> {
        return base::fail(ErrorCode::BadArgument, commissionOperation, why);
    };
    for (const int id : spec.ids) {
        if (id < 0 || id > protocol::maxId)
            return refuse(QStringLiteral("ID %1").arg(id));
    }
    if (spec.ids.empty() && batch.pending.empty())
        return refuse(QStringLiteral("no IDs"));
    if (spec.baud > 0 && !context.bus.canSetBaud())
        return refuse(QStringLiteral("a bridge keeps its rate"));
    return {};
}
} // namespace

QString stepName(CommissionStep step)
{
    constexpr std::array names{"waiting", "blocked", "checking", "confirm", "snapshot", "template",
                               "id",      "rate",    "center",   "health",  "unplug"};
    return QString::fromLatin1(names.at(static_cast<std::size_t>(step)));
}

QString obstacleName(CommissionObstacle obstacle)
{
    constexpr std::array names{"", "several-servos", "twin-ids", "unreadable", "lost"};
    return QString::fromLatin1(names.at(static_cast<std::size_t>(obstacle)));
}

base::Result<CommissionEnd> commission(const device::Context& outer, const CommissionSpec& spec,
                                       record::CommissionBatch& batch, const QString& csvPath,
                                       const CommissionCallbacks& callbacks)
{
    if (const auto good = checkCommissionSpec(outer, spec, batch); !good)
        return tl::unexpected(good.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    updateLockStates(context, batch.pending); // the program may have ended in the middle
    // What cannot be kept must be known before the first servo, not after it.
    if (const auto saveResult = record::saveCommissionBatch(batch, csvPath); !saveResult)
        return tl::unexpected(saveResult.error());
    const int baudBefore = context.bus.baud();
    auto end = CommissionRunner(context, spec, batch, csvPath, callbacks).run();
    // A set-up that broke off ends here: what its journal holds is said of the lock.
    const auto pendingBefore = batch.pending;
    updateLockStates(context, batch.pending);
    if (batch.pending != pendingBefore)
        (void)record::saveCommissionBatch(batch, csvPath); // why it ended is said already
    if (context.bus.canSetBaud() && context.bus.baud() != baudBefore)
        (void)context.bus.setBaud(baudBefore); // a lost link has no rate
    if (!end && end.error().code == ErrorCode::Stopped)
        return CommissionEnd::Stopped;
    return end;
}
} // namespace jobs
