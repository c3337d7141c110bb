// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/arm_text.h"

#include "text/language.h"
#include "text/translate.h"

namespace text {
using base::JointState;

QString jointStateText(JointState state)
{
    switch (state) {
    case JointState::NotMoved:
        return translate("text", "not moved yet");
    case JointState::KeepMoving:
        return translate("text", "keep moving");
    case JointState::Recorded:
        return translate("text", "range recorded");
    case JointState::FullTurn:
        return translate("text", "turns through a full turn");
    case JointState::LostTrack:
        return translate("text", "lost track: record again");
    case JointState::NoReply:
        return translate("text", "no reply");
    }
    return {};
}

QString moveTestStateText(base::MoveTestState state)
{
    using base::MoveTestState;
    switch (state) {
    case MoveTestState::Moving:
        return translate("text", "moving");
    case MoveTestState::Reached:
        return translate("text", "reached both ends");
    case MoveTestState::NotReached:
        return translate("text", "end not reached");
    case MoveTestState::Alarm:
        return translate("text", "alarm while moving");
    case MoveTestState::TorqueLost:
        return translate("text", "no longer takes goals");
    }
    return {};
}

QString armRemarkText(const base::ArmRemark& remark)
{
    using base::ArmRemarkKind;
    const QString joints = joinItems(remark.joints);
    switch (remark.kind) {
    case ArmRemarkKind::NoReply:
        return translate("text", "No reply from %1.").arg(joints);
    case ArmRemarkKind::OtherModel:
        return translate("text", "%1 has the model %2; LeRobot expects %3 and refuses the bus. Fit "
                                 "that model, or enter %2 both in the arm and in LeRobot's code.")
            .arg(joints, remark.model, remark.expectedModel);
    case ArmRemarkKind::OtherFirmware:
        return translate("text", "The firmware versions differ: LeRobot refuses the bus.");
    case ArmRemarkKind::OpenLock:
        return translate("text", "The EPROM lock is open (ID %1), as LeRobot leaves it when it "
                                 "turns torque off.")
            .arg(joints);
    case ArmRemarkKind::OtherSettings:
        return translate("text", "LeRobot would change settings at its next start (ID %1).")
            .arg(joints);
    }
    return {};
}
} // namespace text
