// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission_settle.h"

namespace jobs {
namespace {
base::Result<void> settleOne(const device::Context& context, const QString& uuid)
{
    const auto seen = recover(context, RecoverAction::Look, {false, uuid, {}});
    if (!seen)
        return tl::unexpected(seen.error());
    if (seen->empty())
        return {};
    const Finding finding = seen->front().before.finding;
    if (finding == Finding::NoAnswer || finding == Finding::OtherServo)
        return {};
    const auto done =
        recover(context, finding == Finding::AllOld ? RecoverAction::Undo : RecoverAction::Finish,
                {false, uuid, {}});
    if (!done)
        return tl::unexpected(done.error());
    if (!done->empty() && done->front().error)
        return tl::unexpected(*done->front().error);
    return {};
}
} // namespace

base::Result<void> settleIntents(const device::Context& context, device::Servo& servo,
                                 const QDateTime& since)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    for (const base::Intent& intent : *open) {
        // Both times are of this computer; the batch's is cut to seconds.
        const bool ours = intent.servo.port == context.bus.portName() && intent.at >= since &&
                          intent.servo.sameKind(servo.identity());
        if (!ours)
            continue;
        if (const auto settled = settleOne(context, intent.uuid); !settled)
            return settled;
    }
    return {};
}
} // namespace jobs
