// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/arm.h"

#include "files/json_format.h"
#include "files/json_text.h"
#include "files/text_file.h"

#include <QSet>

namespace jobs {
namespace {
using base::JointKind;

const QString armOperation = QStringLiteral("arm-file");
const QLatin1StringView armFormat("servodesk-arm");
constexpr int armVersion = 1;
constexpr qint64 maxArmFileSize = 1024 * 1024;

/// The six joints that most small arms have.
std::vector<Joint> sixJoints(const QString& prefix, const QString& model)
{
    const auto joint = [&](const char* name, int id, JointKind kind = JointKind::Limited) {
        return Joint{prefix + QLatin1String(name), id, model, kind, false};
    };
    return {joint("shoulder_pan", 1),
            joint("shoulder_lift", 2),
            joint("elbow_flex", 3),
            joint("wrist_flex", 4),
            joint("wrist_roll", 5, JointKind::Continuous),
            joint("gripper", 6, JointKind::Gripper)};
}

const QString sts3215 = QStringLiteral("STS3215");

Arm so101()
{
    return {QStringLiteral("SO-100/SO-101"), false, sixJoints({}, sts3215)};
}

Arm so101Leader()
{
    return {QStringLiteral("SO-100/SO-101 leader"), true, sixJoints({}, sts3215)};
}

Arm lekiwi()
{
    Arm arm{QStringLiteral("LeKiwi"), false, sixJoints(QStringLiteral("arm_"), sts3215)};
    arm.joints.back().kind = JointKind::Limited; // LeRobot gives its gripper no limits
    int id = 7;
    for (const char* wheel : {"base_left_wheel", "base_back_wheel", "base_right_wheel"})
        arm.joints.push_back({QLatin1String(wheel), id++, sts3215, JointKind::Wheel, false});
    return arm;
}

Arm sixJointArm()
{
    return {QStringLiteral("Six joints"), false, sixJoints({}, {})};
}

struct BuiltInArm {
    const char* name;
    Arm (*make)();
};
constexpr BuiltInArm builtIn[]{{"so101", so101},
                               {"so101-leader", so101Leader},
                               {"lekiwi", lekiwi},
                               {"six-joint", sixJointArm}};

Joint decodeJoint(const files::JsonReader& json)
{
    Joint joint;
    json.rejectUnknownKeys({QStringLiteral("name"), QStringLiteral("id"), QStringLiteral("model"),
                            QStringLiteral("kind"), QStringLiteral("reversed")});
    joint.name = json.nonEmptyText("name");
    joint.id = json.smallInteger("id");
    if (joint.id < 0 || joint.id > maxJointId)
        json.reportError("id", QStringLiteral("expected a number from 0 to 253"));
    if (json.contains("model"))
        joint.model = json.text("model");
    joint.kind = json.enumValue<JointKind>("kind", base::jointKindOf);
    joint.isReversed = json.contains("reversed") && json.flag("reversed");
    return joint;
}

tl::expected<Arm, QString> decodeArm(const QByteArray& text)
{
    const auto object = files::parseJson(text);
    if (!object)
        return tl::unexpected(object.error());
    files::JsonReadError error;
    const files::JsonReader json(*object, error);
    files::checkFormat(json, armFormat, armVersion, QStringLiteral("not a file with an arm"));
    Arm arm;
    arm.name = json.text("name");
    arm.isLeader = json.contains("leader") && json.flag("leader");
    QSet<QString> names;
    QSet<int> ids;
    for (const files::JsonReader& one : json.objects("joints")) {
        Joint joint = decodeJoint(one);
        if (names.contains(joint.name))
            one.reportError("name", QStringLiteral("two joints have this name"));
        if (ids.contains(joint.id))
            one.reportError("id", QStringLiteral("two joints have this ID"));
        names.insert(joint.name);
        ids.insert(joint.id);
        arm.joints.push_back(std::move(joint));
    }
    if (arm.joints.empty())
        json.reportError("joints", QStringLiteral("expected at least one joint"));
    return error.isSet() ? tl::expected<Arm, QString>(tl::unexpected(error.text()))
                         : std::move(arm);
}
} // namespace

QStringList builtInArms()
{
    QStringList names;
    for (const BuiltInArm& one : builtIn)
        names << QLatin1String(one.name);
    return names;
}

base::Result<Arm> loadArm(const QString& nameOrPath)
{
    for (const BuiltInArm& one : builtIn) {
        if (nameOrPath == QLatin1String(one.name))
            return one.make();
    }
    const auto text = files::readTextFile(armOperation, nameOrPath, maxArmFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto arm = decodeArm(*text);
    if (!arm)
        return base::fail(base::ErrorCode::FileFormat, armOperation,
                          nameOrPath + QStringLiteral(": ") + arm.error());
    return std::move(*arm);
}

base::Result<void> saveArm(const Arm& arm, const QString& path)
{
    const auto existing = loadArm(path);
    if (!existing && existing.error().code != base::ErrorCode::FileMissing)
        return tl::unexpected(existing.error());
    const QByteArray joints = files::jsonLines(arm.joints, "  ", [](const Joint& joint) {
        return files::JsonObjectWriter()
            .text("name", joint.name)
            .integer("id", joint.id)
            .text("model", joint.model)
            .text("kind", base::jointKindName(joint.kind))
            .flag("reversed", joint.isReversed)
            .done();
    });
    const QByteArray text = "{\n  \"format\": " + files::jsonText(armFormat) +
                            ",\n  \"version\": " + QByteArray::number(armVersion) +
                            ",\n  \"name\": " + files::jsonText(arm.name) +
                            ",\n  \"leader\": " + (arm.isLeader ? "true" : "false") +
                            ",\n  \"joints\": " + joints + "\n}\n";
    return files::saveTextFile(armOperation, text, path);
}
} // namespace jobs
