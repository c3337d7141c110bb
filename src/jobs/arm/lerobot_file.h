// SPDX-License-Identifier: GPL-3.0-or-later
// LeRobot's calibration file: a JSON object with a joint per key. LeRobot accepts it only if it
// equals the servos' registers, so what is saved must have been read back. Values; any thread.
// Errors: FileMissing, FileUnreadable, FileFormat (detail has the place), FileUnwritable, DiskFull.
// Source: huggingface/lerobot, motors_bus.py.
#pragma once

#include "base/error.h"

#include <QJsonObject>

#include <vector>

namespace jobs {
/// In steps; the limits are positions after the offset.
struct JointCalibration {
    int homingOffset = 0; ///< register 31; servos without it: 0
    int rangeMin = 0;     ///< register 9
    int rangeMax = 0;     ///< register 11
    bool operator==(const JointCalibration&) const = default;
};

struct LerobotJoint {
    QString name;
    int id = 0;
    int driveMode = 0; ///< 1: LeRobot reverses the direction
    JointCalibration calibration{};
    bool operator==(const LerobotJoint&) const = default;
};

struct LerobotFile {
    std::vector<LerobotJoint> joints; ///< by ID
    QJsonObject document{}; ///< as it was read; other keys in it are kept when it is saved

    const LerobotJoint* find(const QString& name) const; ///< null: no such joint
};

base::Result<LerobotFile> loadLerobotFile(const QString& path);
/// What to save to `path`: the joints with the direction and the other keys that an existing file
/// has for them. FileFormat if that is another kind of file, or has joints of another arm.
base::Result<LerobotFile> lerobotFileFor(const QString& path, std::vector<LerobotJoint> joints);
/// Replaces the file in one step.
base::Result<void> saveLerobotFile(const LerobotFile& file, const QString& path);

/// Calibration files where LeRobot keeps them on this computer.
QStringList findLerobotFiles();
} // namespace jobs
