// SPDX-License-Identifier: GPL-3.0-or-later
// Words about a robot arm's joints. Data only; made by jobs/arm, worded by the text layer. Any
// thread.
#pragma once

#include <QStringList>

#include <cstdint>
#include <optional>

namespace base {
enum class JointKind : std::uint8_t {
    Limited,    ///< turns between two stops
    Continuous, ///< may turn through a full turn and further
    Gripper,
    Wheel, ///< is not calibrated
};
QString jointKindName(JointKind kind); ///< "limited", "continuous" …
std::optional<JointKind> jointKindOf(const QString& name);

/// What is known of a joint's range while it is moved by hand.
enum class JointState : std::uint8_t {
    NotMoved,
    KeepMoving, ///< less than a range that a joint can have
    Recorded,
    FullTurn,  ///< turns through a full turn or further: it has no end that could be a limit
    LostTrack, ///< readings were missing while it may have turned by half a turn; record again
    NoReply,   ///< its servo has not replied yet
};
QString jointStateName(JointState state); ///< "not-moved", "keep-moving" …

/// How a joint has moved between its limits.
enum class MoveTestState : std::uint8_t {
    Moving,
    Reached,
    NotReached, ///< something is in its way, or the torque is too little
    Alarm,
    TorqueLost, ///< it no longer takes goals: switched off, restarted or exchanged
};
QString moveTestStateName(MoveTestState state); ///< "moving", "reached" …

/// What LeRobot refuses of an arm, leaves behind, or writes at its next start.
enum class ArmRemarkKind : std::uint8_t {
    NoReply,
    OtherModel,
    OtherFirmware, ///< of several versions
    OpenLock,
    OtherSettings,
};
struct ArmRemark {
    ArmRemarkKind kind = ArmRemarkKind::NoReply;
    QStringList joints{}; ///< "elbow_flex (ID 3)"; OpenLock and OtherSettings: "3"
    QString model{};      ///< OtherModel: found, and expected
    QString expectedModel{};
};
} // namespace base
