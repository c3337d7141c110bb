// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arm_servos.h"
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/translate.h"
#include "jobs/arm/move_test.h"
#include "text/arm_text.h"
#include "text/error_text.h"
#include "text/language.h"

#include <cmath>

namespace cli {
namespace {
using base::MoveTestState;

constexpr int maxTorque = 100;
constexpr Option torqueOption{
    "--torque", QT_TRANSLATE_NOOP("cli", "torque limit during the test, 5–100 % (default: 30)"),
    "PERCENT"};

constexpr Option yesToMoveOption{"--yes", QT_TRANSLATE_NOOP("cli", "do not ask before moving")};

base::Result<int> torqueOf(const Values& values)
{
    const auto text = values.option(torqueOption.flag);
    if (!text)
        return jobs::defaultTestTorque;
    const auto number = parsePositive(*text);
    if (!number)
        return tl::unexpected(number.error());
    if (*number < jobs::minTestTorque || *number > maxTorque)
        return badArgument(translate("cli", "--torque takes 5 to 100"));
    return static_cast<int>(std::lround(*number));
}

Json jsonReport(const jobs::Joint& joint, const jobs::MoveTestReport& report)
{
    const bool isReached = report.state == MoveTestState::Reached;
    return Json::object()
        .add("name", joint.name)
        .add("id", joint.id)
        .add("result", base::moveTestStateName(report.state))
        .add("position", std::optional(report.position))
        .add("goal", isReached ? std::nullopt : std::optional(report.goal));
}

QString resultText(const jobs::MoveTestReport& report)
{
    if (report.state == MoveTestState::Reached)
        return text::moveTestStateText(report.state);
    return translate("cli", "%1; at %2, goal %3")
        .arg(text::moveTestStateText(report.state))
        .arg(report.position)
        .arg(report.goal);
}

/// A joint that does not reach its ends does not keep the others from being tested; an alarm, lost
/// torque or an error does.
base::Result<Exit> testJoints(Run& run, std::vector<ArmJoint> joints, int torque)
{
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    Table table({translate("cli", "Joint"), translate("cli", "ID"), translate("cli", "Result")});
    table.alignRight({1});
    Json::Array results;
    bool isAllReached = true;
    std::optional<base::Error> error;
    for (ArmJoint& one : joints) {
        ProgressLine line(run.console(), one.joint.name);
        const auto report =
            jobs::testMoves(*context, *one.servo, torque, [&](const jobs::MoveTestReport& now) {
                line.show(QStringLiteral("%1 → %2").arg(now.position).arg(now.goal));
            });
        if (!report) {
            error = report.error();
            table.add(
                {one.joint.name, QString::number(one.joint.id), text::describe(*error).message});
            results.push_back(Json::object()
                                  .add("name", one.joint.name)
                                  .add("id", one.joint.id)
                                  .add("error", jsonError(*error)));
            break;
        }
        isAllReached &= report->state == MoveTestState::Reached;
        table.add({one.joint.name, QString::number(one.joint.id), resultText(*report)});
        results.push_back(jsonReport(one.joint, *report));
        if (report->state != MoveTestState::Reached && report->state != MoveTestState::NotReached)
            break;
    }
    const QString remedy =
        isAllReached ? QString()
                     : translate("cli", "Something is in the way, the limits are beyond a "
                                        "mechanical stop, or the torque is too little (--torque). "
                                        "To set the limits: servodesk-cli arm calibrate") +
                           QLatin1Char('\n');
    run.finish(Json::object().add("torque_percent", torque).add("joints", std::move(results)),
               table.text() + remedy);
    if (error) {
        run.console().printNote(errorText(*error));
        return exitCode(error->code);
    }
    return isAllReached ? Exit::Success : Exit::Failed;
}

base::Result<Exit> runTest(Run& run, const Values& values)
{
    const auto torque = torqueOf(values);
    if (!torque)
        return tl::unexpected(torque.error());
    auto joints = findJoints(run, values);
    if (!joints)
        return tl::unexpected(joints.error());
    auto selected = selectJoints(values, std::move(*joints));
    if (!selected)
        return tl::unexpected(selected.error());
    if (const auto all = requireJoints(*selected); !all)
        return tl::unexpected(all.error());
    if (!values.has(yesToMoveOption.flag)) {
        const QStringList wide = jobs::uncalibratedJoints(servosOf(*selected));
        if (!wide.isEmpty())
            run.console().printMessage(
                translate("cli", "Not calibrated, so these run into their mechanical stops: %1")
                    .arg(text::joinItems(wide)));
        run.console().printMessage(
            translate("cli", "Each joint moves to the ends of its limits and back, with %1 % of "
                             "its torque. Keep hands and objects away. Torque is off afterwards: "
                             "hold what would drop. Press Enter to begin.")
                .arg(*torque));
        EnterKey enter(run);
        if (!enter.wait())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("arm"));
    }
    return testJoints(run, std::move(*selected), *torque);
}
} // namespace

Command armTestCommand()
{
    return {"arm test",
            QT_TRANSLATE_NOOP("cli", "move each joint to the ends of its limits and back, slowly "
                                     "and with little torque, and report whether it got there"),
            {},
            {armOption, jointOption, torqueOption, yesToMoveOption},
            runTest};
}
} // namespace cli
