// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arm_servos.h"

#include "cli/input/arguments.h"
#include "cli/multi_servo_restore.h"
#include "cli/output/table.h"
#include "cli/translate.h"
#include "jobs/arm/calibration.h"
#include "jobs/arm/joint_access.h"
#include "text/arm_text.h"
#include "text/language.h"

#include <algorithm>

namespace cli {
namespace {
using catalog::Role;

base::Result<device::Servo> readJoint(Run& run, int id)
{
    auto servo = run.servo(id);
    if (!servo)
        return servo;
    const auto context = run.context();
    if (const auto read = jobs::readJoint(*context, *servo); !read)
        return tl::unexpected(read.error());
    return servo;
}

Json orNull(std::optional<std::int64_t> raw)
{
    return Json(raw);
}

QString cell(std::optional<std::int64_t> raw)
{
    return raw ? QString::number(*raw) : noValue();
}

QString firmwareOf(const device::Servo& servo)
{
    return servo.profile->identity.firmware();
}

QString remedyFor(base::ArmRemarkKind kind)
{
    switch (kind) {
    case base::ArmRemarkKind::OtherFirmware:
        return translate("cli", "To see them: servodesk-cli firmware list");
    case base::ArmRemarkKind::OpenLock:
        return translate("cli", "To close it: servodesk-cli write ID lock=1");
    case base::ArmRemarkKind::OtherSettings:
        return translate("cli", "To write them now: servodesk-cli arm prepare");
    case base::ArmRemarkKind::NoReply:
    case base::ArmRemarkKind::OtherModel:
        break;
    }
    return {};
}
} // namespace

base::Result<jobs::Arm> armOf(const Values& values)
{
    const QString name = values.option(armOption.flag).value_or(QStringLiteral("so101"));
    auto arm = jobs::loadArm(name);
    const bool isFile = name.contains(QLatin1Char('/')) || name.contains(QLatin1Char('.'));
    if (!arm && arm.error().code == base::ErrorCode::FileMissing && !isFile)
        return badArgument(translate("cli", "--arm takes %1, or a file")
                               .arg(text::joinItems(jobs::builtInArms())));
    return arm;
}

bool EnterKey::wait()
{
    m_input.discardTyped();
    while (!m_run.stop().isRequested()) {
        if (m_input.readLine())
            return true;
        if (!m_input.isOpen())
            return false;
        constexpr auto slice = std::chrono::milliseconds(20);
        (void)m_run.stop().waitUntil(std::chrono::steady_clock::now() + slice);
    }
    return false;
}

std::optional<jobs::JointCalibration> ArmJoint::calibration() const
{
    return servo ? jobs::calibrationIn(*servo) : std::nullopt;
}

base::Result<std::vector<ArmJoint>> findJoints(Run& run, const Values& values)
{
    const auto arm = armOf(values);
    if (!arm)
        return tl::unexpected(arm.error());
    std::vector<ArmJoint> joints;
    std::optional<base::Error> silence;
    bool isAnyFound = false;
    for (const jobs::Joint& joint : arm->joints) {
        auto servo = readJoint(run, joint.id);
        if (!servo && servo.error().code != base::ErrorCode::NoReply)
            return tl::unexpected(servo.error());
        isAnyFound |= servo.has_value();
        if (!servo && !silence)
            silence = servo.error();
        joints.push_back(
            {joint, servo ? std::optional(std::move(*servo)) : std::nullopt, arm->isLeader});
    }
    if (!isAnyFound)
        return tl::unexpected(*silence);
    return joints;
}

base::Result<void> requireJoints(const std::vector<ArmJoint>& joints)
{
    for (const ArmJoint& one : joints) {
        if (!one.servo)
            return base::fail(base::ErrorCode::NoReply, QStringLiteral("arm"), {}, one.joint.id);
        if (!one.calibration())
            return base::fail(base::ErrorCode::NotSupported, QStringLiteral("arm"),
                              QStringLiteral("no-position-limits"), one.joint.id);
    }
    return {};
}

base::Result<std::vector<ArmJoint>> selectJoints(const Values& values, std::vector<ArmJoint> joints)
{
    const QStringList wanted = values.option(jointOption.flag)
                                   .value_or(QString())
                                   .split(QLatin1Char(','), Qt::SkipEmptyParts);
    QStringList known;
    std::vector<ArmJoint> selected;
    for (ArmJoint& one : joints) {
        if (one.joint.kind == base::JointKind::Wheel)
            continue;
        known << one.joint.name;
        if (wanted.isEmpty() || wanted.contains(one.joint.name))
            selected.push_back(std::move(one));
    }
    for (const QString& name : wanted) {
        if (!known.contains(name))
            return badArgument(
                translate("cli", "no joint %1; the arm has %2").arg(name, text::joinItems(known)));
    }
    if (selected.empty())
        return badArgument(translate("cli", "the arm has no joint to move"));
    return selected;
}

base::Result<Exit> writeTemplates(Run& run, const Values& values,
                                  const std::vector<snapshot::Snapshot>& templates,
                                  const QString& source, Json document)
{
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    MultiServoRestore several(run, values);
    const auto all = jobs::writeJoints(*context, templates, several.options(), several.progress());
    return several.finish(all, source, std::move(document));
}

Json jsonJoint(const ArmJoint& one)
{
    const auto calibration = one.calibration();
    const auto value = [&](int jobs::JointCalibration::*field) {
        return calibration ? Json((*calibration).*field) : Json();
    };
    return Json::object()
        .add("name", one.joint.name)
        .add("id", one.joint.id)
        .add("kind", base::jointKindName(one.joint.kind))
        .add("model", one.servo ? Json(one.servo->profile->modelName) : Json())
        .add("firmware", one.servo ? Json(firmwareOf(*one.servo)) : Json())
        .add("position", one.servo ? orNull(one.servo->raw(Role::PresentPosition)) : Json())
        .add("homing_offset", value(&jobs::JointCalibration::homingOffset))
        .add("range_min", value(&jobs::JointCalibration::rangeMin))
        .add("range_max", value(&jobs::JointCalibration::rangeMax));
}

QString jointsText(const std::vector<ArmJoint>& joints)
{
    Table table({translate("cli", "Joint"), translate("cli", "ID"), translate("cli", "Model"),
                 translate("cli", "Firmware"), translate("cli", "Position"),
                 translate("cli", "Offset"), translate("cli", "Min"), translate("cli", "Max")});
    table.alignRight({1, 4, 5, 6, 7});
    for (const ArmJoint& one : joints) {
        const auto calibration = one.calibration();
        const auto value = [&](int jobs::JointCalibration::*field) {
            return calibration ? QString::number((*calibration).*field) : noValue();
        };
        table.add({one.joint.name, QString::number(one.joint.id),
                   one.servo ? one.servo->profile->modelName : noValue(),
                   one.servo ? firmwareOf(*one.servo) : noValue(),
                   one.servo ? cell(one.servo->raw(Role::PresentPosition)) : noValue(),
                   value(&jobs::JointCalibration::homingOffset),
                   value(&jobs::JointCalibration::rangeMin),
                   value(&jobs::JointCalibration::rangeMax)});
    }
    return table.text();
}

QString changesText(const std::vector<jobs::SettingChange>& changes)
{
    QStringList texts;
    for (const jobs::SettingChange& one : changes)
        texts << QStringLiteral("%1 %2 → %3").arg(one.reg->key).arg(one.now).arg(one.wanted);
    return text::joinItems(texts);
}

QString plansText(const std::vector<JointPlan>& plans)
{
    Table table({translate("cli", "Joint"), translate("cli", "ID"), translate("cli", "Range"),
                 translate("cli", "Offset"), translate("cli", "Min"), translate("cli", "Max")});
    table.alignRight({1, 3, 4, 5});
    for (const JointPlan& one : plans) {
        const auto change = [&](int jobs::JointCalibration::*field) {
            const QString now = one.now ? QString::number((*one.now).*field) : noValue();
            const QString next = one.next ? QString::number((*one.next).*field) : now;
            return now == next ? now : QStringLiteral("%1 → %2").arg(now, next);
        };
        table.add({one.joint.name, QString::number(one.joint.id), one.remark,
                   change(&jobs::JointCalibration::homingOffset),
                   change(&jobs::JointCalibration::rangeMin),
                   change(&jobs::JointCalibration::rangeMax)});
    }
    return table.text();
}

std::vector<jobs::JointServo> servosOf(const std::vector<ArmJoint>& joints)
{
    std::vector<jobs::JointServo> all;
    for (const ArmJoint& one : joints)
        all.push_back({one.joint, one.servo ? &*one.servo : nullptr, one.isLeader});
    return all;
}

QStringList remarksOn(const std::vector<ArmJoint>& joints)
{
    QStringList lines;
    for (const base::ArmRemark& remark : jobs::lerobotRemarks(servosOf(joints))) {
        const QString remedy = remedyFor(remark.kind);
        lines << (remedy.isEmpty() ? text::armRemarkText(remark)
                                   : translate("cli", "%1 %2", "cause, remedy")
                                         .arg(text::armRemarkText(remark), remedy));
    }
    return lines;
}

std::vector<jobs::LerobotJoint> lerobotJoints(const std::vector<ArmJoint>& joints)
{
    std::vector<jobs::LerobotJoint> all;
    for (const ArmJoint& one : joints) {
        if (const auto calibration = one.calibration())
            all.push_back(
                {one.joint.name, one.joint.id, one.joint.isReversed ? 1 : 0, *calibration});
    }
    return all;
}
} // namespace cli
