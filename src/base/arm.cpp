// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/arm.h"

#include "base/enum_names.h"

namespace base {
namespace {
constexpr EnumName<JointKind> jointKindNames[]{{JointKind::Limited, "limited"},
                                               {JointKind::Continuous, "continuous"},
                                               {JointKind::Gripper, "gripper"},
                                               {JointKind::Wheel, "wheel"}};

constexpr EnumName<JointState> jointStateNames[]{
    {JointState::NotMoved, "not-moved"},   {JointState::KeepMoving, "keep-moving"},
    {JointState::Recorded, "recorded"},    {JointState::FullTurn, "full-turn"},
    {JointState::LostTrack, "lost-track"}, {JointState::NoReply, "no-reply"}};

constexpr EnumName<MoveTestState> moveTestStateNames[]{{MoveTestState::Moving, "moving"},
                                                       {MoveTestState::Reached, "reached"},
                                                       {MoveTestState::NotReached, "not-reached"},
                                                       {MoveTestState::Alarm, "alarm"},
                                                       {MoveTestState::TorqueLost, "torque-lost"}};
} // namespace

QString jointKindName(JointKind kind)
{
    return nameOf(jointKindNames, kind);
}

std::optional<JointKind> jointKindOf(const QString& name)
{
    return valueOf(jointKindNames, name);
}

QString jointStateName(JointState state)
{
    return nameOf(jointStateNames, state);
}

QString moveTestStateName(MoveTestState state)
{
    return nameOf(moveTestStateNames, state);
}
} // namespace base
