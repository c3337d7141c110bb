// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/lerobot_check.h"

#include "jobs/arm/calibration.h"
#include "jobs/arm/lerobot_settings.h"

#include <QSet>

#include <algorithm>

namespace jobs {
namespace {
using base::ArmRemarkKind;
using catalog::Role;

QString nameOf(const Joint& joint)
{
    return QStringLiteral("%1 (ID %2)").arg(joint.name).arg(joint.id);
}

/// Of the joint's file entry, which has the same ID.
void compareValues(const JointServo& one, const JointCalibration& saved,
                   std::vector<CalibrationDifference>& all)
{
    using Value = int JointCalibration::*;
    constexpr std::pair<const char*, Value> fields[]{
        {"homing_offset", &JointCalibration::homingOffset},
        {"range_min", &JointCalibration::rangeMin},
        {"range_max", &JointCalibration::rangeMax}};
    const auto held = one.servo != nullptr ? calibrationIn(*one.servo) : std::nullopt;
    for (const auto& [key, value] : fields) {
        const auto inServo = held ? std::optional((*held).*value) : std::nullopt;
        if (inServo != saved.*value)
            all.push_back({one.joint.name, QLatin1String(key), saved.*value, inServo});
    }
}

/// Narrower than those it comes with.
bool hasOwnLimits(const device::Servo& servo)
{
    const auto held = calibrationIn(servo);
    if (!held)
        return false;
    const auto factory = [&](Role role, std::int64_t otherwise) {
        const catalog::Register* reg = servo.profile->byRole(role);
        return reg != nullptr ? reg->defaultRaw.value_or(otherwise) : otherwise;
    };
    return held->rangeMin > factory(Role::MinAngle, 0) ||
           held->rangeMax < factory(Role::MaxAngle, servo.profile->stepsPerTurn - 1);
}

bool isOtherModel(const JointServo& one)
{
    return !one.joint.model.isEmpty() && one.servo->profile->modelName != one.joint.model;
}
} // namespace

JointSettings JointServo::lerobotSettings() const
{
    return servo != nullptr ? jobs::lerobotSettings(*servo, joint.kind, isLeader) : JointSettings();
}

std::vector<CalibrationDifference> differences(const std::vector<JointServo>& joints,
                                               const LerobotFile& file)
{
    std::vector<CalibrationDifference> all;
    for (const JointServo& one : joints) {
        const LerobotJoint* saved = file.find(one.joint.name);
        if (saved != nullptr && saved->id == one.joint.id)
            compareValues(one, saved->calibration, all);
        else
            all.push_back({one.joint.name, QStringLiteral("id"),
                           saved != nullptr ? std::optional(saved->id) : std::nullopt,
                           one.joint.id});
    }
    for (const LerobotJoint& saved : file.joints) {
        const bool isOurs = std::any_of(joints.begin(), joints.end(), [&](const JointServo& one) {
            return one.joint.name == saved.name;
        });
        if (!isOurs)
            all.push_back({saved.name, QStringLiteral("id"), saved.id, std::nullopt});
    }
    return all;
}

QStringList uncalibratedJoints(const std::vector<JointServo>& joints)
{
    QStringList names;
    for (const JointServo& one : joints) {
        if (one.servo != nullptr && one.joint.kind != base::JointKind::Continuous &&
            !hasOwnLimits(*one.servo))
            names << one.joint.name;
    }
    return names;
}

std::vector<base::ArmRemark> lerobotRemarks(const std::vector<JointServo>& joints)
{
    std::vector<base::ArmRemark> remarks;
    QStringList missing;
    QStringList open;
    QStringList otherSettings;
    QSet<QString> versions;
    for (const JointServo& one : joints) {
        if (one.servo == nullptr) {
            missing << nameOf(one.joint);
            continue;
        }
        if (isOtherModel(one))
            remarks.push_back({ArmRemarkKind::OtherModel,
                               {nameOf(one.joint)},
                               one.servo->profile->modelName,
                               one.joint.model});
        versions << one.servo->profile->identity.firmware();
        if (one.servo->raw(Role::Lock) == 0)
            open << QString::number(one.joint.id);
        if (!changesOf(*one.servo, one.lerobotSettings()).empty())
            otherSettings << QString::number(one.joint.id);
    }
    if (!missing.isEmpty())
        remarks.push_back({ArmRemarkKind::NoReply, missing});
    if (versions.size() > 1)
        remarks.push_back({ArmRemarkKind::OtherFirmware});
    if (!open.isEmpty())
        remarks.push_back({ArmRemarkKind::OpenLock, open});
    if (!otherSettings.isEmpty())
        remarks.push_back({ArmRemarkKind::OtherSettings, otherSettings});
    return remarks;
}
} // namespace jobs
