// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/apply_calibration.h"

#include "device/reader.h"

namespace jobs {
using catalog::Role;

base::Result<void> readCalibration(const device::Context& context, device::Servo& servo)
{
    std::vector<Role> roles;
    for (const Role role : {Role::MinAngle, Role::MaxAngle, Role::PositionOffset, Role::Lock,
                            Role::PresentPosition}) {
        if (servo.profile->byRole(role) != nullptr)
            roles.push_back(role);
    }
    return device::readSettings(context, servo).and_then([&] {
        return device::readRoles(context, servo, roles);
    });
}

std::vector<ApplyResult> writeCalibrations(const device::Context& context,
                                           const std::vector<snapshot::Snapshot>& templates,
                                           ApplyOptions options, const ProgressFn& progress)
{
    snapshot::Bundle bundle;
    bundle.servos = templates;
    options.restore.onFailure = OnFailure::RollBack; // limits belong to the offset they came with
    options.choice.consent = options.restore.consent = device::Consent::byTask();
    return restoreBundle(context, bundle, options, progress);
}
} // namespace jobs
