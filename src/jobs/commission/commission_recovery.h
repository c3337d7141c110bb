// SPDX-License-Identifier: GPL-3.0-or-later
// What the journal still owes a servo that was left in the middle of a commissioning line is
// brought to one side: undone where nothing of it was written, finished otherwise. Internal to
// jobs; its thread. Errors: those of jobs::recover.
#pragma once

#include "jobs/recover/recover.h"
#include "results/commission_batch.h"

namespace jobs {
/// Brings the open changes of this port that `begun` made to one side.
base::Result<void> recoverOpenIntents(const device::Context& context,
                                      const record::PendingCommission& pending);

/// The journal holds a change of this servo that has not ended.
bool hasOpenIntent(const device::Context& context, const record::PendingCommission& pending);

/// The journal holds a change of it that opened its lock and has not ended.
void updateLockStates(const device::Context& context, std::vector<record::PendingCommission>& all);

/// Is `servo` the very one, at its old ID or its new one? Yes where the journal has us open the
/// lock of such a servo, the lock is open still, and was closed when the servo came. Losing power
/// closes it, so this one has not been unplugged since.
bool hasLeftLockOpen(const device::Context& context, device::Servo& servo,
                     const record::PendingCommission& pending);
} // namespace jobs
