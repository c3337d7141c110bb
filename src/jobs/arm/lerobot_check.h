// SPDX-License-Identifier: GPL-3.0-or-later
// The joints of an arm with their servos, and what LeRobot finds when it connects: whether its
// calibration file equals the servos, what it refuses, what it would write. Pure; any thread.
// Source: huggingface/lerobot, motors_bus.py.
#pragma once

#include "device/servo.h"
#include "jobs/arm/arm.h"
#include "jobs/arm/joint_template.h"
#include "jobs/arm/lerobot_file.h"

namespace jobs {
/// A joint with its servo, with its calibration read (readJoint()); null: it does not reply.
struct JointServo {
    Joint joint;
    const device::Servo* servo = nullptr;
    bool isLeader = false; ///< Arm::isLeader

    /// The settings that LeRobot would write to it; empty: none, or it does not reply.
    JointSettings lerobotSettings() const;
};

/// A value that differs; none: not there.
struct CalibrationDifference {
    QString joint;
    QString key; ///< as in the file: "id", "homing_offset" …
    std::optional<int> inFile{};
    std::optional<int> inServo{};
};
std::vector<CalibrationDifference> differences(const std::vector<JointServo>& joints,
                                               const LerobotFile& file);

/// Names of joints with two stops whose limits are still the factory's, those of the whole turn, or
/// not known.
QStringList uncalibratedJoints(const std::vector<JointServo>& joints);

/// One of base::ArmRemarkKind, at most one of a kind but for OtherModel.
std::vector<base::ArmRemark> lerobotRemarks(const std::vector<JointServo>& joints);
} // namespace jobs
