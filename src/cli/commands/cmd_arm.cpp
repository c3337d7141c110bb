// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arm_servos.h"
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/output/restore_text.h"
#include "cli/translate.h"
#include "jobs/arm/calibration.h"
#include "session/snapshot/safety_snapshot.h"

#include <algorithm>

namespace cli {
namespace {
constexpr Positional calibrationFile{
    "FILE", QT_TRANSLATE_NOOP("cli", "LeRobot's calibration file, *.json")};

QString linesOf(const QStringList& lines)
{
    return lines.isEmpty() ? QString() : lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

Json jsonJoints(const std::vector<ArmJoint>& joints)
{
    Json::Array all;
    for (const ArmJoint& one : joints)
        all.push_back(jsonJoint(one));
    return all;
}

base::Result<Exit> runShow(Run& run, const Values& values)
{
    const auto joints = findJoints(run, values);
    if (!joints)
        return tl::unexpected(joints.error());
    const QStringList notes = remarksOn(*joints);
    const QStringList files = jobs::findLerobotFiles();
    QStringList lines = notes;
    if (!files.isEmpty())
        lines << translate("cli", "LeRobot's calibration files on this computer:") << files;
    run.finish(Json::object()
                   .add("joints", jsonJoints(*joints))
                   .add("remarks", notes)
                   .add("lerobot_files", files),
               jointsText(*joints) + linesOf(lines));
    return requireJoints(*joints) ? Exit::Success : Exit::NoReply;
}

base::Result<Exit> runCompare(Run& run, const Values& values)
{
    const QString path = values.argument(calibrationFile.name);
    const auto file = jobs::loadLerobotFile(path);
    if (!file)
        return tl::unexpected(file.error());
    const auto joints = findJoints(run, values);
    if (!joints)
        return tl::unexpected(joints.error());
    if (const auto all = requireJoints(*joints); !all)
        return tl::unexpected(all.error());
    const auto found = jobs::differences(servosOf(*joints), *file);
    Table table({translate("cli", "Joint"), translate("cli", "Key"), translate("cli", "File"),
                 translate("cli", "Servo")});
    table.alignRight({2, 3});
    Json::Array rows;
    const auto cell = [](std::optional<int> value) {
        return value ? QString::number(*value) : noValue();
    };
    for (const jobs::CalibrationDifference& one : found) {
        table.add({one.joint, one.key, cell(one.inFile), cell(one.inServo)});
        rows.push_back(Json::object()
                           .add("joint", one.joint)
                           .add("key", one.key)
                           .add("file", Json(one.inFile))
                           .add("servo", Json(one.inServo)));
    }
    const QString same = translate("cli", "The file and the servos agree.");
    const QString remedy =
        translate("cli",
                  "LeRobot would ask for a new calibration. To write the file to the servos: "
                  "servodesk-cli arm apply \"%1\"; to write the servos to the file: "
                  "servodesk-cli arm export \"%1\"")
            .arg(path);
    const QStringList notes = remarksOn(*joints);
    run.finish(
        Json::object()
            .add("file", path)
            .add("equal", found.empty())
            .add("differences", std::move(rows))
            .add("remarks", notes),
        (found.empty() ? same + QLatin1Char('\n') : table.text() + remedy + QLatin1Char('\n')) +
            linesOf(notes));
    return found.empty() ? Exit::Success : Exit::Failed;
}

base::Result<Exit> runApply(Run& run, const Values& values)
{
    const QString path = values.argument(calibrationFile.name);
    const auto file = jobs::loadLerobotFile(path);
    if (!file)
        return tl::unexpected(file.error());
    const auto joints = findJoints(run, values);
    if (!joints)
        return tl::unexpected(joints.error());
    if (const auto all = requireJoints(*joints); !all)
        return tl::unexpected(all.error());
    std::vector<snapshot::Snapshot> templates;
    std::vector<JointPlan> plans;
    for (const ArmJoint& one : *joints) {
        const jobs::LerobotJoint* saved = file->find(one.joint.name);
        if (saved == nullptr || saved->id != one.joint.id)
            return badArgument(translate("cli", "the file has no joint %1 with the ID %2")
                                   .arg(one.joint.name)
                                   .arg(one.joint.id));
        if (const auto valid = jobs::requireValid(*one.servo, saved->calibration); !valid)
            return tl::unexpected(valid.error());
        const auto settings = jobs::positionSettings(*one.servo, one.joint.kind);
        plans.push_back({one.joint, changesText(jobs::changesOf(*one.servo, settings)),
                         one.calibration(), saved->calibration});
        templates.push_back(jobs::calibrationTemplate(*one.servo, one.joint.kind,
                                                      saved->calibration, session::programName()));
    }
    run.console().print(plansText(plans));
    if (!values.has(dryRunOption.flag) && !values.has(yesOption.flag)) {
        run.console().printMessage(translate(
            "cli", "Torque will be turned off, so the arm drops: hold it. Press Enter to write."));
        EnterKey enter(run);
        if (!enter.wait())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("arm"));
    }
    return writeTemplates(run, values, templates, path);
}

/// LeRobot writes these at each start; with the EPROM lock that it leaves open, each time anew.
base::Result<Exit> runPrepare(Run& run, const Values& values)
{
    const auto joints = findJoints(run, values);
    if (!joints)
        return tl::unexpected(joints.error());
    std::vector<snapshot::Snapshot> templates;
    Table table({translate("cli", "Joint"), translate("cli", "ID"), translate("cli", "Changes")});
    table.alignRight({1});
    bool isAnyChanged = false;
    const std::vector<jobs::JointServo> servos = servosOf(*joints);
    for (const jobs::JointServo& one : servos) {
        if (one.servo == nullptr)
            return base::fail(base::ErrorCode::NoReply, QStringLiteral("arm"), {}, one.joint.id);
        const jobs::JointSettings settings = one.lerobotSettings();
        const auto changes = jobs::changesOf(*one.servo, settings);
        isAnyChanged |= !changes.empty();
        table.add({one.joint.name, QString::number(one.joint.id),
                   settings.empty()  ? translate("cli", "not known for this family")
                   : changes.empty() ? translate("cli", "none")
                                     : changesText(changes)});
        if (!settings.empty())
            templates.push_back(jobs::jointTemplate(*one.servo, settings, session::programName()));
    }
    if (templates.empty())
        return base::fail(base::ErrorCode::NotSupported, QStringLiteral("arm"),
                          QStringLiteral("no-lerobot-settings"), servos.front().joint.id);
    run.console().print(table.text());
    if (isAnyChanged && !values.has(dryRunOption.flag) && !values.has(yesOption.flag)) {
        run.console().printMessage(translate(
            "cli", "Torque will be turned off, so the arm drops: hold it. Press Enter to write."));
        EnterKey enter(run);
        if (!enter.wait())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("arm"));
    }
    return writeTemplates(run, values, templates, QString());
}

/// The arm itself, as a file for --arm that the user can change.
base::Result<Exit> exportArm(Run& run, const Values& values)
{
    const QString path = values.argument("FILE");
    const auto arm = armOf(values);
    if (!arm)
        return tl::unexpected(arm.error());
    if (const auto saved = jobs::saveArm(*arm, path); !saved)
        return tl::unexpected(saved.error());
    run.finish(Json::object().add("file", path),
               translate("cli", "Saved to %1").arg(path) + QLatin1Char('\n'));
    return Exit::Success;
}

base::Result<Exit> runExport(Run& run, const Values& values)
{
    const QString format = values.option("--format").value_or(QStringLiteral("lerobot"));
    if (format == QLatin1String("arm"))
        return exportArm(run, values);
    if (format != QLatin1String("lerobot"))
        return badArgument(translate("cli", "--format takes lerobot or arm"));
    const QString path = values.argument("FILE");
    const auto joints = findJoints(run, values);
    if (!joints)
        return tl::unexpected(joints.error());
    if (const auto all = requireJoints(*joints); !all)
        return tl::unexpected(all.error());
    const auto file = jobs::lerobotFileFor(path, lerobotJoints(*joints));
    if (!file)
        return tl::unexpected(file.error());
    if (const auto saved = jobs::saveLerobotFile(*file, path); !saved)
        return tl::unexpected(saved.error());
    const QStringList notes = remarksOn(*joints);
    run.finish(
        Json::object().add("file", path).add("joints", jsonJoints(*joints)).add("remarks", notes),
        jointsText(*joints) + translate("cli", "Saved to %1").arg(path) + QLatin1Char('\n') +
            linesOf(notes));
    return Exit::Success;
}
} // namespace

Command armShowCommand()
{
    return {"arm show",
            QT_TRANSLATE_NOOP("cli", "list the joints of a robot arm with position, offset and "
                                     "limits, and what LeRobot would refuse"),
            {},
            {armOption},
            runShow};
}

Command armCompareCommand()
{
    return {"arm compare",
            QT_TRANSLATE_NOOP("cli", "compare LeRobot's calibration file with the servos"),
            {calibrationFile},
            {armOption},
            runCompare};
}

Command armApplyCommand()
{
    return {"arm apply",
            QT_TRANSLATE_NOOP("cli",
                              "write offsets and limits of LeRobot's calibration file to the "
                              "servos, and set position mode with single-turn feedback where "
                              "needed; torque is turned off"),
            {calibrationFile},
            {armOption, yesOption, dryRunOption},
            runApply};
}

Command armPrepareCommand()
{
    return {"arm prepare",
            QT_TRANSLATE_NOOP("cli", "write the settings that LeRobot writes at each start (mode, "
                                     "gains, reply delay, gripper limits); torque is turned off"),
            {},
            {armOption, yesOption, dryRunOption},
            runPrepare};
}

Command armExportCommand()
{
    return {"arm export",
            QT_TRANSLATE_NOOP("cli", "save what the servos hold as LeRobot's calibration file"),
            {{"FILE", QT_TRANSLATE_NOOP(
                          "cli", "output file; of an existing calibration file, keys of other "
                                 "programs are kept; an existing arm file is replaced")}},
            {armOption,
             {"--format",
              QT_TRANSLATE_NOOP(
                  "cli",
                  "lerobot (default): what the servos hold; arm: the joints, as a file for --arm"),
              "FORMAT"}},
            runExport};
}
} // namespace cli
