// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to the one servo on a commissioning line, step by step, and what speaks against it
// beforehand. Each step does nothing that is so already, so a servo that was left in the middle may
// begin again. Internal to jobs; its thread. An error is this servo's: it ended in this step.
#pragma once

#include "device/servo.h"
#include "jobs/commission/commission.h"
#include "jobs/restore/restore_plan.h"

namespace jobs {
struct CommissionWork {
    device::Servo servo; ///< follows to its new ID and rate
    record::CommissionRow row;
    int newId = -1;
    int newBaud = 0; ///< the rate it is to have; its own where it keeps it
    std::optional<RestorePlan> plan{};
    bool center = false;
    bool saved = false;         ///< its table is on the disk
    bool isVerified = false;    ///< it is the very servo that was begun: its lock still stands open
    bool isIdConfirmed = false; ///< its new ID was written with the lock open, and read back
    QString savedLabel{};       ///< its label in the history
};

/// Reads the whole table, plans the template, and finds everything that speaks against going on:
/// alarms, another model than the template's, an ID or rate this servo cannot have, no centering;
/// and the rows of the template that will be left alone. Writes nothing.
base::Result<std::vector<record::CommissionIssue>>
checkServo(const device::Context& context, const CommissionSpec& spec, CommissionWork& work);

/// It is for the user to say whether this servo is set up all the same.
bool needsDecision(const record::CommissionIssue& issue);

/// Is there anything to be written at all?
bool hasWork(const CommissionWork& work);

base::Result<void> saveTable(const device::Context& context, const CommissionCallbacks& callbacks,
                             CommissionWork& work);
base::Result<void> applyTemplate(const device::Context& context, const CommissionSpec& spec,
                                 CommissionWork& work);
base::Result<void> changeServoId(const device::Context& context, CommissionWork& work);
base::Result<void> changeServoRate(const device::Context& context, CommissionWork& work);
base::Result<void> centerServo(const device::Context& context, CommissionWork& work);

/// Identity read back at the new ID and rate, alarms, torque (switched off where it was on), lock,
/// voltage and temperature. Its findings are the row's troubles.
base::Result<void> checkHealth(const device::Context& context, CommissionWork& work);

/// The servo as rows and files name it.
record::SnapshotServo snapshotServo(const device::Servo& servo);
} // namespace jobs
