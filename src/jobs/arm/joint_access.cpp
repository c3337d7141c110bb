// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/joint_access.h"

#include "device/reader.h"
#include "jobs/arm/lerobot_settings.h"

#include <algorithm>

namespace jobs {
using catalog::Role;

base::Result<void> readJoint(const device::Context& context, device::Servo& servo)
{
    std::vector<const catalog::Register*> registers{servo.profile->find(returnDelayKey)};
    for (const Role role :
         {Role::MinAngle, Role::MaxAngle, Role::PositionOffset, Role::Lock, Role::PresentPosition,
          Role::PositionP, Role::PositionI, Role::PositionD, Role::MaxTorque,
          Role::ProtectionCurrent, Role::OverloadTorque})
        registers.push_back(servo.profile->byRole(role));
    registers.erase(std::remove(registers.begin(), registers.end(), nullptr), registers.end());
    return device::readSettings(context, servo).and_then([&] {
        return device::read(context, servo, registers);
    });
}

std::vector<ApplyResult> writeJoints(const device::Context& context,
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
