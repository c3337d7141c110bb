// SPDX-License-Identifier: GPL-3.0-or-later
// A robot arm as a list of joints, each with its servo: built in for common arms, or a JSON file of
// the user's. A value; any thread. Errors: FileMissing, FileUnreadable, FileFormat (detail has the
// place), FileUnwritable, DiskFull. Source of the built-in names and IDs: huggingface/lerobot.
#pragma once

#include "base/arm.h"
#include "base/error.h"

#include <QStringList>

#include <vector>

namespace jobs {
constexpr int maxJointId = 253;

struct Joint {
    QString name; ///< "shoulder_pan"
    int id = 0;
    QString model{}; ///< "STS3215"; empty: any
    base::JointKind kind = base::JointKind::Limited;
    bool isReversed = false; ///< as LeRobot's drive_mode: changes no register
    bool operator==(const Joint&) const = default;
};

struct Arm {
    QString name;
    /// Moved by hand only: LeRobot sets neither gains nor limits of the gripper.
    bool isLeader = false;
    std::vector<Joint> joints;
    bool operator==(const Arm&) const = default;
};

QStringList builtInArms(); ///< "so101", "so101-leader", "lekiwi", "six-joint"
/// A built-in arm, or the file with this path.
base::Result<Arm> loadArm(const QString& nameOrPath);
/// An existing file that is no arm is kept: the error of loading it.
base::Result<void> saveArm(const Arm& arm, const QString& path);
} // namespace jobs
