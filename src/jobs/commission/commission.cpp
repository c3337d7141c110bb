// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission.h"

#include "jobs/commission/commission_recovery.h"
#include "jobs/commission/commission_runner.h"

namespace jobs {
using base::ErrorCode;

namespace {
const QString commissionOperation = QStringLiteral("commission");

base::Result<void> checkCommissionSpec(const device::Context& context, const CommissionSpec& spec,
                                       const results::CommissionBatch& batch)
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

base::Result<CommissionEnd> commission(const device::Context& outer, const CommissionSpec& spec,
                                       results::CommissionBatch& batch, const QString& csvPath,
                                       const CommissionCallbacks& callbacks)
{
    if (const auto good = checkCommissionSpec(outer, spec, batch); !good)
        return tl::unexpected(good.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    updateLockStates(context, batch.pending); // the program may have been interrupted
    // A file that cannot be written must be known before the first servo.
    if (const auto saveResult = results::saveCommissionBatch(batch, csvPath); !saveResult)
        return tl::unexpected(saveResult.error());
    const int baudBefore = context.bus.baud();
    auto end = CommissionRunner(context, spec, batch, csvPath, callbacks).run();
    // After an interrupted setup, the batch records what the journal knows of the lock.
    const auto pendingBefore = batch.pending;
    updateLockStates(context, batch.pending);
    if (batch.pending != pendingBefore)
        (void)results::saveCommissionBatch(batch, csvPath); // the error that ended the line counts
    if (context.bus.canSetBaud() && context.bus.baud() != baudBefore)
        (void)context.bus.setBaud(baudBefore); // a lost link has no rate
    if (!end && end.error().code == ErrorCode::Stopped)
        return CommissionEnd::Stopped;
    return end;
}
} // namespace jobs
