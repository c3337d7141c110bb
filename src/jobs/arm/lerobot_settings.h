// SPDX-License-Identifier: GPL-3.0-or-later
// The settings that LeRobot writes at each start, by the kind of joint, so that its writes change
// nothing. Only those that a servo keeps: LeRobot also sets the acceleration (41) and its limit
// (85). Of STS and SMS servos; none of others. Pure; any thread. Source: huggingface/lerobot,
// feetech.py, so_follower.py, so_leader.py, lekiwi.py.
#pragma once

#include "jobs/arm/arm.h"
#include "jobs/arm/joint_template.h"

namespace jobs {
/// Not a role: the vendor says that an STS servo does nothing with it.
constexpr QLatin1StringView returnDelayKey("return_delay");

/// `isLeader`: of an arm that is moved by hand only.
JointSettings lerobotSettings(const device::Servo& servo, base::JointKind kind, bool isLeader);
} // namespace jobs
