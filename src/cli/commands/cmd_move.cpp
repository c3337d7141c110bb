// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/input/register_input.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/motion/motion.h"
#include "text/language.h"

#include <deque>
#include <map>

namespace cli {
namespace {
using catalog::Role;

/// Long enough for a slow turn; Ctrl-C ends the wait.
constexpr base::Duration arrivalTimeout = std::chrono::minutes(2);

struct Target {
    int id = 0;
    QString goal;
};

base::Result<std::vector<Target>> parseTargets(const QStringList& words)
{
    std::vector<Target> targets;
    for (const QString& word : words) {
        const auto assignment = parseAssignment(word);
        if (!assignment)
            return badArgument(
                translate("cli", "\"%1\" must have the form ID=POS, without spaces").arg(word));
        const auto id = parseId(assignment->first);
        if (!id)
            return tl::unexpected(id.error());
        for (const Target& other : targets) {
            if (other.id == *id)
                return badArgument(translate("cli", "ID %1 is specified twice").arg(*id));
        }
        targets.push_back({*id, assignment->second});
    }
    return targets;
}

base::Result<device::MoveMethod> parseHow(const QString& word)
{
    if (word == QLatin1String("write"))
        return device::MoveMethod::Write;
    if (word == QLatin1String("sync"))
        return device::MoveMethod::Sync;
    if (word == QLatin1String("async"))
        return device::MoveMethod::Async;
    return badArgument(translate("cli", "--how must be write, sync or async"));
}

/// The message for an invalid value says what the register accepts.
base::Result<void> checkWords(const device::Servo& servo, const device::MoveCommand& order)
{
    const catalog::Mode* mode = servo.mode();
    const std::pair<Role, std::optional<QString>> fields[]{
        {mode != nullptr ? mode->command : Role::GoalPosition, order.goal},
        {Role::GoalSpeed, order.speed},
        {Role::Acceleration, order.acceleration},
        {Role::GoalTime, order.time}};
    for (const auto& [role, text] : fields) {
        const catalog::Register* reg = servo.profile->byRole(role);
        if (reg == nullptr || !text)
            continue;
        if (const auto raw = parseRegisterValue(servo, *reg, *text); !raw)
            return tl::unexpected(raw.error());
    }
    return {};
}

base::Result<std::vector<device::MovePlan>> planAll(Run& run, const Values& values,
                                                    const std::vector<Target>& targets,
                                                    std::deque<device::Servo>& servos)
{
    std::vector<device::MovePlan> plans;
    for (const Target& target : targets) {
        auto servo = run.servoWithSettings(target.id);
        if (!servo)
            return tl::unexpected(servo.error());
        servos.push_back(std::move(*servo));
        device::MoveCommand order{&servos.back(), target.goal};
        order.speed = values.option("--speed");
        order.acceleration = values.option("--acceleration");
        order.time = values.option("--time");
        if (const auto good = checkWords(servos.back(), order); !good)
            return tl::unexpected(good.error());
        auto plan = device::planMove(*run.context(), order);
        if (!plan)
            return tl::unexpected(plan.error());
        plans.push_back(std::move(*plan));
    }
    return plans;
}

base::Result<void> wait(Run& run, std::vector<device::MovePlan>& plans)
{
    ProgressLine line(run.console(), translate("cli", "Moving"));
    std::map<int, QString> presentPositions;
    return device::waitForArrival(
        *run.context(), plans, arrivalTimeout, [&](const device::MoveProgress& progress) {
            if (progress.position)
                presentPositions[progress.id] = QString::number(*progress.position, 'f', 1);
            QStringList shown;
            for (const auto& [id, presentPosition] : presentPositions)
                shown << QStringLiteral("%1: %2").arg(id).arg(presentPosition);
            line.show(shown.join(QStringLiteral("   ")));
        });
}

void show(Run& run, const std::vector<device::MovePlan>& plans, bool waited)
{
    Json::Array moves;
    Table table(
        {translate("cli", "ID"), translate("cli", "Written"), translate("cli", "Position")});
    for (const device::MovePlan& plan : plans) {
        const device::Servo& servo = *plan.servo;
        Json::Array fields;
        QStringList written;
        for (const device::WriteItem& field : plan.fields) {
            const catalog::Register& reg = *servo.profile->find(field.key);
            fields.push_back(Json::object().add("key", field.key).add("raw", field.raw));
            written << QStringLiteral("%1 = %2").arg(
                field.key,
                catalog::formatValue(field.raw, reg, servo.meaning(reg), text::isUiChinese()));
        }
        const catalog::Register* position = servo.profile->byRole(Role::PresentPosition);
        Json json = Json::object();
        json.add("id", servo.id).add("goal", plan.goalRaw).add("fields", std::move(fields));
        if (waited && position != nullptr)
            json.add("position", servo.raw(*position)).add("value", jsonValue(servo, *position));
        moves.push_back(std::move(json));
        table.add({QString::number(servo.id), text::joinItems(written),
                   waited && position != nullptr ? formatValueText(servo, *position) : noValue()});
    }
    run.finish(Json::object().add("moves", std::move(moves)), table.text());
}

base::Result<Exit> runMove(Run& run, const Values& values)
{
    const auto targets = parseTargets(values.arguments("ID=POS"));
    if (!targets)
        return tl::unexpected(targets.error());
    const auto how = parseHow(values.option("--how").value_or(QStringLiteral("write")));
    if (!how)
        return tl::unexpected(how.error());
    std::deque<device::Servo> servos; // the plans refer to them
    auto plans = planAll(run, values, *targets, servos);
    if (!plans)
        return tl::unexpected(plans.error());
    if (const auto sent = device::sendMoves(*run.context(), *plans, *how); !sent)
        return tl::unexpected(sent.error());
    const bool waited = values.has("--wait");
    if (waited) {
        if (const auto arrived = wait(run, *plans); !arrived)
            return tl::unexpected(arrived.error());
    }
    show(run, *plans, waited);
    return Exit::Success;
}
} // namespace

Command moveCommand()
{
    return {
        "move",
        QT_TRANSLATE_NOOP("cli", "set goals; values that are not specified are not written"),
        {{"ID=POS",
          QT_TRANSLATE_NOOP("cli",
                            "goal, raw (1=2048) or with its unit (1=90deg; in speed mode 1=30rpm)"),
          1, many}},
        {{"--speed", QT_TRANSLATE_NOOP("cli", "raw value, or value with its unit"), "V"},
         {"--acceleration", QT_TRANSLATE_NOOP("cli", "raw value, or value with its unit"), "A"},
         {"--time", QT_TRANSLATE_NOOP("cli", "travel time in milliseconds (SCS, LX)"), "MS"},
         {"--wait", QT_TRANSLATE_NOOP("cli", "wait until the servos have reached their goals")},
         {"--how",
          QT_TRANSLATE_NOOP(
              "cli", "write: one servo at a time; sync: all in one packet; async: stored first, "
                     "then started together. Starting several Feetech servos together also starts "
                     "any moves that other programs have stored in servos on the bus"),
          "write|sync|async"}},
        runMove};
}
} // namespace cli
