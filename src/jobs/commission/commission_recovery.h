// SPDX-License-Identifier: GPL-3.0-or-later
// Ends the open changes in the journal of a servo that a commissioning line left unfinished: they
// are undone if nothing was written, and finished otherwise. Internal to jobs; the job's thread.
// Errors are those of jobs::recover.
#pragma once

#include "jobs/recover/recover.h"
#include "results/commission_batch.h"

namespace jobs {
/// Undoes or finishes the open changes of this servo on this port.
base::Result<void> recoverOpenIntents(const device::Context& context,
                                      const results::PendingCommission& pending);

/// The journal holds a change of this servo that has not ended.
bool hasOpenIntent(const device::Context& context, const results::PendingCommission& pending);

/// Sets lockOpen where the journal holds an open change that opened the lock of that servo.
void updateLockStates(const device::Context& context, std::vector<results::PendingCommission>& all);

/// Whether `servo` is the same one, under its old ID or its new one. It is if the journal records
/// that the lock of such a servo was opened, the lock is still open, and it was closed before. Loss
/// of power closes the lock, so this servo has not been disconnected since.
bool hasLeftLockOpen(const device::Context& context, device::Servo& servo,
                     const results::PendingCommission& pending);
} // namespace jobs
