// SPDX-License-Identifier: GPL-3.0-or-later
// Watches joints that are moved by hand: torque is turned off first and stays off, so an arm drops.
// Writes nothing else. The job's thread. Errors: requireCalibratable() of any servo, before torque
// goes off; those of torque off, which leave the servos before it without torque and the others
// holding; those of watch().
#pragma once

#include "jobs/arm/joint_range.h"
#include "jobs/job.h"

namespace jobs {
/// False: enough. In the order of the servos.
using RangesFn = std::function<bool(const std::vector<JointRange>&)>;

/// The ranges when `onRanges`, which is called after each round, has ended it, or a stop.
/// `servos` have their settings read afterwards, as calibrationOf() needs them.
base::Result<std::vector<JointRange>> recordRanges(const device::Context& context,
                                                   std::vector<device::Servo>& servos,
                                                   const RangesFn& onRanges);
} // namespace jobs
