// SPDX-License-Identifier: GPL-3.0-or-later
// What the journal still owes a servo that was left in the middle of a commissioning line is
// brought to one side: undone where nothing of it was written, finished otherwise. Internal to
// jobs; its thread. `servo` stays where it is. Errors: those of jobs::recover.
#pragma once

#include "jobs/recover.h"
#include "record/commission_batch.h"

namespace jobs {
/// Concerns intents of this port and this kind of servo begun at `since` or later.
base::Result<void> settleIntents(const device::Context& context, device::Servo& servo,
                                 const QDateTime& since);

/// The journal holds a change of a servo of this kind, begun since then, that has not ended.
bool owesChange(const device::Context& context, const device::Servo& servo, const QDateTime& since);

/// At its old place: is it the very one? Yes where the journal has us open the lock of such a
/// servo, the lock is open still, and was closed when the servo came. Losing power closes it, so
/// this one has not been unplugged since.
bool leftOpen(const device::Context& context, device::Servo& servo,
              const record::CommissionPending& begun);
} // namespace jobs
