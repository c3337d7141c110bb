// SPDX-License-Identifier: GPL-3.0-or-later
// The steps that set up one servo, and the check before them. Each step skips what is already done,
// so an unfinished servo can begin again. Internal to jobs; the job's thread. An error concerns
// this servo only: it ended in this step.
#pragma once

#include "device/servo.h"
#include "jobs/commission/commission.h"
#include "jobs/restore/restore_plan.h"

namespace jobs {
struct CommissionWork {
    device::Servo servo; ///< follows to its new ID and rate
    results::CommissionRow row;
    int newId = -1;
    int newBaud = 0; ///< the rate it will have; its own if it keeps it
    std::optional<RestorePlan> plan{};
    bool center = false;
    bool saved = false;         ///< its table is on the disk
    bool isVerified = false;    ///< it is the unfinished servo: its lock is still open
    bool isIdConfirmed = false; ///< its new ID was written with the lock open, and read back
    QString savedLabel{};       ///< its label in the history
};

/// Reads the whole table, plans the template, and finds the issues: alarms, a model other than the
/// template's, an ID or rate this servo cannot have, no command to set the midpoint, and the rows
/// of the template that will not be written. Writes nothing.
base::Result<std::vector<results::CommissionIssue>>
checkServo(const device::Context& context, const CommissionSpec& spec, CommissionWork& work);

/// The user decides whether the servo is set up despite this issue.
bool needsDecision(const results::CommissionIssue& issue);

/// Whether anything has to be written.
bool hasWork(const CommissionWork& work);

base::Result<void> saveTable(const device::Context& context, const CommissionCallbacks& callbacks,
                             CommissionWork& work);
base::Result<void> applyTemplate(const device::Context& context, const CommissionSpec& spec,
                                 CommissionWork& work);
base::Result<void> changeServoId(const device::Context& context, CommissionWork& work);
base::Result<void> changeServoRate(const device::Context& context, CommissionWork& work);
base::Result<void> centerServo(const device::Context& context, CommissionWork& work);

/// Reads identity under the new ID and rate, alarms, torque (turned off if it was on), lock,
/// voltage and temperature. Its findings are the issues of the row.
base::Result<void> checkHealth(const device::Context& context, CommissionWork& work);
} // namespace jobs
